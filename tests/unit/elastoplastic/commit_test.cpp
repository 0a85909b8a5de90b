// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/increment.hpp"

#include "brinell/foundation/error.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

/// An increment that fails leaves everything as it was, wherever it fails.
namespace brinell::elastoplastic::commit_test
{

namespace
{

constexpr double cell = 1e-5;                          // m
constexpr double interference = 3.2e-6, radius = 5e-3; // m; 13 cells to the contact radius, moderate yielding

constitutive::Material steel()
{
  constitutive::Material m{{210e9, 0.3}, constitutive::LinearHardening{600e6, 2e9}};
  m.thermal = Thermal{50.0, 7800.0, 460.0, 12e-6};
  return m;
}

/// Two bodies that rub and heat each other, on grids of n x n cells.
CoupledContact rubbing(int n)
{
  const SurfaceGrid surface{n, n, cell, cell};
  const VolumeGrid volume{surface, 8, cell};
  HeatedRun heat{{}, {1e-5, 1e-3}};
  heat.settings.stress = false; // nothing looks at the heat before the end of the increment
  return {surface,
          volume,
          volume,
          steel(),
          steel(),
          Scales{1e-6, interference},
          Settings{},
          Twin::none,
          {},
          0.0,
          {.friction = {0.2}, .heat = heat}};
}

IncrementReport advance(CoupledContact& contact, double pressed)
{
  const SurfaceGrid& g = contact.grid();
  std::vector<double> distance;
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
      distance.push_back((g.x(i) * g.x(i) + g.y(j) * g.y(j)) / (2.0 * radius));
  const contact::Drive drive{contact::Drive::Kind::approach, pressed};
  return contact.advance(distance, drive, {}, {}, {.slid = 1e-6, .duration = 1e-5, .moved = {0.0, -1e-6}});
}

Archive::Fields state_of(CoupledContact& contact)
{
  Archive archive;
  contact.exchange(archive);
  return std::move(archive).fields();
}

/// The thermal grids do not grow with the others, so that a contact may outgrow them. The heat of its friction, and of its plastic
/// work, is known only at the end of the increment.
TEST(Commit, NothingIsKeptOfAnIncrementWhoseHeatIsLost)
{
  CoupledContact small = rubbing(15);
  ASSERT_TRUE(advance(small, 0.15 * interference).converged);
  CoupledContact large = rubbing(75);
  large.continue_from(std::move(small).take_history());
  const Archive::Fields before = state_of(large);
  EXPECT_THROW(static_cast<void>(advance(large, interference)), GridError);
  const Archive::Fields after = state_of(large);
  ASSERT_EQ(before.size(), after.size());
  for (const auto& [name, values] : before)
    if (!name.ends_with("window_wishes")) // says when windows pay, and counts increments that fail, too
    {
      EXPECT_EQ(values, after.at(name)) << name;
    }
  EXPECT_TRUE(advance(large, 0.2 * interference).converged);
}

} // namespace

} // namespace brinell::elastoplastic::commit_test
