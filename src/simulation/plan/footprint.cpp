// SPDX-License-Identifier: BSD-3-Clause
#include "footprint.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/reference/hertz.hpp"
#include "brinell/simulation/first_yield.hpp"
#include "domain.hpp"
#include "embedding.hpp"
#include "grid_layout.hpp"
#include "texture_footprint.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace brinell::simulation
{

namespace
{

using contact::Drive;

constexpr double pi = std::numbers::pi;

/// Mean pressure of a fully plastic contact over the flow stress (Tabor 1951).
constexpr double constraint_factor = 2.8;
/// Representative strain at which the flow stress determines the mean pressure of a contact.
constexpr double representative_strain = 0.02;

/// Combined material properties of both bodies.
struct Combined
{
  double modulus;        ///< E' [Pa]
  double yield_pressure; ///< peak pressure at first yield [Pa]; infinite if nothing yields
  double yield_stress;   ///< of the weaker body [Pa]
  double flow_stress;    ///< at the representative strain [Pa]
};

Combined pair_of(const ShapedBody& lower, const ShapedBody& upper, const Domain& domain, double friction)
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  Combined pair{contact_modulus(lower.material.softest(), upper.material.softest()), inf, inf, inf};
  if (const std::optional<PairYield> yield = earliest_yield(
          lower.material, upper.material,
          touch_all_along_y(lower.shape, upper.shape, domain) ? ContactKind::line : ContactKind::point, friction))
    pair.yield_pressure = yield->peak_pressure();
  for (const ShapedBody* body : {&lower, &upper})
    if (body->material.is_plastic())
    {
      const double softest = smallest_yield_factor(body->material);
      const auto stress_at = [&](double strain) {
        return softest * std::visit([&](const auto& law) { return law.yield_stress_at(strain); }, body->material.law());
      };
      pair.yield_stress =
          std::min(pair.yield_stress, softest * constitutive::initial_yield_stress(body->material.law()));
      pair.flow_stress = std::min(pair.flow_stress, stress_at(representative_strain));
    }
  return pair;
}

/// Ratio of the contact radius to that of the elastic contact, from the mean pressure of the elastic contact, for an imposed
/// load.
double growth_under_load(const Combined& pair, double elastic_mean_pressure)
{
  const double share = elastic_mean_pressure / (constraint_factor * pair.flow_stress);
  return std::pow(1.0 + share * share, 0.25);
}

/// Ratio of the contact radius to that of the elastic contact, for an imposed approach (area by Jackson and Green 2005, for
/// steels).
double growth_under_approach(const Combined& pair, double elastic_peak_pressure)
{
  const double ratio = std::pow(elastic_peak_pressure / pair.yield_pressure, 2) / 1.9;
  return std::min(1.6, std::pow(std::max(1.0, ratio), 0.085));
}

/// Radius of the plastic zone (expanding cavity, Johnson 1985, Eq. 6.33) around a contact of radius a at the slope
/// `inclination` of the surfaces at its edge.
double plastic_reach(const Combined& pair, double a, double inclination)
{
  const double constraint = pair.modulus * inclination / (5.0 * pair.yield_stress);
  return a * std::cbrt(std::max(1.0, constraint));
}

Footprint of_paraboloids(const Combined& pair, double radius_x, double radius_y, const Drive& drive)
{
  const bool by_load = drive.kind == Drive::Kind::load;
  const reference::EllipticalContact e =
      by_load ? reference::elliptical_contact_at_load(radius_x, radius_y, pair.modulus, drive.value)
              : reference::elliptical_contact_at_approach(radius_x, radius_y, pair.modulus, drive.value);
  const double growth =
      by_load ? growth_under_load(pair, e.peak_pressure / 1.5) : growth_under_approach(pair, e.peak_pressure);
  Footprint f;
  f.elastic_x = e.semi_axis_x;
  f.elastic_y = e.semi_axis_y;
  f.half_x = e.semi_axis_x * growth;
  f.half_y = e.semi_axis_y * growth;
  f.approach = e.approach;
  f.elastic_load = e.load;
  f.peak_pressure = e.peak_pressure;
  f.peak_ratio = e.peak_pressure / pair.yield_pressure;
  const double over_yield = std::max(1.0, f.peak_ratio);
  f.first_yield_approach =
      e.approach / (over_yield * over_yield); // peak pressure is proportional to the root of the approach
  const double a = std::min(f.half_x, f.half_y);
  f.plastic_reach = plastic_reach(pair, a, a / std::min(radius_x, radius_y));
  return f;
}

/// Parameters of a line contact.
struct LineContact
{
  double radius = 0.0, length = 0.0; ///< equivalent radius, and length over which the load acts [m]
  double widest = 0.0;               ///< largest half-width for which the approach still grows with the half-width [m]
  double yield_pressure = 0.0;       ///< peak pressure at first yield [Pa]
};

/// Half-width of an elastic line contact with a given approach [m]; `widest` if the approach cannot be reached.
/// @param approach  function of the half-width b [m]: b^2/(4 R) times a factor >= 1.
template <typename Approach>
double half_width_at(double wanted, const LineContact& line, const Approach& approach)
{
  double low = 0.0;
  double high = std::min(line.widest, 2.0 * std::sqrt(line.radius * wanted));
  for (int i = 0; i < 100; ++i)
    (approach(0.5 * (low + high)) < wanted ? low : high) = 0.5 * (low + high);
  return high;
}

/// Bodies that touch in a line along y. The load of an elastic contact of half-width b is pi E' L b^2/(4 R) (Johnson 1985,
/// section 4.2); the approach contains a logarithm that depends on the ends of the line, or on the boundary conditions beside it.
template <typename Approach>
Footprint of_line(const Combined& pair, const LineContact& line, const Drive& drive, const Approach& approach)
{
  const bool by_load = drive.kind == Drive::Kind::load;
  const double R = line.radius;
  const double elastic = by_load ? std::sqrt(4.0 * drive.value * R / (pi * line.length * pair.modulus))
                                 : half_width_at(drive.value, line, approach);
  const double peak = 0.5 * pair.modulus * elastic / R;
  const double growth = growth_under_load(pair, peak * pi / 4.0);
  Footprint f;
  f.elastic_x = elastic;
  f.half_x = elastic * growth * growth; // squared, because the area grows only in width
  if (!by_load)
    f.half_x = std::min(f.half_x, 1.2 * std::sqrt(2.0 * R * drive.value)); // geometry, with some pile-up
  f.elastic_y = f.half_y = 0.5 * line.length;
  f.approach = approach(std::min(elastic, line.widest));
  f.peak_pressure = peak;
  f.peak_ratio = peak / line.yield_pressure;
  f.first_yield_approach = approach(std::min(elastic, line.widest) / std::max(1.0, f.peak_ratio));
  f.plastic_reach = plastic_reach(pair, f.half_x, f.half_x / R);
  return f;
}

/// A cylinder of finite length; its approach grows with the logarithm of length over width.
Footprint of_roller(const Combined& pair, double radius, double length, const Drive& drive)
{
  const auto approach = [&](double b)
  { return b * b / (4.0 * radius) * (1.0 + std::log(1.0 + std::pow(length / b, 2))); };
  const double yield_pressure = 1.1 * pair.yield_pressure; // about 1.1 times that of a point contact
  Footprint f =
      of_line(pair, {radius, length, std::numeric_limits<double>::infinity(), yield_pressure}, drive, approach);
  f.straight_y = true;
  return f;
}

/// An infinite cylinder in plane strain (Johnson 1985, sections 4.2 and 5.6). With zero displacement at the distance l the
/// approach is b^2/(4 R) (1 + 2 ln(2 l/b)). It grows up to b = 2 l, where its derivative by b, b/R ln(2 l/b), vanishes: a strip
/// of that width, whose logarithmic capacity is b/2 = l, has no stiffness left.
Footprint of_endless_line(const Combined& pair, double radius, const Shape& lower, const Shape& upper,
                          const Drive& drive, const Domain& domain)
{
  // Lines in a period L along x have -ln(2 sin(pi x/L)) instead of -ln(x/l), which is the same for small x.
  const double reference =
      domain.x.is_periodic() ? domain.x.size / (2.0 * pi) : reference_distance(lower, upper, domain);
  const auto approach = [&](double b) { return b * b / (4.0 * radius) * (1.0 + 2.0 * std::log(2.0 * reference / b)); };
  if (const double most = approach(reference);
      !domain.x.is_periodic() && drive.kind == Drive::Kind::approach && !(drive.value <= most))
    throw PlanError("`Domain::reference` = {:.4g} m: with it a cylinder of radius {:.4g} m approaches by {:.4g} m "
                    "while the half-width of the contact grows up to that reference, and is to approach by "
                    "{:.4g} m; allowed: a smaller approach, or a larger reference",
                    reference, radius, most, drive.value);
  Footprint f = of_line(pair, {radius, domain.y.size, 2.0 * reference, pair.yield_pressure}, drive, approach);
  f.endless_y = true;
  return f;
}

/// A cone or a pyramid with a given slope, or the ball at its tip, whichever has the larger contact.
/// @param reach  ratio of the contact's half-width to the radius of the circle with the same area.
Footprint of_tip(const Combined& pair, double slope, double tip_radius, double reach, const Drive& drive)
{
  const double elastic_mean = 0.5 * pair.modulus * slope; // Sneddon
  const double share = elastic_mean / (constraint_factor * pair.flow_stress);
  const double mean_pressure = elastic_mean / std::sqrt(1.0 + share * share);
  constexpr double sunk_in = 2.0 / pi; // contact radius times slope over approach: elastic, and fully plastic
  constexpr double piled_up = 1.15;
  const double plastic = std::isfinite(share) ? share / std::sqrt(1.0 + share * share) : 1.0;
  double a = drive.kind == Drive::Kind::load ? std::sqrt(drive.value / (pi * mean_pressure))
                                             : (sunk_in + (piled_up - sunk_in) * plastic) * drive.value / slope;
  Footprint f;
  f.approach = drive.kind == Drive::Kind::load ? 0.5 * pi * a * slope : drive.value;
  f.first_yield_approach = 0.0;
  f.peak_pressure = f.peak_ratio = std::numeric_limits<double>::infinity();
  if (tip_radius > 0.0)
  {
    const Footprint ball = of_paraboloids(pair, tip_radius, tip_radius, drive);
    a = std::max(a, ball.half_x);
    f.approach = std::max(f.approach, ball.approach);
    f.first_yield_approach = ball.first_yield_approach;
  }
  f.half_x = f.half_y = f.elastic_x = f.elastic_y = reach * a;
  f.plastic_reach = plastic_reach(pair, a, slope);
  return f;
}

Footprint of_shapes(const Combined& pair, const Shape& lower, const Shape& upper, const Drive& drive,
                    const Domain& domain)
{
  for (const Shape* shape : {&lower, &upper}) // opposite to a tip the other surface counts as flat
  {
    if (const auto* cone = std::get_if<Cone>(shape))
      return of_tip(pair, 1.0 / std::tan(cone->half_angle), cone->tip_radius, 1.0, drive);
    if (const auto* pyramid = std::get_if<Pyramid>(shape))
    {
      const double n = pyramid->faces;
      const double corner =
          std::sqrt(pi / (0.5 * n * std::sin(2.0 * pi / n))); // distance of the corners of a polygon with the area pi
      const double reach = pyramid->faces == 4 ? corner * std::cos(pi / n) : corner; // four faces point along x and y
      return of_tip(pair, 1.0 / std::tan(pyramid->face_angle), pyramid->tip_radius, reach, drive);
    }
  }
  const auto [along_x, along_y] = relative_curvature(lower, upper).value();
  if (touch_all_along_y(lower, upper, domain))
    return of_endless_line(pair, 1.0 / along_x, lower, upper, drive, domain);
  return along_y == 0.0 ? of_roller(pair, 1.0 / along_x, roller_length(lower, upper), drive)
                        : of_paraboloids(pair, 1.0 / along_x, 1.0 / along_y, drive);
}

} // namespace

