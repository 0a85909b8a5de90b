// SPDX-License-Identifier: BSD-3-Clause
#include "footprint.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/reference/hertz.hpp"
#include "brinell/simulation/first_yield.hpp"
#include "grid_layout.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <numbers>
#include <set>

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

Pair pair_of(const ShapedBody& lower, const ShapedBody& upper, const Domain& domain)
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  Pair pair{contact_modulus(lower.material.elastic, upper.material.elastic), inf, inf, inf};
  if (const std::optional<PairYield> yield =
          earliest_yield(lower.material, upper.material, contact_kind(lower.shape, upper.shape, domain)))
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

/// A cylinder without ends, in plane strain (Johnson 1985, sections 4.2 and 5.6).
/// @param length     of the period, on which the load acts [m]
/// @param reference  of the displacement [m]
Footprint of_line(const Pair& pair, double radius, double length, double reference, const Drive& drive)
{
  const auto half_width = [&](double load) { return std::sqrt(4.0 * load * radius / (pi * length * pair.modulus)); };
  const auto approach = [&](double load)
  { return load / (pi * pair.modulus * length) * (1.0 + 2.0 * std::log(2.0 * reference / half_width(load))); };
  double load = drive.value;
  if (drive.kind == Drive::Kind::approach)
  {
    double low = 0.0;
    double high = pi * pair.modulus * length * reference * reference / (std::exp(2.0) * radius); // there it is largest
    if (!(drive.value < approach(high)))
      throw InputError(fmt::format("an approach of {:.3g} m is more than a cylinder of radius {:.3g} m has with "
                                   "grid.reference = {:.3g} m; allowed: a smaller one, or a larger reference",
                                   drive.value, radius, reference));
    for (int i = 0; i < 100; ++i)
      (approach(0.5 * (low + high)) < drive.value ? low : high) = 0.5 * (low + high);
    load = high;
  }
  const double elastic = half_width(load);
  const double peak = 2.0 * load / (pi * elastic * length);
  const double growth = growth_under_load(pair, peak * pi / 4.0);
  Footprint f;
  f.elastic_x = elastic;
  f.half_x = elastic * growth * growth; // only the width grows
  f.elastic_y = f.half_y = 0.5 * length;
  f.approach = approach(load);
  f.peak_ratio = peak / pair.yield_pressure;
  f.first_yield_approach = approach(load / std::max(1.0, f.peak_ratio * f.peak_ratio));
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

Footprint of_shapes(const Pair& pair, const Shape& lower, const Shape& upper, const Drive& drive, const Domain& domain)
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
  const auto [along_x, along_y] = relative_curvature(lower, upper).value();
  if (along_y == 0.0 && domain.y.is_periodic() && line_length(lower, upper, domain) == domain.y.size)
    return of_line(pair, 1.0 / along_x, domain.y.size, reference_distance(lower, upper, domain), drive);
  return along_y == 0.0 ? of_roller(pair, 1.0 / along_x, roller_length(lower, upper), drive)
                        : of_paraboloids(pair, 1.0 / along_x, 1.0 / along_y, drive);
}

/// A wave that stands for surfaces.
struct Wave
{
  double amplitude, length; ///< [m]
};

/// The wave with the root mean squares of height and slope that both textures together have over a period.
Wave wave_of_both(const ShapedBody& lower, const ShapedBody& upper, const Domain& domain)
{
  constexpr int cells = 128;
  const SurfaceGrid g{
      cells, cells, domain.x.size / cells, domain.y.size / cells, Boundary::periodic, Boundary::periodic};
  std::vector<double> h = cell_depths(lower.texture, g, g.x(0), g.y(0));
  const std::vector<double> other = cell_depths(upper.texture, g, g.x(0), g.y(0));
  std::transform(h.begin(), h.end(), other.begin(), h.begin(), std::plus<>());
  double mean = 0.0;
  for (const double value : h)
    mean += value / static_cast<double>(g.size());
  double squares = 0.0;
  double slopes = 0.0;
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i)
    {
      const double here = h[g.index(i, j)];
      squares += (here - mean) * (here - mean);
      slopes += std::pow((h[g.index((i + 1) % cells, j)] - here) / g.dx, 2) +
                std::pow((h[g.index(i, (j + 1) % cells)] - here) / g.dy, 2);
    }
  if (!(slopes > 0.0))
    throw InputError("the textures are the same everywhere in the period");
  return {std::sqrt(2.0 * squares / static_cast<double>(g.size())), 2.0 * pi * std::sqrt(squares / slopes)};
}

