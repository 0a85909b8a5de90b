// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/schema.hpp"
#include "raw_case.hpp"

namespace brinell::io
{

/// A written value as the entry wants it, in SI.
/// @param pure  the number carries no dimension here (Entry::pure_if holds)
/// @throws InputError; its text continues a sentence that begins with "key = value"
[[nodiscard]] Value converted(const Raw& raw, const Entry& entry, bool pure);

} // namespace brinell::io
