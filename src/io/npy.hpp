// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"

#include <filesystem>
#include <span>
#include <string>

/// NumPy files (.npy) with one table of numbers, for measured heights; text would take three times the space and a hundred times
/// the time.
namespace brinell::io
{

/// @throws InputError (without the file's name) if it is not such a file, or is not a table of real numbers; IoError
[[nodiscard]] HeightTable read_npy(const std::filesystem::path& file);

/// Whether a file is there and begins as a .npy file, whatever its ending.
[[nodiscard]] bool is_npy(const std::filesystem::path& file);

/// The content of a .npy file with these numbers, row by row.
[[nodiscard]] std::string npy_content(std::span<const double> values, std::size_t columns);

} // namespace brinell::io
