// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/measured_curve.hpp"
#include "fatigue.hpp"
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

/// Keys of the elastic constants, and of the choice of the hardening law.
Entries elastic_entries(const std::string& table)
{
  const Condition deforms{table + "rigid", {"false"}};
  return joined(
      {in_table(table, {},
                {{.key = "rigid",
                  .of = kind::boolean,
                  .fallback = false,
                  .text = "Whether the body does not deform at all."}}),
       in_table(
           table, deforms,
           {
               {.key = "young_modulus",
                .of = kind::pressure.above(0.0),
                .required = true,
                .text = "Young's modulus E.",
                .hint = "a steel has about 200 GPa"},
               {.key = "poisson_ratio",
                .of = kind::number.inside(-1.0, 0.5),
                .required = true,
                .text = "Poisson's ratio nu.",
                .hint = "a steel has about 0.3"},
               {.key = "hardening.law",
                .choices = law_names(),
                .fallback = "none",
                .text =
                    "Yield stress sigma_y as a function of the equivalent plastic strain e, with S_y = yield_stress. "
                    "none: the body stays elastic; perfect: S_y; linear: S_y + modulus e; swift: coefficient (offset + "
                    "e)^exponent (Swift 1952); swift_microstrain: coefficient (offset + 1e6 e)^exponent, the law of "
                    "Swift in microstrain; hollomon: coefficient (e_0 + e)^exponent with e_0 such that it begins at "
                    "S_y (Hollomon 1945); ludwik: S_y + coefficient e^exponent (Ludwik 1909); voce: S_y + saturation "
                    "(1 - exp(-rate e)) (Voce 1948); table: linear between points, constant after the last one."},
           })});
}

/// Keys of a measured hardening curve.
Entries curve_entries(const std::string& table)
{
  return in_table(
      table, {table + "law", {"table"}},
      {
          {.key = "file",
           .of = kind::text,
           .unset = "plastic_strain and stress",
           .text = "Text file with one point per line: strain and stress; the path is relative to the folder "
                   "of the case. Columns are separated by commas, semicolons, tabs or blanks; decimal commas are "
                   "allowed if columns are not separated by commas; the file may begin with title lines.",
           .excludes = "plastic_strain"},
          {.key = "strain_unit", .choices = {"1", "%"}, .unset = "1", .text = "Unit of the strain in the file."},
          {.key = "stress_unit",
           .of = kind::text,
           .unset = "Pa",
           .text = "Unit of the stress in the file, for example \"MPa\"."},
          {.key = "plastic_strain",
           .of = kind::number.list().at_least(0.0),
           .unset = "from file",
           .text = "Equivalent plastic strains of the points, ascending from 0.",
           .excludes = "file"},
          {.key = "stress",
           .of = kind::pressure.list().above(0.0),
           .unset = "from file",
           .text = "Yield stresses of the points, as many as plastic strains; they must not decrease."},
          {.key = "monotone",
           .of = kind::boolean,
           .fallback = false,
           .text =
               "Whether a stress below an earlier one, as in scattered measurements, is replaced by the earlier one."},
      });
}

/// Keys that say what a measured curve is and how it becomes a hardening curve.
Entries conversion_entries(const std::string& table)
{
  return in_table(
      table, {table + "law", {"table"}},
      {
          {.key = "strain_type",
           .choices = choices_of(curve_words::strain),
           .unset = "plastic",
           .text = "Whether the strains of the file are plastic strains, or total strains, from which the elastic part "
                   "stress/E is subtracted. Unloading and repeated strains are left out of such a curve."},
          {.key = "measure",
           .choices = choices_of(curve_words::measure),
           .unset = "true",
           .text = "Whether the file has true strains and stresses, or engineering values (elongation over initial "
                   "length, force over initial area), which are converted up to the largest force."},
          {.key = "test",
           .choices = choices_of(curve_words::test),
           .unset = "automatic",
           .text = "Test in which the file was measured. automatic: compression if strains and stresses are below 0, "
                   "tension otherwise. Engineering values are converted accordingly."},
          {.key = "yield_from",
           .choices = choices_of(curve_words::yield_from),
           .unset = "offset for total strains, first_point for plastic strains",
           .text = "Where the material begins to yield. offset: at the stress at the plastic strain yield_offset, "
                   "below which the curve is constant; fit: at plastic strain 0 of the law (Swift, Ludwik or Voce) "
                   "that fits best beyond yield_offset; first_point: at the first point of the file."},
          {.key = "yield_offset",
           .of = kind::share.inside(0.0, 1.0),
           .unset = "0.2 %",
           .text = "Plastic strain of yield_from: at its stress the material yields (offset), or beyond it a law is "
                   "fitted (fit)."},
          {.key = "elastic_slope",
           .choices = choices_of(curve_words::slope),
           .unset = "young_modulus",
           .text = "Modulus by which the elastic strain is computed: young_modulus of the material, or the slope of "
                   "the elastic part of the curve, whose line also sets the zero of the strain. The latter takes off "
                   "the compliance of a testing machine."},
      });
}

