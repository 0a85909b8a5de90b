// SPDX-License-Identifier: BSD-3-Clause
#include "track.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brinell::simulation
{

namespace
{

/// Cell under x = y = 0.
std::size_t middle(const VolumeGrid& grid, int layer)
{
  const SurfaceGrid& s = grid.surface;
  return static_cast<std::size_t>((s.nx - 1) / 2 + s.nx * ((s.ny - 1) / 2 + s.ny * layer));
}

} // namespace

TrackReader::TrackReader(const VolumeGrid& lower, double distance)
    : grid_(lower), quarter_(0.25 * distance), plastic_strain_(static_cast<std::size_t>(lower.nz), 0.0)
{
}

void TrackReader::begin_pass(const elastoplastic::BodyState& lower, double dissipation)
{
  for (int layer = 0; layer < grid_.nz; ++layer)
    plastic_strain_[static_cast<std::size_t>(layer)] = lower.equivalent[middle(grid_, layer)];
  dissipation_ = dissipation;
  sum_resistance_ = sum_pressure_ = 0.0;
  count_ = 0;
}

void TrackReader::add(const RollingRecord& record)
{
  if (std::abs(record.x) > quarter_)
    return;
  sum_resistance_ += record.F_X;
  sum_pressure_ += record.max_pressure;
  ++count_;
}

RollingPass TrackReader::end_pass(const elastoplastic::CoupledContact& pair, double dissipation) const
{
  const elastoplastic::BodyState& lower = pair.lower().state();
  const elastoplastic::BodyState& upper = pair.upper().state();
  const SurfaceGrid& s = grid_.surface;
  RollingPass pass;
  pass.rut_depth = lower.residual_displacement[middle(grid_, 0)];
  for (int j = 0; j < s.ny; ++j)
    pass.shoulder_height = std::max(pass.shoulder_height,
                                    -lower.residual_displacement[static_cast<std::size_t>((s.nx - 1) / 2 + s.nx * j)]);
  for (const elastoplastic::BodyState* body : {&lower, &upper})
    pass.max_equivalent_plastic_strain = std::max(pass.max_equivalent_plastic_strain,
                                                  *std::max_element(body->equivalent.begin(), body->equivalent.end()));
  for (int layer = 0; layer < grid_.nz; ++layer)
  {
    const double now = lower.equivalent[middle(grid_, layer)];
    pass.track_plastic_strain = std::max(pass.track_plastic_strain, now);
    pass.track_plastic_increment =
        std::max(pass.track_plastic_increment, now - plastic_strain_[static_cast<std::size_t>(layer)]);
  }
  pass.dissipation = dissipation - dissipation_;
  if (count_ > 0)
  {
    pass.resistance = sum_resistance_ / count_;
    pass.max_pressure = sum_pressure_ / count_;
  }
  return pass;
}

void TrackReader::exchange(Archive& archive)
{
  archive("plastic_strain", plastic_strain_);
  archive("dissipation", dissipation_);
  archive("sum_resistance", sum_resistance_);
  archive("sum_pressure", sum_pressure_);
  archive("count", count_, 0, std::numeric_limits<int>::max() - 1);
}

TrackProfile track_profile(const BodySnapshot& body)
{
  TrackProfile profile;
  if (body.stress[0].empty())
    return profile;
  for (int layer = 0; layer < body.grid.nz; ++layer)
  {
    const std::size_t cell = middle(body.grid, layer);
    profile.depth.push_back((layer + 0.5) * body.grid.dz);
    profile.residual_xx.push_back(body.stress[0][cell]);
    profile.residual_yy.push_back(body.stress[1][cell]);
    profile.equivalent_plastic_strain.push_back(body.equivalent_plastic_strain[cell]);
  }
  return profile;
}

} // namespace brinell::simulation
