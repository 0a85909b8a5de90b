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
  explicit Walk(std::string_view text) : text_(text) {}

  std::optional<int> line_of_deep_key()
  {
    while (place_ < text_.size())
    {
      const char c = text_[place_];
      if (c == '"' || c == '\'')
        skip_string(c);
      else if (c == '#')
        place_ = std::min(text_.find('\n', place_), text_.size());
      else
        take(c);
      if (parts_ > deepest_key)
        return line_;
    }
    return std::nullopt;
  }

private:
  void take(char c)
  {
    if (c == '.')
      ++parts_;
    else if (c == '\n' || c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}')
      parts_ = 1;
    step();
  }

  void step()
  {
    if (text_[place_++] == '\n')
      ++line_;
  }

  /// One of several lines ends with three quotes, of which two more may stand before; others end with their line at the latest.
  void skip_string(char quote)
  {
    const std::string_view three = quote == '"' ? R"(""")" : "'''";
    const bool is_long = text_.substr(place_).starts_with(three);
    place_ += is_long ? three.size() : 1;
    while (place_ < text_.size())
    {
      const std::string_view rest = text_.substr(place_);
      if (is_long && rest.starts_with(three))
      {
        place_ += three.size();
        for (int more = 0; more < 2 && place_ < text_.size() && text_[place_] == quote; ++more)
          ++place_;
        return;
      }
      if (!is_long && (rest.front() == quote || rest.front() == '\n'))
      {
        place_ += rest.front() == quote ? 1 : 0;
        return;
      }
      const bool escapes = quote == '"' && rest.front() == '\\' && rest.size() > 1;
      step();
      if (escapes && (is_long || text_[place_] != '\n'))
        step();
    }
  }

  std::string_view text_;
  std::size_t place_ = 0;
  int line_ = 1, parts_ = 1;
};

} // namespace

std::optional<int> line_of_deep_key(std::string_view toml)
{
  return Walk(toml).line_of_deep_key();
}

} // namespace brinell::io
