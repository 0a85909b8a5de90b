// SPDX-License-Identifier: BSD-3-Clause
// A layer between the surfaces that gives way in proportion to the local pressure.
#include "brinell/contact/elastic_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace brinell::contact::contact_layer_test
{
namespace
{

// A wave that is pressed until it touches everywhere is an eigenvector of the compliance, and of the layer.
TEST(ContactLayer, AddsToTheComplianceOfAWave)
{
  constexpr int cells = 16;
  constexpr double dx = 1e-6, modulus = 100e9, amplitude = 1e-9;
  const SurfaceGrid grid{cells, cells, dx, dx, Boundary::periodic, Boundary::periodic};
  const halfspace::SurfaceCompliance compliance(grid, modulus);
  std::vector<double> wave(grid.size()), image(grid.size());
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i)
      wave[grid.index(i, j)] = std::cos(2.0 * std::numbers::pi * i / cells);
  auto scratch = compliance.make_scratch();
  compliance.apply({.pressure = wave}, {.z = image}, scratch);
  const double elastic = image[0]; // displacement per pressure of this wave
  ElasticContact contact(compliance);
  for (const double ratio : {0.0, 1.0, 1e3})
  {
    const double layer = ratio * elastic;
    const double wave_pressure = amplitude / (elastic + layer), mean_pressure = 2.0 * wave_pressure;
    std::vector<double> distance(grid.size()), pressure(grid.size()), gap(grid.size());
    for (std::size_t n = 0; n < distance.size(); ++n)
      distance[n] = amplitude * (1.0 - wave[n]);
    const std::vector<double> layers(grid.size(), layer);
    const Report report =
        contact.solve(distance, {Drive::Kind::load, mean_pressure * static_cast<double>(grid.size()) * dx * dx},
                      1e-10 * amplitude, 2000, pressure, gap, {}, layers);
    EXPECT_TRUE(report.converged) << ratio;
    EXPECT_NEAR(report.approach, amplitude + layer * mean_pressure, 1e-8 * amplitude * (1.0 + ratio));
    for (std::size_t n = 0; n < distance.size(); ++n)
      ASSERT_NEAR(pressure[n], mean_pressure + wave_pressure * wave[n], 1e-7 * mean_pressure) << ratio;
  }
}

// The approach, load and pressure of a mean gap that is kept are those which an imposed load finds, whose way through the solver is
// another one.
TEST(ContactLayer, GivesWayWhileAMeanGapIsKept)
{
  constexpr int cells = 24;
  constexpr double dx = 1e-6, modulus = 100e9, amplitude = 1e-8;
  const SurfaceGrid grid{cells, cells, dx, dx, Boundary::periodic, Boundary::periodic};
  const halfspace::SurfaceCompliance compliance(grid, modulus);
  ElasticContact contact(compliance);
  std::vector<double> distance(grid.size());
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i)
      distance[grid.index(i, j)] = amplitude * (2.0 - std::cos(2.0 * std::numbers::pi * i / cells) *
                                                          std::cos(2.0 * std::numbers::pi * j / cells));
  const double tolerance = 1e-7 * amplitude;
  // Far softer than the half spaces: what gives way is larger than the gap.
  for (const double layer : {0.1 * dx / modulus, 10.0 * dx / modulus, 1e4 * dx / modulus})
    for (const double wanted : {0.05 * amplitude, 0.6 * amplitude})
    {
      const std::vector<double> layers(grid.size(), layer);
      std::vector<double> pressure(grid.size()), gap(grid.size()), again(grid.size()), gap_again(grid.size());
      const Report kept =
          contact.solve(distance, {Drive::Kind::mean_gap, wanted}, tolerance, 5000, pressure, gap, {}, layers);
      ASSERT_TRUE(kept.converged) << layer << ' ' << wanted;
      const auto size = static_cast<double>(grid.size());
      EXPECT_NEAR(std::accumulate(gap.begin(), gap.end(), 0.0) / size, wanted, 2.0 * tolerance);
      const double load = std::accumulate(pressure.begin(), pressure.end(), 0.0) * grid.cell_area();
      ASSERT_GT(load, 0.0);
      const Report loaded =
          contact.solve(distance, {Drive::Kind::load, load}, tolerance, 5000, again, gap_again, {}, layers);
      ASSERT_TRUE(loaded.converged);
      EXPECT_NEAR(kept.approach, loaded.approach, 1e-5 * amplitude + 1e-5 * kept.approach) << layer << ' ' << wanted;
      EXPECT_NEAR(std::accumulate(gap_again.begin(), gap_again.end(), 0.0) / size, wanted, 1e-4 * amplitude);
    }
}

} // namespace
} // namespace brinell::contact::contact_layer_test
