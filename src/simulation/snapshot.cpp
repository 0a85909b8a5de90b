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

BodySnapshot body_snapshot(const elastoplastic::Body& body, const SurfaceGrid& contact,
                           std::span<const double> pressure, int offset, double origin, double contact_x)
{
  BodySnapshot s;
  s.grid = body.grid();
  s.x0 = origin;
  s.y0 = -0.5 * (s.grid.surface.ny - 1) * s.grid.surface.dy;
  s.contact_x = contact_x;
  s.equivalent_plastic_strain = body.state().equivalent;
  s.residual_displacement = body.state().residual_displacement;

  std::vector<double> on_body(s.grid.surface.size(), 0.0);
  for (int j = 0; j < contact.ny; ++j)
    for (int i = 0; i < contact.nx; ++i)
      if (const int column = i + offset; column >= 0 && column < s.grid.surface.nx)
        on_body[static_cast<std::size_t>(column + s.grid.surface.nx * j)] =
            pressure[static_cast<std::size_t>(i + contact.nx * j)];
  std::vector<double> deviator(Deviator::size * s.grid.size());
  std::vector<double> trace(s.grid.size(), 0.0);
  s.plastic_strain = expand(body.state().plastic_strain, trace);
  halfspace::HalfSpace::Work work = body.half_space().make_work();
  body.half_space().full_stress(on_body, body.state().plastic_strain, work, deviator, trace);
  body.add_initial_stress(s.grid.nz, deviator);
  for (std::size_t i = 0; i < trace.size(); ++i)
    trace[i] += 2.0 * body.initial_stress()[i / s.grid.surface.size()];
  s.stress = expand(deviator, trace);
  return s;
}

} // namespace

Snapshot snapshot(const elastoplastic::CoupledContact& pair, const Frame& frame, const StepRecord& record)
{
  Snapshot s;
  s.record = record;
  s.contact = pair.grid();
  s.x0 = frame.x0;
  s.y0 = -0.5 * (s.contact.ny - 1) * s.contact.dy;
  s.pressure.assign(pair.pressure().begin(), pair.pressure().end());
  s.gap.assign(pair.gap().begin(), pair.gap().end());
  s.lower = body_snapshot(pair.lower(), s.contact, pair.pressure(), frame.placement.lower, frame.lower_origin,
                          frame.position.arc_lower);
  s.upper = body_snapshot(pair.upper(), s.contact, pair.pressure(), frame.placement.upper, frame.upper_origin,
                          frame.position.arc_upper);
  return s;
}

} // namespace brinell::simulation
