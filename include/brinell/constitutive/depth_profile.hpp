// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace brinell::constitutive
{

/// A quantity as a function of depth: linear between points, constant before the first and after the last one.
class DepthProfile
{
public:
  /// No points: the quantity does not depend on depth.
  DepthProfile() = default;
  /// @param depth  ascending, >= 0 [m]
  /// @param value  one per depth
  /// @throws InputError
  DepthProfile(std::vector<double> depth, std::vector<double> value);

  [[nodiscard]] bool empty() const { return depth_.empty(); }
  [[nodiscard]] const std::vector<double>& depth() const { return depth_; }
  /// @param without  value of a profile without points
  [[nodiscard]] double at(double z, double without) const;
  bool operator==(const DepthProfile&) const = default;

private:
  std::vector<double> depth_, value_;
};

} // namespace brinell::constitutive
