// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/sym_tensor.hpp"

#include <optional>
#include <span>
#include <string>

/// Fatigue of one point from its history of stress: docs/theory/fatigue.md. No grids, no time: a cycle is a closed path of stresses.
namespace brinell::constitutive
{

/// Fatigue constants of a material.
struct Fatigue
{
  enum class Criterion
  {
    none, ///< shear amplitudes and life only
    dang_van,
    crossland,
    findley,
    fatemi_socie
  };
  Criterion criterion = Criterion::none;
  double torsion_limit = 0.0;           ///< t, amplitude of the shear endured in reversed torsion [Pa]
  double bending_limit = 0.0;           ///< b, amplitude of the stress endured in reversed bending [Pa]
  double stress_exponent = 31.0 / 3.0;  ///< c of Lundberg and Palmgren
  double weibull_slope = 10.0 / 9.0;    ///< e, of the scatter of lives
  double depth_exponent = 7.0 / 3.0;    ///< h
  double threshold = 0.0;               ///< shear amplitude below which nothing fails [Pa], Ioannides and Harris (1985)
  std::optional<double> reference = {}; ///< stress-volume per length at which the life is 1 [GPa^c mm^(2-h)]

  bool whole_map = false; ///< evaluate criteria of critical planes in all cells, not only in the worst ones

  bool operator==(const Fatigue&) const = default;
};

/// Why the limits of torsion and bending do not go together with the criterion; empty if they do.
[[nodiscard]] std::string reason_against(const Fatigue& fatigue);

/// Points of a cycle.
struct StressCycle
{
  std::span<const SymTensor> stress; ///< [Pa], tension positive
  /// Twice the shear modulus times the deviator of the total strain [Pa], of which Fatemi and Socie take the shear; empty: that of
  /// the stress.
  std::span<const SymTensor> strain = {};
};

/// A criterion, calibrated by the limits of torsion and bending.
class FatigueCriterion
{
public:
  /// @throws InternalError if there is a reason against it
  explicit FatigueCriterion(const Fatigue& fatigue);

  [[nodiscard]] Fatigue::Criterion kind() const { return kind_; }
  /// Weight of the hydrostatic stress (Dang Van, Crossland) or of the normal stress (Findley) [-]; of Fatemi and Socie [1/Pa].
  [[nodiscard]] double sensitivity() const { return sensitivity_; }
  /// Equivalent stress at the endurance limit [Pa]; 1 without a criterion.
  [[nodiscard]] double limit() const { return limit_; }
  /// Equivalent stress of a cycle over the limit: 1 is the endurance limit; below 0 where pressure prevails.
  [[nodiscard]] double utilisation(const StressCycle& cycle) const;

private:
  Fatigue::Criterion kind_;
  double sensitivity_ = 0.0, limit_ = 1.0;
};

/// Half the difference of the largest and the smallest principal stress [Pa].
[[nodiscard]] double principal_shear(const SymTensor& stress);

/// The smallest ball in the space of deviators that holds a path: its radius is sqrt(2) times the amplitude of sqrt(J2).
struct DeviatorBall
{
  SymTensor centre{};
  double radius = 0.0; ///< [Pa], to 1e-5
};
[[nodiscard]] DeviatorBall enclosing_ball(std::span<const SymTensor> stress);

} // namespace brinell::constitutive
