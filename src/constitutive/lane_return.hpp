// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "constitutive/linear_return.hpp"
#include "foundation/lanes.hpp"

#include <cstddef>

/// Return mapping of several points at once, one per lane, for laws for which it has a closed-form solution.
namespace brinell::constitutive
{

/// Arguments and results of `path_return`, for one point per lane.
struct LanePoints : PointsOf<Lanes>
{
  void set(std::size_t lane, const Deviator& before, const Deviator& q, double yield_stress, double slope);
  [[nodiscard]] PlasticIncrement increment(std::size_t lane) const;
};

inline void LanePoints::set(std::size_t lane, const Deviator& before, const Deviator& q, double yield_stress,
                            double slope)
{
  for (std::size_t c = 0; c < Deviator::size; ++c)
  {
    start[c][lane] = before.v[c];
    trial[c][lane] = q.v[c];
  }
  yield[lane] = yield_stress;
  modulus[lane] = slope;
}

inline PlasticIncrement LanePoints::increment(std::size_t lane) const
{
  PlasticIncrement result;
  for (std::size_t c = 0; c < Deviator::size; ++c)
    result.strain.v[c] = strain[c][lane];
  result.equivalent = equivalent[lane];
  result.dissipation = dissipation[lane];
  return result;
}

} // namespace brinell::constitutive
