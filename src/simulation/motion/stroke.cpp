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

void StrokeReader::begin_stroke(const Stepper& stepper)
{
  sums_ = {};
  plastic_before_ = plastic_work(stepper);
  friction_before_ = friction_;
}

void StrokeReader::add(const SlidingRecord& r)
{
  sums_.add(r);
  friction_ = r.dissipation_friction;
}

SlidingStroke StrokeReader::end_stroke(const Stepper& stepper, const SlidingRecord& last) const
{
  SlidingStroke stroke;
  stroke.stroke = last.pass;
  using R = SlidingRecord;
  const double load = sums_.sum(&R::F_n), ploughing = sums_.sum(&R::F_ploughing), shear = sums_.sum(&R::F_friction);
  if (load > 0.0)
  {
    stroke.friction_ploughing = ploughing / load;
    stroke.friction_interfacial = shear / load;
    stroke.friction = stroke.friction_ploughing + stroke.friction_interfacial;
  }
  stroke.mean_F_X = (ploughing + shear) / sums_.count();
  stroke.contact_area = sums_.mean(&R::contact_area);
  stroke.contact_fraction = sums_.mean(&R::contact_fraction);
  stroke.patches = sums_.mean(&R::patches);
  stroke.largest_patch = sums_.mean(&R::largest_patch);
  stroke.mean_gap = sums_.mean(&R::mean_gap);
  stroke.max_pressure = sums_.mean(&R::max_pressure);
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
