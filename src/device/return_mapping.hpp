// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/flow.hpp"
#include "brinell/constitutive/hardening.hpp"
#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/foundation/host_device.hpp"
#include "constitutive/linear_return.hpp"

#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace brinell::device
{

/// Plastic flow of cells in one increment, all arrays in memory of an executor. Those of deviators are [component][cell].
struct CellsThatFlow
{
  std::size_t cells = 0;                ///< of the body
  std::size_t cells_of_layer = 0;       ///< of which each layer has a factor
  double stiffness = 0.0;               ///< c [Pa] of the trial deviator s + c d_eps: constitutive::flow
  const double* start = nullptr;        ///< stress deviator before the increment [Pa]
  const double* trial = nullptr;        ///< trial deviator [Pa]
  const double* equivalent = nullptr;   ///< equivalent plastic strain before the increment
  const double* layer_factor = nullptr; ///< of the yield stress, one for each layer; nullptr: 1
  const double* softening = nullptr;    ///< factor of the yield stress, one for each cell; nullptr: 1
  double* strain = nullptr;             ///< plastic strain of the increment, out
  double* increment = nullptr;          ///< of the equivalent plastic strain, out
  double* dissipation = nullptr;        ///< plastic work [J/m^3], out
};

/// Kernel of the return mapping: what happens in one cell.
template <typename Law>
struct FlowOfCell
{
  Law law;
  constitutive::Integration integration;
  CellsThatFlow of;

  BRINELL_HOST_DEVICE void operator()(std::size_t cell) const
  {
    double factor = of.layer_factor == nullptr ? 1.0 : of.layer_factor[cell / of.cells_of_layer];
    if (of.softening != nullptr)
      factor *= of.softening[cell];
    const constitutive::ScaledLaw<Law> scaled{law, factor};
    const Deviator start = at(of.start, cell), trial = at(of.trial, cell);
    const constitutive::PlasticIncrement result = flow(scaled, start, trial, of.equivalent[cell]);
    for (int c = 0; c < Deviator::size; ++c)
      of.strain[static_cast<std::size_t>(c) * of.cells + cell] = result.strain[c];
    of.increment[cell] = result.equivalent;
    of.dissipation[cell] = result.dissipation;
  }

private:
  [[nodiscard]] BRINELL_HOST_DEVICE Deviator at(const double* field, std::size_t cell) const
  {
    Deviator d;
    for (int c = 0; c < Deviator::size; ++c)
      d[c] = field[static_cast<std::size_t>(c) * of.cells + cell];
    return d;
  }
  [[nodiscard]] BRINELL_HOST_DEVICE constitutive::PlasticIncrement
  flow(const constitutive::ScaledLaw<Law>& scaled, const Deviator& start, const Deviator& trial, double e) const
  {
    const double mu = 0.5 * of.stiffness;
    if (integration == constitutive::Integration::backward_euler)
      return constitutive::radial_return(trial, e, mu, scaled);
    if constexpr (constitutive::is_linear<Law>)
    {
      constitutive::PointsOf<double> point;
      point.start = start.v;
      point.trial = trial.v;
      point.yield = scaled.yield_stress_at(e);
      point.modulus = scaled.modulus_at(e);
      constitutive::path_return(point, mu);
      return {Deviator{point.strain}, point.equivalent, point.dissipation};
    }
    else
      return constitutive::path_return(start, trial, e, mu, scaled);
  }
};

/// Return mapping of a body with one hardening law on an executor, without kinematic hardening.
template <typename Executor>
class ReturnMapping
{
public:
  /// @throws InputError for a UserHardening, which is a program of the processor
  ReturnMapping(const constitutive::HardeningLaw& law, constitutive::Integration integration, const Executor& executor)
      : executor_(&executor), integration_(integration),
        law_(std::visit([this](const auto& l) { return held(l); }, law))
  {
  }

  ReturnMapping(ReturnMapping&&) noexcept = default; // columns of a table stay where they are
  ReturnMapping& operator=(ReturnMapping&&) noexcept = default;

  /// Computes the flow in all cells.
  void flow(const CellsThatFlow& of) const
  {
    std::visit(
        [&](const auto& law) {
          executor_->run("return mapping", of.cells, FlowOfCell{law, integration_, of});
        },
        law_);
  }

private:
  using Law = std::variant<constitutive::PerfectPlasticity, constitutive::LinearHardening, constitutive::SwiftHardening,
                           constitutive::LudwikHardening, constitutive::VoceHardening, constitutive::HardeningTable>;
  using Array = typename Executor::template Memory<double>;

  template <typename Of>
  Law held(const Of& law)
  {
    if constexpr (std::is_same_v<Of, constitutive::UserHardening>)
      throw InputError(
          "a hardening law of your own is a program of the processor; a device computes with those of brinell, "
          "of which a tabulated one has any shape");
    else if constexpr (std::is_same_v<Of, constitutive::TabulatedHardening>)
      return copied(law.table());
    else
      return law;
  }
  constitutive::HardeningTable copied(constitutive::HardeningTable table)
  {
    for (const double** column : {&table.strain, &table.stress, &table.modulus, &table.works})
    {
      columns_.push_back(executor_->template allocate<double>(table.count));
      executor_->write(std::span<const double>(*column, table.count), columns_.back());
      *column = columns_.back().data();
    }
    return table;
  }

  const Executor* executor_;
  constitutive::Integration integration_;
  std::vector<Array> columns_; ///< of a table
  Law law_;
};

} // namespace brinell::device
