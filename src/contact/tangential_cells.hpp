// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/tangential_contact.hpp"
#include "foundation/sharing.hpp"
#include "friction_discs.hpp"

#include <cstddef>

/// Loops of `TangentialContact` over many cells, and sums that do not depend on the number of threads.
namespace brinell::contact
{

/// work(cell) for all cells.
template <typename Work>
void for_cells(std::size_t cells, const Work& work)
{
  for_pieces(cells,
             [&](std::size_t first, std::size_t last)
             {
#pragma omp simd
               for (std::size_t i = first; i < last; ++i)
                 work(i);
             });
}

/// Sum of part(cell).
template <typename Part>
auto sum_of_cells(std::size_t cells, const Part& part)
{
  return sum_of_pieces(cells,
                       [&](std::size_t first, std::size_t last)
                       {
                         decltype(part(first)) sum{};
                         for (std::size_t i = first; i < last; ++i)
                           sum += part(i);
                         return sum;
                       });
}

/// Maximum of values, accumulated by +=; NaN if any value is NaN.
struct Largest
{
  double value = 0.0;
  Largest& operator+=(const Largest& other)
  {
    value = larger(value, other.value);
    return *this;
  }
};

[[nodiscard]] inline double square(const Along& a)
{
  return dot(a, a);
}

/// Whether a shear is at its bound.
/// @param threshold  fraction of the bound from which on the shear counts as being at its bound
[[nodiscard]] inline bool is_bound(double square_of_shear, double bound, double threshold = slip_threshold)
{
  return square_of_shear >= threshold * threshold * bound * bound;
}

} // namespace brinell::contact
