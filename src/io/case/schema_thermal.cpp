// SPDX-License-Identifier: BSD-3-Clause
#include "schema_parts.hpp"

/// Keys of a material that has to do with heat.
namespace brinell::io
{

std::vector<Entry> thermal_entries(const std::string& material)
{
  constexpr double absolute_zero = -273.15; // [degC]
  constexpr double most_expansion = 1e-3;   // [1/K]: three times that of rubber
  const Condition deforms{material + "rigid", {"false"}};
  return in_table(material + "thermal.", {},
                  {
                      {.key = "conductivity",
                       .type = Type::number,
                       .dimension = dimension::conductivity,
                       .range = above(0.0),
                       .unset = "no heat",
                       .text = "Thermal conductivity K. With density and specific_heat it makes the diffusivity K/(rho "
                               "c).",
                       .hint = "a steel has 15 to 60 W/(m K)"},
                      {.key = "density",
                       .type = Type::number,
                       .dimension = dimension::density,
                       .range = above(0.0),
                       .unset = "no heat",
                       .text = "Mass per volume rho.",
                       .hint = "a steel has about 7850 kg/m^3"},
                      {.key = "specific_heat",
                       .type = Type::number,
                       .dimension = dimension::specific_heat,
                       .range = above(0.0),
                       .unset = "no heat",
                       .text = "Heat capacity per mass c.",
                       .hint = "a steel has about 460 J/(kg K)"},
                      {.key = "expansion",
                       .type = Type::number,
                       .dimension = dimension::expansion,
                       .range = between(-most_expansion, most_expansion),
                       .unset = "no heat",
                       .text = "Coefficient alpha of linear thermal expansion; 0 for heat that neither swells nor "
                               "stresses the body.",
                       .hint = "a steel has about 12e-6 1/K",
                       .when = deforms},
                      {.key = "temperature",
                       .type = Type::number,
                       .range = above(absolute_zero),
                       .celsius = true,
                       .unset = "20 degC",
                       .text = "Temperature of the bulk, far from the contact and before the first load."},
                  });
}

} // namespace brinell::io
