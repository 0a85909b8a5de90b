// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/bearing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

namespace brinell::simulation
{

namespace
{

/// The bearing-area curve: descending heights, each at the middle of its share of the area.
struct Curve
{
  std::vector<double> heights;

  explicit Curve(std::vector<double> of) : heights(std::move(of))
  {
    std::sort(heights.begin(), heights.end(), std::greater<>());
  }
  [[nodiscard]] std::size_t size() const { return heights.size(); }
  [[nodiscard]] double share(std::size_t i) const
  {
    return (static_cast<double>(i) + 0.5) / static_cast<double>(size());
  }

  /// Share of the area at which the curve falls to a level, by linear interpolation between two points.
  [[nodiscard]] double share_above(double level) const
  {
    const auto next = std::lower_bound(heights.begin(), heights.end(), level, std::greater<>()); // first not above
    if (next == heights.begin())
      return 0.0;
    if (next == heights.end())
      return 1.0;
    const auto i = static_cast<std::size_t>(next - heights.begin());
    const double above = heights[i - 1], below = heights[i];
    return share(i - 1) + (above - level) / (above - below) / static_cast<double>(size());
  }
};

/// The core line: height at 0 % of the area, and its fall up to 100 %.
struct Line
{
  double start = 0.0, fall = 0.0;
};

/// Finds the secant over 40 % of the area with the smallest slope (the first one, if there are several); the core line is the
/// least-squares fit to the curve within this secant.
Line core_of(const Curve& curve)
{
  constexpr double part = 0.4;
  const auto& h = curve.heights;
  const auto across =
      std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(part * static_cast<double>(curve.size()))));
  const double rounding =
      1e-9 * (h.front() - h.back()); // regular waves have many equal secants, which must not be chosen by rounding
  std::size_t first = 0;
  for (std::size_t i = 1; i + across < curve.size(); ++i)
    if (h[i] - h[i + across] < h[first] - h[first + across] - rounding)
      first = i;
  if (h[first] == h[first + across])
    return {h[first], 0.0}; // a plateau, exactly
  const auto count = static_cast<double>(across + 1);
  double mean_share = 0.0, mean_height = 0.0;
  for (std::size_t i = first; i <= first + across; ++i)
  {
    mean_share += curve.share(i) / count;
    mean_height += h[i] / count;
  }
  double products = 0.0, squares = 0.0;
  for (std::size_t i = first; i <= first + across; ++i)
  {
    const double s = curve.share(i) - mean_share;
    products += s * (h[i] - mean_height);
    squares += s * s;
  }
  const double fall = -products / squares;
  return {mean_height + fall * mean_share, fall};
}

} // namespace

Bearing bearing_of(std::vector<double> heights)
{
  if (heights.size() < 2)
    return {};
  const Curve curve(std::move(heights));
  const Line core = core_of(curve);
  const double top = core.start, bottom = core.start - core.fall;
  const auto cells = static_cast<double>(curve.size());
  double above = 0.0, below = 0.0; // areas between the curve and the levels of the core's ends
  for (const double height : curve.heights)
  {
    above += std::max(0.0, height - top) / cells;
    below += std::max(0.0, bottom - height) / cells;
  }
  const bool is_plateau = core.fall == 0.0; // heights at the level of the plateau are neither above nor below
  const auto& h = curve.heights;
  Bearing bearing{.core_height = core.fall};
  if (above > 0.0)
  {
    const auto end = std::lower_bound(h.begin(), h.end(), top, std::greater<>());
    bearing.peak_share = is_plateau ? static_cast<double>(end - h.begin()) / cells : curve.share_above(top);
    bearing.peak_height = 2.0 * above / bearing.peak_share;
  }
  if (below > 0.0)
  {
    const auto begin = std::upper_bound(h.begin(), h.end(), bottom, std::greater<>());
    bearing.valley_share = is_plateau ? static_cast<double>(begin - h.begin()) / cells : curve.share_above(bottom);
    bearing.valley_depth = 2.0 * below / (1.0 - bearing.valley_share);
  }
  return bearing;
}

} // namespace brinell::simulation
