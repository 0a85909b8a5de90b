// SPDX-License-Identifier: BSD-3-Clause
#include "body_parts.hpp"
#include "foundation/sharing.hpp"
#include "lane_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

/// Evaluation of the active cells: plastic flow, and the image g(q) of the trials.
namespace brinell::elastoplastic
{

namespace
{

/// Number of consecutive active cells that a thread processes before the next thread takes its share. Small, because flowing
/// cells take longest and are neighbours.
constexpr std::size_t cells_per_share = 64;

#pragma omp declare reduction(larger:double : omp_out = larger(omp_out, omp_in)) initializer(omp_priv = 0.0)

using Values = std::array<double, lane_count>;

Values values_of(const Lanes& lanes)
{
  alignas(Lanes) Values values;
  store_lanes(lanes, lane_count, values.data());
  return values;
}

/// Whether a lane is not 0.
template <typename Mask>
bool any(const Mask& mask)
{
  alignas(Mask) std::array<std::int64_t, lane_count> bits;
  std::memcpy(bits.data(), &mask, sizeof mask);
  std::int64_t all = 0;
  for (const std::int64_t of_lane : bits)
    all |= of_lane;
  return all != 0;
}

Lanes von_mises(const LaneDeviators& d)
{
  return constitutive::detail::root(1.5 * constitutive::detail::contract(d, d));
}

/// Factors of the trials in the work of a plastic strain, as in ActiveCells::set_flow.
LaneDeviators as_factors(const LaneDeviators& strain, const Lanes& copies)
{
  LaneDeviators factors = strain;
  for (Lanes& factor : factors)
    factor *= 2.0;
  factors[Deviator::xx] += strain[Deviator::yy];
  factors[Deviator::yy] += strain[Deviator::xx];
  for (Lanes& factor : factors)
    factor *= copies;
  return factors;
}

LaneDeviators operator-(const LaneDeviators& a, const LaneDeviators& b)
{
  LaneDeviators c;
  for (std::size_t i = 0; i < c.size(); ++i)
    c[i] = a[i] - b[i];
  return c;
}

/// Operations on several active cells at once, one per lane of a vector register.
struct ActiveLanes
{
  BodyParts& b;

