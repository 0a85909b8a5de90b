// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/elastic_contact.hpp"

#include "brinell/foundation/error.hpp"
#include "cell_sums.hpp"
#include "coarser_contact.hpp"
#include "foundation/require_size.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace brinell::contact
{

ElasticContact::ElasticContact(const halfspace::SurfaceCompliance& compliance)
    : compliance_(compliance), scratch_(compliance.make_scratch()), direction_(compliance.grid().size()),
      image_(compliance.grid().size()), displacement_(compliance.grid().size())
{
}

ElasticContact::~ElasticContact() = default;

namespace
{

bool touches(std::span<const double> pressure)
{
  return std::any_of(pressure.begin(), pressure.end(), [](double p) { return p > 0.0; });
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

/// Load or approach that is imposed. The displacement of bodies without ends is counted from their mean plane, so that the mean
/// gap is the mean distance less the approach, whatever the pressure.
Drive imposed(const Drive& drive, const SurfaceGrid& grid, std::span<const double> distance, double tolerance)
{
  const bool by_gap = drive.kind == Drive::Kind::mean_gap;
  if (by_gap && !(grid.is_periodic() && drive.value >= 0.0))
    throw InputError(fmt::format("contact: mean_gap = {:g} m; allowed: not below 0, of bodies that are periodic along "
                                 "both axes",
                                 drive.value));
  if (drive.kind == Drive::Kind::load || !grid.is_periodic())
    return drive;
  const double full = sum(distance) / static_cast<double>(distance.size());
  if (by_gap)
    return {Drive::Kind::approach, full - drive.value};
  if (drive.value > full + tolerance)
    throw InputError(
        fmt::format("contact of bodies that are periodic along both axes: approach = {:g} m; allowed: at most "
                    "the mean distance of the surfaces, {:g} m, at which all of them touches. Impose a load",
                    drive.value, full));
  return drive;
}

} // namespace

/// Nothing presses yet: the pressure of the contact on larger cells, on large grids.
void ElasticContact::guess(std::span<const double> distance, const Drive& drive, double tolerance,
                           std::span<double> pressure, const std::function<bool()>& wants_stop)
{
  if (touches(pressure) || !CoarserCells::helps(compliance_.grid()))
    return;
  if (!coarser_)
    coarser_ = std::make_unique<CoarserContact>(compliance_);
  coarser_->guess(distance, drive, tolerance, pressure, wants_stop);
}

/// A pressure to begin with: the guess, or if there is none the cells that overlap, at the stiffness against the most
/// compliant wave; under a load that has not pressed anything yet, the cell that touches first.
void ElasticContact::start(std::span<const double> distance, const Drive& drive, std::span<double> pressure)
{
  for (double& p : pressure)
    p = std::max(p, 0.0);
  const bool load_given = drive.kind == Drive::Kind::load;
  if (!touches(pressure))
  {
    const double stiffness = 1.0 / compliance_.largest();
    if (load_given)
      pressure[static_cast<std::size_t>(std::min_element(distance.begin(), distance.end()) - distance.begin())] = 1.0;
    else
      for (std::size_t i = 0; i < distance.size(); ++i)
        pressure[i] = std::max(0.0, drive.value - distance[i]) * stiffness;
  }
  if (load_given)
    scale_to_load(drive.value, std::accumulate(pressure.begin(), pressure.end(), 0.0), pressure);
}

/// The load made what it should be; `sum` is that of the pressure. The displacement keeps pace.
void ElasticContact::scale_to_load(double load, double sum, std::span<double> pressure)
{
  const double factor = load / (sum * compliance_.grid().cell_area());
  for_pieces(pressure.size(),
             [&](std::size_t first, std::size_t last)
             {
               for (std::size_t i = first; i < last; ++i)
               {
                 pressure[i] *= factor;
                 displacement_[i] *= factor;
               }
             });
}

/// Gap and errors of the displacement that is known.
Report ElasticContact::settle(std::span<const double> distance, const Drive& drive, std::span<const double> pressure,
                              std::span<double> gap) const
{
  const std::size_t cells = gap.size();
  const double* p = pressure.data();
  const double* u = displacement_.data();
  Report report;
  const auto under = [&](std::size_t first, std::size_t last) {
    return sum_under({first, last}, p, u, distance.data());
  };
  const double approach = drive.kind == Drive::Kind::load ? sum_of_pieces(cells, under).mean() : drive.value;
  const auto close = [&](std::size_t first, std::size_t last)
  {
    for (std::size_t i = first; i < last; ++i)
      gap[i] = u[i] + distance[i] - approach;
    return errors_of({first, last}, p, gap.data());
  };
  const Errors errors = sum_of_pieces(cells, close);
  report.approach = approach;
  report.gap_error = errors.gap;
  report.penetration = errors.penetration;
  return report;
}

/// Of the bodies, and of a layer between them.
void ElasticContact::displace(std::span<const double> pressure, std::span<double> out)
{
  compliance_.apply({.pressure = pressure}, {.z = out}, scratch_);
  for (std::size_t i = 0; i < layer_.size(); ++i)
    out[i] += layer_[i] * pressure[i];
}

/// Next direction of descent, and its image.
/// @param slope  before: of the iteration before, 0 to begin anew; after: of this one
/// @returns the step along it that makes the energy smallest
double ElasticContact::descend(double& slope, bool load_given, std::span<const double> pressure,
                               std::span<const double> gap)
{
  const double* p = pressure.data();
  const double* g = gap.data();
  double* d = direction_.data();
  double* wanted = image_.data();
  for_pieces(gap.size(),
             [&](std::size_t first, std::size_t last)
             {
               for (std::size_t i = first; i < last; ++i)
                 wanted[i] = is_free(p[i], g[i]) ? g[i] : 0.0;
             });
  compliance_.apply_inverse(image_, image_, scratch_);
  const Slopes slopes = sum_of_pieces(gap.size(),
                                      [&](std::size_t first, std::size_t last) {
                                        return slopes_of({first, last}, p, g, wanted, d);
                                      });
  // A given load stays as it is: the mean over the free cells is taken off.
  const double share = load_given && slopes.count > 0.0 ? 1.0 / slopes.count : 0.0;
  const double new_slope = slopes.wanted_descent - share * slopes.wanted * slopes.gap;
  const double before = slopes.before_descent - share * slopes.before * slopes.gap;
  double beta = slope > 0.0 ? new_slope / slope : 0.0;
  if (!(new_slope + beta * before > 0.0)) // other cells are free now: the directions begin anew
    beta = 0.0;
  const double mean = share * (slopes.wanted + beta * slopes.before);
  for_pieces(gap.size(),
             [&](std::size_t first, std::size_t last)
             {
               for (std::size_t i = first; i < last; ++i)
                 d[i] = is_free(p[i], g[i]) ? wanted[i] + beta * d[i] - mean : 0.0;
             });
  displace(direction_, image_);
  const double curvature = dot(direction_, image_);
  slope = new_slope;
  return curvature > 0.0 ? (new_slope + beta * before) / curvature : 0.0;
}

/// Takes the step, with the displacement as far as the image gives it. Steps past zero pressure are cut.
ElasticContact::Step ElasticContact::advance(double step, std::span<const double> gap, std::span<double> pressure)
{
  const auto taken_here = [&](std::size_t first, std::size_t last)
  {
    return taken({first, last}, step, gap.data(), direction_.data(), image_.data(), pressure.data(),
                 displacement_.data());
  };
  const Taken sums = sum_of_pieces(gap.size(), taken_here);
  return {sums.cut > 0.0, sums.pressure};
}

Report ElasticContact::solve(std::span<const double> distance, const Drive& given, double tolerance, int max_iterations,
                             std::span<double> pressure, std::span<double> gap, const std::function<bool()>& wants_stop,
                             std::span<const double> layer)
{
  const std::size_t cells = compliance_.grid().size();
  require_size("ElasticContact::solve: the distance", distance, cells);
  require_size("ElasticContact::solve: the pressure", pressure, cells);
  require_size("ElasticContact::solve: the gap", gap, cells);
  if (!layer.empty())
    require_size("ElasticContact::solve: the layer", layer, cells);
  layer_ = layer;
  const Drive drive = imposed(given, compliance_.grid(), distance, tolerance);
  if (drive.kind == Drive::Kind::load && !(drive.value > 0.0))
    return touching(distance, pressure, gap);
  const Problem problem{distance, drive, tolerance, max_iterations, wants_stop};
  return given.kind == Drive::Kind::mean_gap && !layer.empty() ? keep_gap(problem, pressure, gap)
                                                               : iterate(problem, pressure, gap);
}

/// The conjugate gradients, under a load or an approach.
Report ElasticContact::iterate(const Problem& problem, std::span<double> pressure, std::span<double> gap)
{
  const auto& [distance, drive, tolerance, max_iterations, wants_stop] = problem;
  const bool load_given = drive.kind == Drive::Kind::load;
  guess(distance, drive, tolerance, pressure, wants_stop);
  start(distance, drive, pressure);
  std::fill(direction_.begin(), direction_.end(), 0.0);
  const auto is_good = [most = tolerance](const Report& r)
  { return r.gap_error <= most && r.penetration <= most && std::isfinite(r.approach); };
  constexpr int few = 8;   // iterations between questions whether to stop
  constexpr int many = 32; // and at most between two products with the pressure itself: rounding does not pile up
  int followed = many;     // steps that the displacement has followed since the last of these; `many`: it has not
  double slope = 0.0;      // of the last direction, without the ones before it
  int products = 0;
  for (int iteration = 0;; ++iteration)
  {
    if (wants_stop && iteration % few == 0 && wants_stop())
      throw Interrupted();
    const bool is_last = iteration == max_iterations;
    bool is_exact = followed >= many || is_last;
    Report report;
    if (!is_exact)
    {
      report = settle(distance, drive, pressure, gap);
      is_exact = is_good(report); // to be told apart from what rounding has made of it
    }
    if (is_exact)
    {
      displace(pressure, displacement_);
      followed = 0;
      ++products;
      report = settle(distance, drive, pressure, gap);
    }
    report.iterations = iteration;
    report.products = products;
    report.converged = is_good(report);
    if (report.converged || is_last)
      return report;

    ++products;
    const double step = descend(slope, load_given, pressure, gap);
    const Step done = advance(step, gap, pressure);
    followed = done.cut ? many : followed + 1;
    if (load_given && done.sum > 0.0)
      scale_to_load(drive.value, done.sum, pressure);
    else if (load_given) // everything was cut: begin anew
    {
      start(distance, drive, pressure);
      slope = 0.0;
    }
  }
}

} // namespace brinell::contact
