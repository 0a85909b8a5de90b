// SPDX-License-Identifier: BSD-3-Clause
#include "stack_shears.hpp"

#include "banded_fields.hpp"
#include "radial_fields.hpp"
#include "stack_scales.hpp"

#include <cmath>

namespace brinell::halfspace
{

namespace
{

/// Displacements times k by a wave of unit traction [1/Pa]: normal, along + across, along - across, coupling. Along the surface
/// a shear q displaces by (across I + (along - across) l l^T) q, with l the direction of the wavevector.
WaveParts parts_of(double normal, double along, double across, double coupling)
{
  return {normal, along + across, along - across, coupling, 0.0, 0.0};
}

WaveParts homogeneous_parts(const Elastic& body)
{
  if (body.is_rigid())
    return {};
  const double nu = body.poisson_ratio, mu = body.shear_modulus();
  return parts_of((1.0 - nu) / mu, (1.0 - nu) / mu, 1.0 / mu, -0.5 * (1.0 - 2.0 * nu) / mu);
}

constexpr std::array<WaveTerm, 8> terms{{{excess::zz, 0, 0, false, 1.0},
                                         {excess::xx, 1, 0, false, 0.5},
                                         {excess::xx, 2, 2, false, 0.5},
                                         {excess::yy, 1, 0, false, 0.5},
                                         {excess::yy, 2, 2, false, -0.5},
                                         {excess::xy, 2, 2, true, 0.5},
                                         {excess::x, 3, 1, false, 1.0},
                                         {excess::y, 3, 1, true, 1.0}}};

WaveParts less(WaveParts parts, const WaveParts& other)
{
  for (std::size_t p = 0; p < parts.size(); ++p)
    parts[p] -= other[p];
  return parts;
}

WaveParts excess_parts(const ElasticStack& stack, double k,
                       double green::WaveCompliance::*of = &green::WaveCompliance::normal)
{
  const green::WaveCompliance c = green::StackWave(stack, k).compliance();
  return less(parts_of(k * c.*of, k * c.along, k * c.across, k * c.coupling), homogeneous_parts(stack.top()));
}

void add(double factor, const SurfaceExcess& more, SurfaceExcess& sum)
{
  for (std::size_t t = 0; t < excess::count; ++t)
    sum[t] += (t == excess::x || t == excess::y ? factor : 1.0) * more[t];
}

} // namespace

Quadrant<SurfaceExcess> excess_surface(const SurfaceGrid& surface, const ElasticStack& stack, double reference,
                                       double green::WaveCompliance::*of)
{
  const SurfaceGrid grid = surface.whole();
  WaveScales scales = surface_scales(stack);
  scales.is_over_k = true;
  scales.at_zero = less(homogeneous_parts(stack.substrate), homogeneous_parts(stack.top()));
  std::vector<WaveParts> values;
  for (const double k : RadialFields::Table::wavenumbers(scales.smallest(), scales.largest()))
    values.push_back(excess_parts(stack, k, of));
  const RadialFields::Table waves(scales.smallest(), values);
  if (grid.is_periodic_x() || grid.is_periodic_y())
    return banded_cells(grid, scales, terms, waves, reference);
  return RadialFields(grid, scales, terms, {waves}).cells(0);
}

Quadrant<SurfaceExcess> excess_surface(const SurfaceGrid& surface, const std::vector<LayeredBody>& bodies,
                                       double reference)
{
  Quadrant<SurfaceExcess> sum(surface.whole());
  for (const LayeredBody& body : bodies)
  {
    const Quadrant<SurfaceExcess> more = excess_surface(surface, body.stack, reference);
    for (std::size_t n = 0; n < sum.values.size(); ++n)
      add(body.sign, more.values[n], sum.values[n]);
  }
  return sum;
}

SurfaceExcess excess_wave(const ElasticStack& stack, double m, double n)
{
  const double k = std::hypot(m, n);
  SurfaceExcess value = components_of(terms, excess_parts(stack, k), m / k, n / k);
  for (double& v : value)
    v /= k;
  return value;
}

SurfaceExcess excess_wave(const std::vector<LayeredBody>& bodies, double m, double n)
{
  SurfaceExcess sum{};
  for (const LayeredBody& body : bodies)
    add(body.sign, excess_wave(body.stack, m, n), sum);
  return sum;
}

} // namespace brinell::halfspace
