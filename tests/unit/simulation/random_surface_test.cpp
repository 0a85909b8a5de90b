// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/surfaces/random_surface.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

namespace brinell::simulation::random_surface_test
{
namespace
{

constexpr double pi = std::numbers::pi;
/// Round-off of a sum of some thousand waves, over the rms height.
constexpr double round_off = 1e-12;

/// Some 2000 waves on a period that is no square.
SelfAffine rough()
{
  return {.hurst = 0.7,
          .rms_height = 2e-7,
          .rms_slope = {},
          .rolloff = 60e-6,
          .cutoff = 7e-6,
          .size_x = 240e-6,
          .size_y = 180e-6,
          .seed = 5};
}

/// A grid of the period.
SurfaceGrid period_grid(const SelfAffine& p, int nx, int ny)
{
  return {nx, ny, p.size_x / nx, p.size_y / ny};
}

std::vector<double> heights(const RandomSurface& surface, const SurfaceGrid& grid, double x0, double y0,
                            const Averaged& over = {}, Route route = Route::cheapest)
{
  std::vector<double> h(grid.size(), 0.0);
  add_heights(surface, grid, x0, y0, over, 1.0, h, route);
  return h;
}

double mean_power(const std::vector<double>& values, int power)
{
  return std::accumulate(values.begin(), values.end(), 0.0,
                         [&](double sum, double v) { return sum + std::pow(v, power); }) /
         static_cast<double>(values.size());
}

/// The sum of cosines written out, the slow twin of all routes.
double direct_height(const RandomSurface& surface, double x, double y)
{
  const SelfAffine& p = surface.parameters();
  const RandomSurface::Waves& w = surface.waves();
  double sum = 0.0;
  for (int i = 0; i <= w.max_x; ++i)
    for (int j = -w.max_y; j <= w.max_y; ++j)
    {
      const Complex c = w.amplitudes[w.index(i, j)];
      sum += std::abs(c) * std::cos(2.0 * pi * (i * x / p.size_x + j * y / p.size_y) + std::arg(c));
    }
  return sum;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n)
    largest = std::max(largest, std::abs(a[n] - b[n]));
  return largest;
}

TEST(RandomSurface, AllRoutesGiveTheSumOfItsWaves)
{
  const RandomSurface surface(rough());
  const double allowed = round_off * surface.rms_height();
  // Fine cells, and such on which waves fall onto each other; an origin anywhere; more and less than a period.
  for (const auto& [nx, ny] : {std::pair{96, 70}, {20, 12}})
  {
    const SurfaceGrid period = period_grid(surface.parameters(), nx, ny);
    const SurfaceGrid grid{nx + 5, ny - 7, period.dx, period.dy};
    const double x0 = -33.3e-6, y0 = 1.234e-3;
    const auto by_transform = heights(surface, grid, x0, y0, {}, Route::transform);
    const auto by_rows = heights(surface, grid, x0, y0, {}, Route::rows_and_columns);
    EXPECT_LT(largest_difference(by_transform, by_rows), allowed);
    for (const auto& [i, j] : {std::pair{0, 0}, {nx + 4, 3}, {7, ny - 8}})
    {
      const double x = x0 + i * grid.dx, y = y0 + j * grid.dy;
      // Whole periods away angles of the cosines have lost three digits.
      EXPECT_NEAR(by_rows[grid.index(i, j)], direct_height(surface, x, y), 1e3 * allowed);
      EXPECT_NEAR(height_of(surface, x, y, {}), by_rows[grid.index(i, j)], allowed);
      EXPECT_EQ(depth(Texture(surface), x, y), -height_of(surface, x, y, {}));
    }
  }
}

TEST(RandomSurface, HasTheRmsThatIsAsked)
{
  const RandomSurface by_height(rough());
  SelfAffine p = rough();
  p.rms_height.reset();
  p.rms_slope = 0.03;
  const RandomSurface by_slope(p);
  EXPECT_DOUBLE_EQ(by_height.rms_height(), 2e-7);
  EXPECT_DOUBLE_EQ(by_slope.rms_slope(), 0.03);
  EXPECT_NEAR(by_slope.rms_height() / by_slope.rms_slope(), by_height.rms_height() / by_height.rms_slope(),
              1e-14 * by_height.rms_height() / by_height.rms_slope());
  // On a grid that tells squares of all waves apart, the mean over the points is that over the period. Slopes by the
  // difference of close points, which errs by (q step)^2/24 of the shortest wave.
  for (const RandomSurface* surface : {&by_height, &by_slope})
  {
    const SurfaceGrid grid = period_grid(p, 144, 108);
    const auto h = heights(*surface, grid, 0.0, 0.0);
    EXPECT_NEAR(std::sqrt(mean_power(h, 2)), surface->rms_height(), round_off * surface->rms_height());
    EXPECT_NEAR(mean_power(h, 1), 0.0, round_off * surface->rms_height());
    const double step = 1e-3 * p.cutoff;
    auto along_x = heights(*surface, grid, 0.5 * step, 0.0), along_y = heights(*surface, grid, 0.0, 0.5 * step);
    const auto left = heights(*surface, grid, -0.5 * step, 0.0), below = heights(*surface, grid, 0.0, -0.5 * step);
    for (std::size_t n = 0; n < h.size(); ++n)
    {
      along_x[n] = (along_x[n] - left[n]) / step;
      along_y[n] = (along_y[n] - below[n]) / step;
    }
    EXPECT_NEAR(std::sqrt(mean_power(along_x, 2) + mean_power(along_y, 2)) / surface->rms_slope(), 1.0, 2e-6);
  }
}

TEST(RandomSurface, ItsSpectrumIsFlatThenFallsAndEnds)
{
  SelfAffine p{.hurst = 0.6,
               .rms_height = 1.0,
               .rms_slope = {},
               .rolloff = 1.0 / 16.0,
               .cutoff = 1.0 / 128.0,
               .size_x = 1.0,
               .size_y = 1.0,
               .seed = 3};
  const RandomSurface surface(p);
  const RandomSurface::Waves& w = surface.waves();
  const auto power = [&](double from, double to)
  {
    double sum = 0.0, count = 0.0;
    for (int i = 0; i <= w.max_x; ++i)
      for (int j = -w.max_y; j <= w.max_y; ++j)
        if (const double q = std::hypot(i, j); q >= from && q < to && (i > 0 || j > 0))
        {
          sum += std::norm(w.amplitudes[w.index(i, j)]);
          count += 1.0;
        }
    return std::pair{sum / count, count};
  };
  // |c|^2 is exponentially distributed: the mean of n scatters by 1/sqrt(n); four of these.
  const auto [flat, flat_count] = power(1.0, 8.0);
  const auto [bend, bend_count] = power(8.0, 16.0);
  EXPECT_NEAR(bend / flat, 1.0, 4.0 * std::hypot(1.0 / std::sqrt(flat_count), 1.0 / std::sqrt(bend_count)));
  const auto [low, low_count] = power(31.5, 32.5);
  const auto [high, high_count] = power(125.5, 126.5);
  const double exponent = std::log(high / low) / std::log(126.0 / 32.0);
  EXPECT_NEAR(exponent, -2.0 * (1.0 + p.hurst),
              4.0 * std::hypot(1.0 / std::sqrt(low_count), 1.0 / std::sqrt(high_count)) / std::log(126.0 / 32.0));
  for (int i = 0; i <= w.max_x; ++i)
    for (int j = -w.max_y; j <= w.max_y; ++j)
    {
      const bool is_wave = std::hypot(i, j) <= 128.0 && (i > 0 || j > 0);
      EXPECT_EQ(w.amplitudes[w.index(i, j)] != Complex{}, is_wave) << i << " " << j;
    }
}

TEST(RandomSurface, IsIsotropic)
{
  const RandomSurface surface({.hurst = 0.8,
                               .rms_height = {},
                               .rms_slope = 1.0,
                               .rolloff = 0.05,
                               .cutoff = 0.01,
                               .size_x = 1.0,
                               .size_y = 0.5,
                               .seed = 11});
  const RandomSurface::Waves& w = surface.waves();
  double along_x = 0.0, along_y = 0.0, scatter = 0.0;
  for (int i = 0; i <= w.max_x; ++i)
    for (int j = -w.max_y; j <= w.max_y; ++j)
    {
      const double square = std::norm(w.amplitudes[w.index(i, j)]);
      const double x2 = i * i * square, y2 = 4.0 * j * j * square;
      along_x += x2;
      along_y += y2;
      scatter += std::pow(x2 - y2, 2);
    }
  EXPECT_NEAR(along_x, along_y, 4.0 * std::sqrt(scatter));
}

TEST(RandomSurface, HeightsAreGaussian)
{
  // Without a roll-off few long waves make the surface; here some hundred are equally high.
  const RandomSurface surface({.hurst = 0.8,
                               .rms_height = 1.0,
                               .rms_slope = {},
                               .rolloff = 1.0 / 24.0,
                               .cutoff = 1.0 / 48.0,
                               .size_x = 1.0,
                               .size_y = 1.0,
                               .seed = 1});
  const SurfaceGrid grid = period_grid(surface.parameters(), 192, 192);
  const auto h = heights(surface, grid, 0.0, 0.0);
  // Points a wavelength apart are independent: as many as there are squares of half the roll-off. The variances of
  // skewness and kurtosis are 6/n and 24/n; four of their roots.
  const double n = std::pow(2.0 * 24.0, 2);
  EXPECT_NEAR(mean_power(h, 3), 0.0, 4.0 * std::sqrt(6.0 / n));
  EXPECT_NEAR(mean_power(h, 4), 3.0, 4.0 * std::sqrt(24.0 / n));
}

TEST(RandomSurface, FollowsFromItsSeedAlone)
{
  EXPECT_EQ(RandomSurface(rough()), RandomSurface(rough()));
  SelfAffine other = rough();
  other.seed = 6;
  EXPECT_NE(RandomSurface(rough()), RandomSurface(other));
  const SurfaceGrid grid = period_grid(rough(), 60, 44);
  const auto a = heights(RandomSurface(rough()), grid, 0.0, 0.0), b = heights(RandomSurface(other), grid, 0.0, 0.0);
  // Uncorrelated: both have some hundred waves that count.
  EXPECT_LT(std::abs(std::inner_product(a.begin(), a.end(), b.begin(), 0.0)) / static_cast<double>(a.size()),
            0.3 * 4e-14);
}

/// By tools/oracles/random_surface.py, which shares no code. Machines may differ in the last digits of log, sin and cos.
TEST(RandomSurface, IsTheSameOnEveryMachine)
{
  const RandomSurface surface(rough());
  constexpr double known[] = {-2.8595662810424704e-07, -1.4442015750555305e-07, -1.7738754111473093e-07,
                              -2.6429554400230889e-07};
  const std::pair<double, double> places[] = {{0.0, 0.0}, {1e-5, 2e-5}, {-7.7e-5, 3.1e-5}, {1.2e-4, -9e-5}};
  for (std::size_t n = 0; n < 4; ++n)
    EXPECT_NEAR(height_of(surface, places[n].first, places[n].second, {}), known[n], round_off * 2e-7);
}

TEST(RandomSurface, IsPeriodic)
{
  const SelfAffine p = rough();
  const RandomSurface surface(p);
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {13e-6, -40e-6}})
  {
    const double here = height_of(surface, x, y, {});
    EXPECT_NEAR(height_of(surface, x + p.size_x, y, {}), here, round_off * 2e-7);
    EXPECT_NEAR(height_of(surface, x - 3.0 * p.size_x, y + 2.0 * p.size_y, {}), here, round_off * 2e-7);
    EXPECT_GT(std::abs(height_of(surface, x + 0.5 * p.size_x, y, {}) - here), 1e-9);
  }
}

