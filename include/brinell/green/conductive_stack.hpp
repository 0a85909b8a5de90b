// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/elastic_stack.hpp"
#include "brinell/green/thermal_stack.hpp"

#include <vector>

namespace brinell
{

/// A layer of a constant thickness that conducts current, or with 1/conductivity in place of the resistivity, heat.
struct ConductiveLayer
{
  double thickness = 0.0;   ///< [m], > 0
  double resistivity = 0.0; ///< [ohm m], > 0
  bool operator==(const ConductiveLayer&) const = default;
};

/// Layers on a conducting half space; without layers, the half space alone.
struct ConductiveStack
{
  std::vector<ConductiveLayer> layers; ///< from the surface down
  double substrate = 0.0;              ///< resistivity beneath the layers [ohm m], > 0

  /// Resistivity at the surface [ohm m].
  [[nodiscard]] double top() const { return layers.empty() ? substrate : layers.front().resistivity; }
  bool operator==(const ConductiveStack&) const = default;
};

/// The stack with 1/conductivity in place of the resistivity.
[[nodiscard]] inline ConductiveStack resisting_heat(const ThermalStack& stack)
{
  ConductiveStack result{{}, 1.0 / stack.substrate.conductivity};
  result.layers.reserve(stack.layers.size());
  for (const ThermalCoat& layer : stack.layers)
    result.layers.push_back({layer.thickness, 1.0 / layer.thermal.conductivity});
  return result;
}

/// The elastic body whose displacement across the plane of a wave, under a shear across it, is the potential of a current in the
/// stack: the shear modulus is 1/resistivity, Poisson's ratio is 0 (docs/theory/electrical.md, layers).
[[nodiscard]] inline ElasticStack in_shear(const ConductiveStack& stack)
{
  const auto elastic = [](double resistivity) { return Elastic{2.0 / resistivity, 0.0}; };
  ElasticStack result{{}, elastic(stack.substrate)};
  result.layers.reserve(stack.layers.size());
  for (const ConductiveLayer& layer : stack.layers)
    result.layers.push_back({layer.thickness, elastic(layer.resistivity)});
  return result;
}

} // namespace brinell
