// SPDX-License-Identifier: BSD-3-Clause
#include "stack_heat.hpp"

#include <cmath>
#include <limits>

namespace brinell::green
{

namespace
{

using Complex = std::complex<double>;

/// e^{-a s}, 0 for infinite s.
template <typename Number>
Number decayed(const Number& a, double s)
{
  return std::isinf(s) ? Number{} : std::exp(-a * s);
}

} // namespace

/// From the substrate upwards the admittance K q (1 - x)/(1 + x), with x the reflection at the bottom seen from the top, then downwards the
/// temperature.
StackHeat::StackHeat(const ThermalStack& stack, double k, Complex rate, double reference) : k_(k)
{
  const std::size_t count = stack.layers.size() + 1;
  std::vector<Complex> reflected(count);
  Complex beneath;
  double top = 0.0;
  layers_.reserve(count);
  for (std::size_t j = 0; j < count; ++j)
  {
    const double diffusivity = stack.of_layer(j).diffusivity();
    const double thickness = j + 1 < count ? stack.layers[j].thickness : std::numeric_limits<double>::infinity();
    layers_.push_back(
        {top, thickness, std::sqrt(k * k * (1.0 - reference / diffusivity) + rate / diffusivity), {}, {}});
    top += thickness;
  }
  const auto admittance = [&](std::size_t j) { return stack.of_layer(j).conductivity * layers_[j].q; };
  const auto seen = [&](std::size_t j) { return reflected[j] * decayed(layers_[j].q, 2.0 * layers_[j].thickness); };
  beneath = admittance(count - 1);
  for (std::size_t j = count - 1; j-- > 0;)
  {
    const Complex own = admittance(j);
    reflected[j] = (own - beneath) / (own + beneath);
    beneath = own * (1.0 - seen(j)) / (1.0 + seen(j));
  }
  at_surface_ = 1.0 / beneath;
  excess_ = 2.0 * seen(0) / (1.0 - seen(0)) / admittance(0);
  Complex at_top = at_surface_;
  for (std::size_t j = 0; j < count; ++j)
  {
    Layer& layer = layers_[j];
    layer.down = at_top / (1.0 + seen(j));
    const Complex arrived = layer.down * decayed(layer.q, layer.thickness);
    layer.up = reflected[j] * arrived;
    at_top = arrived + layer.up;
  }
}

Complex StackHeat::at(std::size_t layer, double depth) const
{
  const Layer& l = layers_.at(layer);
  const double from_top = depth - l.top;
  return l.down * std::exp(-l.q * from_top) + l.up * decayed(l.q, l.thickness - from_top);
}

namespace
{

/// Integral over x' from 0 to x of e^{-k (x - x')} e^{-q x'}.
Complex along(double k, Complex q, double x)
{
  if (std::isinf(x))
    return {};
  const Complex apart = (q - k) * x;
  constexpr double small = 1e-2;
  if (std::abs(apart) < small) // the root of the heat is that of the stress
    return x * std::exp(-k * x) * (1.0 - apart * (0.5 - apart * (1.0 / 6.0 - apart * (1.0 / 24.0 - apart / 120.0))));
  return (std::exp(-k * x) - std::exp(-q * x)) / (q - k);
}

/// Integral over x' from 0 to x of e^{-k x'} e^{-q x'}.
Complex against(double k, Complex q, double x)
{
  return (1.0 - decayed(q + k, x)) / (q + k);
}

/// Heat above and beneath a depth, with the decay from there: integrals of e^{-k |z - z'|} T.
struct Sides
{
  Complex above, beneath;
};

Sides sides(double k, const StackHeat::Layer& layer, double depth)
{
  const double x = depth - layer.top, y = layer.thickness - x;
  return {layer.down * along(k, layer.q, x) + layer.up * decayed(layer.q, y) * against(k, layer.q, x),
          layer.up * along(k, layer.q, y) + layer.down * std::exp(-layer.q * x) * against(k, layer.q, y)};
}

} // namespace

StackExpansion::StackExpansion(const ElasticStack& elastic, const ThermalStack& thermal, double k)
    : k_(k), wave_(elastic, k > 0.0 ? k : 1.0)
{
  const std::size_t count = wave_.layers().size();
  for (std::size_t j = 0; j < count; ++j)
  {
    const Elastic& body = elastic.of_layer(j);
    mu_.push_back(body.shear_modulus());
    strain_.push_back(thermal.of_layer(j).expansion * (1.0 + body.poisson_ratio) / (1.0 - body.poisson_ratio));
  }
  for (std::size_t end = 0; end < 2 * count && k > 0.0; ++end)
  {
    StackWave::Field unit(count);
    (end % 2 == 0 ? unit[end / 2].down : unit[end / 2].up).a = 1.0;
    const StackWave::Field& field = fields_.emplace_back(wave_.field_of(unit));
    const auto [l, z, t] = wave_.displacement(WaveLoad::pressure, field, 0, 0.0);
    surface_.factors.push_back({.u_l = l, .u_z = z});
  }
}

void StackExpansion::add_depth(std::size_t layer, double depth)
{
  Depth& added = depths_.emplace_back(Depth{layer, depth, {}});
  added.factors.reserve(fields_.size());
  for (const StackWave::Field& field : fields_)
  {
    const WaveStress stress = wave_.stress(WaveLoad::pressure, field, layer, depth);
    added.factors.push_back({.ll = stress.ll, .zz = stress.zz, .lz = stress.lz});
  }
}

/// Waves that the heat of each layer sends to its bottom and to its top: a dilatation sends only those of the kind a.
std::vector<Complex> StackExpansion::arriving(const StackHeat& heat) const
{
  std::vector<Complex> waves;
  const auto& layers = heat.layers();
  waves.reserve(2 * layers.size());
  for (std::size_t j = 0; j < layers.size(); ++j)
  {
    const double scale = mu_[j] * k_ * strain_[j];
    const bool is_substrate = std::isinf(layers[j].thickness);
    waves.push_back(is_substrate ? Complex{} : scale * sides(k_, layers[j], layers[j].top + layers[j].thickness).above);
    waves.push_back(scale * sides(k_, layers[j], layers[j].top).beneath);
  }
  return waves;
}

void StackExpansion::find(const StackHeat& heat, std::vector<Stress>& stresses, Displacement& displacement) const
{
  if (k_ == 0.0)
    return find_uniform(heat, stresses, displacement);
  const std::vector<Complex> waves = arriving(heat);
  stresses.resize(depths_.size());
  for (std::size_t d = 0; d < depths_.size(); ++d)
  {
    const auto& [layer, depth, factors] = depths_[d];
    const Sides own = sides(k_, heat.layers()[layer], depth);
    const double scale = mu_[layer] * k_ * strain_[layer];
    const Complex temperature = heat.at(layer, depth), both = scale * (own.above + own.beneath);
    Stress& stress = stresses[d];
    stress = {temperature, both - 2.0 * mu_[layer] * strain_[layer] * temperature, -both,
              scale * (own.above - own.beneath)};
    for (std::size_t end = 0; end < waves.size(); ++end)
    {
      stress.ll += factors[end].ll * waves[end];
      stress.zz += factors[end].zz * waves[end];
      stress.lz += factors[end].lz * waves[end];
    }
  }
  // The heat of the first layer moves the surface by its own wave upwards, too.
  const Complex own = waves[1] / (2.0 * mu_.front() * k_);
  displacement = {-own, own};
  for (std::size_t end = 0; end < waves.size(); ++end)
  {
    displacement.z += surface_.factors[end].u_z * waves[end];
    displacement.l += surface_.factors[end].u_l * waves[end];
  }
}

/// Expansion along z only.
void StackExpansion::find_uniform(const StackHeat& heat, std::vector<Stress>& stresses,
                                  Displacement& displacement) const
{
  stresses.resize(depths_.size());
  for (std::size_t d = 0; d < depths_.size(); ++d)
  {
    const std::size_t layer = depths_[d].layer;
    const Complex temperature = heat.at(layer, depths_[d].depth);
    stresses[d] = {temperature, -2.0 * mu_[layer] * strain_[layer] * temperature, {}, {}};
  }
  displacement = {};
  for (std::size_t j = 0; j < heat.layers().size(); ++j)
    displacement.z -= strain_[j] * sides(0.0, heat.layers()[j], heat.layers()[j].top).beneath;
}

} // namespace brinell::green
