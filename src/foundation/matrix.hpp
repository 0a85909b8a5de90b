// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/aligned.hpp"

#include <span>
#include <vector>

/// Dense linear algebra. Eigen does the work in matrix.cpp alone: its templates take longer to compile than all that uses them.
namespace brinell
{

/// Dense matrix, column by column.
class Matrix
{
public:
  Matrix() = default;
  /// All zero.
  Matrix(int rows, int columns)
      : rows_(rows), values_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns))
  {
  }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int columns() const { return rows_ == 0 ? 0 : static_cast<int>(values_.size()) / rows_; }
  [[nodiscard]] double& operator()(int row, int column) { return values_[place(row, column)]; }
  [[nodiscard]] double operator()(int row, int column) const { return values_[place(row, column)]; }
  [[nodiscard]] double* column(int number) { return values_.data() + place(0, number); }
  [[nodiscard]] const double* column(int number) const { return values_.data() + place(0, number); }

private:
  [[nodiscard]] std::size_t place(int row, int column) const
  {
    return static_cast<std::size_t>(row) + static_cast<std::size_t>(rows_) * static_cast<std::size_t>(column);
  }

  int rows_ = 0;
  AlignedVector<double>
      values_; ///< where a sum begins must not depend on the place in memory, and nor must its last digit
};

/// Values that belong to somebody else, taken as the matrix of these rows and columns, column by column.
struct MatrixView
{
  const double* values;
  int rows, columns;
  int stride; ///< from one column to the next

  MatrixView(const double* from, int row_count, int column_count)
      : values(from), rows(row_count), columns(column_count), stride(row_count)
  {
  }
  /// The first rows and columns of a matrix.
  MatrixView(const Matrix& matrix, int row_count, int column_count)
      : values(matrix.column(0)), rows(row_count), columns(column_count), stride(matrix.rows())
  {
  }
  MatrixView(const Matrix& matrix) : MatrixView(matrix, matrix.rows(), matrix.columns()) {}
};

/// to = a b, column by column.
void assign_product(const MatrixView& a, const MatrixView& b, double* to);
/// to = a^T b: the first rows of a matrix that may have more.
void assign_transposed_product(const MatrixView& a, const MatrixView& b, Matrix& to);
/// from -= a b^T, column by column.
void subtract_product(const MatrixView& a, const MatrixView& b, double* from);

[[nodiscard]] double scalar_product(std::span<const double> a, std::span<const double> b);

/// x of the smallest |a x - b|, for each column of b.
[[nodiscard]] Matrix least_squares(const Matrix& a, const Matrix& b);

/// x with a x = b, a square; values that are not finite if there is none.
[[nodiscard]] std::vector<double> solve(const Matrix& a, std::span<const double> b);

struct Eigensystem
{
  std::vector<double> values; ///< rising
  Matrix vectors;             ///< a column of length 1 for each
};
/// Of a symmetric matrix that is zero but on its diagonal and beside it.
[[nodiscard]] Eigensystem eigensystem_of_tridiagonal(std::span<const double> diagonal, std::span<const double> beside);

/// Factors of a square matrix for many right sides, P A = L U with partial pivoting; the same for any number of threads.
class Factorised
{
public:
  explicit Factorised(Matrix a);
  /// Replaces b by the solution x of A x = b.
  void solve(std::span<double> b) const;

private:
  Matrix factors_;
  std::vector<int> place_; ///< of each row among the factors
};

} // namespace brinell
