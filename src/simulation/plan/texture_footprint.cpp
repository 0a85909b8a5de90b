// SPDX-License-Identifier: BSD-3-Clause
#include "texture_footprint.hpp"

#include "domain.hpp"
#include "roughness.hpp"
#include "surface_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

namespace brinell::simulation
{

namespace
{

using contact::Drive;

/// Position of a part of a texture on its body (0 if it covers the whole plane), and the length over which it rises and falls
/// [m].
struct Waviness
{
  double x = 0.0, length = 0.0;
};

Waviness waviness_of(const Dent& dent)
{
  return {dent.x, dent.wavelength()};
}
Waviness waviness_of(const HeightMap& map)
{
  const Boundary boundary = map.periodic ? Boundary::periodic : Boundary::open;
  const Roughness roughness = roughness_of(map.heights, {map.nx, map.ny, map.dx, map.dy, boundary, boundary});
  return {map.periodic ? 0.0 : map.x, roughness.wavelength()};
}
Waviness waviness_of(const Sinusoid& s) // crossed waves: root of the sum of squares of both wavenumbers
{
  return {0.0, 1.0 / std::hypot(1.0 / s.wavelength_x, 1.0 / s.wavelength_y)};
}
Waviness waviness_of(const RandomSurface& surface)
{
  return {0.0, Roughness{surface.rms_height(), surface.rms_slope()}.wavelength()};
}

/// One axis of the coarse grid on which the contact of textured bodies is estimated.
struct CoarseAxis
{
  int cells = 0;
  double half = 0.0; ///< half-length [m]; half of the period along a periodic axis
  Boundary boundary = Boundary::open;

  [[nodiscard]] bool is_periodic() const { return boundary == Boundary::periodic; }
  [[nodiscard]] double cell() const { return 2.0 * half / cells; }
};

CoarseAxis coarse_axis(const Domain::Axis& axis, double smooth_half)
{
  constexpr int most = 41;
  if (!axis.is_periodic())
    return {most, 2.5 * smooth_half, Boundary::open};
  return {axis.cells > 0 ? std::min(axis.cells, most) : most, 0.5 * axis.size, Boundary::periodic};
}

/// Numbers of columns and rows from the middle of a grid to the farthest cell under pressure.
std::array<int, 2> cells_reached(const SurfaceGrid& grid, std::span<const double> pressure)
{
  std::array<int, 2> reached{0, 0};
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      if (pressure[grid.index(i, j)] > 0.0)
        reached = {std::max(reached[0], std::abs(i - grid.nx / 2)), std::max(reached[1], std::abs(j - grid.ny / 2))};
  return reached;
}

/// Half-lengths of the elastic contact when the place x of the textures is under its middle, solved on a coarse grid [m]; along a
/// periodic axis half of the period.
std::array<double, 2> elastic_cover(const ShapedBody& lower, const ShapedBody& upper, const Drive& drive,
                                    double modulus, const Domain& domain, const Footprint& smooth, double x)
{
  constexpr double tolerance = 1e-3; // of the approach
  constexpr int iterations = 500;
  const double reference = reference_distance(lower.shape, upper.shape, domain);
  std::array<CoarseAxis, 2> axes{coarse_axis(domain.x, smooth.half_x), coarse_axis(domain.y, smooth.half_y)};
  for (int attempt = 0; attempt < 4; ++attempt)
  {
    const SurfaceGrid grid{axes[0].cells,  axes[1].cells,    axes[0].cell(),
                           axes[1].cell(), axes[0].boundary, axes[1].boundary};
    // Heights at points, because means over cells would hide the peaks that touch.
    const std::vector<double> distance =
        surface_distance(lower, upper, grid, {.x = grid.x(0), .y = grid.y(0), .lower = x, .upper = x}, depths);
    const halfspace::SurfaceCompliance compliance(grid, modulus, reference);
    contact::ElasticContact solver(compliance);
    std::vector<double> pressure(grid.size(), 0.0);
    std::vector<double> gap(grid.size());
    // For an estimate an unconverged solution is sufficient too.
    static_cast<void>(solver.solve(distance, drive, tolerance * smooth.approach, iterations, pressure, gap));
    const std::array<int, 2> reached = cells_reached(grid, pressure);
    bool ends = true;
    std::array<double, 2> half{};
    for (std::size_t i = 0; i < axes.size(); ++i)
    {
      const bool ends_here = axes[i].is_periodic() || reached[i] < axes[i].cells / 2;
      half[i] = axes[i].is_periodic() ? axes[i].half : (reached[i] + 1) * axes[i].cell();
      axes[i].half *= ends_here ? 1.0 : 1.6;
      ends = ends && ends_here;
    }
    if (ends)
      return half;
  }
  return {axes[0].half, axes[1].half};
}

} // namespace

void add_textures(const ShapedBody& lower, const ShapedBody& upper, const Drive& drive, double modulus,
                  const Domain& domain, Footprint& f)
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
      const auto [x, y] = elastic_cover(lower, upper, drive, modulus, domain, f, waves.x);
      f.over_x = std::max(f.over_x, x);
      f.over_y = f.straight_y ? f.over_y : std::max(f.over_y, y);
    }
  if (longest > 0.0 && f.peak_ratio < clearly_elastic)
    f.depth = std::min(f.depth, longest);
}

