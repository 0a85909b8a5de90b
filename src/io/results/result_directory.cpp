// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/result_directory.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/point_history.hpp"
#include "brinell/io/versions.hpp"
#include "case_difference.hpp"
#include "earlier_result.hpp"
#include "hdf5.hpp"
#include "io/files.hpp"
#include "result_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace brinell::io
{

namespace
{

namespace fs = std::filesystem;

/// Locks a folder for this process; the lock ends with the process, even if it is killed.
class FolderLock
{
public:
  explicit FolderLock(const fs::path& folder) : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
  {
    // Not every file system has locks; only a lock that somebody holds is an error.
    if (descriptor_ >= 0 && flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    {
      close(descriptor_);
      throw IoError(
          fmt::format("{}: another run is writing its results there; choose another folder with -o", folder.string()));
    }
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock()
  {
    if (descriptor_ >= 0)
      close(descriptor_);
  }

private:
  int descriptor_;
};

fs::path made_folder(const fs::path& path)
{
  std::error_code error;
  fs::create_directories(path, error);
  if (error || !fs::is_directory(path))
    throw IoError(fmt::format("{}: the folder for the results cannot be made{}{}", path.string(), error ? ": " : "",
                              error ? error.message() : ""));
  return path;
}

/// Identifies the build, because a checkpoint of another build may lead to other digits or have another state.
std::string program()
{
  const Versions versions = library_versions();
  return versions.brinell + " " + versions.git_hash;
}

/// Writes a checkpoint field by field, so that no copy of the state is kept in memory.
/// @param of_case  the resolved case
void write_checkpoint(const fs::path& path, const std::string& of_case, const std::function<void(Archive&)>& state)
{
  constexpr std::size_t around = 1 << 18, around_a_field = 1 << 10; // bytes
  std::size_t size = around + of_case.size();
  Archive sizes([&](const std::string&, std::span<const double> values)
                { size += around_a_field + values.size_bytes(); },
                [&](const std::string&, std::size_t of_all, std::size_t first, std::span<const double>)
                { size += first == 0 ? around_a_field + of_all * sizeof(double) : 0; });
  state(sizes);
  Replacement replacement(path);
  replacement.require_room(size);
  h5::Handle file = h5::create_file(replacement.part());
  h5::write_attribute(file, "program", program());
  h5::write_attribute(file, "case", of_case);
  std::optional<h5::Handle> dataset; // of which parts are written
  Archive written([&](const std::string& name, std::span<const double> values)
                  { h5::write_numbers(file, name, values); },
                  [&](const std::string& name, std::size_t of_all, std::size_t first, std::span<const double> values)
                  {
                    if (first == 0)
                      dataset = h5::create_numbers(file, name, of_all);
                    h5::write_part(*dataset, first, values);
                  });
  state(written);
  dataset.reset(); // an open dataset would keep the file open
  h5::close_file(std::move(file));
  replacement.seal(checkpoint_mark);
  replacement.commit();
}

/// Large fields are left in the file until they are asked for.
Archive::Fields content_of_checkpoint(const fs::path& path, const std::string& of_case)
{
  constexpr std::size_t large = std::size_t{1} << 17; // 1 MB
  const auto kept_open = std::make_shared<const h5::Handle>(h5::open_file(path));
  const h5::Handle& file = *kept_open;
  if (const std::string written_by = h5::read_text_attribute(file, "program"); written_by != program())
    throw InputError(fmt::format("{}: was written by brinell {}, this is {}; resume with that program, or run without "
                                 "--resume",
                                 path.string(), written_by, program()));
  // The case of the folder is the same; the file may have come from elsewhere.
  if (const std::string difference = case_difference(h5::read_text_attribute(file, "case"), of_case);
      !difference.empty())
    throw InputError(fmt::format("{}: is of another case: {}; run without --resume", path.string(), difference));
  Archive::Fields fields;
  for (const std::string& name : h5::names(file))
    if (const std::size_t size = h5::count_of_numbers(file, name); size < large || Archive::is_member_of_list(name))
      fields[name] = h5::read_numbers(file, name);
    else
      fields.left[name] = size;
  fields.read = [kept_open](const std::string& name, std::size_t first, std::span<double> values)
  { h5::read_part(*kept_open, name, first, values); };
  return fields;
}

/// Reads a checkpoint. Its seal is checked before HDF5 opens it, because HDF5 does not protect itself against damaged files.
std::optional<Archive::Fields> read_checkpoint(const fs::path& path, const std::string& of_case)
{
  if (!fs::exists(path))
    return std::nullopt;
  require_seal(path, checkpoint_mark);
  try
  {
    return content_of_checkpoint(path, of_case);
  }
  catch (const IoError& error)
  {
    const std::string text = error.what();
    throw text.starts_with(path.string()) ? error : damaged_file(path, text);
  }
}

InputError nothing_to_resume(const fs::path& folder)
{
  return InputError(fmt::format("{}: there is no stopped run in this folder that could be resumed", folder.string()));
}

/// The checkpoint from which a run can resume; none if it was stopped before the first one.
std::optional<Archive::Fields> resumable(const fs::path& folder, const Case& c)
{
  const bool is_complete = fs::exists(folder / "summary.json");
  if (!fs::is_regular_file(folder / "resolved.toml"))
  {
    if (!is_complete)
      throw nothing_to_resume(folder);
    throw InputError(fmt::format("{}: the run there is complete, there is nothing to resume", folder.string()));
  }
  const std::string text = input_text(folder / "resolved.toml", std::numeric_limits<std::size_t>::max());
  const std::string asked = resolved_files(c.values).text;
  if (const std::string difference = case_difference(text, asked); !difference.empty())
  {
    if (!is_complete) // first check the program: in another version, keys may have other names
      static_cast<void>(read_checkpoint(folder / checkpoint_file, text));
    throw InputError(fmt::format("{}: the run {} there is of another case: {}; without --resume it is replaced",
                                 folder.string(), is_complete ? "that is complete" : "that was stopped", difference));
  }
  if (is_complete)
    throw InputError(fmt::format("{}: the run there is complete, there is nothing to resume", folder.string()));
  return read_checkpoint(folder / checkpoint_file, asked);
}

/// The columns of the history of a scenario.
std::vector<NamedNumber> columns_of(const Scenario& scenario)
{
  return std::visit([]<typename ScenarioCase>(const ScenarioCase&) { return columns(typename ScenarioCase::Record{}); },
                    scenario);
}

} // namespace

struct ResultDirectory::State
{
  State(const fs::path& folder, const Case& c, StoredParts parts, Mode mode)
      : path(mode == Mode::resume && !fs::exists(folder) ? throw nothing_to_resume(folder) : made_folder(folder)),
        lock(path), of_case(resolved_files(c.values).text), checkpoint(checkpoint_to_resume(path, c, mode)),
        replaced(!checkpoint && removed_earlier_result(path, mode) && mode == Mode::replace),
        history(path / "history.csv", columns_of(c.scenario), checkpoint ? &*checkpoint : nullptr),
        result(path, c, std::move(parts), history.columns(), checkpoint ? &*checkpoint : nullptr)
  {
    if (!c.output.points.empty())
    {
      points.emplace(path / "points.csv", point_columns(), checkpoint ? &*checkpoint : nullptr, "points");
      result.set_points(points->columns());
    }
    write_resolved(path / "resolved.toml", c.values);
  }

  static std::optional<Archive::Fields> checkpoint_to_resume(const fs::path& folder, const Case& c, Mode mode)
  {
    return mode == Mode::resume ? resumable(folder, c) : std::nullopt;
  }

  static bool removed_earlier_result(const fs::path& folder, Mode mode)
  {
    if (mode == Mode::keep && has_earlier_result(folder))
      throw InputError(
          fmt::format("{}: holds an earlier result, which is to be kept; allowed: another folder", folder.string()));
    return remove_earlier_result(folder);
  }

  fs::path path;
  FolderLock lock;     // acquired before any file in the folder is changed
  std::string of_case; ///< resolved
  std::optional<Archive::Fields> checkpoint;
  bool replaced;
  HistoryWriter history;
  std::optional<HistoryWriter> points;
  ResultFile result;
};

ResultDirectory::ResultDirectory(const fs::path& path, const Case& c, StoredParts parts, Mode mode)
    : state_(std::make_unique<State>(path, c, std::move(parts), mode))
{
}
ResultDirectory::ResultDirectory(ResultDirectory&&) noexcept = default;
ResultDirectory& ResultDirectory::operator=(ResultDirectory&&) noexcept = default;
ResultDirectory::~ResultDirectory() = default;

bool ResultDirectory::replaced() const
{
  return state_->replaced;
}

std::optional<Archive::Fields> ResultDirectory::take_checkpoint()
{
  return std::exchange(state_->checkpoint, std::nullopt);
}

int ResultDirectory::finished_steps() const
{
  return static_cast<int>(state_->history.rows());
}

void ResultDirectory::add(const std::vector<NamedNumber>& columns)
{
  state_->history.add(columns);
}

void ResultDirectory::add(int step, const std::vector<NamedNumber>& columns, const simulation::StepFields& fields)
{
  state_->result.add_step(step, columns, fields);
}

void ResultDirectory::add_point(const std::vector<NamedNumber>& row)
{
  state_->points.value().add(row);
}

void ResultDirectory::add_checkpoint(const std::function<void(Archive&)>& state)
{
  const auto with_results = [&](Archive& archive)
  {
    state(archive);
    archive("history", state_->history);
    if (state_->points)
      archive("points", *state_->points);
    archive("result", state_->result);
  };
  write_checkpoint(state_->path / checkpoint_file, state_->of_case, with_results);
}

void ResultDirectory::add_final(const simulation::StepFields& final_state, const std::vector<NamedNumber>& last_columns)
{
  state_->result.add_final(std::get<int>(last_columns.front().value), last_columns, final_state);
}

void ResultDirectory::finish(const std::string& summary)
{
  state_->result.merge(summary);
  replace_file(state_->path / "summary.json", summary);
  try
  {
    remove_pieces(state_->path);
    fs::remove(state_->path / checkpoint_file);
  }
  catch (const std::exception&) // leftover files of a complete run are harmless
  {
  }
}

} // namespace brinell::io
