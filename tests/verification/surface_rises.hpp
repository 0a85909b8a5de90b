// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record.hpp"

#include "brinell/io/case_file.hpp"
#include "brinell/simulation/run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <variant>
#include <vector>

/// Cases as a user writes them, and the temperatures of a surface in one of their steps.
namespace brinell::verification
{

template <typename Case>
Case case_of(const std::string& text)
{
  return std::get<Case>(io::parse_case(text, "case.toml").scenario);
}

/// Temperature rises of a surface, in an array of cells whose middle is that of the contact.
struct Rises
{
  SurfaceGrid grid;
  std::vector<double> rise, flux; ///< [K], [W/m^2]
  double heat = 0.0;              ///< share of this body in the flux

  /// @param body  0: lower, 1: upper
  Rises(const simulation::Snapshot& s, std::size_t body, double bulk = 20.0)
      : grid(s.contact), rise(s.temperature[body]), flux(s.heat_flux[body])
  {
    for (double& r : rise)
      r -= bulk;
    heat = sum(s.heat_flux[body]) / (sum(s.heat_flux[0]) + sum(s.heat_flux[1]));
  }

  /// On the row through the middle.
  [[nodiscard]] double at(int i) const { return rise[grid.index(i, grid.ny / 2)]; }
  [[nodiscard]] double in_the_middle() const { return at(grid.nx / 2); }
  [[nodiscard]] double largest() const { return *std::max_element(rise.begin(), rise.end()); }
  /// Mean over the source: every cell counts as much as the source covers of it.
  [[nodiscard]] double mean() const
  {
    double weighted = 0.0;
    for (std::size_t i = 0; i < rise.size(); ++i)
      weighted += flux[i] * rise[i];
    return weighted / sum(flux);
  }
  /// Vertex of the parabola through the hottest cell of the row through the middle and its neighbours [m].
  [[nodiscard]] double hottest_place() const
  {
    int hottest = 1;
    for (int i = 1; i + 1 < grid.nx; ++i)
      if (at(i) > at(hottest))
        hottest = i;
    const double before = at(hottest - 1), after = at(hottest + 1);
    return grid.x(hottest) + 0.5 * grid.dx * (before - after) / (before - 2.0 * at(hottest) + after);
  }

private:
  static double sum(const std::vector<double>& field) { return std::accumulate(field.begin(), field.end(), 0.0); }
};

/// Both surfaces after so many steps.
template <typename Case>
std::array<Rises, 2> rises_of(const Case& c, int steps)
{
  simulation::Run<Case> run(c);
  for (int step = 0; step < steps; ++step)
    static_cast<void>(run.step());
  const simulation::Snapshot s = run.snapshot();
  return {Rises(s, 0), Rises(s, 1)};
}

/// Order of convergence of a ratio to 1, between two meshes of which the second has half the cell size.
inline void expect_order(const std::string& name, const std::vector<double>& ratios, double low, double high,
                         const std::string& origin)
{
  test::expect_within(name + ", order", std::log2(std::abs((ratios.at(0) - 1.0) / (ratios.at(1) - 1.0))), low, high,
                      origin);
}

} // namespace brinell::verification
