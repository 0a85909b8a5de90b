// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/wear.hpp"

#include "brinell/elastoplastic/effects.hpp"
#include "brinell/foundation/embedding.hpp"
#include "brinell/foundation/error.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace brinell::elastoplastic
{

namespace
{

/// Twice the compliance of the shortest wave along an axis, over the size of the cells and the modulus.
constexpr double explicit_share = 0.9;

/// The intensity of wear as a linear function of the pressure, near the present one and under constant friction.
struct Line
{
  double slope = 0.0; ///< >= 0
  double rest = 0.0;  ///< [Pa]
};

Line line_of(const WearLaw& law, double pressure, double shear)
{
  if (law.kind == WearLaw::Kind::archard)
    return {1.0, 0.0};
  if (pressure <= 0.0) // no wear
    return {};
  const double intensity = law.intensity(pressure, shear);
  if (law.kind == WearLaw::Kind::energy)
    return {intensity / pressure, 0.0};
  constexpr double step = 1e-6;
  const double beyond = law.intensity((1.0 + step) * pressure, (1.0 + step) * shear);
  const double slope = std::max(0.0, (beyond - intensity) / (step * pressure));
  return {slope, intensity - slope * pressure};
}

/// Intensity of wear under which the points of surfaces that may stick begin to slip [Pa]; empty for others.
std::vector<double> intensity_of_onset(const WearLaw& law, const Interaction& trial)
{
  Interface::Onset onset = trial.onset();
  if (law.kind == WearLaw::Kind::energy)
    return std::move(onset.shear);
  if (law.kind == WearLaw::Kind::archard)
    return std::move(onset.pressure);
  for (std::size_t i = 0; i < onset.pressure.size(); ++i)
    onset.pressure[i] = onset.pressure[i] > 0.0 ? law.intensity(onset.pressure[i], onset.shear[i]) : 0.0;
  return std::move(onset.pressure);
}

} // namespace

UserWear::UserWear(Intensity intensity) : intensity_(std::make_shared<const Intensity>(std::move(intensity)))
{
  if (!*intensity_)
    throw InputError("a wear law has no function");
  for (const double pressure : {1.0, 1e3, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11})
    for (const double friction : {0.0, 0.1, 0.5, 1.0})
      static_cast<void>(intensity_at(pressure, friction * pressure));
}

double UserWear::intensity_at(double pressure, double shear) const
{
  const double w = (*intensity_)(pressure, shear);
  if (!(w >= 0.0) || !std::isfinite(w))
    throw InputError(fmt::format("a wear law has the intensity {:g} Pa at the pressure {:g} Pa and the shear {:g} Pa; "
                                 "allowed: >= 0, finite",
                                 w, pressure, shear));
  return w;
}

Wear::Wear(const SurfaceGrid& contact, const SurfaceGrid& lower, const SurfaceGrid& upper, const WearLaw& law,
           double modulus)
    : contact_(contact), law_(law), explicit_limit_(explicit_share * std::min(contact.dx, contact.dy) / modulus),
      sides_{Side{lower, law.lower / law.sum()}, Side{upper, law.upper / law.sum()}},
      state_{.depth = {std::vector<double>(lower.size()), std::vector<double>(upper.size())}},
      compliance_(contact.size()), pressure_before_(contact.size()), from_onset_(contact.size())
{
}

void Wear::begin(const Interaction& before)
{
  const std::span<const double> pressure = before.pressure_before();
  pressure_before_.assign(pressure.begin(), pressure.end());
  for (std::vector<double>* field : {&compliance_, &from_onset_})
    std::fill(field->begin(), field->end(), 0.0);
  if (before.knows_slip())
    static_cast<void>(evaluate(before));
}

double Wear::evaluate(const Interaction& trial)
{
  const bool is_archard = law_.kind == WearLaw::Kind::archard;
  const std::vector<double> length = trial.slip_length();
  const std::vector<double> shear = is_archard ? std::vector<double>() : trial.shear();
  const std::vector<double> onset = intensity_of_onset(law_, trial);
  double change = 0.0;
  for (std::size_t i = 0; i < compliance_.size(); ++i)
  {
    const double p = trial.pressure()[i];
    const double per_pressure = law_.sum() * length[i];
    const Line line = per_pressure > 0.0 ? line_of(law_, p, shear.empty() ? 0.0 : shear[i]) : Line{};
    // Share of the slip that counts under the pressure at the end.
    const double at_end = onset.empty() || per_pressure == 0.0
                              ? 1.0
                              : std::max(0.5, 1.0 - 0.5 * explicit_limit_ / (std::max(1.0, line.slope) * per_pressure));
    const double now = at_end * per_pressure * line.slope;
    const double known =
        (onset.empty() ? 0.0 : (1.0 - at_end) * per_pressure * onset[i]) + at_end * per_pressure * line.rest;
    // With a tangent only the sum matters: rounding errors of the slope cancel in it.
    const double by_slope = (now - compliance_[i]) * p, by_rest = known - from_onset_[i];
    change = larger(change, line.rest != 0.0 ? std::abs(by_slope + by_rest) : std::abs(by_slope) + std::abs(by_rest));
    compliance_[i] = now;
    from_onset_[i] = known;
  }
  return change;
}

void Wear::add_to_gap(std::span<double> gap) const
{
  for (std::size_t i = 0; i < gap.size(); ++i)
    gap[i] += from_onset_[i];
}

double Wear::held_energy(std::span<const double> pressure) const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < compliance_.size(); ++i)
    sum += compliance_[i] * pressure[i] * pressure[i];
  return -0.5 * sum * contact_.cell_area();
}

