// SPDX-License-Identifier: BSD-3-Clause
#include "surface_means.hpp"

#include <algorithm>

namespace brinell::elastoplastic
{

namespace
{

/// Sum over [first, last) of values whose cumulative sums are `sums`; outside [0, count) values are zero, or repeat if periodic.
double sum_of(const std::vector<double>& sums, int count, int first, int last, bool is_periodic)
{
  const auto up_to = [&](int end)
  {
    if (!is_periodic)
      return sums[static_cast<std::size_t>(std::clamp(end, 0, count))];
    const int turns = end >= 0 ? end / count : -((count - 1 - end) / count);
    return turns * sums[static_cast<std::size_t>(count)] + sums[static_cast<std::size_t>(end - turns * count)];
  };
  return up_to(last) - up_to(first);
}

} // namespace

SurfaceMeans::SurfaceMeans(const VolumeGrid& grid) : surface_(grid.surface)
{
  for (std::vector<double>& field : fields_)
    field.assign(surface_.size() * static_cast<std::size_t>(std::min(layers, grid.nz)), 0.0);
}

void SurfaceMeans::set(std::size_t cell, const Deviator& value)
{
  fields_[0][cell] = value[Deviator::xz];
  fields_[1][cell] = value[Deviator::yz];
}

void SurfaceMeans::average_along(std::size_t first, std::size_t stride, int count, int half, bool is_periodic)
{
  const int cells = 2 * half + 1;
  sums_.resize(static_cast<std::size_t>(count) + 1);
  for (std::vector<double>& field : fields_)
  {
    sums_[0] = 0.0;
    for (int i = 0; i < count; ++i)
      sums_[static_cast<std::size_t>(i) + 1] =
          sums_[static_cast<std::size_t>(i)] + field[first + static_cast<std::size_t>(i) * stride];
    for (int i = 0; i < count; ++i)
      field[first + static_cast<std::size_t>(i) * stride] =
          sum_of(sums_, count, i - half, i + half + 1, is_periodic) / cells;
  }
}

void SurfaceMeans::average()
{
  const auto nx = static_cast<std::size_t>(surface_.nx);
  for (std::size_t row = 0; row < fields_[0].size(); row += nx)
    average_along(row, 1, surface_.nx, half_x, surface_.is_periodic_x());
  for (std::size_t layer = 0; layer < fields_[0].size(); layer += surface_.size())
    for (std::size_t i = 0; i < nx; ++i)
      average_along(layer + i, nx, surface_.ny, half_y, surface_.is_periodic_y());
}

double SurfaceMeans::contracted(std::size_t cell, const Deviator& with) const
{
  return 2.0 * (with[Deviator::xz] * fields_[0][cell] + with[Deviator::yz] * fields_[1][cell]);
}

} // namespace brinell::elastoplastic
