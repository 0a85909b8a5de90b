// SPDX-License-Identifier: BSD-3-Clause
#include "earlier_result.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"
#include "io/pattern.hpp"

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

/// A file of a run, and how to recognise that a run has written it.
struct Known
{
  std::string_view name;
  std::string_view begin{};  ///< text with which the file begins
  std::string_view within{}; ///< text somewhere near its beginning
  std::string_view end{};    ///< text somewhere near its end
};

/// The files in the order of their removal: the summary first.
constexpr Known known_files[] = {
    {.name = "summary.json", .within = "brinell-summary"},
    {.name = "history.csv", .begin = "step,pass,", .within = ",energy_residual,"},
    {.name = "points.csv", .begin = "step,point,"},
    {.name = "result.vtkhdf", .begin = "\x89HDF", .within = result_mark},
    {.name = "resolved.toml", .begin = "scenario = ", .end = "\ncheckpoint_interval = "},
    {.name = checkpoint_file, .end = checkpoint_mark},
};

constexpr Known piece = {.name = "000012.h5", .end = piece_mark};

std::string read_part(std::ifstream& stream, std::streamoff from, std::streamoff count)
{
  std::string text(static_cast<std::size_t>(count), '\0');
  stream.seekg(from);
  stream.read(text.data(), count);
  return text;
}

/// Whether the content shows that a run has written the file. An empty file counts too, because it contains nothing to lose.
bool is_own(const fs::path& file, const Known& known)
{
  constexpr std::streamoff most = 1 << 16; // all marks are within so many bytes of the beginning or end
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    return false;
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream ? static_cast<std::streamoff>(stream.tellg()) : -1;
  if (size <= 0)
    return size == 0;
  const std::string head = read_part(stream, 0, std::min(size, most));
  const std::string tail = read_part(stream, std::max<std::streamoff>(0, size - most), std::min(size, most));
  return stream && head.starts_with(known.begin) && head.find(known.within) != head.npos &&
         tail.find(known.end) != tail.npos;
}

/// Whether it is the name of a piece: 000012.h5 or final.h5, also with .part, which remains if a process is killed while writing.
bool is_piece(const std::string& name)
{
  static const Pattern piece_name(R"((final|[0-9]{6,})\.h5(\.part)?)");
  return piece_name.match(name).has_value();
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

/// Whether a folder contains at least two recognisable files of a run. Then damaged files in it belong to the run, too.
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

/// Files that a run would remove or replace although no run has written them.
std::vector<std::string> foreign_files(const fs::path& folder)
{
  std::vector<std::string> names;
  if (is_of_a_run(folder))
    return names;
  const auto check = [&](const std::string& name, const Known& known)
  {
    if (is_there(folder / name) && !is_own(folder / name, known))
      names.push_back(name);
  };
  for (const Known& known : known_files)
  {
    check(std::string(known.name), known);
    check(fmt::format("{}.part", known.name), known);
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

bool has_earlier_result(const fs::path& folder)
{
  return !pieces_in(folder).empty() ||
         std::ranges::any_of(known_files, [&](const Known& known) { return is_there(folder / known.name); });
}

bool remove_earlier_result(const fs::path& folder)
{
  if (const auto foreign = foreign_files(folder); !foreign.empty())
    throw InputError(
        fmt::format("{}: holds other files: {}. A run writes files with these names, but these files were not written "
                    "by a run of brinell: move them away, or choose another folder (-o, output.directory)",
                    folder.string(), fmt::join(foreign, ", ")));
  bool found = false;
  for (const Known& known : known_files)
  {
    found = removed(folder / known.name) || found;
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
