// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <ios>
#include <memory>
#include <string>
#include <string_view>

/// Files as a whole: read, replaced in one piece, recognised as undamaged.
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
[[nodiscard]] std::string input_text(const std::filesystem::path& file, std::size_t largest = largest_input);

/// Replaces a file in one piece: readers see the old content or the new one. @throws IoError
void replace_file(const std::filesystem::path& path, std::string_view content);

/// 64 bits of what has been added, in whatever pieces: XXH3, which leaves one damage in 2^64 unnoticed. It is no signature: who damages
/// on purpose can mend the checksum too.
class Checksum
{
public:
  Checksum();
  ~Checksum();
  Checksum(const Checksum&) = delete;
  Checksum& operator=(const Checksum&) = delete;

  void add(std::string_view bytes);
  /// Sixteen hexadecimal digits.
  [[nodiscard]] std::string text() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

[[nodiscard]] std::string checksum(std::string_view bytes);

/// A file that is written under its name with .part, and takes its name when it is complete.
/// @throws IoError (all members)
class Replacement
{
public:
  explicit Replacement(std::filesystem::path path);
  /// Removes a file that was not complete.
  ~Replacement();
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;

  /// To be written, by `write` or another way.
  [[nodiscard]] const std::filesystem::path& part() const { return part_; }
  /// @param mode  std::ios::trunc: this is the content; std::ios::app: it comes after what is there
  void write(std::string_view content, std::ios::openmode mode) const;
  /// To be asked before the file is written, by whatever creates it anew: HDF5 crashes when a full disk does not let it close a
  /// file. @throws IoError unless there is room for so many bytes
  void require_room(std::uintmax_t bytes) const;
  /// Adds the checksum of the file under a mark: HDF5 does not mind what comes after its own.
  void seal(std::string_view mark) const;
  void commit();

private:
  [[nodiscard]] IoError failed(const std::string& cause) const;

  std::filesystem::path path_, part_;
  bool is_committed_ = false;
};

/// @throws IoError unless the file is as it was written
void require_seal(const std::filesystem::path& path, std::string_view mark);

[[nodiscard]] IoError damaged_file(const std::filesystem::path& path, std::string_view how = "");

/// Where the first byte is that is not UTF-8; the size if there is none.
[[nodiscard]] std::size_t valid_utf8(std::string_view text);

} // namespace brinell::io
