// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/contact_stiffness.hpp"

#include "brinell/contact/elastic_contact.hpp"
#include "foundation/nan.hpp"
#include "foundation/require_size.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace brinell::contact
{

double stiffness(const halfspace::SurfaceCompliance& compliance, std::span<const double> pressure)
{
  const SurfaceGrid& grid = compliance.grid();
  require_size("contact::stiffness: the pressure", pressure, grid.size());
  const auto pressed = std::count_if(pressure.begin(), pressure.end(), [](double p) { return p > 0.0; });
  const auto count = static_cast<double>(pressed);
  if (pressed == 0)
    return 0.0;
  if (grid.is_periodic() && static_cast<std::size_t>(pressed) == grid.size())
    return std::numeric_limits<double>::infinity();
  // The punch carries a mean pressure of 1 Pa. No displacement exceeds the largest response times the sum of the pressure, so the
  // other cells, recessed by more than that, never touch.
  const double out_of_reach = 3.0 * compliance.largest() * count;
  std::vector<double> distance(grid.size());
  std::vector<double> punch(grid.size());
  std::vector<double> gap(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i)
  {
    distance[i] = pressure[i] > 0.0 ? 0.0 : out_of_reach;
    punch[i] = pressure[i] > 0.0 ? 1.0 : 0.0;
  }
  constexpr double accuracy = 1e-5; // relative error of the flat face; that of the stiffness is its square
  constexpr int most_iterations = 2000;
  const double load = count * grid.cell_area();
  ElasticContact contact(compliance);
  // The approach of the punch is known only afterwards: nearly full contacts need a second solution.
  for (double tolerance = accuracy * compliance.largest();;)
  {
    const Report report = contact.solve(distance, {Drive::Kind::load, load}, tolerance, most_iterations, punch, gap);
    if (!report.converged || !(report.approach > 0.0))
      return nan;
    if (tolerance <= 1.1 * accuracy * report.approach)
      return load / report.approach;
    tolerance = accuracy * report.approach;
  }
}

} // namespace brinell::contact
