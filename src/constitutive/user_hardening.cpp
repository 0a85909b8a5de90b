// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/constitutive/user_hardening.hpp"

#include "brinell/foundation/error.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace brinell::constitutive
{

namespace
{

struct Functions
{
  std::function<double(double)> yield_stress, modulus;

  [[nodiscard]] double yield_stress_at(double e) const { return yield_stress(e); }
  [[nodiscard]] double modulus_at(double e) const { return modulus(e); }
};

} // namespace

double integrated_work(const std::function<double(double)>& yield_stress, double e)
{
  constexpr int parts = 24;
  constexpr std::array nodes{0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
  constexpr std::array weights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
  double sum = 0.0;
  double from = 0.0;
  for (int part = 1; part <= parts; ++part)
  {
    const double share = static_cast<double>(part) / parts;
    const double to = e * share * share * share;
    const double middle = 0.5 * (from + to);
    const double half = 0.5 * (to - from);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      sum += weights[i] * half * (yield_stress(middle - half * nodes[i]) + yield_stress(middle + half * nodes[i]));
    from = to;
  }
  return sum;
}

UserHardening::UserHardening(std::function<double(double)> yield_stress, std::function<double(double)> modulus)
    : UserHardening(Functions{std::move(yield_stress), std::move(modulus)})
{
}

/// Checks the law at some strains: not a proof of validity, but it detects the most frequent errors.
void UserHardening::require_valid() const
{
  double before = 0.0;
  for (const double e : {0.0, 1e-6, 1e-5, 1e-4, 1e-3, 2e-3, 5e-3, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0})
  {
    const double stress = yield_stress_at(e);
    const double modulus = modulus_at(e);
    if (!(stress > 0.0) || !std::isfinite(stress))
      throw InputError(fmt::format("a hardening law has the yield stress {:g} Pa at the plastic strain {:g}; allowed: "
                                   "> 0",
                                   stress, e));
    if (stress < before)
      throw InputError(fmt::format("a hardening law falls to the yield stress {:g} Pa at the plastic strain {:g}; "
                                   "allowed: never (softening is not modelled)",
                                   stress, e));
    if (!(modulus >= 0.0) || (e > 0.0 && !std::isfinite(modulus)))
      throw InputError(fmt::format("a hardening law has the slope {:g} Pa at the plastic strain {:g}; allowed: >= 0, "
                                   "infinite at 0 only",
                                   modulus, e));
    before = stress;
  }
}

} // namespace brinell::constitutive
