// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

/// NumPy files (.npy) with one table of numbers, for measured heights; text would take three times the space and a hundred times
/// the time.
namespace brinell::io
{

/// @throws InputError (without the file's name) if it is not such a file, or is not a table of real numbers; IoError
[[nodiscard]] HeightTable read_npy(const std::filesystem::path& file);

/// Numbers on a lattice: x runs fastest, then y, then z.
struct NpyVolume
{
  std::array<std::size_t, 3> count{}; ///< along x, y and z; of a table [rows, x] all rows along y
  std::vector<double> values;
};

/// @throws InputError (without the file's name) if it is not such a file, or has neither two nor three axes; IoError
[[nodiscard]] NpyVolume read_npy_volume(const std::filesystem::path& file);

/// Whether a file is there and begins as a .npy file, whatever its ending.
[[nodiscard]] bool is_npy(const std::filesystem::path& file);

/// The content of a .npy file with these numbers, row by row.
[[nodiscard]] std::string npy_content(std::span<const double> values, std::size_t columns);

} // namespace brinell::io
