// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/elastic.hpp"

#include <cstddef>
#include <vector>

namespace brinell
{

/// A layer of a coating: an isotropic material of constant thickness, bonded to the body beneath and above.
struct ElasticLayer
{
  double thickness = 0.0; ///< [m], > 0
  Elastic elastic;
  bool operator==(const ElasticLayer&) const = default;
};

/// Bonded layers on a half space; without layers, the half space alone.
struct ElasticStack
{
  std::vector<ElasticLayer> layers; ///< from the surface down
  Elastic substrate;                ///< below the layers; may be rigid

  [[nodiscard]] bool is_homogeneous() const { return layers.empty(); }
  /// Constants at the surface.
  [[nodiscard]] const Elastic& top() const { return layers.empty() ? substrate : layers.front().elastic; }
  /// Depth of the substrate [m].
  [[nodiscard]] double thickness() const;
  /// Number of the layer at a depth; the number of layers in the substrate. An interface belongs to the layer beneath.
  [[nodiscard]] std::size_t layer_at(double depth) const;
  /// Constants of a layer; those of the substrate for the number of layers.
  [[nodiscard]] const Elastic& of_layer(std::size_t layer) const
  {
    return layer < layers.size() ? layers[layer].elastic : substrate;
  }
  [[nodiscard]] const Elastic& at(double depth) const { return of_layer(layer_at(depth)); }
  /// The body with as few layers as possible: neighbours of equal constants are one.
  [[nodiscard]] ElasticStack merged() const;
  /// The body without what lies above a depth [m], >= 0, as wear takes it off.
  [[nodiscard]] ElasticStack without_top(double depth) const;
  bool operator==(const ElasticStack&) const = default;
};

} // namespace brinell
