// SPDX-License-Identifier: BSD-3-Clause
#include "cell_means.hpp"

#include <cstddef>

namespace brinell::halfspace
{

void mean_over_cells(const SurfaceGrid& s, double* values, std::vector<double>& copy)
{
  constexpr double of_neighbour = 1.0 / 24.0;
  const auto along = [&](int count, int lines, std::ptrdiff_t next, std::ptrdiff_t next_line, bool is_periodic)
  {
    copy.assign(values, values + s.size());
    for (int line = 0; line < lines; ++line)
      for (int i = 0; i < count; ++i)
      {
        const std::ptrdiff_t first = line * next_line;
        const int before = i > 0         ? i - 1
                           : is_periodic ? count - 1
                                         : i,
                  after = i + 1 < count ? i + 1
                          : is_periodic ? 0
                                        : i;
        const auto at = [&](int place) { return copy[static_cast<std::size_t>(first + place * next)]; };
        values[first + i * next] += of_neighbour * (at(before) - 2.0 * at(i) + at(after));
      }
  };
  along(s.nx, s.ny, 1, s.nx, s.is_periodic_x());
  along(s.ny, s.nx, s.nx, 1, s.is_periodic_y());
}

} // namespace brinell::halfspace