namespace
{

/// Estimated share of the period in contact under a mean pressure: sum of the share of elastic roughness in light contact (Bush,
/// Gibson, Thomas 1975) and that of fully plastic peaks at their hardness.
double contact_share(double pressure, double modulus, double slope, double yield_pressure)
{
  constexpr double hardness = 1.75; // ratio to the peak pressure at first yield, 2.8/1.6
  const double elastic = std::sqrt(2.0 * std::numbers::pi) * pressure / (modulus * slope);
  return std::min(1.0, elastic + pressure / (hardness * yield_pressure));
}

} // namespace

Footprint of_flats(const ShapedBody& lower, const ShapedBody& upper, double modulus, double yield_pressure,
                   const Drive& drive, const Domain& domain)
{
  constexpr double rounding = 1e-9;
  const SurfaceGrid grid = sampled_period(domain);
  if (std::min(grid.nx, grid.ny) > 1 && grid.nx == domain.x.cells &&
      grid.ny == domain.y.cells) // the cells are those of the run
    require_heights_on_cells(lower, upper, domain, grid);
  std::vector<double> h = sampled_depths(lower.texture, grid);
  const std::vector<double> other = sampled_depths(upper.texture, grid);
  const double apart = roughness_of(h, grid).height + roughness_of(other, grid).height;
  std::transform(h.begin(), h.end(), other.begin(), h.begin(), std::plus<>());
  const Roughness together = roughness_of(h, grid);
  if (!(together.height > rounding * apart))
    throw PlanError::at(
        member_of("upper", "texture"),
        "{} and {} cancel: on the cells of the grid the distance of the bodies is the same everywhere in "
        "the period; allowed: textures that differ, with waves that the cells resolve",
        member_of("lower", "texture"), member_of("upper", "texture"));
  const double length = together.wavelength();
  const double slope = std::numbers::sqrt2 * together.slope; // largest slope of a wave with the same rms values
  Footprint f;
  f.elastic_x = f.half_x = f.elastic_y = f.half_y = 0.25 * length; // half-width of a summit
  f.approach = std::numbers::sqrt2 * together.height;
  f.peak_ratio = 0.5 * modulus * slope / yield_pressure; // for a completely flattened wave (Westergaard)
  const double over_yield = std::max(1.0, f.peak_ratio);
  f.first_yield_approach = f.approach / (over_yield * over_yield);
  f.depth = length; // over it exp(-kz) (1 + kz) falls to 1.4 %
  f.over_x = 0.5 * domain.x.size;
  f.over_y = 0.5 * domain.y.size;
  if (drive.kind == Drive::Kind::load)
    f.contact_share =
        contact_share(drive.value / (domain.x.size * domain.y.size), modulus, together.slope, yield_pressure);
  return f;
}

} // namespace brinell::simulation
