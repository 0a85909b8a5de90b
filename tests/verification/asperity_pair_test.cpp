// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"
#include "scenario_runs.hpp"

#include "brinell/simulation/sliding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

/// One pair of asperities on otherwise smooth surfaces, as a sliding of rough surfaces and as a tugging.
namespace brinell::verification::asperity_pair_test
{
namespace
{

using simulation::SlidingCase;
using simulation::SlidingRecord;
using simulation::TuggingCase;

/// Both bodies yield.
TuggingCase pair_as_tugging()
{
  const constitutive::Material material{elastic, constitutive::LinearHardening{yield_stress, 4e9}};
  TuggingCase t = equal_spheres(4.0, material);
  const double a = simulation::plan(t).elastic_contact_radius;
  const double cells = slow_build ? 3.0 : 6.0;
  t.spacing = {{a / cells, a / cells, 0.5 * a / cells}};
  return t;
}

/// A cap of a sphere on a flat, with its foot well below all that is touched.
simulation::HeightMap cap(double radius, double height, double spacing)
{
  const int half = static_cast<int>(std::ceil(std::sqrt(2.0 * radius * height) / spacing));
  return simulation::sampled([&](double x, double y)
                             { return std::max(0.0, height - (x * x + y * y) / (2.0 * radius)); },
                             2 * half + 1, 2 * half + 1, spacing, spacing);
}

/// The same two asperities: the upper one a ball, the lower one a cap on a flat. The step of a tugging moves the contact by a cell on
/// each body, and so the one body by two over the other one.
SlidingCase pair_as_sliding(const TuggingCase& t)
{
  SlidingCase c;
  static_cast<simulation::Numerics&>(c) = t;
  const double dx = (*t.spacing)[0], height = 3.0 * t.interference;
  c.lower = {simulation::Plane{}, t.lower.material, cap(1.0, height, dx)};
  c.upper = t.upper;
  c.press = {contact::Drive::Kind::approach, t.interference - height}; // the ball stays above the flat
  c.press_steps = 1;
  c.shift = 2.0 * dx;
  const double first_touch = std::sqrt(2.0 * 2.0 * t.interference);        // of two paraboloids
  c.distance = *c.shift * 2.0 * (std::ceil(first_touch / *c.shift) + 4.0); // and until residual shapes part
  return c;
}

using SlidingRun = Computed<SlidingCase>;

double largest(const std::vector<SlidingRecord>& history, double SlidingRecord::*column)
{
  double value = 0.0;
  for (const SlidingRecord& r : history)
    value = std::max(value, r.*column);
  return value;
}

// Tugging turns the plane of contact as the asperities pass, and takes the arc of their spheres; sliding keeps the plane, and has
// paraboloids. They differ by the square of the angle at first touch, (X/2R)^2 = 9e-4.
TEST(AsperityPair, OnFlatsIsATugging)
{
  const TuggingCase t = pair_as_tugging();
  const TuggingRun tugged = computed(t);
  const SlidingCase c = pair_as_sliding(t);
  ASSERT_LT(c.press.value, 0.0);
  const SlidingRun run = computed(c);
  EXPECT_EQ(run.history.front().F_n, 0.0) << "apart at first";
  EXPECT_EQ(run.history.back().F_n, 0.0) << "and at last";
  const auto& s = run.summary;
  const auto& u = tugged.summary;
  const char* const origin = "the scenario tugging, same cells and steps";
  constexpr double angle = 2e-3; // twice its square, and what the edge of the contact makes of unlike cells
  test::expect_close("largest F_X over that of tugging", largest(run.history, &SlidingRecord::F_X) / u.peak_F_X, 1.0,
                     angle, origin);
  test::expect_close("largest F_n over F_Z of tugging", largest(run.history, &SlidingRecord::F_n) / u.peak_F_Z, 1.0,
                     angle, origin);
  test::expect_close("net work over that of tugging", s.work / u.work, 1.0, angle, origin);
  test::expect_close("plastic work over that of tugging",
                     (s.dissipation_lower + s.dissipation_upper) / (u.dissipation_lower + u.dissipation_upper), 1.0,
                     angle, origin);
  test::expect_close("dent of the lower body over that of tugging", s.max_residual_lower / u.max_residual_lower, 1.0,
                     angle, origin);
}

// In a period the other pairs lift the surface less than their mean does, which is what displacements count from: by c P/(pi E' L) with
// c = 3.900265, the constant of a square lattice of 1/r (Borwein, Borwein, Shail 1989). The pair then has the load of one that overlaps by as
// much more. What the pressure of the others bends is of the order (a/L)^3.
TEST(AsperityPair, InAPeriodHasItsImages)
{
  TuggingCase t = pair_as_tugging();
  const double a = simulation::plan(t).elastic_contact_radius, dx = (*t.spacing)[0];
  const int cells = 16 * static_cast<int>(std::lround(a / dx));
  const double period = cells * dx;
  SlidingCase c = pair_as_sliding(t);
  const double height = 3.0 * t.interference;
  const int columns = static_cast<int>(std::ceil(std::sqrt(4.0 * t.interference) / *c.shift)) + 1;
  simulation::HeightMap lower = cap(1.0, height, dx);
  lower.x = columns * *c.shift;
  c.lower = {simulation::Plane{}, elastic_material(), lower};
  c.upper = {simulation::Plane{}, elastic_material(), cap(1.0, height, dx)};
  c.domain.x = c.domain.y = {Boundary::periodic, period, cells};
  c.spacing.reset();
  c.press.value = t.interference - 2.0 * height;
  c.distance = 2.0 * lower.x;
  const SlidingRun run = computed(c);
  const double modulus = contact_modulus(elastic, elastic);
  const auto hertz = [&](double overlap) { return 4.0 / 3.0 * modulus * std::sqrt(0.5) * std::pow(overlap, 1.5); };
  double overlap = t.interference;
  for (int i = 0; i < 60; ++i)
    overlap = t.interference + 3.900265 * hertz(overlap) / (std::numbers::pi * modulus * period);
  const SlidingRecord& aligned = run.history.at(static_cast<std::size_t>(columns)); // after the one that presses
  EXPECT_NEAR(aligned.slid, lower.x, 1e-12);
  const double images = std::pow(a / period, 3) * 16.0; // and the cells: 0.25 (a/dx)^-1.5
  test::expect_close("load of the pair in a period over that of Hertz", aligned.F_n / hertz(t.interference),
                     hertz(overlap) / hertz(t.interference), images + 0.25 * std::pow(a / dx, -1.5),
                     "Hertz with the images' displacement");
  EXPECT_NEAR(aligned.F_X, 0.0, 1e-6 * aligned.F_n); // elastic: the same before and after
  EXPECT_NEAR(run.summary.work, 0.0, 1e-3 * modulus * std::pow(t.interference, 2.5));
}

} // namespace
} // namespace brinell::verification::asperity_pair_test
