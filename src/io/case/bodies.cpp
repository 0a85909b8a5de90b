// SPDX-License-Identifier: BSD-3-Clause
#include "body_options.hpp"
#include "brinell/foundation/error.hpp"
#include "case_reader.hpp"
#include "io/files.hpp"

#include <cmath>
#include <limits>
#include <sstream>

/// Shape, texture and material of a body, and the files that they may come from.
namespace brinell::io
{

namespace
{

/// A line of a text file of numbers.
struct NumberLine
{
  int number = 0; ///< counts from 1
  std::string text;
  std::vector<double> values; ///< empty if something there is no number
};

std::vector<double> numbers_of(std::string line)
{
  for (char& c : line)
    if (c == ',' || c == ';' || c == '\t' || c == '\r')
      c = ' ';
  std::istringstream stream(line);
  std::vector<double> values;
  for (double value = 0.0; stream >> value;)
    values.push_back(value);
  return stream.eof() ? values : std::vector<double>{};
}

/// The lines of a file with numbers between blanks, commas, semicolons or tabs; empty lines and those that begin with # are
/// left out. @throws as `read_blocks`; the text continues a sentence that begins with the key.
std::vector<NumberLine> number_lines(const std::filesystem::path& file)
{
  std::istringstream stream(input_text(file));
  std::vector<NumberLine> lines;
  std::string text;
  for (int number = 1; std::getline(stream, text); ++number)
    if (const auto first = text.find_first_not_of(" \t\r"); first != std::string::npos && text[first] != '#')
      lines.push_back({number, text, numbers_of(text)});
  return lines;
}

InputError wrong_line(const NumberLine& line, const std::string& allowed)
{
  return InputError(fmt::format("has in line {} \"{}\"; allowed: {}", line.number, line.text.substr(0, 40), allowed));
}

/// Columns plastic strain [-] and stress [Pa]; one line of titles may come first.
void read_points(const std::filesystem::path& file, std::vector<double>& strain, std::vector<double>& stress)
{
  bool may_be_titles = true;
  for (const NumberLine& line : number_lines(file))
  {
    if (line.values.size() == 2)
    {
      strain.push_back(line.values[0]);
      stress.push_back(line.values[1]);
    }
    else if (!line.values.empty() || !may_be_titles)
      throw wrong_line(line, "plastic strain and stress in Pa, as in \"0.002, 930e6\"");
    may_be_titles = false;
  }
}

/// Heights in m, a line per row; and how many make a row.
std::pair<std::vector<double>, std::size_t> read_heights(const std::filesystem::path& file)
{
  std::vector<double> heights;
  std::size_t columns = 0;
  for (const NumberLine& line : number_lines(file))
  {
    if (line.values.empty() || (columns > 0 && line.values.size() != columns))
      throw wrong_line(line, fmt::format("{} heights in m", columns > 0 ? std::to_string(columns) : "one or more"));
    columns = line.values.size();
    heights.insert(heights.end(), line.values.begin(), line.values.end());
  }
  if (heights.empty())
    throw InputError("has no heights");
  return {std::move(heights), columns};
}

template <typename Product>
const Option<Product>& chosen(const CaseReader& reader, const std::string& key,
                              const std::vector<Option<Product>>& options)
{
  const auto& name = reader.get<std::string>(key);
  for (const Option<Product>& option : options)
    if (option.name == name)
      return option;
  throw InternalError(fmt::format("{} = {} is in the schema, but is not built", key, name));
}

template <typename Product>
Product made(const CaseReader& reader, const std::string& table, const Option<Product>& option)
{
  std::vector<double> numbers;
  for (const std::string& key : option.keys)
    numbers.push_back(reader.get<double>(table + key));
  return option.make(numbers.data());
}

/// Smooth, with the problem told, if the keys do not fit together.
simulation::Texture height_map(const CaseReader& reader, const std::string& table)
{
  const auto& spacing = reader.get<std::vector<double>>(table + "spacing");
  if (spacing.size() != 2)
  {
    reader.add(table + "spacing", "needs two lengths, [dx, dy]");
    return {};
  }
  if (!reader.has(table + "heights") || !reader.has(table + "columns"))
  {
    reader.add(table + "type", fmt::format("needs {0}heights and {0}columns, or {0}file", table));
    return {};
  }
  const auto& heights = reader.get<std::vector<double>>(table + "heights");
  const int columns = reader.integer(table + "columns");
  if (heights.size() % static_cast<std::size_t>(columns) != 0)
  {
    reader.add(table + "columns",
               fmt::format("does not divide the {} numbers of {}heights into rows", heights.size(), table));
    return {};
  }
  return simulation::HeightMap{.nx = columns,
                               .ny = static_cast<int>(heights.size()) / columns,
                               .dx = spacing[0],
                               .dy = spacing[1],
                               .x = reader.get<double>(table + "x"),
                               .y = reader.get<double>(table + "y"),
                               .heights = heights};
}

constitutive::HardeningLaw hardening_law(const CaseReader& reader, const std::string& table)
{
  const auto& option = chosen(reader, table + "law", law_options());
  if (option.make)
    return made(reader, table, option);
  for (const char* key : {"plastic_strain", "stress"})
    if (!reader.has(table + key))
      throw InputError(fmt::format("needs {0}plastic_strain and {0}stress, or {0}file", table));
  return constitutive::TabulatedHardening(reader.get<std::vector<double>>(table + "plastic_strain"),
                                          reader.get<std::vector<double>>(table + "stress"));
}

/// A list, empty if it is not given.
std::vector<double> numbers(const CaseReader& reader, const std::string& key)
{
  return reader.has(key) ? reader.get<std::vector<double>>(key) : std::vector<double>{};
}

std::vector<constitutive::KinematicTerm> kinematic_terms(const CaseReader& reader, const std::string& table)
{
  const std::vector<double> moduli = numbers(reader, table + "kinematic_moduli");
  std::vector<double> recall = numbers(reader, table + "kinematic_recall");
  if (recall.empty())
    recall.assign(moduli.size(), 0.0);
  if (recall.size() != moduli.size())
    throw InputError(fmt::format("needs one number in {0}kinematic_recall for each of {0}kinematic_moduli; there are "
                                 "{1} and {2}",
                                 table, recall.size(), moduli.size()));
  std::vector<constitutive::KinematicTerm> terms;
  for (std::size_t i = 0; i < moduli.size(); ++i)
    terms.push_back({moduli[i], recall[i]});
  return terms;
}

constitutive::DepthProfile profile(const CaseReader& reader, const std::string& table, const char* value)
{
  std::vector<double> depth = numbers(reader, table + "depth");
  std::vector<double> at_depth = numbers(reader, table + value);
  if (depth.empty() && at_depth.empty())
    return {};
  return {std::move(depth), std::move(at_depth)};
}

/// A material that yields before it is loaded is none. Both profiles are linear between their points: look at these.
void require_elastic_at_start(const constitutive::Material& material)
{
  std::vector<double> depths = material.initial_stress.depth();
  depths.insert(depths.end(), material.yield_factor.depth().begin(), material.yield_factor.depth().end());
  for (const double z : depths)
  {
    const double stress = material.initial_stress.at(z, 0.0);
    const double yield = constitutive::initial_yield_stress(*material.hardening) * material.yield_factor.at(z, 1.0);
    if (!(std::abs(stress) < yield))
      throw InputError(fmt::format("{:.4g} Pa at a depth of {:.4g} m, where the material yields at {:.4g} Pa; allowed: "
                                   "less than that",
                                   stress, z, yield));
  }
}

/// A law that cannot be made is a problem, at the place of its key.
constitutive::Material material(const CaseReader& reader, const std::string& table)
{
  if (reader.get<bool>(table + "rigid"))
    return {{std::numeric_limits<double>::infinity(), 0.0}, {}};
  constitutive::Material result{
      {reader.get<double>(table + "young_modulus"), reader.get<double>(table + "poisson_ratio")}, {}};
  const std::string hardening = table + "hardening.", law = hardening + "law";
  if (reader.get<std::string>(law) == "none")
    return result;
  // What does not fit together is reported at the line of `at`, or at its partner if that is missing.
  const auto attempt = [&](const std::string& at, const std::string& partner, const auto& make)
  {
    try
    {
      make();
    }
    catch (const InputError& error)
    {
      const std::string& cited = reader.raw.find(at) ? at : partner;
      reader.problems.add(reader.place(cited), fmt::format("{}: {}", cited, error.what()));
    }
  };
  attempt(law, law, [&] { result.hardening = hardening_law(reader, hardening); });
  attempt(hardening + "kinematic_recall", hardening + "kinematic_moduli",
          [&] { result.kinematic = kinematic_terms(reader, hardening); });
  attempt(table + "yield_profile.factor", table + "yield_profile.depth",
          [&] { result.yield_factor = profile(reader, table + "yield_profile.", "factor"); });
  attempt(table + "initial_stress.value", table + "initial_stress.depth",
          [&] { result.initial_stress = profile(reader, table + "initial_stress.", "value"); });
  if (reader.problems.empty())
    attempt(table + "initial_stress.value", table + "yield_profile.factor", [&] { require_elastic_at_start(result); });
  return result;
}

} // namespace

void load_hardening_file(CaseValues& values, const RawCase& raw, const std::string& body, Problems& problems)
{
  const std::string table = body + ".material.hardening.";
  const CaseReader reader{values, raw, problems};
  if (!reader.has(table + "file"))
    return;
  const auto name = reader.get<std::string>(table + "file");
  if (reader.has(table + "stress"))
    problems.add(reader.place(table + "stress"),
                 fmt::format("{0}stress cannot stand together with {0}file; keep one of them", table));
  std::vector<double> strain, stress;
  try
  {
    read_points(std::filesystem::path(raw.file).parent_path() / name, strain, stress);
  }
  catch (const InputError& error)
  {
    problems.add(reader.place(table + "file"), fmt::format("{}file = \"{}\" {}", table, name, error.what()));
  }
  values.replace(table + "file",
                 {{table + "plastic_strain", std::move(strain)}, {table + "stress", std::move(stress)}});
}

void load_texture_file(CaseValues& values, const RawCase& raw, const std::string& body, Problems& problems)
{
  const std::string table = body + ".texture.";
  const CaseReader reader{values, raw, problems};
  if (!reader.has(table + "file"))
    return;
  const auto name = reader.get<std::string>(table + "file");
  if (reader.has(table + "columns"))
  {
    // As with keys that exclude each other: what the command line sets makes that of the file pointless.
    if (!raw.find(table + "file")->from_command_line || raw.find(table + "columns")->from_command_line)
      reader.add(table + "columns", fmt::format("cannot stand together with {}file; keep one of them", table));
    values.replace(table + "columns", {});
  }
  try
  {
    auto [heights, columns] = read_heights(std::filesystem::path(raw.file).parent_path() / name);
    values.replace(table + "file",
                   {{table + "heights", std::move(heights)}, {table + "columns", static_cast<std::int64_t>(columns)}});
  }
  catch (const InputError& error)
  {
    reader.add(table + "file", error.what());
  }
}

simulation::ShapedBody read_body(const CaseReader& reader, const std::string& body)
{
  const std::string shape = body + ".shape.", texture = body + ".texture.";
  const auto& texture_option = chosen(reader, texture + "type", texture_options());
  return {made(reader, shape, chosen(reader, shape + "type", shape_options())), material(reader, body + ".material."),
          texture_option.make ? made(reader, texture, texture_option) : height_map(reader, texture)};
}

} // namespace brinell::io
