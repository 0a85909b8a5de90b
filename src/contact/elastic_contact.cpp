// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/elastic_contact.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace brinell::contact
{

ElasticContact::ElasticContact(const halfspace::SurfaceCompliance& compliance)
    : compliance_(compliance), scratch_(compliance.make_scratch()), direction_(compliance.grid().size()),
      image_(compliance.grid().size())
{
}

namespace
{

bool touches(std::span<const double> pressure)
{
  return std::any_of(pressure.begin(), pressure.end(), [](double p) { return p > 0.0; });
}

/// Mean of a field over the cells under pressure; 0 without any.
double mean_under(std::span<const double> pressure, std::span<const double> field)
{
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < field.size(); ++i)
    if (pressure[i] > 0.0)
    {
      sum += field[i];
      count += 1.0;
    }
  return count > 0.0 ? sum / count : 0.0;
}

/// The two halves of the complementarity condition.
void measure(std::span<const double> pressure, std::span<const double> gap, Report& report)
{
  report.gap_error = 0.0;
  report.penetration = 0.0;
  const auto larger = [](double a, double b) { return b <= a ? a : b; }; // keeps a NaN
  for (std::size_t i = 0; i < gap.size(); ++i)
    if (pressure[i] > 0.0)
      report.gap_error = larger(report.gap_error, std::abs(gap[i]));
    else
      report.penetration = larger(report.penetration, -gap[i]);
}

/// Without load the surfaces just touch.
Report touching(std::span<const double> distance, std::span<double> pressure, std::span<double> gap)
{
  Report report;
  report.converged = true;
  report.approach = *std::min_element(distance.begin(), distance.end());
  std::fill(pressure.begin(), pressure.end(), 0.0);
  std::transform(distance.begin(), distance.end(), gap.begin(), [&](double d) { return d - report.approach; });
  return report;
}

} // namespace

/// A pressure to begin with: the guess, or if there is none the cells that overlap, at the stiffness of a single cell; under a
/// load that has not pressed anything yet, the cell that touches first.
void ElasticContact::start(std::span<const double> distance, const Drive& drive, std::span<double> pressure) const
{
  for (double& p : pressure)
    p = std::max(p, 0.0);
  const bool load_given = drive.kind == Drive::Kind::load;
  if (!touches(pressure))
  {
    const double stiffness = 1.0 / *std::max_element(compliance_.spectrum().begin(), compliance_.spectrum().end());
    if (load_given)
      pressure[static_cast<std::size_t>(std::min_element(distance.begin(), distance.end()) - distance.begin())] = 1.0;
    else
      for (std::size_t i = 0; i < distance.size(); ++i)
        pressure[i] = std::max(0.0, drive.value - distance[i]) * stiffness;
  }
  if (load_given)
    scale_to_load(drive.value, pressure);
}

void ElasticContact::scale_to_load(double load, std::span<double> pressure) const
{
  const double sum = std::accumulate(pressure.begin(), pressure.end(), 0.0) * compliance_.grid().cell_area();
  for (double& p : pressure)
    p *= load / sum;
}

/// Next direction of descent.
/// @returns the step along it that makes the energy smallest
double ElasticContact::descend(bool conjugate, bool load_given, std::span<const double> pressure,
                               std::span<const double> gap)
{
  double norm = 0.0;
  for (std::size_t i = 0; i < gap.size(); ++i)
    if (pressure[i] > 0.0)
      norm += gap[i] * gap[i];
  const double beta = conjugate ? norm / norm_ : 0.0;
  norm_ = norm;
  for (std::size_t i = 0; i < gap.size(); ++i)
    direction_[i] = pressure[i] > 0.0 ? gap[i] + beta * direction_[i] : 0.0;
  compliance_.apply(direction_, image_, scratch_);
  const double mean = load_given ? mean_under(pressure, image_) : 0.0; // the approach takes it up
  double descent = 0.0;
  double curvature = 0.0;
  for (std::size_t i = 0; i < gap.size(); ++i)
  {
    descent += gap[i] * direction_[i];
    curvature += (image_[i] - mean) * direction_[i];
  }
  return curvature > 0.0 ? descent / curvature : 0.0;
}

Report ElasticContact::solve(std::span<const double> distance, const Drive& drive, double tolerance, int max_iterations,
                             std::span<double> pressure, std::span<double> gap, const std::function<bool()>& wants_stop)
{
  const bool load_given = drive.kind == Drive::Kind::load;
  if (load_given && !(drive.value > 0.0))
    return touching(distance, pressure, gap);
  start(distance, drive, pressure);
  std::fill(direction_.begin(), direction_.end(), 0.0);
  bool conjugate = false;
  Report report;
  report.approach = drive.value;
  constexpr int few = 8;
  for (;; ++report.iterations)
  {
    if (wants_stop && report.iterations % few == 0 && wants_stop())
      throw Interrupted();
    compliance_.apply(pressure, gap, scratch_);
    std::transform(gap.begin(), gap.end(), distance.begin(), gap.begin(), std::plus<>());
    if (load_given)
      report.approach = mean_under(pressure, gap);
    for (double& g : gap)
      g -= report.approach;
    measure(pressure, gap, report);
    report.converged =
        report.gap_error <= tolerance && report.penetration <= tolerance && std::isfinite(report.approach);
    if (report.converged || report.iterations == max_iterations)
      return report;

    const double step = descend(conjugate, load_given, pressure, gap);
    conjugate = true;
    const double relaxation = step > 0.0 ? step : 1.0 / compliance_.spectrum()[1];
    // Steps past zero pressure are cut; cells that overlap come (back) into contact, which restarts the directions.
    for (std::size_t i = 0; i < gap.size(); ++i)
    {
      if (pressure[i] > 0.0)
        pressure[i] = std::max(0.0, pressure[i] - step * direction_[i]);
      if (pressure[i] == 0.0 && gap[i] < 0.0)
      {
        pressure[i] = -relaxation * gap[i];
        conjugate = false;
      }
    }
    if (load_given)
    {
      if (!touches(pressure)) // everything was cut: begin anew
      {
        start(distance, drive, pressure);
        conjugate = false;
      }
      scale_to_load(drive.value, pressure);
    }
  }
}

} // namespace brinell::contact
