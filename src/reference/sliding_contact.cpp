// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/sliding_contact.hpp"

#include "brinell/reference/hertz.hpp"
#include "reference/require.hpp"
#include "reference/spheroidal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace brinell::reference
{
namespace
{

using std::numbers::pi;
using Complex = std::complex<double>;

/// Quadrature that represents the shear sqrt(1 - r^2) by point forces at the complex depths z + e: points e on the right half of
/// the unit circle, with weights. The potential of a point force at the depth z + i t, 1/sqrt(r^2 + (z + i t)^2), integrated with
/// the weight pi/2 (1 - t^2) along t = -1..1, is the potential of the shear. The path may be deformed away from its singularity,
/// the disc. Near the rim the ends of the path are singular, too; therefore the double exponential rule is used (Takahasi and
/// Mori 1974). Only the upper half of the path is stored: the points of the lower half are complex conjugates with equal real
/// parts.
struct Path
{
  static constexpr int points = 60;
  std::array<Complex, points> e, weight;

  Path()
  {
    constexpr double end = 3.2, step = 2.0 * end / (2 * points - 1);
    for (std::size_t i = 0; i < points; ++i)
    {
      const double t = (static_cast<double>(i) + 0.5) * step;
      const double s = 0.5 * pi * std::sinh(t);
      e[i] = std::polar(1.0, 0.5 * pi * std::tanh(s));
      const double length = 0.5 * pi * step * 0.5 * pi * std::cosh(t) / std::pow(std::cosh(s), 2);
      weight[i] = pi * length * (1.0 + e[i] * e[i]) * e[i];
    }
  }
};

/// Derivatives of the potentials of the shear, with D = d/(r dr). For a point force, V = 1/R, dF/dz = V and dF1/dz = F.
struct Potentials
{
  double DV = 0.0, D2V = 0.0, V_z = 0.0, DV_z = 0.0, D2F = 0.0, D3F = 0.0, D2F1 = 0.0, D3F1 = 0.0;
};

/// 1/c without the treatment of infinite parts by the division of C++, which takes several times as long: there are none here.
Complex inverse(const Complex& c)
{
  return std::conj(c) / std::norm(c);
}

/// The square root with a positive real part, also without this treatment. The larger part is computed first, without
/// cancellation.
Complex root(const Complex& c)
{
  const double size = std::sqrt(std::norm(c));
  const double larger = std::sqrt(0.5 * (size + std::abs(c.real())));
  if (larger == 0.0)
    return {};
  const double smaller = 0.5 * std::abs(c.imag()) / larger;
  return c.real() >= 0.0 ? Complex{larger, std::copysign(smaller, c.imag())}
                         : Complex{smaller, std::copysign(larger, c.imag())};
}

Potentials potentials(double r2, double z)
{
  static const Path path;
  Potentials sum;
  for (std::size_t i = 0; i < Path::points; ++i)
  {
    const Complex zeta = z + path.e[i], w = path.weight[i];
    const Complex R2 = r2 + zeta * zeta, R = root(R2), S = R + zeta;
    const Complex over_R2 = inverse(R2), over_S = inverse(S);
    const Complex R3 = w * R * over_R2 * over_R2, R5 = R3 * over_R2, S2 = over_S * over_S;
    sum.DV -= R3.real();
    sum.D2V += 3.0 * R5.real();
    sum.V_z -= (zeta * R3).real();
    sum.DV_z += 3.0 * (zeta * R5).real();
    sum.D2F -= ((2.0 * R + zeta) * R3 * S2).real();
    sum.D3F += ((8.0 * R2 + 9.0 * R * zeta + 3.0 * zeta * zeta) * R5 * S2 * over_S).real();
    sum.D2F1 += (R2 * R3 * S2).real();
    sum.D3F1 -= ((3.0 * R + zeta) * R3 * S2 * over_S).real();
  }
  return sum;
}

/// The position of a local maximum of a function in the half plane z >= 0, found by a pattern search with steps that are halved.
template <typename Function>
std::array<double, 2> climbed(const Function& f, std::array<double, 2> place)
{
  constexpr double finest = 1e-7; // the maximum is flat: with smaller steps the values do not differ
  double best = f(place[0], place[1]);
  for (double step = 0.1; step > finest;)
  {
    bool moved = false;
    for (const auto& [dx, dz] : {std::array{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}})
    {
      const std::array<double, 2> trial{std::clamp(place[0] + dx, -1.0, 1.0), std::max(0.0, place[1] + dz)};
      if (const double value = f(trial[0], trial[1]); value > best)
      {
        best = value;
        place = trial;
        moved = true;
      }
    }
    if (!moved)
      step *= 0.5;
  }
  return place;
}

/// There may be several maxima, on the surface and below it. A search starts from the highest value of a scan on the surface, and
/// of a scan below it.
/// @param stress  stress over peak pressure, at x, z in units of the contact size
template <typename Stress>
SlidingYield largest_stress(const Stress& stress)
{
  const auto size = [&](double x, double z) { return von_mises(stress(x, z)); };
  const auto scanned = [&](int first_row, int last_row)
  {
    constexpr double spacing = 0.1;
    std::array<double, 2> best{};
    double largest = -1.0;
    for (int row = first_row; row <= last_row; ++row)
      for (int column = -10; column <= 10; ++column)
        if (const double value = size(spacing * column, spacing * row); value > largest)
        {
          largest = value;
          best = {spacing * column, spacing * row};
        }
    return climbed(size, best);
  };
  constexpr int deepest = 10;
  const auto beneath = scanned(1, deepest), surface = scanned(0, 0);
  const auto& place = size(beneath[0], beneath[1]) >= size(surface[0], surface[1]) ? beneath : surface;
  return {.pressure_ratio = 1.0 / size(place[0], place[1]), .x_ratio = place[0], .depth_ratio = place[1]};
}

SymTensor added(SymTensor a, const SymTensor& b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] += b[i];
  return a;
}

} // namespace

