// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/sym_tensor.hpp"

#include <gtest/gtest.h>

namespace brinell::sym_tensor_test
{
namespace
{

TEST(SymTensorTest, Trace)
{
  EXPECT_EQ(trace({1.0, 2.0, 4.0, 8.0, 16.0, 32.0}), 7.0);
}

TEST(SymTensorTest, DeviatorHasNoTraceAndKeepsShear)
{
  const SymTensor s = deviator({3.0, 6.0, 9.0, 1.0, -2.0, 5.0});
  EXPECT_EQ(s, (SymTensor{-3.0, 0.0, 3.0, 1.0, -2.0, 5.0}));
}

TEST(SymTensorTest, DoubleContractionCountsOffDiagonalsTwice)
{
  EXPECT_EQ(double_contraction({1.0, 2.0, 3.0, 4.0, 5.0, 6.0}, {1.0, 1.0, 1.0, 1.0, 1.0, 1.0}), 6.0 + 2.0 * 15.0);
}

TEST(SymTensorTest, VonMisesOfSimpleStates)
{
  // Rounding of a few operations: 4 ulp, as EXPECT_DOUBLE_EQ has it.
  EXPECT_DOUBLE_EQ(von_mises({-250.0, 0.0, 0.0, 0.0, 0.0, 0.0}), 250.0);
  EXPECT_DOUBLE_EQ(von_mises({0.0, 0.0, 0.0, 0.0, 100.0, 0.0}), 100.0 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(von_mises({-7.0, -7.0, -7.0, 0.0, 0.0, 0.0}), 0.0);
}

} // namespace
} // namespace brinell::sym_tensor_test
