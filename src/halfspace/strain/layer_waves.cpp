// SPDX-License-Identifier: BSD-3-Clause
#include "layer_waves.hpp"

#include <utility>

namespace brinell::halfspace::layer_waves
{

void Factors::set(std::size_t lane, double m, double n, double kept_x, double kept_y, double dz, double nu, double mu)
{
  const FactorsOf<double> of_wave = factors_of(m, n, kept_x, kept_y, dz, nu, mu);
  for (const auto& [to, value] : {std::pair{&lx, of_wave.lx},
                                  {&ly, of_wave.ly},
                                  {&lx2, of_wave.lx2},
                                  {&ly2, of_wave.ly2},
                                  {&lxly, of_wave.lxly},
                                  {&q, of_wave.q},
                                  {&e0, of_wave.e0},
                                  {&e1, of_wave.e1},
                                  {&e2, of_wave.e2},
                                  {&e3, of_wave.e3},
                                  {&m0, of_wave.m0},
                                  {&m1, of_wave.m1},
                                  {&m2, of_wave.m2},
                                  {&x, of_wave.x},
                                  {&rise, of_wave.rise},
                                  {&lag, of_wave.lag}})
    (*to)[lane] = value;
}

void add_local(const Elastic& elastic, int component, const std::array<const double*, Deviator::size>& strain,
               std::size_t cells, double* stress)
{
  const HeldLayer held = held_layer(elastic.poisson_ratio, elastic.shear_modulus());
  const auto add = [&](double factor, Deviator::Component of)
  {
    const double* e = strain[of];
#pragma omp simd
    for (std::size_t i = 0; i < cells; ++i)
      stress[i] += factor * e[i];
  };
  constexpr int trace = Deviator::size;
  if (component == Deviator::xy)
    add(held.shear, Deviator::xy);
  else if (component == Deviator::xx || component == Deviator::yy || component == trace)
  {
    add(component == trace ? held.trace : component == Deviator::xx ? held.own : held.other, Deviator::xx);
    add(component == trace ? held.trace : component == Deviator::xx ? held.other : held.own, Deviator::yy);
  }
}

} // namespace brinell::halfspace::layer_waves
