// SPDX-License-Identifier: BSD-3-Clause
#include "footprint.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/reference/critical.hpp"
#include "brinell/reference/hertz.hpp"
#include "foundation/fft.hpp"

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
  for (const ShapedBody* body : {&lower, &upper})
    if (body->material.is_plastic())
    {
      double softest = 1.0; // over depth
      for (const double z : body->material.yield_factor.depth())
        softest = std::min(softest, body->material.yield_factor.at(z, 1.0));
      const double yield = softest * constitutive::initial_yield_stress(*body->material.hardening);
      const double C = reference::critical_pressure_ratio(body->material.elastic.poisson_ratio);
      pair.yield_pressure = std::min(pair.yield_pressure, C * yield);
      pair.yield_stress = std::min(pair.yield_stress, yield);
      pair.flow_stress =
          std::min(pair.flow_stress,
                   softest * std::visit([](const auto& law) { return law.yield_stress_at(representative_strain); },
                                        *body->material.hardening));
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
  f.half_x = f.half_y = reach * a;
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

/// Real padded planes of all layers [bytes].
double padded_bytes(const VolumeGrid& grid)
{
  return static_cast<double>(fast_length(2 * grid.surface.nx - 1)) * fast_length(2 * grid.surface.ny - 1) * grid.nz *
         sizeof(double);
}

/// Spectra of the stress, and rows without their padding in y.
double spectra_bytes(const VolumeGrid& grid, int components)
{
  return 1.5 * components * padded_bytes(grid);
}

/// Bytes of one body: kernels, state and trial fields; if it is solved, spectra and accelerator too.
double body_bytes(const VolumeGrid& grid, int anderson_depth, bool solved)
{
  const double kernels = 6.0 / 4.0 * padded_bytes(grid); // six, real, a quarter of the plane each
  const double cells = static_cast<double>(grid.size()) * sizeof(double);
  const double fields = cells * (6 * 5 + 4);
  const double active_share = 0.25;
  const double accelerator = cells * active_share * 5 * (2 * anderson_depth + 4);
  return kernels + fields + (solved ? spectra_bytes(grid, 5) + accelerator : 0.0);
}

/// The final state always is a snapshot: tensors of both bodies, and the operators' spectra for one of them at a time.
double snapshot_bytes(const VolumeGrid& lower, const VolumeGrid& upper)
{
  const auto cells = static_cast<double>(lower.size() + upper.size());
  const VolumeGrid& larger = lower.size() > upper.size() ? lower : upper;
  return sizeof(double) * (13.0 * cells + 6.0 * static_cast<double>(larger.size())) + spectra_bytes(larger, 6);
}

/// A copy of the state, as numbers, as a file in memory, and as that file's image.
double checkpoint_bytes(const VolumeGrid& grid, bool solved)
{
  return solved ? 3.0 * 16.0 * sizeof(double) * static_cast<double>(grid.size()) : 0.0;
}

} // namespace

