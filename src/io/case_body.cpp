// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "case_material.hpp"
#include "case_reader.hpp"
#include "number_lines.hpp"

#include <numbers>

namespace brinell::io
{

namespace
{

constexpr double degree = std::numbers::pi / 180.0;

simulation::Shape shape(const CaseReader& reader, const std::string& body)
{
  const std::string table = body + ".shape.";
  const auto number = [&](const char* key) { return reader.get<double>(table + key); };
  const auto& type = reader.get<std::string>(table + "type");
  if (type == "sphere")
    return simulation::Paraboloid{number("radius"), number("radius")};
  if (type == "ellipsoid")
    return simulation::Paraboloid{number("radius_x"), number("radius_y")};
  if (type == "cylinder")
    return simulation::Roller{number("radius"), number("length")};
  if (type == "cone")
    return simulation::Cone{number("half_angle") * degree, number("tip_radius")};
  if (type == "vickers")
    return simulation::Pyramid{4, 68.0 * degree, number("tip_radius")};
  if (type == "berkovich")
    return simulation::Pyramid{3, 65.27 * degree, number("tip_radius")};
  if (type != "flat")
    throw InternalError(fmt::format("the shape {} is in the schema, but is not built", type));
  return simulation::Plane{};
}

/// Heights row after row [m], and how many make a row.
struct Heights
{
  std::vector<double> values;
  std::size_t columns = 0;
};

/// Heights in m, a line per row.
Heights heights_of(const std::filesystem::path& file)
{
  Heights heights;
  for (const NumberLine& line : number_lines(file))
  {
    if (!line.values || (heights.columns > 0 && line.values->size() != heights.columns))
      throw InputError(fmt::format("has in line {} \"{}\"; allowed: {} heights in m", line.number,
                                   line.text.substr(0, 40),
                                   heights.columns > 0 ? std::to_string(heights.columns) : "one or more"));
    heights.columns = line.values->size();
    heights.values.insert(heights.values.end(), line.values->begin(), line.values->end());
  }
  if (heights.values.empty())
    throw InputError("has no heights");
  return heights;
}

/// Empty, with the problem told, if the keys do not fit together.
std::optional<simulation::HeightMap> height_map(const CaseReader& reader, const std::string& table)
{
  const auto& spacing = reader.get<std::vector<double>>(table + "spacing");
  if (spacing.size() != 2)
  {
    reader.add(table + "spacing", "needs two lengths, [dx, dy]");
    return std::nullopt;
  }
  if (!reader.has(table + "heights") || !reader.has(table + "columns"))
  {
    reader.add(table + "type", fmt::format("needs {0}heights and {0}columns, or {0}file", table));
    return std::nullopt;
  }
  const auto& heights = reader.get<std::vector<double>>(table + "heights");
  const int columns = reader.integer(table + "columns");
  if (heights.size() % static_cast<std::size_t>(columns) != 0)
  {
    reader.add(table + "columns",
               fmt::format("does not divide the {} numbers of {}heights into rows", heights.size(), table));
    return std::nullopt;
  }
  simulation::HeightMap map;
  map.nx = columns;
  map.ny = static_cast<int>(heights.size()) / columns;
  map.dx = spacing[0];
  map.dy = spacing[1];
  map.x = reader.get<double>(table + "x");
  map.y = reader.get<double>(table + "y");
  map.heights = heights;
  return map;
}

simulation::Texture texture(const CaseReader& reader, const std::string& body)
{
  const std::string table = body + ".texture.";
  const auto number = [&](const char* key) { return reader.get<double>(table + key); };
  const auto& type = reader.get<std::string>(table + "type");
  if (type == "smooth")
    return simulation::Smooth{};
  if (type == "dent" || type == "bump")
    return simulation::Dent{number("x"), number("y"), type == "dent" ? number("depth") : -number("height"),
                            number("radius")};
  if (auto map = height_map(reader, table))
    return *std::move(map);
  return simulation::Smooth{};
}

} // namespace

void load_texture_file(CaseValues& values, const RawCase& raw, const std::string& body, Problems& problems)
{
  const std::string table = body + ".texture.";
  if (!values.find(table + "file"))
    return;
  const auto name = values.get<std::string>(table + "file");
  const CaseReader reader{values, raw, problems};
  if (reader.has(table + "columns"))
  {
    // As with keys that exclude each other: what the command line sets makes that of the file pointless.
    if (!raw.find(table + "file")->from_command_line || raw.find(table + "columns")->from_command_line)
      reader.add(table + "columns", fmt::format("cannot stand together with {}file; keep one of them", table));
    values.replace(table + "columns", {});
  }
  try
  {
    Heights heights = heights_of(std::filesystem::path(raw.file).parent_path() / name);
    values.replace(table + "file", {{table + "heights", std::move(heights.values)},
                                    {table + "columns", static_cast<std::int64_t>(heights.columns)}});
  }
  catch (const InputError& error)
  {
    reader.add(table + "file", error.what());
  }
}

simulation::ShapedBody read_body(const CaseReader& reader, const std::string& body)
{
  return {shape(reader, body), material(reader.values, reader.raw, body, reader.problems), texture(reader, body)};
}

} // namespace brinell::io
