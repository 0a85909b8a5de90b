// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/elastoplastic/body.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <variant>

namespace brinell::test
{

/// The stress, computed anew, is within the yield surface of the law of each layer; layers without a law have no plastic strain.
inline void expect_admissible(const StressField& stress, const elastoplastic::BodyState& state,
                              const constitutive::Material& material, const VolumeGrid& grid)
{
  constexpr double tolerance = 2e-4; // twice that of the increments
  const auto laws = material.laws();
  const ElasticStack stack = material.stack();
  for (std::size_t i = 0; i < grid.size(); ++i)
  {
    const double depth = (static_cast<double>(i / grid.surface.size()) + 0.5) * grid.dz;
    const auto& law = laws[stack.layer_at(depth)];
    if (!law)
      ASSERT_EQ(state.equivalent[i], 0.0);
    else
      ASSERT_LE(von_mises(deviator_at(stress.deviator, i)),
                std::visit([&](const auto& one) { return one.yield_stress_at(state.equivalent[i]); }, *law) *
                    (1.0 + tolerance));
  }
}

} // namespace brinell::test
