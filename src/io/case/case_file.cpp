// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/case_file.hpp"

#include "case_reader.hpp"
#include "io/files.hpp"

#include <algorithm>
#include <iterator>

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

/// Unit of a value, as a comment; none for what has no dimension.
std::string unit_comment(const CaseValues& values, const Entry& entry)
{
  if (entry.dimension == dimension::none)
    return "";
  if (!entry.pure_if.empty() && values.get<bool>(entry.pure_if))
    return entry.dimension == dimension::force ? " # P_c" : " # alpha_c";
  return fmt::format(" # {}", si_unit(entry.dimension));
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
                Places places)
{
  Problems problems;
  const RawCase raw = read_raw_case(text, file, overrides, places, problems);
  Draft draft;
  Case& result = draft.c;
  result.file = file;
  result.name = case_name(file);
  result.values = resolved_values(raw, problems);
  problems.throw_if_any();
  for (const char* body : {"lower", "upper"})
  {
    load_hardening_file(result.values, raw, body, problems);
    load_texture_files(result.values, raw, body, problems);
  }
  problems.throw_if_any();

  const CaseReader reader{result.values, raw, problems};
  if (reader.get<std::string>("scenario") == "tugging")
    draft.numerics = draft.tugging; // its default cells are finer
  for (const auto& [key, value] : result.values.all())
    if (const auto& fill = find_entry(key)->fill)
      fill(draft, value);
  const std::string grid_key = reader.has("grid.spacing") ? "grid.spacing"
                               : reader.has("grid.cells") ? "grid.cells"
                                                          : "grid.resolution";
  const Given* grid = raw.find(grid_key);
  result.grid_source = grid ? at_place(grid->place, reader.cited(grid_key))
                            : at_place(raw.file, reader.cited(grid_key) + " (the default)");
  complete(reader, draft);
  if (!problems.empty()) // a forgotten unit may be the reason
    for (const Warning& warning : result.warnings)
      problems.add(raw.file, "warning: " + warning.text);
  problems.throw_if_any();
  result.warnings.insert(result.warnings.begin(), raw.warnings.begin(), raw.warnings.end());
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

std::string resolved_text(const CaseValues& values)
{
  std::string text;
  std::string table;
  for (const auto& [key, value] : values.all())
  {
    const auto dot = key.rfind('.');
    const std::string parent = dot == key.npos ? "" : key.substr(0, dot);
    if (parent != table)
      text += parent.ends_with(']') ? fmt::format("\n[[{}]]\n", plain_key(parent)) : fmt::format("\n[{}]\n", parent);
    table = parent;
    text += fmt::format("{} = {}{}\n", dot == key.npos ? key : key.substr(dot + 1), toml_text(value),
                        unit_comment(values, *find_entry(key)));
  }
  return text;
}

} // namespace brinell::io
