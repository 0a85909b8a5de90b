// SPDX-License-Identifier: BSD-3-Clause
#include "footprint.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/reference/hertz.hpp"
#include "brinell/simulation/first_yield.hpp"
#include "grid_layout.hpp"

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
/// Strain at which a contact's mean pressure reads the flow stress.
constexpr double representative_strain = 0.02;

/// What both bodies together are made of.
struct Pair
{
  double modulus;        ///< E' [Pa]
  double yield_pressure; ///< peak pressure at first yield [Pa]; infinite
  double yield_stress;   ///< of the weaker body [Pa]
  double flow_stress;    ///< at the representative strain [Pa]
};

Pair pair_of(const ShapedBody& lower, const ShapedBody& upper)
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  Pair pair{contact_modulus(lower.material.elastic, upper.material.elastic), inf, inf, inf};
  if (const std::optional<PairYield> yield = earliest_yield(lower.material, upper.material))
    pair.yield_pressure = yield->peak_pressure();
  for (const ShapedBody* body : {&lower, &upper})
    if (body->material.is_plastic())
    {
      const double softest = smallest_yield_factor(body->material);
      const auto stress_at = [&](double strain)
      {
        return softest *
               std::visit([&](const auto& law) { return law.yield_stress_at(strain); }, *body->material.hardening);
      };
      pair.yield_stress =
          std::min(pair.yield_stress, softest * constitutive::initial_yield_stress(*body->material.hardening));
      pair.flow_stress = std::min(pair.flow_stress, stress_at(representative_strain));
    }
  return pair;
}

/// Radius over that of the elastic contact, by the mean pressure that this would have (load imposed).
double growth_under_load(const Pair& pair, double elastic_mean_pressure)
{
  const double share = elastic_mean_pressure / (constraint_factor * pair.flow_stress);
  return std::pow(1.0 + share * share, 0.25);
}

/// The same for an imposed approach (area of Jackson and Green 2005 for steels).
double growth_under_approach(const Pair& pair, double elastic_peak_pressure)
{
  const double ratio = std::pow(elastic_peak_pressure / pair.yield_pressure, 2) / 1.9;
  return std::min(1.6, std::pow(std::max(1.0, ratio), 0.085));
}

/// Radius of the plastic zone (expanding cavity, Johnson 1985, Eq. 6.33) around a contact of radius a at the slope
/// `inclination` of the surfaces at its edge.
double plastic_reach(const Pair& pair, double a, double inclination)
{
  const double constraint = pair.modulus * inclination / (5.0 * pair.yield_stress);
  return a * std::cbrt(std::max(1.0, constraint));
}

Footprint of_paraboloids(const Pair& pair, double radius_x, double radius_y, const Drive& drive)
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
  f.peak_ratio = e.peak_pressure / pair.yield_pressure;
  const double over_yield = std::max(1.0, f.peak_ratio);
  f.first_yield_approach = e.approach / (over_yield * over_yield); // peak pressure grows as the root of the approach
  const double a = std::min(f.half_x, f.half_y);
  f.plastic_reach = plastic_reach(pair, a, a / std::min(radius_x, radius_y));
  return f;
}

/// A cylinder of finite length; its approach grows with the logarithm of length over width.
Footprint of_roller(const Pair& pair, double radius, double length, const Drive& drive)
{
  const auto half_width = [&](double load) { return std::sqrt(4.0 * load * radius / (pi * length * pair.modulus)); };
  const auto approach = [&](double load)
  { return load / (pi * pair.modulus * length) * (1.0 + std::log(1.0 + std::pow(length / half_width(load), 2))); };
  double load = drive.value;
  if (drive.kind == Drive::Kind::approach)
  {
    double low = 0.0;
    double high = pi * pair.modulus * length * drive.value;
    for (int i = 0; i < 100; ++i)
      (approach(0.5 * (low + high)) < drive.value ? low : high) = 0.5 * (low + high);
    load = high;
  }
  const double elastic = half_width(load);
  const double peak = 2.0 * load / (pi * elastic * length);
  const double growth = growth_under_load(pair, peak * pi / 4.0);
  Footprint f;
  f.elastic_x = elastic;
  f.elastic_y = 0.5 * length;
  f.half_x = elastic * growth * growth; // only the width grows
  if (drive.kind == Drive::Kind::approach)
    f.half_x = std::min(f.half_x, 1.2 * std::sqrt(2.0 * radius * drive.value)); // geometry, with some pile-up
  f.straight_y = true;
  f.half_y = 0.5 * length;
  f.approach = approach(load);
  f.peak_ratio = peak / (1.1 * pair.yield_pressure);
  f.first_yield_approach = f.approach / std::max(1.0, f.peak_ratio * f.peak_ratio);
  f.plastic_reach = plastic_reach(pair, f.half_x, f.half_x / radius);
  return f;
}

