// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/symmetry.hpp"
#include "foundation/aligned.hpp"
#include "foundation/lanes.hpp"
#include "halfspace/image_samples.hpp"

#include <array>
#include <vector>

namespace brinell::halfspace
{

/// What MomentCoupling is to polynomials in two distances, of waves along one axis times polynomials of the distance y - y' across it:
/// the waves do not couple, so they lie in lanes. Both the cosines and the sines of a wave are multiplied by the same.
class WaveCoupling
{
public:
  /// @param depths  number of the functions of depth
  /// @param odd     whether a component changes its sign if y is mirrored
  WaveCoupling(int waves, int depths, int degree, const std::array<int, images::stresses>& odd);

  /// Sets the term (y - y')^b of one wave in the stress `c` of the strain `e`, which is there for b even (odd) where both components
  /// are of like (unlike) parity. Threads may set terms of unlike waves at the same time.
  /// @param value  [function of z][function of z']
  void set(int wave, int c, int e, int b, double factor, const Eigen::MatrixXd& value);

  [[nodiscard]] int parts() const { return parts_; } ///< of the waves, each as many as there are lanes

  /// Multiplies the moments of the waves of one part, [component][power][depth]; those of the stress must be zero before. Moments
  /// have to be weighted by `of_strain` before, and by `of_stress` after.
  /// @param symmetry    with one, the moments that are odd across the axis are zero
  /// @param components  of the stress that are wanted, the first ones
  void multiply(int part, const ComplexLanes* strain, Symmetry symmetry, int components, ComplexLanes* stress) const;
  [[nodiscard]] static double of_strain(int power) { return (power % 2 == 0 ? 1.0 : -1.0) / images::factorial(power); }
  [[nodiscard]] static double of_stress(int power) { return 1.0 / images::factorial(power); }

private:
  /// Of one term, [depth of stress][depth of strain].
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
