// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

namespace brinell::simulation
{

/// Position of the contact's centre on the surface of each body [m].
struct Centre
{
  double lower = 0.0, upper = 0.0;
};

/// The contact grid at one moment of the motion.
struct Frame
{
  double x0 = 0.0;                    ///< of contact column 0 relative to the contact's centre [m]
  elastoplastic::Placement placement; ///< on the material grids
};

/// Positions of the grids. The columns of the contact grid coincide with columns of the lower body, and its middle follows the
/// contact's centre to within half a cell; columns of the upper body may lie on those of the contact grid or between them.
class Lattice
{
public:
  /// @param start  a moment when the columns of both bodies coincide.
  Lattice(const Plan& plan, const Centre& start);

  [[nodiscard]] Frame frame(const Centre& centre) const;
  /// Surface coordinate of column 0 of a body's grid [m].
  [[nodiscard]] double lower_origin() const { return -lower_columns_ * dx_; }
  [[nodiscard]] double upper_origin() const { return upper_start_ - upper_columns_ * dx_; }
  /// Adds columns to each end of the grids (removes them if negative); every cell keeps its position.
  void grow(int contact, int lower, int upper);

private:
  [[nodiscard]] long centre_column(double arc_lower) const;

  double dx_;
  int half_;           ///< columns of the contact grid on either side of its middle one
  double upper_start_; ///< position of the contact's column 0 on the upper body at the start [m]
  int lower_columns_;  ///< number of columns of the lower body before the one at 0
  int upper_columns_;  ///< number of columns of the upper body before the one at `upper_start_`
};

} // namespace brinell::simulation
