// SPDX-License-Identifier: BSD-3-Clause
#include "stack_shears.hpp"

#include "foundation/fft.hpp"
#include "radial_table.hpp"
#include "stack_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell::halfspace
{

namespace
{

/// Functions of the wavenumber [m/Pa]. Along the surface a shear q displaces by (delta I + tensor l l^T) q, with l the direction of
/// the wavevector.
enum Part : std::size_t
{
  of_normal,
  of_delta,
  of_tensor,
  of_coupling,
  part_count
};
using Parts = std::array<double, part_count>;

Parts parts_of(const green::WaveCompliance& c)
{
  return {c.normal, c.across, c.along - c.across, c.coupling};
}

/// Parts of a homogeneous body, times k [1/Pa].
Parts homogeneous_parts(const Elastic& body)
{
  if (body.is_rigid())
    return {};
  const double nu = body.poisson_ratio, mu = body.shear_modulus();
  return {(1.0 - nu) / mu, 1.0 / mu, -nu / mu, -0.5 * (1.0 - 2.0 * nu) / mu};
}

Parts excess_parts(const ElasticStack& stack, double k)
{
  Parts parts = parts_of(green::StackWave(stack, k).compliance());
  const Parts of_top = homogeneous_parts(stack.top());
  for (std::size_t p = 0; p < part_count; ++p)
    parts[p] -= of_top[p] / k;
  return parts;
}

/// Factors of the forms of long waves, e^{-kH} / k, e^{-kH} and k e^{-kH}.
using Forms = std::array<double, 3>;

SurfaceExcess in_axes(const Parts& p, double lx, double ly)
{
  return {p[of_normal],
          p[of_delta] + lx * lx * p[of_tensor],
          p[of_delta] + ly * ly * p[of_tensor],
          lx * ly * p[of_tensor],
          lx * p[of_coupling],
          ly * p[of_coupling]};
}

/// The parts and their long waves.
struct Radial
{
  double depth; ///< H [m]
  std::array<Forms, part_count> forms{};
  Parts at_zero{}; ///< of the rest at k = 0

  Radial(const SurfaceGrid& grid, const ElasticStack& stack) : depth(depth_of_forms(grid, stack))
  {
    const Parts top = homogeneous_parts(stack.top()), substrate = homogeneous_parts(stack.substrate);
    for (std::size_t p = 0; p < part_count; ++p)
      forms[p][0] = substrate[p] - top[p];
    const double step = long_wave(std::max(reach(stack), depth));
    std::array<Parts, 4> values;
    for (std::size_t n = 0; n < values.size(); ++n)
      values[n] = rest(stack, static_cast<double>(n + 1) * step);
    for (std::size_t p = 0; p < part_count; ++p)
    {
      const LongWaves found = extrapolated({values[0][p], values[1][p], values[2][p], values[3][p]}, step);
      // A constant times components of the direction reaches as far as 1/r^2, k as far as 1/r^3. Without components of the direction
      // a constant does not reach beyond the cell.
      if (p == of_normal || p == of_delta)
      {
        forms[p][1] = -found.rising / depth;
        at_zero[p] = found.level - forms[p][1];
      }
      else
      {
        forms[p][1] = found.level;
        forms[p][2] = found.rising + found.level * depth;
      }
    }
  }
  /// Waves of the stack less those of its top material and the forms.
  [[nodiscard]] Parts rest(const ElasticStack& stack, double k) const
  {
    Parts parts = excess_parts(stack, k);
    const double decay = std::exp(-k * depth);
    for (std::size_t p = 0; p < part_count; ++p)
      parts[p] -= decay * (forms[p][0] / k + forms[p][1] + k * forms[p][2]);
    return parts;
  }
  [[nodiscard]] SurfaceExcess long_waves(const BuriedTerms& t) const
  {
    const auto level = [&](Part p) { return forms[p][0] * t.level[0] + forms[p][1] * t.level[1]; };
    const auto times = [&](Part p, const std::array<double, 3>& of)
    { return forms[p][0] * of[0] + forms[p][1] * of[1] + forms[p][2] * of[2]; };
    SurfaceExcess value{level(of_normal),
                        level(of_delta) + times(of_tensor, t.xx),
                        level(of_delta) + times(of_tensor, t.yy),
                        times(of_tensor, t.xy),
                        times(of_coupling, t.x),
                        times(of_coupling, t.y)};
    for (double& v : value)
      v *= 0.5 * std::numbers::inv_pi;
    return value;
  }
};

/// The short-ranged part, by a lattice of waves.
std::array<std::vector<double>, excess::count> summed_waves(const SurfaceGrid& grid, const ElasticStack& stack,
                                                            const Radial& radial)
{
  const Lattice lattice = lattice_of(grid, stack);
  const WaveRange range = range_of(grid, lattice);
  std::vector<Parts> values;
  for (const double k : RadialTable<part_count>::wavenumbers(range.smallest, range.largest))
    values.push_back(radial.rest(stack, k));
  const RadialTable<part_count> table(range.smallest, values);
  const PaddedFft fft(grid, lattice.px, lattice.py);
  std::array<std::vector<Complex>, excess::count> spectra;
  spectra.fill(std::vector<Complex>(fft.plane()));
  for (int row = 0; row < lattice.py; ++row)
    for (int i = 0; i < fft.kx(); ++i)
    {
      auto sum = folded<SurfaceExcess>(grid, lattice, i, row,
                                       [&](double m, double n, double cell, SurfaceExcess& total)
                                       {
                                         const double k = std::hypot(m, n);
                                         const SurfaceExcess wave = in_axes(table.at(k), m / k, n / k);
                                         for (std::size_t t = 0; t < excess::count; ++t)
                                           total[t] += cell * wave[t];
                                       });
      if (i == 0 && row == 0)
        for (const auto t : {excess::zz, excess::xx, excess::yy})
          sum[t] += radial.at_zero[t == excess::zz ? of_normal : of_delta];
      for (std::size_t t = 0; t < excess::count; ++t)
        spectra[t][static_cast<std::size_t>(row * fft.kx() + i)] =
            t == excess::x || t == excess::y ? Complex(0.0, sum[t]) : Complex(sum[t]);
    }
  std::array<std::vector<double>, excess::count> fields;
  for (std::size_t t = 0; t < excess::count; ++t)
  {
    fields[t].resize(grid.size());
    fft.inverse(spectra[t].data(), fields[t]);
  }
  return fields;
}

void add(double factor, const SurfaceExcess& more, SurfaceExcess& sum)
{
  for (std::size_t t = 0; t < excess::count; ++t)
    sum[t] += (t == excess::x || t == excess::y ? factor : 1.0) * more[t];
}

} // namespace

Quadrant<SurfaceExcess> excess_surface(const SurfaceGrid& surface, const ElasticStack& stack, double reference)
{
  const SurfaceGrid grid = surface.whole();
  const Radial radial(grid, stack);
  const auto fields = summed_waves(grid, stack, radial);
  const Quadrant<BuriedTerms> buried = buried_terms(grid, radial.depth, reference);
  Quadrant<SurfaceExcess> out(grid);
  for (int j = 0; j < out.ny; ++j)
    for (int i = 0; i < out.nx; ++i)
    {
      SurfaceExcess& value = out.at(i, j) = radial.long_waves(buried.at(i, j));
      for (std::size_t t = 0; t < excess::count; ++t)
        value[t] += fields[t][grid.index(i, j)];
    }
  return out;
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
  return in_axes(excess_parts(stack, k), m / k, n / k);
}

SurfaceExcess excess_wave(const std::vector<LayeredBody>& bodies, double m, double n)
{
  SurfaceExcess sum{};
  for (const LayeredBody& body : bodies)
    add(body.sign, excess_wave(body.stack, m, n), sum);
  return sum;
}

} // namespace brinell::halfspace
