// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "larger.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <numeric>
#include <omp.h>
#include <span>
#include <vector>

namespace brinell
{

/// Whether work on a surface of `cells` cells is worth sharing among threads: on smaller ones, they would mostly wait for each
/// other.
[[nodiscard]] inline bool is_shared(std::size_t cells)
{
  return cells >= 16384;
}

/// Calls work(thread) in a team of threads, which share its loops (`omp for`). Each barrier of a team costs a system call, even
/// in a team of one, so for a single thread no team is created.
template <typename Work>
void in_threads(int threads, const Work& work)
{
  if (threads == 1 && !omp_in_parallel())
    return work(0);
#pragma omp parallel num_threads(threads)
  work(omp_get_thread_num());
}

/// Calls work(0) and work(1), one thread each, which neither wait for each other nor share data; what `work` itself shares among
/// threads is then done by one. If both throw, the exception of work(0) is passed on.
template <typename Work>
void side_by_side(const Work& work)
{
  std::array<std::exception_ptr, 2> failures;
#pragma omp parallel for num_threads(2) schedule(static, 1)
  for (std::size_t i = 0; i < failures.size(); ++i)
    try
    {
      work(i);
    }
    catch (...)
    {
      failures[i] = std::current_exception();
    }
  for (const std::exception_ptr& failure : failures)
    if (failure)
      std::rethrow_exception(failure);
}

/// Cells of one piece of work. The size does not depend on the number of threads, and so neither does any sum over pieces.
inline constexpr std::size_t piece_size = 2048;

/// Calls work(first, last) for every piece of the cells [0, cells), by several threads if there are many cells.
template <typename Work>
void for_pieces(std::size_t cells, const Work& work)
{
  const std::size_t pieces = (cells + piece_size - 1) / piece_size;
  const auto piece = [&](std::size_t i) { work(i * piece_size, std::min(cells, (i + 1) * piece_size)); };
  if (!is_shared(cells))
    for (std::size_t i = 0; i < pieces; ++i)
      piece(i);
  else
  {
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < pieces; ++i)
      piece(i);
  }
}

/// Sum of part(first, last) over the pieces, added with += in their order.
template <typename Part>
[[nodiscard]] auto sum_of_pieces(std::size_t cells, const Part& part)
{
  using Sum = decltype(part(std::size_t{}, std::size_t{}));
  Sum total{};
  if (!is_shared(cells))
  {
    for_pieces(cells, [&](std::size_t first, std::size_t last) { total += part(first, last); });
    return total;
  }
  std::vector<Sum> parts((cells + piece_size - 1) / piece_size);
  for_pieces(cells, [&](std::size_t first, std::size_t last) { parts[first / piece_size] = part(first, last); });
  for (const Sum& sum : parts)
    total += sum;
  return total;
}

/// Sum over all cells of a grid. On a mirrored one each independent row counts as often as it occurs.
template <typename Part>
[[nodiscard]] auto sum_over(const SurfaceGrid& grid, const Part& part)
{
  const std::size_t cells = grid.independent_cells();
  if (!grid.is_mirrored_y)
    return sum_of_pieces(cells, part);
  const std::size_t beside = grid.index(0, grid.ny / 2); // cells on one side of the plane
  auto total = sum_of_pieces(beside, part);
  total += decltype(total)(total);
  if (beside < cells)
    total += part(beside, cells);
  return total;
}

/// Sums over the cells, the same for any number of threads.
[[nodiscard]] inline double sum(std::span<const double> field)
{
  return sum_of_pieces(field.size(), [&](std::size_t first, std::size_t last)
                       { return std::accumulate(field.begin() + first, field.begin() + last, 0.0); });
}
[[nodiscard]] inline double dot(std::span<const double> a, std::span<const double> b)
{
  return sum_of_pieces(a.size(), [&](std::size_t first, std::size_t last)
                       { return std::inner_product(a.begin() + first, a.begin() + last, b.begin() + first, 0.0); });
}
/// Sums over all cells of a grid.
[[nodiscard]] inline double sum(const SurfaceGrid& grid, std::span<const double> field)
{
  return sum_over(grid, [&](std::size_t first, std::size_t last)
                  { return std::accumulate(field.begin() + first, field.begin() + last, 0.0); });
}
[[nodiscard]] inline double dot(const SurfaceGrid& grid, std::span<const double> a, std::span<const double> b)
{
  return sum_over(grid, [&](std::size_t first, std::size_t last)
                  { return std::inner_product(a.begin() + first, a.begin() + last, b.begin() + first, 0.0); });
}

} // namespace brinell
