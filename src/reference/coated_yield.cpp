// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/stack.hpp"
#include "brinell/reference/coated_contact.hpp"
#include "panels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace brinell::reference
{

namespace
{

using Strength = std::function<double(std::size_t layer, double depth)>;

constexpr double depth_step = 0.05, radial_step = 0.1, deepest = 2.5, widest = 1.2; // contact radii
constexpr std::size_t points_along_r = 13;                                          // widest / radial_step + 1
constexpr double steps_of_layer = 4.0;                                              // at least

struct Level
{
  std::size_t layer;
  double depth;
};

/// Depths at which the stress is looked at: both sides of each interface among them.
std::vector<Level> levels_of(const ElasticStack& body, double a)
{
  double top = 0.02 * a;
  if (!body.layers.empty())
    top = std::min(top, 0.25 * body.layers.front().thickness);
  std::vector<Level> levels;
  double end = 0.0;
  for (std::size_t layer = 0; layer <= body.layers.size(); ++layer)
  {
    end = layer < body.layers.size() ? end + body.layers[layer].thickness : std::numeric_limits<double>::infinity();
    const double bottom = std::max(top, std::min(end, deepest * a)); // deeper the stress falls: the top counts
    const auto steps = std::max(steps_of_layer, std::ceil((bottom - top) / (depth_step * a)));
    for (double step = 0.0; step <= (bottom > top ? steps : 0.0); ++step)
      levels.push_back({layer, top + (bottom - top) * step / steps});
    top = end;
  }
  return levels;
}

/// Sums over the waves for one point: of rr + tt, rr - tt, zz and rz.
struct Sums
{
  double plane = 0.0, difference = 0.0, zz = 0.0, rz = 0.0;

  [[nodiscard]] double von_mises() const
  {
    const double rr = 0.5 * (plane + difference), tt = 0.5 * (plane - difference);
    return std::sqrt(0.5 * ((rr - tt) * (rr - tt) + (tt - zz) * (tt - zz) + (zz - rr) * (zz - rr)) + 3.0 * rz * rz);
  }
};

/// Bessel functions J0, J1, J2 at all points along r.
std::array<std::array<double, 3>, points_along_r> bessel_at(double x)
{
  std::array<std::array<double, 3>, points_along_r> values{};
  values[0] = {1.0, 0.0, 0.0};
  for (std::size_t i = 1; i < points_along_r; ++i)
  {
    const double argument = x * radial_step * static_cast<double>(i);
    const double zero = ::j0(argument), one = ::j1(argument);
    const double two = argument < 0.01 ? argument * argument / 8.0 : 2.0 * one / argument - zero;
    values[i] = {zero, one, two};
  }
  return values;
}

std::vector<Sums> stress_at(const CoatedContact& contact, const ElasticStack& body, const std::vector<Level>& levels)
{
  // Of a wave down to a level; its part of the pressure and its Bessel functions decay as well.
  constexpr double decays = 12.0;
  const double a = contact.contact_radius();
  std::vector<Sums> sums(levels.size() * points_along_r);
  constexpr double longest = 1e-3;
  for_each_wave(decays * a / levels.front().depth, longest * std::min(1.0, a / levels.back().depth),
                [&](double x, double weight)
                {
                  const double k = x / a;
                  const green::StackWave wave(body, k);
                  const auto field = wave.field_of(green::WaveLoad::pressure);
                  const double factor = weight / a * k * contact.wave_of_pressure(k);
                  const auto bessel = bessel_at(x);
                  for (std::size_t l = 0; l < levels.size() && k * levels[l].depth < 2.0 * decays; ++l)
                  {
                    const green::WaveStress s =
                        wave.stress(green::WaveLoad::pressure, field, levels[l].layer, levels[l].depth);
                    for (std::size_t i = 0; i < points_along_r; ++i)
                    {
                      Sums& sum = sums[l * points_along_r + i];
                      sum.plane += factor * (s.ll + s.tt) * bessel[i][0];
                      sum.difference -= factor * (s.ll - s.tt) * bessel[i][2];
                      sum.zz += factor * s.zz * bessel[i][0];
                      sum.rz -= factor * s.lz * bessel[i][1];
                    }
                  }
                });
  return sums;
}

} // namespace

CoatedPeak peak_stress(const CoatedContact& contact, const ElasticStack& body, const Strength& strength)
{
  const std::vector<Level> levels = levels_of(body, contact.contact_radius());
  const std::vector<Sums> sums = stress_at(contact, body, levels);
  CoatedPeak peak;
  for (std::size_t l = 0; l < levels.size(); ++l)
    for (std::size_t i = 0; i < points_along_r; ++i)
      if (const double ratio = sums[l * points_along_r + i].von_mises() / strength(levels[l].layer, levels[l].depth);
          ratio > peak.ratio)
        peak = {ratio, radial_step * static_cast<double>(i) * contact.contact_radius(), levels[l].depth,
                levels[l].layer};
  return peak;
}

std::optional<CoatedYield> coated_first_yield(double radius, const ElasticStack& lower, const ElasticStack& upper,
                                              const Strength& lower_strength, const Strength& upper_strength)
{
  double widest_contact = radius;
  for (const ElasticStack& body : {lower.merged(), upper.merged()})
    if (!body.is_homogeneous())
      widest_contact = std::min(widest_contact, body.layers.front().thickness / CoatedContact::thinnest);
  const auto yield_at = [&](double a)
  {
    const CoatedContact contact(radius, a, lower, upper);
    CoatedYield yield{contact.load(), contact.approach(), a, contact.pressure(0.0), false, {}};
    if (lower_strength)
      yield.place = peak_stress(contact, lower, lower_strength);
    if (upper_strength)
      if (const CoatedPeak peak = peak_stress(contact, upper, upper_strength); peak.ratio > yield.place.ratio)
      {
        yield.place = peak;
        yield.in_upper = true;
      }
    return yield;
  };
  // In a homogeneous body the stress is proportional to a: a step with this rule ends the search there, and brackets it elsewhere.
  constexpr double tolerance = 1e-4, largest_step = 30.0;
  constexpr int most_steps = 60;
  double below = 0.0, above = std::numeric_limits<double>::infinity(), a = 0.01 * widest_contact;
  for (int step = 0; step < most_steps; ++step)
  {
    const CoatedYield yield = yield_at(a);
    const double ratio = yield.place.ratio;
    if (std::abs(ratio - 1.0) < tolerance)
      return yield;
    if (ratio == 0.0 || (ratio < 1.0 && a == widest_contact))
      return std::nullopt;
    (ratio < 1.0 ? below : above) = a;
    double next = std::min(a * std::clamp(1.0 / ratio, 1.0 / largest_step, largest_step), widest_contact);
    if (!(next > below && next < above) || step % 4 == 3)
      next = std::isinf(above) ? next : below > 0.0 ? std::sqrt(below * above) : next;
    a = next;
  }
  return std::nullopt;
}

} // namespace brinell::reference
