// SPDX-License-Identifier: BSD-3-Clause
// Softening around a spot through which current flows, against the potential of a disc.
#include "brinell/contact/constriction.hpp"
#include "elastoplastic/interface/spot_softening.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace brinell::elastoplastic::spot_softening_test
{
namespace
{

TEST(SpotSoftening, IsThatOfTheTemperatureUnderADisc)
{
  // On the axis of a disc at one potential that is 0 far away it is (2/pi) atan(a/z); equal bodies of constant properties have
  // T = T_0 + V^2/(8 rho k) (1 - (1 - s)^2) where the potential has gone the share s from its value far away.
  constexpr int n = 41;
  constexpr double cell = 1e-6, a = 8.0 * cell, voltage = 0.1, resistivity = 1e-7, conductivity = 60.0;
  const SurfaceGrid contact{.nx = n, .ny = n, .dx = cell, .dy = cell};
  const VolumeGrid body{contact, 24, cell};
  constitutive::Material material{.elastic = {200e9, 0.3}, .hardening = constitutive::PerfectPlasticity{1e9}};
  const constitutive::LinearSoftening law{.reference = 20.0, .melting_point = 1020.0};
  material.softening = law;

  const double modulus = contact_modulus(material.elastic, material.elastic);
  const halfspace::SurfaceCompliance compliance(contact, modulus);
  contact::Constriction constriction(compliance, modulus);
  std::vector<double> pressure(contact.size()), gap(contact.size());
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      pressure[contact.index(i, j)] = std::hypot(contact.x(i), contact.y(j)) < a ? 1e9 : 0.0;
  const contact::Flow flow = constriction.flow({pressure, gap}, 2.0 * resistivity, {});

  const contact::HotConductor conductor{.resistivity = resistivity, .conductivity = conductivity};
  const std::array bodies{conductor, conductor};
  const contact::HotContact hot = contact::hot_contact(bodies, voltage);
  const SpotSoftening softening(contact, {body, body}, {&material, &material}, 2.0 * resistivity);
  const double peak = voltage * voltage / (8.0 * resistivity * conductivity);
  for (const std::size_t side : {0u, 1u})
  {
    const std::vector<double> factors = softening.factors(side, {}, flow.density, bodies, hot);
    ASSERT_EQ(factors.size(), body.size());
    for (int k = 0; k < body.nz; ++k)
    {
      const double z = (k + 0.5) * cell, s = 2.0 / std::numbers::pi * std::atan(a / z);
      const double rise = peak * (1.0 - (1.0 - s) * (1.0 - s));
      // The radius of the disc of cells is uncertain by some per cent of itself.
      EXPECT_NEAR(1000.0 * (1.0 - factors[body.index((n - 1) / 2, (n - 1) / 2, k)]), rise, 0.03 * peak) << z;
    }
  }
  EXPECT_NEAR(contact::temperature_in(bodies, hot, 0, 1.0), 20.0 + peak, 1e-6 * peak);
  EXPECT_NEAR(contact::temperature_in(bodies, hot, 1, 0.5), 20.0 + 0.75 * peak, 1e-6 * peak);
  EXPECT_NEAR(contact::temperature_in(bodies, hot, 1, 0.0), 20.0, 1e-9);
}

} // namespace
} // namespace brinell::elastoplastic::spot_softening_test
