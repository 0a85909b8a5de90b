// SPDX-License-Identifier: BSD-3-Clause
#include "curve_file.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/units.hpp"
#include "io/files.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <sstream>

namespace brinell::io
{

namespace
{

constexpr std::string_view blanks = " \t\r";

/// Without the blanks and quotes around it.
std::string trimmed(std::string_view field)
{
  const std::string around = std::string(blanks) + '"';
  const auto first = field.find_first_not_of(around), last = field.find_last_not_of(around);
  return first == field.npos ? "" : std::string(field.substr(first, last - first + 1));
}

/// Between any of the separators; empty ones, as behind the last separator of a line, are left out.
std::vector<std::string> split(std::string_view line, std::string_view separators)
{
  std::vector<std::string> fields;
  while (!line.empty())
  {
    const auto end = std::min(line.find_first_of(separators), line.size());
    if (std::string field = trimmed(line.substr(0, end)); !field.empty())
      fields.push_back(std::move(field));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return fields;
}

/// The columns of a line; decimal commas have become points.
std::vector<std::string> columns_of(const std::string& line)
{
  const auto with_points = [](std::vector<std::string> fields)
  {
    for (std::string& field : fields)
      std::replace(field.begin(), field.end(), ',', '.');
    return fields;
  };
  const auto has_comma_at_end = [](const std::string& field) { return field.front() == ',' || field.back() == ','; };
  const std::string inside = trimmed(line);
  if (inside.find(';') != inside.npos)
    return with_points(split(inside, ";"));
  if (inside.find('\t') != inside.npos && inside.find(",\t") == inside.npos)
    return with_points(split(inside, "\t"));
  std::vector<std::string> fields = split(inside, blanks);
  if (fields.size() == 2 && std::none_of(fields.begin(), fields.end(), has_comma_at_end))
    return with_points(std::move(fields));
  return split(inside, ", \t");
}

/// In SI; none if it is no number. The unit is read with it, so that "930.5" in MPa is the double of 930.5e6.
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
  const std::string text = trimmed(line);
  const auto first = text.find_first_not_of("+-.,");
  return first != text.npos && text[first] >= '0' && text[first] <= '9';
}

/// What a line may be, 930 MPa at 0.2 %.
std::string example(std::string_view strain_unit, std::string_view stress_unit)
{
  const double strain = strain_unit == "%" ? 0.2 : 0.002;
  const double stress = 930e6 / quantity(fmt::format("1 {}", stress_unit)).value;
  const std::string with_point = fmt::format("{:g}", strain);
  std::string with_comma = with_point;
  std::replace(with_comma.begin(), with_comma.end(), '.', ',');
  return fmt::format("plastic strain{} and stress in {}, as in \"{}, {:g}\" or, with decimal commas, \"{}; {:g}\"",
                     strain_unit == "%" ? " in %" : "", stress_unit, with_point, stress, with_comma, stress);
}

} // namespace

std::vector<TextLine> text_lines(const std::filesystem::path& file)
{
  std::istringstream stream(input_text(file));
  std::vector<TextLine> lines;
  std::string text;
  for (int number = 1; std::getline(stream, text); ++number)
    if (const auto first = text.find_first_not_of(blanks); first != std::string::npos && text[first] != '#')
      lines.push_back({number, text});
  return lines;
}

Curve read_curve(const std::filesystem::path& file, std::string_view strain_unit, std::string_view stress_unit)
{
  Curve curve;
  for (const TextLine& line : text_lines(file))
  {
    if (curve.stress.empty() && !begins_like_a_number(line.text))
      continue; // titles
    const std::vector<std::string> columns = columns_of(line.text);
    const auto strain =
        columns.size() == 2 ? number_of(columns[0], strain_unit == "1" ? "" : strain_unit) : std::nullopt;
    const auto stress = columns.size() == 2 ? number_of(columns[1], stress_unit) : std::nullopt;
    if (!strain || !stress)
      throw InputError(
          fmt::format("has in line {} \"{}\"{}; allowed: {}", line.number, trimmed(line.text).substr(0, 40),
                      columns.size() != 2 ? fmt::format(", {} columns", columns.size())
                                          : fmt::format(", where {} is no number", columns[strain ? 1 : 0]),
                      example(strain_unit, stress_unit)));
    curve.plastic_strain.push_back(*strain);
    curve.stress.push_back(*stress);
  }
  if (curve.stress.empty())
    throw InputError("has no line of numbers; allowed: text, " + example(strain_unit, stress_unit));
  return curve;
}

void require_unit_of_stress(const std::string& unit)
{
  const auto [value, found] = quantity("1 " + unit);
  if (found != dimension::pressure)
    throw InputError(fmt::format("is a unit of {}; allowed: a unit of stress, such as \"MPa\"", dimension_name(found)));
}

} // namespace brinell::io
