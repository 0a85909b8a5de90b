// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/texture.hpp"

#include "foundation/fft.hpp"
#include "foundation/series_fft.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

/// Slopes and shortest waves of height maps.
namespace brinell::simulation
{

namespace
{

/// Parallel lines of points of a map.
struct Lines
{
  const double* heights;
  int points, count;              ///< of a line, and of lines
  std::ptrdiff_t stride, between; ///< from one point to the next, and from one line to the next
  double spacing;                 ///< [m]

  /// h_{i+1} - 2 h_i + h_{i-1} about the point i + 1.
  [[nodiscard]] double second_difference(int line, int i) const
  {
    const double* h = heights + line * between + i * stride;
    return h[2 * stride] - 2.0 * h[stride] + h[0];
  }
};

/// Wavelength from the ratio of the mean squares of first and second differences: that of a single wave, and otherwise
/// longer than the shortest one. Infinite if the lines are straight.
double mean_wave(const Lines& lines)
{
  double first = 0.0, second = 0.0; // squares of the differences
  for (int line = 0; line < lines.count; ++line)
    for (int i = 0; i + 2 < lines.points; ++i)
    {
      const double* h = lines.heights + line * lines.between + i * lines.stride;
      first += 0.5 * (std::pow(h[lines.stride] - h[0], 2) + std::pow(h[2 * lines.stride] - h[lines.stride], 2));
      second += std::pow(lines.second_difference(line, i), 2);
    }
  if (!(second > 0.0))
    return std::numeric_limits<double>::infinity();
  return std::numbers::pi * lines.spacing / std::asin(std::min(1.0, 0.5 * std::sqrt(second / first)));
}

/// Power of the second differences under a Hann window, summed over the lines, at k/length cycles per point.
std::vector<double> curvature_spectrum(const Lines& lines, const SeriesFft& transform)
{
  const int count = lines.points - 2;
  std::vector<double> window(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    window[static_cast<std::size_t>(i)] = 1.0 - std::cos(2.0 * std::numbers::pi * (i + 0.5) / count);
  const auto length = static_cast<std::size_t>(transform.length());
  std::vector<double> series(2 * static_cast<std::size_t>(count), 0.0), re(length + lane_count),
      im(length + lane_count);
  std::vector<double> power(length / 2 + 1, 0.0);
  SeriesFft::Work work = transform.make_work();
  for (int line = 0; line < lines.count; ++line)
  {
    for (std::size_t i = 0; i < window.size(); ++i)
      series[2 * i] = window[i] * lines.second_difference(line, static_cast<int>(i));
    transform.forward(series.data(), static_cast<int>(series.size()), re.data(), im.data(), work);
    for (std::size_t k = 0; k < power.size(); ++k)
      power[k] += re[k] * re[k] + im[k] * im[k];
  }
  return power;
}

/// The wavelength above which 98 % of the mean square of the curvature lies. The window spreads each wave over the next
/// frequencies, by up to 2/count cycles per point each way, all but 2 % of it within 1.5/count. Infinite for lines too short to
/// tell.
double shortest_wave(const Lines& lines)
{
  constexpr int fewest_points = 10;
  constexpr double share = 0.98;
  if (lines.points < fewest_points)
    return std::numeric_limits<double>::infinity();
  const SeriesFft transform(fast_length(2 * lines.points));
  const std::vector<double> power = curvature_spectrum(lines, transform);
  double all = 0.0, below = 0.0;
  for (const double p : power)
    all += p;
  std::size_t k = 0;
  while (k + 1 < power.size() && below + power[k] < share * all)
    below += power[k++];
  const double cycles = static_cast<double>(k) / transform.length() - 1.5 / (lines.points - 2);
  return cycles > 0.0 ? lines.spacing / cycles : std::numeric_limits<double>::infinity();
}

} // namespace

double rms_slope(const HeightMap& map)
{
  double sum = 0.0;
  std::size_t count = 0;
  const auto add = [&](std::size_t here, std::size_t next, double distance)
  {
    const double slope = (map.heights[next] - map.heights[here]) / distance;
    sum += slope * slope;
    ++count;
  };
  const auto nx = static_cast<std::size_t>(map.nx), ny = static_cast<std::size_t>(map.ny);
  for (std::size_t j = 0; j < ny; ++j)
    for (std::size_t i = 0; i < nx; ++i)
    {
      if (i + 1 < nx)
        add(j * nx + i, j * nx + i + 1, map.dx);
      if (j + 1 < ny)
        add(j * nx + i, j * nx + i + nx, map.dy);
    }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
}

std::array<double, 2> shortest_waves(const HeightMap& map)
{
  const auto of = [](const Lines& lines)
  {
    const double mean = mean_wave(lines);
    return std::isfinite(mean) ? std::max(2.0 * lines.spacing, std::min(mean, shortest_wave(lines))) : mean;
  };
  return {of({map.heights.data(), map.nx, map.ny, 1, map.nx, map.dx}),
          of({map.heights.data(), map.ny, map.nx, map.nx, 1, map.dy})};
}

} // namespace brinell::simulation
