// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/plastic_zone.hpp"

namespace brinell::elastoplastic
{

PlasticZone::PlasticZone(const VolumeGrid& grid, std::span<const double> equivalent)
    : nx_(static_cast<std::size_t>(grid.surface.nx)), ny_(static_cast<std::size_t>(grid.surface.ny)),
      rows_(ny_ * static_cast<std::size_t>(grid.nz), Columns{nx_, 0}), largest_(static_cast<std::size_t>(grid.nz), 0.0)
{
  for (std::size_t cell = 0; cell < equivalent.size(); ++cell)
    if (equivalent[cell] != 0.0)
      add(cell, equivalent[cell]);
}

void PlasticZone::add(std::size_t cell, double equivalent)
{
  const std::size_t row = cell / nx_, column = cell % nx_;
  rows_[row] = {std::min(rows_[row].first, column), std::max(rows_[row].end, column + 1)};
  double& largest = largest_[row / ny_];
  largest = std::max(largest, equivalent);
}

double PlasticZone::largest() const
{
  return largest_.empty() ? 0.0 : *std::max_element(largest_.begin(), largest_.end());
}

} // namespace brinell::elastoplastic
