// SPDX-License-Identifier: BSD-3-Clause
#include "stored_state.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/sym_tensor.hpp"
#include "brinell/io/result_directory.hpp"
#include "stored_parts.hpp"
#include "surface_fields.hpp"

#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <optional>

namespace brinell::io
{

using simulation::StepFields;

namespace
{

constexpr std::array components{"xx", "yy", "zz", "yz", "xz", "xy"};

/// Writes those fields on a surface that exist; fields of bodies that stay elastic may be empty.
void write_fields(const h5::Handle& group, std::span<const simulation::FieldOf<const std::vector<double>>> fields,
                  std::span<const std::size_t> shape, const Form& form)
{
  for (const auto& field : fields)
    if (!field.values->empty())
      h5::write_dataset(group, field.name, *field.values, shape, field.unit, field.text,
                        form.storage(h5::Storage::deflated), form.precision);
}

void write_contact(const h5::Handle& parent, const simulation::Snapshot& snapshot, const Form& form)
{
  const h5::Handle group = h5::create_group(parent, "contact");
  const SurfaceGrid& grid = snapshot.contact;
  h5::write_attribute(group, "spacing", std::array{grid.dx, grid.dy});
  h5::write_attribute(group, "origin", std::array{snapshot.x0, snapshot.y0});
  write_fields(group, surface_fields(snapshot),
               std::array{static_cast<std::size_t>(grid.ny), static_cast<std::size_t>(grid.nx)}, form);
}

/// Fields within a body that are stored together.
struct Stored
{
  const char* name; ///< of the field, or of the group of the components of a tensor
  const LayeredFields& fields;
  std::string_view unit, text;
  h5::Storage storage;
};
using UseStored = std::function<void(const Stored&)>;

/// The fields within a body one after the other, so that only one tensor at a time is in memory.
void for_fields_within(const StepFields::Within& within, const UseStored& use)
{
  using enum h5::Storage;
  if (within.equivalent_plastic_strain)
    use({"equivalent_plastic_strain", within.equivalent_plastic_strain(), "1", "accumulated equivalent plastic strain",
         deflated});
  if (within.inclusion)
    use({"inclusion", within.inclusion(), "1", "number of the inclusion in the order of the case, 0: none", deflated});
  if (within.temperature)
    use({"temperature", within.temperature(), "degC", "temperature", deflated});
  if (within.plastic_strain)
    use({"plastic_strain", within.plastic_strain(), "1", "plastic strain", deflated});
  if (!within.stress)
    return;
  const LayeredFields stress = within.stress();
  if (within.keeps_stress)
    use({"stress", stress, "Pa", "stress of contact, plastic strain, heat and before the first load, tension positive",
         plain});
  const auto von_mises_at = [&](std::size_t cell)
  {
    SymTensor tensor;
    for (std::size_t c = 0; c < tensor.size(); ++c)
      tensor[c] = stress.own(c)[cell];
    return von_mises(tensor);
  };
  if (within.keeps_von_mises)
    use({"von_mises_stress", stress.combined(von_mises_at), "Pa", "von Mises stress", plain});
}

/// The fields of fatigue, which a twin has of its own.
void for_fatigue(const StepFields::Within& within, const UseStored& use)
{
  for (std::size_t n = 0; n < within.fatigue.size(); ++n)
  {
    const simulation::FatigueField& field = simulation::fatigue_fields[n];
    use({field.name.data(), within.fatigue[n](), field.unit, field.text, h5::Storage::deflated});
  }
}

/// @param volume  cells of the body, [z][y][x]
void write_stored(const h5::Handle& group, const Stored& stored, const std::array<std::size_t, 3>& volume,
                  const Form& form)
{
  if (stored.fields.shape() != volume)
    throw InternalError(fmt::format("field {} has {} cells on a grid of {}", stored.name,
                                    fmt::join(stored.fields.shape(), " x "), fmt::join(volume, " x ")));
  std::vector<const char*> names{stored.name};
  std::vector<std::string> texts{std::string(stored.text)};
  if (stored.fields.count() > 1)
  {
    names.assign(components.begin(), components.end());
    texts.clear();
    for (const char* component : components)
      texts.push_back(fmt::format("{}, {}", stored.text, component));
  }
  std::optional<h5::Handle> tensor;
  if (stored.fields.count() > 1)
    tensor = h5::create_group(group, stored.name);
  h5::write_fields(tensor ? *tensor : group, stored.fields, names, texts, stored.unit, form.storage(stored.storage),
                   form.precision);
}

/// Takes part in what the first of several ranks does to write fields.
void follow_stored(const Stored& stored)
{
  for (std::size_t field = 0; field < stored.fields.count(); ++field)
    for (const Slab& slab : h5::slabs(stored.fields.shape()))
      static_cast<void>(stored.fields.part(field, slab));
}

/// Copies the fields within a body from the group of a body with the same fields, so that they are neither computed nor
/// compressed again.
void copy_within(const h5::Handle& alike, const h5::Handle& group)
{
  for (const char* name : {"equivalent_plastic_strain", "temperature", "plastic_strain", "stress", "von_mises_stress"})
    if (h5::has_member(alike, name))
      h5::copy_object(alike, name, group, name);
}

/// @param alike  group of a body with the same fields within; nullptr: there is none
h5::Handle write_body(const h5::Handle& parent, const char* name, const simulation::BodySnapshot& body,
                      const StepFields::Within& within, const Form& form, const h5::Handle* alike)
{
  h5::Handle group = h5::create_group(parent, name);
  const VolumeGrid& grid = body.grid;
  const std::array spacing{grid.surface.dx, grid.surface.dy, grid.dz};
  const std::array origin{body.x0, body.y0, body.top + 0.5 * grid.dz};
  h5::write_attribute(group, "spacing", spacing);
  h5::write_attribute(group, "origin", origin);
  h5::write_attribute(group, "cells", std::array{grid.surface.nx, grid.surface.ny, grid.nz});
  h5::write_attribute(group, "contact_x", body.contact_x);
  h5::write_attribute(group, "is_rigid", body.is_rigid ? 1 : 0);
  const std::array volume{static_cast<std::size_t>(grid.nz), static_cast<std::size_t>(grid.surface.ny),
                          static_cast<std::size_t>(grid.surface.nx)};
  write_fields(group, surface_fields(body), std::span(volume).subspan(1), form);
  const auto write = [&](const Stored& stored) { write_stored(group, stored, volume, form); };
  if (alike != nullptr)
    copy_within(*alike, group);
  else
    for_fields_within(within, write);
  for_fatigue(within, write);
  return group;
}

} // namespace

void write_state(const h5::Handle& group, const std::vector<NamedNumber>& columns, const StepFields& fields,
                 const Form& form)
{
  for (const NamedNumber& column : columns)
    std::visit([&](auto number) { h5::write_attribute(group, std::string(column.name).c_str(), number); },
               column.value);
  write_contact(group, fields.surfaces, form);
  const h5::Handle lower = write_body(group, "lower", fields.surfaces.lower, fields.lower, form, nullptr);
  (void)write_body(group, "upper", fields.surfaces.upper, fields.upper, form, fields.are_alike ? &lower : nullptr);
}

void compute_fields(const StepFields& fields, const std::vector<std::string>& words, const StoredParts& parts)
{
  const StepFields chosen = chosen_fields(fields, words, parts);
  for_fields_within(chosen.lower, follow_stored);
  if (!chosen.are_alike)
    for_fields_within(chosen.upper, follow_stored);
}

} // namespace brinell::io
