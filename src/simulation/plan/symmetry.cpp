// SPDX-License-Identifier: BSD-3-Clause
#include "symmetry.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::simulation
{

namespace
{

Dent mirrored(Dent dent)
{
  dent.y = -dent.y;
  return dent;
}

HeightMap mirrored(HeightMap map)
{
  map.y = -map.y;
  for (int j = 0; 2 * j + 1 < map.ny; ++j)
    std::swap_ranges(map.heights.begin() + static_cast<std::ptrdiff_t>(j) * map.nx,
                     map.heights.begin() + static_cast<std::ptrdiff_t>(j + 1) * map.nx,
                     map.heights.begin() + static_cast<std::ptrdiff_t>(map.ny - 1 - j) * map.nx);
  return map;
}

/// Waves are symmetric about y = 0 if the crests at y and -y are a whole number of wavelengths apart, or if there are no waves
/// along y.
Sinusoid mirrored(Sinusoid waves)
{
  if (std::isfinite(waves.wavelength_y) && std::remainder(2.0 * waves.y, waves.wavelength_y) != 0.0)
    waves.y = -waves.y;
  return waves;
}

} // namespace

/// One overload per shape, without a default, so that a new shape does not compile until it is considered here.
bool is_symmetric_in_y(const Shape& shape)
{
  struct IsSymmetric
  {
    bool operator()(const Plane&) const { return true; }
    bool operator()(const Paraboloid&) const { return true; } // its radii are along x and y
    bool operator()(const Roller&) const { return true; }
    bool operator()(const Cone&) const { return true; }
    bool operator()(const Pyramid&) const { return true; } // one of its faces rises along x
  };
  return std::visit(IsSymmetric{}, shape);
}

/// Whether the texture contains the mirror image of each part as often as the part.
bool is_symmetric_in_y(const Texture& texture)
{
  const auto has_image = [&](const TexturePart& part)
  {
    if (std::holds_alternative<RandomSurface>(part))
      return false;
    const TexturePart image = std::visit(
        []<typename Part>(const Part& p) -> TexturePart
        {
          if constexpr (std::is_same_v<Part, RandomSurface>)
            return p;
          else
            return mirrored(p);
        },
        part);
    const auto count = [&](const TexturePart& like)
    { return std::count(texture.parts.begin(), texture.parts.end(), like); };
    return count(image) == count(part);
  };
  return std::all_of(texture.parts.begin(), texture.parts.end(), has_image);
}

bool is_solved_by_halves(const PairCase& c, const SurfaceGrid& contact, bool one_sided)
{
  const auto is_symmetric = [](const ShapedBody& body)
  {
    return is_symmetric_in_y(body.shape) && is_symmetric_in_y(body.texture) && is_symmetric_in_y(body.film) &&
           body.inclusions.empty();
  };
  const bool is_worth = contact.ny > 1 && (c.lower.material.is_plastic() || c.upper.material.is_plastic());
  return c.solver.symmetry && is_worth && !one_sided && is_symmetric(c.lower) && is_symmetric(c.upper);
}

} // namespace brinell::simulation
