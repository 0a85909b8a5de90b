// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace brinell
{

/// Gauss-Legendre rule of eight points on [-1, 1], the positive half.
inline constexpr std::array<double, 4> gauss_point{0.18343464249564980494, 0.52553240991632898582,
                                                   0.79666647741362673959, 0.96028985649753623168};
inline constexpr std::array<double, 4> gauss_weight{0.36268378337836198297, 0.31370664587788728734,
                                                    0.22238103445337447054, 0.10122853629037625915};

} // namespace brinell
