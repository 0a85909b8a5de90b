// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"
#include "brinell/simulation/scenario.hpp"
#include "hdf5.hpp"
#include "surface_fields.hpp"

#include <string>
#include <vector>

/// The group /VTKHDF, with which ParaView opens a result file. It refers to the fields of the stored states without storing them
/// again.
namespace brinell::io
{

/// Grid of a body's fields, and which fields exist.
struct BodyLayout
{
  VolumeGrid grid;
  double x0 = 0.0, y0 = 0.0; ///< centre of cell (0, 0) [m]
  double top = 0.0;          ///< depth of the upper side of layer 0 [m]
  FieldsThere<simulation::BodySnapshot> surface;
  bool has_equivalent = false, has_plastic_strain = false, has_stress = false, has_von_mises = false,
       has_temperature = false, has_inclusion = false;
  int fatigue = 0; ///< number of `simulation::fatigue_fields` that exist, from the first one

  void exchange(Archive& archive);
};

/// The contact grid, whose cells coincide with cells of the lower body's surface.
struct ContactLayout
{
  int nx = 0, ny = 0;
  int column = 0, row = 0; ///< indices, in the lower body's grid, of the first column and row of the contact
  bool goes_round = false; ///< the lower body's grid is a period along x with as many columns
  FieldsThere<simulation::Snapshot> fields;

  void exchange(Archive& archive);
};

struct StateLayout
{
  BodyLayout lower, upper;
  ContactLayout contact;
  bool is_single = false; ///< the fields are stored in single precision

  void exchange(Archive& archive);
};

[[nodiscard]] StateLayout layout_of(const simulation::StepFields& fields,
                                    Precision precision = Precision::double_precision);

/// A state in a result file.
struct StoredState
{
  double time;
  std::string file;  ///< relative to the folder of the result; "." is the result file itself
  std::string group; ///< in that file
  StateLayout layout;
};

/// Writes /VTKHDF, docs/reference/results-format.md.
/// @param states  ascending in time, on grids that may have grown; nothing is written if there are none.
/// @throws IoError
void write_vtkhdf(const h5::Handle& file, const std::vector<StoredState>& states);

} // namespace brinell::io
