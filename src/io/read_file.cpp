// SPDX-License-Identifier: BSD-3-Clause
#include "read_file.hpp"

#include "brinell/foundation/error.hpp"
#include "checksum.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace brinell::io
{

namespace
{

class Descriptor
{
public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor()
  {
    if (number_ >= 0)
      close(number_);
  }
  [[nodiscard]] int number() const { return number_; }

private:
  int number_;
};

InputError too_large(std::size_t largest)
{
  return InputError(fmt::format("is too large; allowed: up to {} MB", largest / 1'000'000));
}

} // namespace

void read_blocks(const std::filesystem::path& file, std::size_t largest,
                 const std::function<void(std::string_view)>& take)
{
  const Descriptor descriptor(open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)); // a pipe must not keep us waiting
  struct stat status = {};
  if (descriptor.number() < 0 || fstat(descriptor.number(), &status) != 0)
    throw InputError("cannot be opened: no such file, or not readable");
  if (S_ISDIR(status.st_mode))
    throw InputError("is a folder; allowed: a file");
  if (!S_ISREG(status.st_mode))
    throw InputError("is a device or a pipe; allowed: a file");
  if (status.st_size > 0 && static_cast<std::size_t>(status.st_size) > largest)
    throw too_large(largest);
  std::vector<char> block(1 << 20);
  std::size_t size = 0;
  for (;;)
  {
    const ssize_t got = read(descriptor.number(), block.data(), block.size());
    if (got == 0)
      return;
    if (got < 0 && errno == EINTR)
      continue;
    if (got < 0)
      throw IoError(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
    size += static_cast<std::size_t>(got);
    if (size > largest)
      throw too_large(largest);
    take({block.data(), static_cast<std::size_t>(got)});
  }
}

std::string input_text(const std::filesystem::path& file)
{
  std::string text;
  read_blocks(file, largest_input, [&](std::string_view block) { text += block; });
  constexpr std::string_view mark = "\xef\xbb\xbf";
  if (text.starts_with(mark))
    text.erase(0, mark.size());
  return text;
}

std::string file_checksum(const std::filesystem::path& file)
{
  Checksum sum;
  read_blocks(file, std::numeric_limits<std::size_t>::max(), [&](std::string_view block) { sum.add(block); });
  return sum.text();
}

std::size_t valid_utf8(std::string_view text)
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  std::size_t i = 0;
  while (i < text.size())
  {
    const unsigned char first = byte(i);
    const std::size_t length = first < 0x80                     ? 1
                               : first >= 0xc2 && first <= 0xdf ? 2
                               : first >= 0xe0 && first <= 0xef ? 3
                               : first >= 0xf0 && first <= 0xf4 ? 4
                                                                : 0;
    if (length == 0 || i + length > text.size())
      return i;
    for (std::size_t k = 1; k < length; ++k)
      if ((byte(i + k) & 0xc0) != 0x80)
        return i;
    // Longer than needed, halves of pairs of UTF-16, and beyond the last character.
    const unsigned char second = length > 1 ? byte(i + 1) : 0x80;
    if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) || (first == 0xf0 && second < 0x90) ||
        (first == 0xf4 && second > 0x8f))
      return i;
    i += length;
  }
  return i;
}

} // namespace brinell::io
