// SPDX-License-Identifier: BSD-3-Clause
#include "banded_fields.hpp"

#include "foundation/fft.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace brinell::halfspace
{

namespace
{

using std::numbers::pi;
using Table = RadialTable<std::tuple_size_v<WaveParts>>;

/// Components of odd orders, which are imaginary in the amplitudes.
std::array<bool, std::tuple_size_v<WaveComponents>> imaginary(WaveTerms terms)
{
  std::array<bool, std::tuple_size_v<WaveComponents>> result{};
  for (const WaveTerm& term : terms)
    result[term.component] = term.order % 2 == 1;
  return result;
}

/// Field of a unit traction on a strip of cells that is uniform along the periodic axis, by the distance along the open one.
std::vector<WaveComponents> of_strip(const SurfaceGrid& grid, const WaveScales& scales, WaveTerms terms,
                                     const Table& waves, double reference)
{
  const bool along_x = grid.is_periodic_y();
  const int cells = along_x ? grid.nx : grid.ny;
  const double cell = along_x ? grid.dx : grid.dy;
  const auto wave = [&](const WaveParts& parts)
  { return components_of(terms, parts, along_x ? 1.0 : 0.0, along_x ? 0.0 : 1.0); };
  const auto odd = imaginary(terms);
  // A constant over k would reach without bound: that of a load at the depth of the decay is known in closed form.
  const WaveComponents far = wave(scales.at_zero);
  std::vector<WaveComponents> field(static_cast<std::size_t>(cells));
  const WaveNodes quadrature(scales, cells * cell);
  for (std::size_t n = 0; n < quadrature.k.size(); ++n)
  {
    const double k = quadrature.k[n];
    WaveComponents amplitude = wave(waves.at(k));
    for (std::size_t c = 0; c < amplitude.size(); ++c)
    {
      if (scales.is_over_k)
        amplitude[c] = (amplitude[c] - (odd[c] ? 0.0 : far[c] * std::exp(-k * scales.decay))) / k;
      amplitude[c] *= quadrature.weight[n] * cell * sinc(0.5 * k * cell) / pi;
    }
    const Complex step = std::polar(1.0, k * cell);
    Complex turn = 1.0;
    for (WaveComponents& value : field)
    {
      for (std::size_t c = 0; c < value.size(); ++c)
        value[c] += amplitude[c] * (odd[c] ? -turn.imag() : turn.real());
      turn *= step;
    }
  }
  if (scales.is_over_k)
  {
    SurfaceGrid strip = grid;
    (along_x ? strip.ny : strip.nx) = 1;
    (along_x ? strip.dy : strip.dx) *= along_x ? grid.ny : grid.nx;
    const Quadrant<std::array<double, 2>> buried = buried_cell(strip, scales.decay, reference);
    for (std::size_t i = 0; i < field.size(); ++i)
      for (std::size_t c = 0; c < far.size(); ++c)
        field[i][c] += odd[c] ? 0.0 : 0.5 / pi * far[c] * buried.values[i][0];
  }
  return field;
}

/// Lattice of the waves that are not uniform along the periodic axis.
struct Lattice
{
  int px, py, folds_x, folds_y;

  Lattice(const SurfaceGrid& grid, const WaveScales& scales)
      : px(grid.nx), py(grid.ny), folds_x(folds(grid.dx, scales)), folds_y(folds(grid.dy, scales))
  {
    // The longest wave of a period decays by e^{-16} on the way to the next image.
    constexpr double periods = 2.5;
    const auto length = [](int cells, double cell, double period)
    { return fast_length(std::max(2 * cells, cells + static_cast<int>(std::ceil(periods * period / cell)))); };
    if (grid.is_periodic_y())
      px = length(grid.nx, grid.dx, grid.ny * grid.dy);
    else
      py = length(grid.ny, grid.dy, grid.nx * grid.dx);
  }
  /// Waves shorter than two cells matter where the field is sharp compared with a cell.
  static int folds(double cell, const WaveScales& scales)
  {
    constexpr int most = 6;
    return std::clamp(static_cast<int>(std::ceil(1.5 * cell / scales.decay)), 1, most);
  }
};

/// Sum over a wave of the lattice and those that look the same on the cells, each times the waves of a cell.
WaveComponents folded(const SurfaceGrid& grid, const Lattice& lattice, const WaveScales& scales, WaveTerms terms,
                      const Table& waves, int column, int row)
{
  WaveComponents sum{};
  for (int fy = -lattice.folds_y; fy <= lattice.folds_y; ++fy)
    for (int fx = -lattice.folds_x; fx <= lattice.folds_x; ++fx)
    {
      const double m = 2.0 * pi * (column + static_cast<double>(fx) * lattice.px) / (lattice.px * grid.dx);
      const double n = 2.0 * pi * (row + static_cast<double>(fy) * lattice.py) / (lattice.py * grid.dy);
      const double k = std::hypot(m, n);
      if (k > scales.largest())
        continue;
      const double weight = sinc(0.5 * m * grid.dx) * sinc(0.5 * n * grid.dy) / (scales.is_over_k ? k : 1.0);
      const WaveComponents wave = components_of(terms, waves.at(k), m / k, n / k);
      for (std::size_t c = 0; c < sum.size(); ++c)
        sum[c] += weight * wave[c];
    }
  return sum;
}

/// Field of the waves that are not uniform along the periodic axis.
std::array<std::vector<double>, std::tuple_size_v<WaveComponents>>
of_lattice(const SurfaceGrid& grid, const WaveScales& scales, WaveTerms terms, const Table& waves)
{
  const Lattice lattice(grid, scales);
  const PaddedFft fft(grid, lattice.px, lattice.py);
  std::array<std::vector<Complex>, std::tuple_size_v<WaveComponents>> spectra;
  spectra.fill(std::vector<Complex>(fft.plane()));
  const auto odd = imaginary(terms);
  for (int row = 0; row < lattice.py; ++row)
    for (int i = 0; i < fft.kx(); ++i)
    {
      if (grid.is_periodic_y() ? row == 0 : i == 0)
        continue;
      const int signed_row = 2 * row <= lattice.py ? row : row - lattice.py;
      const WaveComponents sum = folded(grid, lattice, scales, terms, waves, i, signed_row);
      for (std::size_t c = 0; c < sum.size(); ++c)
        spectra[c][static_cast<std::size_t>(row * fft.kx() + i)] = odd[c] ? Complex(0.0, sum[c]) : Complex(sum[c]);
    }
  std::array<std::vector<double>, std::tuple_size_v<WaveComponents>> fields;
  for (std::size_t c = 0; c < fields.size(); ++c)
  {
    fields[c].resize(grid.size());
    fft.inverse(spectra[c].data(), fields[c]);
  }
  return fields;
}

} // namespace

Quadrant<WaveComponents> banded_cells(const SurfaceGrid& grid, const WaveScales& scales, WaveTerms terms,
                                      const Table& waves, double reference)
{
  const std::vector<WaveComponents> strip = of_strip(grid, scales, terms, waves, reference);
  const bool along_x = grid.is_periodic_y();
  const int period = along_x ? grid.ny : grid.nx;
  Quadrant<WaveComponents> out(grid);
  for (int j = 0; j < out.ny; ++j)
    for (int i = 0; i < out.nx; ++i)
      for (std::size_t c = 0; c < strip.front().size(); ++c)
        out.at(i, j)[c] = strip[static_cast<std::size_t>(along_x ? i : j)][c] / period;
  if (period == 1)
    return out;
  const auto waved = of_lattice(grid, scales, terms, waves);
  for (int j = 0; j < out.ny; ++j)
    for (int i = 0; i < out.nx; ++i)
      for (std::size_t c = 0; c < waved.size(); ++c)
        out.at(i, j)[c] += waved[c][grid.index(i, j)];
  return out;
}

} // namespace brinell::halfspace
