// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/constitutive/depth_profile.hpp"

#include "between_points.hpp"
#include "brinell/foundation/error.hpp"

#include <cmath>
#include <fmt/format.h>

namespace brinell::constitutive
{

DepthProfile::DepthProfile(std::vector<double> depth, std::vector<double> value)
    : depth_(std::move(depth)), value_(std::move(value))
{
  if (depth_.empty() || depth_.size() != value_.size())
    throw InputError(fmt::format("a profile needs one value for each depth, at least one; it has {} depths and {} "
                                 "values",
                                 depth_.size(), value_.size()));
  for (std::size_t i = 0; i < depth_.size(); ++i)
  {
    if (!std::isfinite(depth_[i]) || !std::isfinite(value_[i]) || depth_[i] < 0.0)
      throw InputError(fmt::format("point {} of a profile is not a finite value at a depth >= 0", i + 1));
    if (i > 0 && !(depth_[i] > depth_[i - 1]))
      throw InputError(
          fmt::format("the depths of a profile must ascend; {:g} m follows {:g} m", depth_[i], depth_[i - 1]));
  }
}

double DepthProfile::at(double z, double without) const
{
  if (depth_.empty())
    return without;
  return between_points(depth_, value_, z);
}

} // namespace brinell::constitutive
