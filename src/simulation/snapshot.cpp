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

BodySnapshot body_snapshot(const elastoplastic::BodyView& body, double origin, double contact_x)
{
  BodySnapshot s;
  s.grid = body.grid();
  s.x0 = origin;
  s.y0 = -0.5 * (s.grid.surface.ny - 1) * s.grid.surface.dy;
  s.contact_x = contact_x;
  if (body.material().elastic.is_rigid())
    return s;
  elastoplastic::BodyState state = body.state();
  s.equivalent_plastic_strain = std::move(state.equivalent);
  s.residual_displacement = std::move(state.residual_displacement);
  s.plastic_strain = expand(state.plastic_strain, std::vector<double>(s.grid.size()));
  return s;
}

void set_stress(const elastoplastic::CoupledContact::Stress& stress, BodySnapshot& snapshot)
{
  snapshot.stress = expand(stress.deviator, stress.trace);
}

} // namespace brinell::simulation
