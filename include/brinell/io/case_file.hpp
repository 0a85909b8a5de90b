// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"
#include "brinell/io/output_choice.hpp"
#include "brinell/io/schema.hpp"
#include "brinell/quality/quality.hpp"
#include "brinell/simulation/first_yield.hpp"
#include "brinell/simulation/scenarios.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace brinell::io
{

/// The values of a case, defaults filled in, in the order of the schema; keys that stay unset are missing.
class CaseValues
{
public:
  void set(std::string_view key, Value value) { values_.emplace_back(key, std::move(value)); }
  /// Replaces `key` by other keys of the same table at the same position, because in the resolved case the keys of a table must
  /// be together.
  void replace(std::string_view key, std::vector<std::pair<std::string, Value>> by);

  /// nullptr if unset.
  [[nodiscard]] const Value* find(std::string_view key) const;

  /// @throws InternalError if the key is unset or of another type than the schema declares.
  template <class T>
  [[nodiscard]] const T& get(std::string_view key) const
  {
    const Value* value = find(key);
    if (!value || !std::holds_alternative<T>(*value))
      throw InternalError("the case has no value of that type for " + std::string(key));
    return std::get<T>(*value);
  }

  [[nodiscard]] const std::vector<std::pair<std::string, Value>>& all() const { return values_; }

private:
  std::vector<std::pair<std::string, Value>> values_;
};

using simulation::FirstYield;
using simulation::YieldsFirst;

using quality::Warning;

using Scenario = simulation::AnyCase;

/// A case as read: typed, in SI, defaults filled in.
struct Case
{
  std::filesystem::path file;
  std::string name;  ///< name of the file, or of its folder if the file is called case.toml
  std::string title; ///< may be empty
  Scenario scenario;
  SnapshotRule snapshots;
  OutputChoice output;
  double checkpoint_interval = 30.0;              ///< [s]
  std::optional<double> accuracy;                 ///< relative error to be reached by a series of runs with finer cells
  std::optional<std::filesystem::path> directory; ///< of the results, if the case names one
  /// Equivalent radius 1 / (1/R1 + 1/R2) [m], if it is the same in all directions, or for cylinders in plane strain; for tugging,
  /// the one in the plane of motion.
  std::optional<double> equivalent_radius;
  double contact_modulus = 0.0;                       ///< E' [Pa]
  std::optional<FirstYield> first_yield;              ///< nominal; empty if there is a reason against it
  std::optional<reference::CoatedYield> coated_yield; ///< of round bodies with layers
  CaseValues values;
  std::string grid_source; ///< "file:line: grid.spacing = ..." for messages about the size of the grid
  std::vector<Warning> warnings;
  std::vector<std::string> notes; ///< how values were obtained from files
};

/// Reads a case file.
/// @param overrides  "key=value" as given to --set; the value is TOML, or a bare word taken as a string.
/// @throws InputError with all problems found, one per line, each with its place.
[[nodiscard]] Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The text of a case file: a regular file of up to 100 MB.
/// @throws InputError, IoError
[[nodiscard]] std::string case_file_text(const std::filesystem::path& file);

/// Heights in memory that a case may name like a file, so that a program need not write them.
struct HeightTable
{
  std::vector<double> heights; ///< row by row [m]
  std::size_t columns = 0;
};
using HeightTables = std::map<std::string, HeightTable, std::less<>>;

/// Whether messages name file and line; not useful if a program has made the text itself.
enum class Places
{
  lines,
  none
};

/// Reads a case from text. `file` is only named in messages, and paths in the case are relative to its folder.
/// @param tables  tables in memory that texture.file may name
[[nodiscard]] Case parse_case(std::string_view text, const std::filesystem::path& file,
                              const std::vector<std::string>& overrides = {}, Places places = Places::lines,
                              const HeightTables& tables = {});

/// The resolved case as a case file, which needs no further files.
[[nodiscard]] std::string resolved_text(const CaseValues& values);

/// The resolved case for a folder. Long height maps, and voxels, become separate binary files, whose names contain a checksum of the content,
/// so that equal texts mean equal cases.
struct ResolvedFiles
{
  std::string text;
  struct Map
  {
    std::string name; ///< <stem>-heights-<16 hexadecimal digits>.npy, or -voxels-
    const std::vector<double>* heights;
    std::size_t columns;
  };
  std::vector<Map> maps; ///< refer to values of the case, which must outlive them
};
/// @param stem  name, without extension, of the file that will contain the text
[[nodiscard]] ResolvedFiles resolved_files(const CaseValues& values, std::string_view stem = "resolved");

/// Writes first the maps, then the text.
/// @throws IoError
void write_resolved(const std::filesystem::path& text_file, const CaseValues& values);

/// Removes the maps that belong to resolved.toml in a folder.
/// @throws IoError
void remove_resolved_maps(const std::filesystem::path& folder);

} // namespace brinell::io
