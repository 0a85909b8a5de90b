// SPDX-License-Identifier: BSD-3-Clause
// The trials of a body's active cells.
#include "brinell/elastoplastic/body.hpp"
#include "sphere_press.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace brinell::elastoplastic::body_test
{
namespace
{

Deviator deviator_of(const std::vector<double>& values, std::size_t a)
{
  Deviator d;
  std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(a * Deviator::size), Deviator::size, d.v.begin());
  return d;
}

TEST(BodyTest, ACellThatJoinsBeginsOnItsYieldSurface)
{
  // It has not flowed in this evaluation, so that its residual is what the stress has beyond the yield surface.
  const SpherePress press;
  const VolumeGrid grid = press.volume();
  const constitutive::Material material = press.material();
  Body body(grid, std::make_shared<const halfspace::HalfSpace>(grid, material.elastic), material);
  std::vector<double> pressure(grid.surface.size(), 0.0), none(grid.surface.size(), 0.0);
  for (int j = -2; j <= 2; ++j)
    for (int i = -2; i <= 2; ++i)
      pressure[grid.surface.index(grid.surface.nx / 2 + i, grid.surface.ny / 2 + j)] = 2.5 * SpherePress::yield_stress;
  body.begin(0, 0.6);
  ASSERT_TRUE(body.active().empty());
  ASSERT_EQ(body.integrate(Integration::path), 0.0);
  ASSERT_TRUE(body.update({.pressure = pressure, .shear_x = none, .shear_y = none}));
  const std::size_t cells = body.active().size();
  ASSERT_GT(cells, 20U);
  for (std::size_t a = 0; a < cells; ++a)
  {
    const Deviator trial = deviator_of(body.trial(), a), stress = deviator_of(body.active().mapped(), a);
    EXPECT_NEAR(von_mises(trial) / SpherePress::yield_stress, 1.0, 1e-12);
    EXPECT_GT(von_mises(stress), SpherePress::yield_stress);
    EXPECT_NEAR(von_mises(stress - trial), von_mises(stress) - SpherePress::yield_stress,
                1e-12 * SpherePress::yield_stress);
  }
}

} // namespace
} // namespace brinell::elastoplastic::body_test
