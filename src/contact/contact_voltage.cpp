// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/contact_voltage.hpp"

#include "foundation/gauss.hpp"
#include "foundation/nan.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::contact
{

namespace
{

constexpr double absolute_zero = -273.15, reference = 20.0; // [deg C]

/// Root of a falling function in an interval that holds it (regula falsi of Illinois; Dowell and Jarratt 1971).
template <typename Function>
double root(const Function& falling, double low, double high)
{
  double at_low = falling(low), at_high = falling(high);
  for (int n = 0; n < 200 && at_low > 0.0 && at_high < 0.0; ++n)
  {
    const double between = (low * at_high - high * at_low) / (at_high - at_low);
    const double x = between > low && between < high ? between : 0.5 * (low + high), at_x = falling(x);
    if (!(high - low > 1e-15 * std::abs(x)) || x == low || x == high)
      return x;
    if (at_x > 0.0)
    {
      low = x;
      at_low = at_x;
      at_high *= 0.5;
    }
    else
    {
      high = x;
      at_high = at_x;
      at_low *= 0.5;
    }
    if (at_x == 0.0)
      return x;
  }
  return at_low > 0.0 ? high : low;
}

/// Integral over an interval by Gauss and Legendre with eight points in each of several parts.
template <typename Function>
double integral(const Function& f, double from, double to)
{
  constexpr int parts = 4;
  const double half = 0.5 * (to - from) / parts;
  double sum = 0.0;
  for (int part = 0; part < parts; ++part)
  {
    const double middle = from + (2 * part + 1) * half;
    for (std::size_t n = 0; n < gauss_point.size(); ++n)
      sum += gauss_weight[n] * (f(middle - gauss_point[n] * half) + f(middle + gauss_point[n] * half));
  }
  return half * sum;
}

/// Potentials [V]: `contact` at the contact area, `hottest` where the temperature is largest; the far ends of the lower and the
/// upper body have the voltage and 0.
struct Potentials
{
  double voltage, contact, hottest;

  /// kirchhoff of a body at a potential, from its far end.
  [[nodiscard]] double in_body(int body, double potential) const
  {
    const double far = body == 0 ? voltage : 0.0;
    return 0.5 * (far - potential) * (far + potential - 2.0 * hottest);
  }
};

/// Where the potential is that of the largest temperature: the temperature is the same on both sides of the contact area.
Potentials with_equal_temperatures(const std::array<HotConductor, 2>& bodies, double voltage, double contact)
{
  // Each temperature is defined for potentials between the ends, where no body is colder than far away but for the other's bulk.
  const auto difference = [&](double hottest)
  {
    const Potentials p{voltage, contact, hottest};
    const double lower = bodies[0].temperature_at(p.in_body(0, contact)),
                 upper = bodies[1].temperature_at(p.in_body(1, contact));
    return (std::isnan(lower) ? absolute_zero : lower) - (std::isnan(upper) ? absolute_zero : upper);
  };
  double low = 0.0, high = voltage;
  for (int n = 0; n < 60 && difference(low) < 0.0; ++n) // bulks of different temperatures: beyond the ends
    low -= voltage * std::pow(2.0, n);
  for (int n = 0; n < 60 && difference(high) > 0.0; ++n)
    high += voltage * std::pow(2.0, n);
  return {voltage, contact, root(difference, low, high)};
}

/// Integral of dphi/rho from the contact area to the far end of a body [A/m].
double flow_in(const HotConductor& body, int index, const Potentials& p)
{
  const auto conductance = [&](double potential)
  { return 1.0 / body.resistivity_at(body.temperature_at(p.in_body(index, potential))); };
  return index == 0 ? integral(conductance, p.contact, p.voltage) : integral(conductance, 0.0, p.contact);
}

} // namespace

double HotConductor::resistivity_at(double t) const
{
  return resistivity * (1.0 + temperature_coefficient * (t - reference));
}

double HotConductor::conductivity_at(double t) const
{
  return conductivity ? *conductivity : lorenz_number * (t - absolute_zero) / resistivity_at(t);
}

double HotConductor::temperature_at(double kirchhoff) const
{
  if (!conductivity)
    return absolute_zero + std::sqrt(std::pow(temperature - absolute_zero, 2) + 2.0 * kirchhoff / lorenz_number);
  // k rho_0 x (1 + alpha (T_0 - T_r) + alpha x/2) = kirchhoff, with x = T - T_0
  const double slope = *conductivity * resistivity_at(temperature),
               curvature = *conductivity * resistivity * temperature_coefficient;
  const double inside = slope * slope + 2.0 * curvature * kirchhoff;
  return temperature + 2.0 * kirchhoff / (slope + std::sqrt(inside));
}

HotContact hot_contact(const std::array<HotConductor, 2>& bodies, double voltage)
{
  if (!(voltage > 0.0))
    return {.interface = nan, .temperature = std::max(bodies[0].temperature, bodies[1].temperature)};
  const auto excess = [&](double contact)
  {
    const Potentials p = with_equal_temperatures(bodies, voltage, contact);
    return flow_in(bodies[0], 0, p) - flow_in(bodies[1], 1, p);
  };
  const double contact = root(excess, 0.0, voltage);
  const Potentials p = with_equal_temperatures(bodies, voltage, contact);
  const double interface = bodies[0].temperature_at(p.in_body(0, contact));
  const int hottest = p.hottest > contact ? 0 : 1;
  const double largest = p.hottest >= 0.0 && p.hottest <= voltage
                             ? bodies[static_cast<std::size_t>(hottest)].temperature_at(p.in_body(hottest, p.hottest))
                             : std::max(bodies[0].temperature, bodies[1].temperature);
  return {voltage, flow_in(bodies[0], 0, p), interface, largest, p.contact, p.hottest};
}

double temperature_in(const std::array<HotConductor, 2>& bodies, const HotContact& contact, std::size_t body,
                      double share)
{
  const double far = body == 0 ? contact.voltage : 0.0;
  const Potentials p{contact.voltage, contact.contact, contact.hottest};
  return bodies.at(body).temperature_at(p.in_body(static_cast<int>(body), far + share * (contact.contact - far)));
}

std::optional<HotContact> hot_contact_of_current(const std::array<HotConductor, 2>& bodies, double flow)
{
  if (!(flow > 0.0))
    return hot_contact(bodies, 0.0);
  constexpr double hottest = 1e5; // [deg C]
  double high =
      flow * (bodies[0].resistivity_at(bodies[0].temperature) + bodies[1].resistivity_at(bodies[1].temperature));
  for (HotContact found = hot_contact(bodies, high); !(found.flow >= flow); found = hot_contact(bodies, high))
    if (!(found.temperature < hottest))
      return std::nullopt;
    else
      high *= 1.1;
  const double voltage = root([&](double v) { return flow - hot_contact(bodies, v).flow; }, 0.0, high);
  return hot_contact(bodies, voltage);
}

} // namespace brinell::contact
