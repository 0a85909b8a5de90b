// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/aligned.hpp"

#include <cstddef>

namespace brinell
{

/// Number of values in a vector register of the processor that the code is compiled for.
#if defined(__AVX512F__)
inline constexpr int lane_count = 8;
#elif defined(__AVX__)
inline constexpr int lane_count = 4;
#else
inline constexpr int lane_count = 2;
#endif

/// As many values as a register holds. It is a vector type of the compiler, so that sums stay in a register, which loops over
/// arrays do not achieve. GCC 12 keeps vector types that are wider than a register in memory, which takes several times as long
/// (bench/notebook/2026-11-24-one-evaluation.md).
using Lanes = double __attribute__((vector_size(lane_count * sizeof(double))));

/// `lane_count` complex values, real and imaginary parts apart.
struct ComplexLanes
{
  Lanes re{}, im{};
};

/// Largest size of an array that may stay in the last-level cache.
inline constexpr std::size_t cached_bytes = 32 * 1024 * 1024;

} // namespace brinell
