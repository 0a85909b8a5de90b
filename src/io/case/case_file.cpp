// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/case_file.hpp"

#include "case_reader.hpp"
#include "io/files.hpp"
#include "io/npy.hpp"
#include "io/pattern.hpp"
#include "io/scenarios/scenario_io.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>

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

/// Unit of a value as a TOML comment; empty for a pure number.
std::string unit_comment(const CaseValues& values, const Entry& entry)
{
  if (entry.of.notation == Notation::temperature)
    return " # degC";
  if (entry.of.dimension == dimension::none)
    return "";
  if (!entry.pure_if.empty() && values.get<bool>(entry.pure_if))
    return entry.of.dimension == dimension::force ? " # P_c" : " # alpha_c";
  return fmt::format(" # {}", si_unit(entry.of.dimension));
}

/// @throws InputError that continues a sentence which begins with the file's name
void require_utf8(std::string_view text)
{
  const std::size_t good = valid_utf8(text);
  if (good == text.size())
    return;
  const std::string_view before = text.substr(0, good);
  throw InputError(
      fmt::format("has in line {}, after \"{}\", the byte 0x{:02x}, which is not UTF-8; save the case in the encoding "
                  "UTF-8",
                  std::count(before.begin(), before.end(), '\n') + 1,
                  before.substr(std::max(before.rfind('\n') + 1, good - std::min<std::size_t>(good, 40))),
                  static_cast<unsigned char>(text[good])));
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

Case parse_case(std::string_view text, const std::filesystem::path& file, const std::vector<std::string>& overrides,
                Places places, const HeightTables& tables)
{
  Problems problems;
  RawCase raw = read_raw_case(text, file, overrides, places, problems);
  raw.height_tables = &tables;
  Case result;
  result.file = file;
  result.name = case_name(file);
  result.values = resolved_values(raw, problems);
  problems.throw_if_any();
  for (const char* body : {"lower", "upper"})
  {
    load_hardening_file(result, raw, body, problems);
    load_texture_files(result.values, raw, body, problems, result.warnings);
    load_voxel_files(result.values, raw, body, problems);
  }
  problems.throw_if_any();

  const CaseReader reader{result.values, raw, problems};
  for_each_scenario(
      [&]<typename ScenarioCase>(const ScenarioIo<ScenarioCase>& io)
      {
        if (io.name == reader.get<std::string>("scenario"))
          result.scenario.emplace<ScenarioCase>();
      });
  for (const auto& [key, value] : result.values.all())
    if (const auto& fill = find_entry(key)->fill)
      fill(result, value);
  const std::string grid_key = reader.has("grid.spacing") ? "grid.spacing"
                               : reader.has("grid.cells") ? "grid.cells"
                                                          : "grid.resolution";
  const Given* grid = raw.find(grid_key);
  result.grid_source = grid ? at_place(grid->place, reader.cited(grid_key))
                            : at_place(raw.file, reader.cited(grid_key) + " (the default)");
  complete(reader, result);
  warn_of_bare_numbers(reader, result);
  if (!problems.empty()) // warnings are listed too, since a forgotten unit may be the cause of the problems
    for (const Warning& warning : result.warnings)
      problems.add_cause(raw.file, "the reason may be: " + warning.text);
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
    std::string text = input_text(file);
    require_utf8(text);
    return text;
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

namespace
{

constexpr std::size_t most_inline = 1000; ///< largest number of heights on a line of text; longer maps become files

/// The lines of a case file, except those replaced by lines in `replaced`.
std::string text_with(const CaseValues& values,
                      const std::function<std::optional<std::string>(std::string_view, const Value&)>& replaced)
{
  std::string text;
  std::string table;
  for (const auto& [key, value] : values.all())
  {
    const auto dot = key.rfind('.');
    const std::string parent = dot == key.npos ? "" : key.substr(0, dot);
    if (parent != table)
      text += parent.ends_with(']') ? fmt::format("\n[[{}]]\n", plain_key(parent))
                                    : fmt::format("\n[{}]\n", plain_key(parent));
    table = parent;
    if (const auto line = replaced(key, value))
      text += *line;
    else
      text += fmt::format("{} = {}{}\n", dot == key.npos ? key : key.substr(dot + 1), toml_text(value),
                          unit_comment(values, *find_entry(key)));
  }
  return text;
}

/// Whether a file was written, or begun, by `write_resolved` for resolved.toml.
bool is_resolved_map(const std::filesystem::path& file)
{
  static const Pattern map(R"(resolved-(?:heights|voxels)-[0-9a-f]{16}\.npy(\.part)?)");
  return map.match(file.filename().string()).has_value();
}

} // namespace

std::string resolved_text(const CaseValues& values)
{
  return text_with(values, [](std::string_view, const Value&) { return std::nullopt; });
}

ResolvedFiles resolved_files(const CaseValues& values, std::string_view stem)
{
  ResolvedFiles result;
  result.text = text_with(values,
                          [&](std::string_view key, const Value& value) -> std::optional<std::string>
                          {
                            const std::string table(key.substr(0, key.rfind('.') + 1));
                            const bool is_columns = key == table + "columns";
                            const char* name = values.find(table + "voxels") != nullptr ? "voxels" : "heights";
                            if (!is_columns && key != table + name)
                              return std::nullopt;
                            const auto& heights = values.get<std::vector<double>>(table + name);
                            if (heights.size() <= most_inline)
                              return std::nullopt;
                            if (is_columns) // the binary file contains the number of columns
                              return "";
                            const auto columns = static_cast<std::size_t>(values.get<std::int64_t>(table + "columns"));
                            const std::string sum = checksum(npy_content(heights, columns));
                            result.maps.push_back({fmt::format("{}-{}-{}.npy", stem, name, sum),
                                                   &std::get<std::vector<double>>(value), columns});
                            return fmt::format("file = {}\n", toml_string(result.maps.back().name));
                          });
  return result;
}

void write_resolved(const std::filesystem::path& text_file, const CaseValues& values)
{
  const ResolvedFiles files = resolved_files(values, text_file.stem().string());
  for (const ResolvedFiles::Map& map : files.maps)
    replace_file(text_file.parent_path() / map.name, npy_content(*map.heights, map.columns));
  replace_file(text_file, files.text); // last, so that the files it names exist
}

void remove_resolved_maps(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> maps;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (is_resolved_map(entry.path()) && entry.is_regular_file(error))
      maps.push_back(entry.path());
  for (const std::filesystem::path& map : maps)
    if (!std::filesystem::remove(map, error))
      throw IoError(fmt::format("{}: cannot be removed: {}", map.string(), error.message()));
}

} // namespace brinell::io
