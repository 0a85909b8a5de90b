// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/first_yield.hpp"
#include "brinell/simulation/run.hpp"
#include "quality_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace brinell::quality::quality_test
{
namespace
{

TEST(Quality, AGoodRunHasNoWarnings)
{
  const RollingCase c = ball_on_flat();
  EXPECT_EQ(before(c), Keys{});
  EXPECT_EQ(after(c, good_totals(c)), Keys{});
}

TEST(Quality, TheSmallerOfBothDirectionsIsTold)
{
  const RollingCase c = ball_on_flat();
  RunTotals t = good_totals(c);
  t.coverage.contact_columns = 17;
  t.coverage.contact_rows = 9;
  const Resolution r = quality::judged(c, plan(c), t).resolution;
  EXPECT_EQ(r.cells_x, 8.5);
  EXPECT_EQ(r.cells_y, 4.5);
  EXPECT_EQ(r.cells, 4.5);
  EXPECT_EQ(r.plastic_layers, 20);
  EXPECT_NE(resolution_text(r).find("8.5 x 4.5 cells per contact radius, 20 layers"), std::string::npos);
}

TEST(Quality, CoarseContact)
{
  RollingCase c = ball_on_flat();
  RunTotals t = good_totals(c);
  t.coverage.contact_columns = 11; // 5.5 per radius
  EXPECT_EQ(after(c, t), Keys{"coarse_contact"});
  t = good_totals(c);
  t.coverage.contact_rows = 5; // across the motion half as many are enough, not 2.5
  EXPECT_EQ(after(c, t), Keys{"coarse_contact"});
  c.resolution = 3.0;
  EXPECT_EQ(before(c), Keys{"coarse_contact"});
  c.resolution = 1.5;
  EXPECT_NE(quality::expected(c, plan(c)).warnings.at(0).text.find("no number"), std::string::npos);
}

// A ball of three cells per radius is judged coarse below that; six to the radius of a void make 4 %.
TEST(Quality, CoarseInclusionsAreTold)
{
  RollingCase c = ball_on_flat();
  c.distance = 1e-4;
  const double cell = plan(c).contact.dy; // the largest size of a cell
  InclusionShape ball{InclusionShape::Kind::ellipsoid, {0.0, 0.0, 5.0 * cell}, {}};
  ball.semi_axes.fill(3.0 * cell);
  c.lower.inclusions = {{{0.0, 0.3}, ball}};
  EXPECT_EQ(before(c), Keys{});
  EXPECT_TRUE(quality::expected(c, plan(c)).resolution.expected_errors.empty());
  c.lower.inclusions.clear();
  EXPECT_FALSE(quality::expected(c, plan(c)).resolution.expected_errors.empty());
  c.lower.inclusions = {{{0.0, 0.3}, ball}};
  ball.semi_axes.fill(2.4 * cell);
  c.lower.inclusions.front().region = ball;
  EXPECT_EQ(before(c), Keys{"coarse_inclusion"});
  EXPECT_NE(quality::expected(c, plan(c)).warnings.at(0).text.find("wrong by about 10 %"), std::string::npos);
  ball.centre[1] = 0.5 * plan(c).contact.ny * cell;
  c.lower.inclusions.front().region = ball;
  EXPECT_EQ(before(c), (Keys{"coarse_inclusion", "cut_inclusion"}));
  const int across = 8;
  simulation::InclusionVoxels voxels{{across, across, across}, {0.0, 0.0, cell}, cell, {}};
  voxels.is_filled.assign(across * across * across, 1);
  c.lower.inclusions.front().region = voxels;
  EXPECT_EQ(before(c), Keys{});
  voxels.size = 0.2 * cell;
  voxels.corner[2] = cell;
  c.lower.inclusions.front().region = voxels;
  EXPECT_EQ(before(c), (Keys{"coarse_inclusion", "fine_voxels"}));
}

TEST(Quality, MisfitsThatYieldByThemselvesAreTold)
{
  RollingCase c = ball_on_flat();
  c.distance = 1e-4;
  const double cell = plan(c).contact.dy;
  InclusionShape ball{InclusionShape::Kind::ellipsoid, {0.0, 0.0, 5.0 * cell}, {}};
  ball.semi_axes.fill(3.0 * cell);
  c.lower.inclusions = {{c.lower.material.elastic, ball}};
  c.lower.inclusions.front().own.dilatation = 1e-4;
  const double ratio = plan(c).inclusions[0].at_rest;
  c.lower.inclusions.front().own.dilatation *= 0.99 / ratio;
  EXPECT_EQ(before(c), Keys{});
  c.lower.inclusions.front().own.dilatation *= 1.02;
  EXPECT_EQ(before(c), Keys{"yields_at_rest"});
  c.lower.material.yield_factor = constitutive::DepthProfile({0.0}, {1.05}); // of a hardened body
  EXPECT_EQ(before(c), Keys{});
  c.lower.inclusions.front().own.dilatation *= 1.05;
  EXPECT_EQ(before(c), Keys{"yields_at_rest"});
}

TEST(Quality, PlaneEndsOfARollerHaveNoExpectedErrors)
{
  RollingCase c = ball_on_flat();
  c.upper.shape = Roller{10e-3, 1e-3};
  c.drive.value = 1500.0;
  EXPECT_EQ(before(c), Keys{"sharp_end"});
  EXPECT_TRUE(quality::expected(c, plan(c)).resolution.expected_errors.empty());
  RunTotals t = good_totals(c);
  const double dy = plan(c).contact.dy;
  t.coverage.contact_rows = static_cast<int>(std::floor(1e-3 / dy));
  EXPECT_EQ(after(c, t), Keys{"sharp_end"});
  EXPECT_TRUE(quality::judged(c, plan(c), t).resolution.expected_errors.empty());
  t.coverage.contact_rows = static_cast<int>(std::floor(0.8e-3 / dy)); // as with ends that a texture rounds
  EXPECT_EQ(after(c, t), Keys{});
  c.domain.y = {Boundary::periodic, 1.0, 1}; // plane strain, the load is that of 1 m
  c.drive.value = 1.5e6;
  c.upper.shape = Roller{10e-3, std::numeric_limits<double>::infinity()};
  EXPECT_EQ(before(c), Keys{});
}

TEST(Quality, ExpectedErrorsFollowTheTables)
{
  const RollingCase c = ball_on_flat();
  RunTotals t = good_totals(c);
  t.coverage.contact_columns = t.coverage.contact_rows = 8; // four per radius, as in the table
  Quality q = quality::judged(c, plan(c), t);
  ASSERT_EQ(q.resolution.expected_errors.at(0).quantity, "rut");
  const double at_four = q.resolution.expected_errors.at(0).relative;
  EXPECT_NEAR(at_four, 0.085, 1e-12);
  t.coverage.contact_columns = t.coverage.contact_rows = 16;
  EXPECT_NEAR(quality::judged(c, plan(c), t).resolution.expected_errors.at(0).relative, at_four / std::pow(2.0, 1.5),
              1e-12);
  t.coverage.contact_columns = t.coverage.contact_rows = 1;
  for (const ExpectedError& e : quality::judged(c, plan(c), t).resolution.expected_errors)
    EXPECT_LE(e.relative, 1.0);
}

TEST(Quality, PercentsAreNeverPowersOfTen)
{
  EXPECT_EQ(percent_text(0.0254), "2.5 %");
  EXPECT_EQ(percent_text(0.994), "99 %");
  EXPECT_EQ(percent_text(0.996), "100 %");
  EXPECT_EQ(percent_text(3.57), "357 %");
}

TEST(Quality, CoarseDepth)
{
  const RollingCase c = ball_on_flat();
  RunTotals t = good_totals(c);
  t.coverage.plastic_layers = 3;
  EXPECT_EQ(after(c, t), Keys{"coarse_depth"});
}

TEST(Quality, NothingTouches)
{
  const RollingCase c = ball_on_flat();
  RunTotals t = good_totals(c);
  t.max_equivalent_plastic_strain = 0.0;
  t.coverage = {};
  EXPECT_EQ(after(c, t), Keys{"no_contact"});
}

TEST(Quality, NothingYields)
{
  RollingCase c = ball_on_flat();
  RunTotals t = good_totals(c);
  t.max_equivalent_plastic_strain = 0.0;
  t.coverage.plastic_layers = 0;
  c.drive.value = 1.0;
  EXPECT_EQ(after(c, t), Keys{"no_yield"});
  EXPECT_EQ(before(c), Keys{"no_yield"});
  c.lower.material.hardening.reset(); // elastic on purpose
  EXPECT_EQ(before(c), Keys{});
  EXPECT_EQ(after(c, t), Keys{});
}

TEST(Quality, YieldThatNoCellHasSeenIsTold)
{
  // Smooth bodies yield in theory, and the cells know better only if surfaces may stick: then the shear is less than that of sliding.
  RunTotals t = good_totals(ball_on_flat());
  t.max_equivalent_plastic_strain = 0.0;
  t.coverage.plastic_layers = 0;
  const auto pressed_to = [&](RollingCase c, double share) // of the peak pressure at first yield of sliding surfaces
  {
    c.friction.coefficient = 0.4;
    const double least = earliest_first_yield(c.lower, c.upper, c.domain, 0.4)->critical.load;
    c.drive.value = std::pow(share, 3) * least;
    return c;
  };
  RollingCase sliding = ball_on_flat();
  sliding.slide_to_roll = 0.5;
  EXPECT_EQ(after(pressed_to(sliding, 0.99), t), Keys{"no_yield"});
  const RollingCase above = pressed_to(sliding, 1.12);
  EXPECT_EQ(after(above, t), Keys{"missed_yield"});
  EXPECT_NEAR(plan(above).peak_over_yield, 1.12, 1e-3); // of the search for the largest stress
  EXPECT_NE(quality::judged(above, plan(above), t).warnings.front().text.find("1.12 times"), std::string::npos);
  RollingCase creeping = pressed_to(ball_on_flat(), 1.12);
  creeping.creepage = Creepage{1e-3, 0.0, 0.0};
  EXPECT_EQ(after(creeping, t), Keys{"no_yield"});
  RollingCase line = sliding;
  line.upper.shape = Roller{5e-3, std::numeric_limits<double>::infinity()};
  line.domain.y = {Boundary::periodic, 1e-3, 1};
  const double of_line = earliest_first_yield(line.lower, line.upper, line.domain, 0.4)->critical.load;
  line.friction.coefficient = 0.4;
  line.drive.value = 1.12 * 1.12 * of_line; // the peak pressure grows as the root of the load
  EXPECT_NEAR(plan(line).peak_over_yield, 1.12, 1e-3);
  EXPECT_EQ(after(line, t), Keys{"missed_yield"});
}

TEST(Quality, CourseOfTheRun)
{
  const RollingCase c = ball_on_flat();
  RunTotals t = good_totals(c);
  t.max_equivalent_plastic_strain = 0.06;
  EXPECT_EQ(after(c, t), Keys{"large_strain"});
  t = good_totals(c);
  t.energy_balance_error = -0.03;
  EXPECT_EQ(after(c, t), Keys{"energy_balance"});
  t.energy_balance_error = std::nan("");
  EXPECT_EQ(after(c, t), Keys{"energy_balance"});
  t = good_totals(c);
  t.split_increments = 2;
  EXPECT_EQ(after(c, t), Keys{"split_increments"});
}

TEST(Quality, LayersThinnerThanTheCells)
{
  using constitutive::DepthProfile;
  RollingCase c = ball_on_flat();
  const double dz = plan(c).lower.dz;
  const auto with_factor = [&](const DepthProfile& profile)
  {
    c.lower.material.yield_factor = profile;
    return after(c, good_totals(c));
  };
  EXPECT_EQ(with_factor({{0.0, 0.3 * dz, 0.31 * dz}, {1.5, 1.5, 1.0}}), Keys{"coarse_profile"});
  EXPECT_EQ(with_factor({{2.6 * dz, 3.0 * dz, 3.4 * dz}, {1.0, 0.8, 1.0}}), Keys{"coarse_profile"})
      << "between two middles";
  EXPECT_EQ(with_factor({{0.0, 4.0 * dz, 4.01 * dz}, {1.5, 1.5, 1.0}}), Keys{}) << "a step lies between two layers";
  EXPECT_EQ(with_factor({{0.0, 10.0 * dz}, {1.5, 1.0}}), Keys{});
  c.lower.material.yield_factor = {};
  c.lower.material.initial_stress = DepthProfile{{0.0, 0.3 * dz}, {-5e8, 0.0}};
  EXPECT_EQ(after(c, good_totals(c)), Keys{"coarse_profile"});
  c.lower.material.initial_stress = DepthProfile{{0.0, 10.0 * dz}, {-5e8, 0.0}};
  EXPECT_EQ(after(c, good_totals(c)), Keys{});
}

TEST(Quality, StepsAndTolerancesAndSizes)
{
  RollingCase c = ball_on_flat();
  c.shift = 0.5 * plan(c).half_width_x;
  EXPECT_EQ(before(c), Keys{"long_step"});
  c = ball_on_flat();
  c.solver.contact_tolerance = 0.05;
  EXPECT_EQ(before(c), Keys{"loose_tolerance"});
  c = ball_on_flat();
  c.lower.material.hardening.reset();
  c.drive.value = 1e-6; // some 20 pm of approach
  c.distance = 1e-5;
  EXPECT_EQ(before(c), Keys{"small_size"});
}

TEST(Quality, TexturesFinerThanTheCells)
{
  RollingCase c = ball_on_flat();
  const double cell = plan(c).contact.dx, row = plan(c).contact.dy;
  c.lower.texture = Dent{0.0, 0.0, 1e-6, 3.0 * cell};
  EXPECT_EQ(before(c).front(), "coarse_texture");
  EXPECT_EQ(after(c, good_totals(c)).front(), "coarse_texture");
  c.lower.texture = Dent{0.0, 0.0, 1e-6, 5.0 * cell};
  EXPECT_EQ(before(c), Keys{});
  c.upper.texture = HeightMap{3, 3, 0.5 * cell, row, 0.0, 0.0, std::vector<double>(9, 0.0)};
  EXPECT_EQ(before(c), Keys{"coarse_texture"});
  c.upper.texture = HeightMap{3, 3, cell, row, 0.0, 0.0, std::vector<double>(9, 0.0)};
  EXPECT_EQ(before(c), Keys{});
  const auto measured = [&](double cells_per_wave)
  {
    HeightMap map{100, 20, cell, row, 0.0, 0.0, {}};
    for (int i = 0; i < 2000; ++i)
      map.heights.push_back(1e-8 * std::cos(2.0 * std::numbers::pi * (i % 100) / cells_per_wave));
    return map;
  };
  c.upper.texture = measured(10.0);
  EXPECT_EQ(before(c), Keys{});
  c.upper.texture = measured(5.0);
  EXPECT_EQ(before(c), Keys{"coarse_texture"});
}

TEST(Quality, OneStepOfAnElasticIndentationIsRight)
{
  // Hertz: the work is 2/5 of load times approach; the trapezoid of one step would be a quarter too large.
  IndentationCase c;
  c.lower = {Plane{}, {{210e9, 0.3}, {}}};
  c.upper = {Paraboloid{1e-3, 1e-3}, {{210e9, 0.3}, {}}};
  c.sequence = {{contact::Drive::Kind::load, 10.0}};
  c.steps = 1;
  const IndentationSummary s = run(c);
  EXPECT_EQ(s.energy_balance_error, 0.0);
  for (const Warning& warning : quality::judged(c, plan(c), s).warnings)
    EXPECT_NE(warning.key, "energy_balance");
  ASSERT_EQ(s.indents.size(), 1U);
  const double exact = 0.4 * 10.0 * s.indents[0].max_approach;
  EXPECT_NEAR(s.indents[0].work / exact, 1.0, 1e-2); // of the cells
  EXPECT_EQ(s.work, s.indents[0].work);
  c.sequence.push_back({contact::Drive::Kind::load, 0.0});
  c.cycles = 2;
  const IndentationSummary back = run(c);
  ASSERT_EQ(back.indents.size(), 2U);
  for (const Indent& indent : back.indents)
    EXPECT_NEAR(indent.work / exact, 0.0, 1e-12);
}

TEST(Quality, CreepForcesHaveAnErrorToExpectAlsoOfElasticBodies)
{
  RollingCase c = ball_on_flat();
  c.lower.material.hardening.reset();
  c.upper.material.hardening.reset();
  const auto first = [&] { return quality::expected(c, plan(c)).resolution.expected_errors.front().quantity; };
  EXPECT_EQ(first(), "contact area");
  c.friction.coefficient = 0.3;
  c.creepage = Creepage{1e-3, 0.0, 0.0};
  EXPECT_EQ(first(), "creep force");
}

TEST(Quality, WavesNeedEightCells)
{
  RollingCase c = ball_on_flat();
  const double dx = plan(c).contact.dx, dy = plan(c).contact.dy;
  const auto text = [&] { return quality::expected(c, plan(c)).warnings.at(0).text; };
  c.lower.texture = Sinusoid{.amplitude = 1e-9, .wavelength_x = 7.9 * dx};
  EXPECT_EQ(before(c), Keys{"coarse_texture"});
  EXPECT_EQ(after(c, good_totals(c)), Keys{"coarse_texture"});
  EXPECT_EQ(text().find("only the mean"), std::string::npos) << text();
  c.lower.texture = Sinusoid{.amplitude = 1e-9, .wavelength_x = 8.1 * dx, .wavelength_y = 8.1 * dy};
  EXPECT_EQ(before(c), Keys{});
  const auto rough = [&](double cells)
  {
    return RandomSurface({.hurst = 0.8,
                          .rms_height = 1e-9,
                          .rms_slope = {},
                          .rolloff = 20.0 * dx,
                          .cutoff = cells * std::max(dx, dy),
                          .size_x = 100.0 * dx,
                          .size_y = 100.0 * dx,
                          .seed = 1});
  };
  c.lower.texture = rough(8.1);
  EXPECT_EQ(before(c), Keys{});
  c.lower.texture = std::vector<TexturePart>{Sinusoid{.amplitude = 1e-9, .wavelength_x = 1.0}, rough(1.9)};
  EXPECT_EQ(before(c), Keys{"coarse_texture"});
  EXPECT_EQ(text().find("lower.texture[1]: roughness with waves down to"), 0u) << text();
  EXPECT_NE(text().find("only the mean"), std::string::npos) << text();
}

TEST(Quality, CellsAndStepsBeyondTheContactAreRefused)
{
  EXPECT_FALSE(reason_against_cells({1e-5, 1e-5, 1e-5}, 1e-5, 1e-5));
  EXPECT_TRUE(reason_against_cells({1.1e-5, 1e-5, 1e-5}, 1e-5, 1e-5));
  EXPECT_TRUE(reason_against_cells({1e-5, 1.1e-5, 1e-5}, 1e-5, 1e-5));
  EXPECT_FALSE(reason_against_shift(2e-5, 1e-5));
  EXPECT_TRUE(reason_against_shift(2.1e-5, 1e-5));
}

TEST(Texture, FinerThanTheCellsCountsWithItsMean)
{
  // Columns of height 0 and 2e-6, two per cell: a point sample would find one or the other.
  HeightMap map{100, 100, 1e-6, 1e-6, 0.0, 0.0, std::vector<double>(10000)};
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    map.heights[i] = i % 2 == 0 ? 0.0 : 2e-6;
  const Texture texture = map;
  // Bilinear teeth of 2 um period, read over 4 um: the mean to the spacing of the samples.
  EXPECT_NEAR(cell_depth(texture, 0.3e-6, 0.0, 4e-6, 4e-6), -1e-6, 0.05e-6);
  EXPECT_EQ(cell_depth(texture, 0.3e-6, 0.0, 1e-6, 1e-6), depth(texture, 0.3e-6, 0.0)); // resolved: as it is
  // A bump between the centres of cells is no longer lost.
  const Texture bump = Dent{5e-6, 5e-6, -1e-6, 1e-6};
  EXPECT_NEAR(depth(bump, 0.0, 0.0), 0.0, 1e-12);
  EXPECT_LT(cell_depth(bump, 0.0, 0.0, 10.5e-6, 10.5e-6), -1e-9);
}

// Half of the energy in one quarter is no average; a tenth more is what is called steady.
TEST(Quality, UnsteadyTrack)
{
  const RollingCase c = ball_on_flat();
  RollingSummary s;
  static_cast<RunTotals&>(s) = good_totals(c);
  s.passes.resize(2);
  s.passes[1].unsteadiness = 0.1;
  EXPECT_EQ(keys(quality::judged(c, plan(c), s)), Keys{});
  s.passes[1].unsteadiness = 0.5;
  const Quality unsteady = quality::judged(c, plan(c), s);
  ASSERT_EQ(keys(unsteady), Keys{"unsteady_track"});
  EXPECT_NE(unsteady.warnings[0].text.find("pass 2: the energy absorbed per length differs by 50 %"),
            std::string::npos);
  EXPECT_EQ(unsteady.warnings[0].text.find("texture"), std::string::npos);
}

TEST(Quality, ARutNearZeroHasNoExpectedError)
{
  const RollingCase c = ball_on_flat();
  RollingSummary s;
  static_cast<RunTotals&>(s) = good_totals(c);
  s.passes.resize(1);
  const auto has_rut = [&](double depth)
  {
    s.passes[0].rut_depth = depth;
    const auto errors = quality::judged(c, plan(c), s).resolution.expected_errors;
    return std::any_of(errors.begin(), errors.end(), [](const ExpectedError& e) { return e.quantity == "rut"; });
  };
  EXPECT_TRUE(has_rut(0.06 * s.max_residual_lower));
  EXPECT_TRUE(has_rut(-0.06 * s.max_residual_lower));
  EXPECT_FALSE(has_rut(0.04 * s.max_residual_lower));
}

TEST(Quality, RoughFlatsHaveWavesAndNoContactRadius)
{
  IndentationCase c;
  c.lower = {Plane{}, {{210e9, 0.3}, constitutive::PerfectPlasticity{1e9}}};
  c.upper = {Plane{}, {{210e9, 0.3}, {}}};
  c.upper.texture = Sinusoid{.amplitude = 1e-6, .wavelength_x = 40e-6, .wavelength_y = 80e-6};
  for (Domain::Axis* axis : {&c.domain.x, &c.domain.y})
    *axis = {Boundary::periodic, 80e-6, 20}; // cells of 4 um
  c.domain.layer = 2e-6;
  c.sequence = {{contact::Drive::Kind::load, 0.1}};
  const Resolution expected = quality::expected(c, plan(c)).resolution;
  EXPECT_DOUBLE_EQ(expected.cells_per_wave.value(), 10.0);
  EXPECT_TRUE(std::isnan(expected.cells));
  EXPECT_FALSE(expected.expected_errors.empty());
  RunTotals t;
  t.coverage = {5, 5, 8};
  t.max_equivalent_plastic_strain = 0.01;
  t.energy_balance_error = 1e-3;
  const Quality q = quality::judged(c, plan(c), t);
  EXPECT_EQ(keys(q), Keys{});
  const std::string text = resolution_text(q.resolution);
  EXPECT_TRUE(text.starts_with("resolution: 10 cells per shortest wave, for a contact of patches of various sizes, "
                               "8 layers through the plastic zone; expected errors"))
      << text;
  t.coverage.contact_columns = t.coverage.contact_rows = 0;
  EXPECT_EQ(resolution_text(quality::judged(c, plan(c), t).resolution), "resolution: no contact");
  c.upper.texture = {}; // one pile of cells for a ball in a period, as for one alone
  c.upper.shape = Paraboloid{1e-4, 1e-4};
  EXPECT_FALSE(quality::expected(c, plan(c)).resolution.cells_per_wave.has_value());
}

TEST(Quality, TexturesOfTugging)
{
  const constitutive::Material steel{{200e9, 0.3}, constitutive::PerfectPlasticity{1e9}};
  TuggingCase t;
  t.lower = t.upper = {Paraboloid{1e-3, 1e-3}, steel};
  t.interference = 1e-6;
  const auto warnings = [&] { return keys(quality::expected(t, plan(t))); };
  EXPECT_EQ(warnings(), Keys{});
  const double cell = plan(t).contact.dy;
  t.upper.texture = Dent{.depth = -1e-7, .edge_radius = 3.5 * cell};
  EXPECT_EQ(warnings(), Keys{"coarse_texture"});
  t.upper.texture = Dent{.depth = -1e-7, .edge_radius = 4.5 * cell};
  EXPECT_EQ(warnings(), Keys{});
  // Where the smooth bodies would stay elastic, those on a bump may yield.
  t.interference = 1e-8;
  EXPECT_EQ(warnings(), Keys{});
  t.upper.texture = {};
  EXPECT_EQ(warnings(), Keys{"no_yield"});
}

} // namespace
} // namespace brinell::quality::quality_test
