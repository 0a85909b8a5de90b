// SPDX-License-Identifier: BSD-3-Clause
#include "kernel_places.hpp"

#include "cell_response.hpp"
#include "foundation/fft.hpp"

namespace brinell::halfspace
{

namespace
{

using Shares = KernelPlaces::Shares;

std::vector<Shares> padded_places(int cells, Boundary boundary, int length)
{
  const Offsets offsets(cells, boundary);
  std::vector<Shares> places(static_cast<std::size_t>(length));
  for (int offset = offsets.first(); offset <= offsets.last(); ++offset)
    places[static_cast<std::size_t>((offset + length) % length)][0] = {offset, 1.0};
  return places;
}

std::vector<Shares> periodic_places(int cells, Boundary boundary)
{
  if (boundary == Boundary::periodic)
    return padded_places(cells, boundary, cells);
  std::vector<Shares> places;
  for (int i = 0; i < cells; ++i)
  {
    const double beyond = static_cast<double>(i) / cells;
    places.push_back({{{i, 1.0 - beyond}, {i - cells, beyond}}});
  }
  places.front()[1] = {};
  return places;
}

} // namespace

KernelPlaces KernelPlaces::padded(const SurfaceGrid& grid)
{
  const PaddedLengths lengths = padded_lengths(grid);
  return {padded_places(grid.nx, grid.boundary_x, lengths.x), padded_places(grid.ny, grid.boundary_y, lengths.y)};
}

KernelPlaces KernelPlaces::periodic(const SurfaceGrid& grid)
{
  return {periodic_places(grid.nx, grid.boundary_x), periodic_places(grid.ny, grid.boundary_y)};
}

std::vector<double> spectrum_of(const SurfaceGrid& grid, const KernelPlaces& places,
                                const std::function<double(int, int)>& response)
{
  const PaddedFft fft(grid, static_cast<int>(places.x.size()), static_cast<int>(places.y.size()));
  AlignedVector<double> kernel;
  kernel.reserve(places.x.size() * places.y.size());
  for (const Shares& row : places.y)
    for (const Shares& column : places.x)
    {
      double value = 0.0;
      for (const KernelPlaces::Share& y : row)
        for (const KernelPlaces::Share& x : column)
          if (const double weight = x.weight * y.weight; weight > 0.0)
            value += weight * response(x.offset, y.offset);
      kernel.push_back(value);
    }
  const AlignedVector<Complex> transformed = fft.forward_padded(kernel);
  std::vector<double> spectrum;
  for (int row = 0; row <= fft.py() / 2; ++row)
    for (int i = 0; i < fft.kx(); ++i)
      spectrum.push_back(
          transformed[static_cast<std::size_t>(row) * static_cast<std::size_t>(fft.kx()) + static_cast<std::size_t>(i)]
              .real());
  return spectrum;
}

SurfaceGrid with_fast_lengths(SurfaceGrid grid)
{
  if (!grid.is_periodic_x())
    grid.nx = fast_length(grid.nx);
  if (!grid.is_periodic_y())
    grid.ny = fast_length(grid.ny);
  return grid;
}

} // namespace brinell::halfspace
