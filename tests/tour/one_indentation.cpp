// SPDX-License-Identifier: BSD-3-Clause
// One indentation, station by station: a rigid ball is pressed into steel in two steps and lifted off. The loop is that of
// CoupledContact::advance without its short cuts. docs/developer/tour.md shows this program and its output.
#include <brinell/contact/elastic_contact.hpp>
#include <brinell/elastoplastic/anderson.hpp>
#include <brinell/elastoplastic/increment.hpp>
#include <brinell/halfspace/half_space.hpp>
#include <brinell/halfspace/surface_compliance.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

using namespace brinell;

namespace
{

// The problem: grids, materials, shape, tolerances, and the loads [N] at the ends of the steps.
const double cell = 4e-6, radius = 1e-3;
const SurfaceGrid surface{.nx = 25, .ny = 25, .dx = cell, .dy = cell};
const VolumeGrid volume{.surface = surface, .nz = 12, .dz = cell};
const constitutive::Material steel{{210e9, 0.3}, constitutive::LinearHardening{800e6, 4e9}};
const constitutive::Material rigid{{std::numeric_limits<double>::infinity(), 0.3}, {}};
const double scale = 9e-8; // approach at first yield [m], to which tolerances are relative
const elastoplastic::Settings settings{.yield_tolerance = 1e-3,
                                       .displacement_tolerance = 1e-3,
                                       .shortcuts = false, // every cell is active, every layer computed
                                       .windows = false};
const double stiffness_share = 0.6; // c / (2 mu)
const std::vector<double> loads{2.0, 4.0, 0.0};

std::vector<double> distance_of_ball()
{
  std::vector<double> distance(surface.size());
  for (int j = 0; j < surface.ny; ++j)
    for (int i = 0; i < surface.nx; ++i)
      distance[surface.index(i, j)] = (surface.x(i) * surface.x(i) + surface.y(j) * surface.y(j)) / (2.0 * radius);
  return distance;
}

double largest(std::span<const double> values)
{
  return *std::max_element(values.begin(), values.end());
}

/// Largest von Mises norm of a field of deviators, component by component.
double largest_norm(std::span<const double> field)
{
  double found = 0.0;
  for (std::size_t i = 0; i < volume.size(); ++i)
    found = std::max(found, von_mises(deviator_at(field, volume.size(), i)));
  return found;
}

/// Largest von Mises norm of the deviators of the active cells, which lie one after the other.
double largest_of_active(std::span<const double> deviators)
{
  double found = 0.0;
  for (std::size_t first = 0; first < deviators.size(); first += Deviator::size)
    found = std::max(found, von_mises(deviator_at(deviators.subspan(first, Deviator::size), 1, 0)));
  return found;
}

double largest_difference(std::span<const double> a, std::span<const double> b)
{
  double found = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    found = std::max(found, std::abs(a[i] - b[i]));
  return found;
}

/// Parts of the indentation. Operators are planned once, from grids and constants; all history is in the state of the body.
struct Parts
{
  std::shared_ptr<const halfspace::HalfSpace> half_space =
      std::make_shared<const halfspace::HalfSpace>(volume, steel.elastic);
  halfspace::SurfaceCompliance compliance{surface, contact_modulus(steel.elastic, rigid.elastic)};
  contact::ElasticContact elastic_contact{compliance};
  elastoplastic::Body body{volume, half_space, steel, {.shortcuts = settings.shortcuts}};
  std::vector<double> ball = distance_of_ball();
  std::vector<double> pressure = std::vector<double>(surface.size()), gap = pressure;
  double approach = 0.0;
};

/// Stress of pressure and plastic strain as Body::update finds it for itself; here it is computed to be seen [Pa].
double largest_stress(const Parts& parts)
{
  halfspace::HalfSpace::Work work = parts.half_space->make_work();
  std::vector<double> deviator(Deviator::size * volume.size()), trace(volume.size());
  parts.half_space->full_stress({.pressure = parts.pressure}, parts.body.state().plastic_strain, work, deviator, trace);
  return largest_norm(deviator);
}

/// One evaluation of g(q).
/// @returns whether q is a fixed point
bool evaluate(Parts& parts, double load, int evaluation)
{
  elastoplastic::Body& body = parts.body;
  // Plastic strain: the return mapping of q in each cell. Residual displacement: that of all plastic strain.
  const double moved = body.integrate(settings.integration);
  const double strain = 2.0 / 3.0 * largest_norm(body.state().plastic_strain);
  // Pressure: elastic contact of the ball with the surface and its residual displacement.
  std::vector<double> distance = parts.ball;
  for (std::size_t i = 0; i < distance.size(); ++i)
    distance[i] += body.residual_displacement()[i];
  const contact::Report solved =
      parts.elastic_contact.solve(distance, {contact::Drive::Kind::load, load}, settings.tolerance_of_contact() * scale,
                                  2000, parts.pressure, parts.gap);
  parts.approach = solved.approach;
  // Stress, then g(q): the stress plus c times the strain of the increment. Residual: g(q) - q.
  const bool grew = body.update({.pressure = parts.pressure});
  std::printf("%3d  %8.4f  %10.2f  %8.4f  %8.1f  %8.1f  %10.1e\n", evaluation, 100.0 * strain,
              1e9 * largest(body.residual_displacement()), 1e-9 * largest(parts.pressure), 1e-6 * largest_stress(parts),
              1e-6 * largest_of_active(body.active().mapped()), body.yield_error());
  return evaluation > 1 && solved.converged && !grew && body.yield_error() <= settings.yield_tolerance &&
         moved <= settings.displacement_tolerance * scale;
}

/// One increment.
/// @param pressed  load before it [N]
/// @returns number of evaluations
int advance(Parts& parts, double load, double pressed)
{
  elastoplastic::Body& body = parts.body;
  using Guess = elastoplastic::Body::Guess;
  const bool lifts = load < pressed; // then the flow does not go on
  body.begin(0, stiffness_share, lifts ? Guess::stress : Guess::last_increment);
  std::printf("step to %g N\nguess: q up to %.1f MPa in %zu cells\n", load, 1e-6 * largest_of_active(body.trial()),
              body.active().size());
  std::printf("      plastic    residual  pressure    stress      g(q)  |g(q) - q|\n"
              "       strain        disp.                               over yield\n"
              "            %%          nm       GPa       MPa       MPa      stress\n");
  elastoplastic::Anderson anderson(settings.anderson_depth);
  int evaluations = 1;
  for (; !evaluate(parts, load, evaluations); ++evaluations)
    anderson.advance(body.trial(), body.active().mapped(), body.active().flow()); // the next q
  body.complete_trial();
  body.commit({.pressure = parts.pressure}); // the trial becomes the state
  std::printf("commit: approach %.1f nm, dissipation %.4f uJ, locked in %.4f uJ\n\n", 1e9 * parts.approach,
              1e6 * body.state().dissipation, 1e6 * body.state().locked_in_energy);
  return evaluations;
}

} // namespace

int main()
{
  Parts parts;
  elastoplastic::CoupledContact coupled(surface, volume, volume, steel, rigid, {scale, scale}, settings);
  bool is_same = true;
  double pressed = 0.0;
  for (const double load : loads)
  {
    const int evaluations = advance(parts, load, std::exchange(pressed, load));
    const elastoplastic::IncrementReport report =
        coupled.advance(parts.ball, {contact::Drive::Kind::load, load}, {}, {.stiffness_share = stiffness_share});
    is_same = is_same && report.converged && report.evaluations == evaluations &&
              largest_difference(coupled.pressure(), parts.pressure) == 0.0 &&
              largest_difference(coupled.lower().state().plastic_strain, parts.body.state().plastic_strain) == 0.0;
  }
  // The calls are those of CoupledContact, in the same order, so that not even the last digit may differ.
  std::printf("CoupledContact::advance: %s\n", is_same ? "the same evaluations, pressure and strain" : "differs");
  return is_same ? 0 : 1;
}
