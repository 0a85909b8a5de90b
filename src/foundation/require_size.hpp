// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"

#include <cstddef>
#include <fmt/format.h>
#include <span>

namespace brinell
{

/// Argument check of public functions: throws unless `field` has the size that its grid requires.
/// @param field_name  e.g. "HalfSpace::deviatoric_stress: the stress"
/// @throws InternalError with both sizes
inline void require_size(const char* field_name, std::span<const double> field, std::size_t expected)
{
  if (field.size() != expected)
    throw InternalError(fmt::format("{} has {} values, its grid asks for {}", field_name, field.size(), expected));
}

} // namespace brinell
