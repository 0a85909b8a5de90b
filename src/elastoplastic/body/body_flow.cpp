// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body.hpp"
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

} // namespace

/// Operations on several active cells at once, one per lane of a vector register.
struct Body::ActiveLanes
{
  Body& body;

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
void Body::ActiveLanes::prefetch(const LaneCells& at, const std::vector<double>& stress) const
{
  constexpr std::size_t ahead = 2 * lane_count;
  const std::vector<std::size_t>& cells = body.active_.cells();
  const std::size_t cell = cells[std::min(at.a + ahead, cells.size() - 1)], n = body.grid().size();
  __builtin_prefetch(body.state_.equivalent.data() + cell);
  for (const std::span<const double> field : {std::span<const double>(body.state_.plastic_strain), std::span(stress)})
    for (std::size_t c = 0; c < Deviator::size; ++c)
      __builtin_prefetch(field.data() + c * n + cell);
}

/// Evaluates a property of the hardening laws of the cells, such as the yield stress.
/// @param equivalent  equivalent plastic strain at which the property is evaluated
template <typename Law, typename Property>
Lanes Body::ActiveLanes::evaluate_laws(const Law& law, const LaneCells& at, const Lanes& equivalent,
                                       const Property& property) const
{
  Values factors;
  factors.fill(body.yield_factor_[body.layer_of(at.cell)]);
  for (std::size_t lane = 0; lane < at.count && !body.softening_.empty(); ++lane)
    factors[lane] *= body.softening_[at.cell + lane];
  Values values = values_of(equivalent);
  // A linear law is cheap: it is evaluated in unused lanes as well, so that the loop has a fixed length.
  const std::size_t count = constitutive::is_linear<Law> ? lane_count : at.count;
  for (std::size_t lane = 0; lane < count; ++lane)
    values[lane] = property(constitutive::ScaledLaw<Law>{law, factors[lane]}, values[lane]);
  return load_lanes(values.data());
}

template <typename Law>
Lanes Body::ActiveLanes::yield_stresses(const Law& law, const LaneCells& at, const Lanes& equivalent) const
{
  return evaluate_laws(law, at, equivalent,
                       [](const auto& scaled_law, double e) { return scaled_law.yield_stress_at(e); });
}

/// Plastic flow by path integration, for a law whose yield stress is linear in the plastic strain, without kinematic hardening.
template <typename Law>
void Body::ActiveLanes::flow(const Law& law, const LaneCells& at) const
{
  const ActiveCells::Packed packed = body.active_.packed();
  const std::size_t n = body.grid().size();
  prefetch(at, body.state_.stress);
  constitutive::LanePoints points;
  points.trial = load_packed(packed.trials, at);
  const Lanes before = load_lanes(body.state_.equivalent.data() + at.cell, at.count);
  points.yield = yield_stresses(law, at, before);
  const bool flows = any(constitutive::is_outside(points));
  // Cells that flowed neither in the previous evaluation nor now need no update.
  if (!flows && !any(load_lanes(packed.equivalent + at.a, at.count) != Lanes{}))
    return;
  if (flows)
  {
    points.start = load_deviators(body.state_.stress.data(), n, at);
    points.modulus =
        evaluate_laws(law, at, before, [](const auto& scaled_law, double e) { return scaled_law.modulus_at(e); });
    constitutive::path_return(points, 0.5 * body.stiffness_);
  }
  store_lanes(points.equivalent, at.count, packed.equivalent + at.a);
  store_lanes(points.dissipation, at.count, packed.dissipation + at.a);
  LaneDeviators& strain = points.strain;
  const Lanes copies = load_lanes(packed.copies + at.a, at.count);
  store_packed(as_factors(strain, copies), packed.flow, at);
  const LaneDeviators start = load_packed(packed.start, at);
  for (std::size_t c = 0; c < strain.size(); ++c)
    strain[c] += start[c];
  store_deviators(strain, body.state_.plastic_strain.data(), n, at);
}

/// Plastic flow in one active cell.
template <typename Law>
constitutive::PlasticIncrement Body::increment(const Law& law, std::size_t a, Integration integration)
{
  const std::size_t cell = active_.cell(a);
  const std::span<Deviator> back = active_.backstress(a);
  for (std::size_t term = 0; term < back.size(); ++term)
    back[term] = backstress(cell, term);
  return constitutive::flow(law, material_.kinematic, integration, deviator_at(state_.stress, grid().size(), cell),
                            active_.trial(a), state_.equivalent[cell], stiffness_, back);
}

/// Plastic flow in all active cells.
template <typename Law>
void Body::flow_of(const Law& law, Integration integration)
{
  const bool in_lanes =
      constitutive::is_linear<Law> && material_.kinematic.empty() && integration == constitutive::Integration::path;
#pragma omp parallel for schedule(static, 1)
  for (std::size_t first = 0; first < active_.size(); first += cells_per_share)
  {
    const std::size_t last = std::min(first + cells_per_share, active_.size());
    if constexpr (constitutive::is_linear<Law>)
      if (in_lanes)
        for_lane_cells(active_.cells(), first, last, grid().surface.size(),
                       [&](const LaneCells& at) { ActiveLanes{*this}.flow(law, at); });
    for (std::size_t a = first; a < last && !in_lanes; ++a)
    {
      const constitutive::PlasticIncrement result = increment(law_at(law, active_.cell(a)), a, integration);
      store(active_.start(a) + result.strain, state_.plastic_strain, grid().size(), active_.cell(a));
      active_.set_flow(a, result);
    }
  }
}

double Body::integrate(Integration integration)
{
  if (!is_plastic())
    return 0.0;
  if (work_.empty())
    work_ = half_space_->make_work();
  choose_window();
  const std::vector<double> before = displacement_;
  std::visit([&](const auto& law) { flow_of(law, integration); }, *material_.hardening);
  load_strain();
  const double change = change_of_displacement(before);
  was_windowed_ = windowed_;
  return change;
}

/// Subtracts the centre of the yield surface before the increment from q.
void Body::ActiveLanes::subtract_centre(const LaneCells& at, LaneDeviators& q) const
{
  const std::size_t n = body.grid().size();
  LaneDeviators centre{};
  for (std::size_t term = 0; term < body.material_.kinematic.size(); ++term)
  {
    const LaneDeviators of_term = load_deviators(body.state_.backstress.data() + term * Deviator::size * n, n, at);
    for (std::size_t c = 0; c < centre.size(); ++c)
      centre[c] += of_term[c];
  }
  q = q - centre;
}

/// Computes the image g of the trials from the stress of the evaluation.
/// @returns the von Mises norm of g - q over the yield stress; 0 in cells that stay elastic
template <typename Law>
Lanes Body::ActiveLanes::map(const Law& law, const LaneCells& at) const
{
  const ActiveCells::Packed packed = body.active_.packed();
  const std::size_t n = body.grid().size();
  const Lanes zero{};
  prefetch(at, body.stress_);
  LaneDeviators g = load_deviators(body.stress_.data(), n, at);
  const Lanes equivalent = load_lanes(packed.equivalent + at.a, at.count);
  if (any(equivalent != zero)) // cells without flow still have the plastic strain before the increment
  {
    const LaneDeviators increment =
        load_deviators(body.state_.plastic_strain.data(), n, at) - load_packed(packed.start, at);
    for (std::size_t c = 0; c < g.size(); ++c)
      g[c] += body.stiffness_ * increment[c];
  }
  store_packed(g, packed.mapped, at);
  LaneDeviators from_centre = g;
  if (!body.material_.kinematic.empty())
    subtract_centre(at, from_centre);
  const Lanes size = von_mises(from_centre);
  const Lanes before = load_lanes(body.state_.equivalent.data() + at.cell, at.count);
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

template <typename Law>
double Body::map_trials(const Law& law)
{
  double error = 0.0;
#pragma omp parallel for schedule(static, 1) reduction(larger : error)
  for (std::size_t first = 0; first < active_.size(); first += cells_per_share)
    for_lane_cells(active_.cells(), first, std::min(first + cells_per_share, active_.size()), grid().surface.size(),
                   [&](const LaneCells& at)
                   {
                     const Values errors = values_of(ActiveLanes{*this}.map(law, at));
                     for (std::size_t lane = 0; lane < at.count; ++lane)
                       error = larger(error, errors[lane]);
                   });
  return error;
}

/// Moves the trials of the active cells from `first` on, which have not been evaluated yet, to the nearest stress of the yield
/// surface. Without plastic strain this is the stress of the material law; g - q, the excess of the stress over it, is then the
/// residual that belongs to the evaluation that found the cells. A trial of g would have no residual there but one in the next
/// evaluation, at the same trial, and the difference of the two would mislead the acceleration.
void Body::put_on_yield_surface(std::size_t first)
{
  std::visit(
      [&](const auto& law)
      {
        for (std::size_t a = first; a < active_.size(); ++a)
        {
          const std::size_t cell = active_.cell(a);
          const Deviator from_centre = active_.mapped(a) - centre(cell);
          const double yield = law_at(law, cell).yield_stress_at(state_.equivalent[cell]);
          const double excess = std::max(0.0, 1.0 - yield / von_mises(from_centre));
          active_.set_trial(a, active_.mapped(a) - excess * from_centre);
        }
      },
      *material_.hardening);
}

bool Body::update(const halfspace::SurfaceLoad& load)
{
  if (!is_plastic())
    return false;
  find_stress(load);
  const auto acts = [](double shear) { return shear != 0.0; };
  bears_shear_ = std::any_of(load.shear_x.begin(), load.shear_x.end(), acts) ||
                 std::any_of(load.shear_y.begin(), load.shear_y.end(), acts);
  yield_error_ = std::visit([&](const auto& law) { return map_trials(law); }, *material_.hardening);
  const std::size_t before = active_.size();
  collect_active(stress_, 0, 1.0);
  if (active_.size() == before)
    return false;
  include_new_cells(before);
  put_on_yield_surface(before);
  return true;
}

} // namespace brinell::elastoplastic
