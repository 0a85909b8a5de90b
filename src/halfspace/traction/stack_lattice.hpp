// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/green/stack.hpp"

#include <array>
#include <cmath>
#include <numbers>

/// The lattice of waves by which the short-ranged part of the response of a layered body is summed, and the long waves of this
/// response: docs/theory/stacks.md (stack-cells).
namespace brinell::halfspace
{

/// Level e^{-kH} + rising k H e^{-kH}: the closed forms of long waves.
struct LongWaves
{
  double level = 0.0, rising = 0.0;
};

/// Lengths of the lattice of waves, in cells, and the waves beyond the cells' shortest one that a cell with sharp edges contains.
struct Lattice
{
  int px, py, folds_x, folds_y;
};
[[nodiscard]] Lattice lattice_of(const SurfaceGrid& grid, const ElasticStack& stack);

/// Distance from which the body responds like its substrate [m]: a hard coating spreads the load, a soft one that hardly
/// changes its volume is squeezed slowly.
[[nodiscard]] double reach(const ElasticStack& stack);

/// Depth of the loads whose closed forms are the long waves [m].
[[nodiscard]] double depth_of_forms(const SurfaceGrid& grid, const ElasticStack& stack);

struct WaveRange
{
  double smallest, largest;
};
[[nodiscard]] WaveRange range_of(const SurfaceGrid& grid, const Lattice& lattice);

/// Value and slope at k = 0 of a function given at four equidistant wavenumbers, the first of which is the step.
[[nodiscard]] LongWaves extrapolated(const std::array<double, 4>& f, double step);

/// Wavenumber of waves so long that only the first powers matter, and yet far above rounding.
[[nodiscard]] inline double long_wave(double reach)
{
  return 1e-3 / reach;
}

[[nodiscard]] inline double sinc(double x)
{
  return x == 0.0 ? 1.0 : std::sin(x) / x;
}

/// Sum over a wave of the lattice and those that look the same on the cells, each times the waves of a cell.
/// @param row  wrapped
template <typename Values, typename Use>
Values folded(const SurfaceGrid& grid, const Lattice& lattice, int column, int row, const Use& use)
{
  using std::numbers::pi;
  const int signed_row = 2 * row <= lattice.py ? row : row - lattice.py;
  Values sum{};
  for (int fy = lattice.py == 1 ? 0 : -lattice.folds_y; fy <= (lattice.py == 1 ? 0 : lattice.folds_y); ++fy)
    for (int fx = lattice.px == 1 ? 0 : -lattice.folds_x; fx <= (lattice.px == 1 ? 0 : lattice.folds_x); ++fx)
    {
      const double m = 2.0 * pi * (column + static_cast<double>(fx) * lattice.px) / (lattice.px * grid.dx);
      const double n = 2.0 * pi * (signed_row + static_cast<double>(fy) * lattice.py) / (lattice.py * grid.dy);
      if (m == 0.0 && n == 0.0)
        continue; // the uniform wave is the caller's
      use(m, n, sinc(0.5 * m * grid.dx) * sinc(0.5 * n * grid.dy), sum);
    }
  return sum;
}

} // namespace brinell::halfspace
