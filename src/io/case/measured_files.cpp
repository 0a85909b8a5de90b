// SPDX-License-Identifier: BSD-3-Clause
#include "measured_files.hpp"

#include "brinell/foundation/error.hpp"
#include "io/input_lines.hpp"
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

InputError wrong_line(const InputLines& text, const InputLine& line, const std::string& why, const std::string& allowed)
{
  return InputError(fmt::format("has in line {} {}{}; allowed: {}", line.number, text.quoted(line.text), why, allowed));
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
std::vector<std::string> columns_of(std::string_view line)
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

bool begins_like_a_number(std::string_view line)
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

} // namespace

Curve read_curve(const std::filesystem::path& file, std::string_view strain_unit, std::string_view stress_unit,
                 CurveRules::Strain kind)
{
  Curve curve;
  const InputLines text = input_lines(file);
  for (const InputLine& line : text.lines)
  {
    if (line.is_comment || (curve.stress.empty() && !begins_like_a_number(line.text)))
      continue; // also title lines
    const std::vector<std::string> columns = columns_of(line.text);
    const auto strain =
        columns.size() == 2 ? number_of(columns[0], strain_unit == "1" ? "" : strain_unit) : std::nullopt;
    const auto stress = columns.size() == 2 ? number_of(columns[1], stress_unit) : std::nullopt;
    if (!strain || !stress)
      throw wrong_line(text, line,
                       columns.size() != 2
                           ? fmt::format(", {} columns", columns.size())
                           : fmt::format(", where {} is not a number", text.shown(columns[strain ? 1 : 0])),
                       example(strain_unit, stress_unit, kind));
    curve.strain.push_back(*strain);
    curve.stress.push_back(*stress);
  }
  if (curve.stress.empty())
    throw InputError("has no line of numbers; allowed: text, " + example(strain_unit, stress_unit, kind));
  return curve;
}

double size_of_unit(const std::string& unit, Dimension dimension, std::string_view allowed)
{
  const auto [size, found] = quantity("1 " + unit);
  if (found != dimension)
    throw InputError(fmt::format("is a unit of {}; allowed: a unit of {}", dimension_name(found), allowed));
  return size;
}

} // namespace brinell::io