void Wear::commit(const Interaction& found, const Placement& placement)
{
  const std::span<const double> pressure = found.pressure();
  std::vector<double> worn(compliance_.size());
  double sum = 0.0, work = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < worn.size(); ++i)
  {
    worn[i] = compliance_[i] * pressure[i] + from_onset_[i];
    sum += worn[i];
    work += 0.5 * (pressure_before_[i] + pressure[i]) * worn[i];
    largest = std::max(largest, worn[i]);
  }
  state_.work += work * contact_.cell_area();
  state_.largest_step = std::max(state_.largest_step, largest);
  for (std::size_t side = 0; side < sides_.size(); ++side)
  {
    const auto& [grid, share] = sides_[side];
    if (share == 0.0)
      continue;
    const Place& place = side == 0 ? placement.lower : placement.upper;
    if (!spread_volume(contact_, worn, share, place, grid, state_.depth[side]))
      throw InternalError("Wear: worn cells lie beyond the grid of the body");
    state_.volume[side] += share * sum * contact_.cell_area();
  }
}

double Wear::largest_depth(std::size_t side) const
{
  const std::vector<double>& depth = state_.depth.at(side);
  return *std::max_element(depth.begin(), depth.end());
}

void Wear::add_depth(std::size_t side, const Place& place, std::span<double> out) const
{
  if (volume(side) > 0.0)
    elastoplastic::add_depth(sides_[side].grid, depth(side), {}, place, contact_, out);
}

void Wear::report(EffectTotals& totals) const
{
  totals.worn_volume_lower = volume(0);
  totals.worn_volume_upper = volume(1);
  totals.max_worn_depth_lower = largest_depth(0);
  totals.max_worn_depth_upper = largest_depth(1);
  totals.max_wear_step = largest_step();
  totals.work_of_wear = work();
}

void Wear::embed(const Effect& smaller_grids)
{
  const auto& smaller = dynamic_cast<const Wear&>(smaller_grids);
  state_ = smaller.state_;
  for (std::size_t side = 0; side < sides_.size(); ++side)
  {
    state_.depth[side].assign(sides_[side].grid.size(), 0.0);
    embed_field(smaller.sides_[side].grid, smaller.depth(side), sides_[side].grid, state_.depth[side]);
  }
}

} // namespace brinell::elastoplastic
