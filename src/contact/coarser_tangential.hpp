// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/tangential_contact.hpp"
#include "coarser_cells.hpp"

#include <vector>

namespace brinell::contact
{

/// Step of stick and slip on cells twice as large, solved for an initial guess of the shears.
class CoarserTangential
{
public:
  explicit CoarserTangential(const halfspace::SurfaceCompliance& fine);

  /// @param tolerance  of the finer solution [m]; the coarser one is solved less accurately
  /// @param shear      in: a guess on the finer cells; out: a better one [Pa]
  /// @returns whether a better guess was found
  [[nodiscard]] bool guess(const TangentialStep& step, double tolerance, const AlongSurface& shear,
                           const std::function<bool()>& wants_stop);

  /// Ratio of the slip error of a guess to the tolerance above which a coarser solution saves more than it costs.
  static constexpr double worth = 1000.0;

private:
  using Pair = std::array<std::vector<double>, 2>;
  void read(const TangentialStep& step);
  void interpolate(std::span<const double> bound, const AlongSurface& shear) const;

  CoarserCells cells_;
  halfspace::SurfaceCompliance compliance_;
  TangentialContact contact_;
  std::vector<double> bound_, finer_; ///< `finer_`: one value for each finer cell
  Pair before_, change_, shear_, guess_, slip_;
};

} // namespace brinell::contact
