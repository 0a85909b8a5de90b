// SPDX-License-Identifier: BSD-3-Clause
#include "earlier_result.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <string>
#include <vector>

namespace brinell::io
{

namespace
{

namespace fs = std::filesystem;

/// A file of a run, and what tells that a run has written it.
struct Known
{
  std::string_view name;
  std::string_view begin{};  ///< of the file
  std::string_view within{}; ///< somewhere at its beginning
  std::string_view end{};    ///< somewhere at its end
  bool is_replaced = true;   ///< under its name with .part first
};

/// The summary goes first.
constexpr Known known_files[] = {
    {.name = "summary.json", .within = "brinell-summary"},
    {.name = "history.csv", .begin = "step,pass,", .within = ",energy_residual,"},
    {.name = "result.vtkhdf", .begin = "\x89HDF", .within = result_mark},
    {.name = "resolved.toml", .begin = "scenario = ", .end = "\ncheckpoint_interval = "},
    {.name = checkpoint_file, .end = checkpoint_mark},
    // of format version 1
    {.name = "result.h5", .begin = "\x89HDF", .within = result_mark},
    {.name = "contact.xdmf", .within = "result.h5", .is_replaced = false},
    {.name = "lower.xdmf", .within = "result.h5", .is_replaced = false},
    {.name = "upper.xdmf", .within = "result.h5", .is_replaced = false},
};

constexpr Known piece = {.name = "000012.h5", .end = piece_mark};

std::string taken(std::ifstream& stream, std::streamoff from, std::streamoff count)
{
  std::string text(static_cast<std::size_t>(count), '\0');
  stream.seekg(from);
  stream.read(text.data(), count);
  return text;
}

/// Whether a run wrote the file, as far as it tells by itself. An empty one holds nothing that could be lost.
bool is_own(const fs::path& file, const Known& known)
{
  constexpr std::streamoff most = 1 << 16; // where all marks are
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    return false;
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream ? static_cast<std::streamoff>(stream.tellg()) : -1;
  if (size <= 0)
    return size == 0;
  const std::string head = taken(stream, 0, std::min(size, most));
  const std::string tail = taken(stream, std::max<std::streamoff>(0, size - most), std::min(size, most));
  return stream && head.starts_with(known.begin) && head.find(known.within) != head.npos &&
         tail.find(known.end) != tail.npos;
}

/// 000012.h5, final.h5, and what is left of them when a process is killed that writes one.
bool is_piece(std::string name)
{
  if (name.ends_with(".part"))
    name.resize(name.size() - 5);
  if (name == final_piece)
    return true;
  constexpr std::size_t digits = 6; // or more
  return name.size() >= digits + 3 && name.ends_with(".h5") &&
         std::all_of(name.begin(), name.end() - 3, [](char c) { return c >= '0' && c <= '9'; });
}

bool is_there(const fs::path& path)
{
  std::error_code error;
  return fs::symlink_status(path, error).type() != fs::file_type::not_found;
}

bool removed(const fs::path& path)
{
  std::error_code error;
  const bool was_there = fs::remove(path, error);
  if (error)
    throw IoError(fmt::format("{}: an earlier result cannot be removed: {}", path.string(), error.message()));
  return was_there;
}

std::vector<fs::path> pieces_in(const fs::path& folder)
{
  std::vector<fs::path> pieces;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / pieces_folder, error))
    if (is_piece(entry.path().filename().string()))
      pieces.push_back(entry.path());
  return pieces;
}

/// A folder with two of these is that of a run: what is damaged in it is of the run too.
bool is_of_a_run(const fs::path& folder)
{
  int count = 0;
  for (const Known& known : known_files)
    if (known.name == "resolved.toml" || known.name == "history.csv" || known.name == "result.vtkhdf")
    {
      std::error_code error;
      const fs::path file = folder / known.name;
      count += is_own(file, known) && fs::file_size(file, error) > 0 ? 1 : 0;
    }
  return count >= 2;
}

/// Files that a run would remove or replace, but that none has written.
std::vector<std::string> foreign_files(const fs::path& folder)
{
  std::vector<std::string> names;
  if (is_of_a_run(folder))
    return names;
  const auto look = [&](const std::string& name, const Known& known)
  {
    if (is_there(folder / name) && !is_own(folder / name, known))
      names.push_back(name);
  };
  for (const Known& known : known_files)
  {
    look(std::string(known.name), known);
    if (known.is_replaced)
      look(fmt::format("{}.part", known.name), known);
  }
  if (is_there(folder / pieces_folder) && !fs::is_directory(folder / pieces_folder))
    names.emplace_back(pieces_folder);
  const auto pieces = pieces_in(folder);
  const auto foreign =
      std::find_if(pieces.begin(), pieces.end(), [](const fs::path& file) { return !is_own(file, piece); });
  if (foreign != pieces.end())
    names.push_back(fmt::format("{}/{}", pieces_folder, foreign->filename().string()));
  return names;
}

} // namespace

bool remove_earlier_result(const fs::path& folder)
{
  if (const auto foreign = foreign_files(folder); !foreign.empty())
    throw InputError(fmt::format("{}: holds other files: {}. A run writes files of these names, but no run of brinell "
                                 "has written these: move them away, or choose another folder (-o, output.directory)",
                                 folder.string(), fmt::join(foreign, ", ")));
  bool found = false;
  for (const Known& known : known_files)
  {
    found = removed(folder / known.name) || found;
    if (known.is_replaced)
      removed(folder / fmt::format("{}.part", known.name));
  }
  found = remove_pieces(folder) || found;
  remove_resolved_maps(folder);
  return found;
}

bool remove_pieces(const fs::path& folder)
{
  bool found = false;
  for (const fs::path& piece : pieces_in(folder))
    found = removed(piece) || found;
  std::error_code not_empty;
  if (fs::is_directory(folder / pieces_folder, not_empty))
    fs::remove(folder / pieces_folder, not_empty);
  return found;
}

} // namespace brinell::io
