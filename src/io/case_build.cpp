// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/case_file.hpp"

#include "case_material.hpp"
#include "case_reader.hpp"
#include "case_values.hpp"
#include "io/files.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace brinell::io
{

namespace
{

std::string case_name(const std::filesystem::path& file)
{
  if (file.stem() != "case")
    return file.stem().string();
  const auto folder = std::filesystem::absolute(file).lexically_normal().parent_path().filename().string();
  return folder.empty() ? "case" : folder;
}

} // namespace

const Value* CaseValues::find(std::string_view key) const
{
  const auto found = std::find_if(values_.begin(), values_.end(), [&](const auto& item) { return item.first == key; });
  return found == values_.end() ? nullptr : &found->second;
}

void CaseValues::replace(std::string_view key, std::vector<std::pair<std::string, Value>> by)
{
  const auto found = std::find_if(values_.begin(), values_.end(), [&](const auto& item) { return item.first == key; });
  values_.insert(values_.erase(found), std::make_move_iterator(by.begin()), std::make_move_iterator(by.end()));
}

template <class T>
const T& CaseValues::get(std::string_view key) const
{
  const Value* value = find(key);
  if (!value || !std::holds_alternative<T>(*value))
    throw InternalError(fmt::format("the case has no value of that type for {}", key));
  return std::get<T>(*value);
}

template const bool& CaseValues::get(std::string_view) const;
template const std::int64_t& CaseValues::get(std::string_view) const;
template const double& CaseValues::get(std::string_view) const;
template const std::string& CaseValues::get(std::string_view) const;
template const std::vector<double>& CaseValues::get(std::string_view) const;
template const Vector3& CaseValues::get(std::string_view) const;
template const SnapshotRule& CaseValues::get(std::string_view) const;

void set_first_yield(const constitutive::Material& lower, const constitutive::Material& upper,
                     std::optional<double> radius, Case& c)
{
  c.contact_modulus = contact_modulus(lower.elastic, upper.elastic);
  c.equivalent_radius = radius;
  if (!radius)
    return;
  if (const auto yield = simulation::nominal_yield(lower, upper))
    c.first_yield =
        FirstYield{reference::critical_values(*radius, c.contact_modulus, yield->pressure_ratio, yield->yield_stress),
                   yield->body};
}

void warn_of_material(const std::string& name, const constitutive::Material& material, Case& c)
{
  constexpr double softest = 1e5;   // a gel
  constexpr double stiffest = 1e15; // a thousand times diamond; far beyond it small numbers of the fields are lost
  const double E = material.elastic.young_modulus;
  if (E < softest)
    c.warnings.push_back(
        {"soft_material",
         fmt::format(
             "{}.material.young_modulus is {:.4g} Pa, softer than any solid; is a unit missing, as in \"{:.4g} GPa\"?",
             name, E, E)});
  if (std::isfinite(E) && E > stiffest)
    c.warnings.push_back(
        {"stiff_material",
         fmt::format(
             "{}.material.young_modulus is {:.4g} Pa, stiffer than any solid (diamond has 1.1e12 Pa); is the unit "
             "right? What is not meant to deform has rigid = true",
             name, E)});
  if (material.hardening && constitutive::initial_yield_stress(*material.hardening) > 0.1 * E)
    c.warnings.push_back(
        {"hard_material",
         fmt::format("{}: the yield stress is above a tenth of Young's modulus; strains will not be small", name)});
}

void refuse_cells_and_shift(const CaseReader& reader, const simulation::Numerics& numerics,
                            const std::optional<double>& shift, double half_x, double half_y, Case& c)
{
  if (numerics.spacing)
    if (const auto reason = simulation::reason_against_cells(*numerics.spacing, half_x, half_y))
      reader.problems.add(c.grid_source, *reason);
  if (shift)
    if (const auto reason = simulation::reason_against_shift(*shift, half_x))
      reader.add(reader.has("tugging.shift") ? "tugging.shift" : "rolling.shift", *reason);
}

void warn_of_size(double contact_radius, double smallest_radius, Case& c)
{
  constexpr double share = 0.3;
  if (contact_radius > share * smallest_radius)
    c.warnings.push_back(
        {"large_contact",
         fmt::format(
             "the contact radius, {:.3g} m, is large beside the bodies (radius {:.3g} m), which are computed as "
             "half spaces",
             contact_radius, smallest_radius)});
}

Case parse_case(std::string_view text, const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  Problems problems;
  const RawCase raw = read_raw_case(text, file, overrides, problems);
  Draft draft;
  Case& result = draft.c;
  result.file = file;
  result.name = case_name(file);
  result.values = resolved_values(raw, problems);
  problems.throw_if_any();
  for (const char* body : {"lower", "upper"})
  {
    load_hardening_file(result.values, raw, body, problems);
    load_texture_file(result.values, raw, body, problems);
  }
  problems.throw_if_any();

  const CaseReader reader{result.values, raw, problems};
  const auto& scenario = reader.get<std::string>("scenario");
  if (scenario == "tugging")
    draft.numerics = draft.tugging; // its default cells are finer
  for (const auto& [key, value] : result.values.all())
    if (const auto& fill = find_entry(key)->fill)
      fill(draft, value);
  const std::string grid_key = reader.has("grid.spacing") ? "grid.spacing" : "grid.resolution";
  const Given* grid = raw.find(grid_key);
  result.grid_source = grid ? fmt::format("{}: {}", grid->place, reader.cited(grid_key))
                            : fmt::format("{}: {} (the default)", raw.file, reader.cited(grid_key));
  if (scenario == "tugging")
    read_tugging(reader, draft);
  else if (scenario == "indentation")
    read_indentation(reader, draft);
  else
    read_rolling(reader, draft);
  if (!problems.empty()) // a forgotten unit may be the reason
    for (const Warning& warning : result.warnings)
      problems.add(raw.file, "warning: " + warning.text);
  problems.throw_if_any();
  return result;
}

std::string case_file_text(const std::filesystem::path& file)
{
  if (std::filesystem::is_directory(file))
    throw InputError(fmt::format("{} is a folder; name the case file in it, as in {}", file.string(),
                                 (file / "case.toml").string()));
  try
  {
    return input_text(file);
  }
  catch (const InputError& error)
  {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  return parse_case(case_file_text(file), file, overrides);
}

} // namespace brinell::io
