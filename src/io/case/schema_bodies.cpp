// SPDX-License-Identifier: BSD-3-Clause
#include "schema_parts.hpp"

namespace brinell::io
{

namespace
{

using Entries = std::vector<Entry>;

/// Keys of the macroscopic shape.
Entries shape_entries(const std::string& table)
{
  const std::string type = table + "type";
  const auto length = [&](const char* key, const char* text)
  { return parameter(type, shape_options(), {.key = key, .of = kind::length.above(0.0), .text = text}); };
  const auto radius = [&](const char* key, const char* text)
  { return parameter(type, shape_options(), {.key = key, .of = kind::length.nonzero(), .text = text}); };
  return in_table(
      table, {},
      {
          {.key = "type",
           .choices = names_of(shape_options()),
           .required = true,
           .text = "Shape of the body near the contact, as seen from its apex. sphere: the paraboloid r^2/(2 "
                   "radius), a share of about (r/(2 radius))^2 lower than a sphere, 1 % at r = 0.2 radius; "
                   "ellipsoid: two radii of curvature at the apex, in the planes xz and yz; cylinder: a roller with "
                   "its axis along y and plane ends; cone: straight flanks, and a tip that may be rounded; vickers: "
                   "a pyramid of four faces at 68 degrees to the axis, one of them facing x; berkovich: a pyramid "
                   "of three faces at 65.27 degrees to the axis, one of them facing x; flat: a plane. Tugging "
                   "allows only shapes that can pass each other: sphere, ellipsoid and cylinder."},
          length("radius", "Radius of the sphere or cylinder."),
          radius("radius_x", "Radius of curvature at the apex in the plane x z; negative for a concave surface, such "
                             "as a raceway along its track. The gap between both bodies must be convex."),
          radius("radius_y", "Radius of curvature at the apex in the plane y z; negative for a concave surface, such "
                             "as the groove of a ball bearing."),
          parameter(type, shape_options(),
                    {.key = "length",
                     .of = kind::length.above(0.0),
                     .unset = "none, with a grid that is periodic along y",
                     .text = "Length of the cylinder, which has plane ends. Without a length the cylinder is infinite, "
                             "for example in plane strain."}),
          parameter(type, shape_options(),
                    {.key = "half_angle",
                     .of = kind::angle.inside(0.0, 90.0),
                     .text = "Angle between axis and flank of the cone, in degrees.",
                     .hint = "a blunt cone keeps strains small; 70.3 degrees has the same ratio of area to depth as a "
                             "Vickers pyramid"}),
          parameter(type, shape_options(),
                    {.key = "tip_radius",
                     .of = kind::length.at_least(0.0),
                     .fallback = 0.0,
                     .text = "Radius of the ball that rounds the tip, and the edges of a pyramid."}),
      });
}

/// Keys of a height map.
Entries map_entries(const std::string& table)
{
  return in_table(
      table, {table + "type", {"height_map"}},
      {
          {.key = "file",
           .of = kind::text,
           .unset = "heights and columns",
           .text = "File of heights, in m or in the given unit, positive outwards; the path is relative to "
                   "the folder of the case. A .npy file is a NumPy array [y, x]; any other file is text: "
                   "one line for each row along x, ordered along y, or x, y and z of one point per line. "
                   "Unit, distances, centre and period are taken from its header if it has one and the "
                   "case does not give them.",
           .excludes = "heights"},
          {.key = "unit",
           .of = kind::text,
           .unset = "from file, otherwise m",
           .text = "Unit of the heights in the file, for example \"um\"; of points also that of x and y, and "
                   "then needed."},
          {.key = "layout",
           .choices = {"rows", "points"},
           .unset = "from file",
           .text = "Whether the lines of the file are rows of heights, or x, y and z of one point each. By "
                   "default, lines of three numbers are points if x and y are those of a grid."},
          {.key = "fill",
           .of = kind::boolean,
           .unset = "false: gaps are an error",
           .text = "Whether a smooth surface fills points of the file that were not measured: empty cells, "
                   "NaN, points that a list leaves out. Each filled point is the mean of its neighbours."},
          {.key = "heights",
           .of = kind::length.list(),
           .unset = "from file",
           .text = "The heights themselves, positive outwards, row by row: x runs fastest, then y.",
           .excludes = "file"},
          {.key = "columns",
           .of = kind::integer.between(1, 1000000),
           .unset = "from file",
           .text = "Number of heights in each row along x."},
          {.key = "spacing",
           .of = kind::length.list().above(0.0),
           .unset = "from file",
           .text = "Distances [dx, dy] between the heights. The surface is linear between the points and "
                   "zero outside the map."},
          {.key = "periodic",
           .of = kind::boolean,
           .fallback = false,
           .text = "Whether the map repeats over the whole surface instead of being zero outside. The "
                   "periods are the numbers of points times their distances."},
      });
}

/// Keys of sinusoidal waves.
Entries wave_entries(const std::string& table)
{
  return in_table(
      table, {table + "type", {"sinusoid"}},
      {
          {.key = "amplitude", .of = kind::length, .required = true, .text = "Height of the crests above the mean."},
          {.key = "wavelength_x",
           .of = kind::length.above(0.0),
           .unset = "no waves along x",
           .text = "Wavelength along x."},
          {.key = "wavelength_y",
           .of = kind::length.above(0.0),
           .unset = "no waves along y",
           .text = "Wavelength along y."},
      });
}

/// Keys of a random rough surface.
Entries random_entries(const std::string& table)
{
  return in_table(
      table, {table + "type", {"random"}},
      {
          {.key = "hurst",
           .of = kind::number.between(0.0, 1.0),
           .fallback = 0.8,
           .text = "Hurst exponent; smaller values make short waves rougher."},
          {.key = "rms_height",
           .of = kind::length.at_least(0.0),
           .unset = "from rms_slope",
           .text = "Root mean square of the height over a period. The surface is scaled to this value exactly.",
           .excludes = "rms_slope"},
          {.key = "rms_slope",
           .of = kind::number.at_least(0.0),
           .unset = "from rms_height",
           .text = "Root mean square of the magnitude of the gradient over a period. The surface is scaled to this "
                   "value exactly.",
           .excludes = "rms_height"},
          {.key = "rolloff",
           .of = kind::length.above(0.0),
           .unset = "none: self-affine up to the size",
           .text = "Roll-off wavelength: for longer waves the power spectral density is constant."},
          {.key = "cutoff",
           .of = kind::length.above(0.0),
           .required = true,
           .text = "Shortest wavelength, independent of the cells; it should span at least eight cells."},
          {.key = "size",
           .of = kind::length.list().above(0.0),
           .unset = "grid.size along axes that are periodic, otherwise 8 rolloff",
           .text = "Period [along x, along y], which is the longest wavelength: up to 4096 times the cutoff."},
          {.key = "seed",
           .of = kind::integer.at_least(0.0),
           .fallback = std::int64_t{0},
           .text = "Seed of the random numbers; different seeds give different surfaces with the same spectrum. The "
                   "heights depend neither on the cells nor on the machine."},
      });
}

/// Keys of the textures of a surface.
Entries texture_entries(const std::string& table)
{
  const std::string type = table + "type";
  const auto length = [&](const char* key, const char* text)
  { return parameter(type, texture_options(), {.key = key, .of = kind::length.above(0.0), .text = text}); };
  const auto centre = [&](const char* key, const char* text)
  { return parameter(type, texture_options(), {.key = key, .of = kind::length, .fallback = 0.0, .text = text}); };
  Entries entries = joined(
      {in_table(
           table, {},
           {
               {.key = "type",
                .choices = names_of(texture_options()),
                .fallback = "smooth",
                .text =
                    "Texture of the surface, fixed to the material. dent: a dent with a raised shoulder, depth "
                    "10^(-10 (r/w)^2) cos(2 pi r/w) with w = 4 edge_radius; bump: a dent upwards; height_map: "
                    "measured heights, or those of a function of x and y; sinusoid: waves, amplitude cos(2 pi (X - "
                    "x)/wavelength_x) cos(2 pi (Y - y)/wavelength_y) at X, Y; random: Gaussian roughness, isotropic "
                    "and self-affine, with a power spectral density that is constant for wavelengths above rolloff, "
                    "falls as q^(-2 (1 + hurst)) with the wavenumber q from there to cutoff, and is zero for "
                    "shorter waves. Several textures add up; give them as repeated tables [[lower.texture]] or as a "
                    "list; --set then names one as lower.texture[0].type."},
               length("depth", "Depth of the dent's centre."),
               length("height", "Height of the bump's centre."),
               length("edge_radius",
                      "Radius at which a dent or a bump crosses the undisturbed surface, half of the diameter that is "
                      "read from a profile at its level. Half of the depth is at half of this radius, the crest of the "
                      "shoulder, 4 % of the depth high, at 1.26 times this radius."),
           }),
       map_entries(table), wave_entries(table), random_entries(table),
       in_table(
           table, {},
           {centre(
                "x",
                "Position of the centre on the body's surface along x; for a sinusoid the position of a crest, for a "
                "periodic map with an even number of columns that of the column after the middle, which then lies on a "
                "column of cells."),
            centre("y",
                   "Position of the centre on the body's surface along y; for a sinusoid the position of a crest.")})});
  for (Entry& entry : entries)
    entry.list = table.substr(0, table.size() - 1);
  return entries;
}

/// Keys of a film whose thickness differs from place to place.
Entries film_entries(const std::string& table)
{
  const Condition has_map{table + "type", {"height_map"}};
  const auto centre = [&](const char* key, const char* text) -> Entry
  { return {.key = key, .of = kind::length, .fallback = 0.0, .text = text}; };
  return joined({in_table(table, {},
                          {{.key = "type",
                            .choices = {"none", "height_map"},
                            .fallback = "none",
                            .text = "Film on the surface at the start, fixed to the material, that conducts badly: its "
                                    "thickness, measured or that of a function of x and y, takes the place of the "
                                    "heights of a map. It adds interface.film_resistivity times the thickness to the "
                                    "film, and changes no height."}}),
                 map_entries(table),
                 in_table(table, has_map,
                          {centre("x", "Position of the centre of the map on the body's surface along x."),
                           centre("y", "Position of the centre of the map on the body's surface along y.")})});
}

} // namespace

std::vector<Entry> in_table(const std::string& table, const Condition& when, std::vector<Entry> entries)
{
  for (Entry& entry : entries)
  {
    entry.key = table + entry.key;
    if (!entry.excludes.empty())
      entry.excludes = table + entry.excludes;
    if (entry.when.key.empty())
      entry.when = when;
  }
  return entries;
}

std::vector<Entry> joined(std::vector<std::vector<Entry>> parts)
{
  std::vector<Entry> all;
  for (std::vector<Entry>& part : parts)
    all.insert(all.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
  return all;
}

std::vector<Entry> body_entries(const std::string& body)
{
  return joined({shape_entries(body + ".shape."), texture_entries(body + ".texture."), film_entries(body + ".film."),
                 material_entries(body + ".material."), inclusion_entries(body + ".inclusion.")});
}

} // namespace brinell::io
