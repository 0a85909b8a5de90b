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

/// Intensity of wear under which the points of surfaces that may stick begin to slip [Pa].
std::vector<double> CoupledContact::wear_of_onset(const PartialSlip& partial) const
{
  const WearLaw& law = wear_->law();
  if (law.kind == WearLaw::Kind::energy)
    return partial.shear_of_onset();
  std::vector<double> onset = partial.pressure_of_onset(pressure_);
  if (law.kind != WearLaw::Kind::archard)
  {
    const std::vector<double> shear = partial.shear_of_onset();
    for (std::size_t i = 0; i < onset.size(); ++i)
      onset[i] = onset[i] > 0.0 ? law.intensity(onset[i], shear[i]) : 0.0;
  }
  return onset;
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
  const std::vector<double> onset = partial != nullptr ? wear_of_onset(*partial) : std::vector<double>{};
  return wear_->follow({.pressure = pressure_, .length = length, .shear = shear, .onset = onset});
}

} // namespace brinell::elastoplastic
