// SPDX-License-Identifier: BSD-3-Clause
#include "schema_parts.hpp"

namespace brinell::io
{

namespace
{

/// Names of the hardening laws; the first one is none.
std::vector<std::string> law_names()
{
  return {"none", "perfect", "linear", "swift", "swift_microstrain", "hollomon", "ludwik", "voce", "table"};
}

/// The entry applies to a body that can yield.
Condition any_law(const std::string& key)
{
  const std::vector<std::string> names = law_names();
  return {key, {names.begin() + 1, names.end()}};
}

/// Parameters of the hardening laws of one body.
std::vector<Entry> hardening_entries(const std::string& body)
{
  const std::string law = body + ".material.hardening.law";
  const Condition yields = any_law(law);
  return {
      {.key = body + ".material.hardening.yield_stress",
       .type = Type::number,
       .dimension = dimension::pressure,
       .range = above(0.0),
       .required = true,
       .text = "Yield stress S_y in uniaxial tension, before any plastic strain.",
       .hint = "law = \"none\" keeps the body elastic",
       .when = {law, {"perfect", "linear", "hollomon", "ludwik", "voce"}}},
      {.key = body + ".material.hardening.modulus",
       .type = Type::number,
       .dimension = dimension::pressure,
       .range = at_least(0.0),
       .required = true,
       .text = "Growth of the yield stress per unit of equivalent plastic strain.",
       .when = {law, {"linear"}}},
      {.key = body + ".material.hardening.coefficient",
       .type = Type::number,
       .dimension = dimension::pressure,
       .range = above(0.0),
       .required = true,
       .text = "Factor of the power law.",
       .when = {law, {"swift", "swift_microstrain", "hollomon", "ludwik"}}},
      {.key = body + ".material.hardening.offset",
       .type = Type::number,
       .range = above(0.0),
       .required = true,
       .text = "Strain at which the power law begins; in millionths with swift_microstrain.",
       .when = {law, {"swift", "swift_microstrain"}}},
      {.key = body + ".material.hardening.exponent",
       .type = Type::number,
       .range = {.min = 0.0, .max = 1.0, .min_allowed = false},
       .required = true,
       .text = "Exponent of the power law.",
       .when = {law, {"swift", "swift_microstrain", "hollomon", "ludwik"}}},
      {.key = body + ".material.hardening.saturation",
       .type = Type::number,
       .dimension = dimension::pressure,
       .range = at_least(0.0),
       .required = true,
       .text = "Largest rise of the yield stress.",
       .when = {law, {"voce"}}},
      {.key = body + ".material.hardening.rate",
       .type = Type::number,
       .range = above(0.0),
       .required = true,
       .text = "How fast the yield stress saturates with plastic strain.",
       .when = {law, {"voce"}}},
      {.key = body + ".material.hardening.file",
       .type = Type::text,
       .unset = "plastic_strain and stress",
       .text = "Text file with a point per line, plastic strain and stress in Pa; from the folder of the case.",
       .when = {law, {"table"}},
       .excludes = body + ".material.hardening.plastic_strain"},
      {.key = body + ".material.hardening.plastic_strain",
       .type = Type::numbers,
       .range = at_least(0.0),
       .unset = "from file",
       .text = "Equivalent plastic strains of the points, ascending from 0.",
       .when = {law, {"table"}},
       .excludes = body + ".material.hardening.file"},
      {.key = body + ".material.hardening.stress",
       .type = Type::numbers,
       .dimension = dimension::pressure,
       .range = above(0.0),
       .unset = "from file",
       .text = "Yield stresses of the points, as many; they must not fall.",
       .when = {law, {"table"}}},
      {.key = body + ".material.hardening.kinematic_moduli",
       .type = Type::numbers,
       .dimension = dimension::pressure,
       .range = at_least(0.0),
       .unset = "no back stress",
       .text =
           "Kinematic hardening beside any law: moduli C of the back stresses, d alpha = 2/3 C d eps - recall alpha "
           "d e (Armstrong and Frederick; several: Chaboche).",
       .when = yields},
      {.key = body + ".material.hardening.kinematic_recall",
       .type = Type::numbers,
       .range = at_least(0.0),
       .unset = "zeros: linear (Prager)",
       .text = "Recall of each back stress; it saturates at C / recall in uniaxial tension.",
       .when = yields},
  };
}

/// What changes with depth in one body.
std::vector<Entry> depth_entries(const std::string& body)
{
  const Condition yields = any_law(body + ".material.hardening.law");
  return {
      {.key = body + ".material.yield_profile.depth",
       .type = Type::numbers,
       .dimension = dimension::length,
       .range = at_least(0.0),
       .unset = "the same at every depth",
       .text =
           "Depths at which yield_profile.factor is given, ascending; linear between, constant beyond. For nitrided or "
           "case-hardened layers. alpha_c, P_c and U_c stay those of S_y.",
       .when = yields},
      {.key = body + ".material.yield_profile.factor",
       .type = Type::numbers,
       .range = above(0.0),
       .unset = "1",
       .text = "Factors on the yield stress at these depths.",
       .when = yields},
      {.key = body + ".material.initial_stress.depth",
       .type = Type::numbers,
       .dimension = dimension::length,
       .range = at_least(0.0),
       .unset = "none",
       .text = "Depths at which initial_stress.value is given, ascending; linear between, constant beyond.",
       .when = yields},
      {.key = body + ".material.initial_stress.value",
       .type = Type::numbers,
       .dimension = dimension::pressure,
       .unset = "none",
       .text = "Residual stress xx = yy before the first load, tension positive, below the yield stress.",
       .when = yields},
  };
}

/// Shape on the scale of the contact.
std::vector<Entry> shape_entries(const std::string& body)
{
  const std::string type = body + ".shape.type";
  const auto length = [&](const char* key, std::vector<std::string> types, const char* text)
  {
    return Entry{.key = body + ".shape." + key,
                 .type = Type::number,
                 .dimension = dimension::length,
                 .range = above(0.0),
                 .required = true,
                 .text = text,
                 .when = {type, std::move(types)}};
  };
  Entry tip = length("tip_radius", {"cone", "vickers", "berkovich"},
                     "Radius of the ball that rounds the tip, and the edges of a pyramid.");
  tip.required = false;
  tip.range = at_least(0.0);
  tip.fallback = 0.0;
  return {
      {.key = type,
       .type = Type::choice,
       .choices = {"sphere", "ellipsoid", "cylinder", "cone", "vickers", "berkovich", "flat"},
       .required = true,
       .text =
           "Shape of the surface where it touches; near the apex, so a sphere is the paraboloid r^2/(2 R). cylinder: "
           "axis along y; vickers, berkovich: pyramids of four faces at 68 and three at 65.27 degrees to the axis, "
           "one of them facing x. Tugging takes those that can pass each other: sphere, ellipsoid, cylinder."},
      length("radius", {"sphere", "cylinder"}, "Radius of the sphere or cylinder."),
      length("radius_x", {"ellipsoid"}, "Radius of curvature at the apex in the plane x z."),
      length("radius_y", {"ellipsoid"}, "Radius of curvature at the apex in the plane y z."),
      length("length", {"cylinder"}, "Length of the cylinder, which has plane ends."),
      {.key = body + ".shape.half_angle",
       .type = Type::number,
       .range = inside(0.0, 90.0),
       .required = true,
       .text = "Angle between axis and flank of the cone, in degrees.",
       .hint = "a blunt cone keeps strains small, as 70.3 of the same area as a Vickers pyramid",
       .when = {type, {"cone"}}},
      tip,
  };
}

/// What lies on the surface.
std::vector<Entry> texture_entries(const std::string& body)
{
  const std::string type = body + ".texture.type";
  const auto length = [&](const char* key, std::vector<std::string> types, const char* text)
  {
    return Entry{.key = body + ".texture." + key,
                 .type = Type::number,
                 .dimension = dimension::length,
                 .range = above(0.0),
                 .required = true,
                 .text = text,
                 .when = {type, std::move(types)}};
  };
  const auto centre = [&](const char* key, const char* text)
  {
    return Entry{.key = body + ".texture." + key,
                 .type = Type::number,
                 .dimension = dimension::length,
                 .fallback = 0.0,
                 .text = text,
                 .when = {type, {"dent", "bump", "height_map"}}};
  };
  return {
      {.key = type,
       .type = Type::choice,
       .choices = {"smooth", "dent", "bump", "height_map"},
       .fallback = "smooth",
       .text = "What lies on the surface, fixed to the material. dent: depth 10^(-10 (r/radius)^2) cos(2 pi r/radius), "
               "with its shoulder; bump: the same upwards; height_map: measured heights, or those of a function of x "
               "and y."},
      length("depth", {"dent"}, "Depth of the dent's centre."),
      length("height", {"bump"}, "Height of the bump's centre."),
      length("radius", {"dent", "bump"}, "Wavelength of the profile: the surface is crossed at a quarter of it."),
      {.key = body + ".texture.file",
       .type = Type::text,
       .unset = "heights and columns",
       .text = "Text file of heights in m, outwards positive: a line per row along x, all of one length, one row "
               "after the other along y; from the folder of the case.",
       .when = {type, {"height_map"}},
       .excludes = body + ".texture.heights"},
      {.key = body + ".texture.heights",
       .type = Type::numbers,
       .dimension = dimension::length,
       .unset = "from file",
       .text = "The heights themselves, outwards positive, row after row: along x first, then along y.",
       .when = {type, {"height_map"}},
       .excludes = body + ".texture.file"},
      {.key = body + ".texture.columns",
       .type = Type::integer,
       .range = between(1, 1000000),
       .unset = "from file",
       .text = "How many of the heights make a row along x.",
       .when = {type, {"height_map"}}},
      {.key = body + ".texture.spacing",
       .type = Type::numbers,
       .dimension = dimension::length,
       .range = above(0.0),
       .required = true,
       .text = "Distances [dx, dy] of the heights; linear between them, zero outside.",
       .when = {type, {"height_map"}}},
      centre("x", "Centre on the body's surface along x."),
      centre("y", "Centre on the body's surface along y."),
  };
}

std::vector<Entry> material_entries(const std::string& body)
{
  const std::string rigid = body + ".material.rigid";
  const std::string law = body + ".material.hardening.law";
  const Condition deforms{rigid, {"false"}};
  return {
      {.key = rigid, .type = Type::boolean, .fallback = false, .text = "Whether the body does not deform at all."},
      {.key = body + ".material.young_modulus",
       .type = Type::number,
       .dimension = dimension::pressure,
       .range = above(0.0),
       .required = true,
       .text = "Young's modulus E.",
       .hint = "a steel has about 200 GPa",
       .when = deforms},
      {.key = body + ".material.poisson_ratio",
       .type = Type::number,
       .range = inside(-1.0, 0.5),
       .required = true,
       .text = "Poisson's ratio nu.",
       .hint = "a steel has about 0.3",
       .when = deforms},
      {.key = law,
       .type = Type::choice,
       .choices = law_names(),
       .fallback = "none",
       .text = "Yield stress sigma_y as a function of the equivalent plastic strain e. none: the body stays elastic; "
               "perfect: S_y; linear: S_y + modulus e; swift: coefficient (offset + e)^exponent; swift_microstrain: "
               "coefficient (offset + 1e6 e)^exponent; hollomon: coefficient (e_0 + e)^exponent with e_0 such that it "
               "begins at S_y; ludwik: S_y + coefficient e^exponent; voce: S_y + saturation (1 - exp(-rate e)); table: "
               "linear between points, constant after the last one.",
       .when = deforms},
  };
}

} // namespace

std::vector<Entry> body_entries(const std::string& body)
{
  std::vector<Entry> entries;
  for (auto part : {shape_entries(body), texture_entries(body), material_entries(body), hardening_entries(body),
                    depth_entries(body)})
    entries.insert(entries.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
  return entries;
}

} // namespace brinell::io