/// Keys of the parameters of the hardening laws.
Entries hardening_entries(const std::string& table, const Condition& yields)
{
  const auto of_law = [&](Entry entry) { return parameter(table + "law", law_options(), std::move(entry)); };
  return in_table(
      table, yields,
      {
          of_law({.key = "yield_stress",
                  .of = kind::pressure.above(0.0),
                  .text = "Yield stress S_y in uniaxial tension, before any plastic strain.",
                  .hint = "law = \"none\" keeps the body elastic"}),
          of_law({.key = "modulus",
                  .of = kind::pressure.at_least(0.0),
                  .text = "Growth of the yield stress per unit of equivalent plastic strain."}),
          of_law({.key = "coefficient", .of = kind::pressure.above(0.0), .text = "Factor of the power law."}),
          of_law({.key = "offset",
                  .of = kind::number.above(0.0),
                  .text = "Strain offset of the power law; in millionths with swift_microstrain."}),
          of_law({.key = "exponent", .of = kind::number.up_to(0.0, 1.0), .text = "Exponent of the power law."}),
          of_law({.key = "saturation",
                  .of = kind::pressure.at_least(0.0),
                  .text = "Largest increase of the yield stress."}),
          of_law({.key = "rate",
                  .of = kind::number.above(0.0),
                  .text = "Rate at which the yield stress saturates with plastic strain."}),
      });
}

/// Keys of kinematic hardening, which may be added to any law: a list of tables, one per back stress.
Entries back_stress_entries(const std::string& list, const Condition& yields)
{
  Entries entries =
      in_table(list + ".", yields,
               {
                   {.key = "modulus",
                    .of = kind::pressure.at_least(0.0),
                    .unset = "no back stress",
                    .text = "Kinematic hardening, in addition to any law: modulus C of a back stress, d alpha = 2/3 C "
                            "d eps - recall alpha d e (Armstrong and Frederick). Several of them (Chaboche) are a list "
                            "of tables: back_stresses = [{modulus = \"90 GPa\", recall = 600}, {modulus = \"10 GPa\", "
                            "recall = 50}]; --set then names one as back_stresses[0].modulus."},
                   {.key = "recall",
                    .of = kind::number.at_least(0.0),
                    .unset = "0: linear (Prager)",
                    .text = "Recall of the back stress, which saturates at C / recall in uniaxial tension."},
               });
  for (Entry& entry : entries)
    entry.list = list;
  return entries;
}

constexpr double absolute_zero = -273.15;              // [degC]
constexpr const char* no_solid = "which no solid has"; // from foams to metals and diamond

/// Keys of the constants of heat conduction and expansion.
/// @param deforms  whether the body deforms
/// @param unset    effect of no such key
Entries heat_entries(const std::string& table, const Condition& given, const Condition& deforms, const char* unset)
{
  constexpr double most_expansion = 1e-3; // [1/K]: three times that of rubber
  return in_table(
      table, given,
      {
          {.key = "conductivity",
           .of = kind::conductivity.above(0.0),
           .unset = unset,
           .text = "Thermal conductivity K. With density rho and specific heat c the diffusivity is K/(rho c).",
           .hint = "a steel has 15 to 60 W/(m K)",
           .usual = {"unusual_thermal", 0.01, 3000.0, no_solid}},
          {.key = "density",
           .of = kind::density.above(0.0),
           .unset = unset,
           .text = "Mass per volume rho.",
           .hint = "a steel has about 7850 kg/m^3",
           .usual = {"unusual_thermal", 10.0, 23000.0, no_solid}},
          {.key = "specific_heat",
           .of = kind::specific_heat.above(0.0),
           .unset = unset,
           .text = "Heat capacity per mass c.",
           .hint = "a steel has about 460 J/(kg K)",
           .usual = {"unusual_thermal", 50.0, 10000.0, no_solid}},
          {.key = "expansion",
           .of = kind::expansion.between(-most_expansion, most_expansion),
           .unset = unset,
           .text = "Coefficient alpha of linear thermal expansion; with 0 heat neither expands nor stresses the body.",
           .hint = "a steel has about 12e-6 1/K",
           .when = deforms},
      });
}

