// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/anderson.hpp"
#include "contact_parts.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace brinell::elastoplastic
{

/// The acceleration of bodies on devices: these keep the history of their unknowns and sum the products, the weights are found here. A body
/// beside them that stays elastic has no unknowns.
class AccelerationOnDevices
{
public:
  explicit AccelerationOnDevices(int depth)
      : weights_(static_cast<std::size_t>(std::max(depth, 0))), moved_({0, weights_.depth()})
  {
  }

  void deepen(int depth, double damping)
  {
    const AndersonWeights::Moved moved = weights_.deepen(depth, damping);
    if (!moved_ || moved.depth != moved_->depth)
      moved_ = moved;
  }
  /// Acceleration::advance
  void advance(std::vector<Side>& sides, bool changes_map, bool is_near)
  {
    if (changes_map)
      weights_.change_map();
    const std::optional<AndersonWeights::Moved> moved = std::exchange(moved_, std::nullopt);
    const AndersonWeights::Entry entry = weights_.next();
    std::vector<AndersonWeights::Products> sums(entry.known);
    for_bodies(sides,
               [&](Body& body)
               {
                 if (moved)
                   body.on_device().deepen(*moved);
                 if (weights_.depth() > 0)
                   add(body.on_device().record(entry), sums);
               });
    if (weights_.depth() > 0)
      weights_.add(entry, sums);
    const std::vector<double> weights = weights_.weights();
    for_bodies(sides, [&](Body& body) { body.combine(weights, is_near && weights_.depth() > 0); });
  }

private:
  template <typename Use>
  static void for_bodies(std::vector<Side>& sides, const Use& use)
  {
    for (Side& side : sides)
      if (side.body.is_on_device())
        use(side.body);
  }
  static void add(const std::vector<AndersonWeights::Products>& of_body, std::vector<AndersonWeights::Products>& sums)
  {
    for (std::size_t d = 0; d < sums.size(); ++d)
    {
      sums[d].newest_flow += of_body[d].newest_flow;
      sums[d].newest_residual += of_body[d].newest_residual;
      sums[d].residual += of_body[d].residual;
    }
  }

  AndersonWeights weights_;
  std::optional<AndersonWeights::Moved> moved_; ///< not yet told to the bodies
};

} // namespace brinell::elastoplastic
