// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/frictional_contact.hpp"

#include "brinell/foundation/error.hpp"
#include "carried_field.hpp"
#include "entry_compliance.hpp"
#include "foundation/require_size.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::contact
{

FrictionalContact::FrictionalContact(const halfspace::SurfaceCompliance& pair)
    : pair_(pair), scratch_(pair.make_scratch()), normal_(pair), tangential_(pair),
      entry_(std::make_unique<EntryCompliance>(pair)), pressure_before_(pair.grid().size()), bound_(pair.grid().size()),
      distance_(bound_.size()), lowered_(bound_.size()), lowered_before_(bound_.size()), pressure_added_(bound_.size()),
      pulled_x_(bound_.size()), pulled_y_(bound_.size())
{
}

FrictionalContact::~FrictionalContact() = default;

/// Computes the displacement along z by the shears.
/// @returns its largest change since the previous call [m]
double FrictionalContact::gap_change()
{
  double change = 0.0;
  for (std::size_t i = 0; i < lowered_.size(); ++i)
    change = std::max(change, std::abs(lowered_[i] - lowered_before_[i]));
  return change;
}

/// Computes the displacement along the surface by the pressure added in this step.
void FrictionalContact::couple(const FrictionState& state)
{
  for (std::size_t i = 0; i < bound_.size(); ++i)
    pressure_added_[i] = state.pressure[i] - pressure_before_[i];
  pair_.apply({.pressure = pressure_added_}, {.x = pulled_x_, .y = pulled_y_}, scratch_);
}

FrictionReport FrictionalContact::step(std::span<const double> distance, const Drive& normal,
                                       const TangentialDrive& tangential, double friction,
                                       const FrictionTolerances& tolerances, FrictionState& state,
                                       std::span<double> gap, const AlongSurface& slip,
                                       const std::function<bool()>& wants_stop, const std::array<int, 2>& carried)
{
  require_size("FrictionalContact::step: the distance", distance, bound_.size());
  require_size("FrictionalContact::step: the pressure before", state.pressure, bound_.size());
  require_size("FrictionalContact::step: the shear before along x", state.shear_x, bound_.size());
  require_size("FrictionalContact::step: the shear before along y", state.shear_y, bound_.size());
  if (!(friction >= 0.0) || std::isinf(friction))
    throw InputError(fmt::format("friction = {:g}; allowed: finite, not below 0", friction));
  carry(pair_.grid(), carried, state.pressure, pressure_before_);
  shear_x_before_ = state.shear_x;
  shear_y_before_ = state.shear_y;
  const bool couples = pair_.couples();
  const auto lower = [&]
  { pair_.apply({.shear_x = state.shear_x, .shear_y = state.shear_y}, {.z = lowered_}, scratch_); };
  std::fill(lowered_.begin(), lowered_.end(), 0.0);
  if (couples)
    lower();
  TangentialStep step;
  step.bound = bound_;
  step.before = {shear_x_before_, shear_y_before_};
  step.drive = tangential;
  step.carried = carried;
  if (couples)
    step.change = {pulled_x_, pulled_y_};

  FrictionReport report;
  while (!report.converged && report.alternations < tolerances.max_alternations)
  {
    ++report.alternations;
    std::transform(distance.begin(), distance.end(), lowered_.begin(), distance_.begin(), std::plus{});
    report.normal =
        normal_.solve(distance_, normal, tolerances.gap, tolerances.max_iterations, state.pressure, gap, wants_stop);
    std::transform(state.pressure.begin(), state.pressure.end(), bound_.begin(),
                   [&](double p) { return friction * p; });
    entry_->find(carried, pressure_before_, state.pressure, gap);
    step.entry = entry_->fields();
    if (couples)
      couple(state);
    report.tangential = tangential_.solve(step, tolerances.slip, tolerances.max_iterations,
                                          {state.shear_x, state.shear_y}, slip, wants_stop);
    if (!report.normal.converged || !report.tangential.converged)
      break;
    if (couples)
    {
      std::swap(lowered_, lowered_before_);
      lower();
      report.gap_change = gap_change();
      for (std::size_t i = 0; i < gap.size(); ++i)
        gap[i] += lowered_[i] - lowered_before_[i];
    }
    report.converged = report.gap_change <= tolerances.gap;
  }
  for (std::size_t axis = 0; axis < 2; ++axis)
    state.shift[axis] += report.tangential.shift[axis];
  state.spin += tangential.spin;
  state.dissipated += report.tangential.dissipated;
  return report;
}

} // namespace brinell::contact
