// SPDX-License-Identifier: BSD-3-Clause
#include "case_reader.hpp"

/// Reading of the thermal and electrical constants and the softening law of a material.
namespace brinell::io
{

std::optional<Thermal> thermal_of(const CaseReader& reader, const std::string& table,
                                  const std::vector<const char*>& keys)
{
  const auto has = [&](const char* key) { return reader.has(table + key); };
  if (std::none_of(keys.begin(), keys.end(), has))
    return std::nullopt;
  for (const char* key : keys)
    if (!has(key))
    {
      const Entry& entry = *find_entry(table + key);
      reader.missing(table + key, fmt::format("{}; {}", allowed_values(entry), entry.hint));
    }
  const auto number = [&](const char* key) { return reader.get_or(table + key, 0.0); };
  return Thermal{.conductivity = number("conductivity"),
                 .density = number("density"),
                 .specific_heat = number("specific_heat"),
                 .expansion = number("expansion")};
}

void read_thermal(const CaseReader& reader, const std::string& table, constitutive::Material& material)
{
  std::vector<const char*> keys{"conductivity", "density", "specific_heat"};
  if (!material.elastic.is_rigid())
    keys.push_back("expansion");
  material.thermal = thermal_of(reader, table, keys);
  if (!reader.has(table + "temperature"))
    return;
  if (!material.thermal) // the temperature of a bulk without constants: they are missing
  {
    for (const char* key : keys)
    {
      const Entry& entry = *find_entry(table + key);
      reader.missing(entry.key, fmt::format("{}; {}", allowed_values(entry), entry.hint));
    }
    material.thermal.emplace();
  }
  material.temperature = reader.get<double>(table + "temperature");
}

std::optional<constitutive::Electrical> electrical_of(const CaseReader& reader, const std::string& table)
{
  if (reader.has(table + "resistivity"))
    return constitutive::Electrical{reader.get<double>(table + "resistivity"),
                                    reader.get_or(table + "temperature_coefficient", 0.0)};
  if (reader.has(table + "temperature_coefficient"))
  {
    const Entry& entry = *find_entry(table + "resistivity");
    reader.missing(table + "resistivity", fmt::format("{}; {}", allowed_values(entry), entry.hint));
  }
  return std::nullopt;
}

std::optional<constitutive::SofteningLaw> softening_law(const CaseReader& reader, const std::string& table)
{
  if (!reader.has(table + "law"))
    return std::nullopt;
  const auto& law = reader.get<std::string>(table + "law");
  if (law == "table")
    return constitutive::TabulatedSoftening(reader.get<std::vector<double>>(table + "temperature"),
                                            reader.get<std::vector<double>>(table + "factor"));
  const double melting = reader.get<double>(table + "melting_temperature");
  const double reference = reader.get_or(table + "reference_temperature", constitutive::LinearSoftening{}.reference);
  if (!(melting > reference))
    throw InputError(
        fmt::format("melting_temperature = {:g} degC is not above reference_temperature = {:g} degC; allowed: above it",
                    melting, reference));
  if (law == "linear")
    return constitutive::LinearSoftening{reference, melting};
  return constitutive::JohnsonCookSoftening{reference, melting, reader.get<double>(table + "exponent")};
}

void warn_of_thermal(const CaseReader& reader, const std::string& body, const constitutive::Material& material, Case& c)
{
  if (!material.thermal)
    return;
  const std::string table = body + ".material.thermal";
  constexpr double ice_point = 273.0, warm_room = 310.0; // [K]
  const Given* given = reader.raw.find(table + ".temperature");
  if (const double t = material.temperature;
      given && !std::holds_alternative<std::string>(given->raw.value) && t >= ice_point && t <= warm_room)
    warn(c, "hot_bulk", "{0}.temperature is {1:.5g} degC; if {1:.5g} K is meant, write \"{1:.5g} K\"", table, t);
}

} // namespace brinell::io
