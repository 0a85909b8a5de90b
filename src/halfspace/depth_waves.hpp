// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace brinell::halfspace
{

/// Waves in depth that share the memory of a conducting half space. Of a unit of heat, exp(-kappa k^2 t)/sqrt(pi kappa t) is left at the
/// surface at a wavenumber k, and
///     1/sqrt(pi kappa t) = 2/pi int_0^inf exp(-kappa s^2 t) ds,
/// a sum over waves cos(s z). In ln s the trapezoidal rule converges exponentially, so that few of them serve all times.
struct DepthWave
{
  double number = 0.0; ///< s [1/m]
  double weight = 0.0; ///< [1/m]
};

/// What the waves shall be good for.
struct DepthRange
{
  double shortest, longest; ///< times that heat is remembered for [s]
  double deepest = -1.0;    ///< of fields in the body [m]; negative: the temperature of the surface alone is wanted
};

/// The waves of one body, from the fastest to the slowest.
struct DepthWaves
{
  std::vector<DepthWave> waves; ///< the last one, of the number 0, stands for all that are slower than the one before
  double step = 0.0;            ///< of ln s
  bool has_fields = false;      ///< whether they are good for more than the temperature of the surface

  /// Those below a number.
  [[nodiscard]] DepthWaves slower_than(double number) const;
  /// Sum over the waves that the last one stands for of weight * k/(k^2 + s^2); 1 for k = 0.
  [[nodiscard]] double slow_share(double k) const;
  /// What waves faster than the first would add to a sum of terms that go with weight/s^power, in terms of the first one.
  [[nodiscard]] double beyond(int power) const;
};

/// For fields they go on beyond those that are left after a step, which tell of its own flux at its end.
/// @param finest  wavenumber along the surface beyond which there are none [1/m]; how far they go
[[nodiscard]] DepthWaves depth_waves(double diffusivity, const DepthRange& range, double finest);

/// Means of cos x and sin x over ln x that leave what a sum in equal steps of ln s can resolve: the same as long as x is small,
/// nothing where x turns from one wave to the next. Sums over waves then hold at any depth: docs/theory/heat.md (turned).
struct TurnedWave
{
  double cosine, sine; ///< the latter for sums that go with s ds
};
class TurnedWaves
{
public:
  /// @param step  of ln s
  explicit TurnedWaves(double step);
  /// The means at so many x, each smaller than the one before by the step of ln x: those of all waves at one depth.
  [[nodiscard]] std::vector<TurnedWave> operator()(double largest, std::size_t count) const;

private:
  /// A point of the path of integration, at equal distances in u: the weights of both means there.
  struct Point
  {
    std::complex<double> of_cosine, of_sine;
  };
  /// Points of the path in a step: so many, that what is asked for at all x of a series lies on one row of points.
  static constexpr std::size_t points_per_step = 10;
  double spacing_, first_; ///< of the points in u
  std::vector<Point> points_;
};

} // namespace brinell::halfspace
