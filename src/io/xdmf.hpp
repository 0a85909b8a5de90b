// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <string>
#include <vector>

namespace brinell::io
{

/// A grid of fields in result.h5, as XDMF describes it; a surface has nz = 0.
struct XdmfGrid
{
  std::string name;
  std::string group; ///< inside result.h5
  VolumeGrid cells;
  double x0 = 0.0, y0 = 0.0; ///< centre of cell (0, 0) [m]
  struct Field
  {
    std::string name;    ///< shown to the user
    std::string dataset; ///< in the group
  };
  std::vector<Field> fields{};
};

/// The grids of one moment.
struct XdmfTime
{
  double time = 0.0;
  std::vector<XdmfGrid> grids;
};

[[nodiscard]] XdmfGrid contact_grid(const simulation::Snapshot& snapshot, const std::string& group);
/// Volume and surface of a body; without a grid that carries no field.
[[nodiscard]] std::vector<XdmfGrid> body_grids(const simulation::BodySnapshot& body, const std::string& group);

/// The text of an .xdmf file beside the HDF5 file of that name.
[[nodiscard]] std::string xdmf_text(const std::string& h5_file, const std::vector<XdmfTime>& times);

} // namespace brinell::io
