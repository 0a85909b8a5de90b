// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

/// What a run may remove: its own files and those of an earlier run, nothing else.
namespace brinell::io
{

/// Names in the folder of a run.
inline constexpr const char* checkpoint_file = "checkpoint.h5";
inline constexpr const char* pieces_folder = "snapshots";
inline constexpr const char* final_piece = "final.h5";

/// In the files by which they are known again.
inline constexpr std::string_view result_mark = "brinell-result";
inline constexpr std::string_view checkpoint_mark = "brinell-checkpoint";
inline constexpr std::string_view piece_mark = "brinell-piece";

/// Removes what an earlier run has left in a folder. Its summary goes first: without it what is left can never look like a
/// complete result.
/// @returns whether there was anything
/// @throws InputError, before anything goes, if a file of such a name was not written by a run; IoError
bool remove_earlier_result(const std::filesystem::path& folder);

/// Removes the pieces of a run, and their folder if nothing else is in it. @throws IoError
bool remove_pieces(const std::filesystem::path& folder);

} // namespace brinell::io
