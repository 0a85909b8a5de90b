// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"
#include "coarser_cells.hpp"

#include <vector>

namespace brinell::contact
{

/// Contact on cells twice as large, solved for an initial guess of the pressure.
class CoarserContact
{
public:
  explicit CoarserContact(const halfspace::SurfaceCompliance& fine);

  /// @param tolerance  of the finer solution [m]; the coarser one is solved less accurately
  /// @param pressure   out: on the finer grid [Pa]
  void guess(std::span<const double> distance, const Drive& drive, double tolerance, std::span<double> pressure,
             const std::function<bool()>& wants_stop);

private:
  [[nodiscard]] double interpolated(int i, int j) const;

  CoarserCells cells_;
  halfspace::SurfaceCompliance compliance_;
  ElasticContact contact_;
  std::vector<double> distance_, pressure_, gap_;
};

} // namespace brinell::contact
