// SPDX-License-Identifier: BSD-3-Clause
// The patches of a contact.
#include "brinell/contact/contact_area.hpp"

#include "brinell/contact/elastic_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

namespace brinell::contact::patches_test
{
namespace
{

constexpr double pi = std::numbers::pi;

struct Contact
{
  SurfaceGrid grid;
  std::vector<double> pressure, gap;

  [[nodiscard]] Patches patches() const { return contact::patches(grid, pressure, gap, 1.0); }
  [[nodiscard]] double area() const { return contact_area(grid, pressure, gap, 1.0); }
};

/// Waves of random phase over a period, moved by whole cells; E' = 1.
Contact rough(int columns_on, int rows_on, double load)
{
  constexpr int nx = 36, ny = 30;
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> any(0.0, 2.0 * pi);
  Contact c{{nx, ny, 1.0, 1.1, Boundary::periodic, Boundary::periodic}, {}, {}};
  std::vector<double> distance(c.grid.size());
  for (const auto& [m, n] : {std::array{4, 1}, {3, 3}, {1, 4}, {2, -4}, {5, 0}})
  {
    const double phase = any(generator);
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        distance[c.grid.index(i, j)] +=
            1e-2 * std::cos(2.0 * pi * (m * (i - columns_on) / double{nx} + n * (j - rows_on) / double{ny}) + phase);
  }
  const halfspace::SurfaceCompliance compliance(c.grid, 1.0);
  c.pressure.resize(c.grid.size());
  c.gap.resize(c.grid.size());
  ElasticContact contact(compliance);
  EXPECT_TRUE(contact.solve(distance, {Drive::Kind::load, load}, 1e-10, 5000, c.pressure, c.gap).converged);
  return c;
}

/// The slow, obvious twin: fills from a cell to all that hang together with it.
int filled(const Contact& c, std::vector<int>& label)
{
  label.assign(c.grid.size(), -1);
  int count = 0;
  for (int start = 0; start < c.grid.nx * c.grid.ny; ++start)
  {
    std::vector<int> open{start};
    const auto is_new = [&](int cell)
    { return c.pressure[static_cast<std::size_t>(cell)] > 0.0 && label[static_cast<std::size_t>(cell)] < 0; };
    const bool begins = is_new(start);
    while (!open.empty())
    {
      const int cell = open.back();
      open.pop_back();
      if (!is_new(cell))
        continue;
      label[static_cast<std::size_t>(cell)] = count;
      const int i = cell % c.grid.nx, j = cell / c.grid.nx;
      for (const auto& [di, dj] : {std::array{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
        open.push_back((i + di + c.grid.nx) % c.grid.nx + c.grid.nx * ((j + dj + c.grid.ny) % c.grid.ny));
    }
    count += begins ? 1 : 0;
  }
  return count;
}

TEST(Patches, AreThoseOfAFillAndTheirAreasSumUp)
{
  for (const double load : {0.3, 2.0, 8.0})
  {
    const Contact c = rough(0, 0, load);
    const Patches p = c.patches();
    std::vector<int> label;
    ASSERT_EQ(static_cast<int>(p.area.size()), filled(c, label)) << load;
    EXPECT_EQ(p.label, label) << load;
    EXPECT_NEAR(std::accumulate(p.area.begin(), p.area.end(), 0.0), c.area(), 1e-12 * c.area()) << load;
    EXPECT_GT(*std::min_element(p.area.begin(), p.area.end()), 0.0) << load;
  }
}

TEST(Patches, HangTogetherOverTheEndsOfAPeriod)
{
  const auto sorted = [](const Contact& c)
  {
    std::vector<double> areas = c.patches().area;
    std::sort(areas.begin(), areas.end());
    return areas;
  };
  const std::vector<double> here = sorted(rough(0, 0, 2.0));
  ASSERT_GT(here.size(), 3U);
  for (const auto& [i, j] : {std::array{5, 0}, {0, 7}, {17, 15}})
  {
    const std::vector<double> there = sorted(rough(i, j, 2.0));
    ASSERT_EQ(there.size(), here.size()) << i << ' ' << j;
    for (std::size_t n = 0; n < here.size(); ++n)
      EXPECT_NEAR(there[n], here[n], 1e-4 * here[n] + 1e-6) << i << ' ' << j; // the tolerance of the contact
  }
}

TEST(Patches, OfTwoBallsHaveHertzsAreas)
{
  // Radii of 1 and 1/4 that overlap by the same: areas as 4 to 1.
  const SurfaceGrid grid{81, 31, 1.0, 1.0};
  Contact c{grid, std::vector<double>(grid.size()), std::vector<double>(grid.size())};
  std::vector<double> distance(grid.size());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      const double y = grid.y(j), left = std::hypot(grid.x(i) + 22.0, y), right = std::hypot(grid.x(i) - 26.0, y);
      distance[grid.index(i, j)] = std::min(left * left, 4.0 * right * right) / 2e3;
    }
  const double a = 10.0;
  const halfspace::SurfaceCompliance compliance(grid, 1.0);
  ElasticContact contact(compliance);
  ASSERT_TRUE(contact.solve(distance, {Drive::Kind::approach, a * a / 1e3}, 1e-10, 5000, c.pressure, c.gap).converged);
  const Patches p = c.patches();
  ASSERT_EQ(p.area.size(), 2U);
  // Each sinks where the other one presses, by 2/3 a^3/(R distance) of its approach a^2/R at the most: 14 and 2 %; and the cells.
  EXPECT_NEAR(p.area[0] / (pi * a * a), 1.0, 0.05);
  EXPECT_NEAR(p.area[1] / (pi * a * a / 4.0), 1.0, 0.2);
  EXPECT_NEAR(p.area[0] + p.area[1], c.area(), 1e-12 * c.area());
}

TEST(Patches, CellsThatMeetAtACornerAreApart)
{
  const SurfaceGrid grid{4, 4, 1.0, 1.0};
  Contact c{grid, std::vector<double>(16, 0.0), std::vector<double>(16, 1e-3)};
  c.pressure[grid.index(1, 1)] = c.pressure[grid.index(2, 2)] = 1e-3;
  EXPECT_EQ(c.patches().area.size(), 2U);
  c.pressure[grid.index(2, 1)] = 1e-3;
  EXPECT_EQ(c.patches().area.size(), 1U);
  EXPECT_NEAR(c.patches().area[0], c.area(), 1e-15);
  const Contact none{grid, std::vector<double>(16, 0.0), std::vector<double>(16, 1e-3)};
  EXPECT_TRUE(none.patches().area.empty());
  EXPECT_EQ(none.patches().label, std::vector<int>(16, -1));
}

} // namespace
} // namespace brinell::contact::patches_test
