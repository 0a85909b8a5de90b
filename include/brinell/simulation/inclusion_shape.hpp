// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/body.hpp"
#include "brinell/foundation/grid.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

namespace brinell::simulation
{

/// Region of a body that an inclusion fills. Coordinates are x and y on the body's surface, as of textures, and the depth z.
struct InclusionShape
{
  enum class Kind
  {
    ellipsoid,
    cuboid,
    cylinder ///< with an elliptic cross-section
  };
  Kind kind = Kind::ellipsoid;
  std::array<double, 3> centre{};    ///< [m]; a depth below semi_axes[2] lets the inclusion end at the surface
  std::array<double, 3> semi_axes{}; ///< half of the sizes along x, y and z [m], > 0
  int axis = 2;                      ///< of a cylinder: 0, 1, 2 for x, y, z

  [[nodiscard]] double volume() const; ///< of the whole region, also above the surface [m^3]
  [[nodiscard]] bool contains(double x, double y, double z) const;
  bool operator==(const InclusionShape&) const = default;
};

/// Balls at random places of a box, which do not overlap.
struct InclusionCluster
{
  std::array<double, 3> centre{};                     ///< of the box [m]
  std::array<double, 3> half_sides{};                 ///< of the box, within which the balls lie [m]
  double smallest_radius = 0.0, largest_radius = 0.0; ///< radii are uniform between both [m]
  int count = 0;
  double gap = 0.0; ///< least distance between two balls [m]
  std::uint64_t seed = 0;
  bool operator==(const InclusionCluster&) const = default;
};

/// Solid and empty voxels of a measured or computed structure, x fastest, from a corner on.
struct InclusionVoxels
{
  std::array<int, 3> count{};
  std::array<double, 3> corner{}; ///< of the first voxel, the one with the smallest coordinates [m]
  double size = 0.0;              ///< of a voxel [m]
  std::vector<char> is_filled{};
  bool operator==(const InclusionVoxels&) const = default;
};

/// Inclusions of one material in a body.
struct BodyInclusion
{
  Elastic elastic; ///< see halfspace::Inclusion
  std::variant<InclusionShape, InclusionCluster, InclusionVoxels> region{};
  halfspace::Inclusion::Own own{};
  double yield_factor = 1.0; ///< on the yield stress of the body; rigid inclusions do not yield
  bool operator==(const BodyInclusion&) const = default;
};

/// Cells of a grid, whose cell (0, 0) has its centre at (x0, y0) [m], with their centre in the region.
/// @throws InputError if a size is not above 0
[[nodiscard]] std::vector<std::size_t> cells_of(const InclusionShape& shape, const VolumeGrid& grid, double x0,
                                                double y0);
[[nodiscard]] std::vector<std::size_t> cells_of(const InclusionVoxels& voxels, const VolumeGrid& grid, double x0,
                                                double y0);
/// The balls of a cluster, the same for the same seed on every machine.
/// @throws InputError if there is no room for them
[[nodiscard]] std::vector<InclusionShape> shapes_of(const InclusionCluster& cluster);
/// Inclusions in the cells of a grid, as above; those beside the grid are left out.
/// @throws InputError if one of them reaches beneath the grid
[[nodiscard]] std::vector<elastoplastic::Inclusion> in_cells(const std::vector<BodyInclusion>& inclusions,
                                                             const VolumeGrid& grid, double x0, double y0);
/// Cells along the smallest semi-axis, which decide about the accuracy: docs/theory/inclusions.md.
[[nodiscard]] double cells_per_axis(const InclusionShape& shape, const VolumeGrid& grid);

} // namespace brinell::simulation