  void prefetch(const LaneCells& at, const std::vector<double>& stress) const;
  template <typename Law, typename Property>
  [[nodiscard]] Lanes evaluate_laws(const Law& law, const LaneCells& at, const Lanes& equivalent,
                                    const Property& property) const;
  template <typename Law>
  [[nodiscard]] Lanes yield_stresses(const Law& law, const LaneCells& at, const Lanes& equivalent) const;
  template <typename Law>
  void flow(const Law& law, const LaneCells& at) const;
  template <typename Law>
  [[nodiscard]] Lanes map(const Law& law, const LaneCells& at) const;
  void subtract_centre(const LaneCells& at, LaneDeviators& q) const;
};

/// Prefetches plastic strain and stress of cells that follow soon: the short pieces in memory defeat the processor's own
/// prefetching.
void ActiveLanes::prefetch(const LaneCells& at, const std::vector<double>& stress) const
{
  constexpr std::size_t ahead = 2 * lane_count;
  const std::vector<std::size_t>& cells = b.trial.active.cells();
  const std::size_t cell = cells[std::min(at.a + ahead, cells.size() - 1)], n = b.grid.size();
  __builtin_prefetch(b.state.equivalent.data() + cell);
  for (const std::span<const double> field : {std::span<const double>(b.state.plastic_strain), std::span(stress)})
    for (std::size_t c = 0; c < Deviator::size; ++c)
      __builtin_prefetch(field.data() + c * n + cell);
}

/// Evaluates a property of the hardening laws of the cells, such as the yield stress.
/// @param equivalent  equivalent plastic strain at which the property is evaluated
template <typename Law, typename Property>
Lanes ActiveLanes::evaluate_laws(const Law& law, const LaneCells& at, const Lanes& equivalent,
                                 const Property& property) const
{
  Values factors;
  factors.fill(b.yield.factor[b.yield.layer_of(at.cell)]);
  for (std::size_t lane = 0; lane < at.count && !b.yield.softening.empty(); ++lane)
    factors[lane] *= b.yield.softening[at.cell + lane];
  Values values = values_of(equivalent);
  // A linear law is cheap: it is evaluated in unused lanes as well, so that the loop has a fixed length.
  const std::size_t count = constitutive::is_linear<Law> ? lane_count : at.count;
  for (std::size_t lane = 0; lane < count; ++lane)
    values[lane] = property(constitutive::ScaledLaw<Law>{law, factors[lane]}, values[lane]);
  return load_lanes(values.data());
}

template <typename Law>
Lanes ActiveLanes::yield_stresses(const Law& law, const LaneCells& at, const Lanes& equivalent) const
{
  return evaluate_laws(law, at, equivalent,
                       [](const auto& scaled_law, double e) { return scaled_law.yield_stress_at(e); });
}

/// Plastic flow by path integration, for a law whose yield stress is linear in the plastic strain, without kinematic hardening.
template <typename Law>
void ActiveLanes::flow(const Law& law, const LaneCells& at) const
{
  const ActiveCells::Packed packed = b.trial.active.packed();
  const std::size_t n = b.grid.size();
  prefetch(at, b.state.stress);
  constitutive::LanePoints points;
  points.trial = load_packed(packed.trials, at);
  const Lanes before = load_lanes(b.state.equivalent.data() + at.cell, at.count);
  points.yield = yield_stresses(law, at, before);
  const bool flows = any(constitutive::is_outside(points));
  // Cells that flowed neither in the previous evaluation nor now need no update.
  if (!flows && !any(load_lanes(packed.equivalent + at.a, at.count) != Lanes{}))
    return;
  if (flows)
  {
    points.start = load_deviators(b.state.stress.data(), n, at);
    points.modulus =
        evaluate_laws(law, at, before, [](const auto& scaled_law, double e) { return scaled_law.modulus_at(e); });
    constitutive::path_return(points, 0.5 * b.stiffness(at.cell));
  }
  store_lanes(points.equivalent, at.count, packed.equivalent + at.a);
  store_lanes(points.dissipation, at.count, packed.dissipation + at.a);
  LaneDeviators& strain = points.strain;
  const Lanes copies = load_lanes(packed.copies + at.a, at.count);
  store_packed(as_factors(strain, copies), packed.flow, at);
  const LaneDeviators start = load_packed(packed.start, at);
  for (std::size_t c = 0; c < strain.size(); ++c)
    strain[c] += start[c];
  store_deviators(strain, b.state.plastic_strain.data(), n, at);
}

/// Plastic flow in one active cell.
template <typename Law>
constitutive::PlasticIncrement increment(BodyParts& b, const Law& law, std::size_t a, Integration integration)
{
  const std::size_t cell = b.trial.active.cell(a);
  const std::span<Deviator> back = b.trial.active.backstress(a);
  for (std::size_t term = 0; term < back.size(); ++term)
    back[term] = b.backstress(cell, term);
  return constitutive::flow(law, b.yield.terms_at(cell), integration, deviator_at(b.state.stress, b.grid.size(), cell),
                            b.trial.active.trial(a), b.state.equivalent[cell], b.stiffness(cell), back);
}

/// Plastic flow in the active cells [first, last).
template <typename Law>
void flow_of(BodyParts& b, const Law& law, Integration integration, std::size_t first, std::size_t last)
{
  const bool in_lanes = constitutive::is_linear<Law> && b.yield.material.kinematic.empty() &&
                        integration == constitutive::Integration::path;
  if constexpr (constitutive::is_linear<Law>)
    if (in_lanes)
      for_lane_cells(b.trial.active.cells(), first, last, b.grid.surface.size(),
                     [&](const LaneCells& at) { ActiveLanes{b}.flow(law, at); });
  for (std::size_t a = first; a < last && !in_lanes; ++a)
  {
    const constitutive::PlasticIncrement result = increment(b, b.yield.at(law, b.trial.active.cell(a)), a, integration);
    store(b.trial.active.start(a) + result.strain, b.state.plastic_strain, b.grid.size(), b.trial.active.cell(a));
    b.trial.active.set_flow(a, result);
  }
}

/// Subtracts the centre of the yield surface before the increment from q.
void ActiveLanes::subtract_centre(const LaneCells& at, LaneDeviators& q) const
{
  const std::size_t n = b.grid.size();
  LaneDeviators centre{};
  for (std::size_t term = 0; term < b.yield.material.kinematic.size(); ++term)
  {
    const LaneDeviators of_term = load_deviators(b.state.backstress.data() + term * Deviator::size * n, n, at);
    for (std::size_t c = 0; c < centre.size(); ++c)
      centre[c] += of_term[c];
  }
  q = q - centre;
}

/// Computes the image g of the trials from the stress of the evaluation.
/// @returns the von Mises norm of g - q over the yield stress; 0 in cells that stay elastic
template <typename Law>
Lanes ActiveLanes::map(const Law& law, const LaneCells& at) const
{
  const ActiveCells::Packed packed = b.trial.active.packed();
  const std::size_t n = b.grid.size();
  const Lanes zero{};
  prefetch(at, b.trial.stress);
  LaneDeviators g = load_deviators(b.trial.stress.data(), n, at);
  const Lanes equivalent = load_lanes(packed.equivalent + at.a, at.count);
  if (any(equivalent != zero)) // cells without flow still have the plastic strain before the increment
  {
    const LaneDeviators increment =
        load_deviators(b.state.plastic_strain.data(), n, at) - load_packed(packed.start, at);
    for (std::size_t c = 0; c < g.size(); ++c)
      g[c] += b.stiffness(at.cell) * increment[c];
  }
  store_packed(g, packed.mapped, at);
  LaneDeviators from_centre = g;
  if (!b.yield.material.kinematic.empty())
    subtract_centre(at, from_centre);
  const Lanes size = von_mises(from_centre);
  const Lanes before = load_lanes(b.state.equivalent.data() + at.cell, at.count);
  const Lanes yield = yield_stresses(law, at, before + equivalent);
  const auto is_plastic = equivalent > zero || !(size <= yield); // negated, so that NaN counts as plastic
  // A cell that stays elastic does not influence the others and must not influence the acceleration: its trial is set to g, so
  // that its residual is zero. A cell that is about to flow has the nearest stress of the yield surface as its trial: its strain
  // is still zero, and its residual is the excess of the stress (put_on_yield_surface).
  if (!any(is_plastic))
  {
    store_packed(g, packed.trials, at);
    return zero;
  }
  LaneDeviators trial = load_packed(packed.trials, at);
  const auto flows = equivalent > zero;
  if (any(!flows))
  {
    const Lanes excess = is_plastic ? 1.0 - yield / size : zero;
    for (std::size_t c = 0; c < g.size(); ++c)
      trial[c] = flows ? trial[c] : g[c] - excess * from_centre[c];
    store_packed(trial, packed.trials, at);
  }
  return von_mises(g - trial) / yield;
}

/// Maps the active cells [first, last). @returns the largest error
template <typename Law>
double map_trials_of(BodyParts& b, const Law& law, std::size_t first, std::size_t last)
{
  double error = 0.0;
  for_lane_cells(b.trial.active.cells(), first, last, b.grid.surface.size(),
                 [&](const LaneCells& at)
                 {
                   const Values errors = values_of(ActiveLanes{b}.map(law, at));
                   for (std::size_t lane = 0; lane < at.count; ++lane)
                     error = larger(error, errors[lane]);
                 });
  return error;
}

} // namespace

void flow(BodyParts& b, Integration integration)
{
  const std::vector<std::size_t>& cells = b.trial.active.cells();
#pragma omp parallel for schedule(static, 1)
  for (std::size_t first = 0; first < cells.size(); first += cells_per_share)
    b.yield.with_laws(cells, first, std::min(first + cells_per_share, cells.size()),
                      [&](const auto& law, std::size_t from, std::size_t to)
                      { flow_of(b, law, integration, from, to); });
}

double map_trials(BodyParts& b)
{
  const std::vector<std::size_t>& cells = b.trial.active.cells();
  double error = 0.0;
#pragma omp parallel for schedule(static, 1) reduction(larger : error)
  for (std::size_t first = 0; first < cells.size(); first += cells_per_share)
    b.yield.with_laws(cells, first, std::min(first + cells_per_share, cells.size()),
                      [&](const auto& law, std::size_t from, std::size_t to)
                      { error = larger(error, map_trials_of(b, law, from, to)); });
  return error;
}

void put_on_yield_surface(BodyParts& b, std::size_t first)
{
  b.yield.with_laws(b.trial.active.cells(), first, b.trial.active.size(),
                    [&](const auto& law, std::size_t from, std::size_t to)
                    {
                      for (std::size_t a = from; a < to; ++a)
                      {
                        const std::size_t cell = b.trial.active.cell(a);
                        const Deviator from_centre = b.trial.active.mapped(a) - b.centre(cell);
                        const double yield = b.yield.at(law, cell).yield_stress_at(b.state.equivalent[cell]);
                        const double excess = std::max(0.0, 1.0 - yield / von_mises(from_centre));
                        b.trial.active.set_trial(a, b.trial.active.mapped(a) - excess * from_centre);
                      }
                    });
}

} // namespace brinell::elastoplastic
