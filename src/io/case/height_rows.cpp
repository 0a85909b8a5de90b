// SPDX-License-Identifier: BSD-3-Clause
#include "height_rows.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/nan.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string_view>

namespace brinell::io
{

namespace
{

using Cells = std::vector<std::string_view>;

/// One or two characters, each of which ends a cell.
struct Separators
{
  char one, other;
  [[nodiscard]] bool contain(char c) const { return c == one || c == other; }
  [[nodiscard]] bool are_in(std::string_view text) const
  {
    return text.find(one) != text.npos || text.find(other) != text.npos;
  }
};

constexpr Separators commas_and_semicolons{',', ';'}, semicolons{';', ';'}, tabs{'\t', '\t'};

std::string_view without_blanks(std::string_view text)
{
  const bool has_none = text.empty() || (text.front() > ' ' && text.back() > ' ');
  return has_none ? text : trimmed(text, white_space);
}

bool has_quoted(std::string_view text, Separators separators)
{
  if (text.find('"') == text.npos)
    return false;
  for (bool is_quoted = false; const char c : text)
    if (c == '"')
      is_quoted = !is_quoted;
    else if (is_quoted && separators.contain(c))
      return true;
  return false;
}

/// Appends what is between the separators, without blanks around it; a gap is an empty cell. Separators inside quotes do not
/// separate: then the text is one cell, which is no number.
void split(std::string_view text, Separators separators, Cells& cells)
{
  if (has_quoted(text, separators))
    return cells.push_back(text);
  std::size_t begin = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (separators.contain(text[i]))
    {
      cells.push_back(without_blanks(text.substr(begin, i - begin)));
      begin = i + 1;
    }
  cells.push_back(without_blanks(text.substr(begin)));
}

void split_at_blanks(std::string_view text, Cells& cells)
{
  const auto is_blank = [](char c) { return c == ' ' || white_space.find(c) != white_space.npos; };
  for (std::size_t i = 0; i < text.size();)
  {
    const std::size_t begin = i;
    while (i < text.size() && !is_blank(text[i]))
      ++i;
    if (i > begin)
      cells.push_back(text.substr(begin, i - begin));
    while (i < text.size() && is_blank(text[i]))
      ++i;
  }
}

/// The cells of a line. Each comma, semicolon or tab ends a cell, so that an empty one is a gap; blanks, also several, end one if
/// nothing else does. Tabs beside a comma or semicolon only align.
/// @param separators  commas and semicolons, or semicolons if commas are decimal commas
void split_line(std::string_view line, Separators separators, Cells& cells)
{
  cells.clear();
  const bool has_tab = line.find('\t') != line.npos;
  if (separators.are_in(line) && !has_tab)
    return split(line, separators, cells);
  if (separators.are_in(line))
  {
    Cells outer;
    split(line, separators, outer);
    for (const std::string_view cell : outer)
      split(cell, tabs, cells);
    return;
  }
  if (has_tab)
  {
    split(line, tabs, cells);
    if (std::any_of(cells.begin(), cells.end(), [](std::string_view cell) { return cell.empty(); }))
      return;
    cells.clear();
  }
  split_at_blanks(line, cells);
}

std::string in_small_letters(std::string_view text)
{
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(), [](unsigned char c) { return std::tolower(c); });
  return small;
}

/// Whether a word stands for a point that was not measured.
bool is_missing(std::string_view word)
{
  constexpr std::size_t longest = 12;
  constexpr std::array<std::string_view, 18> words{"",    "nan",    "inf",  "infinity", "bad",    "na",
                                                   "n/a", "nodata", "null", "none",     "masked", "-",
                                                   "--",  "---",    "***",  "nan(ind)", "1.#ind", "1.#qnan"};
  if (word.size() > longest)
    return false;
  std::string small = in_small_letters(word);
  if (small.size() > 1 && (small[0] == '+' || small[0] == '-') && small[1] != '-')
    small.erase(0, 1);
  return std::find(words.begin(), words.end(), small) != words.end();
}

/// "No Data" of some instruments as one word.
std::string with_one_word(std::string line)
{
  const std::string small = in_small_letters(line);
  constexpr std::string_view two_words = "no data";
  for (auto at = small.find(two_words); at != small.npos; at = small.find(two_words, at + 1))
    line.replace(at, two_words.size(), "nan    ");
  return line;
}

std::optional<double> plain_number(std::string_view word)
{
  if (word.size() > 1 && word.front() == '"' && word.back() == '"')
    word = trimmed(word.substr(1, word.size() - 2), white_space);
  if (word.size() > 1 && word.front() == '+' && word[1] != '-')
    word.remove_prefix(1);
  double value = 0.0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc() && stop == word.data() + word.size() && !word.empty() && std::isfinite(value))
    return value;
  return is_missing(word) ? std::optional(nan) : std::nullopt;
}

