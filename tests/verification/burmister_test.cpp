// SPDX-License-Identifier: BSD-3-Clause
// A round load on a coated half space, and on a layer on a rigid base: Burmister's integrals (tools/oracles/burmister.py).
#include "brinell/halfspace/half_space.hpp"
#include "brinell/halfspace/surface_compliance.hpp"
#include "gauss.hpp"
#include "oracle_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace brinell::verification::burmister_test
{
namespace
{

using namespace halfspace;

constexpr double rigid = std::numeric_limits<double>::infinity();
constexpr std::array columns{"u_0", "u_15", "zz_above", "rr_above", "zz_below", "rr_below"};
using Values = std::array<double, columns.size()>;

/// The pressure (1 - r^2)^2 within r < 1, as means over the cells.
std::vector<double> round_load(const SurfaceGrid& grid)
{
  std::vector<double> pressure(grid.size());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      const test::Gauss x(6, grid.x(i) - 0.5 * grid.dx, grid.x(i) + 0.5 * grid.dx);
      const test::Gauss y(6, grid.y(j) - 0.5 * grid.dy, grid.y(j) + 0.5 * grid.dy);
      for (std::size_t a = 0; a < x.point.size(); ++a)
        for (std::size_t b = 0; b < y.point.size(); ++b)
        {
          const double inside = std::max(0.0, 1.0 - x.point[a] * x.point[a] - y.point[b] * y.point[b]);
          pressure[grid.index(i, j)] += x.weight[a] * y.weight[b] / grid.cell_area() * inside * inside;
        }
    }
  return pressure;
}

/// Values of the oracle on a grid with `cells` cells in the radius of the load.
Values computed(const ElasticStack& stack, int cells)
{
  const double size = 1.0 / cells, thickness = stack.layers.front().thickness;
  const bool on_rigid = stack.substrate.is_rigid();
  const VolumeGrid grid{{3 * cells + 1, 3 * cells + 1, size, size}, on_rigid ? 4 : 5, 0.25 * thickness};
  const std::vector<double> pressure = round_load(grid.surface);
  std::vector<double> u(grid.surface.size());
  SurfaceCompliance(grid.surface, stack, {{}, {rigid, 0.0}}).apply({.pressure = pressure}, {.z = u});
  const int middle = (grid.surface.nx - 1) / 2;
  Values values{u[grid.surface.index(middle, middle)], u[grid.surface.index(grid.surface.nx - 1, middle)]};
  const HalfSpace body(grid, stack);
  HalfSpace::Work work = body.make_guest();
  std::vector<double> stress(6 * grid.surface.size());
  for (int layer = 3; layer < grid.nz; ++layer)
  {
    body.stress_of_load({.pressure = pressure}, layer, work, stress);
    const auto part = [&](std::size_t c)
    { return stress[c * grid.surface.size() + grid.surface.index(middle, middle)]; };
    const double mean = part(5) / 3.0;
    const std::size_t at = layer == 3 ? 2 : 4;
    values[at] = mean - part(0) - part(1);
    values[at + 1] = mean + part(0);
  }
  return values;
}

/// The load is constant in a cell, so the error is of second order in the size of the cells; extrapolated from two grids, it is that of
/// the next order and of the edge of the load, where the second derivative jumps.
TEST(Burmister, CoatedBodiesUnderARoundLoad)
{
  const test::OracleTable oracle("burmister_oracle.csv");
  for (std::size_t row = 0; row < oracle.size(); ++row)
  {
    const bool on_rigid = oracle.text(row, "base") == "rigid";
    const ElasticStack stack{{{oracle.number(row, "thickness"), {oracle.number(row, "contrast"), 0.25}}},
                             on_rigid ? Elastic{rigid, 0.0} : Elastic{1.0, 0.35}};
    // The cells must resolve the layer for the error to be of the second order.
    const int cells = oracle.number(row, "thickness") < 1.0 ? 20 : 8;
    const Values coarse = computed(stack, cells), fine = computed(stack, 2 * cells);
    const std::string body = oracle.text(row, "base") + ", ratio of moduli " + oracle.text(row, "contrast") +
                             ", thickness " + oracle.text(row, "thickness");
    double most = 0.0, extrapolated = 0.0;
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
      const double expected = oracle.number(row, columns[c]);
      const double scale = c < 2 ? oracle.number(row, "u_0") : std::max(1.0, std::abs(expected));
      const double next = fine[c] + (fine[c] - coarse[c]) / 3.0;
      EXPECT_NEAR(fine[c], expected, 3e-3 * scale) << body << ", " << columns[c];
      EXPECT_NEAR(next, expected, 2e-4 * scale) << body << ", " << columns[c];
      most = std::max(most, std::abs(fine[c] - expected) / scale);
      extrapolated = std::max(extrapolated, std::abs(next - expected) / scale);
    }
    std::printf("%-56s %9.2e, extrapolated %9.2e\n", body.c_str(), most, extrapolated);
  }
}

} // namespace
} // namespace brinell::verification::burmister_test
