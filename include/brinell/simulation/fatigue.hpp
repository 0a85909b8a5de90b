// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

/// Results of fatigue of one body: docs/theory/fatigue.md.
namespace brinell::simulation
{

/// State of a point after several cycles.
enum class Shakedown
{
  elastic,           ///< never yielded
  elastic_shakedown, ///< has yielded, and does not do so any more
  plastic_shakedown, ///< yields in each cycle, to and fro
  ratchetting        ///< plastic strain that grows
};

struct Plan;
struct ShapedBody;

/// Samples of a whole body that the history of a cycle may take in memory.
inline constexpr int fatigue_samples = 48;

/// Criteria of critical planes are evaluated in cells that may reach this share of the largest utilisation, unless all are asked
/// for.
inline constexpr double fatigue_map_share = 0.9;

/// A field on the cells of a body.
struct FatigueField
{
  std::string_view name, unit, text;
};

/// Fields of fatigue, in the order of `FatigueFields`. The last one exists only with a criterion.
inline constexpr std::array<FatigueField, 8> fatigue_fields{{
    {"fatigue_orthogonal_shear", "Pa", "amplitude of the shear xz or yz in the last cycle, the larger one"},
    {"fatigue_principal_shear", "Pa", "largest principal shear stress in the last cycle"},
    {"fatigue_mean_stress", "Pa", "mean of the largest and smallest hydrostatic stress in the last cycle"},
    {"fatigue_hydrostatic_stress", "Pa", "largest hydrostatic stress in the last cycle"},
    {"fatigue_plastic_strain", "1", "equivalent plastic strain accumulated in the last cycle"},
    {"fatigue_ratchetting", "1", "equivalent of the plastic strain by which the last cycle fails to close"},
    {"fatigue_shakedown", "1", "0: elastic, 1: elastic shakedown, 2: plastic shakedown, 3: ratchetting"},
    {"fatigue_utilisation", "1", "equivalent stress of the criterion over its limit"},
}};

/// Values of each of `fatigue_fields` in all cells.
using FatigueFields = std::array<std::vector<double>, fatigue_fields.size()>;

/// The largest value of a field, and the centre of its cell.
struct FatiguePlace
{
  double value = 0.0;
  double x = 0.0, y = 0.0, depth = 0.0; ///< in the coordinates of the body [m]
  bool is_at_edge = false;              ///< of the grid of the body, other than its surface
};

/// Key numbers of the fatigue of one body. Where the contact travels, they are those of the part over which it passes as a whole.
struct FatigueSummary
{
  int cycle = 0; ///< judged, counts from 1
  FatiguePlace orthogonal_shear, principal_shear;
  std::optional<FatiguePlace> utilisation;      ///< none without a criterion
  double plastic_strain = 0.0;                  ///< largest of the cycle
  double ratchetting = 0.0;                     ///< largest of the cycle
  std::array<double, 4> shares{};               ///< of the cells in each state of `Shakedown`
  double first_column = 0.0, last_column = 0.0; ///< centres of the first and last column judged [m]
  /// Stress-volume per length of the track [GPa^c mm^(2-h)]; NaN where the contact does not travel.
  double stress_volume = std::numeric_limits<double>::quiet_NaN();
  /// Life over that of a track with the reference; NaN if there is none.
  double life = std::numeric_limits<double>::quiet_NaN();
  bool is_own_reference = false;     ///< the life is that over the median of the same track
  double share_of_first_layer = 0.0; ///< of the stress-volume
  bool is_short = false;             ///< the contact travels, but has passed no column as a whole: all are judged
  double judged_share = 1.0;         ///< of the cells for which the criterion was evaluated
  /// Bound for the error of any shear amplitude because samples of the history were left out or shared, over the largest
  /// orthogonal shear.
  double path_error = 0.0;

  /// The worst state of `Shakedown` of any cell that was judged.
  [[nodiscard]] Shakedown worst() const
  {
    for (int state = 3; state > 0; --state)
      if (shares[static_cast<std::size_t>(state)] > 0.0)
        return static_cast<Shakedown>(state);
    return Shakedown::elastic;
  }
};

/// Memory that the fatigue of both bodies takes [bytes]; 0 without.
[[nodiscard]] double memory_of_fatigue(const Plan& plan, const ShapedBody& lower, const ShapedBody& upper);

} // namespace brinell::simulation
