// SPDX-License-Identifier: BSD-3-Clause
#include "result_file.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/result_directory.hpp"
#include "brinell/io/versions.hpp"
#include "hdf5.hpp"
#include "result_fields.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>

namespace brinell::io
{

namespace
{

namespace fs = std::filesystem;

constexpr int format_version = 1;
constexpr const char* file_name = "result.h5";
constexpr const char* pieces_folder = "snapshots";
constexpr const char* piece_group = "state";

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

ResultFile::ResultFile(fs::path folder, const Case& c)
    : m_folder(std::move(folder)), m_case_text(resolved_text(c.values)),
      m_scenario(c.values.get<std::string>("scenario")), m_title(c.title)
{
  write_result(true);
}

void ResultFile::add_step(const simulation::Snapshot& snapshot)
{
  const std::string name = fmt::format("{:06}", snapshot.record.step);
  m_last_time = snapshot.record.step;
  add(snapshot, {name + ".h5", "/steps/" + name}, m_last_time);
}

void ResultFile::add_final(const simulation::Snapshot& snapshot)
{
  add(snapshot, {"final.h5", "/final"}, std::max(m_last_time, static_cast<double>(snapshot.record.step)) + 1.0);
}

void ResultFile::add(const simulation::Snapshot& snapshot, const Piece& piece, double time)
{
  const fs::path path = m_folder / pieces_folder / piece.file;
  std::error_code error;
  fs::create_directories(path.parent_path(), error); // a failure shows when the file is created
  h5::Handle file = h5::create_file(part_of(path));
  write_snapshot(h5::create_group(file, piece_group), snapshot);
  h5::close_file(std::move(file));
  rename_file(part_of(path), path);
  m_pieces.push_back(piece);
  m_contact.push_back({time, {contact_grid(snapshot, piece.group + "/contact")}});
  m_lower.push_back({time, body_grids(snapshot.lower, piece.group + "/lower")});
  m_upper.push_back({time, body_grids(snapshot.upper, piece.group + "/upper")});
  write_result(true);
  write_xdmf();
}

/// Writes result.h5 anew: with links to the pieces, or with their content.
void ResultFile::write_result(bool linked) const
{
  const fs::path path = m_folder / file_name;
  h5::Handle file = h5::create_file(part_of(path));
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
  h5::close_file(std::move(file));
  rename_file(part_of(path), path);
}

void ResultFile::write_xdmf() const
{
  replace_file(m_folder / "contact.xdmf", xdmf_text(file_name, m_contact));
  replace_file(m_folder / "lower.xdmf", xdmf_text(file_name, m_lower));
  replace_file(m_folder / "upper.xdmf", xdmf_text(file_name, m_upper));
}

void ResultFile::merge()
{
  write_result(false);
  std::error_code error; // pieces that stay behind do no harm
  fs::remove_all(m_folder / pieces_folder, error);
}

} // namespace brinell::io
