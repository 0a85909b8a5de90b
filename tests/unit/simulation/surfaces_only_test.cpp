// SPDX-License-Identifier: BSD-3-Clause
// Runs in which neither body can yield, with and without the fields within the bodies.
#include "brinell/foundation/error.hpp"
#include "brinell/simulation/run.hpp"
#include "template_cases.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace brinell::simulation::surfaces_only_test
{
namespace
{

/// The case of `brinell new`, of bodies that cannot yield.
template <typename Case>
Case elastic(bool fields_within)
{
  Case c = test::template_case<Case>();
  for (ShapedBody* body : {&c.lower, &c.upper})
    body->material.hardening.reset();
  c.fields_within = fields_within;
  return c;
}

template <typename Case>
class SurfacesOnlyTest : public testing::Test
{
};

TYPED_TEST_SUITE(SurfacesOnlyTest, Scenarios<testing::Types>);

TYPED_TEST(SurfacesOnlyTest, ThePlanHasOneLayer)
{
  const auto whole = plan(elastic<TypeParam>(true)), part = plan(elastic<TypeParam>(false));
  EXPECT_FALSE(whole.surfaces_only);
  EXPECT_TRUE(part.surfaces_only);
  EXPECT_EQ(part.lower.nz, 1);
  EXPECT_EQ(part.upper.nz, 1);
  EXPECT_EQ(part.contact, whole.contact);
  EXPECT_EQ(part.lower.surface, whole.lower.surface);
  EXPECT_EQ(part.lower.dz, whole.lower.dz);
  EXPECT_LT(part.memory_bytes, whole.memory_bytes);
}

TYPED_TEST(SurfacesOnlyTest, ABodyThatCanYieldNeedsItsFields)
{
  TypeParam c = test::template_case<TypeParam>();
  ASSERT_TRUE(c.lower.material.is_plastic() || c.upper.material.is_plastic());
  const auto expected = plan(c);
  c.fields_within = false;
  const auto found = plan(c);
  EXPECT_FALSE(found.surfaces_only);
  EXPECT_EQ(found.lower, expected.lower);
  EXPECT_EQ(found.upper, expected.upper);
  EXPECT_EQ(found.memory_bytes, expected.memory_bytes);
}

TYPED_TEST(SurfacesOnlyTest, StepsAndSurfacesAreTheSame)
{
  Run<TypeParam> whole(elastic<TypeParam>(true)), part(elastic<TypeParam>(false));
  while (!whole.is_done())
  {
    ASSERT_FALSE(part.is_done());
    const auto& expected = whole.step();
    const auto& found = part.step();
    EXPECT_EQ(found.work, expected.work);
    EXPECT_EQ(found.F_n, expected.F_n);
    EXPECT_EQ(found.contact_area, expected.contact_area);
    EXPECT_EQ(found.energy_elastic, expected.energy_elastic);
    EXPECT_EQ(found.evaluations, expected.evaluations);
  }
  EXPECT_TRUE(part.is_done());
  const Snapshot expected = whole.snapshot(), found = part.snapshot();
  EXPECT_EQ(found.pressure, expected.pressure);
  EXPECT_EQ(found.gap, expected.gap);
  EXPECT_EQ(found.shear, expected.shear);
  EXPECT_EQ(found.lower.residual_displacement, expected.lower.residual_displacement);
  EXPECT_EQ(found.lower.height, expected.lower.height);
  EXPECT_FALSE(expected.lower.stress[0].empty());
  EXPECT_TRUE(found.lower.stress[0].empty());
  EXPECT_TRUE(found.lower.equivalent_plastic_strain.empty());
}

// The plan does not change a run that is given it.
TYPED_TEST(SurfacesOnlyTest, APlanThatIsKnownIsTaken)
{
  const auto c = elastic<TypeParam>(false);
  const auto known = plan(c);
  Run<TypeParam> given(c, {}, nullptr, known), made(c);
  EXPECT_EQ(given.step().F_n, made.step().F_n);
  EXPECT_EQ(given.summary().memory_bytes, made.summary().memory_bytes);
}

/// A flat period of so many cells that a body of many layers would have too many.
TEST(SurfacesOnly, TheLayersThatThereAreNotDoNotCount)
{
  IndentationCase c;
  c.lower = {Plane{}, {{210e9, 0.3}, {}}};
  c.upper = {Paraboloid{1e-3, 1e-3}, {{210e9, 0.3}, {}}};
  c.sequence = {{contact::Drive::Kind::load, 10.0}};
  c.resolution = 800.0;
  EXPECT_THROW((void)plan(c), GridError);
  c.fields_within = false;
  EXPECT_EQ(plan(c).lower.nz, 1);
}

} // namespace
} // namespace brinell::simulation::surfaces_only_test