bool is_digit(char c)
{
  return c >= '0' && c <= '9';
}

/// Whether a word is a gap or a number that may have a decimal comma, and no decimal point.
bool may_have_decimal_comma(std::string_view word)
{
  if (is_missing(word))
    return true;
  const auto comma = word.find(',');
  const bool is_between = comma == word.npos || (comma > 0 && is_digit(word[comma - 1]) && comma + 1 < word.size() &&
                                                 is_digit(word[comma + 1]));
  std::string with_point(word);
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  return is_between && word.find('.') == word.npos && plain_number(with_point);
}

/// Whether commas are decimal commas: in every line something else separates the numbers.
bool has_decimal_commas(const InputLines& text, std::size_t first)
{
  const auto begin = text.lines.begin() + static_cast<std::ptrdiff_t>(first);
  const auto has_comma = [](const InputLine& line)
  { return !line.is_comment && line.text.find(',') != line.text.npos; };
  Cells cells;
  const auto fits = [&](const InputLine& line)
  {
    if (line.is_comment)
      return true;
    split_line(line.text, semicolons, cells);
    return (cells.size() > 1 || line.text.find('"') != line.text.npos) &&
           std::all_of(cells.begin(), cells.end(), may_have_decimal_comma);
  };
  return std::any_of(begin, text.lines.end(), has_comma) && std::all_of(begin, text.lines.end(), fits);
}

/// Removes a column from all rows.
void remove_column(NumberRows& table, std::size_t column)
{
  std::size_t to = 0;
  for (std::size_t i = 0; i < table.values.size(); ++i)
    if (i % table.columns != column)
      table.values[to++] = table.values[i];
  table.values.resize(to);
  --table.columns;
}

[[noreturn]] void refuse(const InputLines& text, const InputLine& line, std::size_t columns, std::string_view why)
{
  throw InputError(
      fmt::format("has in line {} {}; allowed: {} heights in m or the given unit{}. \"brinell surface convert "
                  "FILE OUT.npy\" reads formats of instruments",
                  line.number, text.quoted(line.text), columns > 0 ? std::to_string(columns) : "one or more", why));
}

} // namespace

bool begins_as_row(std::string_view line)
{
  Cells cells;
  const std::string plain = with_one_word(std::string(line));
  split_line(plain, commas_and_semicolons, cells);
  const auto is_number = [](std::string_view cell) { return plain_number(cell).has_value(); };
  const auto first = std::find_if(cells.begin(), cells.end(), [](std::string_view cell) { return !cell.empty(); });
  return first == cells.end() || is_number(*first);
}

NumberRows number_rows(const InputLines& text, std::size_t first)
{
  const bool decimal = has_decimal_commas(text, first);
  NumberRows table;
  Cells cells;
  std::string plain;                           // a line that is changed
  bool begins_empty = true, ends_empty = true; // all rows
  for (std::size_t i = first; i < text.lines.size(); ++i)
  {
    const InputLine& line = text.lines[i];
    if (line.is_comment)
      continue;
    std::string_view words = line.text;
    if (decimal || words.find('d') != words.npos || words.find('D') != words.npos)
      words = plain = with_one_word(std::string(words));
    split_line(words, decimal ? semicolons : commas_and_semicolons, cells);
    if (decimal)
      std::replace(plain.begin(), plain.end(), ',', '.');
    if (table.rows() == 0)
      table.columns = cells.size();
    for (const std::string_view cell : cells)
      if (const auto number = plain_number(cell))
        table.values.push_back(*number);
      else
        refuse(text, line, table.columns, fmt::format("; {} is no number", text.quoted(cell)));
    if (cells.size() != table.columns)
      refuse(text, line, table.columns, fmt::format(", as in line {}, not {}", table.lines.front(), cells.size()));
    begins_empty = begins_empty && cells.front().empty();
    ends_empty = ends_empty && cells.back().empty();
    table.lines.push_back(line.number);
  }
  if (table.rows() == 0)
    throw InputError("has no heights; allowed: text with a row of heights in m per line");
  // A separator at the end or the beginning of every line stands for no point.
  if (ends_empty && table.columns > 1)
    remove_column(table, table.columns - 1);
  if (begins_empty && table.columns > 1)
    remove_column(table, 0);
  return table;
}

} // namespace brinell::io
