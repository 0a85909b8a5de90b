// SPDX-License-Identifier: BSD-3-Clause
#include "case_reader.hpp"
#include "fatigue.hpp"
#include "measured_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

/// Reading of shape and material of a body, including measured curves from files.
namespace brinell::io
{

namespace
{

constitutive::HardeningLaw hardening_law(const CaseReader& reader, const std::string& table)
{
  const auto& option = chosen(reader, table + "law", law_options());
  if (option.make)
    return made(reader, table, option);
  for (const char* key : {"plastic_strain", "stress"})
    if (!reader.has(table + key))
      throw InputError(fmt::format("needs {0}plastic_strain and {0}stress, or {0}file", table));
  const auto& stress = reader.get<std::vector<double>>(table + "stress");
  try
  {
    return constitutive::TabulatedHardening(reader.get<std::vector<double>>(table + "plastic_strain"), stress);
  }
  catch (const InputError& error)
  {
    const auto& strain = reader.get<std::vector<double>>(table + "plastic_strain");
    if (std::is_sorted(stress.begin(), stress.end()) || !std::is_sorted(strain.begin(), strain.end()))
      throw;
    throw InputError(fmt::format("{}; for a measurement that scatters, monotone = true uses the largest stress so far",
                                 error.what()));
  }
}

/// Reads one term of kinematic hardening per table of the list. A table without a modulus is a problem; without tables there are
/// no terms.
std::vector<constitutive::KinematicTerm> kinematic_terms(const CaseReader& reader, const std::string& list)
{
  std::vector<constitutive::KinematicTerm> terms;
  for (const std::string& table : reader.raw.tables_of(list))
  {
    const bool has_recall = reader.has(table + ".recall");
    if (reader.has(table + ".modulus"))
      terms.push_back({reader.get<double>(table + ".modulus"), reader.get_or(table + ".recall", 0.0)});
    else if (has_recall || reader.raw.lists.contains(list))
      reader.problems.add(
          reader.place(has_recall ? table + ".recall" : table + ".modulus"),
          fmt::format("{}.modulus is missing; allowed: {}", table, allowed_values(*find_entry(table + ".modulus"))));
  }
  return terms;
}

/// Reads one layer per table of the list `layers`; without tables there are none.
std::vector<constitutive::Coat> coats(const CaseReader& reader, const std::string& list)
{
  std::vector<constitutive::Coat> layers;
  for (const std::string& table : reader.raw.tables_of(list))
  {
    const std::array keys{table + ".thickness", table + ".young_modulus", table + ".poisson_ratio"};
    const std::string hardening = table + ".hardening.";
    const bool has_law = reader.get_or(hardening + "law", std::string("none")) != "none";
    const auto given = std::count_if(keys.begin(), keys.end(), [&](const std::string& key) { return reader.has(key); });
    if (given == 0 && !has_law && !reader.raw.lists.contains(list))
      continue;
    for (const std::string& key : keys)
      if (!reader.has(key))
        reader.problems.add(reader.place(key),
                            fmt::format("{} is missing; allowed: {}", key, allowed_values(*find_entry(key))));
    if (given < 3)
      continue;
    layers.push_back(
        {reader.get<double>(keys[0]), {reader.get<double>(keys[1]), reader.get<double>(keys[2])}, {}, {}, {}});
    layers.back().electrical = electrical_of(reader, table + ".electrical.");
    layers.back().thermal =
        thermal_of(reader, table + ".thermal.", {"conductivity", "density", "specific_heat", "expansion"});
    try
    {
      if (has_law)
        layers.back().hardening = hardening_law(reader, hardening);
    }
    catch (const InputError& error)
    {
      reader.problems.add(reader.place(hardening + "law"), fmt::format("{}law: {}", hardening, error.what()));
    }
  }
  return layers;
}

/// Refuses what is computed for a homogeneous material only.
void refuse_with_layers(const CaseReader& reader, const std::string& table, const constitutive::Material& material)
{
  if (material.layers.empty())
    return;
  const auto refuse = [&](bool exists, const std::string& key)
  {
    if (exists)
      reader.problems.add(
          reader.place(key),
          fmt::format("{0} does not go with {1}layers; allowed: a body without layers, or without {0}", key, table));
  };
  refuse(material.softening.has_value(), table + "softening.law");
}

constitutive::DepthProfile profile(const CaseReader& reader, const std::string& table, const char* value)
{
  if (!reader.has(table + "depth") && !reader.has(table + value))
    return {};
  return {reader.get_or(table + "depth", std::vector<double>()), reader.get_or(table + value, std::vector<double>())};
}

/// Checks that a material does not yield under its initial stress. Both profiles are linear between their points, so that
/// checking these points is enough.
void require_elastic_at_start(const constitutive::Material& material)
{
  std::vector<double> depths = material.initial_stress.depth();
  depths.insert(depths.end(), material.yield_factor.depth().begin(), material.yield_factor.depth().end());
  const ElasticStack stack = material.stack();
  const auto laws = material.laws();
  double depth = 0.0; // of the interfaces, where the law beneath begins
  for (const constitutive::Coat& layer : material.layers)
    depths.push_back(depth += layer.thickness);
  for (const double z : depths)
  {
    const auto& law = laws[stack.layer_at(z)];
    if (!law)
      continue;
    const double stress = material.initial_stress.at(z, 0.0);
    const double yield = constitutive::initial_yield_stress(*law) * material.yield_factor.at(z, 1.0);
    if (!(std::abs(stress) < yield))
      throw InputError(fmt::format("{:.4g} Pa at a depth of {:.4g} m, where the material yields at {:.4g} Pa; allowed: "
                                   "less than that",
                                   stress, z, yield));
  }
}

/// Reads a material; where a part of it cannot be made, adds a problem at the place of its key.
constitutive::Material material(const CaseReader& reader, const std::string& table)
{
  constitutive::Material result{{std::numeric_limits<double>::infinity(), 0.0}, {}};
  const bool deforms = !reader.get<bool>(table + "rigid");
  if (deforms)
    result.elastic = {reader.get<double>(table + "young_modulus"), reader.get<double>(table + "poisson_ratio")};
  read_thermal(reader, table + "thermal.", result);
  result.electrical = electrical_of(reader, table + "electrical.");
  if (!deforms)
    return result;
  result.layers = coats(reader, table + "layers");
  const std::string hardening = table + "hardening.", law = hardening + "law";
  if (reader.get<std::string>(law) == "none")
  {
    refuse_with_layers(reader, table, result);
    return result;
  }
  // Inconsistencies are reported at the line of `at`, or of its partner if `at` is missing.
  const auto attempt = [&](const std::string& at, const std::string& partner, const auto& make)
  {
    try
    {
      make();
    }
    catch (const InputError& error)
    {
      const std::string& cited = reader.raw.find(at) ? at : partner;
      reader.problems.add(reader.place(cited), fmt::format("{}: {}", cited, error.what()));
    }
  };
  attempt(law, law, [&] { result.hardening = hardening_law(reader, hardening); });
  result.kinematic = kinematic_terms(reader, hardening + "back_stresses");
  attempt(table + "softening.law", table + "softening.law",
          [&] { result.softening = softening_law(reader, table + "softening."); });
  attempt(table + "yield_profile.factor", table + "yield_profile.depth",
          [&] { result.yield_factor = profile(reader, table + "yield_profile.", "factor"); });
  attempt(table + "initial_stress.value", table + "initial_stress.depth",
          [&] { result.initial_stress = profile(reader, table + "initial_stress.", "value"); });
  refuse_with_layers(reader, table, result);
  if (reader.problems.empty())
    attempt(table + "initial_stress.value", table + "yield_profile.factor", [&] { require_elastic_at_start(result); });
  return result;
}

/// The choice with the same index as the given word.
template <typename Choice, std::size_t N>
void read_choice(const CaseReader& reader, const std::string& key, const std::array<std::string_view, N>& words,
                 Choice& choice)
{
  if (reader.has(key))
    choice = static_cast<Choice>(std::find(words.begin(), words.end(), reader.get<std::string>(key)) - words.begin());
}

CurveRules curve_rules(const CaseReader& reader, const std::string& material)
{
  const std::string table = material + "hardening.";
  CurveRules rules;
  read_choice(reader, table + "strain_type", curve_words::strain, rules.strain);
  read_choice(reader, table + "measure", curve_words::measure, rules.measure);
  read_choice(reader, table + "test", curve_words::test, rules.test);
  if (reader.has(table + "yield_from"))
    read_choice(reader, table + "yield_from", curve_words::yield_from, rules.yield_from.emplace());
  rules.offset = reader.get_or(table + "yield_offset", rules.offset);
  read_choice(reader, table + "elastic_slope", curve_words::slope, rules.slope);
  if (reader.has(material + "young_modulus"))
    rules.young_modulus = reader.get<double>(material + "young_modulus");
  rules.monotone = reader.get_or(table + "monotone", false);
  return rules;
}

/// Replaces hardening.file by the hardening curve of the points that it contains.
void load_curve(Case& c, const CaseReader& reader, const std::string& material)
{
  const std::string table = material + "hardening.";
  const auto word = [&](const char* key, std::string otherwise)
  { return reader.get_or(table + key, std::move(otherwise)); };
  if (reader.has(table + "stress"))
    reader.problems.add(reader.place(table + "stress"),
                        fmt::format("{0}stress cannot stand together with {0}file; keep one of them", table));
  const char* key = "stress_unit";
  HardeningCurve curve;
  try
  {
    const std::string stress_unit = word(key, "Pa");
    static_cast<void>(size_of_unit(stress_unit, dimension::pressure, "stress, such as \"MPa\""));
    key = "file";
    const CurveRules rules = curve_rules(reader, material);
    curve = hardening_curve(
        read_curve(reader.raw.folder / word(key, ""), word("strain_unit", "1"), stress_unit, rules.strain), rules);
  }
  catch (const InputError& error) // names the whole file, which `shown` would shorten
  {
    reader.problems.add(reader.place(table + key),
                        fmt::format("{}{} = \"{}\" {}", table, key, word(key, ""), error.what()));
  }
  const std::string source = fmt::format("{}file = \"{}\"", table, word("file", ""));
  for (const Warning& warning : curve.warnings)
    c.warnings.push_back({warning.key, fmt::format("{}: {}", source, warning.text)});
  for (const std::string& note : curve.notes)
    c.notes.push_back(fmt::format("{}: {}", source, note));
  c.values.replace(table + "file", {{table + "plastic_strain", std::move(curve.plastic_strain)},
                                    {table + "stress", std::move(curve.stress)}});
}

} // namespace

void load_hardening_file(Case& c, const RawCase& raw, const std::string& body, Problems& problems)
{
  const std::string material = body + ".material.", table = material + "hardening.";
  const CaseReader reader{c.values, raw, problems};
  const bool has_file = reader.has(table + "file");
  if (has_file)
    load_curve(c, reader, material);
  for (const char* key : {"strain_unit", "stress_unit", "strain_type", "measure", "test", "yield_from", "yield_offset",
                          "elastic_slope"}) // about the file only: the resolved case has the hardening curve in SI
    if (reader.has(table + key))
    {
      if (!has_file)
        reader.add(table + key, "is {} of a file; it goes with {}file only",
                   std::string_view(key).ends_with("_unit") ? "the unit" : "about the curve", table);
      c.values.replace(table + key, {});
    }
  if (reader.get_or(table + "monotone", false) && reader.has(table + "stress"))
  {
    auto stress = reader.get<std::vector<double>>(table + "stress");
    for (std::size_t i = 1; i < stress.size(); ++i)
      stress[i] = std::max(stress[i], stress[i - 1]);
    c.values.replace(table + "stress", {{table + "stress", std::move(stress)}});
  }
}

simulation::ShapedBody read_body(const CaseReader& reader, const std::string& body, const simulation::Domain* domain)
{
  const std::string shape = body + ".shape.";
  simulation::ShapedBody result{made(reader, shape, chosen(reader, shape + "type", shape_options())),
                                material(reader, body + ".material."), read_texture(reader, body + ".texture", domain),
                                read_fatigue(reader, body + ".material.fatigue."), read_film(reader, body + ".film")};
  result.inclusions = read_inclusions(reader, body, result.material);
  return result;
}

} // namespace brinell::io
