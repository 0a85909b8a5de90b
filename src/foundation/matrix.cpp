// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/matrix.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <omp.h>
#include <utility>

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

Factorised::Factorised(Matrix a) : factors_(std::move(a))
{
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1); // of this thread: the sums of Eigen's products depend on the number
  Eigen::Map<Eigen::MatrixXd> values(factors_.column(0), factors_.rows(), factors_.columns());
  const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>> lu(values); // in place
  omp_set_num_threads(threads);
  const auto& order = lu.permutationP().indices();
  place_.assign(order.begin(), order.end());
}

void Factorised::solve(std::span<double> b) const
{
  const Eigen::Map<const Eigen::MatrixXd> values(factors_.column(0), factors_.rows(), factors_.columns());
  Eigen::VectorXd x(factors_.rows());
  for (std::size_t row = 0; row < place_.size(); ++row)
    x[place_[row]] = b[row];
  values.triangularView<Eigen::UnitLower>().solveInPlace(x);
  values.triangularView<Eigen::Upper>().solveInPlace(x);
  std::copy(x.begin(), x.end(), b.begin());
}

} // namespace brinell
