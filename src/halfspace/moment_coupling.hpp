// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace brinell::halfspace
{

/// A moment of a field: with which others it couples.
struct Moment
{
  int index;  ///< in the caller's arrays
  int parity; ///< moments of unlike parity do not couple
  int degree; ///< of its monomial
};

/// Matrix from moments of the strain to moments of the stress. A kernel that is a polynomial of some degree in the
/// distance couples two moments only if the sum of their degrees is no larger. Stored are the rows up to there.
class MomentCoupling
{
public:
  /// @param stress, strain  all moments; their indices are 0, 1, ... in any order
  MomentCoupling(const std::vector<Moment>& stress, std::vector<Moment> strain, int degree);

  /// Adds to one entry, which must be one that may couple.
  void add(int stress, int strain, double value);
  /// Multiplies moments of strain in the order of `columns()` into those of stress in the order of `rows()`.
  /// @param parities  the moments of this parity and of larger ones are zero
  /// @param rows      moments of stress that are wanted, the first ones
  void multiply(const double* strain, double* stress, int parities, std::size_t rows) const;

  [[nodiscard]] const std::vector<int>& rows() const { return rows_; }       ///< indices of moments of stress
  [[nodiscard]] const std::vector<int>& columns() const { return columns_; } ///< of strain

private:
  struct Row
  {
    std::size_t first_column, columns; ///< of strain, in the order of `columns()`
    std::size_t value;                 ///< of the first one
    int parity;
  };
  std::vector<int> rows_, columns_;
  std::vector<std::size_t> row_of_, column_of_; ///< by index of the moment
  std::vector<Row> row_;
  std::vector<double> value_;
};

} // namespace brinell::halfspace
