// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/case_file.hpp"

#include "case_material.hpp"
#include "case_values.hpp"
#include "value_text.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

namespace brinell::io
{

namespace
{

simulation::Asperity asperity(const CaseValues& values, const RawCase& raw, const std::string& body, Problems& problems)
{
  return {values.get<double>(body + ".shape.radius"), material(values, raw, body, problems)};
}

elastoplastic::Settings solver(const CaseValues& values)
{
  return {.yield_tolerance = values.get<double>("solver.yield_tolerance"),
          .displacement_tolerance = values.get<double>("solver.displacement_tolerance"),
          .contact_tolerance = values.get<double>("solver.contact_tolerance"),
          .max_iterations = static_cast<int>(values.get<std::int64_t>("solver.max_iterations")),
          .anderson_depth = static_cast<int>(values.get<std::int64_t>("solver.anderson_depth")),
          .integration = values.get<std::string>("solver.integration") == "path"
                             ? elastoplastic::Integration::path
                             : elastoplastic::Integration::backward_euler,
          .mirror = values.get<bool>("solver.mirror")};
}

/// Everything but the interference, which may need the critical values.
simulation::TuggingCase tugging_case(const CaseValues& values, const RawCase& raw, Problems& problems)
{
  simulation::TuggingCase tugging;
  tugging.lower = asperity(values, raw, "lower", problems);
  tugging.upper = asperity(values, raw, "upper", problems);
  if (values.find("tugging.shift"))
    tugging.shift = values.get<double>("tugging.shift");
  tugging.kinematics = values.get<std::string>("tugging.kinematics") == "paper" ? simulation::Kinematics::paper
                                                                                : simulation::Kinematics::exact;
  tugging.passes = static_cast<int>(values.get<std::int64_t>("tugging.passes"));
  if (values.find("grid.spacing"))
    tugging.spacing = values.get<Vector3>("grid.spacing");
  else
    tugging.resolution = values.get<double>("grid.resolution");
  tugging.extent = values.get<double>("grid.extent");
  tugging.solver = solver(values);
  return tugging;
}

/// C(nu) S_y: the peak pressure at which the body yields; infinite if it stays elastic.
double yield_pressure(const constitutive::Material& body)
{
  if (!body.hardening)
    return std::numeric_limits<double>::infinity();
  return reference::critical_pressure_ratio(body.elastic.poisson_ratio) *
         constitutive::initial_yield_stress(*body.hardening);
}

std::optional<FirstYield> first_yield(const simulation::TuggingCase& tugging)
{
  const double lower = yield_pressure(tugging.lower.material), upper = yield_pressure(tugging.upper.material);
  if (!std::isfinite(std::min(lower, upper)))
    return std::nullopt;
  const auto& weaker = lower <= upper ? tugging.lower.material : tugging.upper.material;
  return FirstYield{reference::critical_values(equivalent_radius(tugging), contact_modulus(tugging),
                                               reference::critical_pressure_ratio(weaker.elastic.poisson_ratio),
                                               constitutive::initial_yield_stress(*weaker.hardening)),
                    lower == upper ? YieldsFirst::both : (lower < upper ? YieldsFirst::lower : YieldsFirst::upper)};
}

std::string case_name(const std::filesystem::path& file)
{
  if (file.stem() != "case")
    return file.stem().string();
  const auto folder = std::filesystem::absolute(file).lexically_normal().parent_path().filename().string();
  return folder.empty() ? "case" : folder;
}

/// "key = value" with its place, for checks that come after the reading.
std::string cited(const RawCase& raw, const std::string& key)
{
  return fmt::format("{} = {}", key, shown(raw.find(key)->raw));
}

void set_interference(Case& result, const RawCase& raw, Problems& problems)
{
  const std::string key = "tugging.interference";
  const bool normalised = result.values.get<bool>("tugging.normalised");
  const double given = result.values.get<double>(key);
  if (normalised && !result.first_yield)
  {
    problems.add(
        raw.find(key)->place,
        cited(raw, key) +
            " is in units of the critical interference alpha_c, but neither body can yield, so there is none; allowed: "
            "tugging.normalised = false with a length, or a yield stress for a body");
    return;
  }
  result.tugging.interference = normalised ? given * result.first_yield->critical.interference : given;
  const double limit = std::min(result.tugging.lower.radius, result.tugging.upper.radius);
  if (!(result.tugging.interference < limit))
    problems.add(raw.find(key)->place,
                 fmt::format("{} makes {:.4g} m, more than the radius of a sphere; allowed: < {:.4g} m{}",
                             cited(raw, key), result.tugging.interference, limit,
                             normalised
                                 ? fmt::format(" = {:.4g} alpha_c", limit / result.first_yield->critical.interference)
                                 : ""));
}

/// What can be computed, but is seldom meant.
std::vector<Warning> body_warnings(const std::string& name, const simulation::Asperity& body)
{
  constexpr double softest = 1e5; // a gel
  std::vector<Warning> result;
  const double E = body.material.elastic.young_modulus;
  if (E < softest)
    result.push_back(fmt::format(
        "{}.material.young_modulus is {:.4g} Pa, softer than any solid; is a unit missing, as in \"{:.4g} GPa\"?", name,
        E, E));
  if (body.material.hardening && constitutive::initial_yield_stress(*body.material.hardening) > 0.1 * E)
    result.push_back(
        fmt::format("{}: the yield stress is above a tenth of Young's modulus; strains will not be small", name));
  return result;
}

std::vector<Warning> contact_warnings(const simulation::TuggingCase& t)
{
  std::vector<Warning> result;
  const double contact_radius = std::sqrt(equivalent_radius(t) * t.interference);
  if (contact_radius > 0.3 * std::min(t.lower.radius, t.upper.radius))
    result.push_back(
        fmt::format("the contact radius, {:.3g} m, is large beside the spheres, which are computed as half spaces",
                    contact_radius));
  if (t.spacing && std::max((*t.spacing)[0], (*t.spacing)[1]) > 0.8 * contact_radius)
    result.push_back(
        fmt::format("about one cell per contact radius ({:.3g} m): the results will be coarse", contact_radius));
  return result;
}

/// Checks that need more than one value.
void finish(Case& result, const RawCase& raw, Problems& problems)
{
  for (const auto& [name, body] :
       {std::pair{"lower", &result.tugging.lower}, std::pair{"upper", &result.tugging.upper}})
    for (Warning& warning : body_warnings(name, *body))
      result.warnings.push_back(std::move(warning));
  set_interference(result, raw, problems);
  if (!problems.empty()) // a forgotten unit may be the reason
    for (const Warning& warning : result.warnings)
      problems.add(raw.file, warning);
  problems.throw_if_any();
  for (Warning& warning : contact_warnings(result.tugging))
    result.warnings.push_back(std::move(warning));
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

double equivalent_radius(const simulation::TuggingCase& tugging)
{
  return 1.0 / (1.0 / tugging.lower.radius + 1.0 / tugging.upper.radius);
}

double contact_modulus(const simulation::TuggingCase& tugging)
{
  return brinell::contact_modulus(tugging.lower.material.elastic, tugging.upper.material.elastic);
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
  if (result.values.find("title"))
    result.title = result.values.get<std::string>("title");
  if (result.values.find("output.directory"))
    result.directory = result.values.get<std::string>("output.directory");
  result.snapshots = result.values.get<SnapshotRule>("output.snapshots");
  for (const char* body : {"lower", "upper"})
    load_hardening_file(result.values, raw, body, problems);
  problems.throw_if_any();
  result.tugging = tugging_case(result.values, raw, problems);
  problems.throw_if_any();
  result.first_yield = first_yield(result.tugging);
  const std::string grid_key = result.tugging.spacing ? "grid.spacing" : "grid.resolution";
  const Given* grid = raw.find(grid_key);
  result.grid_source = grid ? fmt::format("{}: {}", grid->place, cited(raw, grid_key))
                            : fmt::format("{}: {} = {} (the default)", raw.file, grid_key, result.tugging.resolution);
  finish(result, raw, problems);
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
