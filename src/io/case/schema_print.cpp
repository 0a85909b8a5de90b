// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/schema.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/case_template.hpp"
#include "suggestion.hpp"
#include "value_text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace brinell::io
{

namespace
{

std::string quoted_list(const std::vector<std::string>& words)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += fmt::format("{}\"{}\"", i == 0 ? "" : (i + 1 == words.size() ? " or " : ", "), words[i]);
  return text;
}

std::string unit_note(Dimension dimension)
{
  if (dimension == dimension::none)
    return "";
  return fmt::format(", in {} or with a unit as in \"{}\"", si_unit(dimension), example_quantity(dimension));
}

std::string with_range(const std::string& text, const Range& range)
{
  const std::string interval = range.text();
  return interval.empty() ? text : text + " " + interval;
}

/// The top-level table of a key, and the rest of the key (`tail`).
std::string_view section(std::string_view key)
{
  return key.find('.') == key.npos ? "" : key.substr(0, key.find('.'));
}
std::string_view tail(std::string_view key)
{
  return key.find('.') == key.npos ? key : key.substr(key.find('.') + 1);
}

/// Conditions and exclusions, which type and range do not express.
std::string notes(const Entry& entry, std::string_view quote)
{
  std::string text;
  // A condition on the scenario applies to the whole section and is not repeated for each key.
  if (!entry.when.key.empty() && entry.when.key != "scenario")
    text += fmt::format(" Only with {0}{1}{0} = {2}.", quote, tail(entry.when.key), quoted_list(entry.when.values));
  if (!entry.excludes.empty())
    text += fmt::format(" Not together with {0}{1}{0}.", quote, tail(entry.excludes));
  return text;
}

std::string section_note(std::string_view name)
{
  if (name == "lower")
    return "The lower body. `[upper]`, the moving one, has the same keys.\n\n";
  if (name == "grid")
    return "Give `spacing` or `resolution`, or neither.\n\n";
  if (name == scenario_names().front()) // the sections of the other scenarios follow
    return fmt::format("With `scenario = \"{}\"`.\n\n", name);
  return "";
}

/// Keys and tables whose name contains a word. Keys of the upper body are left out, because the lower body has the same.
std::vector<std::string> keys_with(std::string_view word)
{
  std::vector<std::string> keys;
  for (const Entry& entry : case_schema())
  {
    const auto at = entry.key.find(word);
    if (at == entry.key.npos || entry.key.starts_with("upper."))
      continue;
    const std::string key = entry.key.substr(0, entry.key.find('.', at + word.size()));
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      keys.push_back(key);
  }
  return keys;
}

constexpr std::string_view markdown_head = R"md(<!-- Written by `brinell schema --markdown`; do not edit. -->
# The case file

A case is a [TOML](https://toml.io) file. Dotted keys and tables mean the same: `lower.shape.radius = 1` is
`[lower]` with `shape = {radius = 1}`.

**Units.** A bare number is SI, but for angles, which are in degrees, and temperatures, in degrees Celsius. A string
carries its unit: `"3.85 mm"`, `"200 GPa"`, `"911.5 N/mm^2"`, `"2 µm"`. Units are products of m, g, s, K, N, Pa, bar, J,
W, A, V, ohm (or Ω), rad with the prefixes p n u (or µ) c m k M G T, and of in (or inch), angstrom (or Å), kgf and HV (Vickers hardness as
a pressure, kgf/mm²: about three times the yield stress) without prefixes, `*` or a space between, `/` before each one
that divides or before parentheses, as in `"50 W/(m K)"`. A temperature has `degC` or `K`, an angle `deg`, `rad` or
`mrad`. A quantity of the wrong dimension is an error.

**Errors.** Unknown keys, missing keys, wrong types and impossible values are errors, reported together with file and line.

**Command line.** `--set key=value` replaces or adds a key, as in `--set tugging.interference=4 --set
lower.shape.radius="2 mm"`. Where it excludes a key of the file (`grid.resolution` for `grid.spacing`, `rolling.load`
for `rolling.hertz_pressure`) or makes it pointless (`lower.material.hardening.law=none`), that key of the file is
ignored.

`brinell check case.toml` prints the case with all defaults filled in.
)md";

} // namespace

std::string default_text(const Entry& entry)
{
  if (entry.fallback)
  {
    std::string text = toml_text(*entry.fallback);
    for (const auto& [scenario, value] : entry.fallback_in)
      text += fmt::format(", in {} {}", scenario, toml_text(value));
    return text;
  }
  return entry.required ? "required" : entry.unset;
}

