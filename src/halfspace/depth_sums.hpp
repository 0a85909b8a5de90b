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
      odd_y; ///< kx, ky for what is odd in them: 0 for the shortest wave of an even number of cells, which cannot tell
};

/// The weights of the waves in depth at one depth, in the sums over them.
struct DepthFactors
{
  double depth; ///< [m]
  std::vector<double> temperature, potential, slope, at_surface;
};
[[nodiscard]] std::vector<DepthFactors> depth_factors(const DepthWaves& waves, std::span<const double> depths);
/// For what is wanted of the potential at the surface alone: nothing else is summed.
[[nodiscard]] DepthFactors surface_factors(const DepthWaves& waves);

/// The sums over the waves in depth at several depths, for one row of waves after the other.
///
/// All waves in depth of some neighbouring columns lie side by side. They are divided by k^2 + s^2 once, and up to four depths are
/// summed at a time in registers. What is nothing is left out: waves that turn so often down to a depth that their mean is nothing, and waves along the
/// surface that no heat has brought so deep, as at all times it is at most e^{-kz} of what has entered.
class DepthSums
{
public:
  /// @param factors  of all waves, of which `waves` are the last ones; for each depth, all of a kind
  /// @param left     of each of `waves` but the last one, what its heat is multiplied with
  DepthSums(std::span<const DepthWave> waves, std::span<const DepthFactors> factors, std::span<const double> left);

  /// One row of the waves along the surface, `lane_count` columns after the other: [block].
  struct Along
  {
    const Lanes* k;
    const Lanes* slow_share;  ///< of the potential, of the waves in depth that hardly turn: `DepthWaves::slow_share`
    const Lanes* left;        ///< what all sums are multiplied with
    const ComplexLanes* heat; ///< [block][wave]
  };
  /// Sums have real and imaginary parts in turn.
  struct Row
  {
    std::size_t pitch = 0;                               ///< of whole blocks
    Along along{};                                       ///< as it was given
    AlignedVector<ComplexLanes> integrated;              ///< heat divided by k^2 + s^2, [block][wave]
    AlignedVector<double> at_surface;                    ///< k psi, the same for all depths
    AlignedVector<double> temperature, potential, slope; ///< of depths together, [depth][pitch]; the potential times k
  };
  [[nodiscard]] Row make_row(std::size_t columns) const;
  /// Divides a row, and sums its potential at the surface.
  void gather(const Along& along, Row& row) const;

  static constexpr std::size_t together = 4;
  /// Sums of the depths from `first` on, at most `together`.
  /// @param columns  of the row that count
  void sum(std::size_t first, std::size_t columns, Row& row) const;

private:
  /// What one wave is multiplied with at depths together.
  struct Factors
  {
    std::array<double, together> temperature{}, potential{}, slope{};
  };
  struct Group
  {
    std::size_t first; ///< wave that does not turn too often at the least of the depths
    std::array<double, together> depths{};
    std::vector<Factors> factors;
  };
  std::size_t first_left_ = 0;                ///< faster waves have decayed
  std::vector<double> numbers2_, at_surface_; ///< of each wave but the last one
  double slow_weight_;                        ///< of that: it hardly turns, cos(s z) = 1, s sin(s z) = s^2 z
  std::vector<Group> groups_;
};

/// Waves along the surface that count at a depth are the first so many of a row.
[[nodiscard]] std::size_t columns_that_reach(double depth, std::span<const SurfaceWave> along);

/// e^{-kz} of a row of waves at one depth after the other: where they lie at equal distances, by one product each.
class DecayInDepth
{
public:
  explicit DecayInDepth(std::size_t columns) : decay_(columns), step_(columns) {}
  /// Begins a row.
  void begin() { columns_ = stepped_ = 0; }
  [[nodiscard]] std::span<const double> at(double depth, std::span<const SurfaceWave> along);

private:
  std::vector<double> decay_, step_;
  std::size_t columns_ = 0, stepped_ = 0; ///< that the values are known of
  double depth_ = 0.0, spacing_ = 0.0;
};

} // namespace brinell::halfspace
