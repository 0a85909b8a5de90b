// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/coated_contact.hpp"

#include "brinell/green/stack.hpp"
#include "foundation/matrix.hpp"
#include "panels.hpp"
#include "require.hpp"
#include "spherical_bessel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>

namespace brinell::reference
{

namespace
{

double top_compliance(const ElasticStack& body)
{
  return body.top().is_rigid() ? 0.0 : body.top().contact_compliance();
}

/// Displacement by a wave of unit pressure, over that of a half space of the uppermost material with the contact compliance 1, 2/k.
double wave_compliance(const ElasticStack& body, double k)
{
  return body.is_homogeneous() ? top_compliance(body) : 0.5 * k * green::StackWave(body, k).compliance().normal;
}

double thinnest_top(const ElasticStack& lower, const ElasticStack& upper)
{
  double thinnest = std::numeric_limits<double>::infinity();
  for (const ElasticStack* body : {&lower, &upper})
    if (!body->is_homogeneous())
      thinnest = std::min(thinnest, body->layers.front().thickness);
  return thinnest;
}

/// Values at one x of the cosine transforms of the even Legendre polynomials on [0, 1]: (-1)^n j_2n(x).
class LegendreWaves
{
public:
  explicit LegendreWaves(std::size_t number) : bessel_(2 * number - 1), values_(number) {}
  const std::vector<double>& at(double x)
  {
    spherical_bessel(x, bessel_);
    for (std::size_t n = 0; n < values_.size(); ++n)
      values_[n] = n % 2 == 0 ? bessel_[2 * n] : -bessel_[2 * n];
    return values_;
  }

private:
  std::vector<double> bessel_, values_;
};

/// The Fredholm equation in Legendre polynomials: (delta_mn / (4 m + 1) + K_mn) c_n = the integral of P_2m times the right side.
Matrix fredholm(double a, double modulus, const ElasticStack& lower, const ElasticStack& upper, std::size_t terms)
{
  const int n = static_cast<int>(terms);
  Matrix matrix(n, n);
  for (int m = 0; m < n; ++m)
    matrix(m, m) = 1.0 / (4 * m + 1);
  const double thickness = thinnest_top(lower, upper);
  if (std::isinf(thickness))
    return matrix;
  constexpr double decays = 40.0; // what the layers add decays with the way to their bottom and back
  // The longest waves see the substrate, those of the length that a stiff layer stretches over begin to see the layer.
  constexpr double longest = 1e-3;
  const double first = longest * std::min(1.0, a / std::max(lower.thickness(), upper.thickness()));
  LegendreWaves waves(terms);
  for_each_wave(0.5 * decays * a / thickness, first,
                [&](double x, double weight)
                {
                  const double k = x / a;
                  const double more = modulus * (wave_compliance(lower, k) + wave_compliance(upper, k)) - 1.0;
                  const std::vector<double>& w = waves.at(x);
                  const double factor = 2.0 / std::numbers::pi * weight * more;
                  for (std::size_t j = 0; j < terms; ++j)
                    for (std::size_t i = 0; i < terms; ++i)
                      matrix(static_cast<int>(i), static_cast<int>(j)) += factor * w[i] * w[j];
                });
  return matrix;
}

/// The contact where value(contact) is `wanted`, a value that rises with the radius of the contact about as its `power`.
template <class Value>
CoatedContact contact_at(double wanted, double power, double first, Value value, double radius,
                         const ElasticStack& lower, const ElasticStack& upper)
{
  constexpr double tolerance = 1e-13;
  constexpr int most_steps = 100;
  // Beyond the widest contact, where a homogeneous body of the top material may lie, the constructor throws.
  const double widest = thinnest_top(lower.merged(), upper.merged()) / CoatedContact::thinnest;
  double below = 0.0, above = std::numeric_limits<double>::infinity(), a = std::min(first, widest);
  for (int step = 0;; ++step)
  {
    CoatedContact contact(radius, a, lower, upper);
    const double ratio = value(contact) / wanted;
    if (std::abs(ratio - 1.0) < tolerance || step == most_steps)
      return contact;
    (ratio < 1.0 ? below : above) = a;
    const double next = a * std::pow(ratio, -1.0 / power);
    const double inside = next > below && next < above ? next : 0.5 * (below + above);
    a = a == widest && ratio < 1.0 ? inside : std::min(inside, widest);
  }
}

double sum(std::span<const double> values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

} // namespace

CoatedContact::CoatedContact(double radius, double contact_radius, const ElasticStack& lower, const ElasticStack& upper)
    : contact_radius_(contact_radius), modulus_(1.0 / (top_compliance(lower) + top_compliance(upper)))
{
  require_positive(radius, "radius");
  require_positive(contact_radius, "contact_radius");
  require_positive(top_compliance(lower) + top_compliance(upper), "compliance");
  const ElasticStack lower_body = lower.merged(), upper_body = upper.merged();
  const double thickness = thinnest_top(lower_body, upper_body) / contact_radius;
  constexpr double rounding = 1e-9;
  require_within(thickness, (1.0 - rounding) * thinnest, std::numeric_limits<double>::infinity(),
                 "thickness / contact_radius");
  constexpr double least = 12.0, per_thickness = 2.0;
  const auto terms = static_cast<std::size_t>(least + per_thickness / thickness);
  const Matrix matrix = fredholm(contact_radius, modulus_, lower_body, upper_body, terms);
  // On the circle the displacement is approach - r^2/2R, which phi follows as 2/pi (approach - t^2/R).
  std::vector<double> unit(terms, 0.0), shape(terms, 0.0);
  unit[0] = 2.0 / std::numbers::pi;
  shape[0] = unit[0] * contact_radius * contact_radius / (3.0 * radius);
  shape[1] = unit[0] * contact_radius * contact_radius / radius * 2.0 / 15.0;
  punch_ = solve(matrix, unit);
  const std::vector<double> bent = solve(matrix, shape);
  approach_ = sum(bent) / sum(punch_); // phi(a) = 0: no pressure at the edge
  phi_.resize(terms);
  for (std::size_t n = 0; n < terms; ++n)
    phi_[n] = approach_ * punch_[n] - bent[n];
}

CoatedContact CoatedContact::at_load(double radius, double load, const ElasticStack& lower, const ElasticStack& upper)
{
  require_positive(load, "load");
  const double a = std::cbrt(0.75 * radius * load * (top_compliance(lower) + top_compliance(upper)));
  return contact_at(
      load, 3.0, a, [](const CoatedContact& c) { return c.load(); }, radius, lower, upper);
}

CoatedContact CoatedContact::at_approach(double radius, double approach, const ElasticStack& lower,
                                         const ElasticStack& upper)
{
  require_positive(approach, "approach");
  return contact_at(
      approach, 2.0, std::sqrt(radius * approach), [](const CoatedContact& c) { return c.approach(); }, radius, lower,
      upper);
}

double CoatedContact::load() const
{
  return std::numbers::pi * modulus_ * contact_radius_ * phi_.front();
}

double CoatedContact::stiffness() const
{
  return std::numbers::pi * modulus_ * contact_radius_ * punch_.front();
}

double CoatedContact::wave_of_pressure(double k) const
{
  const std::vector<double> waves = LegendreWaves(phi_.size()).at(k * contact_radius_);
  return 0.5 * modulus_ * contact_radius_ * std::inner_product(waves.begin(), waves.end(), phi_.begin(), 0.0);
}

double CoatedContact::pressure(double r) const
{
  const double rho = r / contact_radius_;
  if (!(rho < 1.0))
    return 0.0;
  // p = -E'/2 integral_r^a phi'(t) / sqrt(t^2 - r^2) dt, with t^2 = r^2 + (a^2 - r^2) u^2; phi'(t)/t is smooth.
  double integral = 0.0;
  const auto panels = static_cast<double>(phi_.size());
  for (double panel = 0.0; panel < panels; ++panel)
    for (std::size_t i = 0; i < gauss_point.size(); ++i)
      for (const double side : {-1.0, 1.0})
      {
        const double u = (panel + 0.5 + 0.5 * side * gauss_point[i]) / panels;
        const double t = std::sqrt(rho * rho + (1.0 - rho * rho) * u * u);
        // P_l' = l/(t^2 - 1) (t P_l - P_{l-1}) cancels near 1; the sum of (2l - 1) P_{l-1}, (2l - 5) P_{l-3}, ... does not.
        double before = 1.0, legendre = t, slope = 0.0, derivative = 0.0;
        for (std::size_t n = 1; n < phi_.size(); ++n)
        {
          const auto l = static_cast<double>(2 * n);
          slope += (2.0 * l - 1.0) * legendre;
          derivative += phi_[n] * slope;
          before = ((2.0 * l - 1.0) * t * legendre - (l - 1.0) * before) / l;
          legendre = ((2.0 * l + 1.0) * t * before - l * legendre) / (l + 1.0);
        }
        integral += 0.5 * gauss_weight[i] / panels * derivative / t;
      }
  return -0.5 * modulus_ / contact_radius_ * std::sqrt(1.0 - rho * rho) * integral;
}

} // namespace brinell::reference
