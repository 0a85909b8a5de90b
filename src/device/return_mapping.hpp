// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/flow.hpp"
#include "brinell/constitutive/hardening.hpp"
#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/foundation/host_device.hpp"
#include "constitutive/linear_return.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
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
  double* backstress = nullptr;         ///< of kinematic hardening [Pa], [term][component][cell], in and out
  double* strain = nullptr;             ///< plastic strain of the increment, out
  double* increment = nullptr;          ///< of the equivalent plastic strain, out
  double* dissipation = nullptr;        ///< plastic work [J/m^3], out
};

/// Terms of kinematic hardening, few enough for a thread to keep their back stresses.
struct KinematicTerms
{
  static constexpr std::size_t most = 4;
  std::array<constitutive::KinematicTerm, most> terms{};
  std::size_t count = 0;
};

/// Kernel of the return mapping: what happens in one cell.
/// @tparam has_backstress  two kernels, because back stresses take memory of a thread
template <typename Law, bool has_backstress>
struct FlowOfCell
{
  Law law;
  constitutive::Integration integration;
  KinematicTerms kinematic;
  CellsThatFlow of;

  BRINELL_HOST_DEVICE void operator()(std::size_t cell) const
  {
    double factor = of.layer_factor == nullptr ? 1.0 : of.layer_factor[cell / of.cells_of_layer];
    if (of.softening != nullptr)
      factor *= of.softening[cell];
    const constitutive::ScaledLaw<Law> scaled{law, factor};
    const Deviator start = at(of.start, cell), trial = at(of.trial, cell);
    constitutive::PlasticIncrement result;
    if constexpr (has_backstress)
      result = flow_with_backstress(scaled, start, trial, cell);
    else
      result = flow(scaled, start, trial, of.equivalent[cell]);
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
  [[nodiscard]] BRINELL_HOST_DEVICE constitutive::PlasticIncrement
  flow_with_backstress(const constitutive::ScaledLaw<Law>& scaled, const Deviator& start, const Deviator& trial,
                       std::size_t cell) const
  {
    const auto field = [&](std::size_t term) { return of.backstress + term * Deviator::size * of.cells; };
    std::array<Deviator, KinematicTerms::most> back;
    for (std::size_t term = 0; term < kinematic.count; ++term)
      back[term] = at(field(term), cell);
    const double end = integration == constitutive::Integration::path ? 0.5 : 1.0;
    const constitutive::PlasticIncrement result = constitutive::kinematic_return(
        start, trial, of.equivalent[cell], 0.5 * of.stiffness, scaled, end,
        std::span<const constitutive::KinematicTerm>(kinematic.terms.data(), kinematic.count),
        std::span<Deviator>(back.data(), kinematic.count));
    for (std::size_t term = 0; term < kinematic.count; ++term)
      for (int c = 0; c < Deviator::size; ++c)
        field(term)[static_cast<std::size_t>(c) * of.cells + cell] = back[term][c];
    return result;
  }
};

/// Return mapping of a body with one hardening law on an executor.
template <typename Executor>
class ReturnMapping
{
public:
  /// @param terms  of kinematic hardening
  /// @throws InputError for a UserHardening, which is a program of the processor, and for more than KinematicTerms::most terms
  ReturnMapping(const constitutive::HardeningLaw& law, constitutive::Integration integration, const Executor& executor,
                std::span<const constitutive::KinematicTerm> terms = {})
      : executor_(&executor), integration_(integration), kinematic_(held(terms)),
        law_(std::visit([this](const auto& l) { return this->held(l); }, law))
  {
  }

  ReturnMapping(ReturnMapping&&) noexcept = default; // columns of a table stay where they are
  ReturnMapping& operator=(ReturnMapping&&) noexcept = default;

  /// Computes the flow in all cells.
  void flow(const CellsThatFlow& of) const
  {
    const auto run = [&](const auto& kernel) { executor_->run("return mapping", of.cells, kernel); };
    std::visit(
        [&](const auto& law)
        {
          using Of = std::decay_t<decltype(law)>;
          if (kinematic_.count == 0)
            run(FlowOfCell<Of, false>{law, integration_, kinematic_, of});
          else
            run(FlowOfCell<Of, true>{law, integration_, kinematic_, of});
        },
        law_);
  }

private:
  using Law = std::variant<constitutive::PerfectPlasticity, constitutive::LinearHardening, constitutive::SwiftHardening,
                           constitutive::LudwikHardening, constitutive::VoceHardening, constitutive::HardeningTable>;
  using Array = typename Executor::template Memory<double>;

  static KinematicTerms held(std::span<const constitutive::KinematicTerm> terms)
  {
    if (terms.size() > KinematicTerms::most)
      throw InputError("kinematic hardening of " + std::to_string(terms.size()) +
                       " terms; allowed on a device: at most " + std::to_string(KinematicTerms::most));
    KinematicTerms kinematic;
    std::copy(terms.begin(), terms.end(), kinematic.terms.begin());
    kinematic.count = terms.size();
    return kinematic;
  }
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
  KinematicTerms kinematic_;
  std::vector<Array> columns_; ///< of a table
  Law law_;
};

} // namespace brinell::device