/// Keys of the thermal constants of a material.
Entries thermal_entries(const std::string& material)
{
  const std::string table = material + "thermal.";
  return joined({heat_entries(table, {}, {material + "rigid", {"false"}}, "no heat"),
                 in_table(table, {},
                          {
                              {.key = "temperature",
                               .of = kind::temperature.above(absolute_zero),
                               .unset = "20 degC",
                               .text = "Temperature of the bulk, far from the contact and before the first load.",
                               .member = material + "temperature"},
                          })});
}

/// Keys of the electrical constants of the layers of a coated body.
Entries electrical_entries_of_layers(const std::string& material)
{
  const std::string table = material + "layers.";
  return in_table(
      table + "electrical.", {material + "rigid", {"false"}},
      {
          {.key = "resistivity",
           .of = kind::resistivity.above(0.0),
           .unset = "the body insulates",
           .text = "Resistivity of the layer at 20 degC. A body that conducts needs it of each of its layers.",
           .hint = "gold has 2.2e-8 ohm m, tin 1.1e-7 ohm m"},
          {.key = "temperature_coefficient",
           .of = kind::expansion.at_least(0.0),
           .unset = "0",
           .text = "Growth of the resistivity per degree up to the temperature of the bulk, over the resistivity at "
                   "20 degC. Where the current heats the contact, the layer grows like the substrate.",
           .hint = "pure metals have about 4e-3 1/K"},
      });
}

/// Keys of the layers of a coated body: a list of tables from the surface down.
Entries layer_entries(const std::string& material)
{
  const std::string list = material + "layers", table = list + ".", hardening = table + "hardening.";
  const Condition yields{hardening + "law", names_of(law_options())};
  Entries points = curve_entries(hardening);
  std::erase_if(points, [](const Entry& entry)
                { return !entry.key.ends_with("plastic_strain") && !entry.key.ends_with(".stress"); });
  for (Entry& entry : points)
  {
    entry.excludes.clear();
    entry.unset = "needed";
  }
  Entries entries = joined(
      {in_table(
           table, {material + "rigid", {"false"}},
           {
               {.key = "thickness",
                .of = kind::length.above(0.0),
                .unset = "no layer",
                .text = "Thickness of a layer that is bonded to what is beneath. Several are a list of tables from "
                        "the surface down, on a substrate that has the constants of the material: layers = "
                        "[{thickness = \"2 um\", young_modulus = \"400 GPa\", poisson_ratio = 0.2}, ...]; --set "
                        "then names one as layers[0].thickness. Units of normalised quantities and "
                        "estimates are those of the substrate.",
                .hint = "hard coatings have 1 to 10 um"},
               {.key = "young_modulus",
                .of = kind::pressure.above(0.0),
                .unset = "no layer",
                .text = "Young's modulus of the layer."},
               {.key = "poisson_ratio",
                .of = kind::number.inside(-1.0, 0.5),
                .unset = "no layer",
                .text = "Poisson's ratio of the layer."},
               {.key = "hardening.law",
                .choices = law_names(),
                .unset = "none",
                .text = "Hardening law of the layer, as that of the material; none: the layer stays elastic."},
           }),
       hardening_entries(hardening, yields), std::move(points), electrical_entries_of_layers(material),
       heat_entries(table + "thermal.", {material + "rigid", {"false"}}, {}, "the body has no thermal constants")});
  for (Entry& entry : entries)
    entry.list = list;
  return entries;
}

