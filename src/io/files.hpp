// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <ios>
#include <string>
#include <string_view>

/// Whole files: reading, atomic replacement, checksums.
namespace brinell::io
{

/// Limit for files of a case, which are read into memory: far larger than any file written by a person or measured by an
/// instrument.
inline constexpr std::size_t largest_input = 100'000'000; // bytes

/// Passes the content to `consume`, block by block. Devices and pipes are refused, because they may have no end, or never deliver
/// data.
/// @throws InputError if there is no such file, or if it is not a regular file or larger than `largest`; the text is meant to
/// follow the file's name, which the caller adds. IoError, with the name, if it cannot be read
void read_blocks(const std::filesystem::path& file, std::size_t largest,
                 const std::function<void(std::string_view)>& consume);

/// The content, without a byte order mark of UTF-8 (BOM). A file that begins with the mark of UTF-16 is converted to UTF-8.
/// @throws as read_blocks
[[nodiscard]] std::string input_text(const std::filesystem::path& file, std::size_t largest = largest_input);

/// Replaces a file atomically: readers see the old content or the new one.
/// @throws IoError
void replace_file(const std::filesystem::path& path, std::string_view content);

/// 64-bit checksum (XXH3), sixteen hexadecimal digits. Damage goes unnoticed with a probability of 2^-64. It is not a signature
/// and does not protect against manipulation.
[[nodiscard]] std::string checksum(std::string_view bytes);

/// A file that is written under its name with the suffix .part, and renamed when it is complete.
/// @throws IoError (all members)
class Replacement
{
public:
  explicit Replacement(std::filesystem::path path);
  /// Removes a file that was not complete.
  ~Replacement();
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;

  /// Path of the temporary file, to be written by `write` or in another way.
  [[nodiscard]] const std::filesystem::path& part() const { return part_; }
  /// @param mode  std::ios::trunc: replaces the content; std::ios::app: appends to it
  void write(std::string_view content, std::ios::openmode mode) const;
  /// Checks that the disk has room for a file of this size. To be called before HDF5 writes the file, because HDF5 crashes if it
  /// cannot close a file on a full disk. @throws IoError if there is not enough room
  void require_room(std::uintmax_t bytes) const;
  /// Appends a mark and the checksum of the file. HDF5 ignores bytes after the end of its own data.
  void seal(std::string_view mark) const;
  void commit();

private:
  [[nodiscard]] IoError failed(const std::string& cause) const;

  std::filesystem::path path_, part_;
  bool is_committed_ = false;
};

/// Checks mark and checksum of a sealed file.
/// @throws IoError if the file is missing or damaged
void require_seal(const std::filesystem::path& path, std::string_view mark);

/// Error for a missing or damaged file of a stopped run.
/// @param how  kind of damage; may be empty
[[nodiscard]] IoError damaged_file(const std::filesystem::path& path, std::string_view how = "");

/// Position of the first byte that is not valid UTF-8; the size of the text if there is none.
[[nodiscard]] std::size_t valid_utf8(std::string_view text);

/// UTF-8 of a text in UTF-16. A half of a pair of surrogates becomes U+FFFD.
[[nodiscard]] std::string from_utf16(std::string_view bytes, bool is_big_endian);

} // namespace brinell::io
