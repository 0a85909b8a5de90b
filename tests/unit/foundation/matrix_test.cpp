// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/matrix.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace brinell
{
namespace
{

/// Rows and columns of values without a pattern.
Matrix some_matrix(int rows, int columns)
{
  Matrix a(rows, columns);
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i)
      a(i, j) = std::sin(1.3 * i * i + 2.7 * i * j + j + 0.1 * rows);
  return a;
}

/// Sum over k of a(i, k) b(k, j), without a part of a library.
double element(const Matrix& a, const Matrix& b, int i, int j, int inner)
{
  double sum = 0.0;
  for (int k = 0; k < inner; ++k)
    sum += a(i, k) * b(k, j);
  return sum;
}

Matrix transposed(const Matrix& a)
{
  Matrix result(a.columns(), a.rows());
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j < a.columns(); ++j)
      result(j, i) = a(i, j);
  return result;
}

} // namespace

// Small products and large ones take different ways in the library.
class MatrixProduct : public testing::TestWithParam<int>
{
};
INSTANTIATE_TEST_SUITE_P(Sizes, MatrixProduct, testing::Values(1, 3, 40));

TEST_P(MatrixProduct, OfTheFirstRowsIsTheSumOverTheInnerIndex)
{
  const int n = GetParam();
  const Matrix a = some_matrix(n + 2, n), b = some_matrix(n + 3, 7);
  std::vector<double> product(static_cast<std::size_t>((n + 2) * 7), 99.0);
  assign_product(a, {b, n, 7}, product.data());
  for (int j = 0; j < 7; ++j)
    for (int i = 0; i < n + 2; ++i)
      EXPECT_NEAR(product[static_cast<std::size_t>(i + (n + 2) * j)], element(a, b, i, j, n), 1e-13);
}

TEST_P(MatrixProduct, OfTransposedMatrices)
{
  const int n = GetParam();
  const Matrix a = some_matrix(n, 4), b = some_matrix(n, 5);
  Matrix product(6, 5);
  assign_transposed_product(a, b, product);
  for (int j = 0; j < 5; ++j)
  {
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(product(i, j), element(transposed(a), b, i, j, n), 1e-13);
    EXPECT_EQ(product(5, j), 0.0); // rows beyond the product are left alone
  }
  const Matrix c = some_matrix(5, n), d = some_matrix(4, n);
  std::vector<double> difference(20, 2.0);
  subtract_product(c, d, difference.data());
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 5; ++i)
      EXPECT_NEAR(difference[static_cast<std::size_t>(i + 5 * j)], 2.0 - element(c, transposed(d), i, j, n), 1e-13);
}

TEST(LeastSquares, ResidualIsAtRightAnglesToAllColumns)
{
  const Matrix a = some_matrix(9, 4), b = some_matrix(9, 3), x = least_squares(a, b);
  ASSERT_EQ(x.rows(), 4);
  ASSERT_EQ(x.columns(), 3);
  for (int j = 0; j < 3; ++j)
    for (int column = 0; column < 4; ++column)
    {
      double product = 0.0;
      for (int i = 0; i < 9; ++i)
        product += a(i, column) * (b(i, j) - element(a, x, i, j, 4));
      EXPECT_NEAR(product, 0.0, 1e-13);
    }
}

TEST(LinearSystem, IsSolvedAndASingularOneIsNotFinite)
{
  const Matrix a = some_matrix(5, 5);
  const std::vector<double> b{1.0, -2.0, 3.0, 0.5, 0.0}, x = solve(a, b);
  for (int i = 0; i < 5; ++i)
  {
    double sum = 0.0;
    for (int j = 0; j < 5; ++j)
      sum += a(i, j) * x[static_cast<std::size_t>(j)];
    EXPECT_NEAR(sum, b[static_cast<std::size_t>(i)], 1e-12);
  }
  const std::vector<double> none = solve(Matrix(2, 2), std::vector<double>{1.0, 1.0});
  EXPECT_FALSE(std::isfinite(none[0]));
}

// With rows that have to be exchanged, and for several right sides.
TEST(LinearSystem, IsSolvedByFactors)
{
  constexpr int n = 70;
  Matrix a = some_matrix(n, n);
  a(0, 0) = 0.0;
  const Factorised factors(a);
  for (const double first : {1.0, -3.0})
  {
    std::vector<double> x(n, 0.5);
    x[0] = first;
    const std::vector<double> b = x;
    factors.solve(x);
    for (int i = 0; i < n; ++i)
    {
      double sum = 0.0, size = 0.0;
      for (int j = 0; j < n; ++j)
      {
        sum += a(i, j) * x[static_cast<std::size_t>(j)];
        size += std::abs(a(i, j) * x[static_cast<std::size_t>(j)]);
      }
      EXPECT_NEAR(sum, b[static_cast<std::size_t>(i)], 1e-12 * size);
    }
  }
}

// The second difference with free ends has the eigenvalues 4 sin^2(pi l / 2n) and cosines as vectors.
TEST(Eigensystem, OfTheSecondDifferenceAreCosines)
{
  constexpr int n = 12;
  std::vector<double> diagonal(n, 2.0);
  diagonal.front() = diagonal.back() = 1.0;
  const Eigensystem modes = eigensystem_of_tridiagonal(diagonal, std::vector<double>(n - 1, -1.0));
  for (int l = 1; l < n; ++l)
  {
    const double half = std::numbers::pi * l / (2.0 * n);
    EXPECT_NEAR(modes.values[static_cast<std::size_t>(l)], 4.0 * std::pow(std::sin(half), 2), 1e-13);
    const double scale = modes.vectors(0, l) / std::cos(half);
    EXPECT_NEAR(std::abs(scale), std::sqrt(2.0 / n), 1e-13);
    for (int i = 0; i < n; ++i)
      EXPECT_NEAR(modes.vectors(i, l), scale * std::cos(half * (2 * i + 1)), 1e-13);
  }
}

} // namespace brinell
