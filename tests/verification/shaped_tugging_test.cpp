// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/hertz.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

/// Tugging of bodies that are no spheres, and of surfaces with something on them.
namespace brinell::verification::shaped_tugging_test
{
namespace
{

using simulation::Dent;
using simulation::TuggingCase;
using simulation::TuggingRecord;

/// Half-length of the elastic contact at alignment of two spheres of 1 m.
double contact_radius(double interference_ratio)
{
  return std::sqrt(0.5 * interference_ratio * critical().interference);
}

/// Of `share` of the interference in height, with its middle at x on the body.
Dent bump(double interference_ratio, double share, double x, double radius)
{
  return {.x = x, .depth = -share * interference_ratio * critical().interference, .edge_radius = 0.25 * radius};
}

/// Square cells, `cells` of them per contact radius, and few layers.
TuggingCase elastic_case(double interference_ratio, double cells)
{
  TuggingCase t = equal_spheres(interference_ratio, elastic_material());
  const double a = contact_radius(interference_ratio);
  t.spacing = {{a / cells, a / cells, a}};
  return t;
}

/// Rows of both histories at the same place.
std::vector<std::pair<TuggingRecord, TuggingRecord>> at_same_places(const TuggingRun& a, const TuggingRun& b)
{
  std::vector<std::pair<TuggingRecord, TuggingRecord>> rows;
  for (const TuggingRecord& r : a.history)
    for (const TuggingRecord& s : b.history)
      if (std::abs(r.X - s.X) < 1e-9 * a.plan.start_distance)
        rows.emplace_back(r, s);
  return rows;
}

double largest_work(const TuggingRun& run)
{
  double largest = 0.0;
  for (const TuggingRecord& r : run.history)
    largest = std::max(largest, std::abs(r.work));
  return largest;
}

TEST(TexturedTugging, WithoutHeightItIsSmooth)
{
  TuggingCase t = small_case(4.0);
  t.upper.shape = ball(1.3);
  const TuggingRun smooth = computed(t);
  t.lower.texture = Dent{.depth = 0.0, .edge_radius = 0.005};
  t.upper.texture = simulation::sampled([](double, double) { return 0.0; }, 21, 11, 0.01, 0.01);
  const TuggingRun flat = computed(t);
  ASSERT_EQ(smooth.history.size(), flat.history.size());
  for (const auto& [what, quantity] : {std::pair{"F_X", &TuggingRecord::F_X}, {"F_Z", &TuggingRecord::F_Z}})
    test::expect_close(std::string("texture of no height: ") + what, difference(smooth, quantity, flat, quantity), 0.0,
                       1e-12, "exact: nothing is added");
  test::expect_close("texture of no height: dissipation", flat.summary.dissipation_lower,
                     smooth.summary.dissipation_lower, 1e-12 * smooth.summary.dissipation_lower,
                     "exact: nothing is added");
}

TEST(TexturedTugging, SwappingTheBodiesMirrorsTheResult)
{
  // Turned over about y, the body with the bump is the other one, and its bump lies on the other side of its top.
  TuggingCase t = small_case(4.0);
  const double a = contact_radius(4.0);
  t.upper.shape = ball(1.3);
  t.lower.texture = bump(4.0, 0.3, 0.6 * a, 1.5 * a);
  TuggingCase turned = t;
  std::swap(turned.lower, turned.upper);
  std::get<Dent>(turned.upper.texture.parts.front()).x *= -1.0;
  const TuggingRun run = computed(t), mirror = computed(turned);
  ASSERT_EQ(run.history.size(), mirror.history.size());
  const auto same = [&](const char* what, double TuggingRecord::*of_run, double TuggingRecord::*of_mirror)
  {
    // The tolerance of the iteration, 1e-4 of the yield stress in a cell, added up over the steps.
    test::expect_close(std::string("bump, swapped: ") + what, difference(run, of_run, mirror, of_mirror), 0.0, 1e-3,
                       "exact: symmetry");
  };
  same("F_X", &TuggingRecord::F_X, &TuggingRecord::F_X);
  same("F_Z", &TuggingRecord::F_Z, &TuggingRecord::F_Z);
  same("work", &TuggingRecord::work, &TuggingRecord::work);
  same("dissipation", &TuggingRecord::dissipation_lower, &TuggingRecord::dissipation_upper);
  // It matters where the bump is: with it on the same side the history is another one.
  std::get<Dent>(turned.upper.texture.parts.front()).x *= -1.0;
  EXPECT_GT(difference(run, &TuggingRecord::F_X, computed(turned), &TuggingRecord::F_X), 0.05);
}

TEST(TexturedTugging, ABumpLiftsWhereItPasses)
{
  const double alpha = 4.0;
  const double a = contact_radius(alpha);
  TuggingCase t = elastic_case(alpha, slow_build ? 6.0 : 10.0);
  const TuggingRun smooth = computed(t);
  // On the lower body, where the contact is half-way from first touch to alignment.
  const double x = -0.25 * smooth.plan.start_distance;
  // Round, without the hollow around it that a dent turned over has: what it adds is not taken away beside it.
  const double width = 0.3 * a;
  t.lower.texture = simulation::sampled([&](double u, double v)
                                        { return 0.2 * t.interference * std::exp(-(u * u + v * v) / (width * width)); },
                                        41, 41, 0.15 * width, 0.15 * width);
  std::get<simulation::HeightMap>(t.lower.texture.parts.front()).x = x;
  const TuggingRun rough = computed(t);
  double largest = 0.0, place = 0.0, beyond = 0.0;
  for (const auto& [without, with] : at_same_places(smooth, rough))
  {
    const double rise = with.F_Z - without.F_Z;
    const double arc = 0.5 * 2.0 * std::atan(without.X / 2.0); // of the contact's middle, on a sphere of 1 m
    if (rise > largest)
    {
      largest = rise;
      place = arc;
    }
    if (arc - x > 1.7 * a) // three widths behind the contact's edge
      beyond = std::max(beyond, std::abs(rise));
  }
  const double scale = rough.summary.peak_F_Z;
  test::expect_within("rise of F_Z on a bump of a fifth of the interference / peak F_Z", largest / scale, 0.02, 0.3,
                      "bound: seen, and less than if all the contact were raised, 1.5 times the fifth");
  test::expect_close("place of the largest rise / contact radius", place / a, x / a, 0.5,
                     "bound: under the contact, which grows towards alignment");
  test::expect_close("change of F_Z away from it / peak F_Z", beyond / scale, 0.0, 1e-3, "exact: not in the contact");
}

TEST(TexturedTugging, ElasticBodiesGiveEverythingBack)
{
  const double alpha = 4.0;
  const double a = contact_radius(alpha);
  std::vector<double> lost;
  for (const double cells : slow_build ? std::vector{6.0} : std::vector{6.0, 12.0})
  {
    TuggingCase t = elastic_case(alpha, cells);
    t.lower.texture = bump(alpha, 0.3, -0.7 * a, 2.0 * a);
    t.upper.texture = bump(alpha, 0.2, 1.1 * a, 1.5 * a);
    const TuggingRun run = computed(t);
    lost.push_back(run.summary.work / largest_work(run));
    // Steps and slopes of second order, where the bumps' own length of a quarter of their radius counts; the force has the
    // slope of the surface to first order, so its square, 1e-3 here, is missing.
    test::expect_close("net work over two bumps / largest, " + std::to_string(std::lround(cells)) + " cells",
                       lost.back(), 0.0, 1.0 / (cells * cells), "exact: nothing is lost");
    EXPECT_EQ(run.summary.dissipation_lower + run.summary.dissipation_upper, 0.0);
  }
}

TEST(TexturedTugging, ElasticRoughBodiesGiveEverythingBack)
{
  const double alpha = 4.0, a = contact_radius(alpha);
  const auto roughness = [&](std::uint64_t seed)
  {
    return simulation::RandomSurface({.hurst = 0.8,
                                      .rms_height = 0.02 * alpha * critical().interference,
                                      .rms_slope = {},
                                      .rolloff = 3.0 * a,
                                      .cutoff = 1.5 * a,
                                      .size_x = 24.0 * a,
                                      .size_y = 24.0 * a,
                                      .seed = seed});
  };
  const double cells = slow_build ? 6.0 : 10.0; // of them nine to the shortest wave in the slow build
  TuggingCase t = elastic_case(alpha, cells);
  t.lower.texture = roughness(1);
  t.upper.texture = std::vector<simulation::TexturePart>{
      roughness(2), simulation::Sinusoid{.amplitude = 0.02 * t.interference, .wavelength_x = 2.0 * a}};
  const TuggingRun run = computed(t);
  // As over bumps: of second order in the cell, and the square of the slopes is missing.
  test::expect_close("net work of rough bodies / largest", run.summary.work / largest_work(run), 0.0,
                     1.0 / (cells * cells), "exact: nothing is lost");
}

TEST(TexturedTugging, UnderALoadTheUpperBodyRidesOverTheBump)
{
  const double a = contact_radius(4.0);
  TuggingCase t = elastic_case(4.0, slow_build ? 4.0 : 8.0);
  t.load = 8.0 * critical().load; // that of the interference
  const TuggingRun smooth = computed(t);
  t.lower.texture = bump(4.0, 0.3, 0.0, 2.0 * a);
  t.upper.texture = bump(4.0, 0.1, 0.3 * a, 1.5 * a);
  const TuggingRun rough = computed(t);
  EXPECT_NEAR(rough.aligned().F_n, *t.load, 1e-6 * *t.load);
  test::expect_within("rise over a bump / its height",
                      (smooth.aligned().interference - rough.aligned().interference) / (0.3 * t.interference), 0.02,
                      1.0, "bound: lifted, by less than a stiff body would be");
  // As under a constant height; F_X and the rise of the body work together.
  test::expect_close("net work over bumps under a load / largest", rough.summary.work / largest_work(rough), 0.0, 2e-3,
                     "exact: nothing is lost");
}

TEST(TexturedTugging, EnergyBalances)
{
  const double a = contact_radius(6.0);
  TuggingCase t = small_case(6.0);
  t.lower.texture = bump(6.0, 0.3, 0.4 * a, 1.6 * a);
  t.passes = 2;
  const TuggingRun run = computed(t);
  EXPECT_EQ(run.plan.twin, elastoplastic::Twin::none);
  EXPECT_GT(run.summary.dissipation_lower, 0.0);
  // Coarse cells: the edge's error, first order in the cell at worst.
  test::expect_close("energy balance over a bump, two passes", run.summary.energy_balance_error, 0.0,
                     slow_build ? 0.1 : 0.05, "exact: conservation of energy");
}

TEST(TexturedTugging, BumpsBeyondTheSmoothContactAreMet)
{
  // One bump on the way to the first touch of the smooth bodies, one after their last: the pass takes both in.
  const double alpha = 2.0;
  TuggingCase t = elastic_case(alpha, 6.0);
  const double a = contact_radius(alpha);
  const double touch = 0.5 * simulation::plan(t).start_distance; // on the body
  for (const double side : {-1.0, 1.0})
  {
    t.lower.texture = bump(alpha, 1.0, side * (touch + 0.2 * a), 1.5 * a);
    const TuggingRun run = computed(t);
    double farthest = 0.0;
    for (const TuggingRecord& r : run.history)
      if (r.F_n > 0.0)
        farthest = std::max(farthest, side * r.X);
    const std::string name = side < 0.0 ? "bump before first touch: " : "bump after last touch: ";
    test::expect_within(name + "farthest contact / that of the smooth bodies", farthest / run.plan.start_distance, 1.02,
                        1.42, "bound: beyond the smooth bodies', within that of spheres larger by the bump");
    EXPECT_EQ(run.history.back().F_n, 0.0) << name;
    EXPECT_TRUE(run.summary.grid_changes.empty()) << name << simulation::text(run.summary.grid_changes.front());
  }
}

TEST(ShapedTugging, EllipsoidsFollowHertz)
{
  TuggingCase t = equal_spheres(4.0, elastic_material());
  t.lower.shape = simulation::Paraboloid{1.0, 2.5};
  t.upper.shape = simulation::Paraboloid{1.4, 0.8};
  t.resolution = slow_build ? 6.0 : 12.0;
  const TuggingRun run = computed(t);
  const auto k = *simulation::relative_curvature(t.lower.shape, t.upper.shape);
  double error = 0.0, largest = 0.0;
  for (const TuggingRecord& r : run.history)
  {
    const double hertz = r.interference > 0.0
                             ? reference::elliptical_contact_at_approach(
                                   1.0 / k[0], 1.0 / k[1], contact_modulus(elastic, elastic), r.interference)
                                   .load
                             : 0.0;
    error = std::max(error, std::abs(r.F_n - hertz));
    largest = std::max(largest, hertz);
  }
  // Cells are twice as long across the motion.
  test::expect_close("ellipsoids: error of F_n along the pass / largest", error / largest, 0.0,
                     0.25 * std::pow(0.5 * t.resolution, -1.5), "analytic: Hertz; edge error of the mesh");
  test::expect_close("ellipsoids: net work / largest", run.summary.work / largest_work(run), 0.0, 1e-3,
                     "exact: nothing is lost");
}

TEST(ShapedTugging, AlignedRollersAreThoseOfAnIndentation)
{
  TuggingCase t = equal_spheres(4.0, elastic_material());
  t.lower.shape = simulation::Roller{1.0, 0.3};
  t.upper.shape = simulation::Roller{1.5, 0.2};
  t.resolution = 6.0;
  const TuggingRun run = computed(t);
  simulation::IndentationCase c;
  c.lower = t.lower;
  c.upper = t.upper;
  c.sequence = {approach(t.interference)};
  c.steps = 1;
  c.spacing = std::array{run.plan.contact.dx, run.plan.contact.dy, run.plan.lower.dz};
  const double pressed = computed(c).history.back().F_n;
  test::expect_close("rollers aligned: F_n / that of an indentation", run.aligned().F_n / pressed, 1.0, 1e-4,
                     "exact: the same contact; tolerance of its solver");
}

TEST(ShapedTugging, EllipsoidsBalanceTheirEnergy)
{
  TuggingCase t = equal_spheres(4.0, perfect_material());
  t.lower.shape = simulation::Paraboloid{1.0, 2.5};
  t.upper.shape = simulation::Paraboloid{1.4, 0.8};
  t.resolution = slow_build ? 3.0 : 5.0;
  const TuggingRun run = computed(t);
  EXPECT_GT(run.summary.dissipation_lower, 0.0);
  test::expect_close("ellipsoids: energy balance", run.summary.energy_balance_error, 0.0, slow_build ? 0.1 : 0.05,
                     "exact: conservation of energy");
  // Across the motion the contact is what its curvatures there make it, not what those along it would.
  EXPECT_NE(run.plan.elastic_contact_radius, run.plan.elastic_contact_radius_y);
}

} // namespace
} // namespace brinell::verification::shaped_tugging_test
