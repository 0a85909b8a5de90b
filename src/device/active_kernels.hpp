// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/host_device.hpp"
#include "foundation/larger.hpp"
#include "held_law.hpp"

#include <cmath>
#include <cstddef>

/// Kernels of the active cells of a body: their flow, the images of their trials, and which cells become active. They compute what
/// elastoplastic/body does for a body on the processor.
namespace brinell::device
{

/// Fields of a body in memory of an executor; deviators are [component][cell].
struct BodyFields
{
  std::size_t cells = 0, nx = 0, ny = 0; ///< of the body, of a row, rows
  bool is_mirrored = false;              ///< along y: SurfaceGrid::is_mirrored_y
  std::size_t independent = 0;           ///< cells of a layer that determine the others
  double stiffness = 0.0;                ///< c [Pa]
  std::size_t terms = 0;                 ///< of kinematic hardening
  const double* layer_factor = nullptr;  ///< of the yield stress
  const double* softening = nullptr;     ///< of the yield stress, of each cell; nullptr: 1
  double* strain = nullptr;              ///< plastic, of the trial
  double* before = nullptr;              ///< stress before the increment [Pa]
  double* stress = nullptr;              ///< of the trial; between increments the guess [Pa]
  double* equivalent = nullptr;          ///< before the increment
  double* backstress = nullptr;          ///< before the increment, [term][component][cell] [Pa]
  unsigned char* is_active = nullptr;

  [[nodiscard]] BRINELL_HOST_DEVICE std::size_t of_layer() const { return nx * ny; }
  [[nodiscard]] BRINELL_HOST_DEVICE std::size_t row(std::size_t cell) const { return cell / nx % ny; }
  /// Cells that a cell represents, itself included.
  [[nodiscard]] BRINELL_HOST_DEVICE double copies(std::size_t cell) const { return has_image(cell) ? 2.0 : 1.0; }
  [[nodiscard]] BRINELL_HOST_DEVICE bool has_image(std::size_t cell) const
  {
    return is_mirrored && 2 * row(cell) + 1 != ny;
  }
  [[nodiscard]] BRINELL_HOST_DEVICE std::size_t image(std::size_t cell) const
  {
    return cell + (ny - 1 - 2 * row(cell)) * nx; // wraps where the difference is negative
  }
  [[nodiscard]] BRINELL_HOST_DEVICE double softening_at(std::size_t cell) const
  {
    return softening == nullptr ? 1.0 : softening[cell];
  }
  /// Factor of the yield stress.
  [[nodiscard]] BRINELL_HOST_DEVICE double factor(std::size_t cell) const
  {
    return layer_factor[cell / of_layer()] * softening_at(cell);
  }
  [[nodiscard]] BRINELL_HOST_DEVICE Deviator at(const double* field, std::size_t cell) const
  {
    Deviator d;
    for (int c = 0; c < Deviator::size; ++c)
      d[c] = field[static_cast<std::size_t>(c) * cells + cell];
    return d;
  }
  BRINELL_HOST_DEVICE void put(const Deviator& d, double* field, std::size_t cell) const
  {
    for (int c = 0; c < Deviator::size; ++c)
      field[static_cast<std::size_t>(c) * cells + cell] = d[c];
  }
  [[nodiscard]] BRINELL_HOST_DEVICE double* backstress_of(std::size_t term) const
  {
    return backstress + term * Deviator::size * cells;
  }
  /// Centre of the yield surface before the increment.
  [[nodiscard]] BRINELL_HOST_DEVICE Deviator centre(std::size_t cell) const
  {
    Deviator sum;
    for (std::size_t term = 0; term < terms; ++term)
      sum = sum + at(backstress_of(term), cell);
    return sum;
  }
};

/// Packed arrays of the active cells, deviators [active][component]: elastoplastic::ActiveCells.
struct ActiveArrays
{
  std::size_t* cells = nullptr;
  double *trials = nullptr, *mapped = nullptr, *flow = nullptr, *start = nullptr;
  double *equivalent = nullptr, *dissipation = nullptr;
  double* backstress = nullptr; ///< [active][term][component]

  [[nodiscard]] static BRINELL_HOST_DEVICE Deviator at(const double* packed, std::size_t a)
  {
    Deviator d;
    for (int c = 0; c < Deviator::size; ++c)
      d[c] = packed[a * Deviator::size + static_cast<std::size_t>(c)];
    return d;
  }
  static BRINELL_HOST_DEVICE void put(const Deviator& d, double* packed, std::size_t a)
  {
    for (int c = 0; c < Deviator::size; ++c)
      packed[a * Deviator::size + static_cast<std::size_t>(c)] = d[c];
  }
};

/// Plastic flow of an active cell.
template <typename Law, bool has_backstress>
struct FlowOfActive
{
  FlowRule<Law, has_backstress> rule;
  BodyFields of;
  ActiveArrays active;

