// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/history_csv.hpp"
#include "brinell/io/output_choice.hpp"
#include "brinell/simulation/scenario.hpp"
#include "hdf5.hpp"

#include <vector>

/// Writing of the fields of one state: docs/reference/results-format.md.
namespace brinell::io
{

/// Where the file is written; in memory, nothing is compressed.
enum class Place
{
  disk,
  memory
};

[[nodiscard]] inline h5::Storage storage_of(Place place, h5::Storage on_disk)
{
  return place == Place::memory ? h5::Storage::contiguous : on_disk;
}

/// Where a state is written, and how its fields are stored.
struct Form
{
  Place place = Place::disk;
  Precision precision = Precision::double_precision;

  [[nodiscard]] h5::Storage storage(h5::Storage on_disk) const { return storage_of(place, on_disk); }
};

/// Writes the fields of a step, and its row of the history as attributes.
/// @throws IoError; InternalError if a field does not fit its grid
void write_state(const h5::Handle& group, const std::vector<NamedNumber>& columns, const simulation::StepFields& fields,
                 const Form& form);

} // namespace brinell::io
