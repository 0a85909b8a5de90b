// SPDX-License-Identifier: BSD-3-Clause
// Softening around a spot through which current flows, against the potential of a disc.
#include "brinell/contact/constriction.hpp"
#include "brinell/foundation/error.hpp"
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

/// Two bodies that soften linearly by 1 in 1000 K, in contact on a disc.
struct Disc
{
  static constexpr double cell = 1e-6, radius = 8.0 * cell, resistivity = 1e-7, conductivity = 60.0;
  SurfaceGrid contact;
  VolumeGrid body;
  constitutive::Material material{.elastic = {200e9, 0.3}, .hardening = constitutive::PerfectPlasticity{1e9}};
  double modulus;
  std::vector<double> pressure, gap;

  explicit Disc(int n, Boundary boundary = Boundary::open)
      : contact{.nx = n, .ny = n, .dx = cell, .dy = cell, .boundary_x = boundary, .boundary_y = boundary}, body{contact,
                                                                                                                12,
                                                                                                                cell},
        modulus(contact_modulus(material.elastic, material.elastic)), pressure(contact.size()), gap(contact.size())
  {
    material.softening = constitutive::LinearSoftening{.reference = 20.0, .melting_point = 1020.0};
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        pressure[contact.index(i, j)] = distance(i, j) < radius ? 1e9 : 0.0;
  }
  [[nodiscard]] double distance(int i, int j) const
  {
    const int middle = (contact.nx - 1) / 2;
    return cell * std::hypot(i - middle, j - middle);
  }
  /// Softening of the lower body under the middle of the disc [K].
  [[nodiscard]] double rise(const std::vector<double>& factors, int k) const
  {
    const int middle = (contact.nx - 1) / 2;
    return 1000.0 * (1.0 - factors.at(body.index(middle, middle, k)));
  }
};

TEST(SpotSoftening, UnderABadFilmIsThatOfAUniformFluxOfHeat)
{
  // Through a film of large resistance the current is uniform, and half of its heat enters each body: on the axis of the disc
  // T = T_0 + q/k (sqrt(a^2 + z^2) - z).
  const Disc disc(41);
  const halfspace::SurfaceCompliance compliance(disc.contact, disc.modulus);
  contact::Constriction constriction(compliance, disc.modulus);
  const double film = 1e4 * Disc::resistivity * Disc::radius, voltage = 0.5;
  const std::vector<double> layer(disc.contact.size(), film);
  const contact::Flow flow = constriction.flow({disc.pressure, disc.gap}, 2.0 * Disc::resistivity, layer);
  std::vector<double> density(flow.density), source(density.size());
  for (std::size_t i = 0; i < density.size(); ++i)
  {
    density[i] *= voltage;
    source[i] = film * density[i] * density[i];
  }
  const contact::Conductor conductor{Disc::resistivity, Disc::conductivity, 20.0};
  const auto heat = constriction.heat(disc.pressure, density, source, {conductor, conductor});
  const SpotSoftening softening(disc.contact, {disc.body, disc.body}, {&disc.material, &disc.material},
                                2.0 * Disc::resistivity);
  const double q = 0.5 * voltage * voltage / film, a = Disc::radius;
  for (const std::size_t side : {0u, 1u})
  {
    const std::vector<double> factors =
        softening.factors(side, {}, density, heat.flux.at(side), Disc::resistivity,
                          {.resistivity = Disc::resistivity, .conductivity = Disc::conductivity, .temperature = 20.0});
    for (int k = 0; k < disc.body.nz; ++k)
    {
      const double z = (k + 0.5) * Disc::cell;
      EXPECT_NEAR(disc.rise(factors, k), q / Disc::conductivity * (std::hypot(a, z) - z),
                  0.03 * q / Disc::conductivity * a)
          << z;
    }
  }
}

TEST(SpotSoftening, OverAPeriodIsThatOfTheOpenContactLessTheOtherDiscs)
{
  // Discs in a square of side L have on each other the potential -3.9002 Q/(2 pi L) of the other charges Q without the mean
  // (Bonsall and Maradudin 1977), the share -3.9002 (2/pi) a/L = -c of their own: with s that of the disc alone, the share of the
  // potential is (s - c)/(1 - c), up to terms of second order in a/L.
  const contact::HotConductor conductor{.resistivity = Disc::resistivity, .conductivity = Disc::conductivity};
  const std::array bodies{conductor, conductor};
  const contact::HotContact hot = contact::hot_contact(bodies, 0.1);
  const double peak = hot.temperature - 20.0;
  const auto shares = [&](const Disc& disc) // from the rise peak (1 - (1 - s)^2)
  {
    const halfspace::SurfaceCompliance compliance(disc.contact, disc.modulus);
    contact::Constriction constriction(compliance, disc.modulus);
    const contact::Flow flow = constriction.flow({disc.pressure, disc.gap}, 2.0 * Disc::resistivity, {});
    const SpotSoftening softening(disc.contact, {disc.body, disc.body}, {&disc.material, &disc.material},
                                  2.0 * Disc::resistivity);
    const std::vector<double> factors = softening.factors(0, {}, flow.density, bodies, hot);
    std::vector<double> all;
    for (int k = 0; k < disc.body.nz; ++k)
      all.push_back(1.0 - std::sqrt(std::max(0.0, 1.0 - disc.rise(factors, k) / peak)));
    return all;
  };
  const std::vector<double> open = shares(Disc(61));
  double before = 1.0;
  for (const int n : {61, 121, 241})
  {
    const std::vector<double> periodic = shares(Disc(n, Boundary::periodic));
    const double others = 3.9002 * 2.0 / std::numbers::pi * Disc::radius / (n * Disc::cell);
    double apart = 0.0;
    for (std::size_t k = 0; k < open.size(); ++k)
      apart = std::max(apart, std::abs(periodic[k] - (open[k] - others) / (1.0 - others)));
    EXPECT_LT(apart, 0.4 * before) << n;
    before = apart;
  }
  EXPECT_LT(before, 0.01);
}

TEST(SpotSoftening, RefusesOnePeriod)
{
  SurfaceGrid grid{
      .nx = 8, .ny = 8, .dx = 1e-6, .dy = 1e-6, .boundary_x = Boundary::open, .boundary_y = Boundary::periodic};
  EXPECT_THROW(halfspace::SpreadingField(grid, {1e-6}), InputError);
}

} // namespace
} // namespace brinell::elastoplastic::spot_softening_test
