// SPDX-License-Identifier: BSD-3-Clause
#include "embedded.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::elastoplastic
{

namespace
{

/// Of the equation of the equivalent strain, relative to the stress that drives it: well below the tolerance of the yield condition.
constexpr double tolerance = 1e-6;
/// Rest that is accepted where the iterations are used up: of strain within voids, which nothing notices.
constexpr double acceptable = 1e-4;
constexpr int most_iterations = 400;
/// Of the acceleration of the displacement: the trials change it, too, so that differences are soon outdated.
constexpr int depth = 2;
/// Changes of the displacement, relative to the largest, that are nothing but this.
constexpr double rounding = 1e-12;

} // namespace

Embedded::Embedded(const halfspace::HalfSpace& body, const std::vector<halfspace::Inclusion>& inclusions,
                   std::size_t axes)
    : inclusions_(body, inclusions), present_{inclusions_.make_solution(),
                                              std::vector<double>(axes * body.grid().surface.size())},
      committed_(present_), given_(inclusions_.make_field()), surface_(body.grid().surface.size()), axes_(axes),
      acceleration_(depth), trace_(body.grid().size())
{
  if (inclusions_.has_own_strain())
    find_own_stress();
}

/// Finds the equivalent strain for the stress `given_`, and adds its fields.
void Embedded::solve(halfspace::Inclusions::Solution& solution, int layers, const halfspace::HalfSpace::Dilated& to)
{
  report_ = inclusions_.update(given_, solution, tolerance, most_iterations, layers, to);
  if (report_.residual > acceptable) // a trial that has got out of hand has numbers that are none, and is repeated
    throw ConvergenceError(fmt::format("the equivalent strain of the inclusions has not converged: after {} iterations "
                                       "its equation is off by {:.1e} of the stress",
                                       report_.iterations, report_.residual));
}

void Embedded::find_own_stress()
{
  halfspace::Inclusions::Solution solution = inclusions_.make_solution();
  const halfspace::InclusionField& own = inclusions_.own_strain();
  const int layers = static_cast<int>(trace_.size() / surface_);
  inclusions_.stress(own, given_);
  own_deviator_.assign(Deviator::size * trace_.size(), 0.0);
  own_trace_.assign(trace_.size(), 0.0);
  inclusions_.add(own, layers, {own_deviator_, own_trace_, {}});
  solve(solution, layers, {own_deviator_, own_trace_, {}});
}

namespace
{

/// Adds a field in the uppermost cells of each component; an empty one is zero.
void add_field(const std::vector<double>& field, std::size_t components, std::size_t of_layers, std::span<double> to)
{
  const std::size_t all = field.size() / components;
  for (std::size_t c = 0; c < components && !field.empty(); ++c)
    for (std::size_t i = c * all; i < c * all + of_layers; ++i)
      to[i] += field[i];
}

} // namespace

void Embedded::add_displacement(std::size_t axis, std::span<double> displacement) const
{
  const std::span<const double> own = std::span(present_.displacement).subspan(axis * surface_, surface_);
  for (std::size_t i = 0; i < displacement.size(); ++i)
    displacement[i] += own[i];
}

void Embedded::update(const halfspace::HalfSpace::Loaded& strain, const halfspace::SurfaceLoad& load, int layers,
                      std::span<double> stress)
{
  strain.traces(load, trace_);
  inclusions_.gather(stress, trace_, given_);
  found_.assign(axes_ * surface_, 0.0);
  const auto of_axis = [&](std::size_t axis)
  { return axis < axes_ ? std::span(found_).subspan(axis * surface_, surface_) : std::span<double>(); };
  solve(present_.solution, layers, {stress, {}, {of_axis(0), of_axis(1), of_axis(2)}});
  add_field(own_deviator_, Deviator::size, static_cast<std::size_t>(layers) * surface_, stress);
  change_.resize(found_.size());
  error_ = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < found_.size(); ++i)
  {
    change_[i] = found_[i] - present_.displacement[i];
    error_ = i < surface_ ? std::max(error_, std::abs(change_[i])) : error_;
    largest = i < surface_ ? std::max(largest, std::abs(found_[i])) : largest;
  }
  if (error_ > rounding * largest)
    return acceleration_.advance(present_.displacement, found_, change_);
  present_.displacement = found_; // differences of rounding would be accelerated to anything
  acceleration_.reset();
}

void Embedded::add_stress(int layers, std::span<double> deviator, std::span<double> trace)
{
  inclusions_.add(present_.solution.equivalent, layers, {deviator, trace, {}});
  add_field(own_deviator_, Deviator::size, static_cast<std::size_t>(layers) * surface_, deviator);
  add_field(own_trace_, 1, static_cast<std::size_t>(layers) * surface_, trace);
}

void Embedded::restore()
{
  present_ = committed_;
  acceleration_.reset();
}

void Embedded::commit()
{
  committed_ = present_;
}

void Embedded::exchange(Archive& archive)
{
  halfspace::Inclusions::Solution& solution = committed_.solution;
  archive("equivalent_deviator", solution.equivalent.deviator);
  archive("equivalent_volume", solution.equivalent.volumetric);
  archive("caused_deviator", solution.caused.deviator);
  archive("caused_volume", solution.caused.volumetric);
  archive("displacement", committed_.displacement);
  restore();
}

} // namespace brinell::elastoplastic
