// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

namespace brinell::constitutive
{

/// Value at x of a function that is linear between points and constant before the first and after the last of them.
/// @param place  places of the points, ascending, at least one
/// @param value  as many values
inline double between_points(const std::vector<double>& place, const std::vector<double>& value, double x)
{
  const auto after = std::upper_bound(place.begin(), place.end(), x);
  if (after == place.begin())
    return value.front();
  if (after == place.end())
    return value.back();
  const auto i = static_cast<std::size_t>(after - place.begin());
  const double t = (x - place[i - 1]) / (place[i] - place[i - 1]);
  return (1.0 - t) * value[i - 1] + t * value[i];
}

} // namespace brinell::constitutive
