// SPDX-License-Identifier: BSD-3-Clause
#include "io/files.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <unistd.h>
#include <vector>

#define XXH_INLINE_ALL // header only: then the xxHash library is not linked
#include <xxhash.h>

namespace brinell::io
{

namespace
{

namespace fs = std::filesystem;

constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

/// Checksum of the added data, independent of how they are split.
class Checksum
{
public:
  Checksum() { XXH3_64bits_reset(&state_); }
  void add(std::string_view bytes) { XXH3_64bits_update(&state_, bytes.data(), bytes.size()); }
  [[nodiscard]] std::string text() const { return fmt::format("{:016x}", XXH3_64bits_digest(&state_)); }

private:
  XXH3_state_t state_{};
};

/// The seal after the content of a sealed file.
std::string seal(std::string_view mark, std::string_view sum)
{
  return fmt::format("\n{} {}\n", mark, sum);
}

} // namespace

void read_blocks(const fs::path& file, std::size_t largest, const std::function<void(std::string_view)>& consume)
{
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::is_directory(status))
    throw InputError("is a folder; allowed: a file");
  if (fs::exists(status) && !fs::is_regular_file(status)) // reading a pipe could block
    throw InputError("is a device or a pipe; allowed: a file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw InputError("cannot be opened: no such file, or not readable");
  const auto too_large = [largest]
  { return InputError(fmt::format("is too large; allowed: up to {} MB", largest / 1'000'000)); };
  if (const std::uintmax_t size = fs::file_size(file, error); !error && size > largest)
    throw too_large();
  std::vector<char> block(1 << 20);
  std::size_t size = 0;
  while (stream.read(block.data(), std::ssize(block)) || stream.gcount() > 0)
  {
    const auto got = static_cast<std::size_t>(stream.gcount());
    size += got;
    if (size > largest) // checked while reading, as files in /proc report no size
      throw too_large();
    consume({block.data(), got});
  }
  if (stream.bad())
    throw IoError(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
}

std::string input_text(const fs::path& file, std::size_t largest)
{
  std::string text;
  read_blocks(file, largest, [&](std::string_view block) { text += block; });
  constexpr std::string_view mark = "\xef\xbb\xbf";
  if (text.starts_with(mark))
    text.erase(0, mark.size());
  if (const bool is_big_endian = text.starts_with("\xfe\xff"); is_big_endian || text.starts_with("\xff\xfe"))
    return from_utf16(std::string_view(text).substr(2), is_big_endian);
  return text;
}

void replace_file(const fs::path& path, std::string_view content)
{
  Replacement file(path);
  file.write(content, std::ios::trunc);
  file.commit();
}

Replacement::Replacement(fs::path path) : path_(std::move(path)), part_(path_)
{
  part_ += ".part";
}

Replacement::~Replacement()
{
  std::error_code ignored;
  if (!is_committed_)
    fs::remove(part_, ignored);
}

IoError Replacement::failed(const std::string& cause) const
{
  return IoError(fmt::format("{}: cannot be written: {}", path_.string(), cause));
}

void Replacement::write(std::string_view content, std::ios::openmode mode) const
{
  std::ofstream stream(part_, std::ios::binary | mode);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream)
    throw failed(std::strerror(errno));
}

void Replacement::require_room(std::uintmax_t bytes) const
{
  const int file = open(part_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0)
    throw failed(std::strerror(errno));
  // Unlike a query of the free disk space, this respects the limits of users and processes.
  const int cause = fallocate(file, 0, 0, static_cast<off_t>(bytes)) == 0 ? 0 : errno;
  close(file);
  std::error_code unknown;
  const std::uintmax_t available = fs::space(path_.parent_path(), unknown).available;
  const bool is_full = !unknown && available < bytes; // some file systems cannot allocate
  if (cause == ENOSPC || cause == EDQUOT || cause == EFBIG || (cause != 0 && is_full))
    throw failed(fmt::format("it needs up to {:.1f} MB, the disk has {:.1f} MB: {}", static_cast<double>(bytes) * 1e-6,
                             static_cast<double>(available) * 1e-6, std::strerror(cause)));
}

void Replacement::seal(std::string_view mark) const
{
  Checksum sum;
  read_blocks(part_, no_limit, [&](std::string_view block) { sum.add(block); });
  write(brinell::io::seal(mark, sum.text()), std::ios::app);
}

void Replacement::commit()
{
  std::error_code error;
  fs::rename(part_, path_, error);
  if (error)
    throw failed(error.message());
  is_committed_ = true;
}

std::string checksum(std::string_view bytes)
{
  Checksum sum;
  sum.add(bytes);
  return sum.text();
}

void require_seal(const fs::path& path, std::string_view mark)
{
  const std::size_t length = seal(mark, checksum("")).size();
  Checksum sum;
  std::string end; // the last bytes, which are the seal of an undamaged file
  try
  {
    read_blocks(path, no_limit,
                [&](std::string_view block)
                {
                  end += block;
                  const std::size_t inside = end.size() - std::min(end.size(), length);
                  sum.add(std::string_view(end).substr(0, inside));
                  end.erase(0, inside);
                });
  }
  catch (const InputError& error) // not a regular file
  {
    throw damaged_file(path, fmt::format("it {}", error.what()));
  }
  if (end != seal(mark, sum.text()))
    throw damaged_file(path);
}

IoError damaged_file(const fs::path& path, std::string_view how)
{
  std::error_code error;
  const bool is_there = fs::exists(path, error);
  const std::string state = !is_there ? "is gone" : how.empty() ? "is damaged" : fmt::format("is damaged: {}", how);
  return IoError(fmt::format("{}: {}; begin the run anew, without --resume", path.string(), state));
}

std::size_t valid_utf8(std::string_view text)
{
  /// The well-formed characters, by their first two bytes (Unicode, table 3-7); all other bytes are 80 to BF.
  struct Form
  {
    unsigned char first, last, second_first, second_last;
    std::size_t length;
  };
  constexpr Form forms[] = {{0x00, 0x7f, 0x00, 0x00, 1}, {0xc2, 0xdf, 0x80, 0xbf, 2}, {0xe0, 0xe0, 0xa0, 0xbf, 3},
                            {0xe1, 0xec, 0x80, 0xbf, 3}, {0xed, 0xed, 0x80, 0x9f, 3}, {0xee, 0xef, 0x80, 0xbf, 3},
                            {0xf0, 0xf0, 0x90, 0xbf, 4}, {0xf1, 0xf3, 0x80, 0xbf, 4}, {0xf4, 0xf4, 0x80, 0x8f, 4}};
  const auto is_between = [&](std::size_t i, unsigned char low, unsigned char high)
  {
    const auto byte = i < text.size() ? static_cast<unsigned char>(text[i]) : 0xff; // occurs in no character
    return byte >= low && byte <= high;
  };
  std::size_t i = 0;
  while (i < text.size())
  {
    const auto form =
        std::find_if(std::begin(forms), std::end(forms), [&](const Form& f) { return is_between(i, f.first, f.last); });
    if (form == std::end(forms))
      return i;
    for (std::size_t k = 1; k < form->length; ++k)
      if (!(k == 1 ? is_between(i + 1, form->second_first, form->second_last) : is_between(i + k, 0x80, 0xbf)))
        return i;
    i += form->length;
  }
  return i;
}

std::string from_utf16(std::string_view bytes, bool is_big_endian)
{
  const auto unit = [&](std::size_t i)
  {
    const auto first = static_cast<unsigned char>(bytes[i]), second = static_cast<unsigned char>(bytes[i + 1]);
    return static_cast<char32_t>(is_big_endian ? first << 8 | second : second << 8 | first);
  };
  const auto is_between = [](char32_t c, char32_t low, char32_t high) { return c >= low && c <= high; };
  std::string text;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
  {
    char32_t c = unit(i);
    if (is_between(c, 0xd800, 0xdbff) && i + 3 < bytes.size() && is_between(unit(i + 2), 0xdc00, 0xdfff))
      c = 0x10000 + ((c - 0xd800) << 10) + (unit(i += 2) - 0xdc00);
    if (is_between(c, 0xd800, 0xdfff))
      c = 0xfffd;
    const int following = c < 0x80 ? 0 : c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
    constexpr unsigned char lead[] = {0x00, 0xc0, 0xe0, 0xf0};
    text += static_cast<char>(lead[following] | (c >> (6 * following)));
    for (int k = following - 1; k >= 0; --k)
      text += static_cast<char>(0x80 | (c >> (6 * k) & 0x3f));
  }
  return text;
}

} // namespace brinell::io
