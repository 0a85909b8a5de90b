// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace brinell::elastoplastic
{

/// Heat that is supplied from outside, besides that of friction and of plastic work. It moves with the contact and is constant in
/// time: docs/theory/heat.md (imposed-heat).
struct HeatSource
{
  enum class Shape
  {
    none,
    disc,      ///< uniform flux into the surface of one body, on a disc
    rectangle, ///< uniform flux into the surface of one body, on a rectangle
    contact ///< between the surfaces where they touch, in proportion to the pressure; shared by the bodies like heat of friction
  };
  enum class Side
  {
    lower,
    upper
  };
  Shape shape = Shape::none;
  Side on = Side::lower;          ///< body of a disc or rectangle
  std::optional<double> power{};  ///< total [W], > 0; on a periodic grid that of one period
  std::optional<double> flux{};   ///< of a disc or rectangle instead of the power [W/m^2], > 0
  std::optional<double> radius{}; ///< of a disc [m], > 0
  std::optional<double> length{}; ///< of a rectangle, along x [m], > 0
  std::optional<double> width{};  ///< of a rectangle, along y [m], > 0; none, along a periodic axis only: the period
  double offset = 0.0; ///< of the middle of a disc or rectangle from the middle of the contact grid, along x [m]

  [[nodiscard]] bool exists() const { return shape != Shape::none; }
  /// Whether the heat enters through the surface of one body.
  [[nodiscard]] bool is_on_body() const { return shape == Shape::disc || shape == Shape::rectangle; }
  [[nodiscard]] std::size_t side() const { return static_cast<std::size_t>(on); }
  bool operator==(const HeatSource&) const = default;
};

/// Largest distances of a disc or rectangle from the middle of the contact grid along x and y [m].
struct SourceReach
{
  double x = 0.0, y = 0.0;
};
/// Zero for other sources, and along y for a rectangle over the whole period.
[[nodiscard]] SourceReach reach(const HeatSource& source);

/// Flux of a disc or rectangle, as its mean over each cell [W/m^2]: the sum of flux x cell area is the power. Zero for other
/// sources.
/// @throws InternalError if a part lies beyond the grid
[[nodiscard]] std::vector<double> flux_on(const HeatSource& source, const SurfaceGrid& contact);

} // namespace brinell::elastoplastic
