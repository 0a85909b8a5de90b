// SPDX-License-Identifier: BSD-3-Clause
#include "result_file.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/citations.hpp"
#include "brinell/io/versions.hpp"
#include "checksum.hpp"
#include "earlier_result.hpp"
#include "hdf5.hpp"
#include "read_file.hpp"
#include "replace_file.hpp"
#include "result_fields.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace brinell::io
{

namespace
{

namespace fs = std::filesystem;

constexpr int format_version = 2;
constexpr const char* file_name = "result.vtkhdf";
constexpr const char* piece_group = "state";
constexpr std::ptrdiff_t most_shown = 30; ///< states in /VTKHDF of an unfinished file, which is written anew for each

using Json = nlohmann::json;

Json json_of(const BodyLayout& body)
{
  const SurfaceGrid& s = body.grid.surface;
  return {{"cells", {s.nx, s.ny, body.grid.nz}},
          {"spacing", {s.dx, s.dy, body.grid.dz}},
          {"origin", {body.x0, body.y0}},
          {"has_residual_displacement", body.has_residual_displacement},
          {"has_plastic_strain", body.has_plastic_strain},
          {"has_stress", body.has_stress}};
}

BodyLayout body_of(const Json& json)
{
  const auto cells = json.at("cells").get<std::array<int, 3>>();
  const auto spacing = json.at("spacing").get<std::array<double, 3>>();
  return {.grid = {{cells[0], cells[1], spacing[0], spacing[1]}, cells[2], spacing[2]},
          .x0 = json.at("origin").at(0),
          .y0 = json.at("origin").at(1),
          .has_residual_displacement = json.at("has_residual_displacement"),
          .has_plastic_strain = json.at("has_plastic_strain"),
          .has_stress = json.at("has_stress")};
}

Json json_of(const StateLayout& layout)
{
  const ContactLayout& c = layout.contact;
  return {
      {"lower", json_of(layout.lower)}, {"upper", json_of(layout.upper)}, {"contact", {c.nx, c.ny, c.column, c.row}}};
}

StateLayout state_of(const Json& json)
{
  const auto contact = json.at("contact").get<std::array<int, 4>>();
  return {body_of(json.at("lower")), body_of(json.at("upper")), {contact[0], contact[1], contact[2], contact[3]}};
}

void write_history(const h5::Handle& file, const std::vector<HistoryColumn>& history)
{
  const h5::Handle group = h5::create_ordered_group(file, "history");
  for (const HistoryColumn& column : history)
  {
    if (column.values.empty())
      continue; // no step is finished yet
    const std::string name(column.name);
    const std::array shape{column.values.size()};
    if (column.is_integer)
      h5::write_dataset(group, name.c_str(), std::vector<int>(column.values.begin(), column.values.end()), shape,
                        column.unit, column.text);
    else
      h5::write_dataset(group, name.c_str(), column.values, shape, column.unit, column.text);
  }
}

void rename_file(const fs::path& from, const fs::path& to)
{
  std::error_code error;
  fs::rename(from, to, error);
  if (error)
    throw IoError(fmt::format("{}: cannot be written: {}", to.string(), error.message()));
}

IoError damaged(const fs::path& path)
{
  return IoError(fmt::format("{}: is damaged; run without --resume", path.string()));
}

fs::path part_of(fs::path path)
{
  return path += ".part";
}

} // namespace

ResultFile::ResultFile(fs::path folder, const Case& c, int finished_steps, const std::vector<HistoryColumn>& history)
    : folder_(std::move(folder)), case_text_(resolved_text(c.values)),
      sources_(fmt::format("{}\n", fmt::join(citation_lines(c), "\n"))),
      scenario_(c.values.get<std::string>("scenario")), title_(c.title), history_(history)
{
  if (finished_steps > 0)
    read_index(finished_steps);
  write_linked();
}

ResultFile::Piece ResultFile::piece_of(int step)
{
  const std::string name = fmt::format("{:06}", step);
  return {name + ".h5", "/steps/" + name, static_cast<double>(step)};
}

fs::path ResultFile::path_of(const Piece& piece) const
{
  return folder_ / pieces_folder / piece.file;
}

void ResultFile::add_step(int step, const std::vector<NamedNumber>& columns, const simulation::Snapshot& snapshot)
{
  add(snapshot, columns, piece_of(step));
}

void ResultFile::add_final(int step, const std::vector<NamedNumber>& columns, const simulation::Snapshot& snapshot)
{
  add(snapshot, columns, {final_piece, "/final", step + 1.0});
}

void ResultFile::add(const simulation::Snapshot& snapshot, const std::vector<NamedNumber>& columns, Piece piece)
{
  std::error_code error;
  fs::create_directories(folder_ / pieces_folder, error); // a failure shows when the file is created
  h5::Handle file = h5::create_file_in_memory();
  write_snapshot(h5::create_group(file, piece_group), columns, snapshot);
  const std::string image = h5::file_image(std::move(file));
  piece.checksum = checksum(image);
  replace_file(path_of(piece), image);
  piece.layout = layout_of(snapshot);
  pieces_.push_back(std::move(piece));
  write_index();
  write_linked();
}

/// The pieces with what /VTKHDF needs to know of them, for a run that goes on later.
void ResultFile::write_index() const
{
  Json index = Json::array();
  for (const Piece& piece : pieces_)
    index.push_back({{"file", piece.file},
                     {"step", static_cast<int>(piece.time)},
                     {"layout", json_of(piece.layout)},
                     {"checksum", piece.checksum}});
  const std::string sum = checksum(index.dump());
  const Json whole = {{"format", index_mark}, {"checksum", sum}, {"pieces", std::move(index)}};
  replace_file(folder_ / pieces_folder / index_file, whole.dump());
}

void ResultFile::read_index(int finished_steps)
{
  const fs::path path = folder_ / pieces_folder / index_file;
  if (!fs::exists(path)) // no step has been stored yet
    return;
  try
  {
    const Json whole = Json::parse(input_text(path));
    const Json& index = whole.at("pieces");
    if (whole.at("format") != index_mark || whole.at("checksum") != checksum(index.dump()))
      throw damaged(path);
    for (const Json& entry : index)
    {
      Piece piece = piece_of(entry.at("step"));
      piece.layout = state_of(entry.at("layout"));
      piece.checksum = entry.at("checksum");
      if (piece.time < finished_steps && entry.at("file") == piece.file) // not the final state
        pieces_.push_back(std::move(piece));
    }
  }
  catch (const Json::exception&)
  {
    throw damaged(path);
  }
  catch (const InputError&) // no regular file
  {
    throw damaged(path);
  }
  for (const Piece& piece : pieces_)
    require_intact(piece);
}

/// @throws IoError if the piece is not as it was written
void ResultFile::require_intact(const Piece& piece) const
{
  std::string sum;
  try
  {
    sum = file_checksum(path_of(piece));
  }
  catch (const InputError& error)
  {
    throw IoError(fmt::format("{}: {}; run without --resume", path_of(piece).string(), error.what()));
  }
  if (sum != piece.checksum)
    throw damaged(path_of(piece));
}

/// HDF5 crashes when a full disk does not let it close a file: better to know before.
void ResultFile::require_space() const
{
  std::uintmax_t needed = 0;
  std::error_code error;
  for (const Piece& piece : pieces_)
  {
    const std::uintmax_t size = fs::file_size(path_of(piece), error);
    needed += error ? 0 : size;
  }
  const fs::space_info space = fs::space(folder_, error);
  if (!error && space.available < needed)
    throw IoError(
        fmt::format("{}: cannot be written: it needs {:.1f} MB, the disk has {:.1f} MB; the finished steps are "
                    "in {}",
                    (folder_ / file_name).string(), static_cast<double>(needed) * 1e-6,
                    static_cast<double>(space.available) * 1e-6, (folder_ / pieces_folder).string()));
}

/// What a result file holds besides the fields.
void ResultFile::write_description(const h5::Handle& file) const
{
  const Versions versions = library_versions();
  h5::write_attribute(file, "format", "brinell-result");
  h5::write_attribute(file, "format_version", format_version);
  h5::write_attribute(file, "brinell_version", versions.brinell);
  h5::write_attribute(file, "git_hash", versions.git_hash);
  h5::write_attribute(file, "fftw_version", versions.fftw);
  h5::write_attribute(file, "hdf5_version", versions.hdf5);
  h5::write_attribute(file, "scenario", scenario_);
  h5::write_attribute(file, "title", title_);
  h5::write_attribute(file, "created", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))));
  h5::write_text(file, "case", case_text_);
  h5::write_text(file, "sources", sources_);
  write_history(file, history_);
}

