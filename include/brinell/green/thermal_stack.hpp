// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/thermal.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace brinell
{

/// A layer of a coating that conducts heat and expands.
struct ThermalCoat
{
  double thickness = 0.0; ///< [m], > 0
  Thermal thermal;
  bool operator==(const ThermalCoat&) const = default;
};

/// Layers on a half space that conduct heat, in perfect contact with each other; without layers, the half space alone.
struct ThermalStack
{
  std::vector<ThermalCoat> layers; ///< from the surface down
  Thermal substrate;               ///< below the layers

  [[nodiscard]] bool is_homogeneous() const { return layers.empty(); }
  /// Constants of a layer; those of the substrate for the number of layers.
  [[nodiscard]] const Thermal& of_layer(std::size_t layer) const
  {
    return layer < layers.size() ? layers[layer].thermal : substrate;
  }
  [[nodiscard]] const Thermal& top() const { return of_layer(0); }
  /// Of the layers and the substrate, the material in which heat spreads most slowly, and the fastest one.
  [[nodiscard]] const Thermal& slowest() const { return extreme(-1.0); }
  [[nodiscard]] const Thermal& fastest() const { return extreme(1.0); }
  /// Depth at which the conduction of the first layer ends: layers beneath that conduct alike belong to it. Infinite if all do.
  [[nodiscard]] double thickness_of_first() const
  {
    double thickness = 0.0;
    for (std::size_t n = 0; n < layers.size(); ++n)
    {
      if (of_layer(n).conductivity != top().conductivity || of_layer(n).diffusivity() != top().diffusivity())
        return thickness;
      thickness += layers[n].thickness;
    }
    const bool is_uniform =
        substrate.conductivity == top().conductivity && substrate.diffusivity() == top().diffusivity();
    return is_uniform ? std::numeric_limits<double>::infinity() : thickness;
  }
  bool operator==(const ThermalStack&) const = default;

private:
  [[nodiscard]] const Thermal& extreme(double sign) const
  {
    const Thermal* found = &substrate;
    for (const ThermalCoat& layer : layers)
      if (sign * layer.thermal.diffusivity() > sign * found->diffusivity())
        found = &layer.thermal;
    return *found;
  }
};

} // namespace brinell