TEST(RandomSurface, AShorterCutoffAddsWaves)
{
  SelfAffine p = rough();
  const RandomSurface coarse(p);
  p.cutoff = 4e-6;
  const RandomSurface fine(p);
  const RandomSurface::Waves &a = coarse.waves(), &b = fine.waves();
  const Complex scale = b.amplitudes[b.index(1, 0)] / a.amplitudes[a.index(1, 0)];
  EXPECT_NEAR(scale.imag(), 0.0, 1e-14);
  for (int i = 0; i <= a.max_x; ++i)
    for (int j = -a.max_y; j <= a.max_y; ++j)
      if (const Complex old = a.amplitudes[a.index(i, j)]; old != Complex{})
      {
        EXPECT_LT(std::abs(b.amplitudes[b.index(i, j)] - scale * old), 1e-13 * std::abs(old)) << i << " " << j;
      }
}

TEST(RandomSurface, CellsThatDoNotShowTheWavesTakeTheirMean)
{
  const SelfAffine p = rough();
  const RandomSurface surface(p);
  const Texture texture = surface;
  const double dx = 5e-6, dy = 6e-6; // more than half of the shortest wave
  const SurfaceGrid grid{3, 2, dx, dy};
  const auto means = cell_depths(texture, grid, 10e-6, -20e-6);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      const double x = 10e-6 + i * dx, y = -20e-6 + j * dy;
      const int points =
          40; // the midpoint rule errs by (q step)^2/24, here 5e-4 of the shortest waves, which count little
      const SurfaceGrid fine{points, points, dx / points, dy / points};
      const auto in_cell = depths(texture, fine, x + fine.x(0), y + fine.y(0));
      EXPECT_NEAR(means[grid.index(i, j)], mean_power(in_cell, 1), 1e-4 * 2e-7);
      EXPECT_NEAR(cell_depth(texture, x, y, dx, dy), means[grid.index(i, j)], round_off * 2e-7);
    }
  EXPECT_EQ(cell_depth(texture, 0.0, 0.0, 3e-6, 3e-6), depth(texture, 0.0, 0.0)) << "resolved: as it is";
}

