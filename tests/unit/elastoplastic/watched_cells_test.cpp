// SPDX-License-Identifier: BSD-3-Clause
#include "mirrored_grid.hpp"
#include "sphere_press.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

/// The state in single cells against the fields of the whole bodies, which are computed anew from the plastic strain.
namespace brinell::elastoplastic::watched_cells_test
{
namespace
{

/// In three layers, on both sides of the middle, twice in the same layer; one in the deepest layer.
std::vector<std::size_t> cells_of(const VolumeGrid& grid)
{
  return {grid.index(6, 6, 2), grid.index(3, 8, 2), grid.index(9, 2, 0), grid.index(6, 7, grid.nz - 1)};
}

/// Rounding: both are sums of as many numbers in another order.
constexpr double rounding = 1e-12;

void expect_as_the_fields(const std::vector<CoupledContact::CellState>& states, const CoupledContact::Stress& fields,
                          const BodyView& body, const std::vector<std::size_t>& cells)
{
  const std::size_t size = body.grid().size();
  double largest = 0.0;
  for (const double stress : fields.deviator)
    largest = std::max(largest, std::abs(stress));
  const std::vector<double> strain = body.field(&BodyState::plastic_strain);
  for (std::size_t n = 0; n < cells.size(); ++n)
  {
    const Deviator stress = deviator_at(fields.deviator, size, cells[n]), plastic = deviator_at(strain, size, cells[n]);
    for (int c = 0; c < Deviator::size; ++c)
    {
      EXPECT_NEAR(states[n].stress.deviator[c], stress[c], rounding * largest) << "cell " << n << ", component " << c;
      EXPECT_EQ(states[n].plastic_strain[c], plastic[c]);
    }
    EXPECT_NEAR(states[n].stress.trace, fields.trace[cells[n]], rounding * largest) << "cell " << n;
    EXPECT_EQ(states[n].equivalent, body.field(&BodyState::equivalent)[cells[n]]);
    EXPECT_FALSE(states[n].temperature);
  }
}

void expect_both(CoupledContact& contact, const Placement& placement)
{
  const std::vector<std::size_t> cells = cells_of(contact.lower().grid());
  const auto lower = contact.cells(0, placement.lower, cells), upper = contact.cells(1, placement.upper, cells);
  expect_as_the_fields(lower, contact.stress(0, placement.lower), contact.lower(), cells);
  expect_as_the_fields(upper, contact.stress(1, placement.upper), contact.upper(), cells);
}

TEST(WatchedCells, AreThoseOfTheFieldsFromTheFirstIncrementOn)
{
  for (const double friction : {0.0, 0.2})
  {
    PressOptions options;
    options.spare_columns = 4;
    options.friction.coefficient = friction;
    options.upper_plastic = false; // an elastic body has no strain, and takes another way
    options.hardening_modulus = 5e9;
    SpherePress press(options);
    for (const auto& [interference, offset] : {std::pair{2.0, 0}, {5.0, 1}, {6.0, 2}, {3.0, 2}})
    {
      ASSERT_TRUE(press.press(interference, Integration::path, offset).converged);
      expect_both(press.contact(), {{offset}, {offset}});
    }
    EXPECT_GT(press.contact().lower().solved().state().equivalent[press.volume().index(6, 6, 2)], 0.0);
  }
}

TEST(WatchedCells, NeedNoStressOfTheWholeBodyOnceAskedFor)
{
  SpherePress press;
  ASSERT_TRUE(press.press(4.0).converged);
  const std::vector<std::size_t> cells = cells_of(press.contact().lower().grid());
  (void)press.contact().cells(0, {}, cells);
  ASSERT_TRUE(press.press(6.0).converged);
  const CoupledContact::Stress fields = press.contact().stress(0, {});
  expect_as_the_fields(press.contact().cells(0, {}, cells), fields, press.contact().lower(), cells);
}

TEST(WatchedCells, SurviveAnIncrementThatFails)
{
  SpherePress press;
  ASSERT_TRUE(press.press(4.0).converged);
  const std::vector<std::size_t> cells = cells_of(press.contact().lower().grid());
  (void)press.contact().cells(0, {}, cells);
  ASSERT_TRUE(press.press(5.0).converged);
  Strategy hopeless;
  hopeless.max_evaluations = 1;
  ASSERT_FALSE(press.press(6.0, hopeless).converged);
  expect_as_the_fields(press.contact().cells(0, {}, cells), press.contact().stress(0, {}), press.contact().lower(),
                       cells);
}

TEST(WatchedCells, OfATwinAreThoseOfItsMirrorImage)
{
  PressOptions options;
  options.spare_columns = 6;
  const SpherePress sample(options);
  const SurfaceGrid grid{SpherePress::n, SpherePress::n, 4.6e-3, 4.6e-3};
  for (const bool is_mirrored : {false, true})
  {
    const VolumeGrid body = test::mirrored(sample.volume(), is_mirrored);
    CoupledContact contact(test::mirrored(grid, is_mirrored), body, body, sample.material(), sample.material(),
                           {SpherePress::alpha_c, 6.0 * SpherePress::alpha_c}, {}, Twin::mirror_image);
    for (const auto& [interference, column] : {std::pair{3.0, 0}, {6.0, 0}, {6.0, 1}})
    {
      const Placement placement{{3 + column}, {3 - column}};
      ASSERT_TRUE(contact.advance(sample.rigid_gap(interference), {}, placement, Strategy{}).converged);
      expect_both(contact, placement);
    }
  }
}

} // namespace
} // namespace brinell::elastoplastic::watched_cells_test
