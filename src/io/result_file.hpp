// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"
#include "brinell/simulation/tugging.hpp"
#include "xdmf.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace brinell::io
{

/// result.h5 and the .xdmf files beside it. An HDF5 file that is open when its process is killed may be lost as a whole, so
/// each step becomes a file of its own, complete before it gets its name, and result.h5 an index of links that is
/// replaced in one piece. `merge` copies the pieces into one file at the end.
class ResultFile
{
public:
  /// Writes an index without steps. @throws IoError (all members)
  ResultFile(std::filesystem::path folder, const Case& c);

  void add_step(const simulation::Snapshot& snapshot);
  void add_final(const simulation::Snapshot& snapshot);
  void merge();

private:
  /// A stored state: its file in snapshots/ and its group in result.h5.
  struct Piece
  {
    std::string file;
    std::string group;
  };
  void add(const simulation::Snapshot& snapshot, const Piece& piece, double time);
  void write_result(bool linked) const;
  void write_xdmf() const;

  std::filesystem::path m_folder;
  std::string m_case_text, m_scenario, m_title;
  std::vector<Piece> m_pieces;
  std::vector<XdmfTime> m_contact, m_lower, m_upper;
  double m_last_time = -1.0;
};

} // namespace brinell::io
