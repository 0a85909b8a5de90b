// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/hardening.hpp"
#include "brinell/green/elastic.hpp"

#include <optional>

namespace brinell::constitutive
{

/// An elastic material, elastic-plastic if it has a hardening law.
struct Material
{
  Elastic elastic;
  std::optional<HardeningLaw> hardening; ///< empty: the body stays elastic

  [[nodiscard]] bool is_plastic() const { return hardening.has_value(); }
  bool operator==(const Material&) const = default;
};

} // namespace brinell::constitutive
