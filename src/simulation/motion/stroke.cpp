// SPDX-License-Identifier: BSD-3-Clause
#include "stroke.hpp"

#include "brinell/simulation/bearing.hpp"
#include "simulation/stepping/snapshot.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace brinell::simulation
{

namespace
{

double plastic_work(const Stepper& stepper)
{
  return stepper.pair().lower().solved().state().dissipation + stepper.pair().upper().solved().state().dissipation;
}

/// Roughness of a surface with texture, residual displacement and wear.
struct Heights
{
  double root_mean_square = 0.0, mean_magnitude = 0.0; ///< Sq and Sa, about the mean height [m]
  Bearing bearing;
};

Heights heights_of(const elastoplastic::BodyView& body, std::span<const double> worn)
{
  std::vector<double> height = surface_height(body, worn);
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

void StrokeReader::Sums::exchange(Archive& archive)
{
  archive("F_n", F_n);
  archive("F_ploughing", F_ploughing);
  archive("F_friction", F_friction);
  archive("contact_area", contact_area);
  archive("contact_fraction", contact_fraction);
  archive("patches", patches);
  archive("largest_patch", largest_patch);
  archive("mean_gap", mean_gap);
  archive("max_pressure", max_pressure);
  archive("steps", steps, 0, std::numeric_limits<int>::max() - 1);
}

void StrokeReader::begin_stroke(const Stepper& stepper)
{
  sums_ = {};
  plastic_before_ = plastic_work(stepper);
  friction_before_ = friction_;
}

void StrokeReader::add(const SlidingRecord& r)
{
  sums_.F_n += r.F_n;
  sums_.F_ploughing += r.F_ploughing;
  sums_.F_friction += r.F_friction;
  sums_.contact_area += r.contact_area;
  sums_.contact_fraction += r.contact_fraction;
  sums_.patches += r.patches;
  sums_.largest_patch += r.largest_patch;
  sums_.mean_gap += r.mean_gap;
  sums_.max_pressure += r.max_pressure;
  ++sums_.steps;
  friction_ = r.dissipation_friction;
}

SlidingStroke StrokeReader::end_stroke(const Stepper& stepper, const SlidingRecord& last) const
{
  SlidingStroke stroke;
  stroke.stroke = last.pass;
  if (sums_.F_n > 0.0)
  {
    stroke.friction_ploughing = sums_.F_ploughing / sums_.F_n;
    stroke.friction_interfacial = sums_.F_friction / sums_.F_n;
    stroke.friction = stroke.friction_ploughing + stroke.friction_interfacial;
  }
  stroke.mean_F_X = (sums_.F_ploughing + sums_.F_friction) / sums_.steps;
  stroke.contact_area = sums_.contact_area / sums_.steps;
  stroke.contact_fraction = sums_.contact_fraction / sums_.steps;
  stroke.patches = sums_.patches / sums_.steps;
  stroke.largest_patch = sums_.largest_patch / sums_.steps;
  stroke.mean_gap = sums_.mean_gap / sums_.steps;
  stroke.max_pressure = sums_.max_pressure / sums_.steps;
  stroke.dissipation_plastic = plastic_work(stepper) - plastic_before_;
  stroke.dissipation_friction = last.dissipation_friction - friction_before_;
  stroke.max_equivalent_plastic_strain = last.max_equivalent_plastic_strain;
  const Heights lower = heights_of(stepper.pair().lower(), worn_depth(stepper.pair(), 0));
  const Heights upper = heights_of(stepper.pair().upper(), worn_depth(stepper.pair(), 1));
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

void StrokeReader::exchange(Archive& archive)
{
  archive("sums", sums_);
  archive("plastic_before", plastic_before_);
  archive("friction_before", friction_before_);
  archive("friction", friction_);
}

} // namespace brinell::simulation
