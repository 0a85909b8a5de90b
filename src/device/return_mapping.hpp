// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "held_law.hpp"

#include <cstddef>
#include <span>
#include <type_traits>

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

/// Kernel of the return mapping: what happens in one cell.
template <typename Law, bool has_backstress>
struct FlowOfCell
{
  FlowRule<Law, has_backstress> rule;
  CellsThatFlow of;

  BRINELL_HOST_DEVICE void operator()(std::size_t cell) const
  {
    double factor = of.layer_factor == nullptr ? 1.0 : of.layer_factor[cell / of.cells_of_layer];
    if (of.softening != nullptr)
      factor *= of.softening[cell];
    typename FlowRule<Law, has_backstress>::BackStresses back;
    const auto field = [&](std::size_t term) { return of.backstress + term * Deviator::size * of.cells; };
    for (std::size_t term = 0; has_backstress && term < rule.kinematic.count; ++term)
      back[term] = at(field(term), cell);
    const constitutive::PlasticIncrement result =
        rule(factor, at(of.start, cell), at(of.trial, cell), of.equivalent[cell], back);
    for (std::size_t term = 0; has_backstress && term < rule.kinematic.count; ++term)
      put(back[term], field(term), cell);
    put(result.strain, of.strain, cell);
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
  BRINELL_HOST_DEVICE void put(const Deviator& d, double* field, std::size_t cell) const
  {
    for (int c = 0; c < Deviator::size; ++c)
      field[static_cast<std::size_t>(c) * of.cells + cell] = d[c];
  }
};

/// Return mapping of a body with one hardening law on an executor.
template <typename Executor>
class ReturnMapping
{
public:
  /// Arguments as those of HeldLaw.
  ReturnMapping(const constitutive::HardeningLaw& law, constitutive::Integration integration, const Executor& executor,
                std::span<const constitutive::KinematicTerm> terms = {})
      : executor_(&executor), integration_(integration), law_(law, terms, executor)
  {
  }

  /// Computes the flow in all cells.
  void flow(const CellsThatFlow& of) const
  {
    const auto run = [&](const auto& kernel) { executor_->run("return mapping", of.cells, kernel); };
    const KinematicTerms& kinematic = law_.kinematic();
    law_.visit(
        [&](const auto& law)
        {
          using Of = std::decay_t<decltype(law)>;
          if (kinematic.count == 0)
            run(FlowOfCell<Of, false>{{law, integration_, kinematic, of.stiffness}, of});
          else
            run(FlowOfCell<Of, true>{{law, integration_, kinematic, of.stiffness}, of});
        });
  }

private:
  const Executor* executor_;
  constitutive::Integration integration_;
  HeldLaw<Executor> law_;
};

} // namespace brinell::device
