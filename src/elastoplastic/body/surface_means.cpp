// SPDX-License-Identifier: BSD-3-Clause
#include "surface_means.hpp"

#include <algorithm>

namespace brinell::elastoplastic
{

namespace
{

/// The sum of all values before an index is `turns` times the sum of one period plus the sum of the first `count` values.
struct Before
{
  int turns;
  std::size_t count;
};

/// @param end    index; may lie outside [0, count), where values are zero, or repeat if periodic
/// @param count  number of values
Before before(int end, int count, bool is_periodic)
{
  if (!is_periodic)
    return {0, static_cast<std::size_t>(std::clamp(end, 0, count))};
  const int turns = end >= 0 ? end / count : -((count - 1 - end) / count);
  return {turns, static_cast<std::size_t>(end - turns * count)};
}

} // namespace

SurfaceMeans::SurfaceMeans(const VolumeGrid& grid) : surface_(grid.surface)
{
  const auto rows = static_cast<std::size_t>(surface_.ny) * static_cast<std::size_t>(std::min(layers, grid.nz));
  for (std::vector<double>& field : fields_)
    field.assign(static_cast<std::size_t>(surface_.nx) * rows, 0.0);
  has_values_.assign(rows, 0);
}

void SurfaceMeans::set(std::size_t cell, const Deviator& value)
{
  fields_[0][cell] = value[Deviator::xz];
  fields_[1][cell] = value[Deviator::yz];
  has_values_[cell / static_cast<std::size_t>(surface_.nx)] = 1;
}

void SurfaceMeans::average_along_x(double* row)
{
  const int count = surface_.nx;
  sums_.resize(static_cast<std::size_t>(count) + 1);
  sums_[0] = 0.0;
  for (int i = 0; i < count; ++i)
    sums_[static_cast<std::size_t>(i) + 1] = sums_[static_cast<std::size_t>(i)] + row[i];
  const auto sum_before = [&](int end)
  {
    const Before values = before(end, count, surface_.is_periodic_x());
    return values.turns * sums_[static_cast<std::size_t>(count)] + sums_[values.count];
  };
  for (int i = 0; i < count; ++i)
    row[i] = (sum_before(i + half_x + 1) - sum_before(i - half_x)) / (2 * half_x + 1);
}

/// Averages all columns of a layer at once, row by row.
void SurfaceMeans::average_along_y(double* layer)
{
  const auto nx = static_cast<std::size_t>(surface_.nx);
  const int count = surface_.ny;
  sums_.assign(nx * (static_cast<std::size_t>(count) + 1), 0.0);
  const auto sums_before = [&](std::size_t row) { return sums_.data() + row * nx; };
  for (std::size_t j = 0; j < static_cast<std::size_t>(count); ++j)
    for (std::size_t i = 0; i < nx; ++i)
      sums_before(j + 1)[i] = sums_before(j)[i] + layer[j * nx + i];
  const double* const period = sums_before(static_cast<std::size_t>(count));
  for (int j = 0; j < count; ++j)
  {
    const Before last = before(j + half_y + 1, count, surface_.is_periodic_y());
    const Before first = before(j - half_y, count, surface_.is_periodic_y());
    double* const row = layer + static_cast<std::size_t>(j) * nx;
    for (std::size_t i = 0; i < nx; ++i)
      row[i] = (last.turns * period[i] + sums_before(last.count)[i] -
                (first.turns * period[i] + sums_before(first.count)[i])) /
               (2 * half_y + 1);
  }
}

void SurfaceMeans::average()
{
  const auto nx = static_cast<std::size_t>(surface_.nx), ny = static_cast<std::size_t>(surface_.ny);
  for (std::size_t first = 0; first < has_values_.size(); first += ny) // layer by layer
  {
    const auto in_layer = has_values_.begin() + static_cast<std::ptrdiff_t>(first);
    if (std::find(in_layer, in_layer + surface_.ny, 1) == in_layer + surface_.ny)
      continue;
    for (std::vector<double>& field : fields_)
    {
      for (std::size_t row = first; row < first + ny; ++row)
        if (has_values_[row] != 0)
          average_along_x(field.data() + row * nx);
      average_along_y(field.data() + first * nx);
    }
  }
}

double SurfaceMeans::contracted(std::size_t cell, const Deviator& with) const
{
  return 2.0 * (with[Deviator::xz] * fields_[0][cell] + with[Deviator::yz] * fields_[1][cell]);
}

} // namespace brinell::elastoplastic
