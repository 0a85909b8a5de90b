// SPDX-License-Identifier: BSD-3-Clause
#include "track.hpp"

#include "simulation/stepping/records.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::simulation
{

namespace
{

/// Cell under x = y = 0.
std::size_t middle(const VolumeGrid& grid, int layer)
{
  const SurfaceGrid& s = grid.surface;
  return grid.index((s.nx - 1) / 2, (s.ny - 1) / 2, layer);
}

/// Equivalent plastic strain in a layer under x = y = 0; a rigid body has none.
double strain_in_middle(const elastoplastic::Body& body, int layer)
{
  return body.equivalent_at(middle(body.grid(), layer));
}

} // namespace

TrackReader::TrackReader(double distance, double shift) : quarter_(std::max(0.25 * distance, shift) * (1.0 + 1e-9)) {}

void TrackReader::begin_pass(const elastoplastic::Body& lower)
{
  plastic_strain_.assign(static_cast<std::size_t>(lower.grid().nz), 0.0);
  for (int layer = 0; layer < lower.grid().nz; ++layer)
    plastic_strain_[static_cast<std::size_t>(layer)] = strain_in_middle(lower, layer);
  whole_ = middle_ = before_ = after_ = {};
  farthest_ = -4.0 * quarter_; // before the start
}

/// Stick and slip depend on the start of the pass, not on its end: means are over the last quarter of the track.
void TrackReader::add_tangential(const RollingRecord& before, const RollingRecord& record)
{
  const bool rolls = record.x > farthest_; // otherwise the body is pressed on or lifted off
  farthest_ = std::max(farthest_, record.x);
  if (!rolls || record.x <= quarter_)
    return;
  (record.x <= 1.5 * quarter_ ? before_ : after_).add(before, record);
}

void TrackReader::add(const RollingRecord& before, const RollingRecord& record)
{
  whole_.add(before, record);
  add_tangential(before, record);
  if (std::abs(record.x) > quarter_)
    return;
  const Uptake now{record.x, record.dissipation_lower + record.dissipation_upper + record.energy_residual};
  if (middle_.count() == 0)
    first_ = now;
  if (middle_.count() == 0 || std::abs(now.x) < std::abs(centre_.x))
    centre_ = now;
  last_ = now;
  middle_.add(before, record);
}

RollingPass TrackReader::end_pass(const elastoplastic::CoupledContact& pair) const
{
  const elastoplastic::BodyState& lower = pair.lower().solved().state();
  const VolumeGrid& grid = pair.lower().grid(); // may have grown in the pass
  const SurfaceGrid& s = grid.surface;
  RollingPass pass;
  pass.rut_depth = lower.residual_displacement[middle(grid, 0)];
  for (int j = 0; j < s.ny; ++j)
    pass.shoulder_height = std::max(pass.shoulder_height, -lower.residual_displacement[s.index((s.nx - 1) / 2, j)]);
  pass.max_equivalent_plastic_strain = whole_.last(&RollingRecord::max_equivalent_plastic_strain);
  for (int layer = 0; layer < grid.nz; ++layer)
  {
    const auto l = static_cast<std::size_t>(layer);
    const double before = l < plastic_strain_.size() ? plastic_strain_[l] : 0.0;
    const double now = strain_in_middle(pair.lower().solved(), layer);
    pass.track_plastic_strain = std::max(pass.track_plastic_strain, now);
    pass.track_plastic_increment = std::max(pass.track_plastic_increment, now - before);
  }
  pass.dissipation = whole_.growth(&RollingRecord::dissipation_lower, &RollingRecord::dissipation_upper);
  fill_tangential(pass);
  if (middle_.count() == 0)
    return pass;
  const double load = middle_.sum(&RollingRecord::F_n);
  pass.mean_F_X = middle_.mean(&RollingRecord::F_X);
  pass.friction = load > 0.0 ? middle_.sum(&RollingRecord::F_X) / load : 0.0;
  pass.contact_area = middle_.mean(&RollingRecord::contact_area);
  pass.max_pressure = middle_.mean(&RollingRecord::max_pressure);
  const auto per_length = [](const Uptake& from, const Uptake& to)
  { return to.x > from.x ? (to.energy - from.energy) / (to.x - from.x) : 0.0; };
  pass.resistance = per_length(first_, last_);
  const double before = per_length(first_, centre_);
  const double after = per_length(centre_, last_);
  constexpr double nothing = 1e-6; // share of the load: a smaller resistance is due to rounding and tolerances
  if (const double larger = std::max({std::abs(before), std::abs(after), nothing * load / middle_.count()});
      larger > 0.0)
    pass.unsteadiness = std::abs(after - before) / larger;
  return pass;
}

void TrackReader::fill_tangential(RollingPass& pass) const
{
  using R = RollingRecord;
  const int count = before_.count() + after_.count();
  if (count == 0)
    return;
  const auto mean = [&](auto member) { return (before_.sum(member) + after_.sum(member)) / count; };
  pass.F_x = mean(&R::F_x);
  pass.F_y = mean(&R::F_y);
  pass.M_z = mean(&R::M_z);
  pass.stick_share = mean(&R::stick_share);
  if (before_.count() == 0 || after_.count() == 0) // track too short
  {
    pass.creep_unsteadiness = pass.F_x != 0.0 || pass.F_y != 0.0 ? 1.0 : 0.0;
    return;
  }
  const double x = before_.mean(&R::F_x), y = before_.mean(&R::F_y);
  const double later_x = after_.mean(&R::F_x), later_y = after_.mean(&R::F_y);
  constexpr double nothing = 1e-6; // share of the load, as for the resistance
  if (const double larger = std::max({std::hypot(x, y), std::hypot(later_x, later_y), nothing * mean(&R::F_n)});
      larger > 0.0)
    pass.creep_unsteadiness = std::hypot(later_x - x, later_y - y) / larger;
}

void TrackReader::exchange(Archive& archive)
{
  archive.list("plastic_strain", plastic_strain_);
  archive("first", first_);
  archive("centre", centre_);
  archive("last", last_);
  archive("whole", whole_);
  archive("middle", middle_);
  archive("before", before_);
  archive("after", after_);
  archive("farthest", farthest_);
}

void TrackReader::Uptake::exchange(Archive& archive)
{
  archive("x", x);
  archive("energy", energy);
}

TrackProfile track_profile(const VolumeGrid& grid, const StepFields::Within& body)
{
  TrackProfile profile;
  if (!body.stress)
    return profile;
  const Spaced layers{0, grid.nz, 1}, row{(grid.surface.ny - 1) / 2, 1, 1}, column{(grid.surface.nx - 1) / 2, 1, 1};
  const LayeredFields stress = body.stress().selected(layers, row, column);
  profile.residual_xx = stress.whole(0);
  profile.residual_yy = stress.whole(1);
  profile.equivalent_plastic_strain = body.equivalent_plastic_strain().selected(layers, row, column).whole();
  // Only one of several ranks receives the fields.
  for (std::size_t layer = 0; layer < profile.residual_xx.size(); ++layer)
    profile.depth.push_back((static_cast<double>(layer) + 0.5) * grid.dz);
  return profile;
}

void RollingPass::exchange(Archive& archive)
{
  exchange_columns(*this, archive);
}

} // namespace brinell::simulation
