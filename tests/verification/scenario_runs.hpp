// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/indentation.hpp"
#include "brinell/simulation/rolling.hpp"
#include "brinell/simulation/run.hpp"
#include "tugging_runs.hpp"

#include <limits>
#include <string>
#include <vector>

/// Runs of all scenarios with their history; cases of indentation and rolling.
namespace brinell::verification
{

/// A run with its history.
template <typename Case>
struct Computed
{
  std::vector<typename Case::Record> history;
  typename Case::Summary summary;
};
using IndentationRun = Computed<simulation::IndentationCase>;
using RollingRun = Computed<simulation::RollingCase>;

template <typename Case>
Computed<Case> computed(const Case& scenario)
{
  Computed<Case> run;
  simulation::Observer<typename Case::Record> observer;
  observer.on_step = [&](const typename Case::Record& r, int) { run.history.push_back(r); };
  run.summary = simulation::run(scenario, observer);
  return run;
}

inline contact::Drive load(double newton)
{
  return {contact::Drive::Kind::load, newton};
}

inline contact::Drive approach(double metre)
{
  return {contact::Drive::Kind::approach, metre};
}

/// Two spheres of 1 m of one material, pressed by the sequence.
inline simulation::IndentationCase pressed_spheres(const constitutive::Material& material,
                                                   std::vector<contact::Drive> sequence)
{
  simulation::IndentationCase c;
  c.lower = {ball(1.0), material};
  c.upper = {ball(1.0), material};
  c.sequence = std::move(sequence);
  return c;
}

/// A steel that hardens linearly, S_y / k = sqrt(3) with k = 1 GPa.
inline constitutive::Material track_steel(double hardening = 0.0)
{
  constitutive::Material m{{200e9, 0.3}, {}};
  const double yield = 1e9 * std::sqrt(3.0);
  if (hardening > 0.0)
    m.hardening = constitutive::LinearHardening{yield, hardening};
  else
    m.hardening = constitutive::PerfectPlasticity{yield};
  return m;
}

/// An elastic ball of 10 mm on a flat of `material`, rolling under the load whose Hertz pressure that is [Pa].
inline simulation::RollingCase ball_on_flat(const constitutive::Material& material, double hertz_pressure,
                                            double distance)
{
  simulation::RollingCase c;
  c.lower = {simulation::Plane{}, material};
  c.upper = {ball(10e-3), {material.elastic, {}}};
  const double modulus = contact_modulus(material.elastic, material.elastic);
  const double radius = 10e-3;
  const double pi = 3.14159265358979323846;
  c.drive = load(std::pow(pi * hertz_pressure, 3) * radius * radius / (6.0 * modulus * modulus)); // Johnson, Eq. 4.24
  c.distance = distance;
  c.resolution = slow_build ? 3.0 : 6.0;
  return c;
}

/// Heat of a carbon steel.
inline constexpr Thermal steel{50.0, 7800.0, 470.0, 1.2e-5};

/// The paper's spheres, but of 10 mm, with friction 0.1.
inline simulation::TuggingCase warm_spheres(const constitutive::Material& material, double interference_ratio,
                                            double speed, double cells)
{
  simulation::TuggingCase t = equal_spheres(interference_ratio, material);
  for (simulation::ShapedBody* body : {&t.lower, &t.upper})
  {
    body->shape = ball(10e-3);
    body->material.thermal = steel;
  }
  t.interference *= 1e-2;
  t.friction.coefficient = 0.1;
  t.speed = speed;
  t.resolution = cells;
  return t;
}

/// Two equal spheres that rub on each other as they pass.
inline simulation::TuggingCase rubbing(double interference_ratio, double friction, double cells)
{
  simulation::TuggingCase t = equal_spheres(interference_ratio, perfect_material());
  t.resolution = cells;
  t.friction.coefficient = friction;
  return t;
}

/// An elastic ball that slides without turning over a flat, on which it keeps no heat: it does not conduct.
inline simulation::RollingCase sliding_ball(double peclet, double cells)
{
  simulation::RollingCase c = ball_on_flat(elastic_material(), 1e9, 1e-3);
  c.lower.material.thermal = steel;
  c.upper.material = {{std::numeric_limits<double>::infinity(), 0.0}, {}};
  c.slide_to_roll = 2.0;
  c.friction.coefficient = 0.1;
  c.heat.displacement = c.heat.stress = false;
  c.resolution = cells;
  c.speed = 1.0; // until the contact is known
  const double half_width = simulation::plan(c).half_width_x;
  c.speed = 2.0 * steel.diffusivity() * peclet / half_width; // Pe = V a/(2 kappa)
  c.distance = 8.0 * half_width;
  return c;
}

} // namespace brinell::verification
