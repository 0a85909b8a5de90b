// SPDX-License-Identifier: BSD-3-Clause
// Friction is raised before the surfaces move: a uniform layer follows the rate equations of plasticity, which are integrated here on
// their own, and its plastic work does not depend on the steps of the sliding that follows.
#include "brinell/simulation/sliding.hpp"

#include "order.hpp"
#include "scenario_checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace brinell::simulation::onset_of_sliding_test
{
namespace
{

constexpr double young = 210e9, poisson = 0.3, yield_stress = 0.5e9, thickness = 1e-6, period = 8e-6; // [Pa], [m]

/// Hardening moduli of the layer [Pa].
struct Moduli
{
  double isotropic, kinematic;
};

/// A layer whose strain along the surface is zero, under a pressure that rises and then stays, and a shear.
class Layer
{
public:
  explicit Layer(const Moduli& moduli) : moduli_(moduli) {}

  void press(double pressure) { go(pressure, 0.0); }
  void shear(double shear) { go(0.0, shear - shear_); }
  [[nodiscard]] double work() const { return work_; } ///< plastic, per volume [J/m^3]
  [[nodiscard]] double strain() const { return strain_; }

private:
  /// The difference a = sigma_xx - sigma_zz, of which xx and yy have the same share, and the shear define the stress: its size is
  /// sqrt(a^2 + 3 q^2). Flow along the normal leaves no strain along the surface, to which a yields by E / (2 (1 - nu)).
  void go(double pressure, double shear)
  {
    constexpr int steps = 40000; // an explicit rule of first order in them
    for (int i = 0; i < steps; ++i)
    {
      const double da = pressure / steps * (1.0 - 2.0 * poisson) / (1.0 - poisson), dq = shear / steps;
      const double a = difference_ + 0.5 * da - back_[0], q = shear_ + 0.5 * dq - back_[1];
      const double size = std::hypot(a, std::sqrt(3.0) * q);
      const double give = 0.5 * young / (1.0 - poisson) * a * a / (size * size);
      const bool is_at_yield = size >= yield_stress + moduli_.isotropic * strain_;
      const double loading = (a * da + 3.0 * q * dq) / size;
      const double flow = is_at_yield ? std::max(0.0, loading / (moduli_.isotropic + moduli_.kinematic + give)) : 0.0;
      difference_ += da - 0.5 * young / (1.0 - poisson) * a / size * flow;
      shear_ += dq;
      work_ += (difference_ * a + 3.0 * shear_ * q) / size * flow;
      back_[0] += moduli_.kinematic * a / size * flow;
      back_[1] += moduli_.kinematic * q / size * flow;
      strain_ += flow;
    }
  }

  Moduli moduli_;
  double difference_ = 0.0, shear_ = 0.0, strain_ = 0.0, work_ = 0.0;
  std::array<double, 2> back_{};
};

/// The layer on a body that does not yield, under a rigid flat. Waves that are nothing give the flats a first touch.
SlidingCase layer_case(const Moduli& moduli, double pressure, double friction)
{
  SlidingCase c;
  c.lower = {Plane{}, {{young, poisson}, constitutive::LinearHardening{yield_stress, moduli.isotropic}}};
  if (moduli.kinematic > 0.0)
    c.lower.material.kinematic = {{moduli.kinematic, 0.0}};
  c.lower.material.yield_factor = constitutive::DepthProfile({0.0, thickness, 1.001 * thickness}, {1.0, 1.0, 20.0});
  c.lower.texture = Sinusoid{1e-12, period, period};
  c.upper = {Plane{}, {Elastic{std::numeric_limits<double>::infinity(), 0.0}, {}}};
  c.domain.x = {Boundary::periodic, period, 8};
  c.domain.y = {Boundary::periodic, period, 8};
  c.domain.layer = 0.5 * thickness;
  c.friction.coefficient = friction;
  c.press = {contact::Drive::Kind::load, pressure * period * period};
  c.press_steps = 16;
  c.distance = period;
  return c;
}

/// Plastic work per volume of the layer in a step [J/m^3].
double work_in(const std::vector<SlidingRecord>& rows, std::size_t step)
{
  return (rows.at(step).dissipation_lower - rows.at(step - 1).dissipation_lower) / (thickness * period * period);
}

constexpr std::size_t first = 16; ///< step that slides

TEST(OnsetOfSliding, OfALayerFollowsTheRateEquations)
{
  for (const auto& [pressure, friction] : {std::pair{0.8e9, 0.25}, {0.9e9, 0.3}, {1.0e9, 0.28}})
  {
    const Moduli moduli{10e9, 0.0};
    Layer layer(moduli);
    layer.press(pressure);
    const double pressed = layer.work();
    layer.shear(friction * pressure);
    // Sixteen increments for the strength of the surface, of second order: the next test measures 0.3 % and less.
    const std::vector<SlidingRecord> rows = history(layer_case(moduli, pressure, friction));
    EXPECT_NEAR(work_in(rows, first) / (layer.work() - pressed), 1.0, 0.005) << pressure;
    EXPECT_NEAR(rows.at(first).max_equivalent_plastic_strain / layer.strain(), 1.0, 0.001) << pressure;
  }
}

TEST(OnsetOfSliding, ConvergesAtSecondOrder)
{
  constexpr double pressure = 0.9e9, friction = 0.3;
  const Moduli moduli{10e9, 0.0};
  Layer layer(moduli);
  layer.press(pressure);
  const double pressed = layer.work();
  layer.shear(friction * pressure);
  std::vector<double> errors;
  for (const int increments : {4, 8, 16})
  {
    SlidingCase c = layer_case(moduli, pressure, friction);
    c.solver.onset_increments = increments;
    errors.push_back(work_in(history(c), first) / (layer.work() - pressed) - 1.0);
  }
  const test::Orders orders("plastic work of the onset", errors);
  EXPECT_GT(orders.last, 1.7);
  EXPECT_LT(std::abs(errors.back()), 0.004);
}

TEST(OnsetOfSliding, DoesNotDependOnTheShift)
{
  const auto work_of = [](double shift)
  {
    SlidingCase c = layer_case({10e9, 0.0}, 0.9e9, 0.3);
    c.shift = shift;
    return work_in(history(c), first);
  };
  const double of_cells = work_of(0.125 * period);
  // The tolerances of the solver, and the waves that are nothing.
  for (const double shift : {0.03125 * period, 0.5 * period})
    EXPECT_NEAR(work_of(shift) / of_cells, 1.0, 1e-5) << shift;
}

TEST(OnsetOfSliding, ReversesAtRest)
{
  // Kinematic hardening, so that the layer yields again when the shear turns.
  constexpr double pressure = 0.9e9, friction = 0.3;
  const Moduli moduli{5e9, 30e9};
  Layer layer(moduli);
  layer.press(pressure);
  layer.shear(friction * pressure);
  const double there = layer.work();
  layer.shear(-friction * pressure);
  SlidingCase c = layer_case(moduli, pressure, friction);
  c.strokes = 2;
  c.to_and_fro = true;
  const std::vector<SlidingRecord> rows = history(c);
  EXPECT_NEAR(work_in(rows, first + 8) / (layer.work() - there), 1.0, 0.01);
}

TEST(OnsetOfSliding, KeepsTheBooksOfEnergyAndHeat)
{
  // The energy of the shear at rest comes from the work of the way after it, and is missing in the heat of this way: all of it
  // enters the lower body, as the upper one conducts nothing.
  SlidingCase c = layer_case({10e9, 0.0}, 0.9e9, 0.3);
  c.lower.material.thermal = Thermal{50.0, 7800.0, 470.0, 0.0};
  c.heat.of_plastic_work = 0.0;
  c.speed = 1e-3;
  simulation::Run run(c);
  while (!run.is_done())
  {
    const SlidingRecord r = run.step();
    if (r.way > 0.0) // otherwise both are nothing
    {
      EXPECT_NEAR(r.heat_lower / r.dissipation_friction, 1.0, 1e-9) << r.step;
    }
  }
  EXPECT_NEAR(run.summary().energy_balance_error, 0.0, 1e-5); // the tolerances of the solver
}

TEST(OnsetOfSliding, OfElasticBodiesNeedsNoIncrements)
{
  SlidingCase c = layer_case({10e9, 0.0}, 0.9e9, 0.3);
  c.lower.material.hardening.reset();
  c.lower.material.yield_factor = {};
  const std::vector<SlidingRecord> with = history(c);
  c.solver.onset_increments = 0;
  const std::vector<SlidingRecord> without = history(c);
  EXPECT_EQ(with.at(first).evaluations, without.at(first).evaluations);
}

} // namespace
} // namespace brinell::simulation::onset_of_sliding_test
