// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/forecast.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/processor.hpp"
#include "forecast_constants.hpp"
#include "foundation/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

namespace brinell::simulation
{

namespace
{

/// Time with the instructions that the engine uses over that with AVX-512, for which the constants are measured:
/// docs/performance.md.
double slowness()
{
  constexpr double avx2 = 1.4, baseline = 2.0;
  const std::string used = chosen_processor();
  if (used == "x86-64-v4" || used == "native")
    return used == "native" && lane_count < 8 ? (lane_count == 4 ? avx2 : baseline) : 1.0;
  return used == "x86-64-v3" ? avx2 : baseline;
}

/// The measured constant of a factor or an amount.
template <typename Constants>
double constant_of(const Constants& constants, std::size_t index, std::string_view name)
{
  if (index >= constants.size() || constants[index].name != name)
    throw InternalError(fmt::format("no constant was measured for \"{}\": bench/forecast.py", name));
  return constants[index].value;
}

} // namespace

Forecast forecast(const Workload& work)
{
  double exponent = 0.0;
  for (std::size_t i = 0; i < work.factors.size(); ++i)
    exponent += constant_of(measured::of_factors, i, work.factors[i].name) * work.factors[i].value;
  Forecast forecast;
  forecast.evaluations = work.steps * std::max(work.fewest_evaluations, std::exp(exponent));
  const double slower = slowness();
  for (std::size_t i = 0; i < work.amounts.size(); ++i)
  {
    const Amount& amount = work.amounts[i];
    forecast.seconds += slower * constant_of(measured::of_amounts, i, amount.name) *
                        (amount.of_run + amount.of_evaluation * forecast.evaluations);
  }
  const double spread = measured::spread[static_cast<std::size_t>(work.certainty)];
  forecast.shortest = forecast.seconds / spread;
  forecast.longest = forecast.seconds * spread;
  return forecast;
}

} // namespace brinell::simulation
