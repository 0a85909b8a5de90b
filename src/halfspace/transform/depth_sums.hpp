// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "depth_waves.hpp"
#include "foundation/aligned.hpp"
#include "foundation/lanes.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// One wave along the surface.
struct SurfaceWave
{
  double kx, ky, k; ///< [rad/m]
  double odd_x,
      odd_y; ///< kx, ky in factors that are odd in them: 0 for the Nyquist wave, whose sign is not defined
};

/// Weights of the waves in depth in the sums for one depth.
struct DepthFactors
{
  double depth; ///< [m]
  std::vector<double> temperature, potential, slope, at_surface;
};
[[nodiscard]] std::vector<DepthFactors> depth_factors(const DepthWaves& waves, std::span<const double> depths);
/// Weights for the potential at the surface only: nothing else is summed.
[[nodiscard]] DepthFactors surface_factors(const DepthWaves& waves);

/// Sums over the waves in depth at several depths, for one row of waves along the surface at a time.
///
/// All waves in depth of some neighbouring columns are contiguous in memory. They are divided by k^2 + s^2 once, and up to four
/// depths are summed at a time in registers. Negligible terms are skipped: waves in depth that oscillate so fast at a depth that
/// their mean is zero, and waves along the surface that do not reach a depth, as at all times at most e^{-kz} of the entered
/// heat is felt there.
class DepthSums
{
public:
  /// @param factors  one element per depth, either all with fields or all without; their weights are those of all waves, of which
  ///                 `waves` are the last ones
  /// @param left     factor on the heat of each of `waves` except the last one
  DepthSums(std::span<const DepthWave> waves, std::span<const DepthFactors> factors, std::span<const double> left);

  /// One row of the waves along the surface, in blocks of `lane_count` columns: [block].
  struct Along
  {
    const Lanes* k;
    const Lanes* slow_share;  ///< share of the slowest waves in depth in the potential: `DepthWaves::slow_share`
    const Lanes* left;        ///< factor on all sums
    const ComplexLanes* heat; ///< [block][wave]
  };
  /// Sums of one row; real and imaginary parts alternate.
  struct Row
  {
    std::size_t pitch = 0;                  ///< values from one depth to the next: whole blocks
    Along along{};                          ///< the argument of `gather`
    AlignedVector<ComplexLanes> integrated; ///< heat divided by k^2 + s^2, [block][wave]
    AlignedVector<double> at_surface;       ///< k psi, the same for all depths
    AlignedVector<double> temperature, potential,
        slope; ///< at up to `together` depths, [depth][pitch]; the potential times k
  };
  [[nodiscard]] Row make_row(std::size_t columns) const;
  /// Divides the heat of a row by k^2 + s^2 and sums its potential at the surface.
  void gather(const Along& along, Row& row) const;

  static constexpr std::size_t together = 4;
  /// Sums at the depths from the index `first` on, at most `together`.
  /// @param columns  number of columns of the row that are not negligible
  void sum(std::size_t first, std::size_t columns, Row& row) const;

private:
  /// Factors on one wave at up to `together` depths.
  struct Factors
  {
    std::array<double, together> temperature{}, potential{}, slope{};
  };
  struct Group
  {
    std::size_t first; ///< first wave that does not oscillate too fast at the smallest of the depths
    std::array<double, together> depths{};
    std::vector<Factors> factors;
  };
  std::size_t first_left_ = 0;                ///< first wave that has not decayed
  std::vector<double> numbers2_, at_surface_; ///< s^2 and weight at the surface of each wave except the last one
  double slow_weight_;                        ///< weight of the last wave, where cos(s z) = 1 and s sin(s z) = s^2 z
  std::vector<Group> groups_;
};

/// Number of waves at the beginning of a row that are not negligible at a depth.
[[nodiscard]] std::size_t columns_that_reach(double depth, std::span<const SurfaceWave> along);

/// e^{-kz} of a row of waves at successive depths: for equidistant depths, by one multiplication each.
class DecayInDepth
{
public:
  explicit DecayInDepth(std::size_t columns) : decay_(columns), step_(columns) {}
  /// Begins a row.
  void begin() { columns_ = stepped_ = 0; }
  [[nodiscard]] std::span<const double> at(double depth, std::span<const SurfaceWave> along);

private:
  std::vector<double> decay_, step_;
  std::size_t columns_ = 0, stepped_ = 0; ///< numbers of columns for which `decay_` and `step_` are up to date
  double depth_ = 0.0, spacing_ = 0.0;
};

} // namespace brinell::halfspace
