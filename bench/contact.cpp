// SPDX-License-Identifier: BSD-3-Clause
// What does one displacement-driven elastic contact cost, from nothing and from the pressure of the step before? What does a
// rough periodic surface under a load cost?
#include "brinell/contact/elastic_contact.hpp"
#include "foundation/fft.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
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
  const SurfaceGrid grid{.nx = static_cast<int>(state.range(0)),
                         .ny = static_cast<int>(state.range(1)),
                         .dx = 3.85e-3,
                         .dy = 3.85e-3 * static_cast<double>(state.range(0)) / static_cast<double>(state.range(1)),
                         .is_mirrored_y = state.range(3) != 0};
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
    ->ArgNames({"nx", "ny", "warm", "mirrored"})
    ->Args({33, 13, 0, 0})
    ->Args({33, 13, 1, 0})
    ->Args({129, 129, 0, 0})
    ->Args({129, 129, 1, 0})
    ->Args({257, 257, 0, 0})
    ->Args({257, 257, 1, 0})
    ->Args({513, 513, 0, 0})
    ->Args({33, 13, 1, 1})
    ->Args({129, 129, 1, 1})
    ->Args({257, 257, 1, 1})
    ->Unit(benchmark::kMicrosecond);

/// Distance from a self-affine surface: Hurst exponent 0.8, wavelengths from a half of the grid to `shortest` cells, root mean
/// square 1.
std::vector<double> rough_distance(int n, int shortest)
{
  const auto columns = static_cast<std::size_t>(n / 2 + 1);
  const PaddedFft fft({n, n, 1.0, 1.0, Boundary::periodic, Boundary::periodic});
  AlignedVector<Complex> waves(fft.plane());
  std::mt19937 random(1);
  std::vector<double> distance(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i <= n / 2; ++i)
    {
      const double k = std::hypot(i, j <= n / 2 ? j : j - n);
      const double phase = 2.0 * std::numbers::pi * static_cast<double>(random()) / 4294967296.0;
      if (k >= 2.0 && k <= n / shortest)
        waves[static_cast<std::size_t>(j) * columns + static_cast<std::size_t>(i)] =
            std::polar(std::pow(k, -1.8), phase);
    }
  fft.inverse(waves.data(), distance);
  double squares = 0.0;
  for (const double d : distance)
    squares += d * d / static_cast<double>(distance.size());
  for (double& d : distance)
    d /= std::sqrt(squares);
  return distance;
}

/// Pressed from nothing until about `percent` of the surface touch, to 1e-6 of the root mean square.
void rough_contact(benchmark::State& state)
{
  const int n = static_cast<int>(state.range(0));
  const SurfaceGrid grid{n, n, 1.0 / n, 1.0 / n, Boundary::periodic, Boundary::periodic};
  const std::vector<double> distance = rough_distance(n, static_cast<int>(state.range(1)));
  double squares = 0.0; // of the slope
  for (std::size_t i = 1; i < distance.size(); ++i)
    squares += 2.0 * std::pow(distance[i] - distance[i - 1], 2); // 2 / n^2 of the sum, by n^2
  const double load = 0.5 * static_cast<double>(state.range(2)) / 100.0 * std::sqrt(squares);
  const halfspace::SurfaceCompliance compliance(grid, 1.0);
  contact::ElasticContact solver(compliance);
  std::vector<double> gap(grid.size());
  contact::Report report;
  for (auto _ : state)
  {
    std::vector<double> pressure(grid.size(), 0.0);
    report = solver.solve(distance, {contact::Drive::Kind::load, load}, 1e-6, 1000, pressure, gap);
    if (!report.converged)
      state.SkipWithError("not converged");
  }
  state.counters["iterations"] = report.iterations;
  state.counters["products"] = report.products;
}
BENCHMARK(rough_contact)
    ->ArgNames({"cells", "shortest", "percent"})
    ->Args({256, 8, 1})
    ->Args({256, 8, 10})
    ->Args({256, 2, 50})
    ->Args({1024, 8, 1})
    ->Args({1024, 8, 10})
    ->Args({1024, 2, 50})
    ->Args({2048, 8, 10})
    ->Unit(benchmark::kMillisecond);

} // namespace
