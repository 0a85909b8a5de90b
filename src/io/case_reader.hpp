// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"
#include "raw_case.hpp"
#include "schema_parts.hpp"
#include "value_text.hpp"

#include <fmt/format.h>
#include <optional>

namespace brinell::io
{

/// What the readers of the parts of a case share.
struct CaseReader
{
  const CaseValues& values;
  const RawCase& raw;
  Problems& problems;

  template <class T>
  [[nodiscard]] const T& get(std::string_view key) const
  {
    return values.get<T>(key);
  }
  [[nodiscard]] int integer(std::string_view key) const { return static_cast<int>(get<std::int64_t>(key)); }
  [[nodiscard]] bool has(std::string_view key) const { return values.find(key) != nullptr; }

  /// Where a key stands, or is missed.
  [[nodiscard]] std::string place(const std::string& key) const
  {
    const Given* given = raw.find(key);
    return given ? given->place : raw.place_for(key);
  }
  /// "key = value" for checks that come after the reading.
  [[nodiscard]] std::string cited(const std::string& key) const
  {
    const Given* given = raw.find(key);
    const Value* value = values.find(key);
    return given ? fmt::format("{} = {}", key, shown(given->raw)) : (value ? key + " = " + toml_text(*value) : key);
  }
  void add(const std::string& key, std::string_view what) const
  {
    problems.add(place(key), fmt::format("{} {}", cited(key), what));
  }
};

/// A body of the general scenarios.
[[nodiscard]] simulation::ShapedBody read_body(const CaseReader& reader, const std::string& body);

/// Puts the heights of texture.file in its place, so that the resolved case needs no other file.
void load_texture_file(CaseValues& values, const RawCase& raw, const std::string& body, Problems& problems);

/// Each scenario completes its case: what takes judgement, equivalent radius, contact modulus, first yield, warnings.
/// What is wrong goes into the reader's problems.
void read_tugging(const CaseReader& reader, Draft& draft);
void read_indentation(const CaseReader& reader, Draft& draft);
void read_rolling(const CaseReader& reader, Draft& draft);

/// The bodies must touch in a point or in a line that ends.
void require_finite_contact(const CaseReader& reader, const simulation::Shape& lower, const simulation::Shape& upper);
/// The plan tells apart grids beyond all measure, and lengths that do not go together: these stand at `key`.
template <typename ScenarioCase>
auto planned(const CaseReader& reader, const Case& c, const ScenarioCase& scenario, const std::string& key)
{
  std::optional<decltype(simulation::plan(scenario))> plan;
  try
  {
    plan = simulation::plan(scenario);
  }
  catch (const GridError& error)
  {
    reader.problems.add(c.grid_source, error.what());
  }
  catch (const InputError& error)
  {
    reader.add(key, fmt::format("does not fit: {}", error.what()));
  }
  return plan;
}

/// Contact modulus and first yield, the latter if the bodies are round with that equivalent radius [m].
void set_first_yield(const constitutive::Material& lower, const constitutive::Material& upper,
                     std::optional<double> radius, Case& c);
/// What can be computed, but is seldom meant.
void warn_of_material(const std::string& name, const constitutive::Material& material, Case& c);
/// Cells or a step with which nothing of the contact could be computed.
void refuse_cells_and_shift(const CaseReader& reader, const simulation::Numerics& numerics,
                            const std::optional<double>& shift, double half_x, double half_y, Case& c);
/// The bodies are computed as half spaces.
void warn_of_size(double contact_radius, double smallest_radius, Case& c);

} // namespace brinell::io
