// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/stack.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace brinell
{

double ElasticStack::thickness() const
{
  double sum = 0.0;
  for (const ElasticLayer& layer : layers)
    sum += layer.thickness;
  return sum;
}

std::size_t ElasticStack::layer_at(double depth) const
{
  double bottom = 0.0;
  std::size_t layer = 0;
  while (layer < layers.size() && (bottom += layers[layer].thickness) <= depth)
    ++layer;
  return layer;
}

ElasticStack ElasticStack::merged() const
{
  ElasticStack result{{}, substrate};
  for (const ElasticLayer& layer : layers)
    if (!result.layers.empty() && result.layers.back().elastic == layer.elastic)
      result.layers.back().thickness += layer.thickness;
    else
      result.layers.push_back(layer);
  if (!result.layers.empty() && result.layers.back().elastic == substrate)
    result.layers.pop_back();
  return result;
}

ElasticStack ElasticStack::without_top(double depth) const
{
  ElasticStack result{{}, substrate};
  for (const ElasticLayer& layer : layers)
  {
    const double left = layer.thickness - depth;
    depth = std::max(0.0, -left);
    if (left > 0.0)
      result.layers.push_back({left, layer.elastic});
  }
  return result;
}

namespace green
{

namespace
{

/// Displacement and traction of a wave at its origin: i k u_l, k u_z, sigma_lz / i, sigma_zz, in the order of the rows; the
/// displacements times 2 mu of the reference.
/// @param g  +1 for waves that go down, -1 for those that go up
struct State
{
  std::array<double, 4> a, c;
  State(double nu, double relative_compliance, double g)
      : a{relative_compliance, g * relative_compliance, g, -1.0}, c{2.0 * (1.0 - nu) * relative_compliance,
                                                                    -g * (1.0 - 2.0 * nu) * relative_compliance, g, 0.0}
  {
  }
};

/// Solves a system of four equations with four right-hand sides, by elimination with exchange of rows.
using System = std::array<std::array<double, 8>, 4>;
void solve(System& rows)
{
  for (std::size_t p = 0; p < 4; ++p)
  {
    std::size_t best = p;
    for (std::size_t r = p + 1; r < 4; ++r)
      if (std::abs(rows[r][p]) > std::abs(rows[best][p]))
        best = r;
    std::swap(rows[p], rows[best]);
    for (std::size_t c = p + 1; c < 8; ++c)
      rows[p][c] /= rows[p][p];
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t c = p + 1; r != p && c < 8; ++c)
        rows[r][c] -= rows[r][p] * rows[p][c];
  }
}

void require_valid(const ElasticStack& stack)
{
  const auto require = [](bool holds, const char* what, double value, const char* allowed)
  {
    if (!holds)
      throw InputError(fmt::format("a layered body: {} is {}; allowed: {}", what, value, allowed));
  };
  for (const ElasticLayer& layer : stack.layers)
  {
    require(layer.thickness > 0.0 && std::isfinite(layer.thickness), "the thickness of a layer", layer.thickness,
            "> 0 m");
    require(!layer.elastic.is_rigid() && layer.elastic.young_modulus > 0.0, "Young's modulus of a layer",
            layer.elastic.young_modulus, "> 0 Pa, finite");
    require(layer.elastic.poisson_ratio > -1.0 && layer.elastic.poisson_ratio < 0.5, "Poisson's ratio of a layer",
            layer.elastic.poisson_ratio, "> -1, < 0.5");
  }
  require(stack.substrate.young_modulus > 0.0, "Young's modulus of the substrate", stack.substrate.young_modulus,
          "> 0 Pa");
  require(stack.substrate.is_rigid() || (stack.substrate.poisson_ratio > -1.0 && stack.substrate.poisson_ratio < 0.5),
          "Poisson's ratio of the substrate", stack.substrate.poisson_ratio, "> -1, < 0.5");
}

} // namespace

StackWave::Wave StackWave::travelled(const Wave& wave, double s)
{
  const double decay = std::exp(-s);
  const double lag = s < std::numeric_limits<double>::infinity() ? s * decay : 0.0;
  return {decay * wave.a - lag * wave.c, decay * wave.c, decay * wave.w};
}

StackWave::Matrix StackWave::seen_from_top(const Layer& layer)
{
  const auto way = [&](const Wave& wave) { return travelled(layer.reflected * travelled(wave, layer.x), layer.x); };
  const Wave a = way({1.0, 0.0, 0.0}), c = way({0.0, 1.0, 0.0}), w = way({0.0, 0.0, 1.0});
  return {a.a, c.a, a.c, c.c, w.w};
}

/// Displacement and traction are continuous between two layers.
void StackWave::join(Layer& upper, const Layer& lower)
{
  const Matrix beneath = seen_from_top(lower);
  const State down(upper.nu, 1.0, 1.0), up(upper.nu, 1.0, -1.0);
  const double softer = upper.mu / lower.mu;
  const State below_down(lower.nu, softer, 1.0), below_up(lower.nu, softer, -1.0);
  System rows{};
  for (std::size_t r = 0; r < 4; ++r)
    rows[r] = {up.a[r],
               up.c[r],
               -(below_down.a[r] + below_up.a[r] * beneath.aa + below_up.c[r] * beneath.ca),
               -(below_down.c[r] + below_up.a[r] * beneath.ac + below_up.c[r] * beneath.cc),
               -down.a[r],
               -down.c[r],
               below_up.a[r],
               below_up.c[r]};
  solve(rows);
  upper.reflected = {rows[0][4], rows[0][5], rows[1][4], rows[1][5], 0.0};
  upper.transmitted = {rows[2][4], rows[2][5], rows[3][4], rows[3][5], 0.0};
  upper.lifted = {rows[0][6], rows[0][7], rows[1][6], rows[1][7], 0.0};
  upper.returned = {rows[2][6], rows[2][7], rows[3][6], rows[3][7], 0.0};
  // Across the wavevector the displacement is w / mu and the traction w g.
  const double compliance = softer * (1.0 + beneath.ww), traction = 1.0 - beneath.ww;
  upper.transmitted.ww = 2.0 / (compliance + traction);
  upper.reflected.ww = (compliance - traction) / (compliance + traction);
  upper.lifted.ww = 2.0 * softer / (compliance + traction);
  upper.returned.ww = (1.0 - softer) / (compliance + traction);
}

/// The bottom of a layer on a rigid base does not move.
void StackWave::clamp(Layer& layer)
{
  const State down(layer.nu, 1.0, 1.0), up(layer.nu, 1.0, -1.0);
  const double determinant = up.a[0] * up.c[1] - up.c[0] * up.a[1];
  const auto reflected = [&](const std::array<double, 4>& of) -> std::array<double, 2> {
    return {-(up.c[1] * of[0] - up.c[0] * of[1]) / determinant, -(up.a[0] * of[1] - up.a[1] * of[0]) / determinant};
  };
  const auto a = reflected(down.a), c = reflected(down.c);
  layer.reflected = {a[0], c[0], a[1], c[1], -1.0};
}

StackWave::StackWave(const ElasticStack& stack, double k) : k_(k), is_on_rigid_base_(stack.substrate.is_rigid())
{
  require_valid(stack);
  if (stack.is_homogeneous() && is_on_rigid_base_)
    throw InputError("a layered body: the substrate is rigid and there is no layer; allowed: one layer or more on a "
                     "rigid substrate");
  double top = 0.0;
  for (const ElasticLayer& layer : stack.layers)
  {
    layers_.push_back({.top = top,
                       .x = k * layer.thickness,
                       .nu = layer.elastic.poisson_ratio,
                       .mu = layer.elastic.shear_modulus(),
                       .reflected = {},
                       .transmitted = {},
                       .lifted = {},
                       .returned = {}});
    top += layer.thickness;
  }
  if (is_on_rigid_base_)
    clamp(layers_.back());
  else
    layers_.push_back({.top = top,
                       .x = std::numeric_limits<double>::infinity(),
                       .nu = stack.substrate.poisson_ratio,
                       .mu = stack.substrate.shear_modulus(),
                       .reflected = {},
                       .transmitted = {},
                       .lifted = {},
                       .returned = {}});
  for (std::size_t j = layers_.size() - 1; j-- > 0;)
    join(layers_[j], layers_[j + 1]);
}

StackWave::Field StackWave::field_of(WaveLoad load) const
{
  const Matrix r = seen_from_top(layers_.front());
  // Traction on the surface: sigma_zz is -a of both directions, sigma_lz / i is a + c of the downward wave minus that of the
  // upward one; sigma_tz likewise w.
  Wave wave;
  if (load == WaveLoad::across)
    wave.w = 1.0 / (1.0 - r.ww);
  else
  {
    const double za = 1.0 + r.aa, zc = r.ac;
    const double la = 1.0 - r.aa - r.ca, lc = 1.0 - r.ac - r.cc;
    const double determinant = za * lc - zc * la;
    wave = load == WaveLoad::pressure ? Wave{lc / determinant, -la / determinant, 0.0}
                                      : Wave{-zc / determinant, za / determinant, 0.0};
  }
  Field field;
  for (const Layer& layer : layers_)
  {
    const Wave at_bottom = travelled(wave, layer.x);
    field.push_back({wave, layer.reflected * at_bottom});
    wave = layer.transmitted * at_bottom;
  }
  if (is_on_rigid_base_)
    field.emplace_back();
  return field;
}

/// A wave F, C that goes up is cancelled by one with a = -F, c = C + 2 F that goes down, w by w: docs/theory/half-space.md
/// (free-surface). With the reflection B from beneath, the downward wave is S (v + B d) for upward waves v from sources.
StackWave::Matrix StackWave::from_free_surface() const
{
  const Matrix b = seen_from_top(layers_.front());
  // 1 - S B with S = (-1 0; 2 1).
  const double aa = 1.0 + b.aa, ac = b.ac, ca = -(2.0 * b.aa + b.ca), cc = 1.0 - (2.0 * b.ac + b.cc);
  const double determinant = aa * cc - ac * ca;
  return {(-cc - 2.0 * ac) / determinant, -ac / determinant, (ca + 2.0 * aa) / determinant, aa / determinant,
          1.0 / (1.0 - b.ww)};
}

namespace
{

StackWave::Wave sum(const StackWave::Wave& p, const StackWave::Wave& q)
{
  return {p.a + q.a, p.c + q.c, p.w + q.w};
}

} // namespace

/// From the deepest layer upwards, waves from beneath are passed on as if nothing came from above; then those from above follow.
StackWave::Field StackWave::field_of(const Field& arriving) const
{
  const std::size_t count = layers_.size();
  std::vector<Wave> from_beneath(count), at_top(count); // upwards, at the bottom and at the top
  for (std::size_t j = count; j-- > 0;)
  {
    const Layer& l = layers_[j];
    at_top[j] = sum(arriving[j].up, travelled(sum(l.reflected * arriving[j].down, from_beneath[j]), l.x));
    if (j > 0)
      from_beneath[j - 1] = layers_[j - 1].lifted * at_top[j];
  }
  Field field(count + (is_on_rigid_base_ ? 1 : 0));
  Wave down = from_free_surface() * at_top.front();
  for (std::size_t j = 0; j < count; ++j)
  {
    const Layer& l = layers_[j];
    const Wave at_bottom = sum(travelled(down, l.x), arriving[j].down);
    field[j] = {down, sum(l.reflected * at_bottom, from_beneath[j])};
    if (j + 1 < count)
      down = sum(l.transmitted * at_bottom, l.returned * at_top[j + 1]);
  }
  return field;
}

namespace
{

/// e^{-s} and s e^{-s} of a wave, or their means over a part of its way.
struct Decay
{
  double level, rising;
};

Decay decay_at(double s)
{
  const double level = std::exp(-s);
  return {level, std::isinf(s) ? 0.0 : s * level};
}

/// @param s      where the part begins
/// @param width  > 0
Decay mean_decay(double s, double width)
{
  if (std::isinf(s))
    return {0.0, 0.0};
  const double mean = -std::expm1(-width) / width;
  return {std::exp(-s) * mean, std::exp(-s) * ((1.0 + s) * mean - std::exp(-width))};
}

WaveStress stress_of(WaveLoad load, const StackWave::Waves& waves, const Decay& down, const Decay& up, double nu)
{
  const auto& [d, u] = waves;
  WaveStress s;
  if (load == WaveLoad::across)
  {
    s.lt = down.level * d.w + up.level * u.w;
    s.tz = up.level * u.w - down.level * d.w;
    return s;
  }
  s.ll = down.level * (d.a + 2.0 * d.c) - down.rising * d.c + up.level * (u.a + 2.0 * u.c) - up.rising * u.c;
  s.zz = down.rising * d.c - down.level * d.a + up.rising * u.c - up.level * u.a;
  s.tt = nu * (s.ll + s.zz);
  s.lz = down.level * (d.a + d.c) - down.rising * d.c - up.level * (u.a + u.c) + up.rising * u.c;
  if (load == WaveLoad::along)
    s.lz = -s.lz;
  return s;
}

} // namespace

WaveStress StackWave::stress(WaveLoad load, const Field& field, std::size_t layer, double depth) const
{
  const Layer& l = layers_.at(layer);
  const double s = k_ * (depth - l.top);
  return stress_of(load, field.at(layer), decay_at(s), decay_at(l.x - s), l.nu);
}

WaveStress StackWave::mean_stress(WaveLoad load, const Field& field, std::size_t layer, double from, double to) const
{
  const Layer& l = layers_.at(layer);
  const double s = k_ * (from - l.top), width = k_ * (to - from);
  return stress_of(load, field.at(layer), mean_decay(s, width), mean_decay(l.x - s - width, width), l.nu);
}

std::array<double, 3> StackWave::displacement(WaveLoad load, const Field& field, std::size_t layer, double depth) const
{
  const Layer& l = layers_.at(layer);
  const double s = k_ * (depth - l.top), f = 0.5 / (l.mu * k_), beta = 1.0 - 2.0 * l.nu;
  const Decay down = decay_at(s), up = decay_at(l.x - s);
  const auto& [d, u] = field.at(layer);
  if (load == WaveLoad::across)
    return {0.0, 0.0, 2.0 * f * (down.level * d.w + up.level * u.w)};
  const double along = down.level * (d.a + (1.0 + beta) * d.c) - down.rising * d.c +
                       up.level * (u.a + (1.0 + beta) * u.c) - up.rising * u.c;
  const double normal =
      down.level * (d.a - beta * d.c) - down.rising * d.c - up.level * (u.a - beta * u.c) + up.rising * u.c;
  return {f * along, f * normal, 0.0};
}

WaveCompliance StackWave::compliance() const
{
  const auto [by_pressure_l, by_pressure_z, none] =
      displacement(WaveLoad::pressure, field_of(WaveLoad::pressure), 0, 0.0);
  return {by_pressure_z, by_pressure_l, displacement(WaveLoad::along, field_of(WaveLoad::along), 0, 0.0)[0],
          displacement(WaveLoad::across, field_of(WaveLoad::across), 0, 0.0)[2]};
}

double largest_change(const std::function<double(double k)>& from, const std::function<double(double k)>& to,
                      double k_least, double k_largest)
{
  constexpr double per_octave = 16.0;
  const int waves = std::max(1, static_cast<int>(std::ceil(per_octave * std::log2(k_largest / k_least))));
  double largest = 0.0;
  for (int n = 0; n <= waves; ++n)
  {
    const double k = k_least * std::pow(k_largest / k_least, static_cast<double>(n) / waves);
    const double change = to(k) / from(k) - 1.0;
    if (std::abs(change) > std::abs(largest))
      largest = change;
  }
  return largest;
}

double change_of_compliance(const ElasticStack& from, const ElasticStack& to, double k_least, double k_largest)
{
  const auto of = [](const ElasticStack& stack)
  { return [&stack](double k) { return StackWave(stack, k).compliance().normal; }; };
  return largest_change(of(from), of(to), k_least, k_largest);
}

} // namespace green
} // namespace brinell
