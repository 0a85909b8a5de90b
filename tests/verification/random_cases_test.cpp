// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "random_field.hpp"
#include "record.hpp"
#include "tugging_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

/// Convergence must not depend on luck: random but possible pairs of asperities. Each run ends with a converged result or with
/// a clear refusal, none with a value that is not finite, an endless loop or a silent failure.
namespace brinell::verification
{
namespace
{

using namespace constitutive;
using simulation::Asperity;
using simulation::TuggingCase;

class Draw
{
public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double between(double a, double b) { return test::uniform(engine_, a, b); }
  double power_of_ten(double a, double b) { return std::pow(10.0, between(a, b)); }
  bool chance(double p) { return between(0.0, 1.0) < p; }
  /// 0 ... n - 1
  int below(int n) { return std::min(n - 1, static_cast<int>(between(0.0, n))); }

private:
  std::mt19937_64 engine_;
};

HardeningLaw random_law(Draw& draw, double E, double S)
{
  switch (draw.below(7))
  {
  case 0:
    return PerfectPlasticity{S};
  case 1:
    return LinearHardening{S, E * draw.between(0.0, 0.1)};
  case 2:
    return SwiftHardening{S * draw.between(1.2, 3.0), draw.power_of_ten(-4.0, -2.0), draw.between(0.03, 0.4)};
  case 3:
    return hollomon(S, S * draw.between(1.2, 3.0), draw.between(0.05, 0.5));
  case 4:
    return LudwikHardening{S, S * draw.between(0.2, 3.0), draw.between(0.2, 1.0)};
  case 5:
    return VoceHardening{S, S * draw.between(0.0, 1.0), draw.between(5.0, 300.0)};
  default:
    return TabulatedHardening({0.0, 0.002, 0.02, 0.1},
                              {S, S * draw.between(1.0, 1.2), S * draw.between(1.2, 1.5), S * draw.between(1.5, 1.8)});
  }
}

/// From a gel to a ceramic; yield stress of 0.06 to 2 % of Young's modulus.
Material random_material(Draw& draw)
{
  const double E = draw.power_of_ten(5.0, 11.6);
  Material m{{E, draw.between(0.0, 0.49)}, {}};
  m.hardening = random_law(draw, E, E * draw.power_of_ten(-3.2, -1.7));
  for (int terms = std::max(0, draw.below(4) - 1); terms > 0; --terms)
    m.kinematic.push_back({E * draw.power_of_ten(-3.0, -0.5), draw.chance(0.3) ? 0.0 : draw.power_of_ten(0.5, 3.0)});
  return m;
}

/// Interferences of 0.5 to 20 times first yield, as long as the contact is small beside the bodies.
TuggingCase random_case(unsigned seed)
{
  Draw draw(seed);
  TuggingCase t;
  const double R = draw.power_of_ten(-6.0, 0.0);
  for (Asperity* body : {&t.lower, &t.upper})
    *body = {R * draw.between(0.5, 2.0), random_material(draw)};
  if (draw.chance(0.3))
    t.upper = t.lower;
  else if (draw.chance(0.2))
    t.upper.material = {t.upper.material.elastic, {}};
  const double modulus = contact_modulus(t.lower.material.elastic, t.upper.material.elastic);
  const double radius = 1.0 / (1.0 / t.lower.radius + 1.0 / t.upper.radius);
  double yields = 1.0;
  for (const Asperity* body : {&t.lower, &t.upper})
    if (body->material.is_plastic())
      yields = std::min(
          yields, reference::critical_values(radius, modulus,
                                             reference::critical_pressure_ratio(body->material.elastic.poisson_ratio),
                                             initial_yield_stress(*body->material.hardening))
                      .interference);
  t.interference = std::min(draw.power_of_ten(-0.3, 1.3) * yields, 0.02 * R);
  t.resolution = draw.between(2.5, 4.0);
  t.passes = 1 + draw.below(2);
  t.kinematics = draw.chance(0.5) ? simulation::Kinematics::exact : simulation::Kinematics::paper;
  t.solver.integration =
      draw.chance(0.3) ? elastoplastic::Integration::backward_euler : elastoplastic::Integration::path;
  t.shift = 0.5 * (1 + draw.below(4)) * simulation::plan(t).contact.dx;
  return t;
}

TEST(RandomCases, ConvergeOrAreRefused)
{
  const unsigned count = slow_build ? 10 : 200;
  int converged = 0, refused = 0, split = 0;
  double iterations = 0.0, steps = 0.0, most = 0.0;
  for (unsigned seed = 0; seed < count; ++seed)
  {
    SCOPED_TRACE(seed);
    try
    {
      const TuggingRun run = computed(random_case(seed));
      const simulation::TuggingSummary& s = run.summary;
      for (const double x : {s.work, s.peak_F_X, s.peak_F_Z, s.dissipation_lower, s.dissipation_upper,
                             s.energy_residual, s.max_residual_lower, s.max_equivalent_plastic_strain})
        EXPECT_TRUE(std::isfinite(x));
      EXPECT_GE(s.dissipation_lower, 0.0);
      EXPECT_GE(s.dissipation_upper, 0.0);
      EXPECT_GE(s.peak_F_Z, 0.0);
      ++converged;
      split += s.split_increments;
      iterations += static_cast<double>(s.iterations);
      steps += s.steps;
      for (const simulation::TuggingRecord& r : run.history)
        most = std::max(most, static_cast<double>(r.iterations));
    }
    catch (const InputError& error) // the plastic zone has outgrown the grid: it says so
    {
      EXPECT_NE(std::string(error.what()).find("grid.extent"), std::string::npos) << error.what();
      ++refused;
    }
  }
  test::expect_within("share of cases that converge", converged / static_cast<double>(count), 0.9, 1.0,
                      "bound: the rest is refused with a reason");
  test::expect_within("evaluations per step, mean", iterations / steps, 1.0, 20.0, "bound: a third of those allowed");
  test::expect_within("evaluations in a step, largest", most, 1.0, 120.0, "bound: those allowed, twice");
  test::expect_within("increments that had to be split", split, 0.0, 0.01 * steps, "bound: one in a hundred");
}

} // namespace
} // namespace brinell::verification