// Stresses of a point force along x, with Cerruti's potentials F = ln(R + z) and F1 = z ln(R + z) - R
// (Johnson 1985, section 3.2):
//     2 pi sigma_xx = 2 (1 + nu) V_x + 2 nu F1_xxx - z F_xxx     2 pi sigma_yz = -z V_xy
//     2 pi sigma_yy = 2 nu V_x + 2 nu F1_xyy - z F_xyy           2 pi sigma_xz = V_z - z V_xx
//     2 pi sigma_zz = -z V_xz                                    2 pi sigma_xy = V_y + 2 nu F1_xxy - z F_xxy
SymTensor point_contact_shear_stress(double x, double y, double z, double contact_radius, double peak_shear,
                                     double poisson_ratio)
{
  x /= contact_radius;
  y /= contact_radius;
  z /= contact_radius;
  const double nu = poisson_ratio;
  const Potentials p = potentials(x * x + y * y, z);
  // The terms with F1 and F are combined as G = 2 nu F1 - z F.
  const double D2G = 2.0 * nu * p.D2F1 - z * p.D2F, D3G = 2.0 * nu * p.D3F1 - z * p.D3F;
  const double unit = peak_shear / (2.0 * pi);
  return {unit * (2.0 * (1.0 + nu) * x * p.DV + x * x * x * D3G + 3.0 * x * D2G),
          unit * (2.0 * nu * x * p.DV + x * y * y * D3G + x * D2G),
          unit * -z * x * p.DV_z,
          unit * -z * x * y * p.D2V,
          unit * (p.V_z - z * (x * x * p.D2V + p.DV)),
          unit * (y * p.DV + x * x * y * D3G + y * D2G)};
}

SymTensor line_contact_shear_stress(double x, double z, double half_width, double peak_shear, double poisson_ratio)
{
  const SymTensor pressed = line_contact_stress(x, z, half_width, peak_shear, poisson_ratio);
  x /= half_width;
  const double xi = spheroidal(x * x, z / half_width).first;
  const double c = std::sqrt(1.0 + xi * xi);
  const double zz = pressed[4];
  const double xx = peak_shear * -2.0 * x / (c * (c + xi)) - zz;
  return {xx, poisson_ratio * (xx + zz), zz, 0.0, pressed[0], 0.0};
}

SymTensor sliding_point_contact_stress(double x, double y, double z, double contact_radius, double peak_pressure,
                                       double poisson_ratio, double friction)
{
  const SymTensor pressed = point_contact_stress(x, y, z, contact_radius, peak_pressure, poisson_ratio);
  if (friction == 0.0)
    return pressed;
  return added(pressed, point_contact_shear_stress(x, y, z, contact_radius, friction * peak_pressure, poisson_ratio));
}

SymTensor sliding_line_contact_stress(double x, double z, double half_width, double peak_pressure, double poisson_ratio,
                                      double friction)
{
  return added(line_contact_stress(x, z, half_width, peak_pressure, poisson_ratio),
               line_contact_shear_stress(x, z, half_width, friction * peak_pressure, poisson_ratio));
}

SlidingYield sliding_first_yield(double poisson_ratio, double friction)
{
  require_not_negative(friction, "friction");
  if (const FirstYield y = first_yield(poisson_ratio); friction == 0.0)
    return {.pressure_ratio = y.pressure_ratio, .x_ratio = 0.0, .depth_ratio = y.depth_ratio};
  return largest_stress([&](double x, double z)
                        { return sliding_point_contact_stress(x, 0.0, z, 1.0, 1.0, poisson_ratio, friction); });
}

SlidingYield line_sliding_first_yield(double poisson_ratio, double friction)
{
  require_not_negative(friction, "friction");
  if (const FirstYield y = line_contact_first_yield(poisson_ratio); friction == 0.0)
    return {.pressure_ratio = y.pressure_ratio, .x_ratio = 0.0, .depth_ratio = y.depth_ratio};
  return largest_stress([&](double x, double z)
                        { return sliding_line_contact_stress(x, z, 1.0, 1.0, poisson_ratio, friction); });
}

} // namespace brinell::reference
