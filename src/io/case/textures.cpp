// SPDX-License-Identifier: BSD-3-Clause
#include "case_reader.hpp"
#include "measured_files.hpp"

#include <array>
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
  const auto& spacing = reader.get<std::vector<double>>(table + "spacing");
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

namespace
{

/// Heights from a table in memory or, if there is none with that name, from a file.
HeightTable named_heights(const RawCase& raw, const std::string& name)
{
  const auto found = raw.height_tables ? raw.height_tables->find(name) : HeightTables::const_iterator();
  return raw.height_tables && found != raw.height_tables->end() ? found->second : read_heights(raw.folder / name);
}

/// Size in m of the unit of a height file; 1 if no unit is given. If the unit is invalid, a problem is added and the result is 1.
/// The key is removed, because the resolved case is in SI.
/// @param table  ends with a dot
double metres_of_unit(CaseValues& values, const CaseReader& reader, const std::string& table)
{
  const std::string key = table + "unit";
  if (!reader.has(key))
    return 1.0;
  double metres = 1.0;
  if (!reader.has(table + "file"))
    reader.add(key, "is the unit of a file; it goes with {}file only", table);
  else
    try
    {
      metres = size_of_unit(reader.get<std::string>(key), dimension::length, "length, such as \"um\"");
    }
    catch (const InputError& error)
    {
      reader.add(key, error.what());
    }
  values.replace(key, {});
  return metres;
}

/// Replaces the key `file` of a texture by its heights.
/// @param table  ends with a dot
void load_heights(CaseValues& values, const RawCase& raw, const std::string& table, Problems& problems)
{
  const CaseReader reader{values, raw, problems};
  const double metres = metres_of_unit(values, reader, table);
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
    auto [heights, columns] = named_heights(raw, name);
    for (double& height : heights)
      height *= metres;
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

} // namespace brinell::io
