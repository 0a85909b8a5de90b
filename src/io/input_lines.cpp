// SPDX-License-Identifier: BSD-3-Clause
#include "io/input_lines.hpp"

#include "brinell/io/units.hpp"
#include "io/files.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace brinell::io
{

namespace
{

/// Control characters that do not occur in text.
bool is_control(char c)
{
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 && white_space.find(c) == white_space.npos && c != '\n';
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
  if (text.find('\r') == text.npos)
    return;
  text = replaced(std::move(text), "\r\n", "\n");
  std::replace(text.begin(), text.end(), '\r', '\n');
}

} // namespace

InputLines input_lines(const std::filesystem::path& file)
{
  std::string text = input_text(file);
  if (const auto control = std::find_if(text.begin(), text.end(), is_control); control != text.end())
    throw NoText(fmt::format("is no text: its byte {} is 0x{:02x}", control - text.begin() + 1,
                             static_cast<unsigned char>(*control)));
  InputLines result;
  result.is_utf8 = valid_utf8(text) == text.size();
  if (!result.is_utf8)
    text = from_latin1(text);
  text = with_plain_signs(text);
  end_lines_by_newline(text);
  int number = 1;
  for (std::size_t begin = 0; begin < text.size(); ++number)
  {
    const auto end = std::min(text.find('\n', begin), text.size());
    std::string line = text.substr(begin, end - begin);
    if (const auto first = line.find_first_not_of(white_space); first != line.npos)
    {
      const bool is_comment = line[first] == '#';
      result.lines.push_back({number, std::move(line), is_comment});
    }
    begin = end + 1;
  }
  return result;
}

std::string InputLines::shown(std::string_view text) const
{
  constexpr std::size_t longest = 40;
  text.remove_prefix(std::min(text.find_first_not_of(white_space), text.size()));
  text = text.substr(0, longest);
  text = text.substr(0, valid_utf8(text)); // no half of a character at the end
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (!is_utf8 && (byte == 0xc2 || byte == 0xc3))
      result += fmt::format("\\x{:02x}", (byte & 0x03) << 6 | (static_cast<unsigned char>(text[++i]) & 0x3f));
    else if (byte < 0x20 && byte != '\t')
      result += fmt::format("\\x{:02x}", byte);
    else
      result += text[i];
  }
  return result;
}

} // namespace brinell::io
