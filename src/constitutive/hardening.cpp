// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/constitutive/hardening.hpp"

#include "brinell/foundation/error.hpp"

#include <fmt/format.h>

namespace brinell::constitutive
{

namespace
{

void require_valid(const std::vector<double>& strain, const std::vector<double>& stress)
{
  if (strain.empty() || strain.size() != stress.size())
    throw InputError(fmt::format("a hardening table needs as many stresses as plastic strains, at least one; it has {} "
                                 "strains and {} stresses",
                                 strain.size(), stress.size()));
  if (strain.front() != 0.0)
    throw InputError(fmt::format("a hardening table must begin at plastic strain 0, not {:g}", strain.front()));
  for (std::size_t i = 0; i < strain.size(); ++i)
  {
    if (!(stress[i] > 0.0) || !std::isfinite(stress[i]) || !std::isfinite(strain[i]))
      throw InputError(fmt::format("point {} of a hardening table, {:g} Pa at {:g}, is not a stress above 0", i + 1,
                                   stress[i], strain[i]));
    if (i > 0 && !(strain[i] > strain[i - 1]))
      throw InputError(fmt::format("the plastic strains of a hardening table must ascend; {:g} follows {:g}", strain[i],
                                   strain[i - 1]));
    if (i > 0 && stress[i] < stress[i - 1])
      throw InputError(
          fmt::format("the stresses of a hardening table must not fall; point {}, {:g} Pa, follows {:g} Pa "
                      "(softening is not modelled)",
                      i + 1, stress[i], stress[i - 1]));
  }
}

} // namespace

TabulatedHardening::TabulatedHardening(std::vector<double> plastic_strain, std::vector<double> stress)
    : strain_(std::move(plastic_strain)), stress_(std::move(stress))
{
  require_valid(strain_, stress_);
  work_.push_back(0.0);
  for (std::size_t i = 1; i < strain_.size(); ++i)
  {
    const double width = strain_[i] - strain_[i - 1];
    modulus_.push_back((stress_[i] - stress_[i - 1]) / width);
    work_.push_back(work_.back() + 0.5 * (stress_[i] + stress_[i - 1]) * width);
  }
  modulus_.push_back(0.0);
}

} // namespace brinell::constitutive
