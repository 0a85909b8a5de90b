// SPDX-License-Identifier: BSD-3-Clause
#include "xdmf.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace brinell::io
{

namespace
{

constexpr std::array components{"xx", "yy", "zz", "yz", "xz", "xy"};

void add_tensor(std::vector<XdmfGrid::Field>& fields, const std::array<std::vector<double>, 6>& values,
                const std::string& name)
{
  if (std::any_of(values.begin(), values.end(), [](const auto& v) { return v.empty(); }))
    return;
  for (const char* component : components)
    fields.push_back({fmt::format("{}_{}", name, component), fmt::format("{}/{}", name, component)});
}

/// Topology, geometry and where the values sit.
struct Frame
{
  int nz, ny, nx;    ///< points
  double z0, y0, x0; ///< first point [m]
  double dz;         ///< [m]
  const char* center;
  std::string dims; ///< of the values
};

/// A surface is one layer of points in the cells' centres: readers put 2D image grids into the plane y-z, cell values of a
/// layer without thickness they cannot read, and points can be warped by their values.
Frame frame(const XdmfGrid& grid)
{
  const SurfaceGrid& s = grid.cells.surface;
  if (grid.cells.nz == 0)
    return {1, s.ny, s.nx, 0.0, grid.y0, grid.x0, s.dx, "Node", fmt::format("1 {} {}", s.ny, s.nx)};
  const int nz = grid.cells.nz;
  return {nz + 1,
          s.ny + 1,
          s.nx + 1,
          0.0,
          grid.y0 - 0.5 * s.dy,
          grid.x0 - 0.5 * s.dx,
          grid.cells.dz,
          "Cell",
          fmt::format("{} {} {}", nz, s.ny, s.nx)};
}

std::string grid_text(const XdmfGrid& grid, const std::string& h5_file, const std::string& indent)
{
  const SurfaceGrid& surface = grid.cells.surface;
  const Frame f = frame(grid);
  std::string text = fmt::format("{0}<Grid Name=\"{1}\" GridType=\"Uniform\">\n"
                                 "{0}  <Topology TopologyType=\"3DCoRectMesh\" Dimensions=\"{2} {3} {4}\"/>\n"
                                 "{0}  <Geometry GeometryType=\"ORIGIN_DXDYDZ\">\n"
                                 "{0}    <DataItem Dimensions=\"3\" Format=\"XML\">{5} {6} {7}</DataItem>\n"
                                 "{0}    <DataItem Dimensions=\"3\" Format=\"XML\">{8} {9} {10}</DataItem>\n"
                                 "{0}  </Geometry>\n",
                                 indent, grid.name, f.nz, f.ny, f.nx, f.z0, f.y0, f.x0, f.dz, surface.dy, surface.dx);
  for (const auto& field : grid.fields)
    text += fmt::format("{0}  <Attribute Name=\"{1}\" AttributeType=\"Scalar\" Center=\"{2}\">\n"
                        "{0}    <DataItem Dimensions=\"{3}\" NumberType=\"Float\" Precision=\"8\" "
                        "Format=\"HDF\">{4}:{5}/{6}</DataItem>\n"
                        "{0}  </Attribute>\n",
                        indent, field.name, f.center, f.dims, h5_file, grid.group, field.dataset);
  return text + fmt::format("{}</Grid>\n", indent);
}

/// `time` goes with the grid, or with the collection of several.
std::string moment_text(const XdmfTime& moment, const std::string& h5_file)
{
  const std::string time = fmt::format("<Time Value=\"{}\"/>\n", moment.time);
  if (moment.grids.size() == 1)
  {
    std::string text = grid_text(moment.grids.front(), h5_file, "      ");
    return text.insert(text.find('\n') + 1, "        " + time);
  }
  std::string text =
      fmt::format("      <Grid Name=\"step\" GridType=\"Collection\" CollectionType=\"Spatial\">\n        {}", time);
  for (const XdmfGrid& grid : moment.grids)
    text += grid_text(grid, h5_file, "        ");
  return text + "      </Grid>\n";
}

} // namespace

XdmfGrid contact_grid(const simulation::Snapshot& snapshot, const std::string& group)
{
  return {.name = "contact",
          .group = group,
          .cells = {snapshot.contact, 0, 0.0},
          .x0 = snapshot.x0,
          .y0 = snapshot.y0,
          .fields = {{"pressure", "pressure"}, {"gap", "gap"}}};
}

std::vector<XdmfGrid> body_grids(const simulation::BodySnapshot& body, const std::string& group)
{
  std::vector<XdmfGrid> grids;
  XdmfGrid volume{.name = "volume", .group = group, .cells = body.grid, .x0 = body.x0, .y0 = body.y0};
  if (!body.equivalent_plastic_strain.empty())
    volume.fields.push_back({"equivalent_plastic_strain", "equivalent_plastic_strain"});
  if (!body.stress[0].empty())
    volume.fields.push_back({"von_mises_stress", "von_mises_stress"});
  add_tensor(volume.fields, body.plastic_strain, "plastic_strain");
  add_tensor(volume.fields, body.stress, "stress");
  if (!volume.fields.empty())
    grids.push_back(volume);
  if (!body.residual_displacement.empty())
    grids.push_back({.name = "surface",
                     .group = group,
                     .cells = {body.grid.surface, 0, 0.0},
                     .x0 = body.x0,
                     .y0 = body.y0,
                     .fields = {{"residual_displacement", "residual_displacement"}}});
  return grids;
}

std::string xdmf_text(const std::string& h5_file, const std::vector<XdmfTime>& times)
{
  std::string text = "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n  <Domain>\n"
                     "    <Grid Name=\"steps\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (const XdmfTime& moment : times)
    if (!moment.grids.empty())
      text += moment_text(moment, h5_file);
  return text + "    </Grid>\n  </Domain>\n</Xdmf>\n";
}

} // namespace brinell::io
