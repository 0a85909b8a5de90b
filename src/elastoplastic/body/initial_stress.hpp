// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/share.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Initial stress xx = yy of a body, one value per layer.
class InitialStress
{
public:
  /// @param grid  the own layers of `share`
  InitialStress(const VolumeGrid& grid, const constitutive::Material& material, const Share& share)
      : grid_(grid), is_zero_(material.initial_stress.empty())
  {
    for (int layer = 0; layer < grid_.nz; ++layer)
      values_.push_back(material.initial_stress.at((share.layer(layer) + 0.5) * grid_.dz, 0.0));
  }

  [[nodiscard]] double at(std::size_t layer) const { return values_[layer]; } ///< [Pa]
  /// Adds its deviator in the layers [0, layers) and in the rows [0, rows) of each layer.
  void add_to(std::span<double> deviator, int layers, int rows) const
  {
    if (is_zero_)
      return;
    for (int layer = 0; layer < layers; ++layer)
      for (const std::size_t component : {Deviator::xx, Deviator::yy})
      {
        const std::size_t first = component * grid_.size() + grid_.index(0, 0, layer);
        for (std::size_t cell = first; cell < first + grid_.surface.index(0, rows); ++cell)
          deviator[cell] += values_[static_cast<std::size_t>(layer)] / 3.0;
      }
  }

private:
  VolumeGrid grid_;
  bool is_zero_;
  std::vector<double> values_;
};

} // namespace brinell::elastoplastic
