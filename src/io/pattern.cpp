// SPDX-License-Identifier: BSD-3-Clause
#include "io/pattern.hpp"

#include <regex>

namespace brinell::io
{

struct Pattern::Compiled
{
  std::regex regex;
};

namespace
{

using Found = std::match_results<std::string_view::const_iterator>;

Pattern::Match match_of(const Found& found)
{
  Pattern::Match match{
      static_cast<std::size_t>(found.position(0)), static_cast<std::size_t>(found.position(0) + found.length(0)), {}};
  for (std::size_t i = 1; i < found.size(); ++i)
    match.groups.push_back(found[i].matched ? std::optional(found.str(i)) : std::nullopt);
  return match;
}

} // namespace

Pattern::Pattern(const char* expression, bool ignores_case)
    : compiled_(new Compiled{
          std::regex(expression, ignores_case ? std::regex::ECMAScript | std::regex::icase : std::regex::ECMAScript)})
{
}

Pattern::~Pattern() = default;

std::optional<Pattern::Match> Pattern::match(std::string_view text) const
{
  Found found;
  if (!std::regex_match(text.begin(), text.end(), found, compiled_->regex))
    return std::nullopt;
  return match_of(found);
}

std::optional<Pattern::Match> Pattern::find(std::string_view text) const
{
  Found found;
  if (!std::regex_search(text.begin(), text.end(), found, compiled_->regex))
    return std::nullopt;
  return match_of(found);
}

std::optional<Pattern::Match> Pattern::match_begin(std::string_view text) const
{
  Found found;
  if (!std::regex_search(text.begin(), text.end(), found, compiled_->regex, std::regex_constants::match_continuous))
    return std::nullopt;
  return match_of(found);
}

std::string Pattern::replaced(const std::string& text, const std::string& by) const
{
  return std::regex_replace(text, compiled_->regex, by);
}

} // namespace brinell::io
