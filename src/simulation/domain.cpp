// SPDX-License-Identifier: BSD-3-Clause
#include "footprint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace brinell::simulation
{

namespace
{

/// Whether the bodies are curved along x alone, so that they touch along y.
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
    return "touch neither in a point nor in a line of finite length; allowed: a sum of curvatures > 0 along x and y, a "
           "tip, "
           "a cylinder of finite length on a flat or on another cylinder, a cylinder of any length with grid.boundary "
           "= "
           "[\"open\", \"periodic\"], or two flats, one of them with a texture, with grid.boundary = \"periodic\"";
  const auto k = relative_curvature(lower.shape, upper.shape);
  if (!k || (*k)[0] < 0.0 || (*k)[1] < 0.0)
    return "touch at the edges of the period only; allowed: a sum of curvatures that is not negative";
  if (are_smooth(lower, upper))
    return "are two smooth flats, which touch everywhere at once; allowed with grid.boundary = \"periodic\": a texture "
           "on "
           "one of them, or a shape";
  return std::nullopt;
}

namespace
{

/// How far a part that does not repeat reaches from the middle of the surface [m]; none for one that does.
std::optional<std::array<double, 2>> bounds(const TexturePart& part)
{
  if (const auto* dent = std::get_if<Dent>(&part))
    return std::array{std::abs(dent->x) + 0.5 * dent->radius, std::abs(dent->y) + 0.5 * dent->radius};
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
