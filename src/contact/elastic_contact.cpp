// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/elastic_contact.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/symmetry.hpp"
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

/// Solution without load: the surfaces just touch.
Report without_load(std::span<const double> distance, std::span<double> pressure, std::span<double> gap)
{
  Report report;
  report.converged = true;
  report.approach = *std::min_element(distance.begin(), distance.end());
  std::fill(pressure.begin(), pressure.end(), 0.0);
  std::transform(distance.begin(), distance.end(), gap.begin(), [&](double d) { return d - report.approach; });
  return report;
}

/// The imposed load or approach. The displacement of bodies that are periodic along both axes is relative to their mean plane, so
/// the mean gap is the mean distance minus the approach, for any pressure.
Drive imposed(const Drive& drive, const SurfaceGrid& grid, std::span<const double> distance, double tolerance)
{
  const bool by_gap = drive.kind == Drive::Kind::mean_gap;
  if (by_gap && !(grid.is_periodic() && drive.value >= 0.0))
    throw InputError(
        fmt::format("contact: mean_gap = {:g} m; allowed: >= 0, and only for bodies that are periodic along both axes",
                    drive.value));
  if (drive.kind == Drive::Kind::load || !grid.is_periodic())
    return drive;
  const double full = sum(distance) / static_cast<double>(distance.size());
  if (by_gap)
    return {Drive::Kind::approach, full - drive.value};
  if (drive.value > full + tolerance)
    throw InputError(
        fmt::format("contact of bodies that are periodic along both axes: approach = {:g} m; allowed: at most the mean "
                    "distance of the surfaces, {:g} m, at which they touch everywhere. Impose a load instead",
                    drive.value, full));
  return drive;
}

} // namespace

/// If the pressure is zero everywhere: on large grids, takes the pressure of the contact on larger cells as a guess.
void ElasticContact::guess(std::span<const double> distance, const Drive& drive, double tolerance,
                           std::span<double> pressure, const std::function<bool()>& wants_stop)
{
  if (touches(pressure.first(cells())) || !CoarserCells::helps(compliance_.grid()))
    return;
  if (!coarser_)
    coarser_ = std::make_unique<CoarserContact>(compliance_);
  coarser_->guess(distance, drive, tolerance, pressure, wants_stop);
}

/// Initial pressure: the guess if it is not zero. Otherwise, for an imposed approach, the overlap divided by the largest
/// compliance of a wave; for an imposed load, a pressure on the cell that touches first.
void ElasticContact::start(std::span<const double> distance, const Drive& drive, std::span<double> pressure)
{
  for (double& p : pressure)
    p = std::max(p, 0.0);
  const bool load_given = drive.kind == Drive::Kind::load;
  if (!touches(pressure.first(cells())))
  {
    const double stiffness = 1.0 / compliance_.largest();
    if (load_given) // on the side that is solved: rounding may make its mirror image the first
    {
      const std::span<const double> side = distance.first(cells());
      pressure[static_cast<std::size_t>(std::min_element(side.begin(), side.end()) - side.begin())] = 1.0;
    }
    else
      for (std::size_t i = 0; i < distance.size(); ++i)
        pressure[i] = std::max(0.0, drive.value - distance[i]) * stiffness;
  }
  if (load_given)
    scale_to_load(drive.value, sum(compliance_.grid(), pressure), pressure);
}

/// Scales the pressure, whose sum is `sum`, to the imposed load, and the displacement with it.
void ElasticContact::scale_to_load(double load, double sum, std::span<double> pressure)
{
  const double factor = load / (sum * compliance_.grid().cell_area());
  for_pieces(cells(),
             [&](std::size_t first, std::size_t last)
             {
               for (std::size_t i = first; i < last; ++i)
               {
                 pressure[i] *= factor;
                 displacement_[i] *= factor;
               }
             });
}

/// Gap and errors from the current displacement.
Report ElasticContact::evaluate(std::span<const double> distance, const Drive& drive, std::span<const double> pressure,
                                std::span<double> gap) const
{
  const double* p = pressure.data();
  const double* u = displacement_.data();
  Report report;
  const auto pressed = [&](std::size_t first, std::size_t last) {
    return sum_of_pressed({first, last}, p, u, distance.data());
  };
  const double approach = drive.kind == Drive::Kind::load ? sum_over(compliance_.grid(), pressed).mean() : drive.value;
  const auto close = [&](std::size_t first, std::size_t last)
  {
    for (std::size_t i = first; i < last; ++i)
      gap[i] = u[i] + distance[i] - approach;
    return errors_of({first, last}, p, gap.data());
  };
  const Errors errors = sum_of_pieces(cells(), close);
  report.approach = approach;
  report.gap_error = errors.gap;
  report.penetration = errors.penetration;
  return report;
}

/// Displacement by a pressure: of the bodies, and of a layer between them.
void ElasticContact::displace(std::span<const double> pressure, std::span<double> out)
{
  compliance_.apply({.pressure = pressure}, {.z = out}, scratch_);
  for (std::size_t i = 0; i < (layer_.empty() ? 0 : cells()); ++i)
    out[i] += layer_[i] * pressure[i];
}

