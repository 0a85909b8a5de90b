// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/case_file.hpp"

#include "case_material.hpp"
#include "case_reader.hpp"
#include "case_values.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

namespace brinell::io
{

namespace
{

elastoplastic::Settings solver(const CaseReader& reader)
{
  return {.yield_tolerance = reader.get<double>("solver.yield_tolerance"),
          .displacement_tolerance = reader.get<double>("solver.displacement_tolerance"),
          .contact_tolerance = reader.get<double>("solver.contact_tolerance"),
          .max_iterations = reader.integer("solver.max_iterations"),
          .anderson_depth = reader.integer("solver.anderson_depth"),
          .integration = reader.get<std::string>("solver.integration") == "path"
                             ? elastoplastic::Integration::path
                             : elastoplastic::Integration::backward_euler,
          .mirror = reader.get<bool>("solver.mirror")};
}

/// C(nu) S_y: the peak pressure at which the body yields; infinite if it stays elastic.
double yield_pressure(const constitutive::Material& body)
{
  if (!body.hardening)
    return std::numeric_limits<double>::infinity();
  return reference::critical_pressure_ratio(body.elastic.poisson_ratio) *
         constitutive::initial_yield_stress(*body.hardening);
}

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
  const auto found =
      std::find_if(m_values.begin(), m_values.end(), [&](const auto& item) { return item.first == key; });
  return found == m_values.end() ? nullptr : &found->second;
}

void CaseValues::replace(std::string_view key, std::vector<std::pair<std::string, Value>> by)
{
  const auto found =
      std::find_if(m_values.begin(), m_values.end(), [&](const auto& item) { return item.first == key; });
  m_values.insert(m_values.erase(found), std::make_move_iterator(by.begin()), std::make_move_iterator(by.end()));
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

void read_numerics(const CaseReader& reader, simulation::Numerics& numerics)
{
  if (reader.has("grid.spacing"))
    numerics.spacing = reader.get<Vector3>("grid.spacing");
  else
    numerics.resolution = reader.get<double>("grid.resolution");
  numerics.extent = reader.get<double>("grid.extent");
  numerics.solver = solver(reader);
}

void set_first_yield(const constitutive::Material& lower, const constitutive::Material& upper,
                     std::optional<double> radius, Case& c)
{
  c.contact_modulus = contact_modulus(lower.elastic, upper.elastic);
  c.equivalent_radius = radius;
  const double of_lower = yield_pressure(lower);
  const double of_upper = yield_pressure(upper);
  if (!radius || !std::isfinite(std::min(of_lower, of_upper)))
    return;
  const auto& weaker = of_lower <= of_upper ? lower : upper;
  c.first_yield = FirstYield{
      reference::critical_values(*radius, c.contact_modulus,
                                 reference::critical_pressure_ratio(weaker.elastic.poisson_ratio),
                                 constitutive::initial_yield_stress(*weaker.hardening)),
      of_lower == of_upper ? YieldsFirst::both : (of_lower < of_upper ? YieldsFirst::lower : YieldsFirst::upper)};
}

void warn_of_material(const std::string& name, const constitutive::Material& material, Case& c)
{
  constexpr double softest = 1e5; // a gel
  const double E = material.elastic.young_modulus;
  if (E < softest)
    c.warnings.push_back(fmt::format(
        "{}.material.young_modulus is {:.4g} Pa, softer than any solid; is a unit missing, as in \"{:.4g} GPa\"?", name,
        E, E));
  if (material.hardening && constitutive::initial_yield_stress(*material.hardening) > 0.1 * E)
    c.warnings.push_back(
        fmt::format("{}: the yield stress is above a tenth of Young's modulus; strains will not be small", name));
}

void warn_of_size(double contact_radius, double smallest_radius, Case& c)
{
  constexpr double share = 0.3;
  if (contact_radius > share * smallest_radius)
    c.warnings.push_back(
        fmt::format("the contact radius, {:.3g} m, is large beside the bodies (radius {:.3g} m), which are computed as "
                    "half spaces",
                    contact_radius, smallest_radius));
}

Case parse_case(std::string_view text, const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  Problems problems;
  const RawCase raw = read_raw_case(text, file, overrides, problems);
  Case result;
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
  if (reader.has("title"))
    result.title = reader.get<std::string>("title");
  if (reader.has("output.directory"))
    result.directory = reader.get<std::string>("output.directory");
  result.snapshots = reader.get<SnapshotRule>("output.snapshots");
  result.checkpoint_interval = reader.get<double>("output.checkpoint_interval");
  const std::string grid_key = reader.has("grid.spacing") ? "grid.spacing" : "grid.resolution";
  const Given* grid = raw.find(grid_key);
  result.grid_source = grid ? fmt::format("{}: {}", grid->place, reader.cited(grid_key))
                            : fmt::format("{}: {} (the default)", raw.file, reader.cited(grid_key));
  const auto& scenario = reader.get<std::string>("scenario");
  if (scenario == "tugging")
    read_tugging(reader, result);
  else if (scenario == "indentation")
    read_indentation(reader, result);
  else
    read_rolling(reader, result);
  if (!problems.empty()) // a forgotten unit may be the reason
    for (const Warning& warning : result.warnings)
      problems.add(raw.file, "warning: " + warning);
  problems.throw_if_any();
  return result;
}

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  if (std::filesystem::is_directory(file))
    throw InputError(fmt::format("{} is a folder; name the case file in it, as in {}", file.string(),
                                 (file / "case.toml").string()));
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw InputError(fmt::format("{}: cannot be opened: no such file, or not readable", file.string()));
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return parse_case(text, file, overrides);
}

} // namespace brinell::io
