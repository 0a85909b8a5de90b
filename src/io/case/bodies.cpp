// SPDX-License-Identifier: BSD-3-Clause
#include "body_options.hpp"
#include "brinell/foundation/error.hpp"
#include "case_reader.hpp"
#include "curve_file.hpp"
#include "io/npy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
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

/// The lines of a file with numbers between blanks, commas, semicolons or tabs. @throws as `text_lines`
std::vector<NumberLine> number_lines(const std::filesystem::path& file)
{
  std::vector<NumberLine> lines;
  for (const TextLine& line : text_lines(file))
    lines.push_back({line.number, line.text, numbers_of(line.text)});
  return lines;
}

InputError wrong_line(const NumberLine& line, const std::string& allowed)
{
  return InputError(fmt::format("has in line {} \"{}\"; allowed: {}", line.number, line.text.substr(0, 40), allowed));
}

/// Heights in m, in text a line per row; and how many make a row.
NumberTable read_heights(const std::filesystem::path& file)
{
  if (file.extension() == ".npy")
    return read_npy(file);
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
  for (const std::string& key : option.keys) // a length that is not given has no end
    numbers.push_back(reader.has(table + key) ? reader.get<double>(table + key)
                                              : std::numeric_limits<double>::infinity());
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
  attempt(table + "softening.law", table + "softening.law",
          [&] { result.softening = softening_law(reader, table + "softening."); });
    return {};
  }
  return simulation::HeightMap{.nx = columns,
                               .ny = static_cast<int>(heights.size()) / columns,
                               .dx = spacing[0],
                               .dy = spacing[1],
                               .x = reader.get<double>(table + "x"),
                               .y = reader.get<double>(table + "y"),
                               .heights = heights,
                               .periodic = reader.get<bool>(table + "periodic")};
}

/// Smooth, with the problem told, if no wavelength is given.
simulation::Texture sinusoid(const CaseReader& reader, const std::string& table)
{
  simulation::Sinusoid waves{.amplitude = reader.get<double>(table + "amplitude"),
                             .x = reader.get<double>(table + "x"),
                             .y = reader.get<double>(table + "y")};
  if (!reader.has(table + "wavelength_x") && !reader.has(table + "wavelength_y"))
  {
    reader.add(table + "type", fmt::format("needs {0}wavelength_x or {0}wavelength_y, or both", table));
    return {};
  }
  if (reader.has(table + "wavelength_x"))
    waves.wavelength_x = reader.get<double>(table + "wavelength_x");
  if (reader.has(table + "wavelength_y"))
    waves.wavelength_y = reader.get<double>(table + "wavelength_y");
  return waves;
}

/// Period of the grid along x and along y, where it is given.
std::array<std::optional<double>, 2> grid_period(const CaseReader& reader)
{
  const auto& boundary = reader.get<std::string>("grid.boundary");
  if (!reader.has("grid.size"))
    return {};
  const auto& size = reader.get<std::vector<double>>("grid.size");
  if (boundary == "periodic" && size.size() == 2)
    return {size[0], size[1]};
  if (size.size() != 1 || boundary == "periodic") // told with the domain
    return {};
  return boundary == "periodic_x" ? std::array<std::optional<double>, 2>{size[0], std::nullopt}
                                  : std::array<std::optional<double>, 2>{std::nullopt, size[0]};
}

/// Period of a random surface; none, with the problem told, if it cannot be known.
std::optional<std::array<double, 2>> random_size(const CaseReader& reader, const std::string& table)
{
  constexpr double rolloffs = 8.0; // so that the longest waves are many
  if (reader.has(table + "size"))
  {
    const auto& size = reader.get<std::vector<double>>(table + "size");
    if (size.size() == 2)
      return std::array{size[0], size[1]};
    reader.add(table + "size", "needs two lengths, [along x, along y]");
    return std::nullopt;
  }
  auto [along_x, along_y] = grid_period(reader);
  if (reader.has(table + "rolloff"))
  {
    const double size = rolloffs * reader.get<double>(table + "rolloff");
    along_x = along_x.value_or(size);
    along_y = along_y.value_or(size);
  }
  if (along_x && along_y)
    return std::array{*along_x, *along_y};
  reader.add(table + "type", fmt::format("needs {0}size or {0}rolloff", table));
  return std::nullopt;
}

