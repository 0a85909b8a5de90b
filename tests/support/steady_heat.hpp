// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/steady_field.hpp"
#include "heated_body.hpp"

#include <cmath>
#include <numbers>
#include <vector>

/// A flux that has always moved over `heated_body`, and pulses of heat whose sum over time is independent of how the field is made.
namespace brinell::test
{

inline std::vector<HeatedLayer> layers_of(const halfspace::SteadyField& field, const Field& flux)
{
  const std::size_t n = field.grid().size(), depths = field.depths().size();
  std::vector<HeatedLayer> result;
  std::vector<Field> deviator(depths, Field(Deviator::size * n)), trace(depths, Field(n));
  std::vector<halfspace::ThermalLayer> out;
  for (std::size_t d = 0; d < depths; ++d)
    result.push_back({Field(n), std::vector<SymTensor>(n)});
  for (std::size_t d = 0; d < depths; ++d)
    out.push_back({result[d].temperature, deviator[d], trace[d]});
  field.layers(flux, 0, out);
  for (std::size_t d = 0; d < depths; ++d)
    for (std::size_t i = 0; i < n; ++i)
      result[d].stress[i] = to_tensor(brinell::deviator_at(deviator[d], n, i), trace[d][i]);
  return result;
}

inline Field displacement_of(const halfspace::SteadyField& field, const Field& flux)
{
  Field result(flux.size());
  field.displacement(flux, result);
  return result;
}

inline Field spot(const SurfaceGrid& g, double width)
{
  return sampled(g, [&](int i, int j) { return std::exp(-(g.x(i) * g.x(i) + g.y(j) * g.y(j)) / (width * width)); });
}

/// Integral over the time since heat entered of f(t), which may go like 1/sqrt(t).
template <typename Function>
double over_time(double begin, double end, Function f)
{
  double sum = 0.0, last = std::sqrt(begin);
  for (double next = std::max(1.2 * last, 1e-7 * std::sqrt(end)); last < std::sqrt(end); next *= 1.2)
  {
    const Gauss root(8, last, std::min(next, std::sqrt(end)));
    for (std::size_t g = 0; g < root.point.size(); ++g)
      sum += root.weight[g] * 2.0 * root.point[g] * f(root.point[g] * root.point[g]);
    last = next;
  }
  return sum;
}

/// What a Gaussian pulse of heat leaves at a distance along the surface, a time after: erfc(k sqrt(kappa t)) or k times it by Hankel's
/// transform; far away the first terms of their series, a nucleus of strain.
struct Pulse
{
  double width, spread;
  double kappa = heated_body.diffusivity(), conductivity = heated_body.conductivity;
  double expansion = heated_body.expansion, nu = heated_elastic.poisson_ratio;

  Pulse(double of_flux, double time) : width(of_flux), spread(std::sqrt(heated_body.diffusivity() * time)) {}
  [[nodiscard]] bool is_far(double r) const { return r > 40.0 * std::hypot(width, spread); }
  [[nodiscard]] double hankel(double r, bool times_k) const
  {
    const double end = std::min(12.0 / width, 4.0 / spread);
    const int pieces = 2 + static_cast<int>(end * std::max(r, width) / 4.0);
    double sum = 0.0;
    for (int p = 0; p < pieces; ++p)
    {
      const Gauss wave(8, end * p / pieces, end * (p + 1) / pieces);
      for (std::size_t g = 0; g < wave.point.size(); ++g)
      {
        const double k = wave.point[g];
        sum += wave.weight[g] * j0(k * r) * k * (times_k ? k : 1.0) * std::exp(-0.25 * k * k * width * width) *
               std::erfc(k * spread);
      }
    }
    return 0.5 * width * width * sum * kappa / conductivity;
  }
  /// Of the surface [m], along z.
  [[nodiscard]] double displacement(double r) const
  {
    const double factor = -2.0 * (1.0 + nu) * expansion;
    if (is_far(r))
      return factor * kappa / conductivity * width * width * spread / (std::sqrt(std::numbers::pi) * r * r * r);
    return factor * hankel(r, false);
  }
  /// xx + yy at the surface: -2 E alpha (T - (1 + nu) k erfc)/(1 - nu).
  [[nodiscard]] double stress(double r) const
  {
    const double wide = width * width + 4.0 * spread * spread;
    const double temperature =
        kappa / conductivity * width * width / wide * std::exp(-r * r / wide) / (std::sqrt(std::numbers::pi) * spread);
    const double lifted = is_far(r) ? -0.5 * kappa / conductivity * width * width / (r * r * r) : hankel(r, true);
    return -2.0 * heated_elastic.young_modulus * expansion / (1.0 - nu) * (temperature - (1.0 + nu) * lifted);
  }
};

} // namespace brinell::test
