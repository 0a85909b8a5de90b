// SPDX-License-Identifier: BSD-3-Clause
#include "measured_files.hpp"

#include "brinell/foundation/error.hpp"
#include "io/files.hpp"
#include "io/npy.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fmt/format.h>
#include <optional>
#include <sstream>
#include <system_error>

namespace brinell::io
{

namespace
{

constexpr std::string_view blanks = " \t\r";

/// A line that is neither a comment nor empty, with its number, counted from 1.
struct Line
{
  int number = 0;
  std::string text;
};

std::vector<Line> lines_of(const std::filesystem::path& file)
{
  std::istringstream stream(input_text(file));
  std::vector<Line> lines;
  std::string text;
  for (int number = 1; std::getline(stream, text); ++number)
    if (const auto first = text.find_first_not_of(blanks); first != std::string::npos && text[first] != '#')
      lines.push_back({number, text});
  return lines;
}

InputError wrong_line(const Line& line, const std::string& why, const std::string& allowed)
{
  const auto first = line.text.find_first_not_of(blanks);
  return InputError(
      fmt::format("has in line {} \"{}\"{}; allowed: {}", line.number, line.text.substr(first, 40), why, allowed));
}

constexpr std::string_view blanks_and_quotes = " \t\r\"";

/// Splits a line at any of the separators. Empty fields, such as after the last separator of a line, are left out.
std::vector<std::string> split(std::string_view line, std::string_view separators)
{
  std::vector<std::string> fields;
  while (!line.empty())
  {
    const auto end = std::min(line.find_first_of(separators), line.size());
    if (std::string field(trimmed(line.substr(0, end), blanks_and_quotes)); !field.empty())
      fields.push_back(std::move(field));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return fields;
}

std::vector<std::string> with_points(std::vector<std::string> fields)
{
  for (std::string& field : fields)
    std::replace(field.begin(), field.end(), ',', '.');
  return fields;
}

bool has_comma_at_end(const std::string& field)
{
  return field.front() == ',' || field.back() == ',';
}

/// The columns of a line of a curve, with decimal commas replaced by points.
std::vector<std::string> columns_of(const std::string& line)
{
  const std::string inside(trimmed(line, blanks_and_quotes));
  if (inside.find(';') != inside.npos)
    return with_points(split(inside, ";"));
  if (inside.find('\t') != inside.npos && inside.find(",\t") == inside.npos)
    return with_points(split(inside, "\t"));
  std::vector<std::string> fields = split(inside, blanks);
  if (fields.size() == 2 && std::none_of(fields.begin(), fields.end(), has_comma_at_end))
    return with_points(std::move(fields));
  return split(inside, ", \t");
}

/// The number in SI; none if the field is not a number. Number and unit are read together, so that "930.5" in MPa is the same
/// double as 930.5e6.
std::optional<double> number_of(const std::string& field, std::string_view unit)
try
{
  if (field.find_first_not_of("-+.0123456789eE") != field.npos)
    return std::nullopt;
  return quantity(fmt::format("{} {}", field, unit)).value;
}
catch (const InputError&)
{
  return std::nullopt;
}

bool begins_like_a_number(const std::string& line)
{
  const std::string_view text = trimmed(line, blanks_and_quotes);
  const auto first = text.find_first_not_of("+-.,");
  return first != text.npos && text[first] >= '0' && text[first] <= '9';
}

/// Example of an allowed line, with 930 MPa at 0.2 %.
std::string example(std::string_view strain_unit, std::string_view stress_unit, CurveRules::Strain kind)
{
  const double strain = strain_unit == "%" ? 0.2 : 0.002;
  const double stress = 930e6 / quantity(fmt::format("1 {}", stress_unit)).value;
  const std::string with_point = fmt::format("{:g}", strain);
  std::string with_comma = with_point;
  std::replace(with_comma.begin(), with_comma.end(), '.', ',');
  return fmt::format("{} strain{} and stress in {}, as in \"{}, {:g}\" or, with decimal commas, \"{}; {:g}\"",
                     curve_words::strain.at(static_cast<std::size_t>(kind)), strain_unit == "%" ? " in %" : "",
                     stress_unit, with_point, stress, with_comma, stress);
}

/// Whether a word stands for a point that was not measured.
bool is_missing(std::string word)
{
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
  word.erase(0, word.find_first_not_of("+-"));
  return word == "nan" || word == "inf" || word == "infinity";
}

std::optional<double> plain_number(const std::string& word)
{
  const char* const begin = word.data() + (word.front() == '+' ? 1 : 0);
  const char* const end = word.data() + word.size();
  double value = 0.0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

constexpr std::string_view between_decimal_commas = ";\t\r ";

bool may_have_decimal_commas(const Line& line)
{
  const std::vector<std::string> fields = split(line.text, between_decimal_commas);
  const auto fits = [](const std::string& field)
  {
    constexpr std::string_view digits = "0123456789";
    const auto comma = field.find(',');
    const bool is_between = comma == field.npos || (comma > 0 && digits.find(field[comma - 1]) != digits.npos &&
                                                    digits.find(field.c_str()[comma + 1]) != digits.npos);
    return is_missing(field) ||
           (is_between && field.find('.') == field.npos && plain_number(with_points({field}).front()));
  };
  return (fields.size() > 1 || line.text.find(';') != line.text.npos) &&
         std::all_of(fields.begin(), fields.end(), fits);
}

/// Rows of heights; a row with a word that is not a number is empty.
/// @throws InputError if some heights were not measured, with the place of the first one, their number and a remedy
std::vector<std::vector<double>> rows_of(const std::vector<Line>& lines)
{
  const auto has_comma = [](const Line& line) { return line.text.find(',') != line.text.npos; };
  const bool decimal = std::any_of(lines.begin(), lines.end(), has_comma) &&
                       std::all_of(lines.begin(), lines.end(), may_have_decimal_commas);
  std::vector<std::vector<double>> rows;
  std::string first; // place of the first height that was not measured
  std::size_t missing = 0;
  for (const Line& line : lines)
  {
    const auto words = decimal ? with_points(split(line.text, between_decimal_commas)) : split(line.text, ",;\t\r ");
    auto& row = rows.emplace_back();
    for (std::size_t i = 0; i < words.size(); ++i)
    {
      if (is_missing(words[i]) && missing++ == 0)
        first = fmt::format("line {}, column {}", line.number, i + 1);
      if (const auto number = plain_number(words[i]))
        row.push_back(*number);
    }
    if (row.size() != words.size())
      row.clear();
  }
  if (missing > 0)
    throw InputError(not_measured(first, missing));
  return rows;
}

} // namespace

Curve read_curve(const std::filesystem::path& file, std::string_view strain_unit, std::string_view stress_unit,
                 CurveRules::Strain kind)
{
  Curve curve;
  for (const Line& line : lines_of(file))
  {
    if (curve.stress.empty() && !begins_like_a_number(line.text))
      continue; // title lines
    const std::vector<std::string> columns = columns_of(line.text);
    const auto strain =
        columns.size() == 2 ? number_of(columns[0], strain_unit == "1" ? "" : strain_unit) : std::nullopt;
    const auto stress = columns.size() == 2 ? number_of(columns[1], stress_unit) : std::nullopt;
    if (!strain || !stress)
      throw wrong_line(line,
                       columns.size() != 2 ? fmt::format(", {} columns", columns.size())
                                           : fmt::format(", where {} is not a number", columns[strain ? 1 : 0]),
                       example(strain_unit, stress_unit, kind));
    curve.strain.push_back(*strain);
    curve.stress.push_back(*stress);
  }
  if (curve.stress.empty())
    throw InputError("has no line of numbers; allowed: text, " + example(strain_unit, stress_unit, kind));
  return curve;
}

HeightTable read_heights(const std::filesystem::path& file)
{
  if (file.extension() == ".npy")
    return read_npy(file);
  HeightTable table;
  const std::vector<Line> lines = lines_of(file);
  const auto rows = rows_of(lines);
  for (std::size_t j = 0; j < rows.size(); ++j)
  {
    if (rows[j].empty() || rows[j].size() != rows.front().size())
      throw wrong_line(lines[j], "",
                       fmt::format("{} heights in m", j > 0 ? std::to_string(table.columns) : "one or more"));
    table.columns = rows[j].size();
    table.heights.insert(table.heights.end(), rows[j].begin(), rows[j].end());
  }
  if (table.heights.empty())
    throw InputError("has no heights; allowed: text with a row of heights in m per line");
  return table;
}

double size_of_unit(const std::string& unit, Dimension dimension, std::string_view allowed)
{
  const auto [size, found] = quantity("1 " + unit);
  if (found != dimension)
    throw InputError(fmt::format("is a unit of {}; allowed: a unit of {}", dimension_name(found), allowed));
  return size;
}

} // namespace brinell::io
