// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/increment.hpp"

#include <cmath>
#include <vector>

/// Wear in an increment: docs/theory/elastoplastic.md (wear).
namespace brinell::elastoplastic
{

/// For surfaces that slide everywhere the slip length is known at the start; for surfaces that may stick it follows from the
/// solution.
void CoupledContact::begin_wear()
{
  const PartialSlip* partial = partial_slip();
  wear_->begin(partial != nullptr ? partial->pressure_before() : pressure_);
  if (partial == nullptr)
    static_cast<void>(follow_wear());
}

/// Computes the wear by the slip of the trial.
/// @returns the largest change of the gap by wear [m]
double CoupledContact::follow_wear()
{
  const PartialSlip* partial = partial_slip();
  const std::vector<double> length =
      partial != nullptr ? partial->slipped() : std::vector<double>(pressure_.size(), slid_);
  std::vector<double> shear(pressure_.size());
  if (interface_)
    for (const std::span<const double>& part : interface_->shears())
      for (std::size_t i = 0; i < part.size(); ++i)
        shear[i] = std::hypot(shear[i], part[i]);
  std::vector<double> onset;
  if (partial != nullptr)
    onset =
        wear_->law().kind == WearLaw::Kind::archard ? partial->pressure_of_onset(pressure_) : partial->shear_of_onset();
  return wear_->follow({.pressure = pressure_, .length = length, .shear = shear, .onset = onset});
}

} // namespace brinell::elastoplastic
