// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"
#include "raw_case.hpp"
#include "schema_parts.hpp"
#include "value_text.hpp"

#include <fmt/format.h>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace brinell::io
{

/// Checks the given keys against the schema (conditions, exclusions, types, units, ranges) and fills in the defaults.
/// Errors are added to `problems`; if there are any, the values are incomplete.
[[nodiscard]] CaseValues resolved_values(const RawCase& raw_case, Problems& problems);

/// State shared by the readers of the parts of a case.
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
  /// Value of a key that may be unset.
  template <class T>
  [[nodiscard]] T get_or(std::string_view key, T otherwise) const
  {
    return has(key) ? get<T>(key) : std::move(otherwise);
  }
  [[nodiscard]] int integer(std::string_view key) const { return static_cast<int>(get<std::int64_t>(key)); }
  [[nodiscard]] bool has(std::string_view key) const { return values.find(key) != nullptr; }

  /// The key of a group (Entry::one_of) that is given. If none or more than one is given, a problem is added and the result is
  /// empty.
  /// @param advice  continues the message "one is needed"
  [[nodiscard]] std::string only_one_of(std::string_view group, std::string_view advice = "") const;

  /// Place of a key, or of the table in which it is missing.
  [[nodiscard]] std::string place(const std::string& key) const;
  /// "key = value" for messages of checks after reading.
  [[nodiscard]] std::string cited(const std::string& key) const;

  /// Adds the problem "key = value TEXT".
  void add(const std::string& key, std::string_view text) const
  {
    problems.add(place(key), fmt::format("{} {}", cited(key), text));
  }
  template <typename First, typename... Rest>
  void add(const std::string& key, fmt::format_string<First, Rest...> text, First&& first, Rest&&... rest) const
  {
    add(key, fmt::format(text, std::forward<First>(first), std::forward<Rest>(rest)...));
  }
  void missing(const std::string& key, std::string_view allowed) const
  {
    problems.add(place(key), fmt::format("{} is missing; allowed: {}", key, allowed));
  }
};

template <typename... Values>
void warn(Case& c, const char* key, fmt::format_string<Values...> text, Values&&... values)
{
  c.warnings.push_back({key, with_keys(fmt::format(text, std::forward<Values>(values)...))});
}

/// Performs an action that throws if the case cannot be computed. The error becomes a problem at the key of the member that the
/// error names, at the source of the grid if it is a GridError, or otherwise at `key`.
template <typename Action>
void at_its_key(const CaseReader& reader, const Case& c, const std::string& key, const Action& action)
try
{
  action();
}
catch (const simulation::PlanError& error)
{
  reader.problems.add(reader.place(key_of_member(error.member())), error.what());
}
catch (const GridError& error)
{
  reader.problems.add(c.grid_source, error.what());
}
catch (const InputError& error)
{
  reader.add(key, "does not fit: {}", error.what());
}

/// The option selected by a key.
template <typename Product>
const Option<Product>& chosen(const CaseReader& reader, const std::string& key,
                              const std::vector<Option<Product>>& options)
{
  const auto& name = reader.get<std::string>(key);
  for (const Option<Product>& option : options)
    if (option.name == name)
      return option;
  throw InternalError(fmt::format("{} = {} is in the schema, but is not built", key, name));
}

/// The object that an option makes from its parameters in a table, whose name ends with a dot.
template <typename Product>
Product made(const CaseReader& reader, const std::string& table, const Option<Product>& option)
{
  std::vector<double> numbers;
  for (const std::string& key : option.keys) // a length that is not given is infinite
    numbers.push_back(reader.get_or(table + key, std::numeric_limits<double>::infinity()));
  return option.make(numbers.data());
}

/// Reads a body. For a shape, texture or law that cannot be made, a problem is added at the place of its key.
/// @param domain  its period is the default size of a random texture; nullptr if the domain has problems
[[nodiscard]] simulation::ShapedBody read_body(const CaseReader& reader, const std::string& body,
                                               const simulation::Domain* domain);

/// Reads the sum of the textures in the tables of a list, or the texture of a single table. For a texture that cannot be made,
/// a problem is added.
[[nodiscard]] simulation::Texture read_texture(const CaseReader& reader, const std::string& key,
                                               const simulation::Domain* domain);

/// Reads the film on a surface from the table `key`: its thickness in place of heights; smooth without one.
[[nodiscard]] simulation::Texture read_film(const CaseReader& reader, const std::string& key);

/// Reads the inclusions of a body in the tables of the list `inclusion`. For one that cannot be made, or that does not go with the
/// material, a problem is added.
[[nodiscard]] std::vector<simulation::BodyInclusion> read_inclusions(const CaseReader& reader, const std::string& body,
                                                                     const constitutive::Material& material);

/// Fills in the thermal constants, if there are any. `material.elastic` must be set before, because a rigid body has no thermal
/// expansion.
/// @param table  ends with a dot
void read_thermal(const CaseReader& reader, const std::string& table, constitutive::Material& material);

/// Reads the electrical constants, if there are any.
/// @param table  ends with a dot
/// Thermal constants of which all `keys` must be given; empty if none is.
std::optional<Thermal> thermal_of(const CaseReader& reader, const std::string& table,
                                  const std::vector<const char*>& keys);
std::optional<constitutive::Electrical> electrical_of(const CaseReader& reader, const std::string& table);

/// Reads the softening law; none if no law is given.
/// @param table  ends with a dot
/// @throws InputError if its keys do not fit together
[[nodiscard]] std::optional<constitutive::SofteningLaw> softening_law(const CaseReader& reader,
                                                                      const std::string& table);

/// Warns of thermal constants that no solid has, and of a bulk temperature that was probably given in kelvin.
void warn_of_thermal(const CaseReader& reader, const std::string& body, const constitutive::Material& material,
                     Case& c);

/// Warns of plain numbers, which are in SI, that were probably meant in N, mm and MPa. The other warnings must be there before.
void warn_of_bare_numbers(const CaseReader& reader, Case& c);

/// Reads the boundaries of a domain, and the period and number of cells of its periodic axes.
/// @param both  whether the scenario can be computed with a periodic x axis, alone or together with y
void read_domain(const CaseReader& reader, simulation::Domain& domain, bool both);

/// Replace hardening.file and each texture.file of a body by the content of these files, so that the resolved case needs no
/// further files. The case gets warnings and notes about a curve, and warnings where it says something else than a file.
void load_hardening_file(Case& c, const RawCase& raw, const std::string& body, Problems& problems);
void load_texture_files(CaseValues& values, const RawCase& raw, const std::string& body, Problems& problems,
                        std::vector<Warning>& warnings);
/// Replaces inclusion.file by its voxels.
void load_voxel_files(CaseValues& values, const RawCase& raw, const std::string& body, Problems& problems);

/// Completes the case of the scenario: checks that need more than the schema, equivalent radius, contact modulus, first yield and
/// warnings. Errors are added to the reader's problems.
void complete(const CaseReader& reader, Case& c);

} // namespace brinell::io
