// SPDX-License-Identifier: BSD-3-Clause
#include "wave_coupling.hpp"

#include "foundation/lane_functions.hpp"

namespace brinell::halfspace
{

using images::strains;
using images::stresses;

WaveCoupling::WaveCoupling(int waves, int depths, int degree, const std::array<int, stresses>& odd)
    : parts_((waves + lane_count - 1) / lane_count), depths_(depths), degree_(degree), odd_(odd),
      value_(place(stresses, 0, 0, 0) * lane_count)
{
}

void WaveCoupling::set(int wave, int c, int e, int b, double factor, const Matrix& value)
{
  double* to = value_.data() + place(c, e, b, wave / lane_count) * lane_count + wave % lane_count;
  for (int i = 0; i < depths_; ++i)
    for (int j = 0; j < depths_; ++j, to += lane_count)
      *to = factor * images::factorial(b) * value(i, j);
}

void WaveCoupling::multiply(int part, const ComplexLanes* strain, bool is_mirrored, int components,
                            ComplexLanes* stress) const
{
  const int step = is_mirrored ? 2 : 1;
  const std::ptrdiff_t powers = degree_ + 1;
  for (int c = 0; c < components; ++c)
    for (int e = 0; e < strains; ++e)
      for (int b = parity(c, e); b <= degree_; b += 2)
        for (int p = is_mirrored ? odd_[static_cast<std::size_t>(c)] : 0; p <= b; p += step)
        {
          const double* value = value_.data() + place(c, e, b, part) * lane_count;
          const ComplexLanes* from = strain + (e * powers + b - p) * depths_;
          ComplexLanes* to = stress + (c * powers + p) * depths_;
          for (int i = 0; i < depths_; ++i)
          {
            ComplexLanes sum = to[i];
            for (int j = 0; j < depths_; ++j, value += lane_count)
              sum = sum + load_lanes(value) * from[j];
            to[i] = sum;
          }
        }
}

} // namespace brinell::halfspace
