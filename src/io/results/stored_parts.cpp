// SPDX-License-Identifier: BSD-3-Clause
#include "stored_parts.hpp"

#include "brinell/simulation/surface_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace brinell::io
{

namespace
{

using simulation::BodySnapshot;
using simulation::Snapshot;
using simulation::StepFields;

const Snapshot no_bodies; ///< for the table of fields

/// Word that chooses a field on a surface; empty for a field that is always stored.
std::string_view word_of(std::string_view name)
{
  std::string_view word;
  const auto look_at = [&](const auto& fields)
  {
    for (const auto& field : fields)
      if (field.name == name && !(field.needs.empty()))
        word = field.word;
  };
  look_at(simulation::surface_fields(no_bodies));
  look_at(simulation::surface_fields(no_bodies.lower));
  return word;
}

constexpr std::array fields_within{"stress",      "von_mises_stress", "plastic_strain", "equivalent_plastic_strain",
                                   "temperature", "fatigue",          "inclusion"};

bool is_within(std::string_view field)
{
  return std::ranges::find(fields_within, field) != fields_within.end();
}

/// Cells along an axis in a region. Which cells a stride takes depends on their coordinates only, so that grids of the same
/// lattice agree, whether one has grown or lies elsewhere.
/// @param first  centre of cell 0 on the body [m]
Spaced taken_along(int cells, double first, double size, const std::optional<std::vector<double>>& region, int stride)
{
  int begin = 0, end = cells;
  if (region)
  {
    constexpr double rounding = 1e-6;
    begin = static_cast<int>(std::ceil(std::clamp((region->front() - first) / size - rounding, 0.0, cells - 1.0)));
    end = 1 + static_cast<int>(std::floor(std::clamp((region->back() - first) / size + rounding, 0.0, cells - 1.0)));
    if (end <= begin) // no centre lies between: the nearest one
    {
      const double middle = 0.5 * (region->front() + region->back());
      begin = static_cast<int>(std::lround(std::clamp((middle - first) / size, 0.0, cells - 1.0)));
      end = begin + 1;
    }
  }
  const int number = static_cast<int>(std::floor(0.5 * std::round(2.0 * (first / size + begin)))); // of the first cell
  const int start = begin + ((-number) % stride + stride) % stride;
  if (start >= end)
    return {begin, 1, stride};
  return {start, (end - start + stride - 1) / stride, stride};
}

/// Some cells of a field on a surface.
std::vector<double> part_of(const std::vector<double>& field, const SurfaceGrid& grid, const Spaced& x, const Spaced& y)
{
  std::vector<double> part;
  if (field.empty())
    return part;
  part.reserve(static_cast<std::size_t>(y.count) * static_cast<std::size_t>(x.count));
  for (int j = 0; j < y.count; ++j)
    for (int i = 0; i < x.count; ++i)
      part.push_back(field[grid.index(x.item(i), y.item(j))]);
  return part;
}

struct TakenOfBody
{
  Spaced x, y, z;
};

TakenOfBody taken_of(const VolumeGrid& grid, double x0, double y0, const StoredCells& cells)
{
  constexpr double rounding = 1e-9;
  const SurfaceGrid& surface = grid.surface;
  const int layers =
      cells.depth ? static_cast<int>(std::ceil(std::min(*cells.depth / grid.dz - rounding, 1.0 * grid.nz))) : grid.nz;
  return {taken_along(surface.nx, x0, surface.dx, cells.region_x, cells.stride),
          taken_along(surface.ny, y0, surface.dy, cells.region_y, cells.stride),
          taken_along(std::max(1, layers), 0.5 * grid.dz, grid.dz, cells.region_z, cells.stride_z)};
}

VolumeGrid grid_of(const VolumeGrid& grid, const TakenOfBody& taken)
{
  VolumeGrid part = grid;
  part.surface.nx = taken.x.count;
  part.surface.ny = taken.y.count;
  part.surface.dx *= taken.x.stride;
  part.surface.dy *= taken.y.stride;
  part.nz = taken.z.count;
  part.dz *= taken.z.stride;
  return part;
}

void cut(BodySnapshot& body, StepFields::Within& within, const StoredCells& cells)
{
  const VolumeGrid grid = body.grid;
  const TakenOfBody taken = taken_of(grid, body.x0, body.y0, cells);
  for (const auto& field : simulation::surface_fields(body))
    *field.values = part_of(*field.values, grid.surface, taken.x, taken.y);
  const auto cut_field = [taken](std::function<LayeredFields()>& field)
  {
    if (field)
      field = [taken, whole = field] { return whole().selected(taken.z, taken.y, taken.x); };
  };
  for (auto* field : {&within.equivalent_plastic_strain, &within.temperature, &within.plastic_strain, &within.stress,
                      &within.inclusion})
    cut_field(*field);
  for (auto& field : within.fatigue)
    cut_field(field);
  body.grid = grid_of(grid, taken);
  body.x0 += taken.x.first * grid.surface.dx;
  body.y0 += taken.y.first * grid.surface.dy;
  body.top += (taken.z.first + 0.5) * grid.dz - 0.5 * body.grid.dz;
}

/// Takes every n-th cell of the contact, those that are taken on the lower body, too.
void cut(Snapshot& contact, const StoredCells& cells)
{
  const SurfaceGrid grid = contact.contact;
  const Spaced x = taken_along(grid.nx, contact.x0 + contact.lower.contact_x, grid.dx, std::nullopt, cells.stride),
               y = taken_along(grid.ny, contact.y0, grid.dy, std::nullopt, cells.stride);
  for (const auto& field : simulation::surface_fields(contact))
    *field.values = part_of(*field.values, grid, x, y);
  contact.contact.nx = x.count;
  contact.contact.ny = y.count;
  contact.contact.dx *= x.stride;
  contact.contact.dy *= y.stride;
  contact.x0 += x.first * grid.dx;
  contact.y0 += y.first * grid.dy;
}

/// Drops the fields of a body that are not chosen.
void choose(BodySnapshot& body, StepFields::Within& within, const std::vector<std::string>& words, bool is_stored)
{
  const auto keeps = [&](std::string_view field) { return is_stored && chooses(words, field); };
  const auto drop = [&](std::string_view name, auto& field)
  {
    if (!keeps(name))
      field = {};
  };
  for (const auto& field : simulation::surface_fields(body))
    drop(field.name, *field.values);
  drop("equivalent_plastic_strain", within.equivalent_plastic_strain);
  drop("temperature", within.temperature);
  drop("plastic_strain", within.plastic_strain);
  drop("fatigue", within.fatigue);
  drop("inclusion", within.inclusion);
  within.keeps_stress = keeps("stress");
  within.keeps_von_mises = keeps("von_mises_stress");
  if (!within.keeps_stress && !within.keeps_von_mises)
    within.stress = {};
}

} // namespace

const std::vector<std::string>& field_words()
{
  static const std::vector<std::string> words = []
  {
    std::vector<std::string> all{"all", "surface"};
    all.insert(all.end(), fields_within.begin(), fields_within.end());
    const auto add = [&](const auto& fields)
    {
      for (const auto& field : fields)
        if (!field.needs.empty() && std::ranges::find(all, field.word) == all.end())
          all.emplace_back(field.word);
    };
    add(simulation::surface_fields(no_bodies.lower));
    add(simulation::surface_fields(no_bodies));
    return all;
  }();
  return words;
}

bool chooses(const std::vector<std::string>& words, std::string_view field)
{
  const auto has = [&](std::string_view word) { return std::ranges::find(words, word) != words.end(); };
  if (is_within(field))
    return has("all") || has(field);
  const std::string_view word = word_of(field);
  return word.empty() || has("all") || has("surface") || has(word);
}

bool asks_for_fields_within(const OutputChoice& choice)
{
  if (!choice.points.empty())
    return true;
  if (choice.fields)
    return std::ranges::any_of(*choice.fields,
                               [](const std::string& word) { return word == "all" || is_within(word); });
  const auto is_plane = [](const std::optional<std::vector<double>>& region)
  { return region && region->front() == region->back(); };
  return choice.cells.depth || choice.cells.region_z || is_plane(choice.cells.region_x) ||
         is_plane(choice.cells.region_y);
}

StepFields chosen_fields(const StepFields& fields, const std::vector<std::string>& words, const StoredParts& parts)
{
  StepFields chosen = fields;
  Snapshot& s = chosen.surfaces;
  for (const auto& field : simulation::surface_fields(s))
    if (!chooses(words, field.name))
      field.values->clear();
  choose(s.lower, chosen.lower, words, parts.bodies != StoredBodies::upper);
  choose(s.upper, chosen.upper, words, parts.bodies != StoredBodies::lower);
  if (!parts.cells.is_everything())
  {
    cut(s.lower, chosen.lower, parts.cells);
    cut(s.upper, chosen.upper, parts.cells);
    if (parts.cells.stride > 1)
      cut(s, parts.cells);
  }
  chosen.are_alike = fields.are_alike && parts.bodies == StoredBodies::both && parts.cells.is_everything();
  return chosen;
}

VolumeGrid stored_grid(const VolumeGrid& grid, double x0, double y0, const StoredCells& cells)
{
  return grid_of(grid, taken_of(grid, x0, y0, cells));
}

} // namespace brinell::io
