// SPDX-License-Identifier: BSD-3-Clause
#include "height_header.hpp"

#include "brinell/foundation/error.hpp"
#include "io/pattern.hpp"
#include "io/text.hpp"
#include "measured_files.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fmt/format.h>
#include <sstream>
#include <toml++/toml.h>

namespace brinell::io
{

namespace
{

/// A word of a header, and what its value is. Gwyddion translates its words into the language of the user.
struct Label
{
  std::string_view word;
  HeaderEntry HeightHeader::*entry;
};

constexpr Label labels[] = {
    {"Width", &HeightHeader::width},
    {"Breite", &HeightHeader::width},
    {"\u0160\u00ed\u0159ka", &HeightHeader::width},
    {"Anchura", &HeightHeader::width},
    {"Largeur", &HeightHeader::width},
    {"Larghezza", &HeightHeader::width},
    {"Largura", &HeightHeader::width},
    {"\u0428\u0438\u0440\u0438\u043d\u0430", &HeightHeader::width},
    {"\u5e45", &HeightHeader::width},
    {"\ud3ed", &HeightHeader::width},
    {"x-length", &HeightHeader::width},
    {"Height", &HeightHeader::height},
    {"H\u00f6he", &HeightHeader::height},
    {"V\u00fd\u0161ka", &HeightHeader::height},
    {"Altura", &HeightHeader::height},
    {"Hauteur", &HeightHeader::height},
    {"Altezza", &HeightHeader::height},
    {"\u0412\u044b\u0441\u043e\u0442\u0430", &HeightHeader::height},
    {"\u9ad8\u3055", &HeightHeader::height},
    {"\ub192\uc774", &HeightHeader::height},
    {"y-length", &HeightHeader::height},
    {"Value units", &HeightHeader::height_unit},
    {"Werteinheiten", &HeightHeader::height_unit},
    {"Werteinheit", &HeightHeader::height_unit},
    {"Einheiten", &HeightHeader::height_unit},
    {"Jednotky hodnot", &HeightHeader::height_unit},
    {"Unidades de valor", &HeightHeader::height_unit},
    {"Unit\u00e9s", &HeightHeader::height_unit},
    {"unit\u00e0 valore", &HeightHeader::height_unit},
    {"\u0415\u0434\u0438\u043d\u0438\u0446\u044b \u0438\u0437\u043c\u0435\u0440\u0435\u043d\u0438\u044f",
     &HeightHeader::height_unit},
    {"\u5024\u306e\u5358\u4f4d", &HeightHeader::height_unit},
    {"\uac12 \ub2e8\uc704", &HeightHeader::height_unit},
    {"z-unit", &HeightHeader::height_unit},
    {"Lateral units", &HeightHeader::x_unit},
    {"x-unit", &HeightHeader::x_unit},
    {"y-unit", &HeightHeader::y_unit},
    {"x-pixels", &HeightHeader::columns},
    {"y-pixels", &HeightHeader::rows},
};

/// Words before the name of a map of Gwyddion.
constexpr std::string_view channel_words[] = {
    "Channel",
    "Kanal",
    "Kan\u00e1l",
    "Canal",
    "Canale",
    "\u041a\u0430\u043d\u0430\u043b",
    "\u30c1\u30e3\u30cd\u30eb",
    "\ucc44\ub110",
};

struct WordAndValue
{
  std::string_view word, value;
};

/// "# Width: 100 um" as "Width" and "100 um".
std::optional<WordAndValue> word_and_value(const InputLine& line)
{
  const std::string_view text = trimmed(line.text, " \t#\"");
  constexpr std::string_view wide_colon = "\uff1a";
  const std::size_t narrow = text.find_first_of(":="), wide = text.find(wide_colon);
  const std::size_t at = std::min(narrow, wide);
  if (!line.is_comment || at == text.npos)
    return std::nullopt;
  return WordAndValue{trimmed(text.substr(0, at)), trimmed(text.substr(at + (at == wide ? wide_colon.size() : 1)))};
}

bool names_channel(const InputLine& line)
{
  const auto entry = word_and_value(line);
  return entry && std::find(std::begin(channel_words), std::end(channel_words), entry->word) != std::end(channel_words);
}

/// A number in m, or a length as text with a unit.
std::optional<double> length_in(const toml::node_view<toml::node>& value)
{
  if (value.is_number())
    return value.value<double>();
  try
  {
    const auto text = value.value_exact<std::string>();
    const Quantity length = quantity(text.value_or(""));
    return length.dimension == dimension::length ? std::optional(length.value) : std::nullopt;
  }
  catch (const InputError&)
  {
    return std::nullopt;
  }
}

/// Reads a comment of brinell's own files, "spacing = [1e-6, 2e-6]"; a comment that only looks similar is left alone.
void add_own_value(const WordAndValue& entry, HeightHeader& header)
{
  constexpr std::string_view own[] = {"spacing", "x", "y", "periodic"};
  if (std::find(std::begin(own), std::end(own), entry.word) == std::end(own))
    return;
  toml::table parsed;
  try
  {
    parsed = toml::parse(fmt::format("value = {}", entry.value));
  }
  catch (const toml::parse_error&)
  {
    return;
  }
  const auto value = parsed["value"];
  const auto dx = length_in(value[0]), dy = length_in(value[1]);
  if (entry.word == "spacing" && dx && dy)
    header.spacing = std::array{*dx, *dy};
  if (entry.word == "periodic")
    header.periodic = value.value_exact<bool>();
  if (entry.word == "x")
    header.x = length_in(value);
  if (entry.word == "y")
    header.y = length_in(value);
}

/// "x [um]", "Y (mm)", "z/nm" or "z": the letter, and the unit if there is one.
struct Title
{
  char axis = 0;
  std::string unit;
};

std::optional<Title> title_of(std::string_view cell)
{
  static const Pattern form(
      R"(([xyz])[ \t]*(?:[-_ ]?(?:coordinate|position|pos|axis|height))?[ \t]*(?:[\[(/][ \t]*([^\])]+?)[ \t]*[\])]?)?)",
      true);
  const auto match = form.match(cell);
  if (!match)
    return std::nullopt;
  return Title{static_cast<char>(std::tolower(static_cast<unsigned char>(match->group(0)[0]))), match->group(1)};
}

/// Titles x, y, z of three columns; units, if there are any, become those of the header.
bool add_titles(const InputLine& line, HeightHeader& header)
{
  static const Pattern separator(R"([ \t]*[,;\t][ \t]*|[ \t]+(?=[xyzXYZ]))");
  const std::string text(trimmed(line.text, " \t#\r"));
  if (text.empty() || std::tolower(static_cast<unsigned char>(text[0] == '"' ? text[1] : text[0])) != 'x')
    return false;
  std::vector<Title> titles;
  std::istringstream cells(separator.replaced(text, "\n"));
  for (std::string cell; std::getline(cells, cell);)
    if (const auto title = title_of(trimmed(cell, " \t\"")))
      titles.push_back(*title);
    else
      return false;
  if (titles.size() != 3 || titles[0].axis != 'x' || titles[1].axis != 'y' || titles[2].axis != 'z')
    return false;
  header.has_titles = true;
  HeaderEntry* const entries[] = {&header.x_unit, &header.y_unit, &header.height_unit};
  for (std::size_t i = 0; i < titles.size(); ++i)
    if (!titles[i].unit.empty())
      *entries[i] = {titles[i].unit, &line};
  return true;
}

/// Size of a unit that a header names [m].
double metres_of_entry(const InputLines& text, const HeaderEntry& entry)
{
  try
  {
    return size_of_unit(entry.value, dimension::length, "length, such as \"um\"");
  }
  catch (const InputError&)
  {
    throw InputError(
        fmt::format("has in line {} {}: {} is no unit of length; allowed: heights in m, mm, um, nm. If the "
                    "numbers are lengths, mend that line; others have to be converted to heights first",
                    entry.line->number, text.quoted(entry.line->text), entry.value));
  }
}

double metres_of_given(const std::string& unit)
{
  try
  {
    return size_of_unit(unit, dimension::length, "length, such as \"um\"");
  }
  catch (const InputError&)
  {
    throw InputError(fmt::format("cannot be read: unit = '{}' is no unit of length; allowed: m, cm, mm, um, nm, pm, "
                                 "\u00c5",
                                 unit));
  }
}

/// Length of a header in m, "100 um", or "100" if the unit stands elsewhere.
double length_of(const InputLines& text, const HeaderEntry& entry, const HeaderEntry& unit)
{
  std::string number = entry.value;
  std::replace(number.begin(), number.end(), ',', '.');
  try
  {
    const Quantity size = quantity(number);
    if (size.dimension == dimension::none && unit.is_there())
      return size.value * metres_of_entry(text, unit);
    if (size.dimension == dimension::length && size.value > 0.0)
      return size.value;
  }
  catch (const InputError&) // said below
  {
  }
  throw InputError(fmt::format("has the size '{}' in its header; allowed: a length, as '100 um' (line {})", entry.value,
                               entry.line->number));
}

void require_count(const HeaderEntry& entry, std::size_t found, std::string_view what)
{
  std::size_t announced = 0;
  const char* const end = entry.value.data() + entry.value.size();
  if (entry.is_there() && std::from_chars(entry.value.data(), end, announced).ptr == end && announced != found)
    throw InputError(fmt::format("has {} {} of heights, but announces {} in line {}: is it cut off?", found, what,
                                 announced, entry.line->number));
}

} // namespace

HeightHeader header_of(const InputLines& text, std::size_t& first)
{
  HeightHeader header;
  const auto begin = text.lines.begin();
  for (auto line = begin; line != begin + static_cast<std::ptrdiff_t>(first); ++line)
    if (const auto entry = word_and_value(*line))
    {
      for (const Label& label : labels)
        if (label.word == entry->word)
          header.*label.entry = {std::string(entry->value), &*line};
      add_own_value(*entry, header);
    }
    else
      add_titles(*line, header);
  if (first < text.lines.size() && add_titles(text.lines[first], header))
    ++first;
  return header;
}

const InputLine* second_map(const InputLines& text, std::size_t first)
{
  const auto begin = text.lines.begin() + static_cast<std::ptrdiff_t>(first);
  const auto found = std::find_if(begin, text.lines.end(), names_channel);
  return found == text.lines.end() ? nullptr : &*found;
}

double metres_of_heights(const InputLines& text, const HeightHeader& header, const std::optional<std::string>& given,
                         bool is_points)
{
  const HeaderEntry& stored = header.height_unit;
  const std::optional<double> size = given ? std::optional(metres_of_given(*given)) : std::nullopt;
  if (stored.is_there())
  {
    const double metres = metres_of_entry(text, stored);
    const bool is_for_coordinates = is_points && !header.x_unit.is_there();
    if (size && *size != metres && !is_for_coordinates)
      throw InputError(fmt::format("tells its unit, {}; leave out unit = '{}' (line {}: {})", stored.value, *given,
                                   stored.line->number, text.quoted(stored.line->text)));
    return metres;
  }
  if (size)
    return *size;
  if (header.is_of_map())
    throw InputError(
        "has no line '# Value units: m' in the header of Gwyddion; give unit='m'. Lines that are looked for "
        "begin with # Width:, # Height:, # Value units: or, in German, # Breite:, # H\u00f6he:, "
        "# Werteinheiten:, # Werteinheit:, and likewise in the other languages of Gwyddion");
  if (is_points)
    throw InputError("is a list of points x, y, z that tells no unit; give the argument unit, as unit='um'");
  return 1.0;
}

std::array<double, 2> metres_of_coordinates(const InputLines& text, const HeightHeader& header,
                                            const std::optional<std::string>& given)
{
  if (!header.x_unit.is_there())
  {
    if (!given && header.height_unit.is_there())
      throw InputError(
          fmt::format("tells the unit of its heights, {}, but not that of x and y; give the argument unit, "
                      "as unit='{}'",
                      header.height_unit.value, header.height_unit.value));
    const double metres = given ? metres_of_given(*given) : metres_of_heights(text, header, given, true);
    return {metres, metres};
  }
  const double along_x = metres_of_entry(text, header.x_unit);
  return {along_x, header.y_unit.is_there() ? metres_of_entry(text, header.y_unit) : along_x};
}

std::optional<std::array<double, 2>> spacing_of(const InputLines& text, const HeightHeader& header, std::size_t columns,
                                                std::size_t rows)
{
  require_count(header.columns, columns, "columns");
  require_count(header.rows, rows, "rows");
  if (header.width.is_there() && header.height.is_there())
    return std::array{length_of(text, header.width, header.x_unit) / static_cast<double>(columns),
                      length_of(text, header.height, header.y_unit.is_there() ? header.y_unit : header.x_unit) /
                          static_cast<double>(rows)};
  return header.spacing;
}

} // namespace brinell::io
