// SPDX-License-Identifier: BSD-3-Clause
#include "result_file.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/citations.hpp"
#include "brinell/io/result_image.hpp"
#include "brinell/io/versions.hpp"
#include "earlier_result.hpp"
#include "hdf5.hpp"
#include "io/files.hpp"
#include "stored_parts.hpp"
#include "stored_state.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>

namespace brinell::io
{

namespace
{

namespace fs = std::filesystem;
using simulation::StepFields;

constexpr const char* file_name = "result.vtkhdf";
constexpr const char *piece_group = "state", *final_group = "/final";
constexpr std::size_t most_shown =
    30; ///< number of states in /VTKHDF of an unfinished file, which is rewritten after each state

/// Upper bound for the size of the file of a state [bytes], with more fields than there are and without compression.
std::uintmax_t largest_size(const StepFields& fields)
{
  constexpr std::size_t in_cell = 16, on_surface = 8, in_contact = 16, around = 1 << 18;
  std::size_t numbers = in_contact * fields.surfaces.contact.size();
  for (const simulation::BodySnapshot* body : {&fields.surfaces.lower, &fields.surfaces.upper})
    numbers += in_cell * body->grid.size() + on_surface * body->grid.surface.size();
  return numbers * sizeof(double) + around;
}

/// Writes a table as a group of columns.
void write_table(const h5::Handle& file, const char* name_of_table, const std::vector<HistoryColumn>& history,
                 Place place)
{
  const h5::Storage storage = storage_of(place, h5::Storage::deflated);
  const h5::Handle group = h5::create_ordered_group(file, name_of_table);
  for (const HistoryColumn& column : history)
  {
    if (column.values.empty())
      continue; // no step is finished yet
    const std::string name(column.name);
    const std::array shape{column.values.size()};
    if (column.is_integer)
      h5::write_dataset(group, name.c_str(), std::vector<int>(column.values.begin(), column.values.end()), shape,
                        column.unit, column.text, storage);
    else
      h5::write_dataset(group, name.c_str(), column.values, shape, column.unit, column.text, storage);
  }
}

/// Writes the content of a result file other than the fields.
/// @param points  histories of points; nullptr: there are none
void write_description(const h5::Handle& file, const Description& description,
                       const std::vector<HistoryColumn>& history, const std::vector<HistoryColumn>* points,
                       Place place = Place::disk)
{
  const Versions versions = library_versions();
  h5::write_attribute(file, "format", "brinell-result");
  h5::write_attribute(file, "format_version", format_version);
  h5::write_attribute(file, "brinell_version", versions.brinell);
  h5::write_attribute(file, "git_hash", versions.git_hash);
  h5::write_attribute(file, "hdf5_version", versions.hdf5);
  h5::write_attribute(file, "processor", versions.processor);
  h5::write_attribute(file, "scenario", description.scenario);
  h5::write_attribute(file, "title", description.title);
  h5::write_attribute(file, "created", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))));
  h5::write_text(file, "case", description.case_text);
  h5::write_text(file, "sources", description.sources);
  write_table(file, "history", history, place);
  if (points != nullptr)
    write_table(file, "points", *points, place);
}

std::string group_of_step(int step)
{
  return fmt::format("/steps/{:06}", step);
}

} // namespace

Description::Description(const Case& c)
    : case_text(resolved_text(c.values)), sources(fmt::format("{}\n", fmt::join(citation_lines(c), "\n"))),
      scenario(c.values.get<std::string>("scenario")), title(c.title)
{
}

void ResultFile::Piece::exchange(Archive& archive)
{
  archive("step", step, 0, std::numeric_limits<int>::max());
  layout.exchange(archive);
}

std::string ResultFile::Piece::file() const
{
  return is_final ? final_piece : fmt::format("{:06}.h5", step);
}

std::string ResultFile::Piece::group() const
{
  return is_final ? final_group : group_of_step(step);
}

ResultFile::ResultFile(fs::path folder, const Case& c, StoredParts parts, const std::vector<HistoryColumn>& history,
                       const Archive::Fields* checkpoint)
    : folder_(std::move(folder)), description_(c), parts_(std::move(parts)), history_(history)
{
  if (checkpoint)
  {
    Archive archive(*checkpoint);
    archive("result", *this);
  }
  for (const Piece& piece : pieces_)
    require_seal(path_of(piece), piece_mark);
  write_linked();
}

fs::path ResultFile::path_of(const Piece& piece) const
{
  return folder_ / pieces_folder / piece.file();
}

void ResultFile::add_step(int step, const std::vector<NamedNumber>& columns, const StepFields& fields)
{
  add({step, false}, columns, fields);
}

void ResultFile::add_final(int step, const std::vector<NamedNumber>& columns, const StepFields& fields)
{
  add({step, true}, columns, fields);
}

