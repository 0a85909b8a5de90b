// SPDX-License-Identifier: BSD-3-Clause
#include "layer_waves.hpp"

#include <cmath>

namespace brinell::halfspace::layer_waves
{

void Factors::set(std::size_t lane, double m, double n, double kept_x, double kept_y, double dz, double nu, double mu)
{
  const double k = std::hypot(m, n);
  if (k == 0.0)
  {
    lx2[lane] = 1.0; // any direction: every non-local factor is zero
    return;
  }
  lx2[lane] = m * m / (k * k);
  ly2[lane] = n * n / (k * k);
  lx[lane] = kept_x * m / k;
  ly[lane] = kept_y * n / k;
  lxly[lane] = lx[lane] * ly[lane];
  const double stiffness = mu / (2.0 * (1.0 - nu));
  const double x_ = k * dz;
  const double q_ = std::exp(-x_);
  const double s0 = -std::expm1(-x_) / x_; // mean of e^{-kz} over a layer
  const double s1 = 0.5 * (1.0 + q_) - s0; // mean of k (dz / 2 - z) e^{-kz} over a layer
  const double g1 = -std::expm1(-2.0 * x_) / (2.0 * x_) - s0 * s0;
  x[lane] = x_;
  q[lane] = q_;
  e0[lane] = stiffness * x_ * s0 * s0;
  e1[lane] = e0[lane] * x_;
  e2[lane] = 2.0 * stiffness * x_ * g1;
  e3[lane] = mu * x_ * s0 * s0;
  m0[lane] = stiffness * 2.0 * (1.0 - s0);
  m1[lane] = -stiffness * 2.0 * (x_ * s0 - 2.0 * (1.0 - s0));
  m2[lane] = mu * 2.0 * (1.0 - s0);
  rise[lane] = s1 / s0;
  lag[lane] = 0.5 - s1 / (x_ * s0) + 2.0 * g1 / (x_ * s0 * s0);
}

void add_local(const Elastic& elastic, int component, const std::array<const double*, Deviator::size>& strain,
               std::size_t cells, double* stress)
{
  const double nu = elastic.poisson_ratio, mu = elastic.shear_modulus();
  const double stiffness = -2.0 * mu / (1.0 - nu);
  const auto add = [&](double factor, Deviator::Component of)
  {
    const double* e = strain[of];
#pragma omp simd
    for (std::size_t i = 0; i < cells; ++i)
      stress[i] += factor * e[i];
  };
  const double own = stiffness * (2.0 - nu) / 3.0;
  const double other = stiffness * (2.0 * nu - 1.0) / 3.0;
  const double sum = stiffness * (1.0 + nu);
  constexpr int trace = Deviator::size;
  if (component == Deviator::xy)
    add(-2.0 * mu, Deviator::xy);
  else if (component == Deviator::xx || component == Deviator::yy || component == trace)
  {
    add(component == trace ? sum : component == Deviator::xx ? own : other, Deviator::xx);
    add(component == trace ? sum : component == Deviator::xx ? other : own, Deviator::yy);
  }
}

} // namespace brinell::halfspace::layer_waves
