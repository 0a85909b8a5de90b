// SPDX-License-Identifier: BSD-3-Clause
#include "domain.hpp"

#include "footprint.hpp"
#include "roughness.hpp"
#include "surface_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <numeric>

namespace brinell::simulation
{

namespace
{

/// Whether the bodies are curved only along x, so that they touch along y.
bool touch_in_a_line(const Shape& lower, const Shape& upper)
{
  const auto k = relative_curvature(lower, upper);
  return k && (*k)[0] > 0.0 && (*k)[1] == 0.0;
}

} // namespace

std::optional<std::string> reason_against_contact(const ShapedBody& lower, const ShapedBody& upper,
                                                  const Domain& domain)
{
  if (contact_is_finite(lower.shape, upper.shape))
    return std::nullopt;
  if (domain.y.is_periodic() && touch_in_a_line(lower.shape, upper.shape))
    return std::nullopt;
  if (!domain.is_periodic())
    return "touch neither in a point nor in a line of finite length; allowed: a sum of curvatures > 0 along x and y, "
           "a tip, a cylinder of finite length on a flat or on another cylinder, a cylinder of any length with "
           "`Domain::boundary` = [\"open\", \"periodic\"], or two flats, one of them with a texture, with "
           "`Domain::boundary` = "
           "\"periodic\"";
  const auto k = relative_curvature(lower.shape, upper.shape);
  if (!k || (*k)[0] < 0.0 || (*k)[1] < 0.0)
    return "touch at the edges of the period only; allowed: a sum of curvatures that is not negative";
  if ((*k)[0] == 0.0 && (*k)[1] > 0.0)
    return "touch in a line along x; allowed: cylinders, whose axes lie along y";
  if (are_smooth(lower, upper) && (*k)[0] == 0.0)
    return "are two smooth flats, which touch everywhere at once; allowed with `Domain::boundary` = \"periodic\": a "
           "texture "
           "on one of them, or a shape";
  return std::nullopt;
}

namespace
{

/// Distance from the middle of the surface to which a part that does not repeat extends [m]; none for a part that repeats.
std::optional<std::array<double, 2>> bounds(const TexturePart& part)
{
  if (const auto* dent = std::get_if<Dent>(&part))
    return std::array{std::abs(dent->x) + 2.0 * dent->edge_radius, std::abs(dent->y) + 2.0 * dent->edge_radius};
  if (const auto* map = std::get_if<HeightMap>(&part); map && !map->periodic)
    return std::array{std::abs(map->x) + 0.5 * map->nx * map->dx, std::abs(map->y) + 0.5 * map->ny * map->dy};
  return std::nullopt;
}

} // namespace

std::optional<std::string> reason_against_texture(const Texture& texture, const Domain& domain)
{
  constexpr double any = std::numeric_limits<double>::infinity();
  constexpr double rounding = 1.0 + 1e-9;
  const double size_x = domain.x.is_periodic() ? domain.x.size : any;
  const double size_y = domain.y.is_periodic() ? domain.y.size : any;
  for (const TexturePart& part : texture.parts)
  {
    const auto reach = bounds(part);
    if (!reach)
    {
      if (auto reason = reason_against_period(std::vector{part}, size_x, size_y))
        return reason;
    }
    else if ((*reach)[0] > 0.5 * size_x * rounding || (*reach)[1] > 0.5 * size_y * rounding)
      return fmt::format("it reaches {:g} x {:g} m from the middle of the surface, beyond the period of {:g} x {:g} m",
                         (*reach)[0], (*reach)[1], size_x, size_y);
  }
  return std::nullopt;
}

namespace
{

/// Whether a map is uniform along one axis and compatible with a period of a given size.
bool is_uniform(const HeightMap& map, bool along_y, double size)
{
  constexpr double rounding = 1e-9;
  if (!map.periodic && (along_y ? map.ny * map.dy : map.nx * map.dx) < size * (1.0 - rounding))
    return false;
  for (int j = 0; j < map.ny; ++j)
    for (int i = 0; i < map.nx; ++i)
    {
      const std::size_t first = along_y ? static_cast<std::size_t>(i) : static_cast<std::size_t>(j) * map.nx;
      if (map.heights[static_cast<std::size_t>(j) * map.nx + i] != map.heights[first])
        return false;
    }
  return true;
}
bool is_uniform(const Sinusoid& s, bool along_y, double /*size*/)
{
  return std::isinf(along_y ? s.wavelength_y : s.wavelength_x);
}
bool is_uniform(const Dent& /*dent*/, bool /*along_y*/, double /*size*/)
{
  return false;
}
bool is_uniform(const RandomSurface& /*surface*/, bool /*along_y*/, double /*size*/)
{
  return false;
}

bool is_uniform(const Texture& texture, bool along_y, double size)
{
  return std::all_of(texture.parts.begin(), texture.parts.end(),
                     [&](const TexturePart& part)
                     { return std::visit([&](const auto& p) { return is_uniform(p, along_y, size); }, part); });
}

/// Name of the part of two bodies that varies along one axis of a period of a given size; empty if nothing varies.
std::string what_varies(const ShapedBody& lower, const ShapedBody& upper, bool along_y, double size)
{
  const auto k = relative_curvature(lower.shape, upper.shape);
  if (!k || (*k)[along_y ? 1 : 0] != 0.0)
    return "their shapes vary";
  for (const auto& [name, body] : {std::pair{"lower", &lower}, {"upper", &upper}})
    if (!is_uniform(body->texture, along_y, size))
      return member_of(name, "texture") + " varies";
    else if (!is_uniform(body->film, along_y, size))
      return member_of(name, "film") + " varies";
  return {};
}

} // namespace

void require_heights_on_cells(const ShapedBody& lower, const ShapedBody& upper, const Domain& domain,
                              const SurfaceGrid& grid)
{
  const std::optional<double> cells = cells_per_wave(lower, upper, domain, grid.dx, grid.dy);
  if (!cells || std::isinf(*cells)) // not flats over a period, or no waves that cells could miss
    return;
  constexpr double flat = 1e-6; // share of the texture's height: rounding, and below every tolerance of a contact
  std::string names;
  for (const auto& [name, body] : {std::pair{"lower", &lower}, {"upper", &upper}})
  {
    if (body->texture.is_smooth())
      continue;
    if (roughness_of(sampled_depths(body->texture, grid), grid).height > flat * reach(body->texture).height)
      return;
    names += (names.empty() ? "" : " and ") + member_of(name, "texture");
  }
  const char* const key = domain.x.cells > 0 ? "`Domain::cells`" : "`Numerics::spacing`";
  throw PlanError("{}: on cells of {:g} x {:g} m, each with the mean height over its area, nothing of {} "
                  "remains, and two flats touch everywhere at once; allowed: cells that resolve the waves: "
                  "the shortest one has {:.3g} cells and needs 8 for contact area and peak pressure",
                  key, grid.dx, grid.dy, names, *cells);
}

bool touch_all_along_y(const Shape& lower, const Shape& upper, const Domain& domain)
{
  return domain.y.is_periodic() && touch_in_a_line(lower, upper) && !(roller_length(lower, upper) < domain.y.size);
}

SurfaceGrid sampled_period(const Domain& domain)
{
  constexpr int usual = 256;
  constexpr int most = 1024;
  const auto cells = [&](const Domain::Axis& axis) { return axis.cells > 0 ? std::min(axis.cells, most) : usual; };
  const int nx = cells(domain.x);
  const int ny = cells(domain.y);
  return {nx, ny, domain.x.size / nx, domain.y.size / ny, Boundary::periodic, Boundary::periodic};
}

std::vector<double> sampled_depths(const Texture& texture, const SurfaceGrid& grid)
{
  const CellPlaces at = places_in_run(grid);
  return cell_depths(texture, grid, at.x, at.y);
}

void require_cells_in_periods(const PairCase& c, const SurfaceGrid& grid)
{
  if (grid.is_periodic() && grid.size() == 1)
    throw PlanError("`Domain::cells` = [1, 1]: the pressure on a single cell is uniform and causes no "
                    "displacement; allowed: more than one cell along x or y");
  for (const bool along_y : {false, true})
  {
    const Domain::Axis& axis = along_y ? c.domain.y : c.domain.x;
    if (!axis.is_periodic() || (along_y ? grid.ny : grid.nx) > 1)
      continue;
    const char* const name = along_y ? "y" : "x";
    if (const double length = roller_length(c.lower.shape, c.upper.shape); along_y && length < axis.size)
      throw PlanError("`Domain::size` = {:g} m along y, in one row, is more than the length of the cylinder, "
                      "{:g} m, whose ends one row cannot show; allowed: a period up to that length, or "
                      "`Domain::cells` > 1 along y",
                      axis.size, length);
    if (const std::string varying = what_varies(c.lower, c.upper, along_y, axis.size); !varying.empty())
      throw PlanError("`Domain::cells` is 1 along {0}: one cell takes bodies that are uniform along {0}, as in "
                      "plane strain, but {1}; allowed: the period along {0} as `Domain::size` and more "
                      "than one cell in it as `Domain::cells`",
                      name, varying);
  }
  require_heights_on_cells(c.lower, c.upper, c.domain, grid);
}

std::optional<std::string> reason_against_approach(const ShapedBody& lower, const ShapedBody& upper, double approach,
                                                   const Domain& domain, std::string_view scenario_case)
{
  if (!domain.is_periodic())
    return std::nullopt;
  constexpr double rounding = 1.0 + 1e-9;
  const SurfaceGrid grid = sampled_period(domain);
  const std::vector<double> distance = surface_distance(lower, upper, grid, places_in_run(grid), cell_depths);
  const auto size = static_cast<double>(grid.size());
  const double mean = std::accumulate(distance.begin(), distance.end(), 0.0) / size;
  const double magnitude =
      std::sqrt(std::inner_product(distance.begin(), distance.end(), distance.begin(), 0.0) / size);
  const bool may_be_apart =
      scenario_case == "SlidingCase"; // initially: peaks may meet on the way, even at a negative approach
  const double most =
      mean > 1e-12 * magnitude ? mean : 0.0; // a smaller mean is rounding of textures about the mean plane
  if (approach < 0.0 || (most > 0.0 && approach <= most * rounding))
    return std::nullopt;
  return fmt::format(
      "cannot be reached: with both axes periodic the approach counts from the mean planes, and at {0:.3g} m the "
      "surfaces touch everywhere; allowed: {1}a load or mean pressure instead (`{2}::load`, `{2}::pressure`, "
      "`{2}::mean_gap`)",
      most, most > 0.0 || may_be_apart ? "less than that, or " : "", scenario_case);
}

void require_finite_depth(const ShapedBody& lower, const ShapedBody& upper, double load, const Domain& domain)
{
  if (!domain.is_periodic())
    return;
  const double pressure = load / (domain.x.size * domain.y.size);
  for (const auto& [name, body] : {std::pair{"lower", &lower}, {"upper", &upper}})
  {
    if (!body->material.is_plastic())
      continue;
    const constitutive::DepthProfile& factor = body->material.yield_factor;
    const double core = factor.empty() ? 1.0 : factor.at(factor.depth().back(), 1.0);
    const double nu = body->material.elastic.poisson_ratio;
    const double most = core * constitutive::initial_yield_stress(body->material.law()) * (1.0 - nu) / (1.0 - 2.0 * nu);
    if (!(pressure < most))
      throw InputError(fmt::format("a mean pressure of {:.4g} Pa over the period makes the {} body yield to any depth; "
                                   "allowed: less than {:.4g} Pa, its yield stress times (1 - nu)/(1 - 2 nu)",
                                   pressure, name, most));
  }
}

double reference_distance(const Shape& lower, const Shape& upper, const Domain& domain)
{
  if (domain.x.is_periodic() == domain.y.is_periodic())
    return 0.0;
  if (domain.reference > 0.0)
    return domain.reference;
  if (touch_in_a_line(lower, upper))
    return 2.0 / (std::numbers::e * (*relative_curvature(lower, upper))[0]);
  return domain.x.is_periodic() ? domain.x.size : domain.y.size;
}

double line_length(const Shape& lower, const Shape& upper, const Domain& domain)
{
  const double length = roller_length(lower, upper);
  return domain.y.is_periodic() ? std::min(length, domain.y.size) : length;
}

} // namespace brinell::simulation
