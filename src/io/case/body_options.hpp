// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/hardening.hpp"
#include "brinell/simulation/shape.hpp"
#include "brinell/simulation/texture.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

/// Shapes, textures and hardening laws of the case file. The schema takes names and keys from here, the reader the factory
/// functions.
namespace brinell::io
{

/// One shape, texture or hardening law.
template <typename Product>
struct Option
{
  std::string name;              ///< the choice in the case file
  std::vector<std::string> keys; ///< keys of its parameters
  Product (*make)(const double* number) =
      nullptr;          ///< makes it from the parameters; nullptr: it needs more than numbers
  std::string source{}; ///< entry in references.bib
};

[[nodiscard]] const std::vector<Option<simulation::Shape>>& shape_options();
[[nodiscard]] const std::vector<Option<simulation::Texture>>& texture_options();
[[nodiscard]] const std::vector<Option<constitutive::HardeningLaw>>& law_options();

/// Names of the options that have a key, or of all options if the key is empty.
template <typename Product>
std::vector<std::string> names_of(const std::vector<Option<Product>>& options, std::string_view key = "")
{
  std::vector<std::string> names;
  for (const Option<Product>& option : options)
    if (key.empty() || std::find(option.keys.begin(), option.keys.end(), key) != option.keys.end())
      names.push_back(option.name);
  return names;
}

} // namespace brinell::io