double stressed_depth(double half_x, double half_y)
{
  const double narrow = std::min(half_x, half_y) / std::max(half_x, half_y);
  return (2.9 - 1.05 * narrow) * std::min(half_x, half_y);
}

namespace
{

/// Limits a half-length to the radius of curvature, beyond which neither half space nor paraboloid is valid.
void require_within_radius(const Footprint& f, const Shape& lower, const Shape& upper)
{
  const auto curvature = relative_curvature(lower, upper);
  for (const auto& [half, axis] : {std::pair{f.half_x, 0}, std::pair{f.half_y, 1}})
    if (curvature && half * (*curvature)[static_cast<std::size_t>(axis)] > 1.0)
      throw InputError(fmt::format("the contact would reach {:.3g} m from its middle along {}, more than the radius of "
                                   "curvature there, {:.3g} m; allowed: a smaller load or approach, or larger bodies",
                                   half, axis == 0 ? "x" : "y", 1.0 / (*curvature)[static_cast<std::size_t>(axis)]));
}

} // namespace

void require_within_reference(double half_x, double half_y, const ShapedBody& lower, const ShapedBody& upper,
                              const Domain& domain)
{
  const double reference = reference_distance(lower.shape, upper.shape, domain);
  const double half = domain.y.is_periodic() ? half_x : half_y;
  if (reference > 0.0 && half > reference)
    throw PlanError("`Domain::reference` = {:.4g} m{} is less than the half-width of the contact, about {:.4g} m, "
                    "and at twice that distance the approach no longer grows with the load; allowed: a "
                    "reference of at least that half-width",
                    reference, domain.reference > 0.0 ? "" : ", the default,", half);
}

