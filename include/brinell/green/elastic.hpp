// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace brinell
{

/// Constants of an isotropic linear elastic body; rigid if Young's modulus is infinite.
struct Elastic
{
  double young_modulus = 0.0; ///< E [Pa], > 0
  double poisson_ratio = 0.0; ///< nu [-], -1 < nu < 0.5

  /// Shear modulus mu = E / (2 (1 + nu)) [Pa].
  [[nodiscard]] double shear_modulus() const { return young_modulus / (2.0 * (1.0 + poisson_ratio)); }
  /// Contact compliance of one half space (1 - nu^2) / E [1/Pa].
  [[nodiscard]] double contact_compliance() const { return (1.0 - poisson_ratio * poisson_ratio) / young_modulus; }
  [[nodiscard]] bool is_rigid() const { return std::isinf(young_modulus); }
  bool operator==(const Elastic&) const = default;
};

/// Contact modulus E' of two bodies, 1/E' = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 [Pa] (Johnson 1985, Eq. 4.4).
[[nodiscard]] inline double contact_modulus(const Elastic& body1, const Elastic& body2)
{
  return 1.0 / (body1.contact_compliance() + body2.contact_compliance());
}

} // namespace brinell
