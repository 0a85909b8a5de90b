// SPDX-License-Identifier: BSD-3-Clause
#include "embedding.hpp"

#include "heat.hpp"
#include "stress_at_rest.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace brinell::simulation
{

namespace
{

constexpr double deepest_over_contact = 3.0;

/// The shapes of an inclusion; of voxels the box of all of them.
std::vector<InclusionShape> parts_of(const BodyInclusion& inclusion)
{
  if (const auto* shape = std::get_if<InclusionShape>(&inclusion.region))
    return {*shape};
  if (const auto* cluster = std::get_if<InclusionCluster>(&inclusion.region))
    return shapes_of(*cluster);
  const auto& voxels = std::get<InclusionVoxels>(inclusion.region);
  InclusionShape box{InclusionShape::Kind::cuboid};
  for (std::size_t i = 0; i < 3; ++i)
  {
    box.semi_axes[i] = 0.5 * voxels.size * voxels.count[i];
    box.centre[i] = voxels.corner[i] + box.semi_axes[i];
  }
  return {box};
}

/// Inclusions of a body on its grid.
class Laid
{
public:
  /// @param name  "lower" or "upper"
  /// @param origin  x of the first column [m]
  Laid(const ShapedBody& body, std::string_view name, const VolumeGrid& grid, double origin, double beside)
      : body_(body), name_(name), grid_(grid), origin_(origin), x0_(grid.surface.x(0)), y0_(grid.surface.y(0) + beside)
  {
  }

  EmbeddedCells counted()
  {
    for (std::size_t number = 0; number < body_.inclusions.size(); ++number)
      count(number);
    count_cells();
    return found_;
  }

private:
  /// An inclusion as messages name it: "`lower.inclusion[0]`".
  [[nodiscard]] std::string member(std::size_t number) const
  {
    return member_of(name_, fmt::format("inclusion[{}]", number));
  }

  enum class Where
  {
    within,
    cut,
    beside
  };

  /// Whether a shape is within the grid along an axis.
  [[nodiscard]] Where along(const InclusionShape& shape, std::size_t axis, std::size_t number) const
  {
    constexpr double rounding = 1e-9;
    const SurfaceGrid& s = grid_.surface;
    const double cell = axis == 0 ? s.dx : s.dy, first = (axis == 0 ? x0_ : y0_) - 0.5 * cell;
    const double last = first + cell * (axis == 0 ? s.nx : s.ny);
    const double begin = shape.centre[axis] - shape.semi_axes[axis], end = shape.centre[axis] + shape.semi_axes[axis];
    const double small = rounding * cell;
    if (begin >= first - small && end <= last + small)
      return Where::within;
    if (axis == 0 ? s.is_periodic_x() : s.is_periodic_y())
      throw PlanError("{} reaches from {:.4g} m to {:.4g} m along {}, over the edge of the period, from {:.4g} "
                      "m to {:.4g} m; allowed: inclusions within the period",
                      member(number), begin, end, axis == 0 ? "x" : "y", first, last);
    return end <= first || begin >= last ? Where::beside : Where::cut;
  }

  void count(std::size_t number)
  {
    const BodyInclusion& inclusion = body_.inclusions[number];
    const double mu = body_.material.elastic.shear_modulus();
    const Elastic& elastic = inclusion.elastic;
    const double ratio = elastic.shear_modulus() / mu;
    const double contrast = elastic.is_rigid() ? -1.0 : (1.0 - ratio) / (1.0 + ratio);
    found_.softest = std::max(found_.softest, contrast);
    found_.stiffest = std::min(found_.stiffest, contrast);
    found_.has_own_strain = found_.has_own_strain || !(inclusion.own == halfspace::Inclusion::Own{});
    found_.has_own_strength = found_.has_own_strength || inclusion.yield_factor != 1.0 || elastic.is_rigid();
    if (is_plane(grid_.surface))
      require_prism(number);
    if (const auto* voxels = std::get_if<InclusionVoxels>(&inclusion.region))
      found_.voxel = std::min(
          found_.voxel,
          voxels->size / std::min({grid_.surface.dx, grid_.dz, is_plane(grid_.surface) ? grid_.dz : grid_.surface.dy}));
    for (const InclusionShape& shape : parts_of(inclusion))
      if (is_within(shape, number))
        measure(shape, number, contrast);
  }

  /// Refuses, where nothing varies along y, an inclusion that does.
  void require_prism(std::size_t number) const
  {
    constexpr int along_y = 1;
    const auto& region = body_.inclusions[number].region;
    const auto* shape = std::get_if<InclusionShape>(&region);
    const auto* voxels = std::get_if<InclusionVoxels>(&region);
    const bool is_prism =
        shape != nullptr && (shape->kind == InclusionShape::Kind::cuboid ||
                             (shape->kind == InclusionShape::Kind::cylinder && shape->axis == along_y));
    if (!is_prism && !(voxels != nullptr && voxels->count[1] == 1))
      throw PlanError(
          "{} ends along y, but in plane strain nothing varies along y; allowed: cuboids, cylinders with the "
          "axis y, voxels of one row",
          member(number));
  }

  /// @returns whether a part of the shape is within the grid
  bool is_within(const InclusionShape& shape, std::size_t number)
  {
    const bool is_one = !std::holds_alternative<InclusionCluster>(body_.inclusions[number].region);
    const double bottom = grid_.nz * grid_.dz, deepest = shape.centre[2] + shape.semi_axes[2];
    if (deepest > bottom * (1.0 + 1e-9))
      throw PlanError("{} reaches down to {:.4g} m, where the contact causes hardly any stress; allowed: down "
                      "to {:.4g} m, or deeper grids by `Numerics::extent`",
                      member(number), deepest, bottom);
    const Where x = along(shape, 0, number), y = is_plane(grid_.surface) ? Where::within : along(shape, 1, number);
    if (x == Where::beside || y == Where::beside)
    {
      const SurfaceGrid& s = grid_.surface;
      if (is_one)
        throw PlanError("{} at x = {:.4g} m, y = {:.4g} m lies beside the grid, where the body is not "
                        "computed; allowed: x from {:.4g} m to {:.4g} m and y from {:.4g} m to {:.4g} m",
                        member(number), shape.centre[0], shape.centre[1], x0_, x0_ + (s.nx - 1) * s.dx, y0_,
                        y0_ + (s.ny - 1) * s.dy);
      ++found_.beside;
      return false;
    }
    found_.cut += x == Where::cut || y == Where::cut ? 1 : 0;
    return true;
  }

  void measure(const InclusionShape& shape, std::size_t number, double contrast)
  {
    constexpr double fewest = 0.5; // one cell along the smallest size
    InclusionShape measured = shape;
    if (is_plane(grid_.surface))
      measured.semi_axes[1] = std::max(measured.semi_axes[1], 1e6 * grid_.surface.dy);
    const double cells = cells_per_axis(measured, grid_);
    if (cells < found_.least)
    {
      found_.least = cells;
      found_.coarsest = number;
      found_.contrast = contrast;
    }
    if (!(cells >= fewest))
      throw PlanError("{} has {:.2g} cells along its smallest size; allowed: at least 1, so larger inclusions or "
                      "smaller cells (`Numerics::resolution` or `Numerics::spacing`)",
                      member(number), 2.0 * cells);
  }

  /// Counts the cells, of which none may belong to two inclusions.
  void count_cells()
  {
    std::vector<std::pair<std::size_t, std::size_t>> owners; // cell, inclusion
    std::vector<elastoplastic::Inclusion> all;
    for (std::size_t number = 0; number < body_.inclusions.size(); ++number)
    {
      const auto laid = in_cells({body_.inclusions[number]}, grid_, origin_, y0_);
      if (laid.empty() && !std::holds_alternative<InclusionCluster>(body_.inclusions[number].region))
        throw PlanError("{} contains no centre of a cell; allowed: larger inclusions, or smaller cells",
                        member(number));
      for (const elastoplastic::Inclusion& one : laid)
        for (const std::size_t cell : one.cells)
          owners.emplace_back(cell, number);
      all.insert(all.end(), laid.begin(), laid.end());
    }
    std::ranges::sort(owners);
    for (std::size_t i = 1; i < owners.size(); ++i)
      if (owners[i].first == owners[i - 1].first)
        throw PlanError("{} and {} overlap in a cell; allowed: inclusions that share no cell",
                        member(owners[i - 1].second), member(owners[i].second));
    if (owners.empty())
      throw PlanError("{}: all inclusions lie beside the grid; allowed: inclusions beneath the track",
                      member_of(name_, "inclusion"));
    found_.cells = owners.size();
    found_.layers = static_cast<int>(owners.back().first / grid_.surface.size()) + 1;
    if (found_.has_own_strain)
      found_.at_rest = ratio_at_rest(all, grid_, body_.material);
  }

  const ShapedBody& body_;
  std::string name_;
  const VolumeGrid& grid_;
  double origin_; ///< x of the first column
  double x0_,
      y0_; ///< of the first column and row of a grid with its middle at x = 0; `origin_` is up to half a cell from it
  EmbeddedCells found_;
};

/// Refuses what is not computed in a body with inclusions.
void require_computable(const PairCase& c, const ShapedBody& body, std::string_view name)
{
  const std::string inclusion = member_of(name, "inclusion");
  const constitutive::Material& material = body.material;
  if (material.elastic.is_rigid())
    throw PlanError("{} in a rigid body; allowed: a body that deforms", inclusion);
  if (!material.layers.empty())
    throw PlanError("{} and {}; allowed: one of them", inclusion, member_of(name, "material.layers"));
  if (!material.is_plastic())
    throw PlanError(
        "{} in a body that cannot yield; allowed: a body with a hardening law, with a high yield stress if it is "
        "to stay elastic",
        inclusion);
  if (is_heated(c) && material.thermal)
    throw PlanError("{} in a body that is heated; allowed: no heat, or no {}", inclusion,
                    member_of(name, "material.thermal"));
  if (material.softening)
    throw PlanError("{} and {}; allowed: one of them", inclusion, member_of(name, "material.softening"));
  if (!material.initial_stress.empty())
    throw PlanError("{} and {}: how inclusions change an initial stress is not computed; allowed: one of them, or a "
                    "misfit of the inclusion",
                    inclusion, member_of(name, "material.initial_stress"));
  if (material.electrical)
    throw PlanError("{} and {}: the current through inclusions is not computed; allowed: one of them", inclusion,
                    member_of(name, "material.electrical"));
  const auto is_rigid = [](const BodyInclusion& one) { return one.elastic.is_rigid(); };
  if (body.fatigue && std::ranges::any_of(body.inclusions, is_rigid))
    throw PlanError("{} and {}: a rigid inclusion, whose cells have no accurate stress; allowed: one of them, or an "
                    "elastic inclusion",
                    inclusion, member_of(name, "fatigue"));
  if (c.wear.wears())
    throw PlanError(
        "{} and {}: wear would bring inclusions nearer to the surface, which is not computed; allowed: one of "
        "them",
        c.wear.lower > 0.0 ? "`WearLaw::lower`" : "`WearLaw::upper`", inclusion);
}

} // namespace

double depth_with_inclusions(const ShapedBody& lower, const ShapedBody& upper, double depth)
{
  double deepest = 0.0;
  for (const ShapedBody* body : {&lower, &upper})
    for (const BodyInclusion& inclusion : body->inclusions)
      for (const InclusionShape& shape : parts_of(inclusion))
        deepest = std::max(deepest, shape.centre[2] + shape.semi_axes[2]);
  return std::max(depth, std::min(deepest, deepest_over_contact * depth));
}

std::array<EmbeddedCells, 2> embedded_cells(const PairCase& c, const Plan& plan, const std::array<double, 2>& beside)
{
  std::array<EmbeddedCells, 2> found{};
  // Where the run has the columns of the lower body, and, to half a cell, those of the upper one.
  const int lower_nx = plan.lower.surface.nx, upper_nx = plan.upper.surface.nx, half = (plan.contact.nx - 1) / 2,
            lower_half = (lower_nx - 1) / 2;
  const double lower_origin = -lower_half * plan.lower.surface.dx;
  const double upper_origin =
      -(half + static_cast<double>(std::lround(0.5 * (upper_nx - 1) - half))) * plan.upper.surface.dx;
  if (!c.lower.inclusions.empty())
  {
    require_computable(c, c.lower, "lower");
    found[0] = Laid(c.lower, "lower", plan.lower, lower_origin, beside[0]).counted();
  }
  if (!c.upper.inclusions.empty())
  {
    require_computable(c, c.upper, "upper");
    found[1] = Laid(c.upper, "upper", plan.upper, upper_origin, beside[1]).counted();
  }
  return found;
}

} // namespace brinell::simulation
