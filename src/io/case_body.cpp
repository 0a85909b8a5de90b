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

/// Heights in m, a line per row.
simulation::HeightMap heights(const std::filesystem::path& file)
{
  simulation::HeightMap map;
  for (const NumberLine& line : number_lines(file))
  {
    if (!line.values || (map.ny > 0 && static_cast<int>(line.values->size()) != map.nx))
      throw InputError(fmt::format("has in line {} \"{}\"; allowed: {} heights in m", line.number,
                                   line.text.substr(0, 40), map.ny > 0 ? std::to_string(map.nx) : "one or more"));
    map.nx = static_cast<int>(line.values->size());
    ++map.ny;
    map.heights.insert(map.heights.end(), line.values->begin(), line.values->end());
  }
  if (map.ny == 0)
    throw InputError("has no heights");
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
  const auto& spacing = reader.get<std::vector<double>>(table + "spacing");
  if (spacing.size() != 2)
    reader.add(table + "spacing", "needs two lengths, [dx, dy]");
  else
    try
    {
      const auto& name = reader.get<std::string>(table + "file");
      simulation::HeightMap map = heights(std::filesystem::path(reader.raw.file).parent_path() / name);
      map.dx = spacing[0];
      map.dy = spacing[1];
      map.x = number("x");
      map.y = number("y");
      return map;
    }
    catch (const InputError& error)
    {
      reader.add(table + "file", error.what());
    }
  return simulation::Smooth{};
}

} // namespace

void name_texture_file(CaseValues& values, const RawCase& raw, const std::string& body)
{
  const std::string key = body + ".texture.file";
  if (!values.find(key))
    return;
  const auto path = std::filesystem::path(raw.file).parent_path() / values.get<std::string>(key);
  values.replace(key, {{key, std::filesystem::absolute(path).lexically_normal().string()}});
}

simulation::ShapedBody read_body(const CaseReader& reader, const std::string& body)
{
  return {shape(reader, body), material(reader.values, reader.raw, body, reader.problems), texture(reader, body)};
}

} // namespace brinell::io
