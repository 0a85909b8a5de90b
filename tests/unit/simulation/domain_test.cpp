// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/plan/domain.hpp"

#include "brinell/quality/quality.hpp"
#include "brinell/simulation/run.hpp"
#include "domain_cases.hpp"
#include "simulation/plan/footprint.hpp"
#include "simulation/plan/roughness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

/// Plans of bodies in a period: plane strain, one and two periodic axes.
namespace brinell::simulation::domain_test
{
namespace
{

using cases::approach;
using cases::cylinder;
using cases::load;
using contact::Drive;

constexpr double pi = std::numbers::pi;
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double R = cases::radius;

IndentationCase flats(const Drive& drive)
{
  IndentationCase c = cylinder(drive);
  c.upper.shape = Plane{};
  c.domain.x = c.domain.y = {Boundary::periodic, 1e-3, 16};
  c.lower.texture = Sinusoid{.amplitude = 1e-6, .wavelength_x = 0.5e-3, .wavelength_y = 0.5e-3};
  return c;
}

Footprint smooth(const IndentationCase& c)
{
  return smooth_footprint(c.lower, c.upper, c.sequence.front(), c.domain);
}

// --- cells in a period --------------------------------------------------------------------------------------------

TEST(PlaneProblem, IsOneRowHoweverItIsGiven)
{
  IndentationCase by_cells = cylinder(load(1e6));
  by_cells.lower.material.hardening = constitutive::LinearHardening{600e6, 20e9};
  const IndentationPlan one = plan(by_cells);
  EXPECT_TRUE(is_plane(one.contact));
  EXPECT_DOUBLE_EQ(one.lower.dz, 0.5 * one.contact.dx);
  IndentationCase by_spacing = by_cells;
  by_spacing.domain.y.cells = 0;
  by_spacing.spacing = {{one.contact.dx, 1.0, one.lower.dz}};
  const IndentationPlan other = plan(by_spacing);
  EXPECT_EQ(other.contact, one.contact);
  EXPECT_EQ(other.lower, one.lower);
  const quality::Resolution expected = quality::expected(by_cells, one).resolution;
  const quality::Resolution found = quality::expected(by_spacing, other).resolution;
  EXPECT_NEAR(found.cells_y, expected.cells_y, 1e-9);
  EXPECT_NEAR(found.cells_x, expected.cells_x, 1e-9);
}

TEST(PlaneProblem, TheLengthOfThePeriodMeansNothing)
{
  for (const double yield : {600e6, inf})
  {
    IndentationCase c = cylinder(load(1e6));
    if (std::isfinite(yield))
      c.lower.material.hardening = constitutive::LinearHardening{yield, 20e9};
    const IndentationPlan expected = plan(c);
    for (const double length : {1e-6, 1e-3, 100.0})
    {
      c.domain.y.size = length;
      c.sequence = {load(1e6 * length)};
      const IndentationPlan found = plan(c);
      EXPECT_EQ(found.contact.nx, expected.contact.nx);
      EXPECT_NEAR(found.contact.dx, expected.contact.dx, 1e-9 * expected.contact.dx);
      EXPECT_EQ(found.lower.surface.nx, expected.lower.surface.nx);
      EXPECT_EQ(found.lower.nz, expected.lower.nz) << length;
    }
  }
}

TEST(CellsInPeriods, OneRowTakesWhatIsUniformAlongIt)
{
  IndentationCase c = cylinder(load(1e6));
  c.upper.shape = Paraboloid{R, R};
  expect_refused(c, "grid.cells", "their shapes vary; allowed: the period along y as grid.size and more than one cell");
  c = cylinder(load(1e3));
  c.upper.shape = Roller{R, 1e-3};
  expect_refused(c, "grid.size",
                 "grid.size = 1 m along y, in one row, is more than the length of the cylinder, 0.001 m");
  c = cylinder(load(1e6));
  c.lower.texture = Sinusoid{.amplitude = 1e-7, .wavelength_y = 0.5};
  expect_refused(c, "grid.cells", "lower.texture varies");
  c.lower.texture = Dent{.depth = 1e-7, .edge_radius = 0.25e-4};
  expect_refused(c, "grid.cells", "lower.texture varies");
  c.lower.texture = Sinusoid{.amplitude = 1e-7, .wavelength_x = 1e-4};
  EXPECT_NO_THROW(static_cast<void>(plan(c)));
  HeightMap profile{4, 2, 1e-4, 0.5, 0.0, 0.0, {0.0, 1e-7, 0.0, 0.0, 0.0, 1e-7, 0.0, 0.0}, true};
  c.lower.texture = profile;
  EXPECT_NO_THROW(static_cast<void>(plan(c)));
  profile.heights[0] = 1e-7;
  c.lower.texture = profile;
  expect_refused(c, "grid.cells", "lower.texture varies");
}

TEST(CellsInPeriods, OneColumnAndOneCell)
{
  IndentationCase c = flats(load(1.0));
  c.domain.x.cells = 1;
  expect_refused(c, "grid.cells", "grid.cells is 1 along x");
  c.lower.texture = Sinusoid{.amplitude = 1e-6, .wavelength_y = 0.5e-3};
  EXPECT_NO_THROW(static_cast<void>(plan(c)));
  c.domain.y.cells = 1;
  c.lower.texture = HeightMap{1, 1, 1e-3, 1e-3, 0.0, 0.0, {1e-6}, true};
  c.upper.shape = Roller{R, inf};
  expect_refused(c, "grid.cells", "allowed: more than one cell along x or y");
}

// A cell as long as a wave has the mean height all over: flats that touch everywhere at once, whose contact no solver finds.
TEST(CellsInPeriods, TheyHaveToShowSomethingOfTheTextures)
{
  const double cell = 1e-3 / 16.0;
  IndentationCase c = flats(load(1.0));
  c.lower.texture = Sinusoid{.amplitude = 1e-6, .wavelength_x = cell, .wavelength_y = 0.5e-3};
  expect_refused(c, "grid.cells",
                 "nothing of lower.texture remains, and two flats touch everywhere at once; allowed: cells that "
                 "resolve the waves: the shortest one has 1 cells and needs 8");
  c.lower.texture.parts.push_back(Sinusoid{.amplitude = 1e-7, .wavelength_x = 0.5e-3}); // one of them is enough
  EXPECT_NO_THROW(static_cast<void>(plan(c)));
  HeightMap checks{32, 32, 0.5 * cell, 0.5 * cell, 0.0, 0.0, std::vector<double>(32 * 32), true};
  for (std::size_t i = 0; i < checks.heights.size(); ++i)
    checks.heights[i] = (i + i / 32) % 2 == 0 ? 1e-6 : -1e-6;
  c.lower.texture = checks;
  c.upper.texture = checks;
  expect_refused(c, "grid.cells", "nothing of lower.texture and upper.texture remains");
  c.domain.x.cells = c.domain.y.cells = 0;
  c.spacing = {cell, cell, cell};
  c.upper.texture = {};
  c.lower.texture = Sinusoid{.amplitude = 1e-6, .wavelength_x = cell, .wavelength_y = cell};
  expect_refused(c, "grid.spacing", "on cells of 6.25e-05 x 6.25e-05 m");
}

// Beside a shape it is one that the texture leaves, which a warning tells.
TEST(CellsInPeriods, AShapeTouchesWithoutTheTextures)
{
  IndentationCase c = flats(load(1.0));
  c.lower.texture = Sinusoid{.amplitude = 1e-8, .wavelength_x = 1e-3 / 16.0};
  c.upper.shape = Paraboloid{R, R};
  EXPECT_NO_THROW(static_cast<void>(plan(c)));
}

TEST(CellsInPeriods, FewOfThemGiveNumbers)
{
  for (const auto& [nx, ny] : {std::pair{2, 1}, {1, 2}, {2, 2}, {3, 1}, {3, 2}})
  {
    IndentationCase c = flats(load(600.0));
    c.domain.x.cells = nx;
    c.domain.y.cells = ny;
    c.lower.material.hardening = constitutive::LinearHardening{600e6, 20e9};
    Sinusoid waves{.amplitude = 20e-6};
    if (nx > 1)
      waves = {.amplitude = 20e-6, .wavelength_x = 1e-3, .wavelength_y = inf, .x = 0.0, .y = 0.0};
    else
      waves = {.amplitude = 20e-6, .wavelength_x = inf, .wavelength_y = 1e-3, .x = 0.0, .y = 0.25e-3};
    c.lower.texture = waves;
    c.sequence = {load(600.0), load(0.0)};
    c.steps = 2;
    const IndentationSummary summary = run(c, {});
    EXPECT_GT(summary.last.max_equivalent_plastic_strain, 0.0) << nx << ' ' << ny;
    EXPECT_TRUE(std::isfinite(summary.last.max_residual_lower));
    EXPECT_TRUE(std::isfinite(summary.last.approach));
    EXPECT_TRUE(std::isfinite(summary.last.work));
    EXPECT_EQ(summary.last.F_n, 0.0);
  }
}

TEST(CellsInPeriods, EndsOfACylinderAreThoseOfCells)
{
  IndentationCase c = cylinder(load(1e3));
  c.upper.shape = Roller{R, 0.5e-3};
  for (const int cells : {15, 16})
  {
    const double dy = 1.2e-3 / cells;
    c.domain.y = {Boundary::periodic, 1.2e-3, cells};
    for (const int rows : {5, 6})
    {
      c.upper.shape = Roller{R, rows * dy};
      if ((rows - cells) % 2 == 0)
        EXPECT_NO_THROW(static_cast<void>(plan(c)));
      else
        EXPECT_THROW(static_cast<void>(plan(c)), GridError);
    }
  }
}

// --- approach -----------------------------------------------------------------------------------------------------

TEST(PeriodicApproach, EndsAtTheMeanDistanceOfTheSurfaces)
{
  const auto refused = [](const IndentationCase& c)
  {
    return reason_against_approach(c.lower, c.upper, c.sequence.front().value, c.domain, "IndentationCase").has_value();
  };
  EXPECT_TRUE(refused(flats(approach(1e-9)))) << "waves touch before their mean planes do";
  EXPECT_THROW(static_cast<void>(plan(flats(approach(1e-9)))), InputError);
  // Flats that touch all around a dent: full contact at its mean depth.
  IndentationCase dented = flats(approach(0.0));
  dented.lower.texture = Dent{.depth = 1e-6, .edge_radius = 0.2e-3};
  const SurfaceGrid g = sampled_period(dented.domain);
  double mean = 0.0;
  for (const double d : sampled_depths(dented.lower.texture, g))
    mean += d / static_cast<double>(g.size());
  ASSERT_GT(mean, 0.0);
  dented.sequence = {approach(0.99 * mean)};
  EXPECT_FALSE(refused(dented));
  dented.sequence = {approach(1.01 * mean)};
  EXPECT_TRUE(refused(dented));
  // A ball: the mean of r^2/(2 R) over the square is L^2/(12 R).
  IndentationCase ball = flats(approach(0.0));
  ball.lower.texture = {};
  ball.upper.shape = Paraboloid{R, R};
  for (const double share : {0.95, 1.05})
  {
    ball.sequence = {approach(share * 1e-6 / (12.0 * R))};
    EXPECT_EQ(refused(ball), share > 1.0);
  }
  // Nothing of this with an open axis.
  EXPECT_FALSE(refused(cylinder(approach(1e-3))));
}

TEST(PeriodicApproach, CountsShapesWhereTheCellsAre)
{
  // Four columns of a run lie at -1, 0, 1 and 2 cells from the middle, four rows at -1.5, -0.5, 0.5 and 1.5.
  constexpr double cell = 0.25e-3;
  IndentationCase c = flats(approach(0.0));
  c.upper.shape = Paraboloid{R, R};
  c.domain.x.cells = c.domain.y.cells = 4;
  const double mean_square = (1.0 + 0.0 + 1.0 + 4.0) / 4.0 + (2.25 + 0.25 + 0.25 + 2.25) / 4.0;
  const double ball = cell * cell * mean_square / (2.0 * R);
  c.lower.texture = {};
  const auto refused = [&](double share)
  { return reason_against_approach(c.lower, c.upper, share * ball, c.domain, "IndentationCase").has_value(); };
  EXPECT_FALSE(refused(1.0 - 1e-6));
  EXPECT_TRUE(refused(1.0 + 1e-6));
  // Mean displacements are zero, so a run with an imposed approach keeps the mean distance less that approach as mean gap.
  const double imposed = 0.96 * ball; // which centred columns, of mean square 2.5, do not allow
  c.sequence = {approach(imposed)};
  c.steps = 1;
  EXPECT_NEAR(run(c, {}).last.mean_gap, ball - imposed, 1e-6 * ball);
}

TEST(PeriodicLoad, DoesNotYieldEverythingBeneath)
{
  // Held in its plane under p, s_zz = -p and s_xx = s_yy = -nu/(1 - nu) p.
  IndentationCase c = flats(load(0.0));
  c.lower.material.hardening = constitutive::LinearHardening{600e6, 20e9};
  const double most = 600e6 * 0.7 / 0.4 * 1e-6; // on 1 mm^2
  c.sequence = {load(0.99 * most)};
  EXPECT_NO_THROW(static_cast<void>(plan(c)));
  c.sequence = {load(1.01 * most)};
  EXPECT_THROW(static_cast<void>(plan(c)), InputError);
  c.lower.material.yield_factor = constitutive::DepthProfile({0.0, 1e-4}, {0.5, 1.1}); // what counts is the core
  EXPECT_NO_THROW(static_cast<void>(plan(c)));
  c.lower.material.hardening.reset();
  c.sequence = {load(100.0 * most)};
  EXPECT_NO_THROW(static_cast<void>(plan(c)));
}

// --- textures -----------------------------------------------------------------------------------------------------

TEST(RoughnessTest, WavelengthOfWavesAndOfIsotropicSurfaces)
{
  // Differences of points n to a wave see its slope by sin(pi/n)/(pi/n).
  constexpr int n = 64;
  const double seen = std::sin(pi / n) / (pi / n);
  const double length = 2e-3;
  const SurfaceGrid grid{2 * n, 2 * n, length / n, length / n, Boundary::periodic, Boundary::periodic};
  const auto roughness = [&](const Texture& t) { return roughness_of(depths(t, grid, 0.0, 0.0), grid); };
  const double A = 3e-6;
  const Roughness along_x = roughness(Sinusoid{.amplitude = A, .wavelength_x = length});
  EXPECT_NEAR(along_x.height, A / std::sqrt(2.0), 1e-9 * A);
  EXPECT_NEAR(along_x.slope, seen * 2.0 * pi / length * A / std::sqrt(2.0), 1e-9 * A / length);
  EXPECT_NEAR(along_x.wavelength(), length / seen, 1e-9 * length);
  // Crossed waves of one length have wavevectors at 45 degrees, of sqrt(2) times the wavenumber.
  const Roughness crossed = roughness(Sinusoid{.amplitude = A, .wavelength_x = length, .wavelength_y = length});
  EXPECT_NEAR(crossed.wavelength(), length / std::sqrt(2.0) / seen, 1e-9 * length);
  // An isotropic surface: as the sum over its waves has it.
  const RandomSurface random({.hurst = 0.8,
                              .rms_height = 1e-6,
                              .rms_slope = {},
                              .rolloff = 2.0 * length,
                              .cutoff = 0.5 * length,
                              .size_x = 2.0 * length,
                              .size_y = 2.0 * length,
                              .seed = 3});
  const Roughness of_random = roughness(random);
  EXPECT_NEAR(of_random.height, random.rms_height(), 1e-9 * random.rms_height());
  EXPECT_NEAR(of_random.slope, random.rms_slope(), 0.005 * random.rms_slope()); // differences, 32 to the shortest wave
  // The same without the differences around the period.
  SurfaceGrid open = grid;
  open.boundary_x = open.boundary_y = Boundary::open;
  const Roughness of_map = roughness_of(depths(random, grid, 0.0, 0.0), open);
  EXPECT_NEAR(of_map.wavelength(), of_random.wavelength(), 0.03 * of_random.wavelength()); // one row and column less
}

TEST(TextureFootprint, OfAPlaneProblemCoversWhatTheContactCovers)
{
  // The cylinder bears on two crests at twice the half-width of the smooth contact. What the run finds on fine cells lies in
  // the cover, which has one coarse cell more at either end, of a fortieth of the coarse grid.
  IndentationCase c = cylinder(load(2e4));
  const Footprint bare = smooth(c);
  c.lower.texture = Sinusoid{.amplitude = 1e-6, .wavelength_x = 4.0 * bare.half_x, .x = 2.0 * bare.half_x};
  c.steps = 1;
  const Footprint rough = footprint(c.lower, c.upper, c.sequence.front(), c.domain);
  const IndentationPlan p = plan(c);
  const IndentationSummary summary = run(c, {});
  const double reached = 0.5 * summary.coverage.contact_columns * p.contact.dx;
  EXPECT_GT(reached, 2.0 * bare.half_x);
  EXPECT_GE(rough.over_x, reached - p.contact.dx);
  EXPECT_LE(rough.over_x, reached + p.contact.dx + 2.0 * 5.0 * bare.half_x / 41.0);
  EXPECT_TRUE(summary.grid_changes.empty()) << "the grid was wide enough";
  // More rows of the same change nothing.
  c.domain.y.cells = 5;
  const Footprint rows = footprint(c.lower, c.upper, c.sequence.front(), c.domain);
  EXPECT_DOUBLE_EQ(rows.over_x, rough.over_x);
  EXPECT_DOUBLE_EQ(rows.over_y, rough.over_y);
}

TEST(TextureFootprint, FlatsThatFitIntoEachOtherAreRefused)
{
  IndentationCase c = flats(load(1.0));
  c.upper.texture = c.lower.texture;
  std::get<Sinusoid>(c.upper.texture.parts.front()).amplitude *= -1.0;
  expect_refused(c, "upper.texture", "the same everywhere in the period");
}

} // namespace
} // namespace brinell::simulation::domain_test
