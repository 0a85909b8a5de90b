// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/first_yield.hpp"

#include "brinell/reference/sliding_contact.hpp"
#include "domain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <vector>

namespace brinell::simulation
{

namespace
{

using constitutive::Material;

/// Ratio C of peak pressure to yield stress at first yield.
double pressure_ratio(double poisson_ratio, ContactKind kind, double friction)
{
  if (kind == ContactKind::line)
    return reference::line_sliding_first_yield(poisson_ratio, friction).pressure_ratio;
  // Without friction C is the fit of the paper. Its error of 0.15 % must not make the value with friction larger.
  const double frictionless = reference::critical_pressure_ratio(poisson_ratio);
  if (friction == 0.0)
    return frictionless;
  return std::min(frictionless, reference::sliding_first_yield(poisson_ratio, friction).pressure_ratio);
}

/// C of one body; empty if it stays elastic.
std::optional<PairYield> yield_of(const Material& material, double factor, YieldsFirst body, double ratio)
{
  if (!material.is_plastic())
    return std::nullopt;
  return PairYield{ratio, factor * constitutive::initial_yield_stress(material.law()), body};
}

std::optional<PairYield> weaker(const std::optional<PairYield>& lower, const std::optional<PairYield>& upper)
{
  if (!lower || !upper)
    return lower ? lower : upper;
  PairYield weaker = lower->peak_pressure() <= upper->peak_pressure() ? *lower : *upper;
  if (lower->peak_pressure() == upper->peak_pressure())
    weaker.body = YieldsFirst::both;
  return weaker;
}

/// @param factors  factors on the yield stress of the lower and the upper body
std::optional<PairYield> yield_of_pair(const Material& lower, const Material& upper,
                                       const std::array<double, 2>& factors, ContactKind kind, double friction)
{
  const auto ratio_of = [&](const Material& material)
  { return material.is_plastic() ? pressure_ratio(material.elastic.poisson_ratio, kind, friction) : 0.0; };
  const double of_lower = ratio_of(lower);
  const bool are_alike = lower.is_plastic() && lower.elastic.poisson_ratio == upper.elastic.poisson_ratio;
  const double of_upper = are_alike ? of_lower : ratio_of(upper); // avoids a second search with friction
  return weaker(yield_of(lower, factors[0], YieldsFirst::lower, of_lower),
                yield_of(upper, factors[1], YieldsFirst::upper, of_upper));
}

/// Relative curvature 1/R of a round point contact, or of cylinders [1/m].
std::optional<double> curvature_of(const Shape& lower, const Shape& upper, ContactKind kind)
{
  if (kind == ContactKind::line)
    return (*relative_curvature(lower, upper))[0];
  const std::optional<double> radius = equivalent_radius(lower, upper);
  return radius ? std::optional(1.0 / *radius) : std::nullopt;
}

std::optional<FirstYield> first_yield_of(const ShapedBody& lower, const ShapedBody& upper, const Domain& domain,
                                         const std::optional<PairYield>& yield)
{
  const ContactKind kind = contact_kind(lower.shape, upper.shape, domain);
  const auto curvature = curvature_of(lower.shape, upper.shape, kind);
  if (!yield || !curvature)
    return std::nullopt;
  const double radius = 1.0 / *curvature;
  const double modulus = contact_modulus(lower.material.elastic, upper.material.elastic);
  if (kind == ContactKind::point)
    return FirstYield{reference::critical_values(radius, modulus, yield->pressure_ratio, yield->yield_stress),
                      yield->body};
  const reference::Line line{domain.y.size, reference_distance(lower.shape, upper.shape, domain)};
  if (!(line.reference > radius * yield->peak_pressure() /
                             modulus)) // half of the half-width; at this reference distance the approach is largest
    return std::nullopt;
  return FirstYield{reference::critical_values(radius, modulus, yield->pressure_ratio, yield->yield_stress, line),
                    yield->body, line};
}

/// Yield stress of each layer at a depth; empty if the body stays elastic.
std::function<double(std::size_t, double)> strength_of(const Material& material)
{
  if (!material.is_plastic())
    return {};
  std::vector<double> stresses;
  for (const auto& law : material.laws())
    stresses.push_back(law ? constitutive::initial_yield_stress(*law) : std::numeric_limits<double>::infinity());
  return [stresses, factor = material.yield_factor](std::size_t layer, double depth)
  { return stresses.at(layer) * factor.at(depth, 1.0); };
}

} // namespace

ContactKind contact_kind(const Shape& lower, const Shape& upper, const Domain& domain)
{
  return touch_all_along_y(lower, upper, domain) && !domain.x.is_periodic() ? ContactKind::line : ContactKind::point;
}

std::optional<PairYield> nominal_yield(const Material& lower, const Material& upper, ContactKind kind)
{
  return yield_of_pair(lower, upper, {1.0, 1.0}, kind, 0.0);
}

std::optional<PairYield> earliest_yield(const Material& lower, const Material& upper, ContactKind kind, double friction)
{
  return yield_of_pair(lower, upper, {smallest_yield_factor(lower), smallest_yield_factor(upper)}, kind, friction);
}

std::optional<std::string> reason_against_first_yield(const ShapedBody& lower, const ShapedBody& upper,
                                                      const Domain& domain)
{
  if (!lower.material.is_plastic() && !upper.material.is_plastic())
    return "neither body can yield";
  if (!curvature_of(lower.shape, upper.shape, contact_kind(lower.shape, upper.shape, domain)))
    return "the bodies are neither round where they touch, nor cylinders in plane strain "
           "(`Domain::boundary` = [\"open\", \"periodic\"])";
  if (!nominal_first_yield(lower, upper, domain))
    return fmt::format("`Domain::reference` = {:.4g} m is too short compared with the contact at first yield",
                       reference_distance(lower.shape, upper.shape, domain));
  return std::nullopt;
}

std::optional<FirstYield> nominal_first_yield(const ShapedBody& lower, const ShapedBody& upper, const Domain& domain)
{
  const ContactKind kind = contact_kind(lower.shape, upper.shape, domain);
  return first_yield_of(lower, upper, domain, nominal_yield(lower.material, upper.material, kind));
}

std::optional<FirstYield> earliest_first_yield(const ShapedBody& lower, const ShapedBody& upper, const Domain& domain,
                                               double friction)
{
  const ContactKind kind = contact_kind(lower.shape, upper.shape, domain);
  return first_yield_of(lower, upper, domain, earliest_yield(lower.material, upper.material, kind, friction));
}

std::optional<reference::CoatedYield> coated_yield(const ShapedBody& lower, const ShapedBody& upper,
                                                   const Domain& domain)
{
  const Material &of_lower = lower.material, &of_upper = upper.material;
  const std::optional<double> radius = equivalent_radius(lower.shape, upper.shape);
  if ((of_lower.layers.empty() && of_upper.layers.empty()) || !radius || std::isinf(*radius) ||
      contact_kind(lower.shape, upper.shape, domain) == ContactKind::line ||
      (!of_lower.is_plastic() && !of_upper.is_plastic()))
    return std::nullopt;
  return reference::coated_first_yield(*radius, of_lower.stack(), of_upper.stack(), strength_of(of_lower),
                                       strength_of(of_upper));
}

double smallest_yield_factor(const Material& material)
{
  // A profile is linear between its points and constant beyond them, so that its minimum is at one of the points.
  const constitutive::DepthProfile& profile = material.yield_factor;
  double smallest = profile.depth().empty() ? 1.0 : profile.at(profile.depth().front(), 1.0);
  for (const double z : profile.depth())
    smallest = std::min(smallest, profile.at(z, 1.0));
  return smallest;
}

} // namespace brinell::simulation
