// SPDX-License-Identifier: BSD-3-Clause
// What does one displacement-driven elastic contact cost, from nothing and from the pressure of the step before?
#include "brinell/contact/elastic_contact.hpp"

#include <benchmark/benchmark.h>

#include <vector>

namespace
{

using namespace brinell;

constexpr double modulus = 1.114082e11; // E' of two steel bodies [Pa]

/// A sphere (1/R = 2/m) pressed until the contact covers 70 % of the grid's width in y.
std::vector<double> rigid_gap(const SurfaceGrid& g, double factor)
{
  const double radius = 0.35 * g.ny * g.dy;
  std::vector<double> gap(g.size());
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
    {
      const double x = (i - 0.5 * (g.nx - 1)) * g.dx;
      const double y = (j - 0.5 * (g.ny - 1)) * g.dy;
      gap[g.index(i, j)] = x * x + y * y - factor * 2.0 * radius * radius;
    }
  return gap;
}

void contact_solution(benchmark::State& state)
{
  const SurfaceGrid grid{static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), 3.85e-3,
                         3.85e-3 * static_cast<double>(state.range(0)) / static_cast<double>(state.range(1))};
  const bool warm = state.range(2) != 0;
  const halfspace::SurfaceCompliance compliance(grid, modulus);
  contact::ElasticContact solver(compliance);
  std::vector<double> last(grid.size(), 0.0);
  std::vector<double> gap(grid.size());
  const std::vector<double> rigid = rigid_gap(grid, 1.0);
  const double depth = -rigid[rigid.size() / 2];
  if (warm && !solver.solve(rigid_gap(grid, 0.95), {}, 1e-7 * depth, 1000, last, gap).converged)
    state.SkipWithError("the step before has not converged");
  long iterations = 0;
  long products = 0;
  for (auto _ : state)
  {
    std::vector<double> pressure = last;
    const contact::Report report = solver.solve(rigid, {}, 1e-7 * depth, 1000, pressure, gap);
    iterations += report.iterations;
    products += report.products;
    if (!report.converged)
      state.SkipWithError("not converged");
  }
  state.counters["iterations"] = static_cast<double>(iterations) / static_cast<double>(state.iterations());
  state.counters["products"] = static_cast<double>(products) / static_cast<double>(state.iterations());
}
BENCHMARK(contact_solution)
    ->ArgNames({"nx", "ny", "warm"})
    ->Args({33, 13, 0})
    ->Args({33, 13, 1})
    ->Args({129, 129, 0})
    ->Args({129, 129, 1})
    ->Args({257, 257, 0})
    ->Args({257, 257, 1})
    ->Args({513, 513, 0})
    ->Unit(benchmark::kMicrosecond);

} // namespace
