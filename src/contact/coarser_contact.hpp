// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"

#include <vector>

namespace brinell::contact
{

/// How the cells along one axis lie on the larger ones.
struct CoarserAxis
{
  /// A finer cell: the larger one that its middle lies on, the nearest one beside, and how much that one counts.
  struct Place
  {
    int own = 0, beside = 0;
    double share = 0.0;
  };
  int cells = 0; ///< larger ones
  std::vector<Place> places;

  /// Larger cells cover two finer ones each, of which the last may stand out by one; those of a period, all of it. Few cells stay as
  /// they are.
  CoarserAxis(int fine, Boundary boundary);
};

/// The same contact on cells twice as large, which gives a guess of the pressure where there is none.
class CoarserContact
{
public:
  /// Whether a guess from larger cells saves more than it costs.
  [[nodiscard]] static bool helps(const SurfaceGrid& fine);

  explicit CoarserContact(const halfspace::SurfaceCompliance& fine);

  /// @param tolerance  of the finer solution; this one is not solved as well
  /// @param pressure   out: on the finer grid [Pa]
  void guess(std::span<const double> distance, const Drive& drive, double tolerance, std::span<double> pressure,
             const std::function<bool()>& wants_stop);

private:
  [[nodiscard]] double interpolated(int i, int j) const;

  SurfaceGrid fine_;
  CoarserAxis x_, y_;
  halfspace::SurfaceCompliance compliance_;
  ElasticContact contact_;
  std::vector<double> distance_, pressure_, gap_;
};

} // namespace brinell::contact
