// SPDX-License-Identifier: BSD-3-Clause
#include "key_depth.hpp"

#include <algorithm>
#include <cstddef>

namespace brinell::io
{

namespace
{

/// Walks over TOML as far as strings and comments go. Behind the first syntax error it may go astray, but there the parser
/// does not go.
class Walk
{
public:
  explicit Walk(std::string_view text) : m_text(text) {}

  std::optional<int> line_of_deep_key()
  {
    while (m_place < m_text.size())
    {
      const char c = m_text[m_place];
      if (c == '"' || c == '\'')
        skip_string(c);
      else if (c == '#')
        m_place = std::min(m_text.find('\n', m_place), m_text.size());
      else
        take(c);
      if (m_parts > deepest_key)
        return m_line;
    }
    return std::nullopt;
  }

private:
  void take(char c)
  {
    if (c == '.')
      ++m_parts;
    else if (c == '\n' || c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}')
      m_parts = 1;
    step();
  }

  void step()
  {
    if (m_text[m_place++] == '\n')
      ++m_line;
  }

  /// One of several lines ends with three quotes, of which two more may stand before; others end with their line at the latest.
  void skip_string(char quote)
  {
    const std::string_view three = quote == '"' ? R"(""")" : "'''";
    const bool is_long = m_text.substr(m_place).starts_with(three);
    m_place += is_long ? three.size() : 1;
    while (m_place < m_text.size())
    {
      const std::string_view rest = m_text.substr(m_place);
      if (is_long && rest.starts_with(three))
      {
        m_place += three.size();
        for (int more = 0; more < 2 && m_place < m_text.size() && m_text[m_place] == quote; ++more)
          ++m_place;
        return;
      }
      if (!is_long && (rest.front() == quote || rest.front() == '\n'))
      {
        m_place += rest.front() == quote ? 1 : 0;
        return;
      }
      const bool escapes = quote == '"' && rest.front() == '\\' && rest.size() > 1;
      step();
      if (escapes && (is_long || m_text[m_place] != '\n'))
        step();
    }
  }

  std::string_view m_text;
  std::size_t m_place = 0;
  int m_line = 1, m_parts = 1;
};

} // namespace

std::optional<int> line_of_deep_key(std::string_view toml)
{
  return Walk(toml).line_of_deep_key();
}

} // namespace brinell::io
