// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/hertz.hpp"

#include "reference/bisection.hpp"
#include "reference/require.hpp"
#include "reference/spheroidal.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace brinell::reference
{
namespace
{

using std::numbers::pi;

PointContact point_contact(double radius, double contact_modulus, double contact_radius)
{
  const double a = contact_radius;
  return {.load = 4.0 / 3.0 * contact_modulus * a * a * a / radius,
          .approach = a * a / radius,
          .contact_radius = a,
          .peak_pressure = 2.0 * contact_modulus * a / (pi * radius)};
}

/// Complete elliptic integrals K and D = (K - E)/k^2 as functions of k' = sqrt(1 - k^2).
struct EllipticIntegrals
{
  double K, D;
};

/// Computes them by the arithmetic-geometric mean (Abramowitz & Stegun 1964, 17.6). This avoids the cancellation in K - E at
/// small k, and the loss of digits if k near 1 is computed from k', as std::comp_ellint_2(k) would require.
EllipticIntegrals elliptic_integrals(double k_prime)
{
  double a = 0.5 * (1.0 + k_prime), b = std::sqrt(k_prime);
  double c = 0.5 * (1.0 - k_prime);
  double c_over_k = 0.5 * std::sqrt((1.0 - k_prime) / (1.0 + k_prime)); // k^2 = (1 - k')(1 + k')
  double weight = 2.0, sum = 1.0;
  while (weight * c_over_k * c_over_k > 1e-17 * sum)
  {
    sum += weight * c_over_k * c_over_k;
    weight *= 2.0;
    const double next = c * c_over_k / (4.0 * 0.5 * (a + b)); // c_{n+1} = c_n^2/(4 a_{n+1})
    c = c * c / (4.0 * 0.5 * (a + b));
    c_over_k = next;
    a = std::exchange(b, std::sqrt(a * b)) * 0.5 + 0.5 * a;
  }
  const double K = pi / (2.0 * a);
  return {.K = K, .D = 0.5 * K * sum};
}

/// Shape of the ellipse for a ratio of the radii of curvature >= 1: k' = b/a <= 1 and its integrals.
struct EllipseShape
{
  double axis_ratio;
  EllipticIntegrals integrals;
};

/// Solves R_long/R_short = (K - D)/(k'^2 D), Johnson 1985, Eq. 4.28; the right side falls with k'.
EllipseShape ellipse_shape(double radius_ratio)
{
  const auto excess = [radius_ratio](double log_axis_ratio)
  {
    const double k_prime = std::exp(log_axis_ratio);
    const auto [K, D] = elliptic_integrals(k_prime);
    return (K - D) / (k_prime * k_prime * D) - radius_ratio;
  };
  const double k_prime = std::exp(bisected_root(excess, -std::log(radius_ratio), 0.0));
  return {k_prime, elliptic_integrals(k_prime)};
}

EllipseShape ellipse_shape(double radius_x, double radius_y)
{
  return radius_x > radius_y ? ellipse_shape(radius_x / radius_y) : ellipse_shape(radius_y / radius_x);
}

/// The contact with a long semi-axis a: p0 = E' a^2/(b D 2 R_long), approach = p0 b K/E' (Johnson 1985, Eqs.
/// 4.26-4.29).
EllipticalContact elliptical_contact(double radius_x, double radius_y, double contact_modulus,
                                     const EllipseShape& shape, double a)
{
  const double b = a * shape.axis_ratio;
  const double p0 = contact_modulus * a * a / (2.0 * b * shape.integrals.D * std::max(radius_x, radius_y));
  const bool along_x = radius_x >= radius_y;
  return {.load = 2.0 / 3.0 * pi * a * b * p0,
          .approach = p0 * b * shape.integrals.K / contact_modulus,
          .semi_axis_x = along_x ? a : b,
          .semi_axis_y = along_x ? b : a,
          .peak_pressure = p0};
}

void require_contact(double radius_x, double radius_y, double contact_modulus)
{
  require_positive(radius_x, "radius");
  require_positive(radius_y, "radius");
  require_positive(contact_modulus, "contact modulus");
}

/// ln(2 l/a); 0 without a load, because then all products with it vanish.
double reference_logarithm(const LineContact& contact, double contact_modulus, double reference)
{
  require_positive(contact_modulus, "contact modulus");
  require_positive(reference, "reference");
  if (contact.half_width == 0.0)
    return 0.0;
  if (!(2.0 * reference > contact.half_width))
    throw InputError(fmt::format("reference = {} m must be more than half of the half-width of the contact, {} m.",
                                 reference, contact.half_width));
  return std::log(2.0 * reference / contact.half_width);
}

} // namespace

PointContact point_contact_at_load(double radius, double contact_modulus, double load)
{
  require_contact(radius, radius, contact_modulus);
  require_not_negative(load, "load");
  return point_contact(radius, contact_modulus, std::cbrt(0.75 * load * radius / contact_modulus));
}

PointContact point_contact_at_approach(double radius, double contact_modulus, double approach)
{
  require_contact(radius, radius, contact_modulus);
  require_not_negative(approach, "approach");
  return point_contact(radius, contact_modulus, std::sqrt(radius * approach));
}

EllipticalContact elliptical_contact_at_load(double radius_x, double radius_y, double contact_modulus, double load)
{
  require_contact(radius_x, radius_y, contact_modulus);
  require_not_negative(load, "load");
  const EllipseShape shape = ellipse_shape(radius_x, radius_y);
  const double R = std::max(radius_x, radius_y);
  const double a = std::cbrt(3.0 * load * shape.integrals.D * R / (pi * contact_modulus));
  return elliptical_contact(radius_x, radius_y, contact_modulus, shape, a);
}

EllipticalContact elliptical_contact_at_approach(double radius_x, double radius_y, double contact_modulus,
                                                 double approach)
{
  require_contact(radius_x, radius_y, contact_modulus);
  require_not_negative(approach, "approach");
  const EllipseShape shape = ellipse_shape(radius_x, radius_y);
  const double R = std::max(radius_x, radius_y);
  const double a = std::sqrt(2.0 * R * approach * shape.integrals.D / shape.integrals.K);
  return elliptical_contact(radius_x, radius_y, contact_modulus, shape, a);
}

SymTensor point_contact_stress(double x, double y, double z, double contact_radius, double peak_pressure,
                               double poisson_ratio)
{
  const double nu = poisson_ratio;
  const double r = std::hypot(x, y);
  const auto [xi, eta] = spheroidal(r * r / (contact_radius * contact_radius), z / contact_radius);
  const double sum = xi * xi + eta * eta;
  const double inverse = sum > 0.0 ? 1.0 / sum : 0.0; // set to zero on the rim, where the numerators vanish faster
  const double spread = 1.0 / (1.0 + xi * xi);
  const double q = (1.0 - 2.0 * nu) / 3.0 * (1.0 + eta + eta * eta) * spread / (1.0 + eta);
  const double w = (1.0 - nu) * xi * xi * spread, acot = (1.0 + nu) * xi * std::atan2(1.0, xi);
  const double normal = peak_pressure * -eta * eta * eta * inverse;
  const double radial = peak_pressure * (q + eta * (w + acot - 2.0)) - normal;
  const double hoop = peak_pressure * (-q - eta * (2.0 * nu + w - acot));
  const double shear = -peak_pressure * xi * eta * eta * inverse * spread / contact_radius; // sigma_rz / r

  const double c = r > 0.0 ? x / r : 1.0, s = r > 0.0 ? y / r : 0.0;
  return {radial * c * c + hoop * s * s, radial * s * s + hoop * c * c, normal, shear * y, shear * x,
          (radial - hoop) * c * s};
}

LineContact line_contact_at_load(double radius, double contact_modulus, double load_per_length)
{
  require_contact(radius, radius, contact_modulus);
  require_not_negative(load_per_length, "load per length");
  const double a = std::sqrt(4.0 * load_per_length * radius / (pi * contact_modulus));
  return {.load_per_length = load_per_length, .half_width = a, .peak_pressure = contact_modulus * a / (2.0 * radius)};
}

double line_contact_approach(const LineContact& contact, double contact_modulus, double reference)
{
  return contact.load_per_length / (pi * contact_modulus) *
         (1.0 + 2.0 * reference_logarithm(contact, contact_modulus, reference));
}

double line_contact_work(const LineContact& contact, double contact_modulus, double reference)
{
  const double W = contact.load_per_length;
  return W * W / (4.0 * pi * contact_modulus) * (1.0 + 4.0 * reference_logarithm(contact, contact_modulus, reference));
}

LineContact line_contact_at_approach(double radius, double contact_modulus, double approach, double reference)
{
  require_contact(radius, radius, contact_modulus);
  require_not_negative(approach, "approach");
  require_positive(reference, "reference");
  const double largest = reference * reference / radius;
  if (!(approach <= largest))
    throw InputError(fmt::format("approach = {} m is more than a line contact has with the reference {} m, {} m.",
                                 approach, reference, largest));
  // The approach grows with a up to a = 2 l.
  const auto excess = [=](double a)
  { return a > 0.0 ? a * a / (4.0 * radius) * (1.0 + 2.0 * std::log(2.0 * reference / a)) - approach : -approach; };
  const double a = approach > 0.0 ? bisected_root(excess, 2.0 * reference, 0.0) : 0.0;
  return {.load_per_length = pi * contact_modulus * a * a / (4.0 * radius),
          .half_width = a,
          .peak_pressure = contact_modulus * a / (2.0 * radius)};
}

SymTensor line_contact_stress(double x, double z, double half_width, double peak_pressure, double poisson_ratio)
{
  x /= half_width;
  z /= half_width;
  const auto [xi, eta] = spheroidal(x * x, z);
  const double c = std::sqrt(1.0 + xi * xi);
  const double S = xi * xi + eta * eta;
  const double share = S > 0.0 ? eta * eta / S : 0.0; // at the contact's edge all stresses are zero
  const double zz = -c * eta * share;
  const double xx = -2.0 * eta / (c + xi) - zz;
  const double xz = -x * xi * share / c;
  const double p0 = peak_pressure;
  return {p0 * xx, p0 * poisson_ratio * (xx + zz), p0 * zz, 0.0, p0 * xz, 0.0};
}

FirstYield first_yield(double poisson_ratio)
{
  require_within(poisson_ratio, -1.0, 0.5, "Poisson's ratio");
  const double g = 1.0 + poisson_ratio;
  const auto slope = [g](double s)
  {
    const double f = 1.0 / (1.0 + s * s);
    return g * (std::atan2(1.0, s) - s * f) - 3.0 * s * f * f;
  };
  const double s = bisected_root(slope, 0.0, 1.0);
  const double largest = 1.5 / (1.0 + s * s) - g * (1.0 - s * std::atan2(1.0, s));
  const double at_edge = (1.0 - 2.0 * poisson_ratio) / std::numbers::sqrt3;
  return at_edge > largest ? FirstYield{1.0 / at_edge, 0.0} : FirstYield{1.0 / largest, s};
}

FirstYield line_contact_first_yield(double poisson_ratio)
{
  require_within(poisson_ratio, -1.0, 0.5, "Poisson's ratio");
  const double m = (1.0 - 2.0 * poisson_ratio) * (1.0 - 2.0 * poisson_ratio);
  if (m >= 0.375) // there both branches agree, T = 1/2
    return {.pressure_ratio = 1.0 / std::sqrt(m), .depth_ratio = 0.0};
  // The largest root of the cubic, by Viete.
  const double T = 4.0 / 3.0 * std::cos(std::acos(-(11.0 + 9.0 * m) / 16.0) / 3.0) - 1.0 / 3.0;
  return {.pressure_ratio = std::sqrt((1.0 + T) / ((1.0 - T) * (m + 3.0 * T * T))),
          .depth_ratio = T / std::sqrt((1.0 - T) * (1.0 + T))};
}

} // namespace brinell::reference
