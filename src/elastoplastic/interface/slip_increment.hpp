// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "shear_bound.hpp"
#include "slip_drive.hpp"

#include <array>
#include <functional>
#include <vector>

namespace brinell::elastoplastic
{

/// One increment between surfaces that may stick: what it starts from and what is imposed, then what `StickSlip` finds. The shear
/// at its end is in SlipState.
struct SlipIncrement
{
  using Pair = std::array<std::vector<double>, 2>;

  SlipIncrement(const SurfaceGrid& contact, double coefficient) : grid(contact), bound(coefficient, contact.size())
  {
    for (Pair* pair : {&shear_before, &residual_before, &displacement_before, &change, &slip})
      pair->fill(std::vector<double>(contact.size(), 0.0));
    pressure_before.assign(contact.size(), 0.0);
    heat.assign(contact.size(), 0.0);
  }
  /// Whether shears within the bound can carry the imposed force.
  [[nodiscard]] bool is_carried() const { return can_carry(sum(bound.now()) * grid.cell_area(), drive.along); }

  SurfaceGrid grid;
  SlipDrive drive;
  bool is_driven = false; ///< whether the increment imposes another shift, force or rotation
  double tolerance = 0.0; ///< of the slip [m]
  std::function<bool()> wants_stop;
  ShearBound bound;
  Pair shear_before;                   ///< of the surface points that now lie in each cell [Pa]
  std::vector<double> pressure_before; ///< of the same points [Pa]
  Pair residual_before;                ///< residual displacement, lower minus upper body, before the increment [m]
  Pair displacement_before; ///< total (elastic and residual) displacement, lower minus upper, before the increment [m]

  int entries = 0;               ///< how often the free motion of entering points has been found
  Pair change;                   ///< of the displacement that is not due to the shears [m]
  Pair slip;                     ///< [m]
  std::array<double, 2> shift{}; ///< imposed or found [m]
  std::vector<double> heat;      ///< of friction per area, after the end of the increment [J/m^2]
};

} // namespace brinell::elastoplastic
