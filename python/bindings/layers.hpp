// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/green/elastic_stack.hpp"

#include <tuple>
#include <vector>

namespace brinell::python
{

/// Thickness, Young's modulus and Poisson's ratio of layers, from the surface down.
using Layers = std::vector<std::tuple<double, double, double>>;

inline ElasticStack stack_of(const Layers& layers, const constitutive::Material& substrate)
{
  ElasticStack stack{{}, substrate.elastic};
  for (const auto& [thickness, young_modulus, poisson_ratio] : layers)
    stack.layers.push_back({thickness, {young_modulus, poisson_ratio}});
  return stack;
}

} // namespace brinell::python