/// Writes result.vtkhdf anew, with links to the pieces. Its cost must grow little with each of them: thirty in /VTKHDF take
/// some 15 ms, a plain link or a row of the history some microseconds.
void ResultFile::write_linked() const
{
  h5::Handle file = h5::create_file_in_memory();
  write_description(file);
  std::vector<StoredState> states;
  {
    // The group must be closed before the file is.
    const h5::Handle steps = h5::create_group(file, "steps");
    for (const Piece& piece : pieces_)
    {
      states.push_back(
          {piece.time, fmt::format("{}/{}", pieces_folder, piece.file), fmt::format("/{}", piece_group), piece.layout});
      h5::link_external(file, piece.group, states.back().file, states.back().group);
    }
  }
  if (std::ssize(states) > most_shown)
    states.erase(states.begin(), states.end() - most_shown);
  write_vtkhdf(file, states);
  replace_file(folder_ / file_name, h5::file_image(std::move(file)));
}

/// Writes result.vtkhdf anew, with the content of the pieces.
void ResultFile::merge(const std::string& summary)
{
  require_space();
  const fs::path path = folder_ / file_name;
  h5::Handle file = h5::create_file(part_of(path));
  write_description(file);
  h5::write_text(file, "summary", summary);
  std::vector<StoredState> states;
  {
    const h5::Handle steps = h5::create_group(file, "steps");
    for (const Piece& piece : pieces_)
    {
      require_intact(piece); // it is copied as it is
      states.push_back({piece.time, ".", piece.group, piece.layout});
      h5::copy_group(h5::open_file(path_of(piece)), piece_group, file, piece.group);
    }
  }
  write_vtkhdf(file, states);
  h5::close_file(std::move(file));
  {
    const h5::Handle written = h5::open_file(part_of(path));
    for (const Piece& piece : pieces_)
      h5::require_same_datasets(h5::open_group(h5::open_file(path_of(piece)), piece_group),
                                h5::open_group(written, piece.group));
  }
  rename_file(part_of(path), path);
}

} // namespace brinell::io
