// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/return_mapping.hpp"
#include "brinell/foundation/grid.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// The active set: the cells of a body that may yield in the current increment. For each active cell it stores the unknown of the
/// fixed point (the trial deviator q), its image g(q) under an evaluation, and the plastic flow that follows from q. All arrays
/// are packed, in the order in which the cells became active.
class ActiveCells
{
public:
  ActiveCells() = default;
  /// @param cells  number of cells of the body's grid
  /// @param terms  number of terms of kinematic hardening
  ActiveCells(std::size_t cells, std::size_t terms) : is_active_(cells, 0), terms_(terms) {}

  void clear();
  /// Adds a cell to the active set. Until the next evaluation its trial deviator is mapped to itself.
  /// @param start   plastic strain before the increment
  /// @param copies  number of cells that this cell represents, itself included: on a mirrored grid also its mirror image
  void add(std::size_t cell, const Deviator& q, const Deviator& start, int copies);

  /// Takes over the active cells that were found elsewhere, in their order; what belongs to them is then to be filled in.
  void assign(std::vector<std::size_t> cells, const SurfaceGrid& grid);
  /// @param packed  [active][term][component]
  void assign_backstresses(std::span<const double> packed);

  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] bool empty() const { return cells_.empty(); }
  [[nodiscard]] bool contains(std::size_t cell) const { return is_active_[cell] != 0; }
  /// Index in the grid of the body of the a-th active cell.
  [[nodiscard]] std::size_t cell(std::size_t a) const { return cells_[a]; }
  [[nodiscard]] const std::vector<std::size_t>& cells() const { return cells_; }
  /// Number of cells that the a-th active cell represents, see `add`.
  [[nodiscard]] double copies(std::size_t a) const { return copies_[a]; }
  /// Plastic strain before the increment.
  [[nodiscard]] Deviator start(std::size_t a) const { return at(start_, a); }
  /// The last active cell in the order of the grid, which lies in the deepest active layer. The set must not be empty.
  [[nodiscard]] std::size_t deepest() const;

  [[nodiscard]] Deviator trial(std::size_t a) const { return at(q_, a); }
  [[nodiscard]] Deviator mapped(std::size_t a) const { return at(g_, a); }
  void set_trial(std::size_t a, const Deviator& q) { set(q_, a, q); }
  /// All trial deviators, [active][component].
  [[nodiscard]] std::vector<double>& trials() { return q_; }
  [[nodiscard]] const std::vector<double>& trials() const { return q_; }
  [[nodiscard]] const std::vector<double>& mapped() const { return g_; }
  /// The plastic strain of the increment, weighted so that a plain scalar product with the trials gives the work: for each
  /// cell, the sum over components of flow times deviator is the contraction of strain and deviator times `copies`.
  [[nodiscard]] const std::vector<double>& flow() const { return flow_; }

  /// Equivalent plastic strain [-] and plastic work [J/m^3] of the increment.
  [[nodiscard]] double equivalent(std::size_t a) const { return equivalent_[a]; }
  [[nodiscard]] double dissipation(std::size_t a) const { return dissipation_[a]; }
  [[nodiscard]] const std::vector<double>& dissipations() const { return dissipation_; }
  [[nodiscard]] const std::vector<double>& all_copies() const { return copies_; }
  void set_flow(std::size_t a, const constitutive::PlasticIncrement& increment);

  /// Pointers to the packed arrays, for work on several cells at once; deviators are [active][component].
  struct Packed
  {
    double *trials, *mapped, *flow;
    double *equivalent, *dissipation, *start;
    const double* copies;
  };
  [[nodiscard]] Packed packed()
  {
    return {q_.data(), g_.data(), flow_.data(), equivalent_.data(), dissipation_.data(), start_.data(), copies_.data()};
  }
  /// Trial back stresses of a cell, one per term [Pa].
  [[nodiscard]] std::span<Deviator> backstress(std::size_t a) { return {backstress_.data() + a * terms_, terms_}; }
  [[nodiscard]] std::span<const Deviator> backstress(std::size_t a) const
  {
    return {backstress_.data() + a * terms_, terms_};
  }

private:
  [[nodiscard]] static Deviator at(const std::vector<double>& packed, std::size_t a)
  {
    Deviator d;
    std::copy_n(packed.begin() + static_cast<std::ptrdiff_t>(a * Deviator::size), Deviator::size, d.v.begin());
    return d;
  }
  static void set(std::vector<double>& packed, std::size_t a, const Deviator& d)
  {
    std::copy(d.v.begin(), d.v.end(), packed.begin() + static_cast<std::ptrdiff_t>(a * Deviator::size));
  }

  std::vector<std::size_t> cells_;
  std::vector<char> is_active_; ///< one value per cell of the grid
  std::vector<double> q_, g_, start_, flow_;
  std::vector<double> equivalent_, dissipation_, copies_;
  std::vector<Deviator> backstress_;
  std::size_t terms_ = 0;
};

} // namespace brinell::elastoplastic
