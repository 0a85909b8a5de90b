// SPDX-License-Identifier: BSD-3-Clause
#include "case_reader.hpp"

#include "brinell/io/schema.hpp"
#include "io/npy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

/// Reading of the inclusions of a body, including voxels from files.
namespace brinell::io
{

namespace
{

using simulation::BodyInclusion;
using simulation::InclusionCluster;
using simulation::InclusionShape;
using simulation::InclusionVoxels;

/// Reader of one inclusion. @param table  ends with a dot
struct InclusionReader
{
  const CaseReader& reader;
  std::string table;

  [[nodiscard]] std::array<double, 3> centre() const
  {
    return {reader.get<double>(table + "x"), reader.get<double>(table + "y"), reader.get<double>(table + "depth")};
  }

  /// Half of the sizes; if their number is wrong, adds a problem.
  [[nodiscard]] std::array<double, 3> half_sizes() const
  {
    const auto& size = reader.get<std::vector<double>>(table + "size");
    if (size.size() == 1)
      return {0.5 * size[0], 0.5 * size[0], 0.5 * size[0]};
    if (size.size() == 3)
      return {0.5 * size[0], 0.5 * size[1], 0.5 * size[2]};
    reader.add(table + "size", "has {} lengths; allowed: one, or three along x, y and z", size.size());
    return {};
  }

  [[nodiscard]] InclusionShape shape(InclusionShape::Kind kind) const
  {
    InclusionShape result{kind, centre(), half_sizes()};
    if (kind == InclusionShape::Kind::cylinder)
    {
      const auto& axis = reader.get<std::string>(table + "axis");
      result.axis = axis == "x" ? 0 : axis == "y" ? 1 : 2;
    }
    return result;
  }

  [[nodiscard]] InclusionCluster cluster() const
  {
    const auto& diameter = reader.get<std::vector<double>>(table + "diameter");
    const bool is_ordered = diameter.size() <= 2 && diameter.back() >= diameter.front();
    if (!is_ordered)
      reader.add(table + "diameter", "; allowed: one length, or the smallest and the largest");
    InclusionCluster result{centre(),
                            half_sizes(),
                            0.5 * diameter.front(),
                            0.5 * diameter.back(),
                            reader.integer(table + "count"),
                            reader.get<double>(table + "gap"),
                            static_cast<std::uint64_t>(reader.get<std::int64_t>(table + "seed"))};
    if (!is_ordered || result.half_sides[0] <= 0.0) // told already
      return result;
    try
    {
      static_cast<void>(simulation::shapes_of(result));
    }
    catch (const InputError& error)
    {
      reader.add(table + "count", "does not fit: {}", error.what());
    }
    return result;
  }

  [[nodiscard]] InclusionVoxels voxels() const
  {
    const auto& size = reader.get<std::vector<double>>(table + "size");
    if (size.size() != 1)
      reader.add(table + "size", "has {} lengths; allowed: one, the edge of a voxel", size.size());
    for (const char* key : {"voxels", "columns", "rows"})
      if (!reader.has(table + key))
      {
        reader.missing(table + key, fmt::format("{0}voxels, {0}columns and {0}rows, or {0}file", table));
        return {};
      }
    const auto& values = reader.get<std::vector<double>>(table + "voxels");
    const int columns = reader.integer(table + "columns"), rows = reader.integer(table + "rows");
    const std::size_t layer = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    if (values.size() % layer != 0)
    {
      reader.add(table + "columns", "and {0}rows = {1} do not divide the {2} voxels into layers", table, rows,
                 values.size());
      return {};
    }
    InclusionVoxels result{{columns, rows, static_cast<int>(values.size() / layer)}, centre(), size.front(), {}};
    for (std::size_t i = 0; i < 3; ++i)
      result.corner[i] -= 0.5 * result.size * result.count[i];
    result.is_filled.reserve(values.size());
    if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); }))
      reader.add(table + (reader.raw.find(table + "file") ? "file" : "voxels"),
                 "has a voxel that is no finite number; allowed: 0 where the body is, else the inclusion");
    for (const double value : values)
      result.is_filled.push_back(value != 0.0 ? 1 : 0);
    if (std::ranges::count(result.is_filled, 1) == 0)
      reader.add(table + "type", "has no voxel that is not 0; allowed: at least one");
    return result;
  }

  [[nodiscard]] halfspace::Inclusion::Own misfit() const
  {
    if (!reader.has(table + "misfit"))
      return {};
    std::vector<double> strain = reader.get<std::vector<double>>(table + "misfit");
    if (strain.size() == 1)
      strain.assign(3, strain.front());
    if (strain.size() != 3 && strain.size() != 6)
    {
      reader.add(table + "misfit", "has {} numbers; allowed: one, three (x, y, z), or six (x, y, z, yz, xz, xy)",
                 strain.size());
      return {};
    }
    strain.resize(6, 0.0);
    const double mean = (strain[0] + strain[1] + strain[2]) / 3.0;
    return {Deviator{{strain[0] - mean, strain[1] - mean, strain[3], strain[4], strain[5]}}, mean};
  }

  [[nodiscard]] BodyInclusion inclusion(const std::string& type) const
  {
    using Kind = InclusionShape::Kind;
    BodyInclusion result;
    if (type == "cluster")
      result.region = cluster();
    else if (type == "voxels")
      result.region = voxels();
    else
      result.region = shape(type == "ellipsoid" ? Kind::ellipsoid : type == "cuboid" ? Kind::cuboid : Kind::cylinder);
    const auto& content = reader.get<std::string>(table + "content");
    if (content == "elastic")
    {
      result.elastic = {reader.get<double>(table + "young_modulus"), reader.get<double>(table + "poisson_ratio")};
      result.yield_factor = reader.get<double>(table + "yield_factor");
    }
    else
      result.elastic = {content == "void" ? 0.0 : std::numeric_limits<double>::infinity(), 0.25};
    result.own = misfit();
    return result;
  }
};

