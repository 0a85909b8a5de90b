// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/elastic_tugging.hpp"

#include "reference/bisection.hpp"
#include "reference/require.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::reference
{
namespace
{

double radii(const ElasticTugging& t)
{
  return t.radius_lower + t.radius_upper;
}

/// R1 + R2 - omega' without the cancellation of two lengths that differ by an interference: omega' - omega is
/// X^2/(omega' + omega).
double interference_at(const ElasticTugging& t, double X)
{
  const double omega = radii(t) - t.interference;
  return std::max(t.interference - X * X / (std::hypot(omega, X) + omega), 0.0);
}

/// 4/3 E' sqrt(R), 1/R = 1/R1 + 1/R2.
double hertz_factor(const ElasticTugging& t)
{
  return 4.0 / 3.0 * t.contact_modulus * std::sqrt(t.radius_lower * t.radius_upper / radii(t));
}

double energy(const ElasticTugging& t, double X)
{
  const double alpha = interference_at(t, X);
  return 0.4 * hertz_factor(t) * alpha * alpha * std::sqrt(alpha);
}

} // namespace

void require_valid(const ElasticTugging& tugging)
{
  require_positive(tugging.radius_lower, "radius of the lower sphere");
  require_positive(tugging.radius_upper, "radius of the upper sphere");
  require_positive(tugging.contact_modulus, "contact modulus");
  require_positive(tugging.interference, "interference");
  if (!(tugging.interference < radii(tugging)))
    throw InputError(fmt::format("interference = {} m must be less than the sum of the radii, {} m.",
                                 tugging.interference, radii(tugging)));
}

double half_sliding_distance(const ElasticTugging& tugging)
{
  require_valid(tugging);
  return std::sqrt(tugging.interference * (2.0 * radii(tugging) - tugging.interference));
}

TuggingForces elastic_tugging_forces(const ElasticTugging& tugging, double X)
{
  require_valid(tugging);
  const double omega = radii(tugging) - tugging.interference;
  const double distance = std::hypot(omega, X);
  const double alpha = interference_at(tugging, X);
  const double load = hertz_factor(tugging) * alpha * std::sqrt(alpha);
  return {.load = load, .F_X = -load * X / distance, .F_Z = load * omega / distance, .interference = alpha};
}

TuggingPeak elastic_tugging_peak(const ElasticTugging& tugging)
{
  const double d0 = half_sliding_distance(tugging);
  const double omega = radii(tugging) - tugging.interference;
  const auto slope = [&](double s)
  { return omega * omega * interference_at(tugging, s) - 1.5 * s * s * std::hypot(omega, s); };
  const double X = -bisected_root(slope, 0.0, d0);
  return {.F_X = elastic_tugging_forces(tugging, X).F_X, .X = X};
}

double elastic_tugging_work(const ElasticTugging& tugging, double X1, double X2)
{
  require_valid(tugging);
  return energy(tugging, X2) - energy(tugging, X1);
}

} // namespace brinell::reference
