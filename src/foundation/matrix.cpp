// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/matrix.hpp"

#include <Eigen/Dense>

namespace brinell
{

namespace
{

using EigenMap = Eigen::Map<Eigen::MatrixXd, Eigen::Unaligned, Eigen::OuterStride<>>;
using ConstEigenMap = Eigen::Map<const Eigen::MatrixXd, Eigen::Unaligned, Eigen::OuterStride<>>;
using ConstEigenVector = Eigen::Map<const Eigen::VectorXd>;

ConstEigenMap eigen_map(const MatrixView& a)
{
  return {a.values, a.rows, a.columns, Eigen::OuterStride<>(a.stride)};
}

ConstEigenVector eigen_map(std::span<const double> a)
{
  return {a.data(), static_cast<Eigen::Index>(a.size())};
}

EigenMap packed_map(double* values, int rows, int columns)
{
  return {values, rows, columns, Eigen::OuterStride<>(rows)};
}

Matrix copy_of(const Eigen::MatrixXd& from)
{
  Matrix to(static_cast<int>(from.rows()), static_cast<int>(from.cols()));
  packed_map(to.column(0), to.rows(), to.columns()) = from;
  return to;
}

} // namespace

void assign_product(const MatrixView& a, const MatrixView& b, double* to)
{
  packed_map(to, a.rows, b.columns).noalias() = eigen_map(a) * eigen_map(b);
}

void assign_transposed_product(const MatrixView& a, const MatrixView& b, Matrix& to)
{
  packed_map(to.column(0), to.rows(), to.columns()).topRows(a.columns).noalias() =
      eigen_map(a).transpose() * eigen_map(b);
}

void subtract_product(const MatrixView& a, const MatrixView& b, double* from)
{
  packed_map(from, a.rows, b.rows).noalias() -= eigen_map(a) * eigen_map(b).transpose();
}

double scalar_product(std::span<const double> a, std::span<const double> b)
{
  return eigen_map(a).dot(eigen_map(b));
}

Matrix least_squares(const Matrix& a, const Matrix& b)
{
  return copy_of(Eigen::MatrixXd(eigen_map(a)).colPivHouseholderQr().solve(eigen_map(b)));
}

std::vector<double> solve(const Matrix& a, std::span<const double> b)
{
  const Eigen::VectorXd x = Eigen::MatrixXd(eigen_map(a)).partialPivLu().solve(eigen_map(b));
  return {x.begin(), x.end()};
}

Eigensystem eigensystem_of_tridiagonal(std::span<const double> diagonal, std::span<const double> beside)
{
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes;
  modes.computeFromTridiagonal(Eigen::VectorXd(eigen_map(diagonal)), Eigen::VectorXd(eigen_map(beside)));
  const Eigen::VectorXd& values = modes.eigenvalues();
  return {{values.begin(), values.end()}, copy_of(modes.eigenvectors())};
}

} // namespace brinell
