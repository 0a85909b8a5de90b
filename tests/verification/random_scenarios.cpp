// SPDX-License-Identifier: BSD-3-Clause
#include "random_scenarios.hpp"

#include "brinell/reference/hertz.hpp"
#include "scenario_runs.hpp"
#include "simulation/plan/footprint.hpp"

#include <limits>
#include <numbers>
#include <vector>

namespace brinell::verification
{

using namespace constitutive;
using simulation::TuggingCase;

namespace
{

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

reference::CriticalValues first_yield(const Material& lower, const Material& upper, double radius)
{
  const double modulus = contact_modulus(lower.elastic, upper.elastic);
  reference::CriticalValues least;
  for (const Material* m : {&lower, &upper})
    if (m->is_plastic())
    {
      const auto values =
          reference::critical_values(radius, modulus, reference::critical_pressure_ratio(m->elastic.poisson_ratio),
                                     initial_yield_stress(*m->hardening));
      if (least.load == 0.0 || values.load < least.load)
        least = values;
    }
  return least;
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

template <typename Scenario>
void randomise_solver(Draw& draw, Scenario& c)
{
  c.resolution = draw.between(2.5, 4.0);
  c.solver.integration =
      draw.chance(0.3) ? elastoplastic::Integration::backward_euler : elastoplastic::Integration::path;
}

} // namespace

TuggingCase random_tugging(Draw& draw)
{
  TuggingCase t;
  const double R = draw.power_of_ten(-6.0, 0.0);
  for (simulation::ShapedBody* body : {&t.lower, &t.upper})
    *body = {ball(R * draw.between(0.5, 2.0)), random_material(draw)};
  if (draw.chance(0.3))
    t.upper = t.lower;
  else if (draw.chance(0.2))
    t.upper.material = {t.upper.material.elastic, {}};
  const double radius = simulation::equivalent_radius(t.lower.shape, t.upper.shape).value();
  t.interference = std::min(
      draw.power_of_ten(-0.3, 1.3) * first_yield(t.lower.material, t.upper.material, radius).interference, 0.02 * R);
  randomise_solver(draw, t);
  if (draw.chance(0.25)) // about as far, by load
    t.load = reference::point_contact_at_approach(
                 radius, contact_modulus(t.lower.material.elastic, t.upper.material.elastic), t.interference)
                 .load;
  t.passes = 1 + draw.below(2);
  t.kinematics = draw.chance(0.5) || t.load ? simulation::Kinematics::exact : simulation::Kinematics::paper;
  // Whole and half cells, and what lies between them.
  const double cells = draw.chance(0.7) ? 0.5 * (1 + draw.below(4)) : draw.between(0.4, 2.0);
  t.shift = cells * simulation::plan(t).contact.dx;
  return t;
}

namespace
{

simulation::Shape random_tip(Draw& draw, double R)
{
  const double slope = draw.between(0.1, 0.4);
  if (draw.chance(0.5))
    return simulation::Cone{std::atan(1.0 / slope), R * draw.between(0.01, 0.1)};
  return simulation::Pyramid{3 + draw.below(2), std::atan(1.0 / slope), R * draw.between(0.01, 0.1)};
}

/// A convex pair: ball, ellipsoid, roller or tip on a plane or on another convex body.
template <typename Scenario>
void random_bodies(Draw& draw, Scenario& c, bool tips)
{
  const double R = draw.power_of_ten(-6.0, -1.0);
  c.lower.material = random_material(draw);
  c.upper.material = draw.chance(0.3) ? c.lower.material : random_material(draw);
  if (draw.chance(0.3))
    c.upper.material.hardening.reset(), c.upper.material.kinematic.clear();
  else if (draw.chance(0.2))
    c.upper.material = {{std::numeric_limits<double>::infinity(), 0.0}, {}};
  c.lower.shape = simulation::Plane{};
  if (draw.chance(0.3))
    c.lower.shape = simulation::Paraboloid{R * draw.between(2.0, 9.0), R * draw.between(2.0, 9.0)};
  c.upper.shape = simulation::Paraboloid{R, R * draw.power_of_ten(-0.5, 0.5)};
  if (tips && draw.chance(0.3))
  {
    c.lower.shape = simulation::Plane{};
    c.upper.shape = random_tip(draw, R);
  }
  else if (draw.chance(0.15))
  {
    c.lower.shape = simulation::Plane{};
    c.upper.shape = simulation::Roller{R, R * draw.between(0.1, 0.5)};
  }
}

/// Load at which the peak pressure of a ball of that size would be 0.5 to 3 times that of first yield, 0.7 to 15 times its
/// approach; small beside the bodies.
template <typename Scenario>
double random_load(Draw& draw, const Scenario& c, double R)
{
  const auto critical = first_yield(c.lower.material, c.upper.material, R);
  const double modulus = contact_modulus(c.lower.material.elastic, c.upper.material.elastic);
  const double largest = 4.0 / 3.0 * modulus * R * R * std::pow(0.2, 3); // contact radius of 0.2 R, if it stays elastic
  return std::min(largest, critical.load * std::pow(draw.power_of_ten(-0.3, 0.5), 3));
}

double size_of(const simulation::Shape& shape)
{
  if (const auto* p = std::get_if<simulation::Paraboloid>(&shape))
    return std::sqrt(p->radius_x * p->radius_y);
  if (const auto* r = std::get_if<simulation::Roller>(&shape))
    return r->radius;
  if (const auto* cone = std::get_if<simulation::Cone>(&shape))
    return cone->tip_radius;
  return std::get<simulation::Pyramid>(shape).tip_radius;
}

} // namespace

simulation::IndentationCase random_indentation(Draw& draw)
{
  simulation::IndentationCase c;
  random_bodies(draw, c, true);
  randomise_solver(draw, c);
  const double load = random_load(draw, c, size_of(c.upper.shape));
  c.sequence = {{contact::Drive::Kind::load, load}, {contact::Drive::Kind::load, 0.0}};
  if (draw.chance(0.3)) // about as deep
    for (contact::Drive& drive : c.sequence)
      drive = {contact::Drive::Kind::approach, drive.value > 0.0 ? simulation::plan(c).scales.gap : 0.0};
  c.steps = 2 + draw.below(6);
  c.cycles = 1 + draw.below(2);
  if (draw.chance(0.3))
    c.places = {0.0, simulation::plan(c).contact_radius * draw.between(0.0, 6.0)};
  return c;
}

simulation::RollingCase random_rolling(Draw& draw)
{
  simulation::RollingCase c;
  random_bodies(draw, c, false);
  randomise_solver(draw, c);
  c.drive = {contact::Drive::Kind::load, random_load(draw, c, size_of(c.upper.shape))};
  c.distance = 1.0; // to be set when the contact's size is known
  const double a = simulation::footprint(c.lower, c.upper, c.drive, c.domain).half_x;
  c.distance = a * draw.between(2.0, 6.0); // two shifts at least
  c.shift = a / c.resolution * (draw.chance(0.5) ? 1 + draw.below(2) : draw.between(0.3, 1.5));
  if (draw.chance(0.3))
    c.drive = {contact::Drive::Kind::approach, simulation::plan(c).scales.gap};
  if (draw.chance(0.4))
    c.slide_to_roll = draw.between(-1.0, 2.0); // the upper surface moves up to three times as far in a step
  c.passes = 1 + draw.below(2);
  c.load_steps = 2 + draw.below(5);
  if (draw.chance(0.3))
    c.lower.texture =
        simulation::Dent{a * draw.between(-1.0, 1.0), a * draw.between(-1.0, 1.0),
                         draw.between(-0.3, 0.6) * a * a / size_of(c.upper.shape), 0.25 * a * draw.between(0.7, 3.0)};
  return c;
}

namespace
{

/// Friction up to 0.5, mostly up to what the surfaces can carry.
template <typename Scenario>
void add_friction(Draw& draw, Scenario& c)
{
  c.friction.coefficient = draw.between(0.02, 0.5);
  c.friction.coupling = draw.chance(0.8);
}

} // namespace

TuggingCase random_rubbing(Draw& draw)
{
  TuggingCase t = random_tugging(draw);
  add_friction(draw, t);
  return t;
}

simulation::RollingCase random_skidding(Draw& draw)
{
  simulation::RollingCase c = random_rolling(draw);
  if (c.slide_to_roll == 0.0)
    c.slide_to_roll = draw.between(0.2, 2.0);
  add_friction(draw, c);
  return c;
}

simulation::RollingCase random_creeping(Draw& draw)
{
  simulation::RollingCase c = random_rolling(draw);
  c.slide_to_roll = 0.0;
  c.shift.reset();
  add_friction(draw, c);
  c.creepage.emplace();
  const simulation::RollingPlan plan = simulation::plan(c);
  // All slips from some times the friction times the approach over the radius on.
  const double size =
      std::min(0.1, draw.between(0.02, 6.0) * c.friction.coefficient * plan.scales.gap / plan.half_width_x);
  const double angle = draw.between(0.0, 2.0 * std::numbers::pi);
  c.creepage = simulation::Creepage{size * std::cos(angle), size * std::sin(angle), 0.0};
  if (draw.chance(0.5))
    c.creepage->spin = draw.between(-1.0, 1.0) * size / std::max(plan.half_width_x, plan.half_width_y);
  c.shift = (1 + draw.below(2)) * plan.shift;
  return c;
}

namespace
{

/// Adds constants, and returns a speed with Peclet numbers of 0.05 to 30 [m/s]. Each surface expands by up to a third of the
/// approach, and the heat stresses it by up to twice its yield stress.
/// @param radius, approach  of the contact [m]
/// @param sliding           sliding speed over the speed
/// @param sticks            the heat of slip then expands the surfaces by less than the slip, as that of all solids does: otherwise
///                          slip grows without limit by its own heat
template <typename Scenario>
double add_heat(Draw& draw, Scenario& c, double radius, double approach, double sliding, bool sticks)
{
  std::optional<double> speed;
  const double pressure = 0.5 * contact_modulus(c.lower.material.elastic, c.upper.material.elastic) * approach / radius;
  for (simulation::ShapedBody* body : {&c.lower, &c.upper})
  {
    const Material& m = body->material;
    Thermal thermal{draw.power_of_ten(-1.0, 2.0), draw.power_of_ten(3.0, 4.0), draw.power_of_ten(2.0, 3.3), 0.0};
    if (!speed)
      speed = 2.0 * thermal.diffusivity() * draw.power_of_ten(-1.3, 1.5) / radius;
    const double peclet = 0.5 * *speed * radius / thermal.diffusivity();
    const double rise = c.friction.coefficient * pressure * sliding * *speed * radius /
                        (thermal.conductivity * (1.0 + std::sqrt(peclet)));
    double strain = draw.between(0.0, 0.3) * approach / radius;
    const double stress = draw.between(0.0, 2.0); // over the yield stress
    if (m.is_plastic())
      strain = std::min(strain, stress * initial_yield_stress(*m.hardening) * (1.0 - m.elastic.poisson_ratio) /
                                    m.elastic.young_modulus);
    thermal.expansion = strain / rise;
    if (sticks)
      thermal.expansion =
          std::min(thermal.expansion, 0.1 * thermal.density * thermal.specific_heat /
                                          (c.friction.coefficient * pressure * (1.0 + std::sqrt(peclet))));
    if (!m.elastic.is_rigid())
      body->material.thermal = thermal;
  }
  c.heat.of_plastic_work = draw.between(0.0, 1.0);
  if (draw.chance(0.3))
    c.heat.partition = draw.between(0.0, 1.0);
  if (!c.lower.material.thermal || !c.upper.material.thermal)
    c.heat.partition.reset();
  return *speed;
}

} // namespace

TuggingCase random_hot_rubbing(Draw& draw)
{
  TuggingCase t = random_rubbing(draw);
  const simulation::TuggingPlan plan = simulation::plan(t);
  t.speed = add_heat(draw, t, plan.elastic_contact_radius, plan.scales.gap, 1.0, false);
  return t;
}

simulation::RollingCase random_hot_skidding(Draw& draw)
{
  simulation::RollingCase c = random_skidding(draw);
  const simulation::RollingPlan plan = simulation::plan(c);
  c.speed = add_heat(draw, c, plan.half_width_x, plan.scales.gap, 1.0, false);
  return c;
}

simulation::RollingCase random_hot_creeping(Draw& draw)
{
  simulation::RollingCase c = random_creeping(draw);
  const simulation::RollingPlan plan = simulation::plan(c);
  const double creepage = std::hypot(c.creepage->longitudinal, c.creepage->lateral);
  c.speed = add_heat(draw, c, plan.half_width_x, plan.scales.gap, creepage, true);
  return c;
}

namespace
{

/// A cylinder on a flat in plane strain, in place of a point contact; pressed as hard.
void make_plane(Draw& draw, simulation::FrettingCase& c)
{
  const double R = size_of(c.upper.shape);
  c.lower.shape = simulation::Plane{};
  c.upper.shape = simulation::Roller{R, std::numeric_limits<double>::infinity()};
  c.domain.y = {Boundary::periodic, R, 1};
  const double modulus = contact_modulus(c.lower.material.elastic, c.upper.material.elastic);
  const double critical =
      1.7 * modulus * std::sqrt(first_yield(c.lower.material, c.upper.material, R).interference / R);
  const double p0 = std::min(critical * draw.power_of_ten(-0.5, 0.3), 0.1 * modulus);
  c.press.value = std::numbers::pi * R * R * p0 * p0 / modulus; // Johnson (1985), Eq. 4.45, over the period
}

} // namespace

simulation::FrettingCase random_fretting(Draw& draw)
{
  simulation::FrettingCase c;
  random_bodies(draw, c, false);
  randomise_solver(draw, c);
  c.press = {contact::Drive::Kind::load, random_load(draw, c, size_of(c.upper.shape))};
  if (draw.chance(0.2))
    make_plane(draw, c);
  add_friction(draw, c);
  c.press_steps = 2 + draw.below(5);
  c.cycles = 1 + draw.below(2);
  c.steps_per_cycle = 4 * (2 + draw.below(3));
  c.direction = draw.chance(0.5) ? 0.0 : draw.between(0.0, 2.0 * std::numbers::pi);
  const simulation::FrettingPlan plan = simulation::plan(c); // that is not moved yet
  const double most = c.friction.coefficient * c.press.value;
  if (draw.chance(0.35))
  {
    c.kind = simulation::FrettingCase::Kind::force;
    c.amplitude = most * draw.between(0.1, 0.9);
  }
  else
    c.amplitude = std::min(plan.sliding_displacement * draw.power_of_ten(-1.0, 0.7), 0.3 * plan.contact_radius);
  if (draw.chance(0.2))
    c.friction.shear_limit =
        most / (std::numbers::pi * plan.contact_radius * plan.contact_radius_y) * draw.between(0.8, 1.6);
  if (draw.chance(0.3) && c.kind == simulation::FrettingCase::Kind::shift)
    c.press = {contact::Drive::Kind::approach, plan.scales.gap};
  return c;
}

simulation::FrettingCase random_hot_fretting(Draw& draw)
{
  simulation::FrettingCase c = random_fretting(draw);
  const simulation::FrettingPlan plan = simulation::plan(c);
  const double speed = add_heat(draw, c, plan.contact_radius, plan.scales.gap, 1.0, true);
  const bool by_force = c.kind == simulation::FrettingCase::Kind::force;
  c.frequency = 0.25 * speed / (by_force ? 0.3 * plan.sliding_displacement : c.amplitude);
  return c;
}

namespace
{

/// @param radius, approach  of the contact [m]
/// @param slip              of a point of the surface in a pass or a cycle [m]
template <typename Scenario>
void add_wear(Draw& draw, Scenario& c, double radius, double approach, double slip)
{
  const double pressure = 0.5 * contact_modulus(c.lower.material.elastic, c.upper.material.elastic) * approach / radius;
  double coefficient = approach * draw.power_of_ten(-3.0, 0.5) / (pressure * slip);
  if (draw.chance(0.5))
  {
    c.wear.kind = elastoplastic::WearLaw::Kind::energy;
    coefficient /= c.friction.coefficient;
  }
  const double lower = draw.chance(0.3) ? std::round(draw.between(0.0, 1.0)) : draw.between(0.0, 1.0);
  c.wear.lower = lower * coefficient;
  c.wear.upper = (1.0 - lower) * coefficient;
}

} // namespace

TuggingCase random_worn_rubbing(Draw& draw)
{
  TuggingCase t = draw.chance(0.5) ? random_rubbing(draw) : random_hot_rubbing(draw);
  const simulation::TuggingPlan plan = simulation::plan(t);
  add_wear(draw, t, plan.elastic_contact_radius, plan.scales.gap, 2.0 * plan.elastic_contact_radius);
  return t;
}

simulation::RollingCase random_worn_skidding(Draw& draw)
{
  simulation::RollingCase c = draw.chance(0.5) ? random_skidding(draw) : random_hot_skidding(draw);
  const simulation::RollingPlan plan = simulation::plan(c);
  add_wear(draw, c, plan.half_width_x, plan.scales.gap, 2.0 * std::abs(c.slide_to_roll) * plan.half_width_x);
  return c;
}

simulation::RollingCase random_worn_creeping(Draw& draw)
{
  simulation::RollingCase c = draw.chance(0.5) ? random_creeping(draw) : random_hot_creeping(draw);
  const simulation::RollingPlan plan = simulation::plan(c);
  const double creepage = std::hypot(c.creepage->longitudinal, c.creepage->lateral);
  add_wear(draw, c, plan.half_width_x, plan.scales.gap, 2.0 * creepage * plan.half_width_x);
  return c;
}

simulation::FrettingCase random_worn_fretting(Draw& draw)
{
  simulation::FrettingCase c = draw.chance(0.5) ? random_fretting(draw) : random_hot_fretting(draw);
  const simulation::FrettingPlan plan = simulation::plan(c);
  const bool by_force = c.kind == simulation::FrettingCase::Kind::force;
  add_wear(draw, c, plan.contact_radius, plan.scales.gap, by_force ? plan.sliding_displacement : 4.0 * c.amplitude);
  return c;
}

void add_current(Draw& draw, simulation::Numerics& numerics, constitutive::Material& lower,
                 constitutive::Material& upper)
{
  const bool has_film = draw.chance(0.5);
  for (constitutive::Material* material : {&lower, &upper})
    material->electrical = {draw.power_of_ten(-8.0, -5.0), has_film ? 0.0 : draw.between(0.0, 5e-3)};
  if (has_film)
  {
    numerics.current.film.resistance = draw.power_of_ten(-15.0, -7.0);
    if (numerics.friction.coefficient > 0.0 && draw.chance(0.5))
      numerics.current.film.growth = draw.power_of_ten(-12.0, -3.0);
  }
  // Where heat is computed the bodies feel that of the current, V^2/(8 rho k). It stays below 100 K and a thermal strain of 1e-4:
  // expansion and conductivity are made for the heat of friction and may be those of no metal.
  const bool is_heated = lower.thermal || upper.thermal;
  double hot_voltage = std::numeric_limits<double>::infinity();
  for (const constitutive::Material* material : {&lower, &upper})
    if (material->thermal)
    {
      const double rise = std::min(100.0, 1e-4 / material->thermal->expansion);
      hot_voltage = std::min(
          hot_voltage, std::sqrt(8.0 * rise * material->electrical->resistivity * material->thermal->conductivity));
    }
  const int drive = is_heated ? 0 : draw.below(3);
  if (!is_heated && draw.chance(0.3)) // around the spots
    for (constitutive::Material* material : {&lower, &upper})
      material->softening = constitutive::LinearSoftening{.reference = 20.0, .melting_point = 1200.0};
  std::vector<double>& values = drive == 0 ? numerics.current.voltage : numerics.current.current;
  const int count = drive == 2 ? 0 : 1 + draw.below(3);
  for (int n = 0; n < count; ++n)
  {
    values.push_back(is_heated    ? hot_voltage * draw.power_of_ten(-2.0, 0.0)
                     : drive == 0 ? draw.power_of_ten(-4.0, 0.0)
                                  : draw.power_of_ten(-4.0, 2.0));
    if (count > 1)
      numerics.current.steps.push_back(3.0 * n + draw.between(0.0, 2.0));
  }
}

} // namespace brinell::verification
