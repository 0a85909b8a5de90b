// SPDX-License-Identifier: BSD-3-Clause
#include "earlier_result.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <array>
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

constexpr std::array others{"history.csv", "result.vtkhdf", "resolved.toml", checkpoint_file,
                            // of format version 1
                            "result.h5", "contact.xdmf", "lower.xdmf", "upper.xdmf"};

/// Under a name with .part first.
constexpr std::array replaced_in_one_piece{"summary.json",  "history.csv",   "result.vtkhdf",
                                           "resolved.toml", checkpoint_file, "result.h5"};

/// Where all marks are.
struct Ends
{
  std::string head, tail;
};

Ends ends_of(const fs::path& file)
{
  constexpr std::streamoff most = 1 << 16;
  Ends ends;
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream ? static_cast<std::streamoff>(stream.tellg()) : 0;
  const auto taken = [&](std::streamoff from, std::streamoff count)
  {
    std::string text(static_cast<std::size_t>(count), '\0');
    stream.seekg(from);
    stream.read(text.data(), count);
    return stream ? text : std::string();
  };
  if (size > 0)
    ends = {taken(0, std::min(size, most)), taken(std::max<std::streamoff>(0, size - most), std::min(size, most))};
  return ends;
}

bool contains(const std::string& text, std::string_view part)
{
  return text.find(part) != text.npos;
}

/// Whether a run wrote the file, as far as it tells by itself. An empty one holds nothing that could be lost.
bool is_own(const fs::path& file)
{
  std::error_code error;
  const auto type = fs::symlink_status(file, error).type();
  if (type != fs::file_type::regular && type != fs::file_type::symlink)
    return false;
  if (!fs::is_regular_file(file, error))
    return false;
  const auto [head, tail] = ends_of(file);
  if (head.empty())
    return fs::file_size(file, error) == 0;
  const std::string name = file.filename().string();
  if (name == "history.csv")
    return head.starts_with("step,pass,") && contains(head.substr(0, head.find('\n')), ",iterations");
  if (name == "resolved.toml")
    return head.starts_with("scenario = ") && contains(tail, "\ncheckpoint_interval = ");
  if (name == "summary.json")
    return contains(head, "brinell-summary");
  if (name == checkpoint_file)
    return contains(tail, checkpoint_mark);
  if (name == index_file)
    return contains(head, index_mark) || contains(head, "\"has_plastic_strain\"");
  if (name == "result.vtkhdf" || name == "result.h5")
    return head.starts_with("\x89HDF") && contains(head, result_mark);
  return name.ends_with(".xdmf") && contains(head, "result.h5");
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

/// 000012.h5, final.h5, index.json, and what is left of them when a process is killed that writes one.
bool is_piece(std::string name)
{
  if (name.ends_with(".part"))
    name.resize(name.size() - 5);
  if (name == index_file || name == final_piece)
    return true;
  constexpr std::size_t digits = 6; // or more
  return name.size() >= digits + 3 && name.ends_with(".h5") &&
         std::all_of(name.begin(), name.end() - 3, [](char c) { return c >= '0' && c <= '9'; });
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
  int known = 0;
  for (const char* name : {"resolved.toml", "history.csv", "result.vtkhdf"})
  {
    std::error_code error;
    known += is_there(folder / name) && fs::file_size(folder / name, error) > 0 && is_own(folder / name) ? 1 : 0;
  }
  return known >= 2;
}

/// Files that a run would remove or replace, but that none has written.
std::vector<std::string> foreign_files(const fs::path& folder)
{
  std::vector<std::string> names;
  if (is_of_a_run(folder))
    return names;
  const auto look = [&](const std::string& name)
  {
    if (is_there(folder / name) && !is_own(folder / name))
      names.push_back(name);
  };
  look("summary.json");
  for (const char* name : others)
    look(name);
  for (const char* name : replaced_in_one_piece)
    look(name + std::string(".part"));
  if (is_there(folder / pieces_folder) && !fs::is_directory(folder / pieces_folder))
    names.emplace_back(pieces_folder);
  else if (const auto pieces = pieces_in(folder); !pieces.empty() && !is_own(folder / pieces_folder / index_file))
    names.push_back(fmt::format("{}/{}", pieces_folder, pieces.front().filename().string()));
  return names;
}

} // namespace

bool remove_earlier_result(const fs::path& folder)
{
  if (const auto foreign = foreign_files(folder); !foreign.empty())
    throw InputError(fmt::format("{}: holds other files: {}. A run writes files of these names, but no run of brinell "
                                 "has written these: move them away, or choose another folder (-o, output.directory)",
                                 folder.string(), fmt::join(foreign, ", ")));
  bool found = removed(folder / "summary.json");
  found = remove_pieces(folder) || found;
  for (const char* name : others)
    found = removed(folder / name) || found;
  for (const char* name : replaced_in_one_piece)
    removed(folder / (name + std::string(".part")));
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