  BRINELL_HOST_DEVICE void operator()(std::size_t a) const
  {
    const std::size_t cell = active.cells[a];
    typename FlowRule<Law, has_backstress>::BackStresses back;
    for (std::size_t term = 0; has_backstress && term < of.terms; ++term)
      back[term] = of.at(of.backstress_of(term), cell);
    const constitutive::PlasticIncrement result =
        rule(of.factor(cell), of.at(of.before, cell), ActiveArrays::at(active.trials, a), of.equivalent[cell], back);
    for (std::size_t term = 0; has_backstress && term < of.terms; ++term)
      ActiveArrays::put(back[term], active.backstress, a * of.terms + term);
    active.equivalent[a] = result.equivalent;
    active.dissipation[a] = result.dissipation;
    const Deviator& d = result.strain;
    Deviator factors = 2.0 * d; // as in ActiveCells::set_flow
    factors[Deviator::xx] += d[Deviator::yy];
    factors[Deviator::yy] += d[Deviator::xx];
    ActiveArrays::put(of.copies(cell) * factors, active.flow, a);
    Deviator strain = ActiveArrays::at(active.start, a) + d;
    of.put(strain, of.strain, cell);
    if (!of.has_image(cell))
      return;
    strain[Deviator::yz] = -strain[Deviator::yz];
    strain[Deviator::xy] = -strain[Deviator::xy];
    of.put(strain, of.strain, of.image(cell));
  }
};

/// The largest of several errors; NaN if one is.
struct LargestError
{
  double value = 0.0;
  BRINELL_HOST_DEVICE LargestError& operator+=(const LargestError& other)
  {
    value = larger(value, other.value);
    return *this;
  }
};

/// Image g of the trial of an active cell, from the stress of the evaluation. The term is the von Mises norm of g - q over the yield
/// stress; 0 in cells that stay elastic.
template <typename Law>
struct ImageOfActive
{
  Law law;
  BodyFields of;
  ActiveArrays active;

  BRINELL_HOST_DEVICE LargestError operator()(std::size_t a) const
  {
    const std::size_t cell = active.cells[a];
    const double equivalent = active.equivalent[a];
    Deviator g = of.at(of.stress, cell);
    if (equivalent != 0.0)
      g = g + of.stiffness * (of.at(of.strain, cell) - ActiveArrays::at(active.start, a));
    ActiveArrays::put(g, active.mapped, a);
    const Deviator from_centre = of.terms == 0 ? g : g - of.centre(cell);
    const double size = von_mises(from_centre);
    const double yield =
        constitutive::ScaledLaw<Law>{law, of.factor(cell)}.yield_stress_at(of.equivalent[cell] + equivalent);
    if (!(equivalent > 0.0))
    {
      const bool is_plastic = !(size <= yield); // negated, so that NaN counts as plastic
      const Deviator trial = is_plastic ? g - (1.0 - yield / size) * from_centre : g;
      ActiveArrays::put(trial, active.trials, a);
      return {is_plastic ? von_mises(g - trial) / yield : 0.0};
    }
    return {von_mises(g - ActiveArrays::at(active.trials, a)) / yield};
  }
};

/// Cells that are found, and the deepest of their layers.
struct FoundCells
{
  double count = 0.0, deepest = -1.0;
  BRINELL_HOST_DEVICE FoundCells& operator+=(const FoundCells& other)
  {
    count += other.count;
    deepest = other.deepest > deepest ? other.deepest : deepest;
    return *this;
  }
};

/// The n-th of the cells that determine the others.
[[nodiscard]] BRINELL_HOST_DEVICE inline std::size_t independent_cell(const BodyFields& of, std::size_t n)
{
  return n / of.independent * of.of_layer() + n % of.independent;
}

/// Marks a cell that is not yet active and whose q, `shift` columns to the left, lies outside the yield surface scaled by `fraction`.
template <typename Law>
struct FindBeyond
{
  Law law;
  BodyFields of;
  const double* q;
  int shift;
  double fraction;
  unsigned char* is_found; ///< of the independent cells

  BRINELL_HOST_DEVICE FoundCells operator()(std::size_t n) const
  {
    const std::size_t cell = independent_cell(of, n);
    const bool found = is_beyond(cell);
    is_found[n] = found ? 1 : 0;
    return found ? FoundCells{1.0, static_cast<double>(cell / of.of_layer())} : FoundCells{};
  }

private:
  [[nodiscard]] static BRINELL_HOST_DEVICE double square(double value) { return value < 0.0 ? -1.0 : value * value; }
  [[nodiscard]] BRINELL_HOST_DEVICE bool is_beyond(std::size_t cell) const
  {
    const auto column = static_cast<long long>(cell % of.nx) - shift;
    if (column < 0 || column >= static_cast<long long>(of.nx) || of.is_active[cell] != 0)
      return false;
    Deviator d = of.at(q, cell - static_cast<std::size_t>(static_cast<long long>(shift)));
    for (std::size_t term = 0; term < of.terms; ++term)
      d = d - of.at(of.backstress_of(term), cell);
    using D = Deviator;
    const double squared = 3.0 * (d[D::xx] * d[D::xx] + d[D::yy] * d[D::yy] + d[D::xx] * d[D::yy] +
                                  d[D::yz] * d[D::yz] + d[D::xz] * d[D::xz] + d[D::xy] * d[D::xy]);
    const constitutive::ScaledLaw<Law> scaled{law, of.layer_factor[cell / of.of_layer()]};
    const double softened = of.softening_at(cell) * of.softening_at(cell);
    return squared > square(fraction * scaled.yield_stress_at(0.0)) * softened &&
           squared > square(fraction * scaled.yield_stress_at(of.equivalent[cell])) * softened;
  }
};

/// Cells that a thread counts and adds one after the other, so that active cells have the order of the grid.
inline constexpr std::size_t cells_of_piece = 64;

struct CountOfPiece
{
  std::size_t count; ///< of all cells looked at
  const unsigned char* is_found;
  std::size_t* counts;

