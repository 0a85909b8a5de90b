// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/deviator.hpp"

#include "random_field.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

namespace brinell::deviator_test
{
namespace
{

Deviator random_deviator(unsigned seed)
{
  return test::deviator_at(test::random_field(Deviator::size, seed), 0);
}

// Sums of ten products of order one.
constexpr double rounding = 1e-14;

TEST(DeviatorTest, ContractionIsThatOfTheFullTensors)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const Deviator a = random_deviator(2 * seed), b = random_deviator(2 * seed + 1);
    EXPECT_NEAR(contract(a, b), double_contraction(test::as_tensor(a), test::as_tensor(b)), rounding);
    EXPECT_NEAR(contract(a, b), contract(b, a), rounding);
    EXPECT_NEAR(von_mises(a), von_mises(test::as_tensor(a)), rounding);
  }
}

TEST(DeviatorTest, UniaxialStressHasItselfAsVonMises)
{
  EXPECT_NEAR(von_mises(Deviator{{2.0, -1.0, 0.0, 0.0, 0.0}}), 3.0, rounding);
  EXPECT_NEAR(von_mises(Deviator{{0.0, 0.0, 0.0, 0.0, 1.0}}), std::sqrt(3.0), rounding);
}

TEST(DeviatorTest, GoesToATensorAndBack)
{
  const Deviator d = random_deviator(3);
  const SymTensor t = to_tensor(d, 1.8);
  EXPECT_NEAR(trace(t), 1.8, rounding);
  for (int i = 0; i < Deviator::size; ++i)
    EXPECT_NEAR(to_deviator(t)[i], d[i], rounding);
  const SymTensor expected = test::as_tensor(d);
  const SymTensor traceless = to_tensor(d);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(traceless[i], expected[i]) << i;
}

TEST(DeviatorTest, IsALinearSpace)
{
  const Deviator a = random_deviator(1), b = random_deviator(2);
  const Deviator c = 2.0 * (a + b) - a;
  for (int i = 0; i < Deviator::size; ++i)
    EXPECT_NEAR(c[i], a[i] + 2.0 * b[i], rounding);
}

} // namespace
} // namespace brinell::deviator_test
