// SPDX-License-Identifier: BSD-3-Clause
#include "case_reader.hpp"

#include "brinell/io/height_file.hpp"
#include "brinell/io/schema.hpp"
#include "brinell/simulation/filling.hpp"
#include "measured_files.hpp"

#include <array>
#include <cmath>
#include <iterator>
#include <limits>

/// Reading of the textures of a body, including height maps from files.
namespace brinell::io
{

namespace
{

/// Reads a height map; if its keys are inconsistent, adds a problem and returns a smooth texture.
simulation::Texture height_map(const CaseReader& reader, const std::string& table)
{
  const auto spacing = reader.get_or<std::vector<double>>(table + "spacing", {});
  if (!reader.has(table + "spacing"))
  {
    reader.missing(table + "spacing", allowed_values(*find_entry(table + "spacing")));
    return {};
  }
  if (spacing.size() != 2)
  {
    reader.add(table + "spacing", "needs two lengths, [dx, dy]");
    return {};
  }
  if (!reader.has(table + "heights") || !reader.has(table + "columns"))
  {
    reader.add(table + "type", "needs {0}heights and {0}columns, or {0}file", table);
    return {};
  }
  const auto& heights = reader.get<std::vector<double>>(table + "heights");
  const int columns = reader.integer(table + "columns");
  if (heights.size() % static_cast<std::size_t>(columns) != 0)
  {
    reader.add(table + "columns", "does not divide the {} numbers of {}heights into rows", heights.size(), table);
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

/// Period of a random surface; if it cannot be determined, none, and a problem is added.
std::optional<std::array<double, 2>> random_size(const CaseReader& reader, const std::string& table,
                                                 const simulation::Domain* domain)
{
  constexpr double rolloffs =
      8.0; // period over roll-off wavelength, so that the period contains many of the longest waves
  if (reader.has(table + "size"))
  {
    const auto& size = reader.get<std::vector<double>>(table + "size");
    if (size.size() == 2)
      return std::array{size[0], size[1]};
    reader.add(table + "size", "needs two lengths, [along x, along y]");
    return std::nullopt;
  }
  if (!domain)
    return std::nullopt;
  const auto period = [&](const simulation::Domain::Axis& axis)
  { return axis.is_periodic() && reader.has("grid.size") ? std::optional(axis.size) : std::nullopt; };
  auto along_x = period(domain->x), along_y = period(domain->y);
  if (reader.has(table + "rolloff"))
  {
    const double size = rolloffs * reader.get<double>(table + "rolloff");
    along_x = along_x.value_or(size);
    along_y = along_y.value_or(size);
  }
  if (along_x && along_y)
    return std::array{*along_x, *along_y};
  reader.add(table + "type", "needs {0}size or {0}rolloff", table);
  return std::nullopt;
}

/// Reads a random surface; if its keys are inconsistent, adds a problem and returns a smooth texture.
simulation::Texture random_surface(const CaseReader& reader, const std::string& table, const simulation::Domain* domain)
{
  const auto number = [&](const char* key)
  { return reader.has(table + key) ? std::optional(reader.get<double>(table + key)) : std::nullopt; };
  simulation::SelfAffine p{.hurst = reader.get<double>(table + "hurst"),
                           .rms_height = number("rms_height"),
                           .rms_slope = number("rms_slope"),
                           .rolloff = reader.get_or(table + "rolloff", std::numeric_limits<double>::infinity()),
                           .cutoff = reader.get<double>(table + "cutoff"),
                           .seed = static_cast<std::uint64_t>(reader.get<std::int64_t>(table + "seed"))};
  if (!p.rms_height && !p.rms_slope)
  {
    reader.add(table + "type", "needs {0}rms_height or {0}rms_slope", table);
    return {};
  }
  const auto size = random_size(reader, table, domain);
  if (!size)
    return {};
  p.size_x = (*size)[0];
  p.size_y = (*size)[1];
  if (p.rolloff < p.cutoff)
  {
    reader.add(table + "rolloff", "is shorter than {0}cutoff = {1:g} m; allowed: {1:g} m or more", table, p.cutoff);
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

} // namespace

simulation::Texture read_texture(const CaseReader& reader, const std::string& key, const simulation::Domain* domain)
{
  simulation::Texture sum;
  for (const std::string& name : reader.raw.tables_of(key))
  {
    const std::string table = name + ".";
    const auto& option = chosen(reader, table + "type", texture_options());
    if (option.name == "sinusoid" && !reader.has(table + "wavelength_x") && !reader.has(table + "wavelength_y"))
      reader.add(table + "type", "needs {0}wavelength_x or {0}wavelength_y, or both", table);
    simulation::Texture part = option.make               ? made(reader, table, option)
                               : option.name == "random" ? random_surface(reader, table, domain)
                                                         : height_map(reader, table);
    std::move(part.parts.begin(), part.parts.end(), std::back_inserter(sum.parts));
  }
  return sum;
}

simulation::Texture read_film(const CaseReader& reader, const std::string& key)
{
  const std::string table = key + ".";
  return reader.get<std::string>(table + "type") == "none" ? simulation::Texture() : height_map(reader, table);
}

namespace
{

/// Whether distances differ by more than the digits that files have.
bool differs(const std::array<double, 2>& a, const std::array<double, 2>& b)
{
  constexpr double digits = 1e-3;
  return std::abs(a[0] - b[0]) > digits * std::abs(a[0]) || std::abs(a[1] - b[1]) > digits * std::abs(a[1]);
}

/// Warns if the case gives other distances than the file.
void warn_of_spacing(const CaseReader& reader, const std::string& table, const std::array<double, 2>& stored,
                     std::vector<Warning>& warnings)
{
  const auto& given = reader.get<std::vector<double>>(table + "spacing");
  if (given.size() != 2 || !differs(stored, {given[0], given[1]}))
    return;
  warnings.push_back({"spacing_of_file", fmt::format("{} is used, although the file has points every {:.6g} x {:.6g} m",
                                                     reader.cited(table + "spacing"), stored[0], stored[1])});
}

/// The unit of a file; if it is none of length, a problem is added and the result is m.
std::string length_unit(const CaseReader& reader, const std::string& key)
{
  try
  {
    static_cast<void>(size_of_unit(reader.get<std::string>(key), dimension::length, "length, such as \"um\""));
    return reader.get<std::string>(key);
  }
  catch (const InputError& error)
  {
    reader.add(key, error.what());
    return "m";
  }
}

/// Options of a case for a file of heights. The keys are removed, because the resolved case is in SI and has the heights.
/// @param table  ends with a dot
HeightFileOptions options_of(CaseValues& values, const CaseReader& reader, const std::string& table)
{
  HeightFileOptions options;
  for (const char* name : {"unit", "layout", "fill"})
  {
    const std::string key = table + name;
    if (!reader.has(key))
      continue;
    if (!reader.has(table + "file"))
      reader.add(key, "belongs to a file; it goes with {}file only", table);
    else if (key.ends_with("unit"))
      options.unit = length_unit(reader, key);
    else if (key.ends_with("layout"))
      options.layout = height_layout(reader.get<std::string>(key));
    else
      options.fill = reader.get<bool>(key);
    values.replace(key, {});
  }
  return options;
}

/// Replaces the value of a key, or a key that is replaced by more than one.
void set(CaseValues& values, const std::string& key, Value value)
{
  values.replace(key, {{key, std::move(value)}});
}

/// Adds what the file says and the case does not.
void take_from_file(CaseValues& values, const CaseReader& reader, const std::string& table, const HeightFile& file)
{
  if (file.x && !reader.raw.find(table + "x"))
    set(values, table + "x", *file.x);
  if (file.y && !reader.raw.find(table + "y"))
    set(values, table + "y", *file.y);
  if (file.periodic && !reader.raw.find(table + "periodic"))
    set(values, table + "periodic", *file.periodic);
}

/// Heights from a table in memory or, if there is none with that name, from a file.
HeightFile named_heights(const RawCase& raw, const std::string& name, const HeightFileOptions& options)
{
  HeightFile file;
  const auto found = raw.height_tables ? raw.height_tables->find(name) : HeightTables::const_iterator();
  if (raw.height_tables && found != raw.height_tables->end())
    file.table = found->second;
  else
    file = read_height_file(raw.folder / name, options);
  if (options.fill && file.gaps > 0)
    file.table.heights = simulation::filled(std::move(file.table.heights), file.table.columns);
  else if (file.gaps > 0)
    throw InputError(gap_text(file) + ", or fill = true here");
  return file;
}

/// Replaces the key `file` of a texture by its heights.
/// @param table  ends with a dot
void load_heights(CaseValues& values, const RawCase& raw, const std::string& table, Problems& problems,
                  std::vector<Warning>& warnings)
{
  const CaseReader reader{values, raw, problems};
  const HeightFileOptions options = options_of(values, reader, table);
  if (!reader.has(table + "file"))
    return;
  const auto name = reader.get<std::string>(table + "file");
  if (reader.has(table + "columns"))
  {
    // As with mutually exclusive keys, the command line overrides the file.
    if (!raw.find(table + "file")->from_command_line || raw.find(table + "columns")->from_command_line)
      reader.add(table + "columns", "cannot stand together with {}file; keep one of them", table);
    values.replace(table + "columns", {});
  }
  try
  {
    HeightFile file = named_heights(raw, name, options);
    take_from_file(values, reader, table, file);
    std::vector<std::pair<std::string, Value>> loaded{
        {table + "heights", std::move(file.table.heights)},
        {table + "columns", static_cast<std::int64_t>(file.table.columns)}};
    if (!reader.has(table + "spacing") && file.spacing)
      loaded.emplace_back(table + "spacing", std::vector(file.spacing->begin(), file.spacing->end()));
    else if (file.spacing)
      warn_of_spacing(reader, table, *file.spacing, warnings);
    values.replace(table + "file", std::move(loaded));
  }
  catch (const NoHeightText& error)
  {
    reader.add(
        table + "file",
        "{}; allowed: text with a row of heights or with x, y and z of a point per line, or a .npy file; \"brinell "
        "surface convert FILE OUT.npy\" makes one of formats of instruments, with --channel NAME of one of several "
        "maps",
        error.what());
  }
  catch (const InputError& error)
  {
    reader.add(table + "file", error.what());
  }
}

} // namespace

void load_texture_files(CaseValues& values, const RawCase& raw, const std::string& body, Problems& problems,
                        std::vector<Warning>& warnings)
{
  for (const std::string& table : raw.tables_of(body + ".texture"))
    load_heights(values, raw, table + ".", problems, warnings);
  load_heights(values, raw, body + ".film.", problems, warnings);
}

} // namespace brinell::io