  BRINELL_HOST_DEVICE void operator()(std::size_t piece) const
  {
    std::size_t found = 0;
    for (std::size_t n = piece * cells_of_piece; n < count && n < (piece + 1) * cells_of_piece; ++n)
      found += is_found[n];
    counts[piece] = found;
  }
};

/// Adds the cells of a piece that were found to the active ones.
struct AddOfPiece
{
  BodyFields of;
  ActiveArrays active;
  std::size_t count;
  const unsigned char* is_found;
  const std::size_t* places; ///< of the first cell of each piece among the active ones
  const double* q;
  int shift;

  BRINELL_HOST_DEVICE void operator()(std::size_t piece) const
  {
    std::size_t a = places[piece];
    for (std::size_t n = piece * cells_of_piece; n < count && n < (piece + 1) * cells_of_piece; ++n)
      if (is_found[n] != 0)
        add(a++, independent_cell(of, n));
  }

private:
  BRINELL_HOST_DEVICE void add(std::size_t a, std::size_t cell) const
  {
    const Deviator trial = of.at(q, cell - static_cast<std::size_t>(static_cast<long long>(shift)));
    of.is_active[cell] = 1;
    active.cells[a] = cell;
    ActiveArrays::put(trial, active.trials, a);
    ActiveArrays::put(trial, active.mapped, a);
    ActiveArrays::put(of.at(of.strain, cell), active.start, a);
    ActiveArrays::put(Deviator(), active.flow, a);
    active.equivalent[a] = active.dissipation[a] = 0.0;
    for (std::size_t term = 0; term < of.terms; ++term)
      ActiveArrays::put(Deviator(), active.backstress, a * of.terms + term);
  }
};

/// Moves the trial of an active cell from `first` on to the nearest stress of the yield surface: elastoplastic::put_on_yield_surface.
template <typename Law>
struct PutOnYieldSurface
{
  Law law;
  BodyFields of;
  ActiveArrays active;
  std::size_t first;

  BRINELL_HOST_DEVICE void operator()(std::size_t n) const
  {
    const std::size_t a = first + n, cell = active.cells[a];
    const Deviator mapped = ActiveArrays::at(active.mapped, a), from_centre = mapped - of.centre(cell);
    const double yield = constitutive::ScaledLaw<Law>{law, of.factor(cell)}.yield_stress_at(of.equivalent[cell]);
    const double beyond = 1.0 - yield / von_mises(from_centre), excess = beyond > 0.0 ? beyond : 0.0;
    ActiveArrays::put(mapped - excess * from_centre, active.trials, a);
  }
};

struct Deactivate
{
  BodyFields of;
  const std::size_t* cells;
  BRINELL_HOST_DEVICE void operator()(std::size_t a) const { of.is_active[cells[a]] = 0; }
};

/// Makes the trial of an active cell its state, and its image the guess of the next increment.
struct CommitActive
{
  BodyFields of;
  ActiveArrays active;

  BRINELL_HOST_DEVICE void operator()(std::size_t a) const
  {
    const std::size_t cell = active.cells[a];
    of.equivalent[cell] += active.equivalent[a];
    for (std::size_t term = 0; active.equivalent[a] > 0.0 && term < of.terms; ++term)
      of.put(ActiveArrays::at(active.backstress, a * of.terms + term), of.backstress_of(term), cell);
    of.put(ActiveArrays::at(active.mapped, a), of.stress, cell);
  }
};

/// Packs the plastic strain of an active cell.
struct StrainOfActive
{
  BodyFields of;
  const std::size_t* cells;
  double* packed;
  BRINELL_HOST_DEVICE void operator()(std::size_t a) const { ActiveArrays::put(of.at(of.strain, cells[a]), packed, a); }
};

/// Adds a value of each layer to the components xx and yy.
struct AddInLayers
{
  std::size_t cells, of_layer;
  const double* values;
  double* field;
  BRINELL_HOST_DEVICE void operator()(std::size_t cell) const
  {
    field[Deviator::xx * cells + cell] += values[cell / of_layer];
    field[Deviator::yy * cells + cell] += values[cell / of_layer];
  }
};

struct AddField
{
  const double* from;
  double* to;
  BRINELL_HOST_DEVICE void operator()(std::size_t n) const { to[n] += from[n]; }
};

template <typename Value>
struct CopyValues
{
  const Value* from;
  Value* to;
  BRINELL_HOST_DEVICE void operator()(std::size_t n) const { to[n] = from[n]; }
};

} // namespace brinell::device
