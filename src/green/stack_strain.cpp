// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/stack_strain.hpp"

#include <cmath>
#include <limits>

namespace brinell::green
{

using Complex = std::complex<double>;

StackStrain::StackStrain(const StackWave& wave, std::size_t layer, double from, double to, const WaveStrain& strain)
    : StackStrain(wave, layer, from, to, strain, false)
{
}

StackStrain StackStrain::sheet(const StackWave& wave, std::size_t layer, double depth, const WaveStrain& strain)
{
  return {wave, layer, depth, depth, strain, true};
}

StackStrain::StackStrain(const StackWave& wave, std::size_t layer, double from, double to, const WaveStrain& strain,
                         bool is_sheet)
    : wave_(wave), layer_(layer), from_(from), to_(to), strain_(strain), is_sheet_(is_sheet)
{
  const StackWave::Layer& l = wave.layers().at(layer);
  const double k = wave.wavenumber();
  const Wave down = emitted(to - from, 1.0), up = emitted(to - from, -1.0);
  const double below = l.x - k * (to - l.top), above = k * (from - l.top);
  const auto field = [&](const auto& part)
  {
    const auto of = [&](const Wave& w) -> StackWave::Wave { return {part(w.a), part(w.c), part(w.w)}; };
    StackWave::Field arriving(wave.layers().size());
    arriving[layer] = {StackWave::travelled(of(down), below), StackWave::travelled(of(up), above)};
    return wave.field_of(arriving);
  };
  real_ = field([](const Complex& z) { return z.real(); });
  imaginary_ = field([](const Complex& z) { return z.imag(); });
}

/// The wave that a part of the source emits, at the end of this part.
StackStrain::Wave StackStrain::emitted(double thickness, double direction) const
{
  const StackWave::Layer& l = wave_.layers()[layer_];
  const double k = wave_.wavenumber(), x = k * thickness;
  // Integrals of k e^{-kz} and k kz e^{-kz} over the thickness; for a sheet k per thickness.
  const double level = is_sheet_ ? k : -std::expm1(-x);
  const double rising = is_sheet_ ? 0.0 : level - x * std::exp(-x);
  const Complex turn(0.0, direction);
  const double a = strain_.ll + strain_.zz + 2.0 * l.nu * strain_.tt;
  const Complex c = strain_.ll - strain_.zz + 2.0 * turn * strain_.lz;
  const double plane = l.mu / (2.0 * (1.0 - l.nu));
  return {plane * (level * a - rising * c), plane * level * c, l.mu * level * (strain_.lt + turn * strain_.tz)};
}

void StackStrain::add_wave(const Wave& wave, double distance, double direction, const StackWave::Layer& medium,
                           double share, StrainedField& f) const
{
  const double s = wave_.wavenumber() * distance;
  if (s == std::numeric_limits<double>::infinity())
    return;
  const double e = share * std::exp(-s), compliance = e / (2.0 * medium.mu * wave_.wavenumber()), nu = medium.nu;
  const Complex i(0.0, 1.0);
  const auto& [a, c, w] = wave;
  const Complex ll = e * (a + (2.0 - s) * c), zz = e * (s * c - a);
  f.ll += ll;
  f.zz += zz;
  f.tt += nu * (ll + zz);
  f.lz += i * direction * e * (a + (1.0 - s) * c);
  f.lt += e * w;
  f.tz += i * direction * e * w;
  f.u_l -= i * compliance * (a + (2.0 * (1.0 - nu) - s) * c);
  f.u_z += direction * compliance * (a - (s + 1.0 - 2.0 * nu) * c);
  f.u_t -= 2.0 * i * compliance * w;
}

void StackStrain::add_own(double depth, StrainedField& f) const
{
  const StackWave::Layer& l = wave_.layers()[layer_];
  if (is_sheet_)
  {
    const double below = depth > from_ ? 1.0 : depth < from_ ? 0.0 : 0.5;
    add_wave(emitted(0.0, 1.0), std::abs(depth - from_), 1.0, l, below, f);
    add_wave(emitted(0.0, -1.0), std::abs(depth - from_), -1.0, l, 1.0 - below, f);
    return;
  }
  if (depth > from_)
    add_wave(emitted(std::min(depth, to_) - from_, 1.0), std::max(depth - to_, 0.0), 1.0, l, 1.0, f);
  if (depth < to_)
    add_wave(emitted(to_ - std::max(depth, from_), -1.0), std::max(from_ - depth, 0.0), -1.0, l, 1.0, f);
  if (depth >= from_ && depth <= to_)
  {
    const double held = -2.0 * l.mu / (1.0 - l.nu); // a layer held in its plane
    f.ll += held * (strain_.ll + l.nu * strain_.tt);
    f.tt += held * (strain_.tt + l.nu * strain_.ll);
    f.lt -= 2.0 * l.mu * strain_.lt;
  }
}

StrainedField StackStrain::at(std::size_t layer, double depth) const
{
  StrainedField field;
  const StackWave::Layer& l = wave_.layers().at(layer);
  const auto wave = [](const StackWave::Wave& re, const StackWave::Wave& im) -> Wave {
    return {{re.a, im.a}, {re.c, im.c}, {re.w, im.w}};
  };
  add_wave(wave(real_[layer].down, imaginary_[layer].down), depth - l.top, 1.0, l, 1.0, field);
  const double to_bottom = l.x / wave_.wavenumber() - (depth - l.top);
  add_wave(wave(real_[layer].up, imaginary_[layer].up), std::max(to_bottom, 0.0), -1.0, l, 1.0, field);
  if (layer == layer_)
    add_own(depth, field);
  return field;
}

} // namespace brinell::green
