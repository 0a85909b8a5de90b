// SPDX-License-Identifier: BSD-3-Clause
#include "body_options.hpp"
#include "schema_parts.hpp"

namespace brinell::io
{

namespace
{

using Entries = std::vector<Entry>;

/// Names of the hardening laws; the first one is none.
std::vector<std::string> law_names()
{
  std::vector<std::string> names = names_of(law_options());
  names.insert(names.begin(), "none");
  return names;
}

/// A number of some of the options, required unless it has a default.
template <typename Product>
Entry parameter(const std::string& choice, const std::vector<Option<Product>>& options, Entry entry)
{
  entry.type = Type::number;
  entry.required = !entry.fallback && entry.unset.empty();
  entry.when = {choice, names_of(options, entry.key)};
  return entry;
}

/// Shape on the scale of the contact.
Entries shape_entries(const std::string& table)
{
  const std::string type = table + "type";
  const auto length = [&](const char* key, const char* text)
  {
    return parameter(type, shape_options(),
                     {.key = key, .dimension = dimension::length, .range = above(0.0), .text = text});
  };
  const auto radius = [&](const char* key, const char* text)
  {
    return parameter(type, shape_options(),
                     {.key = key, .dimension = dimension::length, .range = nonzero(), .text = text});
  };
  return in_table(
      table, {},
      {
          {.key = "type",
           .type = Type::choice,
           .choices = names_of(shape_options()),
           .required = true,
           .text = "Shape of the surface where it touches; near the apex, so a sphere is the paraboloid r^2/(2 R). "
                   "cylinder: axis along y; vickers, berkovich: pyramids of four faces at 68 and three at 65.27 "
                   "degrees to the axis, one of them facing x. Tugging takes those that can pass each other: sphere, "
                   "ellipsoid, cylinder."},
          length("radius", "Radius of the sphere or cylinder."),
          radius("radius_x",
                 "Radius of curvature at the apex in the plane x z; below 0 for a hollow, as that of a raceway "
                 "along its track. Both bodies together must be convex."),
          radius("radius_y",
                 "Radius of curvature at the apex in the plane y z; below 0 for a hollow, as the groove of a "
                 "ball bearing."),
          parameter(type, shape_options(),
                    {.key = "length",
                     .dimension = dimension::length,
                     .range = above(0.0),
                     .unset = "none, with a grid that is periodic along y",
                     .text =
                         "Length of the cylinder, which has plane ends. Without one it has no end, in plane strain for "
                         "example."}),
          parameter(type, shape_options(),
                    {.key = "half_angle",
                     .range = inside(0.0, 90.0),
                     .degrees = true,
                     .text = "Angle between axis and flank of the cone, in degrees.",
                     .hint = "a blunt cone keeps strains small, as 70.3 of the same area as a Vickers pyramid"}),
          parameter(type, shape_options(),
                    {.key = "tip_radius",
                     .dimension = dimension::length,
                     .range = at_least(0.0),
                     .fallback = 0.0,
                     .text = "Radius of the ball that rounds the tip, and the edges of a pyramid."}),
      });
}

/// What lies on the surface.
Entries texture_entries(const std::string& table)
{
  const std::string type = table + "type";
  const auto length = [&](const char* key, const char* text)
  {
    return parameter(type, texture_options(),
                     {.key = key, .dimension = dimension::length, .range = above(0.0), .text = text});
  };
  const auto centre = [&](const char* key, const char* text)
  {
    return parameter(type, texture_options(),
                     {.key = key, .dimension = dimension::length, .fallback = 0.0, .text = text});
  };
  const Condition of_map{type, {"height_map"}}, of_random{type, {"random"}}, of_waves{type, {"sinusoid"}};
  Entries entries = in_table(
      table, {},
      {
          {.key = "type",
           .type = Type::choice,
           .choices = names_of(texture_options()),
           .fallback = "smooth",
           .text =
               "What lies on the surface, fixed to the material. dent: depth 10^(-10 (r/radius)^2) cos(2 pi "
               "r/radius), with its shoulder; bump: the same upwards; height_map: measured heights, or "
               "those of a function of x and y; sinusoid: waves, of the height amplitude cos(2 pi (X - "
               "x)/wavelength_x) cos(2 pi (Y - y)/wavelength_y) at X, Y; random: roughness, Gaussian and self-affine, "
               "with a power spectral density that is constant down to the wavelength rolloff and falls as "
               "q^(-2 (1 + hurst)) from there to cutoff. Several textures add up, as [[lower.texture]] and "
               "[[lower.texture]] or as a list; --set then names one as lower.texture[0].type."},
          length("depth", "Depth of the dent's centre."),
          length("height", "Height of the bump's centre."),
          length("radius", "Wavelength of the profile: the surface is crossed at a quarter of it."),
          {.key = "file",
           .type = Type::text,
           .unset = "heights and columns",
           .text = "File of heights in m, or in unit, outwards positive; from the folder of the case. .npy: an array "
                   "[y, x] of "
                   "NumPy, binary; any other: text, a line per row along x, all of one length, one row after the other "
                   "along y.",
           .when = of_map,
           .excludes = "heights"},
          {.key = "unit",
           .type = Type::text,
           .unset = "m",
           .text = "Unit of the heights in the file, as \"um\".",
           .when = of_map},
          {.key = "heights",
           .type = Type::numbers,
           .dimension = dimension::length,
           .unset = "from file",
           .text = "The heights themselves, outwards positive, row after row: along x first, then along y.",
           .when = of_map,
           .excludes = "file"},
          {.key = "columns",
           .type = Type::integer,
           .range = between(1, 1000000),
           .unset = "from file",
           .text = "How many of the heights make a row along x.",
           .when = of_map},
          {.key = "spacing",
           .type = Type::numbers,
           .dimension = dimension::length,
           .range = above(0.0),
           .required = true,
           .text = "Distances [dx, dy] of the heights; linear between them, zero outside.",
           .when = of_map},
          {.key = "periodic",
           .type = Type::boolean,
           .fallback = false,
           .text =
               "Whether the map covers the surface, again and again, instead of being zero outside; its periods are "
               "the numbers of points times their distances.",
           .when = of_map},
          {.key = "amplitude",
           .type = Type::number,
           .dimension = dimension::length,
           .required = true,
           .text = "Height of the crests above the mean.",
           .when = of_waves},
          {.key = "wavelength_x",
           .type = Type::number,
           .dimension = dimension::length,
           .range = above(0.0),
           .unset = "no waves along x",
           .text = "Wavelength along x.",
           .when = of_waves},
          {.key = "wavelength_y",
           .type = Type::number,
           .dimension = dimension::length,
           .range = above(0.0),
           .unset = "no waves along y",
           .text = "Wavelength along y.",
           .when = of_waves},
          {.key = "hurst",
           .type = Type::number,
           .range = between(0.0, 1.0),
           .fallback = 0.8,
           .text = "Exponent of Hurst; the smaller, the rougher are short waves.",
           .when = of_random},
          {.key = "rms_height",
           .type = Type::number,
           .dimension = dimension::length,
           .range = at_least(0.0),
           .unset = "from rms_slope",
           .text = "Root mean square of the height over a period, exactly.",
           .when = of_random,
           .excludes = "rms_slope"},
          {.key = "rms_slope",
           .type = Type::number,
           .range = at_least(0.0),
           .unset = "from rms_height",
           .text = "Root mean square of the length of the gradient over a period, exactly.",
           .when = of_random,
           .excludes = "rms_height"},
          {.key = "rolloff",
           .type = Type::number,
           .dimension = dimension::length,
           .range = above(0.0),
           .unset = "none: self-affine up to the size",
           .text = "Wavelength from which on longer waves are not higher any more.",
           .when = of_random},
          {.key = "cutoff",
           .type = Type::number,
           .dimension = dimension::length,
           .range = above(0.0),
           .required = true,
           .text = "Shortest wavelength, whatever the cells; eight cells or more.",
           .when = of_random},
          {.key = "size",
           .type = Type::numbers,
           .dimension = dimension::length,
           .range = above(0.0),
           .unset = "grid.size along axes that are periodic, otherwise 8 rolloff",
           .text = "Period [along x, along y], which is the longest wavelength: up to 4096 times the cutoff.",
           .when = of_random},
          {.key = "seed",
           .type = Type::integer,
           .range = at_least(0.0),
           .fallback = std::int64_t{0},
           .text =
               "Other numbers give other surfaces of the same spectrum. The heights depend neither on the cells nor on "
               "the machine.",
           .when = of_random},
          centre("x", "Centre on the body's surface along x; of a sinusoid a crest."),
          centre("y", "Centre on the body's surface along y; of a sinusoid a crest."),
      });
  for (Entry& entry : entries)
    entry.list = table.substr(0, table.size() - 1);
  return entries;
}

Entries material_entries(const std::string& table)
{
  const Condition deforms{table + "rigid", {"false"}};
  return in_table(
      table, {},
      {
          {.key = "rigid",
           .type = Type::boolean,
           .fallback = false,
           .text = "Whether the body does not deform at all."},
          {.key = "young_modulus",
           .type = Type::number,
           .dimension = dimension::pressure,
           .range = above(0.0),
           .required = true,
           .text = "Young's modulus E.",
           .hint = "a steel has about 200 GPa",
           .when = deforms},
          {.key = "poisson_ratio",
           .type = Type::number,
           .range = inside(-1.0, 0.5),
           .required = true,
           .text = "Poisson's ratio nu.",
           .hint = "a steel has about 0.3",
           .when = deforms},
          {.key = "hardening.law",
           .type = Type::choice,
           .choices = law_names(),
           .fallback = "none",
           .text =
               "Yield stress sigma_y as a function of the equivalent plastic strain e. none: the body stays elastic; "
               "perfect: S_y; linear: S_y + modulus e; swift: coefficient (offset + e)^exponent; swift_microstrain: "
               "coefficient (offset + 1e6 e)^exponent; hollomon: coefficient (e_0 + e)^exponent with e_0 such that it "
               "begins at S_y; ludwik: S_y + coefficient e^exponent; voce: S_y + saturation (1 - exp(-rate e)); table: "
               "linear between points, constant after the last one.",
           .when = deforms},
      });
}

/// Parameters of the hardening laws of one body.
Entries hardening_entries(const std::string& table, const Condition& yields)
{
  const auto of_law = [&](Entry entry) { return parameter(table + "law", law_options(), std::move(entry)); };
  const Condition of_table{table + "law", {"table"}};
  return in_table(
      table, yields,
      {
          of_law({.key = "yield_stress",
                  .dimension = dimension::pressure,
                  .range = above(0.0),
                  .text = "Yield stress S_y in uniaxial tension, before any plastic strain.",
                  .hint = "law = \"none\" keeps the body elastic"}),
          of_law({.key = "modulus",
                  .dimension = dimension::pressure,
                  .range = at_least(0.0),
                  .text = "Growth of the yield stress per unit of equivalent plastic strain."}),
          of_law({.key = "coefficient",
                  .dimension = dimension::pressure,
                  .range = above(0.0),
                  .text = "Factor of the power law."}),
          of_law({.key = "offset",
                  .range = above(0.0),
                  .text = "Strain at which the power law begins; in millionths with swift_microstrain."}),
          of_law({.key = "exponent", .range = up_to(0.0, 1.0), .text = "Exponent of the power law."}),
          of_law({.key = "saturation",
                  .dimension = dimension::pressure,
                  .range = at_least(0.0),
                  .text = "Largest rise of the yield stress."}),
          of_law(
              {.key = "rate", .range = above(0.0), .text = "How fast the yield stress saturates with plastic strain."}),
          {.key = "file",
           .type = Type::text,
           .unset = "plastic_strain and stress",
           .text = "Text file with a point per line, plastic strain and stress; from the folder of the case. Columns "
                   "between commas, semicolons, tabs or blanks; decimal commas where something else stands between the "
                   "columns; lines of titles may come first.",
           .when = of_table,
           .excludes = "plastic_strain"},
          {.key = "strain_unit",
           .type = Type::choice,
           .choices = {"1", "%"},
           .unset = "1",
           .text = "Unit of the plastic strain in the file.",
           .when = of_table},
          {.key = "stress_unit",
           .type = Type::text,
           .unset = "Pa",
           .text = "Unit of the stress in the file, as \"MPa\".",
           .when = of_table},
          {.key = "plastic_strain",
           .type = Type::numbers,
           .range = at_least(0.0),
           .unset = "from file",
           .text = "Equivalent plastic strains of the points, ascending from 0.",
           .when = of_table,
           .excludes = "file"},
          {.key = "stress",
           .type = Type::numbers,
           .dimension = dimension::pressure,
           .range = above(0.0),
           .unset = "from file",
           .text = "Yield stresses of the points, as many; they must not fall.",
           .when = of_table},
          {.key = "monotone",
           .type = Type::boolean,
           .fallback = false,
           .text = "Whether a stress below an earlier one, as the scatter of a measurement has it, becomes that one.",
           .when = of_table},
      });
}

/// Kinematic hardening of one body, beside any law: a list of tables, one per back stress.
Entries back_stress_entries(const std::string& list, const Condition& yields)
{
  Entries entries = in_table(
      list + ".", yields,
      {
          {.key = "modulus",
           .type = Type::number,
           .dimension = dimension::pressure,
           .range = at_least(0.0),
           .unset = "no back stress",
           .text =
               "Kinematic hardening beside any law: modulus C of a back stress, d alpha = 2/3 C d eps - recall "
               "alpha d e (Armstrong and Frederick). Several of them (Chaboche) are a list of tables: back_stresses "
               "= [{modulus = \"90 GPa\", recall = 600}, {modulus = \"10 GPa\", recall = 50}]; --set then names "
               "one as back_stresses[0].modulus."},
          {.key = "recall",
           .type = Type::number,
           .range = at_least(0.0),
           .unset = "0: linear (Prager)",
           .text = "Recall of the back stress, which saturates at C / recall in uniaxial tension."},
      });
  for (Entry& entry : entries)
    entry.list = list;
  return entries;
}

/// What changes with depth in one body.
Entries depth_entries(const std::string& table, const Condition& yields)
{
  return in_table(
      table, yields,
      {
          {.key = "yield_profile.depth",
           .type = Type::numbers,
           .dimension = dimension::length,
           .range = at_least(0.0),
           .unset = "the same at every depth",
           .text = "Depths at which yield_profile.factor is given, ascending; linear between, constant beyond. For "
                   "nitrided or case-hardened layers. alpha_c, P_c and U_c stay those of S_y."},
          {.key = "yield_profile.factor",
           .type = Type::numbers,
           .range = above(0.0),
           .unset = "1",
           .text = "Factors on the yield stress at these depths."},
          {.key = "initial_stress.depth",
           .type = Type::numbers,
           .dimension = dimension::length,
           .range = at_least(0.0),
           .unset = "none",
           .text = "Depths at which initial_stress.value is given, ascending; linear between, constant beyond."},
          {.key = "initial_stress.value",
           .type = Type::numbers,
           .dimension = dimension::pressure,
           .unset = "none",
           .text = "Residual stress xx = yy before the first load, tension positive, below the yield stress."},
      });
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

std::vector<Entry> body_entries(const std::string& body)
{
  const std::string material = body + ".material.";
  const Condition yields{material + "hardening.law", names_of(law_options())};
  std::vector<Entry> entries;
  for (auto part : {shape_entries(body + ".shape."), texture_entries(body + ".texture."), material_entries(material),
                    hardening_entries(material + "hardening.", yields),
                    back_stress_entries(material + "hardening.back_stresses", yields), depth_entries(material, yields),
                    thermal_entries(material), softening_entries(material, yields)})
    entries.insert(entries.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
  return entries;
}

} // namespace brinell::io
