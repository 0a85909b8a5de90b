// SPDX-License-Identifier: BSD-3-Clause
#include "toml_text.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/units.hpp"
#include "io/pattern.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace brinell::io
{

namespace
{

/// Position after the end of the string that begins at `first`. A multi-line string ends with three quotes, which may be preceded
/// by up to two quotes of its content; other strings end at the end of the line at the latest.
std::size_t end_of_string(std::string_view text, std::size_t first)
{
  const char quote = text[first];
  const std::string three(3, quote);
  const bool is_long = text.substr(first).starts_with(three);
  for (std::size_t i = first + (is_long ? 3 : 1); i < text.size(); ++i)
    if (quote == '"' && text[i] == '\\' && (is_long || !text.substr(i).starts_with("\\\n")))
      ++i;
    else if (!is_long && (text[i] == quote || text[i] == '\n'))
      return text[i] == quote ? i + 1 : i;
    else if (is_long && text.substr(i).starts_with(three))
      return std::min({text.find_first_not_of(quote, i), i + 5, text.size()});
  return text.size();
}

/// Hint about a common mistake in a line, counted from 1, that is not valid TOML; empty if none is recognised.
std::string remedy(std::string_view text, std::size_t number)
{
  for (; number > 1 && !text.empty(); --number)
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  const std::string line(text.substr(0, text.find('\n')));
  if (line.find("\u2212") != line.npos)
    return "; it has a minus sign (U+2212): outside of quotes a number has a hyphen, as -0.3";
  if (with_plain_signs(line) != line)
    return "; it has a no-break space: outside of quotes only ordinary blanks are allowed";
  if (std::count(line.begin(), line.end(), '"') % 2 == 1)
    return "; is a quote missing at the end of the line?";
  if (line.find('\\') != line.npos)
    return "; between \" a backslash is written twice; for a path use '...', or / as in \"data/curve.csv\"";
  if (Pattern(R"(=\s*[-+]?\d+,\d)").find(line))
    return "; is a decimal comma meant? Numbers have a point, as in 0.3";
  return "";
}

} // namespace

std::string too_deep()
{
  return fmt::format("a key of more than {} parts; allowed: the keys of a case, which have four parts at most",
                     deepest_key);
}

std::optional<int> line_of_deep_key(std::string_view toml)
{
  constexpr std::string_view ends_of_keys = "\n=,[]{}";
  int line = 1, parts = 1;
  for (std::size_t i = 0; i < toml.size() && parts <= deepest_key;)
  {
    std::size_t next = i + 1;
    if (toml[i] == '"' || toml[i] == '\'')
      next = end_of_string(toml, i);
    else if (toml[i] == '#')
      next = std::min(toml.find('\n', i), toml.size());
    else if (toml[i] == '.')
      ++parts;
    else if (ends_of_keys.find(toml[i]) != ends_of_keys.npos)
      parts = 1;
    line += static_cast<int>(std::count(toml.begin() + i, toml.begin() + next, '\n'));
    i = next;
  }
  return parts > deepest_key ? std::optional(line) : std::nullopt;
}

toml::table parse_toml(std::string_view text, const std::string& file)
{
  if (const auto line = line_of_deep_key(text))
    throw InputError(fmt::format("{}:{}: {}", file, *line, too_deep()));
  try
  {
    return toml::parse(text, file);
  }
  catch (const toml::parse_error& error)
  {
    const auto& position = error.source().begin;
    throw InputError(fmt::format("{}:{}:{}: not valid TOML: {}{}", file, position.line, position.column,
                                 error.description(), remedy(text, position.line)));
  }
}

} // namespace brinell::io
