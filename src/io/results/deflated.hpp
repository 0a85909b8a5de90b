// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

namespace brinell::io
{

/// Numbers as the filters shuffle and deflate of HDF5 leave them: the first bytes of all numbers, then their second ones and so on,
/// as a zlib stream. HDF5 does one chunk at a time; this may be called by several threads.
/// @param level  1: fast, to 9: small
[[nodiscard]] std::vector<unsigned char> shuffled_and_deflated(std::span<const double> numbers, int level);

} // namespace brinell::io