/// Refuses what is not computed in a body with inclusions, but for what depends on the motion.
void refuse_with_inclusions(const CaseReader& reader, const std::string& body, const constitutive::Material& material)
{
  const std::string inclusion = body + ".inclusion", table = body + ".material.";
  const auto refuse = [&](bool exists, const std::string& key, const char* allowed)
  {
    if (exists)
      reader.problems.add(reader.place(key),
                          fmt::format("{} does not go with {}; allowed: {}", key, inclusion, allowed));
  };
  refuse(material.elastic.is_rigid(), table + "rigid", "a body that deforms");
  refuse(!material.layers.empty(), table + "layers", "one of them");
  refuse(material.softening.has_value(), table + "softening.law", "one of them");
  if (!material.elastic.is_rigid() && !material.hardening && material.layers.empty())
    reader.problems.add(reader.place(table + "hardening.law"),
                        fmt::format("{}hardening.law = \"none\" does not go with {}; allowed: a hardening law, for a "
                                    "body that stays elastic one with a high yield stress",
                                    table, inclusion));
}

} // namespace

std::vector<BodyInclusion> read_inclusions(const CaseReader& reader, const std::string& body,
                                           const constitutive::Material& material)
{
  const std::string list = body + ".inclusion";
  std::vector<BodyInclusion> inclusions;
  for (const std::string& table : reader.raw.tables_of(list))
  {
    const auto type = reader.get_or(table + ".type", std::string("none"));
    if (type != "none")
      inclusions.push_back(InclusionReader{reader, table + "."}.inclusion(type));
    else if (reader.raw.lists.contains(list) && !reader.has(table + ".type"))
      reader.missing(table + ".type", allowed_values(*find_entry(table + ".type")));
  }
  if (!inclusions.empty())
    refuse_with_inclusions(reader, body, material);
  return inclusions;
}

void load_voxel_files(CaseValues& values, const RawCase& raw, const std::string& body, Problems& problems)
{
  const CaseReader reader{values, raw, problems};
  for (const std::string& name : raw.tables_of(body + ".inclusion"))
  {
    const std::string table = name + ".", key = table + "file";
    if (!reader.has(key))
      continue;
    try
    {
      NpyVolume volume = read_npy_volume(raw.folder / reader.get<std::string>(key));
      // A file of two axes may have the rows of all layers one beneath the other, as that in a folder of results.
      const auto given = [&](const char* axis, std::size_t of_file, bool may_divide)
      {
        if (!reader.has(table + axis))
          return static_cast<std::int64_t>(of_file);
        const auto number = reader.get<std::int64_t>(table + axis);
        if (may_divide ? of_file % static_cast<std::size_t>(number) != 0 : static_cast<std::size_t>(number) != of_file)
          reader.add(table + axis, "does not fit the {} {} of {}file; allowed: no {}, which follow from the file",
                     of_file, axis, table, axis);
        values.replace(table + axis, {});
        return number;
      };
      const std::int64_t columns = given("columns", volume.count[0], false),
                         rows = given("rows", volume.count[1], volume.count[2] == 1);
      values.replace(
          key, {{table + "voxels", std::move(volume.values)}, {table + "columns", columns}, {table + "rows", rows}});
    }
    catch (const InputError& error)
    {
      reader.add(key, error.what());
    }
  }
}

} // namespace brinell::io
