// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/aligned.hpp"
#include "foundation/lanes.hpp"
#include "image_samples.hpp"

#include <array>
#include <vector>

namespace brinell::halfspace
{

/// The analogue of MomentCoupling for kernels that are sums of waves along one axis times polynomials of the distance y - y'
/// across it. The waves do not couple, so neighbouring waves are processed in lanes; cosine and sine of a wave have the same
/// factors.
class WaveCoupling
{
public:
  /// @param depths  number of functions of depth
  /// @param odd     1 for components that change their sign if y is mirrored, otherwise 0
  WaveCoupling(int waves, int depths, int degree, const std::array<int, images::stresses>& odd);

  /// Sets the term (y - y')^b of one wave in the stress component `c` by the strain component `e`. b must be even if both
  /// components have the same parity, otherwise odd. Different threads may set terms of different waves concurrently.
  /// @param value  [function of z][function of z']
  void set(int wave, int c, int e, int b, double factor, const Matrix& value);

  [[nodiscard]] int parts() const { return parts_; } ///< number of groups of `lane_count` waves

  /// Multiplies the moments of the waves of one part, [component][power][depth]; `stress` must be zero on entry. The moments of
  /// the strain must have been multiplied by `of_strain`, and the result must still be multiplied by `of_stress`.
  /// @param is_mirrored  if the fields are mirror images about y = 0, moments that vanish are skipped
  /// @param components  number of components of the stress that are computed, from the first one
  void multiply(int part, const ComplexLanes* strain, bool is_mirrored, int components, ComplexLanes* stress) const;
  [[nodiscard]] static double of_strain(int power) { return (power % 2 == 0 ? 1.0 : -1.0) / images::factorial(power); }
  [[nodiscard]] static double of_stress(int power) { return 1.0 / images::factorial(power); }

private:
  /// Index into `value_` of the matrix [depth of stress][depth of strain] of one term.
  [[nodiscard]] std::size_t place(int c, int e, int b, int part) const
  {
    return static_cast<std::size_t>((((c * images::strains + e) * (degree_ / 2 + 1) + b / 2) * parts_ + part) *
                                    depths_ * depths_);
  }
  [[nodiscard]] int parity(int c, int e) const { return images::is_odd(odd_, c, e) ? 1 : 0; }

  int parts_, depths_, degree_;
  std::array<int, images::stresses> odd_;
  AlignedVector<double> value_; ///< waves in lanes
};

} // namespace brinell::halfspace
