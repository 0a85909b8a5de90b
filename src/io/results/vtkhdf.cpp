// SPDX-License-Identifier: BSD-3-Clause
#include "vtkhdf.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <optional>
#include <utility>

namespace brinell::io
{

namespace
{

using Counts = std::vector<hsize_t>;
using Body = BodyLayout StateLayout::*;

/// Components of a symmetric tensor in the order of VTK.
constexpr std::array vtk_components{"xx", "yy", "zz", "xy", "yz", "xz"};

/// Number of cells, slowest index first.
Counts counts(const VolumeGrid& grid)
{
  return {static_cast<hsize_t>(grid.nz), static_cast<hsize_t>(grid.surface.ny), static_cast<hsize_t>(grid.surface.nx)};
}

Counts counts(const SurfaceGrid& grid)
{
  return {static_cast<hsize_t>(grid.ny), static_cast<hsize_t>(grid.nx)};
}

h5::Box whole(const Counts& shape)
{
  return {Counts(shape.size(), 0), shape};
}

/// Number of layers, rows and columns of the grid of `all` before those of the grid of `state`.
std::array<long, 3> offset(const BodyLayout& all, const BodyLayout& state)
{
  const SurfaceGrid& s = all.grid.surface;
  return {std::lround((state.top - all.top) / all.grid.dz), std::lround((state.y0 - all.y0) / s.dy),
          std::lround((state.x0 - all.x0) / s.dx)};
}

/// The box that the cells of a state occupy in the grid of `all`: a plane, or a volume. None if they lie beside it: of a region
/// beyond a grid that had not grown yet, the nearest cells were stored.
std::optional<h5::Box> place_of(const Counts& shape, const BodyLayout& all, const BodyLayout& state)
{
  h5::Box box = whole(shape);
  const std::array<long, 3> first = offset(all, state);
  const std::array counts_of_all{all.grid.nz, all.grid.surface.ny, all.grid.surface.nx};
  for (std::size_t axis = 3 - shape.size(), i = 0; axis < 3; ++axis, ++i)
  {
    if (first[axis] < 0 || first[axis] + static_cast<long>(shape[i]) > counts_of_all[axis])
      return std::nullopt;
    box.start[i] = static_cast<hsize_t>(first[axis]);
  }
  return box;
}

/// A VTK image with all states along a time axis. A single state has no time axis, because VTK would treat it as a space axis.
class Block
{
public:
  /// @param body  group, in a state, of the body whose fields are shown
  Block(const h5::Handle& parent, const char* name, std::string body, int index, const std::vector<StoredState>& states)
      : body_(std::move(body)), states_(states), group_(h5::create_ordered_group(parent, name))
  {
    h5::write_attribute(group_, "Version", std::array{2, 2});
    h5::write_fixed_attribute(group_, "Type", "ImageData");
    h5::write_attribute(group_, "Index", index);
    if (states.size() > 1)
      write_steps(h5::create_group(group_, "Steps"));
  }

  /// @param up  direction of increasing layer index: 1 up, -1 down
  void place(const std::array<int, 3>& last, const std::array<double, 3>& origin, const std::array<double, 3>& spacing,
             double up = 1.0)
  {
    h5::write_attribute(group_, "Direction", std::array{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, up});
    h5::write_attribute(group_, "WholeExtent", std::array{0, last[0], 0, last[1], 0, last[2]});
    h5::write_attribute(group_, "Origin", origin);
    h5::write_attribute(group_, "Spacing", spacing);
  }

  /// @param data  "CellData" or "PointData"
  void begin(const char* data) { data_.emplace(h5::create_group(group_, data)); }

  /// Function that returns the parts of an array for one state; they refer to datasets in its group.
  using Parts = std::function<std::vector<h5::VirtualPart>(const StateLayout&)>;

