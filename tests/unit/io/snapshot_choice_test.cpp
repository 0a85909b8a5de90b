// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/snapshot_choice.hpp"

#include <gtest/gtest.h>

namespace brinell::io::snapshot_choice_test
{

namespace
{

/// Steps that are stored of passes with the given X.
std::vector<int> stored(SnapshotRule rule, const std::vector<std::vector<double>>& passes)
{
  SnapshotChoice choice(std::move(rule));
  std::vector<int> steps;
  simulation::TuggingRecord record;
  for (record.pass = 0; record.pass < static_cast<int>(passes.size()); ++record.pass)
    for (const double X : passes[static_cast<std::size_t>(record.pass)])
    {
      record.X = X;
      if (choice(simulation::TuggingCase{}, record))
        steps.push_back(record.step);
      ++record.step;
    }
  return steps;
}

using Kind = SnapshotRule::Kind;
const std::vector<double> through_zero{-2.0, -1.0, 0.0, 1.0, 2.0};

TEST(SnapshotChoice, PlainRules)
{
  EXPECT_EQ(stored({.kind = Kind::none}, {through_zero}), (std::vector<int>{}));
  EXPECT_EQ(stored({.kind = Kind::all}, {through_zero}), (std::vector{0, 1, 2, 3, 4}));
  EXPECT_EQ(stored({.kind = Kind::every, .every = 3}, {through_zero, through_zero}), (std::vector{0, 3, 6, 9}));
  EXPECT_EQ(stored({.kind = Kind::listed, .steps = {1, 4, 77}}, {through_zero}), (std::vector{1, 4}));
}

TEST(SnapshotChoice, StepsThatARunDoesNotHaveAreTold)
{
  const SnapshotRule rule{.kind = Kind::listed, .steps = {1, 4, 77, 99}};
  EXPECT_FALSE(missing_steps(rule, 99));
  EXPECT_FALSE(missing_steps({.kind = Kind::every, .every = 3}, 1));
  ASSERT_TRUE(missing_steps(rule, 76));
  EXPECT_EQ(missing_steps(rule, 76)->text,
            "output.snapshots asks for the fields of steps 77, 99, but the last step is 76");
}

TEST(SnapshotChoice, AlignedIsTheNearestStepOfEachPass)
{
  const SnapshotRule aligned;
  EXPECT_EQ(stored(aligned, {through_zero, through_zero}), (std::vector{2, 7}));
  EXPECT_EQ(stored(aligned, {{-1.4, -0.4, 0.6, 1.6}}), (std::vector{1})); // before zero
  EXPECT_EQ(stored(aligned, {{-1.6, -0.6, 0.4, 1.4}}), (std::vector{2})); // behind it
  EXPECT_EQ(stored(aligned, {{-1.5, -1e-17, 1.5}}), (std::vector{1}));    // round-off
  EXPECT_EQ(stored(aligned, {{0.5, 1.5}}), (std::vector{0}));
  EXPECT_EQ(stored(aligned, {{-3.0, -2.0}}), (std::vector<int>{}));
}

} // namespace

} // namespace brinell::io::snapshot_choice_test
