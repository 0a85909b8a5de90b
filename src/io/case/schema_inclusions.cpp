// SPDX-License-Identifier: BSD-3-Clause
#include "schema_parts.hpp"

/// Keys of the inclusions of a body.
namespace brinell::io
{

namespace
{

using Entries = std::vector<Entry>;

/// Keys of the region that an inclusion fills.
Entries region_entries(const std::string& table)
{
  const std::string type = table + "type";
  const Condition any{type, {"ellipsoid", "cuboid", "cylinder", "cluster", "voxels"}}, cluster{type, {"cluster"}},
      voxels{type, {"voxels"}};
  return joined(
      {in_table(
           table, any,
           {
               {.key = "x",
                .of = kind::length,
                .fallback = 0.0,
                .text = "Position of the centre on the body's surface along x."},
               {.key = "y",
                .of = kind::length,
                .fallback = 0.0,
                .text = "Position of the centre on the body's surface along y."},
               {.key = "depth",
                .of = kind::length.at_least(0.0),
                .required = true,
                .text = "Depth of the centre. An inclusion that reaches above the surface ends there."},
               {.key = "size",
                .of = kind::length.list().above(0.0),
                .required = true,
                .text = "Sizes along x, y and z, twice the semi-axes of an ellipsoid; one length holds along all axes. "
                        "Of a cluster those of the box in which the balls lie, of voxels the edge of one voxel.",
                .when = any},
               {.key = "axis",
                .choices = {"x", "y", "z"},
                .fallback = "z",
                .text = "Axis of the cylinder, whose cross-section is an ellipse.",
                .when = {type, {"cylinder"}}},
           }),
       in_table(
           table, cluster,
           {
               {.key = "count", .of = kind::integer.between(1, 100000), .required = true, .text = "Number of balls."},
               {.key = "diameter",
                .of = kind::length.list().above(0.0),
                .required = true,
                .text = "Smallest and largest diameter of the balls, which are uniform in between; one length holds "
                        "for all."},
               {.key = "gap",
                .of = kind::length.at_least(0.0),
                .fallback = 0.0,
                .text = "Smallest distance between the surfaces of two balls."},
               {.key = "seed",
                .of = kind::integer.at_least(0.0),
                .fallback = std::int64_t{0},
                .text = "Seed of the random numbers; the balls depend neither on the cells nor on the machine."},
           }),
       in_table(
           table, voxels,
           {
               {.key = "file",
                .of = kind::text,
                .unset = "needs voxels",
                .text = "NumPy file (.npy) of an array [z, y, x], z from the surface down: where it is not 0 is the "
                        "inclusion. The path is relative to the case.",
                .excludes = "voxels"},
               {.key = "voxels",
                .of = kind::number.list(),
                .unset = "from file",
                .text = "The voxels themselves: x runs fastest, then y, then z.",
                .excludes = "file"},
               {.key = "columns",
                .of = kind::integer.between(1, 1000000),
                .unset = "from file",
                .text = "Number of voxels along x; with a file that of the file."},
               {.key = "rows",
                .of = kind::integer.between(1, 1000000),
                .unset = "from file",
                .text =
                    "Number of voxels along y; with a file of two axes, which has the layers one beneath the other, "
                    "a divisor of its rows."},
           })});
}

/// Keys of what an inclusion consists of.
Entries content_entries(const std::string& table)
{
  const Condition any{table + "type", {"ellipsoid", "cuboid", "cylinder", "cluster", "voxels"}},
      elastic{table + "content", {"elastic"}}, solid{table + "content", {"elastic", "rigid"}};
  return joined(
      {in_table(table, any,
                {{.key = "content",
                  .choices = {"elastic", "void", "rigid"},
                  .fallback = "elastic",
                  .text = "elastic: a solid with elastic constants of its own, bonded to the body; void: nothing; "
                          "rigid: a solid that does not deform."}}),
       in_table(
           table, elastic,
           {
               {.key = "young_modulus",
                .of = kind::pressure.above(0.0),
                .required = true,
                .text = "Young's modulus of the inclusion.",
                .hint = "alumina has 390 GPa, manganese sulphide about 120 GPa"},
               {.key = "poisson_ratio",
                .of = kind::number.inside(-1.0, 0.5),
                .required = true,
                .text = "Poisson's ratio of the inclusion."},
               {.key = "yield_factor",
                .of = kind::number.above(0.0),
                .fallback = 1.0,
                .text = "Yield stress of the inclusion over that of the body, whose hardening law it has, times this "
                        "factor. A large one, such as 1000, lets it stay elastic."},
           }),
       in_table(
           table, solid,
           {{.key = "misfit",
             .of = kind::share.list().between(-0.1, 0.1),
             .unset = "none",
             .text = "Strain that the inclusion would have without the body around it: one number, equal along all "
                     "axes, three along x, y and z, or six, those and yz, xz and xy (tensor components). From "
                     "cooling by T: the difference of both expansions times T. The stress that it causes is there "
                     "before the first load, under a flat surface.",
             .hint = "from cooling about 0.1 %"}})});
}

} // namespace

std::vector<Entry> inclusion_entries(const std::string& table)
{
  Entries entries =
      joined({in_table(table, {},
                       {{.key = "type",
                         .choices = {"none", "ellipsoid", "cuboid", "cylinder", "cluster", "voxels"},
                         .unset = "none",
                         .text = "Region of the body that has other elastic constants. cluster: balls at "
                                 "random places of a box, which do not overlap; voxels: those of a file. "
                                 "Axes are those of the contact. Several inclusions are repeated tables "
                                 "[[lower.inclusion]] or a list; --set then names one as "
                                 "lower.inclusion[0].type. The body needs a hardening law, and no heat, "
                                 "layers, initial stress, softening, wear or current; rigid inclusions do not go "
                                 "with fatigue. In plane strain inclusions are cuboids, cylinders along y or voxels "
                                 "of one row. First yield and critical values are those of the body without "
                                 "inclusions, and no expected errors are stated."}}),
              region_entries(table), content_entries(table)});
  for (Entry& entry : entries)
    entry.list = table.substr(0, table.size() - 1);
  return entries;
}

} // namespace brinell::io
