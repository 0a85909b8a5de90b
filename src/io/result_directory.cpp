// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/result_directory.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/versions.hpp"
#include "hdf5.hpp"
#include "replace_file.hpp"
#include "result_file.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace brinell::io
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* checkpoint_file = "checkpoint.h5";

/// Holds a folder for this process; the lock ends with the process, however that ends.
class FolderLock
{
public:
  explicit FolderLock(const fs::path& folder) : m_descriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
  {
    // Not every file system has locks; only a lock that somebody holds is an error.
    if (m_descriptor >= 0 && flock(m_descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    {
      close(m_descriptor);
      throw IoError(
          fmt::format("{}: another run is writing its results there; choose another folder with -o", folder.string()));
    }
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock()
  {
    if (m_descriptor >= 0)
      close(m_descriptor);
  }

private:
  int m_descriptor;
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

bool removed(const fs::path& path)
{
  std::error_code error;
  const auto count = fs::remove_all(path, error);
  if (error)
    throw IoError(fmt::format("{}: an earlier result cannot be removed: {}", path.string(), error.message()));
  return count > 0;
}

/// The summary goes first: without it what is left can never look like a complete result.
bool earlier_result_removed(const fs::path& folder)
{
  bool found = false;
  for (const char* name :
       {"summary.json", "history.csv", "result.vtkhdf", "snapshots", "resolved.toml", "result.vtkhdf.part",
        "summary.json.part", "resolved.toml.part", "history.csv.part", checkpoint_file, "checkpoint.h5.part",
        // of format version 1
        "result.h5", "result.h5.part", "contact.xdmf", "lower.xdmf", "upper.xdmf"})
    found = removed(folder / name) || found;
  return found;
}

struct Checkpoint
{
  int step = 0; ///< the last one that is finished
  Archive::Fields fields;
};

/// Another build may compute other digits, or know another state.
std::string program()
{
  const Versions versions = library_versions();
  return versions.brinell + " " + versions.git_hash;
}

void write_checkpoint(const fs::path& path, int step, const Archive::Fields& fields)
{
  h5::Handle file = h5::create_file_in_memory();
  h5::write_attribute(file, "step", step);
  h5::write_attribute(file, "program", program());
  for (const auto& [name, values] : fields)
    h5::write_numbers(file, name, values);
  h5::save_file(std::move(file), path);
}

std::optional<Checkpoint> read_checkpoint(const fs::path& path)
{
  if (!fs::exists(path))
    return std::nullopt;
  const h5::Handle file = h5::open_file(path);
  if (const std::string written_by = h5::read_text_attribute(file, "program"); written_by != program())
    throw InputError(fmt::format("{}: was written by brinell {}, this is {}; resume with that program, or run without "
                                 "--resume",
                                 path.string(), written_by, program()));
  Checkpoint checkpoint{h5::read_int_attribute(file, "step"), {}};
  for (const std::string& name : h5::names(file))
    checkpoint.fields[name] = h5::read_numbers(file, name);
  return checkpoint;
}

InputError nothing_to_resume(const fs::path& folder)
{
  return InputError(fmt::format("{}: no run was stopped there that could be resumed", folder.string()));
}

/// A case without what only decides with which grids a run begins: they grow as far as they must.
std::string without_extent(const std::string& text)
{
  std::string kept;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("extent = "))
      kept += line + "\n";
  return kept;
}

/// What a run can go on from: nothing if it was stopped before its first checkpoint.
std::optional<Checkpoint> resumable(const fs::path& folder, const Case& c)
{
  if (fs::exists(folder / "summary.json"))
    throw InputError(fmt::format("{}: the run there is complete, there is nothing to resume", folder.string()));
  std::ifstream stream(folder / "resolved.toml", std::ios::binary);
  if (!stream)
    throw nothing_to_resume(folder);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (without_extent(text) != without_extent(resolved_text(c.values)))
    throw InputError(fmt::format("{}: the run that was stopped there is of another case: compare resolved.toml there "
                                 "with what brinell check prints; without --resume it is replaced",
                                 folder.string()));
  return read_checkpoint(folder / checkpoint_file);
}

/// The columns that the history of a scenario has.
std::vector<NamedNumber> columns_of(const Scenario& scenario)
{
  using namespace simulation;
  struct Columns
  {
    std::vector<NamedNumber> operator()(const TuggingCase&) const { return columns(TuggingRecord{}); }
    std::vector<NamedNumber> operator()(const IndentationCase&) const { return columns(IndentationRecord{}); }
    std::vector<NamedNumber> operator()(const RollingCase&) const { return columns(RollingRecord{}); }
  };
  return std::visit(Columns{}, scenario);
}

} // namespace

struct ResultDirectory::State
{
  State(const fs::path& folder, const Case& c, Mode mode)
      : path(mode == Mode::resume && !fs::exists(folder) ? throw nothing_to_resume(folder) : made_folder(folder)),
        lock(path), checkpoint(take(path, c, mode)),
        replaced(!checkpoint && earlier_result_removed(path) && mode == Mode::replace),
        history(path / "history.csv", columns_of(c.scenario), finished_steps()),
        result(path, c, finished_steps(), history.columns())
  {
    replace_file(path / "resolved.toml", resolved_text(c.values));
  }

  static std::optional<Checkpoint> take(const fs::path& folder, const Case& c, Mode mode)
  {
    return mode == Mode::resume ? resumable(folder, c) : std::nullopt;
  }
  [[nodiscard]] int finished_steps() const { return checkpoint ? checkpoint->step + 1 : 0; }

  fs::path path;
  FolderLock lock; // before anything in the folder is touched
  std::optional<Checkpoint> checkpoint;
  std::optional<Archive::Fields> fields = checkpoint ? std::optional(std::move(checkpoint->fields)) : std::nullopt;
  bool replaced;
  HistoryWriter history;
  ResultFile result;
};

ResultDirectory::ResultDirectory(const fs::path& path, const Case& c, Mode mode)
    : m_state(std::make_unique<State>(path, c, mode))
{
}
ResultDirectory::ResultDirectory(ResultDirectory&&) noexcept = default;
ResultDirectory& ResultDirectory::operator=(ResultDirectory&&) noexcept = default;
ResultDirectory::~ResultDirectory() = default;

bool ResultDirectory::replaced() const
{
  return m_state->replaced;
}

const std::optional<Archive::Fields>& ResultDirectory::checkpoint() const
{
  return m_state->fields;
}

int ResultDirectory::finished_steps() const
{
  return m_state->finished_steps();
}

void ResultDirectory::add(const std::vector<NamedNumber>& columns)
{
  m_state->history.add(columns);
}

void ResultDirectory::add(int step, const std::vector<NamedNumber>& columns, const simulation::Snapshot& snapshot)
{
  m_state->result.add_step(step, columns, snapshot);
}

void ResultDirectory::add_checkpoint(int step, const Archive::Fields& fields)
{
  write_checkpoint(m_state->path / checkpoint_file, step, fields);
}

void ResultDirectory::finish(const simulation::Snapshot& final_state, const std::vector<NamedNumber>& last_columns,
                             const std::string& summary)
{
  m_state->result.add_final(std::get<int>(last_columns.front().second), last_columns, final_state);
  m_state->result.merge(summary);
  replace_file(m_state->path / "summary.json", summary);
  m_state->result.remove_pieces();
  removed(m_state->path / checkpoint_file);
}

} // namespace brinell::io