std::string unit_of(const ValueKind& kind)
{
  if (kind.notation == Notation::angle || kind.notation == Notation::temperature)
    return kind.notation == Notation::angle ? "degrees" : "degC";
  return kind.dimension == dimension::none ? "" : si_unit(kind.dimension);
}

std::string Range::text() const
{
  const bool low = std::isfinite(min), high = std::isfinite(max);
  if (!zero_allowed)
    return "other than 0"; // no such key has bounds
  if (low && high)
    return fmt::format("in {}{}, {}{}", min_allowed ? '[' : '(', min, max, max_allowed ? ']' : ')');
  if (low)
    return fmt::format("{} {}", min_allowed ? ">=" : ">", min);
  return high ? fmt::format("{} {}", max_allowed ? "<=" : "<", max) : "";
}

bool Range::contains(double x) const
{
  if (!std::isfinite(x) || (x == 0.0 && !zero_allowed))
    return false;
  return (min_allowed ? x >= min : x > min) && (max_allowed ? x <= max : x < max);
}

std::string allowed_values(const Entry& entry)
{
  const std::string what = entry.of.notation == Notation::temperature ? "temperature"
                           : entry.of.dimension == dimension::none    ? "number"
                                                                      : dimension_name(entry.of.dimension);
  const char* temperature_note =
      entry.of.notation == Notation::temperature ? ", in degC or with a unit as in \"293.15 K\"" : "";
  switch (entry.of.type)
  {
  case Type::text:
    return "text";
  case Type::choice:
    return quoted_list(entry.choices);
  case Type::boolean:
    return "true or false";
  case Type::integer:
    return with_range("integer", entry.of.range);
  case Type::number:
    return with_range(what, entry.of.range) + unit_note(entry.of.dimension) +
           (entry.of.notation == Notation::angle ? ", in degrees or with a unit as in \"1.2 rad\" or \"20 mrad\""
                                                 : "") +
           temperature_note + (entry.of.notation == Notation::share ? ", or as in \"1 %\"" : "") +
           (entry.pure_if.empty() ? "" : fmt::format("; a number without unit if {} = true", tail(entry.pure_if)));
  case Type::vector3:
    return with_range(fmt::format("three {}s", what), entry.of.range) +
           fmt::format(", in {0} or with units as in [\"{1}\", \"{1}\", \"{1}\"]", si_unit(entry.of.dimension),
                       example_quantity(entry.of.dimension));
  case Type::numbers:
    return with_range(fmt::format("{0}, or list of {0}s", what), entry.of.range) + unit_note(entry.of.dimension) +
           temperature_note;
  case Type::snapshots:
    return "\"none\", \"aligned\", \"all\", \"every N\" or a list of step numbers as in [0, 12]";
  case Type::words:
    return fmt::format("one or a list of {}", quoted_list(entry.choices));
  }
  return "";
}

std::string schema_text(std::string_view part)
{
  if (!part.empty() && !find_entry(part) && !is_table(part))
  {
    const auto keys = keys_with(part);
    throw InputError(
        fmt::format("there is no key {}; {}", part,
                    keys.empty() ? suggestion(part) : fmt::format("with that word: {}", fmt::join(keys, ", "))));
  }
  std::string text;
  for (const Entry& entry : case_schema())
  {
    if (!part.empty() && entry.key != part && !entry.key.starts_with(fmt::format("{}.", part)))
      continue;
    const std::string preset = default_text(entry);
    text += fmt::format("{}\n    {}\n    {}{}\n    {}{}\n\n", entry.key, allowed_values(entry),
                        entry.required ? "" : "default: ", preset, entry.text, notes(entry, ""));
  }
  text.pop_back();
  return text;
}

std::string schema_markdown()
{
  std::string text(markdown_head);
  std::string_view current = "-";
  for (const Entry& entry : case_schema())
  {
    const auto name = section(entry.key);
    if (name == "upper")
      continue;
    if (name != current)
    {
      text += name.empty() ? std::string("\n## Top of the file\n\n") : fmt::format("\n## `[{}]`\n\n", name);
      text += section_note(name);
      text += "| key | value | default | meaning |\n| --- | --- | --- | --- |\n";
    }
    current = name;
    const std::string preset = default_text(entry);
    text += fmt::format("| `{}` | {} | {} | {}{} |\n", tail(entry.key), allowed_values(entry),
                        entry.fallback ? fmt::format("`{}`", preset) : preset, entry.text, notes(entry, "`"));
  }
  return text;
}

} // namespace brinell::io
