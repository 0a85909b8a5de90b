// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/frictional_contact.hpp"

#include "brinell/foundation/error.hpp"
#include "shear_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

/// Normal and tangential problem at once.
namespace brinell::contact::frictional_contact_test
{
namespace
{

using Kind = TangentialDrive::Kind;

TEST(FrictionalContactTest, OfDissimilarBodiesMeetsBothProblemsAtOnce)
{
  // Pressed, then pushed: gap and slip are recomputed from pressure and shears of all steps.
  const SurfaceGrid g{31, 27, 0.08, 0.09};
  const Elastic soft{1.0, 0.1}, hard{20.0, 0.3};
  const halfspace::SurfaceCompliance tractions(g, soft, hard);
  FrictionalContact contact(tractions);
  Field distance(g.size()), gap(g.size());
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
      distance[g.index(i, j)] = 0.5 * (std::pow(g.x(i), 2) + std::pow(g.y(j), 2)) / 10.0;
  FrictionState state(g.size());
  Fields slip(g.size());
  const double friction = 0.4;
  FrictionTolerances tolerances;
  tolerances.gap = 1e-9;
  tolerances.slip = 1e-9;
  FrictionReport report;
  Fields u(g.size()), before(g.size());
  for (const double load : {0.03, 0.06, 0.1})
  {
    before = u;
    report = contact.step(distance, {Drive::Kind::load, load},
                          {{Kind::force, load == 0.1 ? 0.5 * friction * load : 0.0}, {Kind::force, 0.0}, 0.0}, friction,
                          tolerances, state, gap, slip.out());
    ASSERT_TRUE(report.converged);
    EXPECT_GT(report.alternations, 1);
    Field lowered(g.size());
    tractions.apply({state.pressure, state.shear_x, state.shear_y}, {lowered, u.x, u.y});
    for (std::size_t i = 0; i < g.size(); ++i)
    {
      const double expected = distance[i] + lowered[i] - report.normal.approach;
      EXPECT_NEAR(gap[i], expected, 1e-12);
      EXPECT_GE(expected, -2.1 * tolerances.gap);
      if (state.pressure[i] > 0.0)
      {
        EXPECT_NEAR(expected, 0.0, 2.1 * tolerances.gap);
        EXPECT_LE(std::hypot(state.shear_x[i], state.shear_y[i]), friction * state.pressure[i] * (1.0 + 1e-12));
        EXPECT_NEAR(slip.x[i], report.tangential.shift[0] - (u.x[i] - before.x[i]), 1e-9);
      }
    }
  }
  EXPECT_NEAR(total(state.shear_x, g.cell_area()), 0.5 * friction * 0.1, 1e-12);
  EXPECT_GT(state.dissipated, 0.0);
  EXPECT_THROW((void)contact.step(distance, {}, {}, -0.1, tolerances, state, gap, slip.out()), InputError);
}

TEST(FrictionalContactTest, ABallIsPressedOnAnUnlikeFlatInAFewIterations)
{
  // At the rim a few cells have to cross their disc, at a step or a turn that is not known before. Part of the way back then led
  // to the same place again and again, for hundreds of iterations or until the last one allowed.
  struct Case
  {
    double friction, poisson_ratio, young_modulus;
  };
  for (const Case& c : {Case{0.3, 0.3, 1.0 / 3.0}, {0.3, 0.1, 0.2}, {0.3, 0.17, 1.0 / 3.0}, {0.6, 0.1, 1.0 / 3.0}})
    for (const int cells : {36, 37})
    {
      const SurfaceGrid g{cells, cells, 1.0 / 12.0, 1.0 / 12.0};
      const Elastic stiff{1.0, 0.3}, soft{c.young_modulus, c.poisson_ratio};
      const halfspace::SurfaceCompliance tractions(g, stiff, soft);
      FrictionalContact contact(tractions);
      Field distance(g.size()), gap(g.size());
      for (int j = 0; j < g.ny; ++j)
        for (int i = 0; i < g.nx; ++i)
          distance[g.index(i, j)] = 0.5 * (std::pow(g.x(i), 2) + std::pow(g.y(j), 2)) / 100.0;
      const double last_load = 4.0 / 3.0 * contact_modulus(stiff, soft) / 100.0; // of a radius of 12 cells
      FrictionState state(g.size());
      Fields slip(g.size());
      FrictionTolerances tolerances;
      tolerances.gap = tolerances.slip = 1e-10;
      tolerances.max_iterations = 30; // of each turn: most need fewer than 10
      for (int step = 1; step <= 10; ++step)
      {
        const FrictionReport report = contact.step(distance, {Drive::Kind::load, last_load * step / 10.0}, {},
                                                   c.friction, tolerances, state, gap, slip.out());
        EXPECT_TRUE(report.converged) << c.friction << ' ' << cells << " step " << step << " turn "
                                      << report.alternations << ": " << report.tangential.slip_error << " m";
      }
    }
}

} // namespace
} // namespace brinell::contact::frictional_contact_test
