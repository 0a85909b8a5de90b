// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/contact_stiffness.hpp"

#include "brinell/contact/punch.hpp"
#include "foundation/nan.hpp"
#include "foundation/require_size.hpp"
#include "foundation/sharing.hpp"

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
  if (pressed == 0)
    return 0.0;
  if (grid.is_periodic() && static_cast<std::size_t>(pressed) == grid.size())
    return std::numeric_limits<double>::infinity();
  std::vector<double> punch(grid.size());
  const Punch::Report report = Punch(compliance).press(pressure, std::vector<double>(grid.size(), 1.0), punch);
  const double load = sum(grid, punch) * grid.cell_area();
  return report.converged && load > 0.0 ? load : nan;
}

} // namespace brinell::contact