/// A cone or a pyramid of that slope, or the ball at its tip, whichever makes the larger contact.
/// @param reach  half-width of the contact over the radius of the circle with its area.
Footprint of_tip(const Pair& pair, double slope, double tip_radius, double reach, const Drive& drive)
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
  f.peak_ratio = std::numeric_limits<double>::infinity();
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

Footprint of_shapes(const Pair& pair, const Shape& lower, const Shape& upper, const Drive& drive)
{
  for (const Shape* shape : {&lower, &upper}) // beside a tip the other surface is flat
  {
    if (const auto* cone = std::get_if<Cone>(shape))
      return of_tip(pair, 1.0 / std::tan(cone->half_angle), cone->tip_radius, 1.0, drive);
    if (const auto* pyramid = std::get_if<Pyramid>(shape))
    {
      const double n = pyramid->faces;
      const double corner = std::sqrt(pi / (0.5 * n * std::sin(2.0 * pi / n)));      // of the polygon with the area pi
      const double reach = pyramid->faces == 4 ? corner * std::cos(pi / n) : corner; // four faces look along x and y
      return of_tip(pair, 1.0 / std::tan(pyramid->face_angle), pyramid->tip_radius, reach, drive);
    }
  }
  if (!contact_is_finite(lower, upper))
    throw InputError("the bodies touch neither in a point nor in a line of finite length");
  const auto [along_x, along_y] = relative_curvature(lower, upper).value();
  return along_y == 0.0 ? of_roller(pair, 1.0 / along_x, roller_length(lower, upper), drive)
                        : of_paraboloids(pair, 1.0 / along_x, 1.0 / along_y, drive);
}

/// Where a texture is on its body, and over which length it rises and falls [m]; none if the body is smooth.
struct Waviness
{
  double x = 0.0, length = 0.0;
};

/// 2 pi times the ratio of the root mean squares of height and slope: the wavelength of a sinusoid.
double wavelength(const HeightMap& map)
{
  double mean = 0.0;
  for (const double h : map.heights)
    mean += h / static_cast<double>(map.heights.size());
  double squares = 0.0;
  double slopes = 0.0;
  for (int j = 0; j < map.ny; ++j)
    for (int i = 0; i < map.nx; ++i)
    {
      const double* h = map.heights.data() + i + static_cast<std::ptrdiff_t>(map.nx) * j;
      squares += (*h - mean) * (*h - mean);
      slopes += i + 1 < map.nx ? std::pow((h[1] - h[0]) / map.dx, 2) : 0.0;
      slopes += j + 1 < map.ny ? std::pow((h[map.nx] - h[0]) / map.dy, 2) : 0.0;
    }
  return slopes > 0.0 ? 2.0 * pi * std::sqrt(2.0 * squares / slopes) : 0.0;
}

std::optional<Waviness> waviness(const Texture& texture)
{
  if (const auto* dent = std::get_if<Dent>(&texture))
    return Waviness{dent->x, dent->radius};
  if (const auto* map = std::get_if<HeightMap>(&texture))
    return Waviness{map->x, wavelength(*map)};
  return std::nullopt;
}

