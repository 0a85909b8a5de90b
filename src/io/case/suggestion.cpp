// SPDX-License-Identifier: BSD-3-Clause
#include "suggestion.hpp"

#include "brinell/io/schema.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace brinell::io
{

namespace
{

/// The table of a key, and its last part.
std::pair<std::string_view, std::string_view> split(std::string_view key)
{
  const auto dot = key.rfind('.');
  return dot == key.npos ? std::pair{std::string_view{}, key} : std::pair{key.substr(0, dot), key.substr(dot + 1)};
}

/// Symbols from the theory that users write instead of a key.
constexpr std::pair<std::string_view, std::string_view> symbols[] = {
    {"E", "young_modulus"}, {"nu", "poisson_ratio"},     {"R", "radius"}, {"S_y", "yield_stress"},
    {"Sy", "yield_stress"}, {"sigma_y", "yield_stress"}, {"P", "load"},   {"F", "load"},
    {"force", "load"},      {"depth", "approach"},
};

/// The candidate that was probably meant by a word; empty if none is similar enough.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates)
{
  for (const auto& [symbol, key] : symbols)
    if (word == symbol && std::find(candidates.begin(), candidates.end(), key) != candidates.end())
      return std::string(key);
  for (const auto& candidate : candidates) // "poisson" for "poisson_ratio"
    if (word.size() > 2 && (candidate.starts_with(word) || candidate.ends_with(word)))
      return candidate;
  constexpr std::size_t longest = 100; // longer words match no key, and comparing them is expensive
  if (word.size() > longest)
    return "";
  std::string best;
  int best_distance = std::max(2, static_cast<int>(word.size()) / 3) + 1;
  for (const auto& candidate : candidates)
    if (const int distance = edit_distance(word, candidate); distance < best_distance)
    {
      best = candidate;
      best_distance = distance;
    }
  return best;
}

/// Why a key that meant something else is refused; empty for any other key.
std::string retired(std::string_view key)
{
  if (!plain_key(key).ends_with(".texture.radius"))
    return "";
  const std::string table(split(key).first);
  return fmt::format("a dent or bump has {0}.edge_radius, at which it crosses the undisturbed surface; the earlier "
                     "radius was the wavelength of its profile: edge_radius = 0.25 x radius. Half of the depth is at "
                     "0.124 x radius, the crest of the shoulder at 0.315 x radius",
                     table);
}

/// A key with the same last part in another table, preferably in the same top-level table, else in the table of the scenario.
std::string misplaced(std::string_view key, std::string_view scenario)
{
  const auto name = split(key).second;
  const auto top = [](std::string_view whole) { return whole.substr(0, whole.find('.')); };
  std::string found;
  int best = -1;
  for (const Entry& entry : case_schema())
  {
    const int likely = top(entry.key) == top(key) ? 2 : top(entry.key) == scenario ? 1 : 0;
    if (split(entry.key).second == name && likely > best)
    {
      found = entry.key;
      best = likely;
    }
  }
  return found;
}

} // namespace

std::vector<std::string> children(std::string_view parent, std::string_view scenario)
{
  std::vector<std::string> names;
  const std::string prefix = parent.empty() ? "" : fmt::format("{}.", plain_key(parent));
  for (const Entry& entry : case_schema())
  {
    if (!entry.key.starts_with(prefix) || (!scenario.empty() && !belongs_to(entry, scenario)))
      continue;
    const std::string rest = entry.key.substr(prefix.size()), name = rest.substr(0, rest.find('.'));
    if (std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  }
  return names;
}

int edit_distance(std::string_view a, std::string_view b)
{
  const std::size_t n = a.size(), m = b.size();
  std::vector<std::vector<int>> d(n + 1, std::vector<int>(m + 1));
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= m; ++j)
    {
      if (i == 0 || j == 0)
      {
        d[i][j] = static_cast<int>(i + j);
        continue;
      }
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[n][m];
}

std::string known_keys(std::string_view parent)
{
  return fmt::format("{}", fmt::join(children(parent), ", "));
}

std::string suggestion(std::string_view unknown_key, std::string_view scenario)
{
  const auto [parent, name] = split(unknown_key);
  if (!parent.empty() && !is_table(parent)) // the error is in the name of the table
    return suggestion(parent, scenario);
  if (std::string why = retired(unknown_key); !why.empty())
    return why;
  const std::string near = nearest(name, children(parent));
  if (!near.empty())
    return fmt::format("did you mean {}{}{}?", parent, parent.empty() ? "" : ".", near);
  if (const std::string elsewhere = misplaced(unknown_key, scenario); !elsewhere.empty())
    return fmt::format("did you mean {}?", elsewhere);
  return fmt::format("allowed {}: {}", parent.empty() ? "here" : fmt::format("in {}", parent), known_keys(parent));
}

} // namespace brinell::io
