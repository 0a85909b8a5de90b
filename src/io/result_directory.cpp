// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/result_directory.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/history_csv.hpp"
#include "result_file.hpp"
#include "summary_json.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace brinell::io
{

namespace
{

namespace fs = std::filesystem;

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
  for (const char* name : {"summary.json", "history.csv", "result.h5", "snapshots", "contact.xdmf", "lower.xdmf",
                           "upper.xdmf", "resolved.toml", "result.h5.part", "summary.json.part"})
    found = removed(folder / name) || found;
  return found;
}

} // namespace

void replace_file(const fs::path& path, const std::string& text)
{
  fs::path part = path;
  part += ".part";
  std::ofstream stream(part, std::ios::binary | std::ios::trunc);
  stream << text;
  stream.close();
  std::error_code error;
  if (stream)
    fs::rename(part, path, error);
  if (!stream || error)
    throw IoError(
        fmt::format("{}: cannot be written: {}", path.string(), error ? error.message() : std::strerror(errno)));
}

struct ResultDirectory::State
{
  State(const fs::path& folder, Case given)
      : path(made_folder(folder)), c(std::move(given)), lock(path), replaced(earlier_result_removed(path)),
        result(path, c), history(path / "history.csv")
  {
    replace_file(path / "resolved.toml", resolved_text(c.values));
  }

  fs::path path;
  Case c;
  FolderLock lock; // before anything in the folder is touched
  bool replaced;
  ResultFile result;
  HistoryWriter history;
};

ResultDirectory::ResultDirectory(const fs::path& path, const Case& c) : m_state(std::make_unique<State>(path, c)) {}
ResultDirectory::ResultDirectory(ResultDirectory&&) noexcept = default;
ResultDirectory& ResultDirectory::operator=(ResultDirectory&&) noexcept = default;
ResultDirectory::~ResultDirectory() = default;

bool ResultDirectory::replaced() const
{
  return m_state->replaced;
}

void ResultDirectory::add(const simulation::StepRecord& record)
{
  m_state->history.add(record);
}

void ResultDirectory::add(const simulation::Snapshot& snapshot)
{
  m_state->result.add_step(snapshot);
}

void ResultDirectory::finish(const simulation::TuggingPlan& plan, const simulation::TuggingSummary& summary,
                             const RunInfo& info)
{
  m_state->result.add_final(summary.final_state);
  m_state->result.merge();
  replace_file(m_state->path / "summary.json", summary_text(m_state->c, plan, summary, info));
}

void ResultDirectory::stop()
{
  m_state->result.merge();
}

} // namespace brinell::io
