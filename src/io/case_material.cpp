// SPDX-License-Identifier: BSD-3-Clause
#include "case_material.hpp"

#include "brinell/foundation/error.hpp"
#include "number_lines.hpp"
#include "value_text.hpp"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <limits>

namespace brinell::io
{

namespace
{

/// Place of a key for messages: its own, or that of the table in which it is missing.
std::string place_of(const RawCase& raw, const std::string& key)
{
  const Given* given = raw.find(key);
  return given ? given->place : raw.place_for(key);
}

/// Columns plastic strain [-] and stress [Pa]; one line of titles may come first.
void read_points(const std::filesystem::path& file, std::vector<double>& strain, std::vector<double>& stress)
{
  bool may_be_titles = true;
  for (const NumberLine& line : number_lines(file))
  {
    if (line.values && line.values->size() == 2)
    {
      strain.push_back((*line.values)[0]);
      stress.push_back((*line.values)[1]);
    }
    else if (line.values || !may_be_titles)
      throw InputError(fmt::format("has in line {} \"{}\"; allowed: plastic strain and stress in Pa, as in "
                                   "\"0.002, 930e6\"",
                                   line.number, line.text.substr(0, 40)));
    may_be_titles = false;
  }
}

constitutive::HardeningLaw hardening_law(const CaseValues& values, const std::string& table, const std::string& law)
{
  const auto number = [&](const char* key) { return values.get<double>(table + key); };
  if (law == "perfect")
    return constitutive::PerfectPlasticity{number("yield_stress")};
  if (law == "linear")
    return constitutive::LinearHardening{number("yield_stress"), number("modulus")};
  if (law == "swift")
    return constitutive::SwiftHardening{number("coefficient"), number("offset"), number("exponent")};
  if (law == "swift_microstrain")
    return constitutive::swift_of_microstrain(number("coefficient"), number("offset"), number("exponent"));
  if (law == "hollomon")
    return constitutive::hollomon(number("yield_stress"), number("coefficient"), number("exponent"));
  if (law == "ludwik")
    return constitutive::LudwikHardening{number("yield_stress"), number("coefficient"), number("exponent")};
  if (law == "voce")
    return constitutive::VoceHardening{number("yield_stress"), number("saturation"), number("rate")};
  if (law != "table")
    throw InternalError(fmt::format("the hardening law {} is in the schema, but is not built", law));
  for (const char* key : {"plastic_strain", "stress"})
    if (!values.find(table + key))
      throw InputError(fmt::format("needs {0}plastic_strain and {0}stress, or {0}file", table));
  return constitutive::TabulatedHardening(values.get<std::vector<double>>(table + "plastic_strain"),
                                          values.get<std::vector<double>>(table + "stress"));
}

/// A list, empty if it is not given.
std::vector<double> numbers(const CaseValues& values, const std::string& key)
{
  return values.find(key) ? values.get<std::vector<double>>(key) : std::vector<double>{};
}

std::vector<constitutive::KinematicTerm> kinematic_terms(const CaseValues& values, const std::string& table)
{
  const std::vector<double> moduli = numbers(values, table + "kinematic_moduli");
  std::vector<double> recall = numbers(values, table + "kinematic_recall");
  if (recall.empty())
    recall.assign(moduli.size(), 0.0);
  if (recall.size() != moduli.size())
    throw InputError(fmt::format("needs one number in {0}kinematic_recall for each of {0}kinematic_moduli; there are "
                                 "{1} and {2}",
                                 table, recall.size(), moduli.size()));
  std::vector<constitutive::KinematicTerm> terms;
  for (std::size_t i = 0; i < moduli.size(); ++i)
    terms.push_back({moduli[i], recall[i]});
  return terms;
}

constitutive::DepthProfile profile(const CaseValues& values, const std::string& table, const char* value)
{
  std::vector<double> depth = numbers(values, table + "depth");
  std::vector<double> at_depth = numbers(values, table + value);
  if (depth.empty() && at_depth.empty())
    return {};
  return {std::move(depth), std::move(at_depth)};
}

/// A material that yields before it is loaded is none. Both profiles are linear between their points: look at these.
void require_elastic_at_start(const constitutive::Material& material)
{
  std::vector<double> depths = material.initial_stress.depth();
  depths.insert(depths.end(), material.yield_factor.depth().begin(), material.yield_factor.depth().end());
  for (const double z : depths)
  {
    const double stress = material.initial_stress.at(z, 0.0);
    const double yield = constitutive::initial_yield_stress(*material.hardening) * material.yield_factor.at(z, 1.0);
    if (!(std::abs(stress) < yield))
      throw InputError(fmt::format("{:.4g} Pa at a depth of {:.4g} m, where the material yields at {:.4g} Pa; allowed: "
                                   "less than that",
                                   stress, z, yield));
  }
}

} // namespace

void load_hardening_file(CaseValues& values, const RawCase& raw, const std::string& body, Problems& problems)
{
  const std::string table = body + ".material.hardening.";
  if (!values.find(table + "file"))
    return;
  const auto name = values.get<std::string>(table + "file");
  if (values.find(table + "stress"))
    problems.add(place_of(raw, table + "stress"),
                 fmt::format("{0}stress cannot stand together with {0}file; keep one of them", table));
  std::vector<double> strain;
  std::vector<double> stress;
  try
  {
    read_points(std::filesystem::path(raw.file).parent_path() / name, strain, stress);
  }
  catch (const InputError& error)
  {
    problems.add(place_of(raw, table + "file"), fmt::format("{}file = \"{}\" {}", table, name, error.what()));
  }
  values.replace(table + "file",
                 {{table + "plastic_strain", std::move(strain)}, {table + "stress", std::move(stress)}});
}

constitutive::Material material(const CaseValues& values, const RawCase& raw, const std::string& body,
                                Problems& problems)
{
  const std::string table = body + ".material.";
  const std::string key = table + "hardening.law";
  if (values.get<bool>(table + "rigid"))
    return {{std::numeric_limits<double>::infinity(), 0.0}, {}};
  const auto& law = values.get<std::string>(key);
  constitutive::Material result{
      {values.get<double>(table + "young_modulus"), values.get<double>(table + "poisson_ratio")}, {}};
  if (law == "none")
    return result;
  // What does not fit together is reported at the line of `at`, or at its partner if that is missing.
  const auto attempt = [&](const std::string& at, const std::string& partner, const auto& make)
  {
    try
    {
      make();
    }
    catch (const InputError& error)
    {
      const std::string& cited = raw.find(at) ? at : partner;
      problems.add(place_of(raw, cited), fmt::format("{}: {}", cited, error.what()));
    }
  };
  attempt(key, key, [&] { result.hardening = hardening_law(values, table + "hardening.", law); });
  attempt(table + "hardening.kinematic_recall", table + "hardening.kinematic_moduli",
          [&] { result.kinematic = kinematic_terms(values, table + "hardening."); });
  attempt(table + "yield_profile.factor", table + "yield_profile.depth",
          [&] { result.yield_factor = profile(values, table + "yield_profile.", "factor"); });
  attempt(table + "initial_stress.value", table + "initial_stress.depth",
          [&] { result.initial_stress = profile(values, table + "initial_stress.", "value"); });
  if (problems.empty())
    attempt(table + "initial_stress.value", table + "yield_profile.factor", [&] { require_elastic_at_start(result); });
  return result;
}

} // namespace brinell::io