TEST(RandomSurface, ReachIsItsHighestPoint)
{
  const RandomSurface surface(rough());
  const TextureReach found = reach(surface);
  const auto h = heights(surface, period_grid(rough(), 960, 720), 0.0, 0.0);
  const double highest = *std::max_element(h.begin(), h.end());
  EXPECT_LE(found.height, 1.0001 * highest);
  EXPECT_GE(found.height, 0.97 * highest);
  EXPECT_TRUE(std::isinf(found.half_width_y));
}

TEST(RandomSurface, RefusesWhatMakesNone)
{
  const auto refused = [](const auto& change)
  {
    SelfAffine p = rough();
    change(p);
    try
    {
      static_cast<void>(RandomSurface(p));
    }
    catch (const InputError& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  for (const auto& [text, part] :
       {std::pair{refused([](SelfAffine& p) { p.hurst = 1.1; }), "hurst = 1.1"},
        {refused([](SelfAffine& p) { p.rms_slope = 0.1; }), "rms_height or rms_slope, one of them"},
        {refused([](SelfAffine& p) { p.rms_height.reset(); }), "rms_height or rms_slope, one of them"},
        {refused([](SelfAffine& p) { p.rms_height = -1.0; }), "rms_height = -1"},
        {refused([](SelfAffine& p) { p.size_y = 0.0; }), "size_y = 0"},
        {refused([](SelfAffine& p) { p.cutoff = 2e-4; }), "not longer than the size"},
        {refused([](SelfAffine& p) { p.cutoff = 5e-8; }), "at least 1/4096 of the size"},
        {refused([](SelfAffine& p) { p.rolloff = 1e-6; }), "rolloff = 1e-06"}})
    EXPECT_NE(text.find(part), std::string::npos) << part << ": " << text;
}

TEST(Sinusoid, IsWhatItsFormulaSays)
{
  const Sinusoid s{.amplitude = 2e-6, .wavelength_x = 3e-4, .wavelength_y = 5e-4, .x = 1e-5, .y = -2e-5};
  const Texture texture = s;
  EXPECT_DOUBLE_EQ(depth(texture, 1e-5, -2e-5), -2e-6);
  const double x = 7e-5, y = 4e-5;
  EXPECT_NEAR(depth(texture, x, y), -2e-6 * std::cos(2.0 * pi * 6e-5 / 3e-4) * std::cos(2.0 * pi * 6e-5 / 5e-4), 1e-20);
  const Texture ridges = Sinusoid{.amplitude = 2e-6, .wavelength_x = 3e-4};
  EXPECT_EQ(depth(ridges, x, 0.0), depth(ridges, x, 1.0));
  EXPECT_EQ(reach(texture).height, 2e-6);
  // The mean over a cell that is too large to show the waves: over a whole wave it is zero.
  EXPECT_NEAR(cell_depth(ridges, x, y, 3e-4, 1e-5), 0.0, 1e-20);
  EXPECT_NEAR(cell_depth(ridges, 0.0, y, 1.6e-4, 1e-5), -2e-6 * std::sin(pi * 1.6 / 3.0) / (pi * 1.6 / 3.0), 1e-19);
}

TEST(Texture, IsTheSumOfItsParts)
{
  const Texture waves = Sinusoid{.amplitude = 1e-6, .wavelength_x = 1e-4};
  const Texture dent = Dent{.depth = 2e-6, .edge_radius = 0.25e-4};
  const Texture both(std::vector<TexturePart>{waves.parts[0], dent.parts[0], RandomSurface(rough())});
  const Texture third = RandomSurface(rough());
  const SurfaceGrid grid{7, 5, 3e-6, 2e-6};
  const auto sum = depths(both, grid, -1e-5, -4e-6);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      const double x = -1e-5 + i * grid.dx, y = -4e-6 + j * grid.dy;
      EXPECT_NEAR(sum[grid.index(i, j)], depth(waves, x, y) + depth(dent, x, y) + depth(third, x, y), 1e-18);
    }
  EXPECT_DOUBLE_EQ(reach(both).height, reach(waves).height + reach(dent).height + reach(third).height);
  EXPECT_TRUE(Texture{}.is_smooth());
  EXPECT_FALSE(both.is_smooth());
}

TEST(Texture, KnowsWhetherItIsPeriodic)
{
  const SelfAffine p = rough();
  const Texture random = RandomSurface(p);
  EXPECT_TRUE(is_periodic(random, p.size_x, p.size_y));
  EXPECT_TRUE(is_periodic(random, 2.0 * p.size_x, 3.0 * p.size_y));
  EXPECT_FALSE(is_periodic(random, 1.5 * p.size_x, p.size_y));
  EXPECT_FALSE(is_periodic(random, 0.5 * p.size_x, p.size_y));
  const Texture ridges = Sinusoid{.amplitude = 1e-6, .wavelength_x = 60e-6};
  EXPECT_TRUE(is_periodic(ridges, 240e-6, 1.0));
  EXPECT_FALSE(is_periodic(ridges, 230e-6, 1.0));
  EXPECT_TRUE(is_periodic(Texture{}, 1.0, 1.0));
  EXPECT_FALSE(is_periodic(Texture(Dent{.depth = 1e-6, .edge_radius = 0.25e-5}), 1.0, 1.0));
  HeightMap map{3, 2, 1e-6, 2e-6, 4e-6, 0.0, {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}};
  EXPECT_FALSE(is_periodic(Texture(map), 3e-6, 4e-6));
  map.periodic = true;
  EXPECT_TRUE(is_periodic(Texture(map), 3e-6, 4e-6));
  EXPECT_FALSE(is_periodic(Texture(map), 2e-6, 4e-6));
  EXPECT_FALSE(
      is_periodic(Texture(std::vector<TexturePart>{map, Dent{.depth = 1e-6, .edge_radius = 0.25e-5}}), 3e-6, 4e-6));
  const Texture bumpy(std::vector<TexturePart>{map, Dent{.depth = -1e-6, .edge_radius = 0.25e-5}});
  EXPECT_EQ(reason_against_period(bumpy, 3e-6, 4e-6), "texture[1]: a bump does not repeat");
  EXPECT_EQ(reason_against_period(ridges, 230e-6, 1.0),
            "texture: the wavelength of 6e-05 m does not go a whole number of times into 0.00023 m");
  EXPECT_FALSE(reason_against_period(random, p.size_x, p.size_y));
  // Points (0, 0) at x = 3 um, y = -1 um; between the last and the first one the map is linear.
  for (const auto& [x, y, height] :
       {std::tuple{3e-6, -1e-6, 1.0}, {6e-6, 3e-6, 1.0}, {-3e-6, 1e-6, 4.0}, {5.5e-6, -1e-6, 2.0}, {2.5e-6, 2e-6, 3.5}})
    EXPECT_NEAR(depth(Texture(map), x, y), -height, 1e-9) << x << " " << y;
}

} // namespace
} // namespace brinell::simulation::random_surface_test
