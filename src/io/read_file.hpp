// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <string_view>

namespace brinell::io
{

/// Files of a case are read whole, with all that is made of them: far beyond any that a person writes or an instrument measures.
inline constexpr std::size_t largest_input = 100'000'000; // bytes

/// Hands the content to `take`, block by block. Devices and pipes may have no end, or never begin: they are refused.
/// @throws InputError if there is no such file, it is not a regular one or larger than `largest`: says so after the file's
/// name, that the caller puts before it; IoError, with the name, if it cannot be read
void read_blocks(const std::filesystem::path& file, std::size_t largest,
                 const std::function<void(std::string_view)>& take);

/// The content, without the mark that may say that it is UTF-8 (BOM).
/// @throws as read_blocks
[[nodiscard]] std::string input_text(const std::filesystem::path& file);

/// The checksum of a file of any size.
/// @throws as read_blocks
[[nodiscard]] std::string file_checksum(const std::filesystem::path& file);

/// Where the first byte is that is not UTF-8; the size if there is none.
[[nodiscard]] std::size_t valid_utf8(std::string_view text);

} // namespace brinell::io
