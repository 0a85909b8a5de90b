// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/motion/indent.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace brinell::simulation::indent_test
{
namespace
{

IndentationRecord at(double approach, double load)
{
  IndentationRecord r;
  r.approach = approach;
  r.F_n = load;
  r.mean_pressure = 2.0 * load;
  r.residual_depth = 0.1;
  r.mean_gap = std::nan(""); // not periodic
  return r;
}

/// Loads along P = 3 h^2, unloads along P = 12 (h - 0.5)^2 from h = 1.
Indent squares(const std::vector<double>& loading, const std::vector<double>& unloading)
{
  IndentReader reader(0.25, 1, 0.0);
  for (const double h : loading)
    (void)reader.add(at(h, 3.0 * h * h), 0.0);
  for (const double h : unloading)
    (void)reader.add(at(h, 12.0 * (h - 0.5) * (h - 0.5)), 0.5);
  return reader.result();
}

TEST(IndentTest, StiffnessIsTheSlopeAtThePeak)
{
  const Indent i = squares({0.25, 0.5, 0.75, 1.0}, {0.9, 0.7, 0.5});
  EXPECT_DOUBLE_EQ(i.max_load, 3.0);
  EXPECT_DOUBLE_EQ(i.max_approach, 1.0);
  EXPECT_DOUBLE_EQ(i.hardness, 6.0);
  EXPECT_NEAR(i.loading_stiffness, 6.0, 1e-12);    // exact for a power law
  EXPECT_NEAR(i.unloading_stiffness, 12.0, 1e-12); // uneven steps
  EXPECT_DOUBLE_EQ(i.final_approach, 0.5);
  EXPECT_DOUBLE_EQ(i.residual_depth, 0.1);
  EXPECT_EQ(i.place, 1);
  EXPECT_EQ(i.cycle, 1);
}

TEST(IndentTest, UnevenLoadsHardlyChangeTheStiffness)
{
  // Cells that join the contact one ring after the other: loads alternate by half a percent. The parabola through three points
  // would be 10 % off.
  IndentReader reader(0.0, 1, 0.0);
  for (int i = 1; i <= 16; ++i)
    (void)reader.add(at(i / 16.0, 3.0 * std::pow(i / 16.0, 1.5) * (i % 2 ? 1.005 : 1.0)), 0.0);
  EXPECT_NEAR(reader.result().loading_stiffness, 4.5, 0.03 * 4.5);
}

TEST(IndentTest, WhatWasLoadedBeforeHasAStiffnessOfItsOwn)
{
  // P = 3 h^2 where it has not been loaded before, P = 12 (h - 0.5)^2 on the way back from h = 1 and up to it again.
  IndentReader first(0.0, 1, 0.0);
  for (const double h : {0.5, 1.0})
    (void)first.add(at(h, 3.0 * h * h), 0.0);
  (void)first.add(at(0.5, 0.0), 0.5);
  IndentReader same = first.next_cycle(0.5), more = first.next_cycle(0.5);
  for (const double h : {0.8, 0.9, 1.0})
    for (IndentReader* reader : {&same, &more})
      (void)reader->add(at(h, 12.0 * (h - 0.5) * (h - 0.5)), 0.5);
  for (const double h : {1.1, 1.2})
    (void)more.add(at(h, 3.0 * h * h), 0.5);
  EXPECT_EQ(same.result().cycle, 2);
  EXPECT_NEAR(same.result().loading_stiffness, 12.0, 1e-12);
  EXPECT_NEAR(more.result().loading_stiffness, 7.2, 1e-12);
  // To the same load in one cycle, after a part of it was taken off: the origin of the elastic branch is not known.
  IndentReader partly(0.0, 1, 0.0);
  for (const double h : {0.5, 1.0})
    (void)partly.add(at(h, 3.0 * h * h), 0.0);
  for (const double h : {0.9, 0.8, 0.9, 1.0})
    (void)partly.add(at(h, 12.0 * (h - 0.5) * (h - 0.5)), 0.5);
  EXPECT_NEAR(partly.result().loading_stiffness, 12.0, 1e-12);
}

TEST(IndentTest, AHeldLoadIsOneLoad)
{
  // Rounding must not decide which step is the peak, nor divide by nothing.
  const double ulp = 1.0 + 4e-16;
  IndentReader reader(0.0, 1, 0.0);
  for (const double h : {0.5, 0.75})
    (void)reader.add(at(h, 3.0 * h * h), 0.0);
  for (const double noise : {ulp, 1.0, 1.0 / ulp})
    (void)reader.add(at(1.0, 3.0 * noise), 0.0);
  for (const double h : {0.9, 0.8})
    (void)reader.add(at(h, 12.0 * (h - 0.5) * (h - 0.5)), 0.5);
  const Indent i = reader.result();
  EXPECT_NEAR(i.loading_stiffness, 6.0, 1e-9);
  EXPECT_NEAR(i.unloading_stiffness, 12.0, 1e-9);
}

TEST(IndentTest, WithoutUnloadingThereIsNoStiffnessOfIt)
{
  const Indent i = squares({0.5, 1.0}, {});
  EXPECT_TRUE(std::isnan(i.unloading_stiffness));
  EXPECT_TRUE(std::isnan(i.final_approach));
}

TEST(IndentTest, BodiesThatDoNotTouchHaveNoStiffness)
{
  IndentReader reader(0.0, 1, 0.0);
  for (const double h : {0.5, 1.0, 0.0})
    (void)reader.add(at(h, 0.0), 0.0);
  const Indent i = reader.result();
  EXPECT_EQ(i.max_load, 0.0);
  EXPECT_EQ(i.max_approach, 1.0);
  EXPECT_TRUE(std::isnan(i.mean_gap));
  EXPECT_TRUE(std::isnan(i.loading_stiffness));
}

TEST(IndentTest, WorkIsTheAreaOfTheLoop)
{
  std::vector<double> loading;
  std::vector<double> unloading;
  constexpr int n = 200;
  for (int i = 1; i <= n; ++i)
  {
    loading.push_back(static_cast<double>(i) / n);
    unloading.push_back(1.0 - 0.5 * i / n);
  }
  EXPECT_NEAR(squares(loading, unloading).work, 1.0 - 0.5, 2.0 / (n * n));
}

} // namespace
} // namespace brinell::simulation::indent_test