  /// A surface of one row loses the axis of the rows: VTK reads an image of points along one axis from arrays of one axis.
  void add(const char* name, const Counts& shape, double fill, const Parts& parts_of)
  {
    const bool is_one_row = shape.size() == 2 && shape[0] == 1;
    std::vector<h5::VirtualPart> parts;
    for (std::size_t step = 0; step < states_.size(); ++step)
      for (h5::VirtualPart& part : parts_of(states_[step].layout))
      {
        if (is_one_row)
          part.target = {{part.target.start[1]}, {part.target.count[1]}};
        parts.push_back({at(part.target, step), states_[step].file, states_[step].group + "/" + part.dataset,
                         std::move(part.shape), std::move(part.source)});
      }
    Counts all = is_one_row ? Counts{shape[1]} : shape;
    if (states_.size() > 1)
      all.insert(all.begin(), states_.size());
    h5::write_virtual_dataset(*data_, name, all, fill, parts,
                              states_.back().layout.is_single ? Precision::single : Precision::double_precision);
  }

  enum class Kind
  {
    of_surface,
    of_volume,
    tensor
  };
  /// Adds a field of a body. The image has the grid of the last state; grids of earlier states may be smaller.
  /// @param beyond    value outside a smaller grid
  /// @param is_there  whether a state has the field
  void add_field(const char* name, Kind kind, Body body, double beyond,
                 const std::function<bool(const BodyLayout&)>& is_there)
  {
    const BodyLayout& all = states_.back().layout.*body;
    const bool in_all =
        std::ranges::all_of(states_, [&](const StoredState& state) { return is_there(state.layout.*body); });
    const std::size_t count = kind == Kind::tensor ? vtk_components.size() : 1;
    const auto shape_of = [&](const BodyLayout& b)
    { return kind == Kind::of_surface ? counts(b.grid.surface) : counts(b.grid); };
    const auto parts_of = [&](const StateLayout& layout)
    {
      if (!is_there(layout.*body))
        return std::vector<h5::VirtualPart>{};
      const Counts shape = shape_of(layout.*body);
      const std::optional<h5::Box> place = place_of(shape, all, layout.*body);
      if (!place)
        return std::vector<h5::VirtualPart>{};
      std::vector<h5::VirtualPart> parts(count, {*place, "", fmt::format("{}/{}", body_, name), shape, whole(shape)});
      for (hsize_t c = 0; count > 1 && c < count; ++c)
      {
        parts[c].dataset += fmt::format("/{}", vtk_components[c]);
        parts[c].target.start.push_back(c);
        parts[c].target.count.push_back(1);
      }
      return parts;
    };
    Counts shape = shape_of(all);
    if (count > 1)
      shape.push_back(count);
    add(name, shape, in_all ? beyond : unknown, parts_of);
  }

