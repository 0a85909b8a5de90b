// SPDX-License-Identifier: BSD-3-Clause
#include "result_file.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/versions.hpp"
#include "hdf5.hpp"
#include "replace_file.hpp"
#include "result_fields.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

namespace brinell::io
{

namespace
{

namespace fs = std::filesystem;

constexpr int format_version = 1;
constexpr const char* file_name = "result.h5";
constexpr const char* pieces_folder = "snapshots";
constexpr const char* piece_group = "state";
constexpr const char* index_file = "index.json";

using Json = nlohmann::json;

Json grids_json(const std::vector<XdmfGrid>& grids)
{
  Json result = Json::array();
  for (const XdmfGrid& grid : grids)
  {
    const SurfaceGrid& s = grid.cells.surface;
    Json fields = Json::array();
    for (const auto& field : grid.fields)
      fields.push_back({field.name, field.dataset});
    result.push_back({{"name", grid.name},
                      {"group", grid.group},
                      {"cells", {s.nx, s.ny, grid.cells.nz}},
                      {"spacing", {s.dx, s.dy, grid.cells.dz}},
                      {"origin", {grid.x0, grid.y0}},
                      {"fields", fields}});
  }
  return result;
}

std::vector<XdmfGrid> grids(const Json& json)
{
  std::vector<XdmfGrid> result;
  for (const Json& grid : json)
  {
    const auto cells = grid["cells"].get<std::array<int, 3>>();
    const auto spacing = grid["spacing"].get<std::array<double, 3>>();
    XdmfGrid g{.name = grid["name"],
               .group = grid["group"],
               .cells = {{cells[0], cells[1], spacing[0], spacing[1]}, cells[2], spacing[2]},
               .x0 = grid["origin"][0],
               .y0 = grid["origin"][1]};
    for (const Json& field : grid["fields"])
      g.fields.push_back({field[0], field[1]});
    result.push_back(std::move(g));
  }
  return result;
}

void rename_file(const fs::path& from, const fs::path& to)
{
  std::error_code error;
  fs::rename(from, to, error);
  if (error)
    throw IoError(fmt::format("{}: cannot be written: {}", to.string(), error.message()));
}

fs::path part_of(fs::path path)
{
  return path += ".part";
}

} // namespace

ResultFile::ResultFile(fs::path folder, const Case& c, int finished_steps)
    : m_folder(std::move(folder)), m_case_text(resolved_text(c.values)),
      m_scenario(c.values.get<std::string>("scenario")), m_title(c.title)
{
  if (finished_steps > 0)
    read_index(finished_steps);
  write_result(true);
}

void ResultFile::add_step(int step, const std::vector<NamedNumber>& columns, const simulation::Snapshot& snapshot)
{
  const std::string name = fmt::format("{:06}", step);
  add(snapshot, columns, {name + ".h5", "/steps/" + name, static_cast<double>(step)});
}

void ResultFile::add_final(int step, const std::vector<NamedNumber>& columns, const simulation::Snapshot& snapshot)
{
  add(snapshot, columns, {"final.h5", "/final", step + 1.0});
}

void ResultFile::add(const simulation::Snapshot& snapshot, const std::vector<NamedNumber>& columns, Piece piece)
{
  const fs::path path = m_folder / pieces_folder / piece.file;
  std::error_code error;
  fs::create_directories(path.parent_path(), error); // a failure shows when the file is created
  h5::Handle file = h5::create_file_in_memory();
  write_snapshot(h5::create_group(file, piece_group), columns, snapshot);
  h5::save_file(std::move(file), path);
  piece.contact = {contact_grid(snapshot, piece.group + "/contact")};
  piece.lower = body_grids(snapshot.lower, piece.group + "/lower");
  piece.upper = body_grids(snapshot.upper, piece.group + "/upper");
  m_pieces.push_back(std::move(piece));
  write_index();
  write_result(true);
  write_xdmf();
}

/// The pieces with what XDMF needs to know of them, for a run that goes on later.
void ResultFile::write_index() const
{
  Json index = Json::array();
  for (const Piece& piece : m_pieces)
    index.push_back({{"file", piece.file},
                     {"group", piece.group},
                     {"time", piece.time},
                     {"contact", grids_json(piece.contact)},
                     {"lower", grids_json(piece.lower)},
                     {"upper", grids_json(piece.upper)}});
  replace_file(m_folder / pieces_folder / index_file, index.dump());
}

void ResultFile::read_index(int finished_steps)
{
  std::ifstream stream(m_folder / pieces_folder / index_file);
  if (!stream) // no step has been stored yet
    return;
  const Json index = Json::parse(stream, nullptr, false);
  if (index.is_discarded())
    throw IoError(
        fmt::format("{}: is damaged; run without --resume", (m_folder / pieces_folder / index_file).string()));
  for (const Json& piece : index)
    if (piece["time"].get<double>() < finished_steps && piece["file"] != "final.h5")
      m_pieces.push_back({piece["file"], piece["group"], piece["time"], grids(piece["contact"]), grids(piece["lower"]),
                          grids(piece["upper"])});
}

/// HDF5 crashes when a full disk does not let it close a file: better to know before.
void ResultFile::require_space() const
{
  std::uintmax_t needed = 0;
  std::error_code error;
  for (const Piece& piece : m_pieces)
    needed += fs::file_size(m_folder / pieces_folder / piece.file, error);
  const fs::space_info space = fs::space(m_folder, error);
  if (!error && space.available < needed)
    throw IoError(
        fmt::format("{}: cannot be written: it needs {:.1f} MB, the disk has {:.1f} MB; the finished steps are "
                    "in {}",
                    (m_folder / file_name).string(), static_cast<double>(needed) * 1e-6,
                    static_cast<double>(space.available) * 1e-6, (m_folder / pieces_folder).string()));
}

/// Writes result.h5 anew: with links to the pieces, or with their content.
void ResultFile::write_result(bool linked) const
{
  const fs::path path = m_folder / file_name;
  h5::Handle file = linked ? h5::create_file_in_memory() : h5::create_file(part_of(path));
  const Versions versions = library_versions();
  h5::write_attribute(file, "format", "brinell-result");
  h5::write_attribute(file, "format_version", format_version);
  h5::write_attribute(file, "brinell_version", versions.brinell);
  h5::write_attribute(file, "git_hash", versions.git_hash);
  h5::write_attribute(file, "scenario", m_scenario);
  h5::write_attribute(file, "title", m_title);
  h5::write_attribute(file, "created", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))));
  h5::write_attribute(file, "case", m_case_text);
  {
    // The group must be closed before the file is.
    const h5::Handle steps = h5::create_group(file, "steps");
    for (const Piece& piece : m_pieces)
    {
      const std::string piece_path = fmt::format("{}/{}", pieces_folder, piece.file);
      if (linked)
        h5::link_external(file, piece.group, piece_path, fmt::format("/{}", piece_group));
      else
        h5::copy_group(h5::open_file(m_folder / piece_path), piece_group, file, piece.group);
    }
  }
  if (linked)
    return h5::save_file(std::move(file), path);
  h5::close_file(std::move(file));
  rename_file(part_of(path), path);
}

void ResultFile::write_xdmf() const
{
  for (const auto& [name, member] :
       {std::pair{"contact.xdmf", &Piece::contact}, {"lower.xdmf", &Piece::lower}, {"upper.xdmf", &Piece::upper}})
  {
    std::vector<XdmfTime> times;
    for (const Piece& piece : m_pieces)
      times.push_back({piece.time, piece.*member});
    replace_file(m_folder / name, xdmf_text(file_name, times));
  }
}

void ResultFile::merge()
{
  require_space();
  write_result(false);
}

void ResultFile::remove_pieces() const
{
  std::error_code error; // pieces that stay behind do no harm
  fs::remove_all(m_folder / pieces_folder, error);
}

} // namespace brinell::io
