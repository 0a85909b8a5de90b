// SPDX-License-Identifier: BSD-3-Clause
#include "result_fields.hpp"

#include "brinell/foundation/sym_tensor.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace brinell::io
{

namespace
{

constexpr std::array components{"xx", "yy", "zz", "yz", "xz", "xy"};

using TensorField = std::array<std::vector<double>, 6>;

/// Bodies that stay elastic may leave fields empty; then there is no dataset.
bool is_stored(const std::vector<double>& field)
{
  return !field.empty();
}
bool is_stored(const TensorField& field)
{
  return std::all_of(field.begin(), field.end(), [](const auto& f) { return is_stored(f); });
}

void write_tensor(const h5::Handle& parent, const char* name, const TensorField& field,
                  std::span<const std::size_t> shape, std::string_view units, std::string_view long_name,
                  h5::Storage storage)
{
  if (!is_stored(field))
    return;
  const h5::Handle group = h5::create_group(parent, name);
  for (std::size_t c = 0; c < components.size(); ++c)
    h5::write_dataset(group, components[c], field[c], shape, units, fmt::format("{}, {}", long_name, components[c]),
                      storage);
}

std::vector<double> von_mises_field(const TensorField& stress)
{
  const std::size_t size = stress[0].size();
  std::vector<double> result(size);
#pragma omp parallel for
  for (std::size_t i = 0; i < size; ++i)
    result[i] =
        von_mises(SymTensor{stress[0][i], stress[1][i], stress[2][i], stress[3][i], stress[4][i], stress[5][i]});
  return result;
}

void write_contact(const h5::Handle& parent, const simulation::Snapshot& snapshot)
{
  const h5::Handle group = h5::create_group(parent, "contact");
  const SurfaceGrid& grid = snapshot.contact;
  h5::write_attribute(group, "spacing", std::array{grid.dx, grid.dy});
  h5::write_attribute(group, "origin", std::array{snapshot.x0, snapshot.y0});
  const std::array shape{static_cast<std::size_t>(grid.ny), static_cast<std::size_t>(grid.nx)};
  h5::write_dataset(group, "pressure", snapshot.pressure, shape, "Pa", "contact pressure, compression positive");
  h5::write_dataset(group, "gap", snapshot.gap, shape, "m", "gap between the deformed surfaces");
}

void write_body(const h5::Handle& parent, const char* name, const simulation::BodySnapshot& body)
{
  const h5::Handle group = h5::create_group(parent, name);
  const VolumeGrid& grid = body.grid;
  const std::array spacing{grid.surface.dx, grid.surface.dy, grid.dz};
  const std::array origin{body.x0, body.y0, 0.5 * grid.dz};
  h5::write_attribute(group, "spacing", spacing);
  h5::write_attribute(group, "origin", origin);
  h5::write_attribute(group, "contact_x", body.contact_x);
  const std::array volume{static_cast<std::size_t>(grid.nz), static_cast<std::size_t>(grid.surface.ny),
                          static_cast<std::size_t>(grid.surface.nx)};
  const std::span surface = std::span(volume).subspan(1);
  if (is_stored(body.residual_displacement))
    h5::write_dataset(group, "residual_displacement", body.residual_displacement, surface, "m",
                      "residual displacement of the surface, into the body");
  if (is_stored(body.equivalent_plastic_strain))
    h5::write_dataset(group, "equivalent_plastic_strain", body.equivalent_plastic_strain, volume, "1",
                      "accumulated equivalent plastic strain");
  write_tensor(group, "plastic_strain", body.plastic_strain, volume, "1", "plastic strain", h5::Storage::deflated);
  write_tensor(group, "stress", body.stress, volume, "Pa",
               "stress of contact, plastic strain and before the first load, tension positive", h5::Storage::plain);
  if (is_stored(body.stress))
    h5::write_dataset(group, "von_mises_stress", von_mises_field(body.stress), volume, "Pa", "von Mises stress",
                      h5::Storage::plain);
}

} // namespace

void write_snapshot(const h5::Handle& group, const std::vector<NamedNumber>& columns,
                    const simulation::Snapshot& snapshot)
{
  for (const NamedNumber& column : columns)
    std::visit([&](auto number) { h5::write_attribute(group, std::string(column.name).c_str(), number); },
               column.value);
  write_contact(group, snapshot);
  write_body(group, "lower", snapshot.lower);
  write_body(group, "upper", snapshot.upper);
}

} // namespace brinell::io