/// Half-lengths that the elastic contact covers with a texture's middle under its own, by a solution on a coarse grid.
std::array<double, 2> elastic_cover(const ShapedBody& lower, const ShapedBody& upper, const Drive& drive,
                                    double modulus, const Footprint& smooth, double x)
{
  constexpr int cells = 41;
  constexpr double tolerance = 1e-3; // of the approach
  constexpr int iterations = 500;
  std::array<double, 2> half{2.5 * smooth.half_x, 2.5 * smooth.half_y};
  for (int attempt = 0; attempt < 4; ++attempt)
  {
    const SurfaceGrid grid{cells, cells, 2.0 * half[0] / cells, 2.0 * half[1] / cells};
    std::vector<double> distance(grid.size());
    for (int j = 0; j < cells; ++j)
      for (int i = 0; i < cells; ++i)
      {
        const double u = (i - 0.5 * (cells - 1)) * grid.dx;
        const double v = (j - 0.5 * (cells - 1)) * grid.dy;
        distance[static_cast<std::size_t>(i + cells * j)] = height(lower.shape, u, v) + height(upper.shape, u, v) +
                                                            depth(lower.texture, x + u, v) +
                                                            depth(upper.texture, x + u, v);
      }
    const halfspace::SurfaceCompliance compliance(grid, modulus);
    contact::ElasticContact solver(compliance);
    std::vector<double> pressure(grid.size(), 0.0);
    std::vector<double> gap(grid.size());
    // An estimate: what has not converged by then still shows where the contact is.
    static_cast<void>(solver.solve(distance, drive, tolerance * smooth.approach, iterations, pressure, gap));
    int reach_x = 0;
    int reach_y = 0;
    for (int j = 0; j < cells; ++j)
      for (int i = 0; i < cells; ++i)
        if (pressure[static_cast<std::size_t>(i + cells * j)] > 0.0)
        {
          reach_x = std::max(reach_x, std::abs(i - cells / 2));
          reach_y = std::max(reach_y, std::abs(j - cells / 2));
        }
    if (reach_x < cells / 2 && reach_y < cells / 2)
      return {(reach_x + 1) * grid.dx, (reach_y + 1) * grid.dy};
    half = {reach_x < cells / 2 ? half[0] : 1.6 * half[0], reach_y < cells / 2 ? half[1] : 1.6 * half[1]};
  }
  return half;
}

/// Widens the footprint to what textures touch. Where the smooth bodies would stay elastic it need only be as deep as the
/// stress of the texture goes: a wavelength, over which exp(-kz) (1 + kz) falls to 1.4 %.
void add_textures(const ShapedBody& lower, const ShapedBody& upper, const Drive& drive, const Pair& pair, Footprint& f)
{
  constexpr double clearly_elastic = 0.7; // of the pressure at first yield
  double longest = 0.0;
  for (const ShapedBody* body : {&lower, &upper})
    if (const std::optional<Waviness> texture = waviness(body->texture))
    {
      longest = std::max(longest, texture->length);
      const auto [x, y] = elastic_cover(lower, upper, drive, pair.modulus, f, texture->x);
      f.over_x = std::max(f.over_x, x);
      f.over_y = f.straight_y ? f.over_y : std::max(f.over_y, y);
    }
  if (longest > 0.0 && f.peak_ratio < clearly_elastic)
    f.depth = std::min(f.depth, longest);
}

} // namespace

double stressed_depth(double half_x, double half_y)
{
  const double narrow = std::min(half_x, half_y) / std::max(half_x, half_y);
  return (2.9 - 1.05 * narrow) * std::min(half_x, half_y);
}

Footprint smooth_footprint(const ShapedBody& lower, const ShapedBody& upper, const Drive& drive)
{
  Footprint f = of_shapes(pair_of(lower, upper), lower.shape, upper.shape, drive);
  f.depth = std::max(stressed_depth(f.half_x, f.half_y), 1.3 * f.plastic_reach);
  f.over_x = f.half_x;
  f.over_y = f.half_y;
  return f;
}

Footprint footprint(const ShapedBody& lower, const ShapedBody& upper, const Drive& drive)
{
  Footprint f = smooth_footprint(lower, upper, drive);
  add_textures(lower, upper, drive, pair_of(lower, upper), f);
  return f;
}

bool alike(const ShapedBody& lower, const ShapedBody& upper)
{
  return lower.material == upper.material && lower.material.is_plastic() && are_smooth(lower, upper);
}

bool are_smooth(const ShapedBody& lower, const ShapedBody& upper)
{
  return std::holds_alternative<Smooth>(lower.texture) && std::holds_alternative<Smooth>(upper.texture);
}

void lay_out(const Numerics& numerics, const Footprint& f, double track_lower, double track_upper, Plan& plan)
{
  const double scale = numerics.extent;
  const double width = std::min(f.half_x, f.half_y); // of what surrounds the contact
  const double plastic = 0.3 * width + 0.85 * f.plastic_reach;
  const double reach_x = std::max(f.over_x + 0.5 * width, plastic);
  const double reach_y = std::max(f.over_y + 0.5 * width, plastic);
  lay_out(cell_sizes(numerics, {f.half_x, f.half_y, f.straight_y}, 1.0),
          {scale * 1.6 * f.over_x, scale * reach_y, track_lower + scale * reach_x, track_upper + scale * reach_x,
           scale * f.depth},
          plan);
  // Not so small a change of displacement that the tolerance of the contact hides it.
  plan.scales = {std::clamp(f.first_yield_approach, 1e-2 * f.approach, f.approach), f.approach};
}

} // namespace brinell::simulation
