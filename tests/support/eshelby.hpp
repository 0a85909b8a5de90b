// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/sym_tensor.hpp"
#include "brinell/green/elastic.hpp"
#include "gauss.hpp"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>

/// Eshelby's (1957) ellipsoidal inclusion in a body without boundary, written with Mura's (1987, Eqs. 11.15 to 11.18) integrals.
namespace brinell::test
{

/// Matrix from strain to stress of an isotropic material, for tensor components (xx, yy, zz, yz, xz, xy).
inline Eigen::Matrix<double, 6, 6> stiffness(const Elastic& elastic)
{
  const double mu = elastic.shear_modulus();
  const double lambda = 2.0 * mu * elastic.poisson_ratio / (1.0 - 2.0 * elastic.poisson_ratio);
  Eigen::Matrix<double, 6, 6> c = 2.0 * mu * Eigen::Matrix<double, 6, 6>::Identity();
  c.topLeftCorner<3, 3>().array() += lambda;
  return c;
}

/// Eshelby's tensor as a matrix from the eigenstrain of an ellipsoid to the strain in it, for tensor components.
inline Eigen::Matrix<double, 6, 6> eshelby_tensor(const std::array<double, 3>& axes, double nu)
{
  constexpr double pi = std::numbers::pi;
  const double product = axes[0] * axes[1] * axes[2];
  std::array<double, 3> one{};
  std::array<std::array<double, 3>, 3> two{};
  // s = a^2 t^2/(1 - t^2) makes the integrands smooth from 0 to 1.
  const Gauss points(60, 0.0, 1.0);
  const double a2 = std::pow(product, 2.0 / 3.0);
  for (std::size_t q = 0; q < points.point.size(); ++q)
  {
    const double t = points.point[q], u = 1.0 - t * t, s = a2 * t * t / u;
    const double ds = points.weight[q] * a2 * 2.0 * t / (u * u);
    double delta = 1.0;
    for (const double a : axes)
      delta *= std::sqrt(a * a + s);
    for (std::size_t i = 0; i < 3; ++i)
    {
      one[i] += 2.0 * pi * product * ds / ((axes[i] * axes[i] + s) * delta);
      for (std::size_t j = 0; j < 3; ++j)
        two[i][j] += 2.0 * pi * product * ds / ((axes[i] * axes[i] + s) * (axes[j] * axes[j] + s) * delta);
    }
  }
  Eigen::Matrix<double, 6, 6> result = Eigen::Matrix<double, 6, 6>::Zero();
  const double q = 1.0 / (8.0 * pi * (1.0 - nu)), r = (1.0 - 2.0 * nu) * q;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      result(i, j) = (i == j ? 3.0 : 1.0) * q * axes[b] * axes[b] * two[a][b] + (i == j ? r : -r) * one[a];
    }
  constexpr std::array<std::array<std::size_t, 2>, 3> pairs{{{1, 2}, {0, 2}, {0, 1}}};
  for (int shear = 0; shear < 3; ++shear)
  {
    const auto [i, j] = pairs[static_cast<std::size_t>(shear)];
    result(3 + shear, 3 + shear) =
        q * (axes[i] * axes[i] + axes[j] * axes[j]) * two[i][j] + r * (one[i] + one[j]); // 2 S_ijij
  }
  return result;
}

/// Uniform fields in an ellipsoid.
struct InEllipsoid
{
  SymTensor stress{};
  SymTensor equivalent{}; ///< strain of a body without inclusion that has this stress
};

/// Fields in an ellipsoid of another material under a uniform stress far away.
inline InEllipsoid in_ellipsoid(const std::array<double, 3>& axes, const Elastic& body, const Elastic& inclusion,
                                const SymTensor& remote)
{
  using Matrix = Eigen::Matrix<double, 6, 6>;
  using Vector = Eigen::Matrix<double, 6, 1>;
  const Matrix c0 = stiffness(body), soft = c0.inverse(), identity = Matrix::Identity();
  const Matrix inner = inclusion.young_modulus == 0.0 ? Matrix(Matrix::Zero()) : stiffness(inclusion);
  const Matrix s = eshelby_tensor(axes, body.poisson_ratio);
  Vector far;
  for (int i = 0; i < 6; ++i)
    far[i] = remote[static_cast<std::size_t>(i)];
  const Vector strain = (identity + s * soft * (inner - c0)).inverse() * (soft * far);
  const Vector stress = inner * strain, equivalent = strain - soft * stress;
  InEllipsoid result;
  for (int i = 0; i < 6; ++i)
  {
    result.stress[static_cast<std::size_t>(i)] = stress[i];
    result.equivalent[static_cast<std::size_t>(i)] = equivalent[i];
  }
  return result;
}

} // namespace brinell::test