namespace
{

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

Footprint footprint(const ShapedBody& lower, const ShapedBody& upper, const Drive& drive)
{
  const Pair pair = pair_of(lower, upper);
  Footprint f = of_shapes(pair, lower.shape, upper.shape, drive);
  // Under a point contact the largest shear is at 0.48 a, under a line contact at 0.79 a.
  const double narrow = std::min(f.half_x, f.half_y) / std::max(f.half_x, f.half_y);
  f.depth = std::max((2.9 - 1.05 * narrow) * std::min(f.half_x, f.half_y), 1.3 * f.plastic_reach);
  f.over_x = f.half_x;
  f.over_y = f.half_y;
  add_textures(lower, upper, drive, pair, f);
  return f;
}

bool alike(const ShapedBody& lower, const ShapedBody& upper)
{
  return lower.material == upper.material && lower.material.is_plastic() &&
         std::holds_alternative<Smooth>(lower.texture) && std::holds_alternative<Smooth>(upper.texture);
}

std::array<double, 3> cell_sizes(const Numerics& numerics, const Footprint& f)
{
  const double dx = f.half_x / numerics.resolution;
  double dy = dx * std::clamp(f.half_y / f.half_x, 0.25, 4.0);
  if (f.straight_y) // the length is a whole number of cells, one of them in the middle
    dy = 2.0 * f.half_y / (2.0 * std::round(f.half_y / dy - 0.5) + 1.0);
  const std::array<double, 3> spacing = numerics.spacing.value_or(std::array{dx, dy, 0.5 * std::min(dx, dy)});
  if (const double rows = 2.0 * f.half_y / spacing[1];
      f.straight_y && std::abs(std::remainder(rows - 1.0, 2.0)) > 1e-6 * rows)
    throw GridError(
        fmt::format("grid: the cylinder is {:.6g} cells of dy long; allowed: an odd whole number, so that its "
                    "ends are those of cells",
                    rows));
  constexpr double most_cells = 1e5;
  const double finest = *std::min_element(spacing.begin(), spacing.end());
  if (const double a = std::max(f.half_x, f.half_y); !(a / finest < most_cells))
    throw GridError(fmt::format("grid: cells of {:g} m are too small for a contact of {:g} m", finest, a));
  return spacing;
}

int half_cells(double length, double cell)
{
  return std::max(2, static_cast<int>(std::ceil(length / cell - 0.5 - 1e-9)));
}

int step_count(double steps)
{
  constexpr double most = 1e9;
  if (!(steps <= most))
    throw InputError(fmt::format("{:.1e} steps; allowed: up to {:.0e}", steps, most));
  return static_cast<int>(steps);
}

double memory_bytes(const Plan& plan, bool lower_is_plastic, bool upper_is_plastic, int anderson_depth)
{
  const bool upper_is_solved = upper_is_plastic && plan.twin == elastoplastic::Twin::none;
  return body_bytes(plan.lower, anderson_depth, lower_is_plastic) +
         body_bytes(plan.upper, anderson_depth, upper_is_solved) +
         std::max(snapshot_bytes(plan.lower, plan.upper),
                  checkpoint_bytes(plan.lower, lower_is_plastic) + checkpoint_bytes(plan.upper, upper_is_solved));
}

void lay_out(const Numerics& numerics, const Footprint& f, double track_lower, double track_upper, Plan& plan)
{
  const auto [dx, dy, dz] = cell_sizes(numerics, f);
  const double scale = numerics.extent;
  const double width = std::min(f.half_x, f.half_y); // of what surrounds the contact
  const double half_y = scale * std::max(f.over_y + 0.5 * width, 0.3 * width + 0.85 * f.plastic_reach);
  const double reach_x = scale * std::max(f.over_x + 0.5 * width, 0.3 * width + 0.85 * f.plastic_reach);
  constexpr int margin = 4;          // cells: material pushed ahead
  constexpr double most_cells = 2e9; // beyond it indices would overflow; far beyond any machine
  const double cells =
      4.0 * (std::max(track_lower, track_upper) + reach_x) / dx * (half_y / dy) * (scale * f.depth / dz);
  if (!(cells < most_cells))
    throw GridError(
        fmt::format("grid: {:.1e} cells for a contact of {:.3g} x {:.3g} m with a plastic zone of {:.3g} m; "
                    "allowed: fewer than {:.0e}, so larger cells or a shorter track",
                    cells, 2.0 * f.half_x, 2.0 * f.half_y, f.plastic_reach, most_cells));
  plan.contact = {2 * half_cells(scale * 1.6 * f.over_x, dx) + 1, 2 * half_cells(half_y, dy) + 1, dx, dy};
  for (const auto& [grid, track] : {std::pair{&plan.lower, track_lower}, {&plan.upper, track_upper}})
  {
    grid->surface = plan.contact;
    grid->surface.nx = std::max(plan.contact.nx, 2 * (half_cells(track + reach_x, dx) + margin) + 1);
    grid->nz = std::max(2, static_cast<int>(std::ceil(scale * f.depth / dz - 1e-9)));
    grid->dz = dz;
  }
  // Not so small a change of displacement that the tolerance of the contact hides it.
  plan.scales = {std::clamp(f.first_yield_approach, 1e-2 * f.approach, f.approach), f.approach};
}

} // namespace brinell::simulation
