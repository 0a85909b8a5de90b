// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/printable.hpp"

#include "io/files.hpp"

#include <fmt/format.h>

namespace brinell::io
{

std::string printable(std::string_view text)
{
  std::string result;
  while (!text.empty())
  {
    const std::size_t good = valid_utf8(text);
    result += text.substr(0, good);
    text.remove_prefix(good);
    if (!text.empty())
    {
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
      text.remove_prefix(1);
    }
  }
  return result;
}

} // namespace brinell::io
