// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/aligned.hpp"

#include <cstddef>

namespace brinell
{

/// Values worked on together, one per lane of the processor's vector units (two or four instructions where these are
/// narrower). A vector type of the compiler: sums kept in it stay in registers, which loops over arrays do not achieve.
inline constexpr int lane_count = 8;
using Lanes = double __attribute__((vector_size(lane_count * sizeof(double))));

/// `lane_count` complex values, real and imaginary parts apart.
struct ComplexLanes
{
  Lanes re{}, im{};
};

inline constexpr std::size_t cached_bytes = 32 * 1024 * 1024; ///< of an array that may stay in the last cache

} // namespace brinell
