// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"
#include "brinell/io/history_csv.hpp"
#include "vtkhdf.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace brinell::io
{

/// result.vtkhdf. An HDF5 file that is open when its process is killed may be lost as a whole, so each step becomes a file of
/// its own, complete before it gets its name, and result.vtkhdf an index of links that is replaced in one piece. `merge`
/// copies the pieces into one file at the end.
class ResultFile
{
public:
  /// Writes an index of the first steps that are there already, none in a new folder. @throws IoError (all members)
  /// @param history  its rows are written with each index; must outlive this object.
  ResultFile(std::filesystem::path folder, const Case& c, int finished_steps,
             const std::vector<HistoryColumn>& history);

  void add_step(int step, const std::vector<NamedNumber>& columns, const simulation::Snapshot& snapshot);
  /// The state after the last step.
  void add_final(int step, const std::vector<NamedNumber>& columns, const simulation::Snapshot& snapshot);
  /// The pieces stay: nothing else can be resumed from.
  void merge(const std::string& summary);

private:
  /// A stored state: its file in snapshots/ and its group in result.vtkhdf.
  struct Piece
  {
    std::string file;
    std::string group;
    double time; ///< the step
    StateLayout layout{};
    std::string checksum{}; ///< of the file
  };
  static Piece piece_of(int step);
  [[nodiscard]] std::filesystem::path path_of(const Piece& piece) const;
  void require_intact(const Piece& piece) const;
  void add(const simulation::Snapshot& snapshot, const std::vector<NamedNumber>& columns, Piece piece);
  void read_index(int finished_steps);
  void write_index() const;
  void require_space() const;
  void write_linked() const;
  void write_description(const h5::Handle& file) const;

  std::filesystem::path folder_;
  std::string case_text_, sources_, scenario_, title_;
  const std::vector<HistoryColumn>& history_;
  std::vector<Piece> pieces_;
};

} // namespace brinell::io
