// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/green/elastic_stack.hpp"
#include "brinell/green/thermal_stack.hpp"
#include "heat_memory.hpp"
#include "thermal_wave.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

/// Thermal stress of rows of waves.
namespace brinell::halfspace
{

/// Trace and deviator of the thermal stress of a row of waves, as by `stress_wave` for each wave, with the condition of a
/// traction-free surface inserted: zz = k [(1 + kz) S - psi], and so the trace is 2 [(1 + nu) k S - T], where S is e^{-kz} times
/// the potential at the surface. Real and imaginary parts are computed separately so that the compiler can vectorise over the
/// waves.
class StressOfRow
{
public:
  StressOfRow(double poisson_ratio, double scale) : nu_(poisson_ratio), scale_(scale) {}

  void trace(const HeatRow& heat, Complex* out) const
  {
    const double *temperature = parts(heat.temperature), *surface = parts(heat.potential_at_surface);
    auto* to = reinterpret_cast<double*>(out);
#pragma omp simd
    for (std::size_t i = 0; i < heat.waves.size(); ++i)
    {
      const double of_surface = (1.0 + nu_) * heat.waves[i].k * heat.decay[i];
      to[2 * i] = 2.0 * scale_ * (of_surface * surface[2 * i] - temperature[2 * i]);
      to[2 * i + 1] = 2.0 * scale_ * (of_surface * surface[2 * i + 1] - temperature[2 * i + 1]);
    }
  }

  /// @param out  five components
  void deviator(const HeatRow& heat, std::span<Complex* const> out) const
  {
    const double *temperature = parts(heat.temperature), *potential = parts(heat.potential), *slope = parts(heat.slope),
                 *surface = parts(heat.potential_at_surface), *decay = heat.decay.data();
    const SurfaceWave* waves = heat.waves.data();
    const auto to = [&](int component) { return reinterpret_cast<double*>(out[static_cast<std::size_t>(component)]); };
    double *xx = to(Deviator::xx), *yy = to(Deviator::yy), *yz = to(Deviator::yz), *xz = to(Deviator::xz),
           *xy = to(Deviator::xy);
    const double depth = heat.depth, nu = nu_, scale = scale_, third = 1.0 / 3.0;
#pragma omp simd
    for (std::size_t i = 0; i < heat.waves.size(); ++i)
    {
      const SurfaceWave& wave = waves[i];
      const double kz = wave.k * depth, inverse = wave.k > 0.0 ? scale / wave.k : 0.0;
      const double along = wave.kx * wave.kx * inverse, across = wave.ky * wave.ky * inverse,
                   both = wave.odd_x * wave.odd_y * inverse, of_slope_x = scale * wave.odd_x,
                   of_slope_y = scale * wave.odd_y;
      const std::size_t re = 2 * i, im = re + 1;
      const double s_re = decay[i] * surface[re], s_im = decay[i] * surface[im];
      const double of_bent = 1.0 - 2.0 * nu - kz, of_all = third * (4.0 * nu - 2.0) * wave.k;
      const double bent_re = potential[re] + of_bent * s_re, bent_im = potential[im] + of_bent * s_im;
      const double all_re = scale * (of_all * s_re - third * temperature[re]),
                   all_im = scale * (of_all * s_im - third * temperature[im]);
      // -i times the slope
      const double slope_re = slope[im] + kz * s_im, slope_im = -(slope[re] + kz * s_re);
      xx[re] = all_re + along * bent_re;
      xx[im] = all_im + along * bent_im;
      yy[re] = all_re + across * bent_re;
      yy[im] = all_im + across * bent_im;
      yz[re] = of_slope_y * slope_re;
      yz[im] = of_slope_y * slope_im;
      xz[re] = of_slope_x * slope_re;
      xz[im] = of_slope_x * slope_im;
      xy[re] = both * bent_re;
      xy[im] = both * bent_im;
    }
  }

private:
  static const double* parts(std::span<const Complex> values)
  {
    return reinterpret_cast<const double*>(values.data());
  }

  double nu_, scale_; ///< 2 mu alpha (1 + nu)/(1 - nu)
};

/// Fields of a row of waves in a coated body.
struct CoatedStress
{
  const ThermalStack& thermal;
  const ElasticStack& stack;
  bool has_temperature, has_trace, has_deviator;

  void operator()(const HeatRow& heat, std::span<Complex* const> out) const
  {
    const std::size_t layer = stack.layer_at(heat.depth);
    const Elastic& body = stack.of_layer(layer);
    const double nu = body.poisson_ratio, held = body.young_modulus * thermal.of_layer(layer).expansion;
    std::size_t field = 0;
    if (has_temperature)
      std::copy(heat.temperature.begin(), heat.temperature.end(), out[field++]);
    Complex* const trace = has_trace ? out[field++] : nullptr;
    const auto to = [&](int component) { return out[field + static_cast<std::size_t>(component)]; };
    for (std::size_t i = 0; i < heat.waves.size(); ++i)
    {
      const SurfaceWave& wave = heat.waves[i];
      const Complex ll = heat.ll[i], zz = heat.zz[i];
      // Across a wave nothing moves; a uniform temperature is held in both directions alike.
      const Complex tt = wave.k > 0.0 ? nu * (ll + zz) - held * heat.temperature[i] : ll;
      const Complex all = ll + zz + tt;
      if (has_trace)
        trace[i] = all;
      if (!has_deviator)
        continue;
      const double inverse = wave.k > 0.0 ? 1.0 / wave.k : 0.0;
      const double x = wave.kx * inverse, y = wave.ky * inverse;
      const Complex apart = ll - tt, shear = inverse * -1.0 * divided_by_i(heat.lz[i]);
      to(Deviator::xx)[i] = tt + x * x * apart - all / 3.0;
      to(Deviator::yy)[i] = tt + y * y * apart - all / 3.0;
      to(Deviator::yz)[i] = wave.odd_y * shear;
      to(Deviator::xz)[i] = wave.odd_x * shear;
      to(Deviator::xy)[i] = wave.odd_x * wave.odd_y * inverse * inverse * apart;
    }
  }
};

} // namespace brinell::halfspace