void ResultFile::add(Piece piece, const std::vector<NamedNumber>& columns, const StepFields& whole)
{
  const StepFields fields = chosen_fields(whole, piece.is_final ? parts_.in_final : parts_.in_steps, parts_);
  std::error_code error;
  fs::create_directories(folder_ / pieces_folder, error); // an error is reported when the file is created
  Replacement replacement(path_of(piece));
  replacement.require_room(largest_size(fields));
  h5::Handle file = h5::create_file(replacement.part());
  write_state(h5::create_group(file, piece_group), columns, fields, {Place::disk, parts_.precision});
  h5::close_file(std::move(file));
  replacement.seal(piece_mark);
  replacement.commit();
  piece.layout = layout_of(fields, parts_.precision);
  pieces_.push_back(piece);
  if (!piece.is_final) // after the final state, the pieces are merged
    write_linked();
}

std::uintmax_t ResultFile::size_of_pieces() const
{
  std::uintmax_t sum = 0;
  for (const Piece& piece : pieces_)
  {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path_of(piece), error);
    sum += error ? 0 : size;
  }
  return sum;
}

/// Rewrites result.vtkhdf with links to the pieces. The cost must grow little with their number: thirty states in /VTKHDF take
/// about 15 ms, a plain link or a row of the history some microseconds.
void ResultFile::write_linked() const
{
  constexpr std::size_t growth = 1 << 16; // small, because HDF5 clears the memory
  h5::Handle file = h5::create_file_in_memory(growth);
  write_description(file, description_, history_, points_,
                    Place::memory); // uncompressed, because compressing the history took most of the time
  std::vector<StoredState> states;
  {
    // The group must be closed before the file is.
    const h5::Handle steps = h5::create_group(file, "steps");
    for (const Piece& piece : pieces_)
    {
      const std::string name = fmt::format("{}/{}", pieces_folder, piece.file());
      const std::string group = fmt::format("/{}", piece_group);
      h5::link_external(file, piece.group(), name, group);
      states.push_back({piece.time(), name, group, piece.layout});
    }
  }
  if (states.size() > most_shown)
    states.erase(states.begin(), states.end() - most_shown);
  write_vtkhdf(file, states);
  replace_file(folder_ / file_name, h5::file_image(std::move(file)));
}

void ResultFile::merge(const std::string& summary)
{
  try
  {
    write_merged(summary);
  }
  catch (...)
  {
    write_linked(); // includes the last piece
    throw;
  }
}

/// Rewrites result.vtkhdf with the content of the pieces.
void ResultFile::write_merged(const std::string& summary) const
{
  Replacement replacement(folder_ / file_name);
  replacement.require_room(size_of_pieces());
  h5::Handle file = h5::create_file(replacement.part());
  write_description(file, description_, history_, points_);
  h5::write_text(file, "summary", summary);
  std::vector<StoredState> states;
  {
    const h5::Handle steps = h5::create_group(file, "steps");
    for (const Piece& piece : pieces_)
    {
      require_seal(path_of(piece), piece_mark); // copied without another check
      states.push_back({piece.time(), ".", piece.group(), piece.layout});
      h5::copy_object(h5::open_file(path_of(piece)), piece_group, file, piece.group());
    }
  }
  write_vtkhdf(file, states);
  h5::close_file(std::move(file));
  {
    const h5::Handle written = h5::open_file(replacement.part());
    for (const Piece& piece : pieces_)
      h5::require_same_datasets(h5::open_group(h5::open_file(path_of(piece)), piece_group),
                                h5::open_group(written, piece.group()));
  }
  replacement.commit();
}

struct ResultImage::State
{
  State(const Case& c, StoredParts stored) : description(c), parts(std::move(stored))
  {
    (void)h5::create_group(file, "steps");
  }

  void add(const std::string& name, const std::vector<NamedNumber>& columns, const StepFields& fields,
           const std::vector<std::string>& words) const
  {
    write_state(h5::create_group(file, name), columns, chosen_fields(fields, words, parts),
                {Place::memory, parts.precision});
  }

  Description description;
  StoredParts parts;
  std::vector<HistoryColumn> history{}, points{};
  h5::Handle file = h5::create_file_in_memory();
};

ResultImage::ResultImage(const Case& c, StoredParts parts) : state_(std::make_unique<State>(c, std::move(parts))) {}
ResultImage::~ResultImage() = default;
ResultImage::ResultImage(ResultImage&&) noexcept = default;
ResultImage& ResultImage::operator=(ResultImage&&) noexcept = default;

void ResultImage::add(const std::vector<NamedNumber>& columns)
{
  add_row(state_->history, columns);
}

void ResultImage::add_point(const std::vector<NamedNumber>& row)
{
  add_row(state_->points, row);
}

void ResultImage::add(int step, const std::vector<NamedNumber>& columns, const StepFields& fields)
{
  state_->add(group_of_step(step), columns, fields, state_->parts.in_steps);
}

void ResultImage::add_final(const StepFields& final_state, const std::vector<NamedNumber>& last_columns)
{
  state_->add(final_group, last_columns, final_state, state_->parts.in_final);
}

void ResultImage::finish(const std::string& summary)
{
  write_description(state_->file, state_->description, state_->history,
                    state_->points.empty() ? nullptr : &state_->points, Place::memory);
  h5::write_text(state_->file, "summary", summary);
}

std::string ResultImage::bytes() &&
{
  return h5::file_image(std::move(state_->file));
}

} // namespace brinell::io
