// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/tangential_contact.hpp"

#include "brinell/foundation/error.hpp"
#include "coarser_tangential.hpp"
#include "foundation/require_size.hpp"
#include "foundation/sharing.hpp"
#include "tangential_iteration.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::contact
{

TangentialContact::TangentialContact(const halfspace::SurfaceCompliance& compliance)
    : compliance_(compliance), iteration_(std::make_unique<Iteration>(compliance))
{
}

TangentialContact::~TangentialContact() = default;

namespace
{

void require_pair(const char* name, const ConstAlongSurface& pair, std::size_t cells)
{
  for (const std::span<const double>& part : pair)
    require_size(name, part, cells);
}

void require_bound(std::span<const double> bound)
{
  const auto wrong = std::find_if(bound.begin(), bound.end(), [](double g) { return !(g >= 0.0) || std::isinf(g); });
  if (wrong != bound.end())
    throw InputError(
        fmt::format("tangential contact: the bound of the shear is {:g} Pa in cell {}; allowed: finite, not "
                    "below 0",
                    *wrong, wrong - bound.begin()));
}

void require_finite(const TangentialDrive& drive)
{
  if (!std::isfinite(drive.x.value) || !std::isfinite(drive.y.value) || !std::isfinite(drive.spin))
    throw InputError(fmt::format("tangential contact: {:g} along x, {:g} along y, a spin of {:g}; allowed: finite",
                                 drive.x.value, drive.y.value, drive.spin));
}

/// @param carried  largest force that the contact can carry: the integral of the bound [N]
void require_force_below(double carried, const TangentialDrive& drive)
{
  const auto force = [](const TangentialDrive::Axis& axis)
  { return axis.kind == TangentialDrive::Kind::force ? axis.value : 0.0; };
  const double size = std::hypot(force(drive.x), force(drive.y));
  // Relative margin: closer to gross sliding, sticking cells cannot be identified because of rounding.
  constexpr double margin = 1e-9;
  const bool is_forced = drive.x.kind == TangentialDrive::Kind::force || drive.y.kind == TangentialDrive::Kind::force;
  if (is_forced && !(size < (1.0 - margin) * carried) && size > 0.0)
    throw InputError(fmt::format("tangential contact: a force of {:g} N along the surface; allowed: below {:g} N, the "
                                 "sum of the bound, at which the whole contact slides. Impose a shift instead",
                                 size, carried));
}

/// Recovers from a step that has increased the energy.
/// @param is_repeated  whether a recent step has, too: returning part of the way could then cycle forever, where a few cells have
///          to
///                     cross their disc and the projection on its edge increases the energy by more than the step has decreased
///                     it
/// @returns whether the displacement is only approximately that of the shears, because it was interpolated and not recomputed
template <typename Iteration>
bool recover_descent(Iteration& it, bool is_repeated)
{
  if (!is_repeated && it.retreat())
    return true;
  if (is_repeated)
  {
    it.move_worst();
    it.displace();
    if (it.has_descended())
      return false;
  }
  it.follow_gradient();
  it.displace();
  return false;
}

} // namespace

/// On large grids, improves the guess by solving the same step on larger cells.
void TangentialContact::improve_guess(const TangentialStep& step, double tolerance, TangentialReport& report,
                                      const AlongSurface& shear, const std::function<bool()>& wants_stop)
{
  Iteration& it = *iteration_;
  it.save();
  it.evaluate(report);
  if (!(report.slip_error > CoarserTangential::worth * tolerance) || !CoarserCells::helps(compliance_.grid()))
    return;
  if (!coarser_)
    coarser_ = std::make_unique<CoarserTangential>(compliance_);
  if (!coarser_->guess(step, tolerance, shear, wants_stop))
    return;
  it.restart({shear[0], shear[1]});
  if (!it.has_descended())
    it.restore_saved();
  it.save();
}

TangentialReport TangentialContact::solve(const TangentialStep& step, double tolerance, int max_iterations,
                                          const AlongSurface& shear, const AlongSurface& slip,
                                          const std::function<bool()>& wants_stop)
{
  Iteration& it = *iteration_;
  require_size("TangentialContact::solve: the bound", step.bound, it.grid().size());
  require_pair("TangentialContact::solve: the shear", {shear[0], shear[1]}, it.grid().size());
  require_pair("TangentialContact::solve: the slip", {slip[0], slip[1]}, it.grid().size());
  if (!step.before[0].empty() || !step.before[1].empty())
    require_pair("TangentialContact::solve: the shear before", step.before, it.grid().size());
  if (!step.change[0].empty() || !step.change[1].empty())
    require_pair("TangentialContact::solve: the change of displacement", step.change, it.grid().size());
  for (const std::span<const double>& part : step.entry)
    if (!part.empty())
      require_size("TangentialContact::solve: the compliance on entry", part, it.grid().size());
  require_bound(step.bound);
  require_finite(step.drive);
  require_force_below(sum(step.bound) * compliance_.grid().cell_area(), step.drive);

  constexpr int few = 8; // iterations between calls of `wants_stop`
  // Most iterations between two products with the shears themselves, which limits rounding errors.
  constexpr int many = 32;
  it.start(step, shear);
  TangentialReport report;
  improve_guess(step, tolerance, report, shear, wants_stop);
  constexpr int soon = 16; // number of iterations after a retreat within which another one indicates a cycle
  int retreated = -soon;   // iteration of the last retreat
  bool is_known = true;    // whether the displacement is that of the shears, up to rounding
  for (int followed = 0;; ++report.iterations)
  {
    if (wants_stop && report.iterations % few == 0 && wants_stop())
      throw Interrupted();
    const bool is_last = report.iterations == max_iterations;
    if (is_known)
      it.evaluate(report);
    if (!is_known || (followed > 0 && (report.slip_error <= tolerance || is_last || followed >= many)))
    {
      it.restore_bounds();
      it.displace();
      followed = 0;
      if (!it.has_descended() && !is_last)
      {
        ++report.retreats;
        followed = recover_descent(it, report.iterations - retreated < soon) ? 1 : 0;
        retreated = report.iterations;
      }
      it.evaluate(report);
      it.save();
    }
    report.converged = report.slip_error <= tolerance && followed == 0;
    if (report.converged || is_last)
      break;
    is_known = it.advance(it.find_direction(), report.slip_error);
    ++followed;
  }
  it.finish(report, shear, slip);
  return report;
}

} // namespace brinell::contact