namespace
{

/// @param pair  properties of these bodies with this friction, passed because computing them takes a search
Footprint smooth_footprint_of(const Combined& pair, const ShapedBody& lower, const ShapedBody& upper,
                              const Drive& drive, const Domain& domain, double friction)
{
  for (const ShapedBody* body : {&lower, &upper})
    if (const auto* p = std::get_if<Paraboloid>(&body->shape); p && (p->radius_x == 0.0 || p->radius_y == 0.0))
      throw InputError("a paraboloid of radius 0; allowed: any other");
  if (!std::isfinite(drive.value))
    throw InputError(fmt::format("a contact under {:g}; allowed: a finite load or approach", drive.value));
  if (const auto reason = reason_against_contact(lower, upper, domain))
    throw InputError("the bodies " + *reason);
  Footprint f = of_shapes(pair, lower.shape, upper.shape, drive, domain);
  require_within_radius(f, lower.shape, upper.shape);
  require_within_reference(f.half_x, f.half_y, lower, upper, domain);
  const double half_y = f.endless_y ? std::numeric_limits<double>::infinity() : f.half_y;
  f.depth = std::max(stressed_depth(f.half_x, half_y), 1.3 * f.plastic_reach);
  f.over_x = f.half_x;
  f.over_y = f.half_y;
  f.frictionless_yield_approach =
      friction > 0.0 ? smooth_footprint(lower, upper, drive, domain).first_yield_approach : f.first_yield_approach;
  if (domain.x.is_periodic() || domain.y.is_periodic()) // neighbouring contacts contribute to the approach
    f.elastic_load = std::numeric_limits<double>::infinity();
  return f;
}

} // namespace

