// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"

#include <fmt/format.h>

#include <string_view>

namespace brinell::reference
{

/// @throws InputError unless lowest < value <= highest (NaN is outside).
inline void require_within(double value, double lowest, double highest, std::string_view name)
{
  if (!(value > lowest && value <= highest))
    throw InputError(fmt::format("{} = {} is outside ({}, {}].", name, value, lowest, highest));
}

/// @throws InputError unless 0 < value.
inline void require_positive(double value, std::string_view name)
{
  if (!(value > 0.0))
    throw InputError(fmt::format("{} = {} must be positive.", name, value));
}

/// @throws InputError unless 0 <= value.
inline void require_not_negative(double value, std::string_view name)
{
  if (!(value >= 0.0))
    throw InputError(fmt::format("{} = {} must not be negative.", name, value));
}

} // namespace brinell::reference