/// Textures of bodies that have no shape, in a period: what the wave that stands for them needs.
Footprint of_flats(const Pair& pair, const ShapedBody& lower, const ShapedBody& upper, const Domain& domain)
{
  const Wave wave = wave_of_both(lower, upper, domain);
  Footprint f;
  f.elastic_x = f.half_x = f.elastic_y = f.half_y = 0.25 * wave.length; // of a summit
  f.approach = wave.amplitude;
  const double slope = 2.0 * pi * wave.amplitude / wave.length;
  f.peak_ratio = 0.5 * pair.modulus * slope / pair.yield_pressure; // where the wave is flattened (Westergaard)
  const double over_yield = std::max(1.0, f.peak_ratio);
  f.first_yield_approach = f.approach / (over_yield * over_yield);
  f.depth = wave.length; // over it exp(-kz) (1 + kz) falls to 1.4 %
  f.over_x = 0.5 * domain.x.size;
  f.over_y = 0.5 * domain.y.size;
  return f;
}

/// Where a part of a texture is on its body, in the middle of what covers the whole plane, and over which length it rises and
/// falls [m].
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

Waviness waviness_of(const Dent& dent)
{
  return {dent.x, dent.radius};
}
Waviness waviness_of(const HeightMap& map)
{
  return {map.periodic ? 0.0 : map.x, wavelength(map)};
}
Waviness waviness_of(const Sinusoid& s) // the stress of crossed waves fades with both wavenumbers
{
  return {0.0, 1.0 / std::hypot(1.0 / s.wavelength_x, 1.0 / s.wavelength_y)};
}
Waviness waviness_of(const RandomSurface& surface)
{
  const double slope = surface.rms_slope();
  return {0.0, slope > 0.0 ? 2.0 * pi * std::numbers::sqrt2 * surface.rms_height() / slope : 0.0};
}

/// Half-lengths that the elastic contact covers with a place x of the textures under its middle, by a solution on a coarse
/// grid. Heights at its points, not means over its cells: roughness bears where it is high.
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
    const std::vector<double> of_lower = depths(lower.texture, grid, x + grid.x(0), grid.y(0)),
                              of_upper = depths(upper.texture, grid, x + grid.x(0), grid.y(0));
    std::vector<double> distance(grid.size());
    for (int j = 0; j < cells; ++j)
      for (int i = 0; i < cells; ++i)
      {
        const double u = grid.x(i);
        const double v = grid.y(j);
        const std::size_t n = grid.index(i, j);
        distance[n] = height(lower.shape, u, v) + height(upper.shape, u, v) + of_lower[n] + of_upper[n];
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
  std::set<double> places;
  for (const ShapedBody* body : {&lower, &upper})
    for (const TexturePart& part : body->texture.parts)
    {
      const Waviness waves = std::visit([](const auto& p) { return waviness_of(p); }, part);
      longest = std::max(longest, waves.length);
      if (!places.insert(waves.x).second)
        continue;
      const auto [x, y] = elastic_cover(lower, upper, drive, pair.modulus, f, waves.x);
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

namespace
{

/// Whether only the textures of the bodies touch.
bool are_flat(const ShapedBody& lower, const ShapedBody& upper)
{
  const auto k = relative_curvature(lower.shape, upper.shape);
  return k && (*k)[0] == 0.0 && (*k)[1] == 0.0;
}

} // namespace

Footprint smooth_footprint(const ShapedBody& lower, const ShapedBody& upper, const Drive& drive, const Domain& domain)
{
  if (const auto reason = reason_against_contact(lower, upper, domain))
    throw InputError("the bodies " + *reason);
  Footprint f = of_shapes(pair_of(lower, upper, domain), lower.shape, upper.shape, drive, domain);
  f.depth = std::max(stressed_depth(f.half_x, f.half_y), 1.3 * f.plastic_reach);
  f.over_x = f.half_x;
  f.over_y = f.half_y;
  return f;
}

Footprint footprint(const ShapedBody& lower, const ShapedBody& upper, const Drive& drive, const Domain& domain)
{
  if (domain.is_periodic() && are_flat(lower, upper) && !are_smooth(lower, upper))
    return of_flats(pair_of(lower, upper, domain), lower, upper, domain);
  Footprint f = smooth_footprint(lower, upper, drive, domain);
  if (!domain.is_periodic())
    add_textures(lower, upper, drive, pair_of(lower, upper, domain), f);
  return f;
}

bool alike(const ShapedBody& lower, const ShapedBody& upper)
{
  return lower.material == upper.material && lower.material.is_plastic() && are_smooth(lower, upper);
}

bool are_smooth(const ShapedBody& lower, const ShapedBody& upper)
{
  return lower.texture.is_smooth() && upper.texture.is_smooth();
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
          numerics.domain, plan);
  // Not so small a change of displacement that the tolerance of the contact hides it.
  plan.scales = {std::clamp(f.first_yield_approach, 1e-2 * f.approach, f.approach), f.approach};
}

} // namespace brinell::simulation
