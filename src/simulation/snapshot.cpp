// SPDX-License-Identifier: BSD-3-Clause
#include "snapshot.hpp"

namespace brinell::simulation
{

namespace
{

/// Six components of a deviator field plus a third of a trace.
std::array<std::vector<double>, 6> expand(const std::vector<double>& deviator, const std::vector<double>& trace)
{
  using D = Deviator;
  const std::size_t n = trace.size();
  const auto component = [&](int c, std::size_t i) { return deviator[static_cast<std::size_t>(c) * n + i]; };
  std::array<std::vector<double>, 6> out;
  for (auto& field : out)
    field.resize(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const double mean = trace[i] / 3.0;
    out[0][i] = component(D::xx, i) + mean;
    out[1][i] = component(D::yy, i) + mean;
    out[2][i] = mean - component(D::xx, i) - component(D::yy, i);
    out[3][i] = component(D::yz, i);
    out[4][i] = component(D::xz, i);
    out[5][i] = component(D::xy, i);
  }
  return out;
}

} // namespace

BodySnapshot body_snapshot(const elastoplastic::CoupledContact& pair, const elastoplastic::Body& body,
                           const elastoplastic::Place& place, double origin, double contact_x)
{
  BodySnapshot s;
  s.grid = body.grid();
  s.x0 = origin;
  s.y0 = -0.5 * (s.grid.surface.ny - 1) * s.grid.surface.dy;
  s.contact_x = contact_x;
  if (!body.shared_half_space()) // rigid
    return s;
  s.equivalent_plastic_strain = body.state().equivalent;
  s.residual_displacement = body.state().residual_displacement;
  std::vector<double> pressure;
  pair.spread_pressure(body, place, pressure);
  std::vector<double> deviator(Deviator::size * s.grid.size());
  std::vector<double> trace(s.grid.size(), 0.0);
  s.plastic_strain = expand(body.state().plastic_strain, trace);
  const halfspace::HalfSpace& half_space = *body.shared_half_space();
  halfspace::HalfSpace::Work work = half_space.make_work();
  half_space.full_stress(pressure, body.state().plastic_strain, work, deviator, trace);
  body.add_initial_stress(s.grid.nz, deviator);
  for (std::size_t i = 0; i < trace.size(); ++i)
    trace[i] += 2.0 * body.initial_stress()[i / s.grid.surface.size()];
  s.stress = expand(deviator, trace);
  return s;
}

} // namespace brinell::simulation
