// SPDX-License-Identifier: BSD-3-Clause
#include "schema_parts.hpp"

/// Keys of a material that has to do with heat.
namespace brinell::io
{

namespace
{

constexpr double absolute_zero = -273.15; // [degC]

}

std::vector<Entry> thermal_entries(const std::string& material)
{
  constexpr double most_expansion = 1e-3; // [1/K]: three times that of rubber
  const Condition deforms{material + "rigid", {"false"}};
  return in_table(
      material + "thermal.", {},
      {
          {.key = "conductivity",
           .dimension = dimension::conductivity,
           .range = above(0.0),
           .unset = "no heat",
           .text = "Thermal conductivity K. With density and specific_heat it makes the diffusivity K/(rho c).",
           .hint = "a steel has 15 to 60 W/(m K)"},
          {.key = "density",
           .dimension = dimension::density,
           .range = above(0.0),
           .unset = "no heat",
           .text = "Mass per volume rho.",
           .hint = "a steel has about 7850 kg/m^3"},
          {.key = "specific_heat",
           .dimension = dimension::specific_heat,
           .range = above(0.0),
           .unset = "no heat",
           .text = "Heat capacity per mass c.",
           .hint = "a steel has about 460 J/(kg K)"},
          {.key = "expansion",
           .dimension = dimension::expansion,
           .range = between(-most_expansion, most_expansion),
           .unset = "no heat",
           .text =
               "Coefficient alpha of linear thermal expansion; 0 for heat that neither swells nor stresses the body.",
           .hint = "a steel has about 12e-6 1/K",
           .when = deforms},
          {.key = "temperature",
           .range = above(absolute_zero),
           .celsius = true,
           .unset = "20 degC",
           .text = "Temperature of the bulk, far from the contact and before the first load."},
      });
}

std::vector<Entry> softening_entries(const std::string& material, const Condition& yields)
{
  const std::string table = material + "softening.";
  const Condition melts{table + "law", {"linear", "johnson_cook"}}, johnson_cook{table + "law", {"johnson_cook"}},
      of_table{table + "law", {"table"}};
  const auto temperature = [](Entry entry)
  {
    entry.range = above(absolute_zero);
    entry.celsius = true;
    return entry;
  };
  return joined(
      {in_table(table, yields,
                {
                    {.key = "law",
                     .type = Type::choice,
                     .choices = {"linear", "johnson_cook", "table"},
                     .unset = "none",
                     .text = "Factor on the yield stress by the temperature T, 1 up to reference_temperature T_r and 0 "
                             "from melting_temperature T_m on. linear: straight between; johnson_cook: 1 - ((T - "
                             "T_r)/(T_m - T_r))^exponent; table: of temperature and factor. At least 0.01 is left, "
                             "also of what has melted."},
                }),
       in_table(
           table, melts,
           {
               temperature({.key = "reference_temperature",
                            .unset = "20 degC",
                            .text = "Temperature at which the yield stress is that of hardening; not softer below."}),
               temperature({.key = "melting_temperature",
                            .required = true,
                            .text = "Temperature at which no yield stress is left.",
                            .hint = "a steel melts at about 1500 degC"}),
           }),
       in_table(table, johnson_cook,
                {
                    {.key = "exponent",
                     .range = above(0.0),
                     .required = true,
                     .text = "Exponent m of Johnson and Cook.",
                     .hint = "steels have about 1"},
                }),
       in_table(
           table, of_table,
           {
               temperature(
                   {.key = "temperature",
                    .type = Type::numbers,
                    .required = true,
                    .text = "Temperatures at which factor is given, ascending; linear between, constant outside."}),
               {.key = "factor",
                .type = Type::numbers,
                .range = above(0.0),
                .required = true,
                .text = "Factors on the yield stress at these temperatures."},
           })});
}

} // namespace brinell::io
