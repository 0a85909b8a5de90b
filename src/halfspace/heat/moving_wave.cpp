// SPDX-License-Identifier: BSD-3-Clause
#include "moving_wave.hpp"

#include "foundation/faddeeva.hpp"

namespace brinell::halfspace
{

namespace
{

constexpr Complex i_unit{0.0, 1.0};

/// e^{-2bd} erfc(b - d) and e^{2bd} erfc(b + d), of b with a real part >= 0 and d >= 0: no overflow in either.
struct Later
{
  Complex down, up;
};

Later later(Complex b, double d)
{
  const Complex squares = b * b + d * d;
  constexpr double negligible = 45.0;
  const bool is_deep = b.real() < d;
  const Complex straight = is_deep ? std::exp(-2.0 * d * b) : Complex{};
  if (squares.real() > negligible)
    return {2.0 * straight, {}};
  const Complex common = std::exp(-squares);
  const Complex up = common * faddeeva(i_unit * (d + b));
  return {is_deep ? 2.0 * straight - common * faddeeva(i_unit * (d - b)) : common * faddeeva(i_unit * (b - d)), up};
}

/// Integrals over the time since heat entered, times kappa, of the temperature of a unit, e^{-z^2/4 kappa t}/sqrt(pi kappa t)
/// e^{-kappa s^2 t}, and of its potential, at s^2 = k^2 + i turn.
struct Integrals
{
  Complex temperature, potential, slope; ///< [m], [m^2], [m^2]
};

/// The integrals from 0 to infinity: e^{-sz}/s, and its potential in a form without cancellation for s near k.
Integrals of_all_time(double k, Complex s, Complex turn, double depth)
{
  const Complex sum = s + k, wound = i_unit * turn * depth / sum; // (s - k) z
  const Complex mean = std::abs(wound) < 1e-3 ? 1.0 - wound * (0.5 - wound * (1.0 / 6.0 - wound / 24.0))
                                              : (1.0 - std::exp(-wound)) / wound;
  const double decayed = std::exp(-k * depth);
  return {std::exp(-s * depth) / s, decayed * (1.0 + k * depth * mean) / (s * sum), -depth * decayed * mean / sum};
}

/// The integrals from 0 to `time`: those to infinity minus the rest. The potential follows by integration by parts, since
/// d psi/dt = -kappa T for a unit of heat.
/// @param now  the erfc terms at `time`
Integrals integrals(double k, Complex turn, double depth, double time, const Later& now)
{
  const Complex s = std::sqrt(k * k + i_unit * turn);
  Integrals result = of_all_time(k, s, turn, depth);
  const Later past = later(s * std::sqrt(time), 0.5 * depth / std::sqrt(time));
  const Complex temperature = 0.5 * (past.down + past.up) / s, bend = 0.5 * (past.up - past.down);
  const Complex turned = 0.5 * std::exp(-i_unit * turn * time), divisor = 1.0 / (i_unit * turn);
  result.temperature -= temperature;
  result.potential -= divisor * (turned * (now.down + now.up) - k * temperature);
  result.slope -= divisor * (turned * (now.up - now.down) - bend);
  return result;
}

} // namespace

ThermalWave moving_wave(const MovingFlux& flux, double kx, double k, double depth)
{
  const double time = flux.diffusivity * flux.duration; // [m^2]
  const double turn = -kx * flux.velocity / flux.diffusivity;
  const Later now = later(k * std::sqrt(time), 0.5 * depth / std::sqrt(time));
  // For a small `turn` the difference quotients are ill-conditioned. The result is smooth in `turn`, so it is approximated by the
  // mean of two values beside it, with an error of second order.
  constexpr double small = 1e-4;
  const double aside = std::abs(turn) * time < 10.0 * small ? small / time : 0.0;
  Integrals all = integrals(k, turn + aside, depth, time, now);
  if (aside > 0.0)
  {
    const Integrals other = integrals(k, turn - aside, depth, time, now);
    all = {0.5 * (all.temperature + other.temperature), 0.5 * (all.potential + other.potential),
           0.5 * (all.slope + other.slope)};
  }
  const double unit = 1.0 / flux.conductivity;
  return {unit * all.temperature, unit * all.potential, unit * all.slope, {}};
}

} // namespace brinell::halfspace
