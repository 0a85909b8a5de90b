// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

/// Removal of an earlier result. Only files that a run has written are removed.
namespace brinell::io
{

/// Names of the files and folders of a run.
inline constexpr const char* checkpoint_file = "checkpoint.h5";
inline constexpr const char* pieces_folder = "snapshots";
inline constexpr const char* final_piece = "final.h5";

/// Marks in the files by which they are recognised.
inline constexpr std::string_view result_mark = "brinell-result";
inline constexpr std::string_view checkpoint_mark = "brinell-checkpoint";
inline constexpr std::string_view piece_mark = "brinell-piece";

/// Whether a folder holds files that a run has written.
[[nodiscard]] bool has_earlier_result(const std::filesystem::path& folder);

/// Removes the files of an earlier run from a folder. The summary is removed first, because without it the remaining files cannot
/// look like a complete result.
/// @returns whether there was an earlier result
/// @throws InputError, before anything is removed, if a file with such a name was not written by a run; IoError
bool remove_earlier_result(const std::filesystem::path& folder);

/// Removes the pieces of a run, and their folder if it contains nothing else.
/// @throws IoError
bool remove_pieces(const std::filesystem::path& folder);

} // namespace brinell::io
