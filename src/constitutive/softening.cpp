// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/constitutive/softening.hpp"

#include "between_points.hpp"
#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::constitutive
{

namespace
{

/// (T - reference)/(melting - reference), clamped to [0, 1].
double homologous(double temperature, double reference, double melting)
{
  return std::clamp((temperature - reference) / (melting - reference), 0.0, 1.0);
}

} // namespace

double LinearSoftening::factor(double temperature) const
{
  return 1.0 - homologous(temperature, reference, melting_point);
}

double JohnsonCookSoftening::factor(double temperature) const
{
  return 1.0 - std::pow(homologous(temperature, reference, melting_point), exponent);
}

TabulatedSoftening::TabulatedSoftening(std::vector<double> temperature, std::vector<double> factor)
    : temperature_(std::move(temperature)), factor_(std::move(factor))
{
  if (temperature_.empty() || temperature_.size() != factor_.size())
    throw InputError(fmt::format("a table of softening needs one factor for each temperature, at least one; it has {} "
                                 "temperatures and {} factors",
                                 temperature_.size(), factor_.size()));
  for (std::size_t i = 0; i < factor_.size(); ++i)
  {
    if (!std::isfinite(temperature_[i]) || !(factor_[i] > 0.0) || !std::isfinite(factor_[i]))
      throw InputError(
          fmt::format("point {} of a table of softening is not a factor > 0 at a finite temperature", i + 1));
    if (i > 0 && !(temperature_[i] > temperature_[i - 1]))
      throw InputError(fmt::format("the temperatures of a table of softening must ascend; {:g} degC follows {:g} degC",
                                   temperature_[i], temperature_[i - 1]));
  }
}

double TabulatedSoftening::factor(double temperature) const
{
  return between_points(temperature_, factor_, temperature);
}

double softening_factor(const SofteningLaw& law, double temperature)
{
  return std::max(least_softening_factor, std::visit([&](const auto& of) { return of.factor(temperature); }, law));
}

std::optional<double> melting_temperature(const SofteningLaw& law)
{
  return std::visit([](const auto& of) { return of.melting(); }, law);
}

bool covers(const SofteningLaw& law, double temperature)
{
  const auto* table = std::get_if<TabulatedSoftening>(&law);
  return !table || (table->first() <= temperature && temperature <= table->last());
}

} // namespace brinell::constitutive