  /// Makes this group the group Steps of /VTKHDF: VTK 9.7 recognises the time axis of a composite only if /VTKHDF itself has such
  /// a group. But readers also treat each group of /VTKHDF as a block, so this one is an empty image that has the times.
  void imitate_steps()
  {
    place({-1, -1, -1}, {0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
    write_steps(group_);
  }

private:
  void write_steps(const h5::Handle& group) const
  {
    std::vector<double> times;
    for (const StoredState& state : states_)
      times.push_back(state.time);
    h5::write_attribute(group, "NSteps", static_cast<int>(times.size()));
    h5::write_numbers(group, "Values", times);
  }

  [[nodiscard]] h5::Box at(h5::Box box, std::size_t step) const
  {
    if (states_.size() > 1)
    {
      box.start.insert(box.start.begin(), step);
      box.count.insert(box.count.begin(), 1);
    }
    return box;
  }

  std::string body_;
  const std::vector<StoredState>& states_;
  h5::Handle group_;
  std::optional<h5::Handle> data_;
};

/// @param up  direction into the body: 1 up, -1 down. The layers of a dataset go from the surface into the body, and a virtual
///            dataset cannot reverse their order, so the axis is reversed instead.
void write_volume(Block block, Body which, const BodyLayout& body, double up)
{
  const SurfaceGrid& s = body.grid.surface;
  block.place({s.nx, s.ny, body.grid.nz}, {body.x0 - 0.5 * s.dx, body.y0 - 0.5 * s.dy, up * body.top},
              {s.dx, s.dy, body.grid.dz}, up);
  block.begin("CellData");
  const auto add = [&](const char* name, Block::Kind kind, bool BodyLayout::*is_there, double beyond)
  {
    if (body.*is_there)
      block.add_field(name, kind, which, beyond, std::mem_fn(is_there));
  };
  add("equivalent_plastic_strain", Block::Kind::of_volume, &BodyLayout::has_equivalent, 0.0);
  add("plastic_strain", Block::Kind::tensor, &BodyLayout::has_plastic_strain, 0.0);
  add("von_mises_stress", Block::Kind::of_volume, &BodyLayout::has_von_mises, unknown);
  add("stress", Block::Kind::tensor, &BodyLayout::has_stress, unknown);
  add("temperature", Block::Kind::of_volume, &BodyLayout::has_temperature, unknown);
  add("inclusion", Block::Kind::of_volume, &BodyLayout::has_inclusion, 0.0);
  for (int n = 0; n < body.fatigue; ++n)
    block.add_field(simulation::fatigue_fields[static_cast<std::size_t>(n)].name.data(), Block::Kind::of_volume, which,
                    unknown, [n](const BodyLayout& layout) { return n < layout.fatigue; });
}

/// The cells of the contact that lie on the lower body's grid, as parts of the grid of `all`; none if the grids do not overlap.
/// Two parts where a period goes round.
std::vector<h5::VirtualPart> contact_parts(const char* name, const StateLayout& layout, const BodyLayout& all)
{
  const ContactLayout& c = layout.contact;
  const SurfaceGrid& lower = layout.lower.grid.surface;
  const auto place = place_of(counts(lower), all, layout.lower);
  if (!place)
    return {};
  const hsize_t row_of_lower = place->start[0], column_of_lower = place->start[1];
  const Counts shape{static_cast<hsize_t>(c.ny), static_cast<hsize_t>(c.nx)};
  std::vector<h5::VirtualPart> parts;
  const auto add = [&](int column)
  {
    const int first_row = std::max(c.row, 0), last_row = std::min(c.row + c.ny, lower.ny);
    const int first_column = std::max(column, 0), last_column = std::min(column + c.nx, lower.nx);
    if (first_row >= last_row || first_column >= last_column)
      return;
    const Counts count{static_cast<hsize_t>(last_row - first_row), static_cast<hsize_t>(last_column - first_column)};
    const Counts target{row_of_lower + static_cast<hsize_t>(first_row),
                        column_of_lower + static_cast<hsize_t>(first_column)};
    const Counts source{static_cast<hsize_t>(first_row - c.row), static_cast<hsize_t>(first_column - column)};
    parts.push_back({{target, count}, "", fmt::format("contact/{}", name), shape, {source, count}});
  };
  if (!c.goes_round)
  {
    add(c.column);
    return parts;
  }
  const int column = (c.column % c.nx + c.nx) % c.nx;
  add(column);
  add(column - c.nx);
  return parts;
}

/// Writes a surface as points at the centres of the cells, so that ParaView can warp it by its values.
/// @param contact  layout of the contact fields that are shown on this surface; nullptr: none
void write_surface(Block block, Body which, const BodyLayout& body, const ContactLayout* contact)
{
  const SurfaceGrid& s = body.grid.surface;
  block.place({s.nx - 1, s.ny - 1, 0}, {body.x0, body.y0, 0.0}, {s.dx, s.dy, body.grid.dz});
  block.begin("PointData");
  body.surface.for_each(
      [&](const SurfaceField& field)
      {
        block.add_field(field.name, Block::Kind::of_surface, which, field.elsewhere,
                        [&](const BodyLayout& layout) { return layout.surface.has(field.name); });
      });
  if (contact != nullptr)
    contact->fields.for_each(
        [&](const SurfaceField& field)
        {
          block.add(field.name, counts(s), field.elsewhere,
                    [&](const StateLayout& layout)
                    {
                      return layout.contact.fields.has(field.name) ? contact_parts(field.name, layout, body)
                                                                   : std::vector<h5::VirtualPart>{};
                    });
        });
}

BodyLayout layout_of(const simulation::BodySnapshot& body, const simulation::StepFields::Within& within)
{
  return {.grid = body.grid,
          .x0 = body.x0,
          .y0 = body.y0,
          .top = body.top,
          .surface = FieldsThere(body),
          .has_equivalent = static_cast<bool>(within.equivalent_plastic_strain),
          .has_plastic_strain = static_cast<bool>(within.plastic_strain),
          .has_stress = within.stress && within.keeps_stress,
          .has_von_mises = within.stress && within.keeps_von_mises,
          .has_temperature = static_cast<bool>(within.temperature),
          .has_inclusion = static_cast<bool>(within.inclusion),
          .fatigue = static_cast<int>(within.fatigue.size())};
}

} // namespace

void BodyLayout::exchange(Archive& archive)
{
  archive("nx", grid.surface.nx);
  archive("ny", grid.surface.ny);
  archive("nz", grid.nz);
  archive("dx", grid.surface.dx);
  archive("dy", grid.surface.dy);
  archive("dz", grid.dz);
  archive("x0", x0);
  archive("y0", y0);
  archive("top", top);
  archive("surface", surface);
  archive("has_equivalent", has_equivalent);
  archive("has_plastic_strain", has_plastic_strain);
  archive("has_stress", has_stress);
  archive("has_von_mises", has_von_mises);
  archive("has_temperature", has_temperature);
  archive("has_inclusion", has_inclusion);
  archive("fatigue", fatigue, 0, static_cast<int>(simulation::fatigue_fields.size()));
}

void ContactLayout::exchange(Archive& archive)
{
  archive("nx", nx);
  archive("ny", ny);
  archive("column", column);
  archive("row", row);
  archive("goes_round", goes_round);
  archive("fields", fields);
}

void StateLayout::exchange(Archive& archive)
{
  archive("lower", lower);
  archive("upper", upper);
  archive("contact", contact);
  archive("is_single", is_single);
}

StateLayout layout_of(const simulation::StepFields& fields, Precision precision)
{
  const simulation::Snapshot& snapshot = fields.surfaces;
  const simulation::BodySnapshot& lower = snapshot.lower;
  const SurfaceGrid& grid = snapshot.contact;
  FieldsThere contact(snapshot);
  constexpr std::size_t shear_x = 2, shear_y = 3; // in surface_fields
  contact[shear_y] = contact[shear_x];            // a component that never acts is shown as zero
  const double x = snapshot.x0 + lower.contact_x - lower.x0, y = snapshot.y0 - lower.y0;
  return {.lower = layout_of(lower, fields.lower),
          .upper = layout_of(snapshot.upper, fields.upper),
          .contact = {.nx = grid.nx,
                      .ny = grid.ny,
                      .column = static_cast<int>(std::lround(x / grid.dx)),
                      .row = static_cast<int>(std::lround(y / grid.dy)),
                      .goes_round = grid.is_periodic_x(),
                      .fields = contact},
          .is_single = precision == Precision::single};
}

void write_vtkhdf(const h5::Handle& file, const std::vector<StoredState>& states)
{
  if (states.empty())
    return;
  const h5::Handle root = h5::create_ordered_group(file, "VTKHDF");
  h5::write_attribute(root, "Version", std::array{2, 2});
  h5::write_fixed_attribute(root, "Type", "PartitionedDataSetCollection");
  const h5::Handle assembly = h5::create_ordered_group(root, "Assembly");
  int count = 0;
  const auto block = [&](const char* name, const char* body)
  {
    const h5::Handle node = h5::create_ordered_group(assembly, name);
    h5::link_soft(node, name, fmt::format("/VTKHDF/{}", name));
    return Block(root, name, body, count++, states);
  };
  const auto& [lower, upper, contact, is_single] = states.back().layout;
  const auto has_volume = [](const BodyLayout& body)
  {
    return body.has_equivalent || body.has_plastic_strain || body.has_stress || body.has_von_mises ||
           body.has_temperature || body.fatigue > 0;
  };
  if (has_volume(lower))
    write_volume(block("lower_volume", "lower"), &StateLayout::lower, lower, -1.0);
  if (has_volume(upper))
    write_volume(block("upper_volume", "upper"), &StateLayout::upper, upper, 1.0);
  write_surface(block("lower_surface", "lower"), &StateLayout::lower, lower, &contact);
  if (upper.surface.any())
    write_surface(block("upper_surface", "upper"), &StateLayout::upper, upper, nullptr);
  if (states.size() > 1)
    Block(root, "Steps", "", count, states).imitate_steps();
}

} // namespace brinell::io