Footprint smooth_footprint(const ShapedBody& lower, const ShapedBody& upper, const Drive& drive, const Domain& domain,
                           double friction)
{
  return smooth_footprint_of(pair_of(lower, upper, domain, friction), lower, upper, drive, domain, friction);
}

Footprint footprint(const ShapedBody& lower, const ShapedBody& upper, const Drive& drive, const Domain& domain,
                    double friction)
{
  if (drive.kind == Drive::Kind::load)
    require_finite_depth(lower, upper, drive.value, domain);
  const Combined pair = pair_of(lower, upper, domain, friction);
  if (domain.is_periodic() && are_flat(lower, upper) && !are_smooth(lower, upper))
  {
    Footprint f = of_flats(lower, upper, pair.modulus, pair.yield_pressure, drive, domain);
    f.frictionless_yield_approach =
        friction > 0.0 ? footprint(lower, upper, drive, domain).first_yield_approach : f.first_yield_approach;
    f.depth = depth_with_inclusions(lower, upper, f.depth);
    return f;
  }
  Footprint f = smooth_footprint_of(pair, lower, upper, drive, domain, friction);
  f.depth = depth_with_inclusions(lower, upper, f.depth);
  if (!domain.is_periodic())
  {
    add_textures(lower, upper, drive, pair.modulus, domain, f);
    require_within_reference(f.over_x, f.over_y, lower, upper, domain);
  }
  return f;
}