/// Keys of profiles over depth.
Entries depth_entries(const std::string& table, const Condition& yields)
{
  return in_table(
      table, yields,
      {
          {.key = "yield_profile.depth",
           .of = kind::length.list().at_least(0.0),
           .unset = "the same at every depth",
           .text = "Depths at which yield_profile.factor is given, ascending; the factor is linear between them and "
                   "constant beyond. For nitrided or case-hardened layers. Normalised results still refer to S_y "
                   "(alpha_c, P_c, U_c)."},
          {.key = "yield_profile.factor",
           .of = kind::number.list().above(0.0),
           .unset = "1",
           .text = "Factors on the yield stress at these depths."},
          {.key = "initial_stress.depth",
           .of = kind::length.list().at_least(0.0),
           .unset = "none",
           .text = "Depths at which initial_stress.value is given, ascending; the stress is linear between them and "
                   "constant beyond."},
          {.key = "initial_stress.value",
           .of = kind::pressure.list(),
           .unset = "none",
           .text =
               "Residual stress xx = yy before the first load, tension positive; it must be below the yield stress."},
      });
}

/// Keys of the electrical constants of a material.
Entries electrical_entries(const std::string& material)
{
  return in_table(material + "electrical.", {},
                  {
                      {.key = "resistivity",
                       .of = kind::resistivity.above(0.0),
                       .unset = "the body insulates",
                       .text = "Resistivity at 20 degC. If both bodies have one, the resistance of their contact is "
                               "found, and the current that interface.current or interface.voltage drives.",
                       .hint = "copper has 1.7e-8 ohm m, a steel about 2e-7 ohm m"},
                      {.key = "temperature_coefficient",
                       .of = kind::expansion.at_least(0.0),
                       .unset = "0",
                       .text = "Growth of the resistivity per degree, over the resistivity at 20 degC.",
                       .hint = "pure metals have about 4e-3 1/K"},
                  });
}

/// Keys of softening: how the yield stress falls with temperature.
/// @param yields  condition that the material has a yield stress
Entries softening_entries(const std::string& material, const Condition& yields)
{
  const std::string table = material + "softening.";
  const Condition melts{table + "law", {"linear", "johnson_cook"}}, johnson_cook{table + "law", {"johnson_cook"}},
      of_table{table + "law", {"table"}};
  constexpr ValueKind temperature = kind::temperature.above(absolute_zero);
  return joined(
      {in_table(table, yields,
                {
                    {.key = "law",
                     .choices = {"linear", "johnson_cook", "table"},
                     .unset = "none",
                     .text = "Factor on the yield stress as a function of the temperature T: 1 up to "
                             "reference_temperature T_r and 0 above melting_temperature T_m. linear: linear between "
                             "T_r and T_m; johnson_cook: 1 - ((T - T_r)/(T_m - T_r))^exponent (Johnson and Cook "
                             "1983); table: by temperature and factor. The factor is never below 0.01, even above "
                             "the melting temperature."},
                }),
       in_table(table, melts,
                {
                    {.key = "reference_temperature",
                     .of = temperature,
                     .unset = "20 degC",
                     .text = "Temperature up to which the yield stress is that of the hardening law."},
                    {.key = "melting_temperature",
                     .of = temperature,
                     .required = true,
                     .text = "Temperature at which no yield stress is left.",
                     .hint = "a steel melts at about 1500 degC"},
                }),
       in_table(table, johnson_cook,
                {
                    {.key = "exponent",
                     .of = kind::number.above(0.0),
                     .required = true,
                     .text = "Exponent m of Johnson and Cook.",
                     .hint = "steels have about 1"},
                }),
       in_table(table, of_table,
                {
                    {.key = "temperature",
                     .of = temperature.list(),
                     .required = true,
                     .text = "Temperatures at which factor is given, ascending; the factor is linear between them and "
                             "constant outside."},
                    {.key = "factor",
                     .of = kind::number.list().above(0.0),
                     .required = true,
                     .text = "Factors on the yield stress at these temperatures."},
                })});
}

} // namespace

std::vector<Entry> material_entries(const std::string& material)
{
  const Condition yields{material + "hardening.law", names_of(law_options())};
  return joined({elastic_entries(material), hardening_entries(material + "hardening.", yields),
                 curve_entries(material + "hardening."), conversion_entries(material + "hardening."),
                 back_stress_entries(material + "hardening.back_stresses", yields), layer_entries(material),
                 depth_entries(material, yields), thermal_entries(material), electrical_entries(material),
                 softening_entries(material, yields), fatigue_entries(material)});
}

} // namespace brinell::io
