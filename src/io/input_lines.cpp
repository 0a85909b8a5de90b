// SPDX-License-Identifier: BSD-3-Clause
#include "io/input_lines.hpp"

#include "brinell/io/units.hpp"
#include "io/files.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace brinell::io
{

namespace
{

/// Kinds of bytes.
enum Kind : unsigned char
{
  ascii,
  control, ///< does not occur in text
  high     ///< part of a character beyond ASCII
};

constexpr std::array<Kind, 256> kinds = []
{
  std::array<Kind, 256> result{};
  for (std::size_t byte = 0; byte < result.size(); ++byte)
  {
    const bool is_blank = white_space.find(static_cast<char>(byte)) != white_space.npos || byte == '\n';
    result[byte] = byte >= 0x80 ? high : byte < 0x20 && !is_blank ? control : ascii;
  }
  return result;
}();

Kind kind_of(char c)
{
  return kinds[static_cast<unsigned char>(c)];
}

std::string from_latin1(std::string_view bytes)
{
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 8);
  for (const char c : bytes)
    if (const auto byte = static_cast<unsigned char>(c); byte < 0x80)
      text += c;
    else
      (text += static_cast<char>(0xc0 | byte >> 6)) += static_cast<char>(0x80 | (byte & 0x3f));
  return text;
}

/// Ends each line as Unix does: "\r\n" of Windows and "\r" of old Macs become "\n".
void end_lines_by_newline(std::string& text)
{
  std::size_t to = text.find('\r');
  if (to == text.npos)
    return;
  for (std::size_t from = to; from < text.size(); ++from)
    if (text[from] != '\r')
      text[to++] = text[from];
    else if (from + 1 == text.size() || text[from + 1] != '\n')
      text[to++] = '\n';
  text.resize(to);
}

} // namespace

InputLines input_lines(const std::filesystem::path& file)
{
  std::string text = input_text(file);
  unsigned char found = 0;
  for (const char c : text)
    found |= static_cast<unsigned char>(kind_of(c));
  if ((found & control) != 0)
  {
    const auto first = std::find_if(text.begin(), text.end(), [](char c) { return kind_of(c) == control; });
    throw NoText(fmt::format("is no text: its byte {} is 0x{:02x}", first - text.begin() + 1,
                             static_cast<unsigned char>(*first)));
  }
  InputLines result;
  if ((found & high) != 0)
  {
    result.is_utf8 = valid_utf8(text) == text.size();
    text = with_plain_signs(result.is_utf8 ? text : from_latin1(text));
  }
  end_lines_by_newline(text);
  result.text = std::make_shared<const std::string>(std::move(text));
  const std::string_view whole = *result.text;
  int number = 1;
  for (std::size_t begin = 0; begin < whole.size(); ++number)
  {
    const auto end = std::min(whole.find('\n', begin), whole.size());
    const std::string_view line = whole.substr(begin, end - begin);
    if (const auto first = line.find_first_not_of(white_space); first != line.npos)
      result.lines.push_back({number, line, line[first] == '#'});
    begin = end + 1;
  }
  return result;
}

std::string InputLines::shown(std::string_view part) const
{
  constexpr std::size_t longest = 40;
  part.remove_prefix(std::min(part.find_first_not_of(white_space), part.size()));
  part = part.substr(0, longest);
  part = part.substr(0, valid_utf8(part)); // no half of a character at the end
  std::string result;
  for (std::size_t i = 0; i < part.size(); ++i)
  {
    const auto byte = static_cast<unsigned char>(part[i]);
    if (!is_utf8 && (byte == 0xc2 || byte == 0xc3))
      result += fmt::format("\\x{:02x}", (byte & 0x03) << 6 | (static_cast<unsigned char>(part[++i]) & 0x3f));
    else if (byte < 0x20 && byte != '\t')
      result += fmt::format("\\x{:02x}", byte);
    else
      result += part[i];
  }
  return result;
}

} // namespace brinell::io
