// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/sym_tensor.hpp"

#include <array>
#include <cmath>

/// Symmetric tensors in the order of SymTensor.
namespace brinell::test
{

inline constexpr std::array component_names{"xx", "yy", "zz", "yz", "xz", "xy"};

inline SymTensor unit_tensor(std::size_t component)
{
  SymTensor t{};
  t[component] = 1.0;
  return t;
}

/// sum += factor * part.
inline void add(const SymTensor& part, double factor, SymTensor& sum)
{
  for (std::size_t c = 0; c < 6; ++c)
    sum[c] += factor * part[c];
}

/// Magnitude of the divergence of stress(x, y, z) by central differences over h to either side: of second order in h where it
/// is zero.
template <class Stress>
[[nodiscard]] double divergence(double x, double y, double z, double h, Stress stress)
{
  const SymTensor east = stress(x + h, y, z), west = stress(x - h, y, z);
  const SymTensor north = stress(x, y + h, z), south = stress(x, y - h, z);
  const SymTensor down = stress(x, y, z + h), up = stress(x, y, z - h);
  constexpr std::array<std::array<std::size_t, 3>, 3> rows{{{0, 5, 4}, {5, 1, 3}, {4, 3, 2}}};
  double squares = 0.0;
  for (const auto& [a, b, c] : rows)
    squares += std::pow((east[a] - west[a] + north[b] - south[b] + down[c] - up[c]) / (2.0 * h), 2);
  return std::sqrt(squares);
}

} // namespace brinell::test
