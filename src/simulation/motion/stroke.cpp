// SPDX-License-Identifier: BSD-3-Clause
#include "stroke.hpp"

#include "brinell/simulation/bearing.hpp"
#include "simulation/stepping/snapshot.hpp"

#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace brinell::simulation
{

namespace
{

/// Roughness of a surface with texture, residual displacement and wear.
struct Heights
{
  double root_mean_square = 0.0, mean_magnitude = 0.0; ///< Sq and Sa, about the mean height [m]
  Bearing bearing;
};

Heights heights_of(std::vector<double> height)
{
  const auto size = static_cast<double>(height.size());
  const double mean = std::accumulate(height.begin(), height.end(), 0.0) / size;
  double squares = 0.0, magnitudes = 0.0;
  for (const double h : height)
  {
    squares += (h - mean) * (h - mean);
    magnitudes += std::abs(h - mean);
  }
  return {std::sqrt(squares / size), magnitudes / size, bearing_of(std::move(height))};
}

} // namespace

SlidingStroke stroke_of(const ColumnStatistics<SlidingRecord>& rows, const Stepper& stepper)
{
  SlidingStroke stroke;
  using R = SlidingRecord;
  stroke.stroke = static_cast<int>(rows.last(&R::pass));
  const double load = rows.sum(&R::F_n), ploughing = rows.sum(&R::F_ploughing), shear = rows.sum(&R::F_friction);
  if (load > 0.0)
  {
    stroke.friction_ploughing = ploughing / load;
    stroke.friction_interfacial = shear / load;
    stroke.friction = stroke.friction_ploughing + stroke.friction_interfacial;
  }
  stroke.mean_F_X = (ploughing + shear) / rows.count();
  stroke.contact_area = rows.mean(&R::contact_area);
  stroke.contact_fraction = rows.mean(&R::contact_fraction);
  stroke.patches = rows.mean(&R::patches);
  stroke.largest_patch = rows.mean(&R::largest_patch);
  stroke.mean_gap = rows.mean(&R::mean_gap);
  stroke.max_pressure = rows.mean(&R::max_pressure);
  stroke.dissipation_plastic = rows.growth(&R::dissipation_lower, &R::dissipation_upper);
  stroke.dissipation_friction = rows.growth(&R::dissipation_friction);
  stroke.max_equivalent_plastic_strain = rows.last(&R::max_equivalent_plastic_strain);
  const Heights lower = heights_of(surface_height(stepper.pair(), 0));
  const Heights upper = heights_of(surface_height(stepper.pair(), 1));
  stroke.rms_height_lower = lower.root_mean_square;
  stroke.mean_height_lower = lower.mean_magnitude;
  stroke.rms_height_upper = upper.root_mean_square;
  stroke.mean_height_upper = upper.mean_magnitude;
  stroke.core_height_lower = lower.bearing.core_height;
  stroke.core_height_upper = upper.bearing.core_height;
  stroke.peak_height_lower = lower.bearing.peak_height;
  stroke.peak_height_upper = upper.bearing.peak_height;
  stroke.valley_depth_lower = lower.bearing.valley_depth;
  stroke.valley_depth_upper = upper.bearing.valley_depth;
  return stroke;
}

} // namespace brinell::simulation
