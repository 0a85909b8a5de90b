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

/// Potentials [V]: `contact` in each body at the contact area, `hottest` where the temperature is largest, or would be in a film;
/// the far ends of the lower and the upper body have the voltage and 0. The flux of heat plus the potential times the current is
/// the same everywhere, in the film as well, and so is `hottest`.
struct Potentials
{
  double voltage;
  std::array<double, 2> contact;
  double hottest;

  [[nodiscard]] double far(std::size_t body) const { return body == 0 ? voltage : 0.0; }
  /// kirchhoff of a body at a potential, from its far end.
  [[nodiscard]] double in_body(std::size_t body, double potential) const
  {
    return 0.5 * (far(body) - potential) * (far(body) + potential - 2.0 * hottest);
  }
  [[nodiscard]] double at_contact(std::size_t body) const { return in_body(body, contact.at(body)); }
};

/// Where the potential is that of the largest temperature: the temperature is the same on both sides of the contact area.
Potentials with_equal_temperatures(const std::array<HotConductor, 2>& bodies, double voltage,
                                   const std::array<double, 2>& contact)
{
  // Each temperature is defined for potentials between the ends, where no body is colder than far away but for the other's bulk.
  const auto difference = [&](double hottest)
  {
    const Potentials p{voltage, contact, hottest};
    const double lower = bodies[0].temperature_at(p.at_contact(0)), upper = bodies[1].temperature_at(p.at_contact(1));
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
double flow_in(const HotConductor& body, std::size_t index, const Potentials& p)
{
  const auto conductance = [&](double potential)
  { return 1.0 / body.resistivity_at(body.temperature_at(p.in_body(index, potential))); };
  return index == 0 ? integral(conductance, p.contact[0], p.voltage) : integral(conductance, 0.0, p.contact[1]);
}

/// The potentials for a voltage, of which a given part drops in the film.
Potentials potentials(const std::array<HotConductor, 2>& bodies, double voltage, double drop)
{
  const auto with_contact = [&](double lower) {
    return with_equal_temperatures(bodies, voltage, {lower, lower - drop});
  };
  const auto excess = [&](double lower)
  {
    const Potentials p = with_contact(lower);
    return flow_in(bodies[0], 0, p) - flow_in(bodies[1], 1, p);
  };
  return with_contact(root(excess, drop, voltage));
}

HotContact hot_contact_of(const std::array<HotConductor, 2>& bodies, const Potentials& p)
{
  const double interface = bodies[0].temperature_at(p.at_contact(0));
  double largest = std::max(bodies[0].temperature, bodies[1].temperature);
  if (p.hottest > p.contact[0] && p.hottest <= p.voltage)
    largest = bodies[0].temperature_at(p.in_body(0, p.hottest));
  else if (p.hottest < p.contact[1] && p.hottest >= 0.0)
    largest = bodies[1].temperature_at(p.in_body(1, p.hottest));
  else if (p.hottest >= p.contact[1] && p.hottest <= p.contact[0])
    largest = interface;
  return {p.voltage, flow_in(bodies[0], 0, p), interface, largest, p.contact, p.hottest};
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

HotContact hot_contact(const std::array<HotConductor, 2>& bodies, double voltage, double film)
{
  if (!(voltage > 0.0))
    return {.interface = nan, .temperature = std::max(bodies[0].temperature, bodies[1].temperature)};
  if (film == 0.0)
    return hot_contact_of(bodies, potentials(bodies, voltage, 0.0));
  const auto excess = [&](double drop)
  { return film * flow_in(bodies[0], 0, potentials(bodies, voltage, drop)) - drop; };
  return hot_contact_of(bodies, potentials(bodies, voltage, root(excess, 0.0, voltage)));
}

double temperature_in(const std::array<HotConductor, 2>& bodies, const HotContact& contact, std::size_t body,
                      double share)
{
  const Potentials p{contact.voltage, contact.contact, contact.hottest};
  return bodies.at(body).temperature_at(p.in_body(body, p.far(body) + share * (p.contact.at(body) - p.far(body))));
}

Conductor as_constant(const std::array<HotConductor, 2>& bodies, const HotContact& contact, std::size_t body)
{
  const HotConductor& at = bodies.at(body);
  const double t = at.temperature;
  if (!(contact.flow > 0.0))
    return {at.resistivity_at(t), at.conductivity_at(t), t};
  const Potentials p{contact.voltage, contact.contact, contact.hottest};
  const double resistivity = std::abs(p.far(body) - p.contact.at(body)) / contact.flow;
  const double rise = contact.interface - t, product = p.at_contact(body) / rise;
  constexpr double none = 1e-6; // [K]
  return {resistivity, std::abs(rise) > none ? product / resistivity : at.conductivity_at(t), t};
}

std::optional<HotContact> hot_contact_of_current(const std::array<HotConductor, 2>& bodies, double flow, double film)
{
  if (!(flow > 0.0))
    return hot_contact(bodies, 0.0);
  constexpr double hottest = 1e5; // [deg C]
  const double drop = film * flow;
  const auto at = [&](double constriction) { return potentials(bodies, drop + constriction, drop); };
  const auto flow_at = [&](double constriction) { return flow_in(bodies[0], 0, at(constriction)); };
  double high =
      flow * (bodies[0].resistivity_at(bodies[0].temperature) + bodies[1].resistivity_at(bodies[1].temperature));
  while (!(flow_at(high) >= flow))
    if (!(hot_contact_of(bodies, at(high)).temperature < hottest))
      return std::nullopt;
    else
      high *= 1.1;
  return hot_contact_of(bodies, at(root([&](double v) { return flow - flow_at(v); }, 0.0, high)));
}

} // namespace brinell::contact