/// Computes the next search direction and its image.
/// @param slope  in: that of the previous iteration, 0 to restart; out: that of this iteration
/// @returns the step along the direction that minimises the energy
double ElasticContact::descend(double& slope, bool load_given, std::span<const double> pressure,
                               std::span<const double> gap)
{
  const double* p = pressure.data();
  const double* g = gap.data();
  double* d = direction_.data();
  double* correction = image_.data();
  for_pieces(cells(),
             [&](std::size_t first, std::size_t last)
             {
               for (std::size_t i = first; i < last; ++i)
                 correction[i] = is_free(p[i], g[i]) ? g[i] : 0.0;
             });
  compliance_.apply_inverse(image_, image_, scratch_);
  const Slopes slopes = sum_over(compliance_.grid(),
                                 [&](std::size_t first, std::size_t last) {
                                   return slopes_of({first, last}, p, g, correction, d);
                                 });
  const auto [new_slope, along, beta, mean] = descent_of(slopes, slope, load_given);
  for_pieces(cells(),
             [p, g, d, correction, beta = beta, mean = mean](std::size_t first, std::size_t last)
             {
#pragma omp simd
               for (std::size_t i = first; i < last; ++i)
                 d[i] = is_free(p[i], g[i]) ? correction[i] + beta * d[i] - mean : 0.0;
             });
  displace(direction_, image_);
  const double curvature = brinell::dot(compliance_.grid(), direction_, image_);
  slope = new_slope;
  return curvature > 0.0 ? along / curvature : 0.0;
}

/// Takes the step and updates the displacement by the image, which is exact only if no pressure is cut off at zero.
ElasticContact::Step ElasticContact::advance(double step, std::span<const double> gap, std::span<double> pressure)
{
  const auto step_piece = [&](std::size_t first, std::size_t last)
  {
    return take_step({first, last}, step, gap.data(), direction_.data(), image_.data(), pressure.data(),
                     displacement_.data());
  };
  const StepSums sums = sum_over(compliance_.grid(), step_piece);
  return {sums.cut > 0.0, sums.pressure};
}

Report ElasticContact::solve(std::span<const double> distance, const Drive& given, double tolerance, int max_iterations,
                             std::span<double> pressure, std::span<double> gap, const std::function<bool()>& wants_stop,
                             std::span<const double> layer)
{
  const std::size_t all = compliance_.grid().size();
  require_size("ElasticContact::solve: the distance", distance, all);
  require_size("ElasticContact::solve: the pressure", pressure, all);
  require_size("ElasticContact::solve: the gap", gap, all);
  if (!layer.empty())
    require_size("ElasticContact::solve: the layer", layer, all);
  layer_ = layer;
  const Drive drive = imposed(given, compliance_.grid(), distance, tolerance);
  if (drive.kind == Drive::Kind::load && !(drive.value > 0.0))
    return without_load(distance, pressure, gap);
  const Problem problem{distance, drive, tolerance, max_iterations, wants_stop};
  const Report report = given.kind == Drive::Kind::mean_gap && !layer.empty() ? solve_mean_gap(problem, pressure, gap)
                                                                              : iterate(problem, pressure, gap);
  if (compliance_.grid().is_mirrored_y)
    for (const std::span<double>& field : {pressure, gap})
      complete_in_y(compliance_.grid(), 1.0, field.data(), field.size());
  return report;
}

/// The conjugate gradients, under a load or an approach.
Report ElasticContact::iterate(const Problem& problem, std::span<double> pressure, std::span<double> gap)
{
  const auto& [distance, drive, tolerance, max_iterations, wants_stop] = problem;
  const bool load_given = drive.kind == Drive::Kind::load;
  guess(distance, drive, tolerance, pressure, wants_stop);
  if (device_ && layer_.empty())
    return device_->solve(distance, drive, tolerance, max_iterations, pressure, gap, wants_stop);
  start(distance, drive, pressure);
  std::fill(direction_.begin(), direction_.end(), 0.0);
  const auto is_good = [most = tolerance](const Report& r)
  { return r.gap_error <= most && r.penetration <= most && std::isfinite(r.approach); };
  constexpr int few = 8; // iterations between calls of `wants_stop`
  // Most iterations between two products with the pressure itself, which limits rounding errors.
  constexpr int many = 32;
  int followed = many; // updates of the displacement since the last such product; `many`: the displacement is not valid
  double slope = 0.0;  // of the preconditioned gap in the last iteration; 0: restart
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
      report = evaluate(distance, drive, pressure, gap);
      is_exact = is_good(report); // confirm convergence without the rounding errors of the updates
    }
    if (is_exact)
    {
      displace(pressure, displacement_);
      followed = 0;
      ++products;
      report = evaluate(distance, drive, pressure, gap);
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
    else if (load_given) // all pressures were cut off: restart
    {
      start(distance, drive, pressure);
      slope = 0.0;
    }
  }
}

} // namespace brinell::contact
