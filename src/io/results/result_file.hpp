// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"
#include "brinell/io/history_csv.hpp"
#include "vtkhdf.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace brinell::io
{

/// Description of a case that is stored with its results.
struct Description
{
  explicit Description(const Case& c);

  std::string case_text, sources, scenario, title;
};

/// Writes result.vtkhdf. An HDF5 file that is open when its process is killed may be lost as a whole. Therefore each step becomes
/// a sealed file of its own, which gets its name only when it is complete, and result.vtkhdf is an index of links that is
/// replaced atomically. At the end, `merge` copies the pieces into one file.
class ResultFile
{
public:
  /// Writes an index of the steps that a checkpoint contains, or an empty one for a new run. @throws IoError (all members)
  /// @param parts       what is stored
  /// @param history     its rows are written with each index; must outlive this object.
  /// @param checkpoint  nullptr: a new run
  ResultFile(std::filesystem::path folder, const Case& c, StoredParts parts, const std::vector<HistoryColumn>& history,
             const Archive::Fields* checkpoint);

  /// Histories of points, which are written with each index; they must outlive this object.
  void set_points(const std::vector<HistoryColumn>& points) { points_ = &points; }

  void add_step(int step, const std::vector<NamedNumber>& columns, const simulation::StepFields& fields);
  /// The state after the last step.
  void add_final(int step, const std::vector<NamedNumber>& columns, const simulation::StepFields& fields);
  /// Replaces the index by one file with the content of all pieces. The pieces are kept, because a run can be resumed from them.
  void merge(const std::string& summary);

  /// Saves or restores the list of stored steps.
  void exchange(Archive& archive) { archive.list("pieces", pieces_); }

private:
  /// A stored state: a file in snapshots/ and a group in result.vtkhdf.
  struct Piece
  {
    int step = 0;
    bool is_final = false;
    StateLayout layout{};

    void exchange(Archive& archive);
    [[nodiscard]] std::string file() const;
    [[nodiscard]] std::string group() const;
    [[nodiscard]] double time() const { return is_final ? step + 1.0 : step; }
  };
  [[nodiscard]] std::filesystem::path path_of(const Piece& piece) const;
  void add(Piece piece, const std::vector<NamedNumber>& columns, const simulation::StepFields& whole);
  void write_merged(const std::string& summary) const;
  [[nodiscard]] std::uintmax_t size_of_pieces() const;
  void write_linked() const;

  std::filesystem::path folder_;
  Description description_;
  StoredParts parts_;
  const std::vector<HistoryColumn>& history_;
  const std::vector<HistoryColumn>* points_ = nullptr; ///< nullptr: the case has none
  std::vector<Piece> pieces_;
};

} // namespace brinell::io
