// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/constitutive/material.hpp"

#include <algorithm>

namespace brinell::constitutive
{

namespace
{

bool never_hardens(const HardeningLaw& law)
{
  return std::visit([](const auto& one) { return one.modulus_at(0.0) == 0.0; }, law);
}

} // namespace

std::vector<std::optional<HardeningLaw>> Material::laws() const
{
  std::vector<std::optional<HardeningLaw>> all;
  all.reserve(layers.size() + 1);
  for (const Coat& layer : layers)
    all.push_back(layer.hardening);
  all.push_back(hardening);
  return all;
}

bool Material::is_plastic() const
{
  return hardening.has_value() ||
         std::any_of(layers.begin(), layers.end(), [](const Coat& layer) { return layer.hardening.has_value(); });
}

bool Material::is_perfectly_plastic() const
{
  const auto perfect = [](const std::optional<HardeningLaw>& law) { return law && never_hardens(*law); };
  return (kinematic.empty() && perfect(hardening)) ||
         std::any_of(layers.begin(), layers.end(), [&](const Coat& layer) { return perfect(layer.hardening); });
}

const HardeningLaw& Material::law() const
{
  if (hardening)
    return *hardening;
  return *std::find_if(layers.begin(), layers.end(), [](const Coat& layer) { return layer.hardening.has_value(); })
              ->hardening;
}

const Elastic& Material::softest() const
{
  const Elastic* softest = &elastic;
  for (const Coat& layer : layers)
    if (layer.elastic.contact_compliance() > softest->contact_compliance())
      softest = &layer.elastic;
  return *softest;
}

ElasticStack Material::stack() const
{
  ElasticStack stack{{}, elastic};
  stack.layers.reserve(layers.size());
  for (const Coat& layer : layers)
    stack.layers.push_back({layer.thickness, layer.elastic});
  return stack;
}

ThermalStack Material::thermal_stack() const
{
  ThermalStack result{{}, thermal.value()};
  result.layers.reserve(layers.size());
  for (const Coat& layer : layers)
    result.layers.push_back({layer.thickness, layer.thermal.value()});
  return result;
}

bool Material::expands() const
{
  const auto does = [](const std::optional<Thermal>& part) { return part && part->expansion != 0.0; };
  return does(thermal) ||
         std::any_of(layers.begin(), layers.end(), [&](const Coat& layer) { return does(layer.thermal); });
}

ConductiveStack Material::conductors() const
{
  ConductiveStack stack{{}, electrical->resistivity_at(temperature)};
  stack.layers.reserve(layers.size());
  for (const Coat& layer : layers)
    stack.layers.push_back({layer.thickness, layer.electrical->resistivity_at(temperature)});
  return stack;
}

} // namespace brinell::constitutive
