// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/elastic_tugging.hpp"

#include "brinell/reference/hertz.hpp"
#include "reference/bisection.hpp"
#include "reference/require.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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

/// Equivalent radius R with 1/R = 1/R1 + 1/R2 [m].
double equivalent_radius(const ElasticTugging& t)
{
  return t.radius_lower * t.radius_upper / radii(t);
}

/// The normal contact at an interference.
struct Press
{
  double load = 0.0;      ///< P [N]
  double stiffness = 0.0; ///< dP/d alpha [N/m]
  double work = 0.0;      ///< of pressing up to this interference [J]
};

Press press_of_spheres(const ElasticTugging& t, double alpha)
{
  const double factor = 4.0 / 3.0 * t.contact_modulus * std::sqrt(equivalent_radius(t) * alpha);
  return {factor * alpha, 1.5 * factor, 0.4 * factor * alpha * alpha};
}

Press press_of_cylinders(const ElasticTugging& t, double alpha)
{
  const auto [length, reference] = *t.line;
  const LineContact c = line_contact_at_approach(equivalent_radius(t), t.contact_modulus, alpha, reference);
  if (c.half_width == 0.0)
    return {};
  const double logarithm = std::log(2.0 * reference / c.half_width); // d alpha/dW = 2 ln(2 l/a)/(pi E')
  return {length * c.load_per_length, length * 0.5 * std::numbers::pi * t.contact_modulus / logarithm,
          length * line_contact_work(c, t.contact_modulus, reference)};
}

Press press(const ElasticTugging& t, double X)
{
  const double alpha = interference_at(t, X);
  return t.line ? press_of_cylinders(t, alpha) : press_of_spheres(t, alpha);
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
  if (!tugging.line)
    return;
  require_positive(tugging.line->length, "length");
  require_positive(tugging.line->reference, "reference");
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
  const double load = press(tugging, X).load;
  return {.load = load,
          .F_X = -load * X / distance,
          .F_Z = load * omega / distance,
          .interference = interference_at(tugging, X)};
}

TuggingPeak elastic_tugging_peak(const ElasticTugging& tugging)
{
  const double d0 = half_sliding_distance(tugging);
  const double omega = radii(tugging) - tugging.interference;
  const auto slope = [&](double s)
  {
    const Press p = press(tugging, s);
    return omega * omega * p.load - p.stiffness * s * s * std::hypot(omega, s);
  };
  const double X = -bisected_root(slope, 0.0, d0);
  return {.F_X = elastic_tugging_forces(tugging, X).F_X, .X = X};
}

double elastic_tugging_work(const ElasticTugging& tugging, double X1, double X2)
{
  require_valid(tugging);
  return press(tugging, X2).work - press(tugging, X1).work;
}

} // namespace brinell::reference