/// Smooth, with the problem told, if the keys do not fit together.
simulation::Texture random_surface(const CaseReader& reader, const std::string& table)
{
  const auto number = [&](const char* key)
  { return reader.has(table + key) ? std::optional(reader.get<double>(table + key)) : std::nullopt; };
  simulation::SelfAffine p{.hurst = reader.get<double>(table + "hurst"),
                           .rms_height = number("rms_height"),
                           .rms_slope = number("rms_slope"),
                           .rolloff = number("rolloff").value_or(std::numeric_limits<double>::infinity()),
                           .cutoff = reader.get<double>(table + "cutoff"),
                           .seed = static_cast<std::uint64_t>(reader.get<std::int64_t>(table + "seed"))};
  if (!p.rms_height && !p.rms_slope)
  {
    reader.add(table + "type", fmt::format("needs {0}rms_height or {0}rms_slope", table));
    return {};
  }
  const auto size = random_size(reader, table);
  if (!size)
    return {};
  p.size_x = (*size)[0];
  p.size_y = (*size)[1];
  if (p.rolloff < p.cutoff)
  {
    reader.add(table + "rolloff",
               fmt::format("is shorter than {0}cutoff = {1:g} m; allowed: {1:g} m or more", table, p.cutoff));
    return {};
  }
  try
  {
    return simulation::RandomSurface(p);
  }
  catch (const InputError& error)
  {
    reader.problems.add(reader.place(table + "cutoff"), fmt::format("{}cutoff: {}", table, error.what()));
    return {};
  }
}

/// The sum of the tables of its list, or what its one table says.
simulation::Texture texture(const CaseReader& reader, const std::string& key)
{
  simulation::Texture sum;
  for (const std::string& name : reader.raw.tables_of(key))
  {
    const std::string table = name + ".";
    const auto& option = chosen(reader, table + "type", texture_options());
    simulation::Texture part = option.make                 ? made(reader, table, option)
                               : option.name == "random"   ? random_surface(reader, table)
                               : option.name == "sinusoid" ? sinusoid(reader, table)
                                                           : height_map(reader, table);
    std::move(part.parts.begin(), part.parts.end(), std::back_inserter(sum.parts));
  }
  return sum;
}

constitutive::HardeningLaw hardening_law(const CaseReader& reader, const std::string& table)
{
  const auto& option = chosen(reader, table + "law", law_options());
  if (option.make)
    return made(reader, table, option);
  for (const char* key : {"plastic_strain", "stress"})
    if (!reader.has(table + key))
      throw InputError(fmt::format("needs {0}plastic_strain and {0}stress, or {0}file", table));
  const auto& stress = reader.get<std::vector<double>>(table + "stress");
  try
  {
    return constitutive::TabulatedHardening(reader.get<std::vector<double>>(table + "plastic_strain"), stress);
  }
  catch (const InputError& error)
  {
    if (std::is_sorted(stress.begin(), stress.end()))
      throw;
    throw InputError(fmt::format("{}; of a measurement that scatters, monotone = true takes the largest stress so far",
                                 error.what()));
  }
}

/// A list, empty if it is not given.
std::vector<double> numbers(const CaseReader& reader, const std::string& key)
{
  return reader.has(key) ? reader.get<std::vector<double>>(key) : std::vector<double>{};
}

/// One term per table of the list; a table without a modulus is a problem, none at all is none.
std::vector<constitutive::KinematicTerm> kinematic_terms(const CaseReader& reader, const std::string& list)
{
  std::vector<constitutive::KinematicTerm> terms;
  for (const std::string& table : reader.raw.tables_of(list))
  {
    const bool has_recall = reader.has(table + ".recall");
    if (reader.has(table + ".modulus"))
      terms.push_back(
          {reader.get<double>(table + ".modulus"), has_recall ? reader.get<double>(table + ".recall") : 0.0});
    else if (has_recall || reader.raw.lists.contains(list))
      reader.problems.add(
          reader.place(has_recall ? table + ".recall" : table + ".modulus"),
          fmt::format("{}.modulus is missing; allowed: {}", table, allowed_values(*find_entry(table + ".modulus"))));
  }
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
  constitutive::Material result{{std::numeric_limits<double>::infinity(), 0.0}, {}};
  const bool deforms = !reader.get<bool>(table + "rigid");
  if (deforms)
    result.elastic = {reader.get<double>(table + "young_modulus"), reader.get<double>(table + "poisson_ratio")};
  read_thermal(reader, table + "thermal.", result);
  if (!deforms)
    return result;
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
  result.kinematic = kinematic_terms(reader, hardening + "back_stresses");
  attempt(table + "yield_profile.factor", table + "yield_profile.depth",
          [&] { result.yield_factor = profile(reader, table + "yield_profile.", "factor"); });
  attempt(table + "initial_stress.value", table + "initial_stress.depth",
          [&] { result.initial_stress = profile(reader, table + "initial_stress.", "value"); });
  if (reader.problems.empty())
    attempt(table + "initial_stress.value", table + "yield_profile.factor", [&] { require_elastic_at_start(result); });
  return result;
}