bool alike(const ShapedBody& lower, const ShapedBody& upper)
{
  return lower.material == upper.material && lower.material.is_plastic() && are_smooth(lower, upper) &&
         lower.film.is_smooth() && upper.film.is_smooth() && lower.inclusions.empty() && upper.inclusions.empty();
}

bool are_flat(const ShapedBody& lower, const ShapedBody& upper)
{
  const auto k = relative_curvature(lower.shape, upper.shape);
  return k && (*k)[0] == 0.0 && (*k)[1] == 0.0;
}

bool are_smooth(const ShapedBody& lower, const ShapedBody& upper)
{
  return lower.texture.is_smooth() && upper.texture.is_smooth();
}

bool needs_surfaces_only(const PairCase& c)
{
  return !c.fields_within && !c.lower.material.is_plastic() && !c.upper.material.is_plastic() && !c.lower.fatigue &&
         !c.upper.fatigue;
}

void lay_out(const PairCase& pair, const Footprint& f, double track_lower, double track_upper, Plan& plan)
{
  lay_out(pair, cell_sizes(pair, {f.half_x, f.half_y, f.straight_y}, 1.0), f, track_lower, track_upper, plan);
}

void lay_out(const Numerics& numerics, const std::array<double, 3>& cells, const Footprint& f, double track_lower,
             double track_upper, Plan& plan)
{
  const double scale = numerics.extent;
  const double width = f.endless_y ? f.half_x : std::min(f.half_x, f.half_y); // half-width that determines the depth
  const double plastic = 0.3 * width + 0.85 * f.plastic_reach;
  const double reach_x = std::max(f.over_x + 0.5 * width, plastic);
  const double reach_y = std::max(f.over_y + 0.5 * width, plastic);
  Extents extents{scale * 1.6 * f.over_x, scale * reach_y, track_lower + scale * reach_x, track_upper + scale * reach_x,
                  scale * f.depth};
  cover(numerics.heat.source, extents);
  lay_out(cells, extents, numerics.domain, plan);
  plan.contact_share = f.contact_share;
  // Lower limit: smaller changes of displacement would be lost in the tolerance of the contact.
  const auto resolved = [&](double approach) { return std::clamp(approach, 1e-2 * f.approach, f.approach); };
  plan.scales = {resolved(f.frictionless_yield_approach), f.approach};
  plan.first_yield = resolved(f.first_yield_approach);
  plan.peak_pressure = f.peak_pressure;
  plan.peak_over_yield = f.peak_ratio;
}

} // namespace brinell::simulation
