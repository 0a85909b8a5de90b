// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/elastic_contact.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::contact
{

ElasticContact::ElasticContact(const halfspace::SurfaceCompliance& compliance)
    : compliance_(compliance), scratch_(compliance.make_scratch()), direction_(compliance.grid().size()),
      image_(compliance.grid().size())
{
}

namespace
{

/// The two halves of the complementarity condition.
Report measure(std::span<const double> pressure, std::span<const double> gap)
{
  Report report;
  for (std::size_t i = 0; i < gap.size(); ++i)
    if (pressure[i] > 0.0)
      report.gap_error = std::max(report.gap_error, std::abs(gap[i]));
    else
      report.penetration = std::max(report.penetration, -gap[i]);
  return report;
}

} // namespace

Report ElasticContact::solve(std::span<const double> rigid_gap, double tolerance, int max_iterations,
                             std::span<double> pressure, std::span<double> gap)
{
  const std::size_t n = rigid_gap.size();
  for (double& p : pressure)
    p = std::max(p, 0.0);
  if (std::none_of(pressure.begin(), pressure.end(), [](double p) { return p > 0.0; }))
  {
    // A start for the conjugate gradient: the cells that overlap, at the stiffness of a single cell.
    const double stiffness = 1.0 / *std::max_element(compliance_.spectrum().begin(), compliance_.spectrum().end());
    for (std::size_t i = 0; i < n; ++i)
      pressure[i] = rigid_gap[i] < 0.0 ? -rigid_gap[i] * stiffness : 0.0;
  }
  std::fill(direction_.begin(), direction_.end(), 0.0);
  double previous_norm = 1.0;
  bool conjugate = false;
  Report report;
  for (int iteration = 0;; ++iteration)
  {
    compliance_.apply(pressure, gap, scratch_);
    for (std::size_t i = 0; i < n; ++i)
      gap[i] += rigid_gap[i];
    report = measure(pressure, gap);
    report.iterations = iteration;
    report.converged = report.gap_error <= tolerance && report.penetration <= tolerance;
    if (report.converged || iteration == max_iterations)
      return report;

    double norm = 0.0;
    for (std::size_t i = 0; i < n; ++i)
      if (pressure[i] > 0.0)
        norm += gap[i] * gap[i];
    const double beta = conjugate ? norm / previous_norm : 0.0;
    previous_norm = norm;
    for (std::size_t i = 0; i < n; ++i)
      direction_[i] = pressure[i] > 0.0 ? gap[i] + beta * direction_[i] : 0.0;
    compliance_.apply(direction_, image_, scratch_);
    double descent = 0.0;
    double curvature = 0.0;
    for (std::size_t i = 0; i < n; ++i)
    {
      descent += gap[i] * direction_[i];
      curvature += image_[i] * direction_[i];
    }
    const double step = curvature > 0.0 ? descent / curvature : 0.0;
    conjugate = true;
    // Steps past zero pressure are cut; cells that overlap come (back) into contact, which restarts the directions.
    for (std::size_t i = 0; i < n; ++i)
    {
      if (pressure[i] > 0.0)
        pressure[i] = std::max(0.0, pressure[i] - step * direction_[i]);
      if (pressure[i] == 0.0 && gap[i] < 0.0)
      {
        const double relaxation = step > 0.0 ? step : 1.0 / compliance_.spectrum()[1];
        pressure[i] = -relaxation * gap[i];
        conjugate = false;
      }
    }
  }
}

} // namespace brinell::contact