/// Puts the points of hardening.file in its place.
void load_curve(CaseValues& values, const CaseReader& reader, const std::string& table)
{
  const auto word = [&](const char* key, const char* otherwise)
  { return reader.has(table + key) ? reader.get<std::string>(table + key) : std::string(otherwise); };
  if (reader.has(table + "stress"))
    reader.problems.add(reader.place(table + "stress"),
                        fmt::format("{0}stress cannot stand together with {0}file; keep one of them", table));
  const char* key = "stress_unit";
  Curve curve;
  try
  {
    const std::string stress_unit = word(key, "Pa");
    require_unit_of_stress(stress_unit);
    key = "file";
    curve = read_curve(reader.raw.folder / word(key, ""), word("strain_unit", "1"), stress_unit);
  }
  catch (const InputError& error) // the whole name, however long
  {
    reader.problems.add(reader.place(table + key),
                        fmt::format("{}{} = \"{}\" {}", table, key, word(key, ""), error.what()));
  }
  values.replace(table + "file", {{table + "plastic_strain", std::move(curve.plastic_strain)},
                                  {table + "stress", std::move(curve.stress)}});
}

} // namespace

void load_hardening_file(CaseValues& values, const RawCase& raw, const std::string& body, Problems& problems)
{
  const std::string table = body + ".material.hardening.";
  const CaseReader reader{values, raw, problems};
  const bool is_of_file = reader.has(table + "file");
  if (is_of_file)
    load_curve(values, reader, table);
  for (const char* unit : {"strain_unit", "stress_unit"}) // those of the file: what is resolved is in SI
    if (reader.has(table + unit))
    {
      if (!is_of_file)
        reader.add(table + unit, fmt::format("is the unit of a file; it goes with {}file only", table));
      values.replace(table + unit, {});
    }
  if (reader.has(table + "monotone") && reader.get<bool>(table + "monotone") && reader.has(table + "stress"))
  {
    auto stress = reader.get<std::vector<double>>(table + "stress");
    for (std::size_t i = 1; i < stress.size(); ++i)
      stress[i] = std::max(stress[i], stress[i - 1]);
    values.replace(table + "stress", {{table + "stress", std::move(stress)}});
  }
}

namespace
{

/// Of a table in memory, or of a file.
NumberTable named_heights(const RawCase& raw, const std::string& name)
{
  if (raw.height_tables)
    if (const auto found = raw.height_tables->find(name); found != raw.height_tables->end())
      return {found->second.heights, found->second.columns};
  return read_heights(raw.folder / name);
}

/// @param table  ends with a dot
void load_heights(CaseValues& values, const RawCase& raw, const std::string& table, Problems& problems)
{
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
    auto [heights, columns] = named_heights(raw, name);
    values.replace(table + "file",
                   {{table + "heights", std::move(heights)}, {table + "columns", static_cast<std::int64_t>(columns)}});
  }
  catch (const InputError& error)
  {
    reader.add(table + "file", error.what());
  }
}

} // namespace

void load_texture_files(CaseValues& values, const RawCase& raw, const std::string& body, Problems& problems)
{
  for (const std::string& table : raw.tables_of(body + ".texture"))
    load_heights(values, raw, table + ".", problems);
}

simulation::ShapedBody read_body(const CaseReader& reader, const std::string& body)
{
  const std::string shape = body + ".shape.";
  return {made(reader, shape, chosen(reader, shape + "type", shape_options())), material(reader, body + ".material."),
          texture(reader, body + ".texture")};
}

} // namespace brinell::io
