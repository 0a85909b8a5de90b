// SPDX-License-Identifier: BSD-3-Clause
#include "stack_image_samples.hpp"

#include "brinell/green/stack_strain.hpp"
#include "green/sheet_waves.hpp"

#include <complex>

namespace brinell::halfspace::images
{

namespace
{

using Complex = std::complex<double>;
constexpr std::size_t pairs = static_cast<std::size_t>(stresses) * static_cast<std::size_t>(strains);

/// A strain whose component number `component` is 1, in the frame of the wavevector.
green::WaveStrain unit_strain(int component, const green::WaveDirection<double>& f)
{
  Deviator e;
  e[component] = 1.0;
  using D = Deviator;
  const double xx = e[D::xx], yy = e[D::yy], xy = e[D::xy];
  return {f.lx2 * xx + f.ly2 * yy + 2.0 * f.lxly * xy,
          f.ly2 * xx + f.lx2 * yy - 2.0 * f.lxly * xy,
          -xx - yy,
          f.lx * e[D::xz] + f.ly * e[D::yz],
          f.lxly * (yy - xx) + (f.lx2 - f.ly2) * xy,
          f.lx * e[D::yz] - f.ly * e[D::xz]};
}

/// Adds the stress of a sheet at all depths by one wave, [depth][strain][stress][distance in x].
void add_wave(const WaveRow::Wave& wave, double n, const std::vector<double>& depths, double source,
              const ElasticStack& stack, std::vector<double>& sum)
{
  const green::StackWave waves(stack, std::hypot(wave.m, n));
  const green::WaveDirection<double> towards = green::direction_of(wave.m, n);
  const std::size_t along = wave.in_x[0].size();
  for (int e = 0; e < strains; ++e)
  {
    const auto sheet = green::StackStrain::sheet(waves, stack.layer_at(source), source, unit_strain(e, towards));
    for (std::size_t z = 0; z < depths.size(); ++z)
    {
      const std::size_t layer = stack.layer_at(depths[z]);
      const green::StrainedField s = sheet.at(layer, depths[z]);
      const auto axes =
          green::in_axes<double, Complex>(towards, stack.of_layer(layer).poisson_ratio, s.ll, s.zz, s.lz, s.lt, s.tz);
      const std::array<Complex, stresses> values{axes.xx, axes.yy, axes.yz, axes.xz, axes.xy, axes.trace};
      for (int c = 0; c < stresses; ++c)
      {
        const bool odd_x = is_odd(odd_in_x, c, e), odd_y = is_odd(odd_in_y, c, e);
        // Sum of K e^{ik.r} over the signs of m and n, K being real if odd in both or none, else imaginary.
        const Complex& value = values[static_cast<std::size_t>(c)];
        const double amplitude =
            wave.weight * (odd_x == odd_y ? (odd_x ? -value.real() : value.real()) : -value.imag());
        double* to = sum.data() + (z * pairs + static_cast<std::size_t>(e * stresses + c)) * along;
        for (std::size_t o = 0; o < along; ++o)
          to[o] += amplitude * wave.in_x[odd_x ? 1 : 0][o];
      }
    }
  }
}

} // namespace

std::vector<double> sampled_in_layers(std::span<const WaveRow> rows, const std::vector<double>& depths,
                                      const ElasticStack& stack)
{
  const std::size_t along_x = rows.front().waves.front().in_x[0].size(), along_y = rows.front().in_y[0].size();
  const std::size_t count = depths.size(), block = pairs * along_x * along_y;
  std::vector<double> value(count * count * block);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t source = 0; source < count; ++source)
  {
    std::vector<double> in_row(count * pairs * along_x);
    for (const WaveRow& row : rows)
    {
      std::fill(in_row.begin(), in_row.end(), 0.0);
      for (const WaveRow::Wave& wave : row.waves)
        add_wave(wave, row.n, depths, depths[source], stack, in_row);
      const double* from = in_row.data();
      for (std::size_t z = 0; z < count; ++z)
      {
        double* to = value.data() + (z * count + source) * block;
        for (int e = 0; e < strains; ++e)
          for (int c = 0; c < stresses; ++c, from += along_x)
            for (const double in_y : row.in_y[is_odd(odd_in_y, c, e) ? 1 : 0])
              for (std::size_t ox = 0; ox < along_x; ++ox)
                *to++ += in_y * from[ox];
      }
    }
  }
  return value;
}

} // namespace brinell::halfspace::images
