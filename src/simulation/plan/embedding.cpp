// SPDX-License-Identifier: BSD-3-Clause
#include "embedding.hpp"

#include "heat.hpp"

#include <algorithm>
#include <cmath>
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
  Laid(const ShapedBody& body, std::string_view name, const VolumeGrid& grid, double beside)
      : body_(body), member_(member_of(name, "inclusion")), grid_(grid),
        x0_(-0.5 * (grid.surface.nx - 1) * grid.surface.dx), y0_(grid.surface.y(0) + beside)
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
      throw PlanError(
          "{}: inclusion {} reaches from {:.4g} m to {:.4g} m along {}, over the edge of the period, from {:.4g} "
          "m to {:.4g} m; allowed: inclusions within the period",
          member_, number + 1, begin, end, axis == 0 ? "x" : "y", first, last);
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
    for (const InclusionShape& shape : parts_of(inclusion))
      if (is_within(shape, number))
        measure(shape, number, contrast);
  }

  /// @returns whether a part of the shape is within the grid
  bool is_within(const InclusionShape& shape, std::size_t number)
  {
    const bool is_one = !std::holds_alternative<InclusionCluster>(body_.inclusions[number].region);
    const double bottom = grid_.nz * grid_.dz, deepest = shape.centre[2] + shape.semi_axes[2];
    if (deepest > bottom * (1.0 + 1e-9))
      throw PlanError(
          "{}: inclusion {} reaches down to {:.4g} m, where the contact causes hardly any stress; allowed: down "
          "to {:.4g} m, or deeper grids by `Numerics::extent`",
          member_, number + 1, deepest, bottom);
    const Where x = along(shape, 0, number), y = is_plane(grid_.surface) ? Where::within : along(shape, 1, number);
    if (x == Where::beside || y == Where::beside)
    {
      const SurfaceGrid& s = grid_.surface;
      if (is_one)
        throw PlanError("{}: inclusion {} at x = {:.4g} m, y = {:.4g} m lies beside the grid, where the body is not "
                        "computed; allowed: x from {:.4g} m to {:.4g} m and y from {:.4g} m to {:.4g} m",
                        member_, number + 1, shape.centre[0], shape.centre[1], x0_, x0_ + (s.nx - 1) * s.dx, y0_,
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
      throw PlanError(
          "{}: inclusion {} has {:.2g} cells along its smallest size; allowed: at least 1, so larger inclusions or "
          "smaller cells (`Numerics::resolution` or `Numerics::spacing`)",
          member_, number + 1, 2.0 * cells);
  }

  /// Counts the cells, of which none may belong to two inclusions.
  void count_cells()
  {
    std::vector<std::pair<std::size_t, std::size_t>> owners; // cell, inclusion
    for (std::size_t number = 0; number < body_.inclusions.size(); ++number)
    {
      const auto laid = in_cells({body_.inclusions[number]}, grid_, x0_, y0_);
      if (laid.empty() && !std::holds_alternative<InclusionCluster>(body_.inclusions[number].region))
        throw PlanError("{}: inclusion {} contains no centre of a cell; allowed: larger inclusions, or smaller cells",
                        member_, number + 1);
      for (const elastoplastic::Inclusion& one : laid)
        for (const std::size_t cell : one.cells)
          owners.emplace_back(cell, number);
    }
    std::ranges::sort(owners);
    for (std::size_t i = 1; i < owners.size(); ++i)
      if (owners[i].first == owners[i - 1].first)
        throw PlanError("{}: inclusions {} and {} overlap in a cell; allowed: inclusions that share no cell", member_,
                        owners[i - 1].second + 1, owners[i].second + 1);
    if (owners.empty())
      throw PlanError("{}: all inclusions lie beside the grid; allowed: inclusions beneath the track", member_);
    found_.cells = owners.size();
    found_.layers = static_cast<int>(owners.back().first / grid_.surface.size()) + 1;
  }

  const ShapedBody& body_;
  std::string member_;
  const VolumeGrid& grid_;
  double x0_, y0_; ///< of the first column and row, to half a cell
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
  if (!c.lower.inclusions.empty())
  {
    require_computable(c, c.lower, "lower");
    found[0] = Laid(c.lower, "lower", plan.lower, beside[0]).counted();
  }
  if (!c.upper.inclusions.empty())
  {
    require_computable(c, c.upper, "upper");
    found[1] = Laid(c.upper, "upper", plan.upper, beside[1]).counted();
  }
  return found;
}

} // namespace brinell::simulation
