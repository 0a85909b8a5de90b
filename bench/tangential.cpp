// SPDX-License-Identifier: BSD-3-Clause
// How many normal contacts does one solution of stick and slip cost, from nothing and after a step before?
#include "brinell/contact/elastic_contact.hpp"
#include "brinell/contact/tangential_contact.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>
#include <vector>

namespace
{

using namespace brinell;

double processor_seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Two equal balls with nu = 0.3 under a load, then pushed to a share of the limiting force; a step before to 5 % less, if warm.
void partial_slip(benchmark::State& state)
{
  const int n = static_cast<int>(state.range(0));
  const double share = static_cast<double>(state.range(1)) / 100.0;
  const bool warm = state.range(2) != 0;
  const SurfaceGrid grid{n, n, 2.6 / n, 2.6 / n}; // the contact has the radius 1
  const Elastic body{1.0, 0.3};
  const double modulus = contact_modulus(body, body);
  const halfspace::SurfaceCompliance normal(grid, modulus);
  const halfspace::SurfaceCompliance tractions(grid, body, body);
  contact::ElasticContact press(normal);
  contact::TangentialContact push(tractions);
  constexpr double radius = 100.0, friction = 0.3, tolerance = 1e-7;
  std::vector<double> distance(grid.size());
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      distance[grid.index(i, j)] = 0.5 * (std::pow(grid.x(i), 2) + std::pow(grid.y(j), 2)) / radius;
  const double load = 4.0 / 3.0 * modulus / radius;
  std::vector<double> pressure, gap(grid.size()), bound(grid.size()), slip_x(grid.size()), slip_y(grid.size());
  const auto pressed = [&]
  {
    pressure.assign(grid.size(), 0.0);
    return press.solve(distance, {contact::Drive::Kind::load, load}, tolerance / radius, 1000, pressure, gap).converged;
  };
  bool is_good = pressed();
  for (std::size_t i = 0; i < bound.size(); ++i)
    bound[i] = friction * pressure[i];
  std::vector<double> before_x(grid.size(), 0.0), before_y(grid.size(), 0.0), x, y;
  contact::TangentialStep step{bound, {}, {}, {}};
  const auto pushed = [&](double to)
  {
    step.drive.x = {contact::TangentialDrive::Kind::force, to * friction * load};
    return push.solve(step, friction * tolerance / radius, 1000, {x, y}, {slip_x, slip_y});
  };
  x = before_x;
  y = before_y;
  if (warm)
  {
    is_good = is_good && pushed(share - 0.05).converged;
    before_x = x;
    before_y = y;
    step.before = {before_x, before_y};
  }
  contact::TangentialReport report;
  double of_push = 0.0, of_press = 0.0; // timed by turns, so that both see the same machine
  for (auto _ : state)
  {
    x = before_x;
    y = before_y;
    const double start = processor_seconds();
    report = pushed(share);
    const double between = processor_seconds();
    of_push += between - start;
    state.PauseTiming();
    const double again = processor_seconds();
    is_good = is_good && report.converged && pressed();
    of_press += processor_seconds() - again;
    state.ResumeTiming();
  }
  if (!is_good)
    state.SkipWithError("not converged");
  state.counters["iterations"] = report.iterations;
  state.counters["products"] = report.products;
  state.counters["normal_contacts"] = of_push / of_press;
}
BENCHMARK(partial_slip)
    ->ArgNames({"cells", "percent", "warm"})
    ->ArgsProduct({{32, 64, 128, 256}, {50, 90}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

} // namespace
