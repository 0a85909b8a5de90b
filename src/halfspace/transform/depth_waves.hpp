// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace brinell::halfspace
{

/// Waves in depth that represent the memory of a conducting half space. Of a unit of heat at the wavenumber k,
/// exp(-kappa k^2 t)/sqrt(pi kappa t) remains at the surface after the time t, and
///     1/sqrt(pi kappa t) = 2/pi int_0^inf exp(-kappa s^2 t) ds
/// is a sum over waves cos(s z). In ln s the trapezoidal rule converges exponentially, so that a few waves suffice for all times.
struct DepthWave
{
  double number = 0.0; ///< s [1/m]
  double weight = 0.0; ///< [1/m]
};

/// Ranges of time and depth in which the waves are to be accurate.
struct DepthRange
{
  double shortest, longest; ///< times since the heat has entered [s]
  double deepest = -1.0;    ///< largest depth of fields in the body [m]; negative: only the temperature of the surface
};

/// The waves of one body, from the fastest to the slowest.
struct DepthWaves
{
  std::vector<DepthWave> waves; ///< the last one, with s = 0, represents all waves that are slower than the one before
  double step = 0.0;            ///< of ln s
  bool has_fields = false;      ///< whether they also serve for fields in the body

  /// The waves with s below `number`.
  [[nodiscard]] DepthWaves slower_than(double number) const;
  /// Sum of weight * k/(k^2 + s^2) over the waves that the last one represents; 1 for k = 0.
  [[nodiscard]] double slow_share(double k) const;
  /// Contribution of waves faster than the first one to a sum of terms proportional to weight/s^power, relative to the term of
  /// the first one.
  [[nodiscard]] double beyond(int power) const;
};

/// The waves of a body. For fields they include faster waves than those that remain after a step, as these represent the flux of
/// the step itself at its end.
/// @param finest  largest wavenumber along the surface [1/m], which determines the fastest wave
[[nodiscard]] DepthWaves depth_waves(double diffusivity, const DepthRange& range, double finest);

/// Means of cos x and sin x over ln x that retain what a sum in equal steps of ln s can resolve: equal to cos x and sin x for
/// small x, and zero where the phase x changes too much from one wave to the next. Sums over waves are then accurate at any
/// depth: docs/theory/heat.md (turned).
struct TurnedWave
{
  double cosine, sine; ///< the sine for sums over s ds
};
class TurnedWaves
{
public:
  /// @param step  of ln s
  explicit TurnedWaves(double step);
  /// The means at `count` values of x, from the largest one down in steps of ln x: those of all waves at one depth.
  [[nodiscard]] std::vector<TurnedWave> operator()(double largest, std::size_t count) const;

private:
  /// A point of the path of integration, equidistant in u: the weights of both means at this point.
  struct Point
  {
    std::complex<double> of_cosine, of_sine;
  };
  /// Points of the path per step: an integer, so that all x of a series use the same row of points.
  static constexpr std::size_t points_per_step = 10;
  double spacing_, first_; ///< of the points in u
  std::vector<Point> points_;
};

} // namespace brinell::halfspace
