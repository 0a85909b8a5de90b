// SPDX-License-Identifier: BSD-3-Clause
#include "halfspace/moment_coupling.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <tuple>

namespace brinell::halfspace
{

namespace
{

constexpr std::size_t shared_values = 32768; ///< from so many on, threads do not mostly wait for each other
constexpr int rows_of_share = 16;            ///< that a thread does before the next one: they differ in length

} // namespace

MomentCoupling::MomentCoupling(const std::vector<Moment>& stress, std::vector<Moment> strain, int degree)
    : row_of_(stress.size()), column_of_(strain.size())
{
  std::stable_sort(strain.begin(), strain.end(),
                   [](const Moment& a, const Moment& b)
                   { return std::tie(a.parity, a.degree) < std::tie(b.parity, b.degree); });
  for (const Moment& moment : strain)
  {
    column_of_[static_cast<std::size_t>(moment.index)] = columns_.size();
    columns_.push_back(moment.index);
  }
  std::size_t values = 0;
  for (const Moment& moment : stress)
  {
    const auto begins = [&](const Moment& m) { return m.parity < moment.parity; };
    const auto couples = [&](const Moment& m)
    { return m.parity < moment.parity || (m.parity == moment.parity && m.degree + moment.degree <= degree); };
    const auto first = std::partition_point(strain.begin(), strain.end(), begins);
    const auto last = std::partition_point(strain.begin(), strain.end(), couples);
    row_of_[static_cast<std::size_t>(moment.index)] = rows_.size();
    rows_.push_back(moment.index);
    row_.push_back({static_cast<std::size_t>(first - strain.begin()), static_cast<std::size_t>(last - first), values,
                    moment.parity});
    values += row_.back().columns;
  }
  value_.assign(values, 0.0);
}

void MomentCoupling::add(int stress, int strain, double value)
{
  const Row& row = row_[row_of_[static_cast<std::size_t>(stress)]];
  const std::size_t column = column_of_[static_cast<std::size_t>(strain)];
  if (column < row.first_column || column >= row.first_column + row.columns)
    throw InternalError("MomentCoupling: these moments do not couple");
  value_[row.value + column - row.first_column] += value;
}

void MomentCoupling::multiply(const double* strain, double* stress, int parities, std::size_t rows) const
{
#pragma omp parallel for schedule(static, rows_of_share) if (value_.size() >= shared_values)
  for (std::size_t i = 0; i < rows; ++i)
  {
    const Row& row = row_[i];
    if (row.parity >= parities)
    {
      stress[i] = 0.0;
      continue;
    }
    const double* value = value_.data() + row.value;
    const double* from = strain + row.first_column;
    double sum = 0.0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t column = 0; column < row.columns; ++column)
      sum += value[column] * from[column];
    stress[i] = sum;
  }
}

} // namespace brinell::halfspace
