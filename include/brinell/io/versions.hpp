// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace brinell::io
{

/// Format version of the files of a run: docs/reference/results-format.md. It changes when names or meanings of their contents
/// change.
inline constexpr int format_version = 3;

/// Versions of the program and libraries that computed a result.
struct Versions
{
  std::string brinell, git_hash, hdf5;
  std::string
      processor; ///< kind whose instructions are used (foundation/processor.hpp): it decides about the last digits
};

[[nodiscard]] Versions library_versions();

/// Licence of brinell and those of the libraries that its program and its Python extension contain or load.
[[nodiscard]] std::string licenses();

} // namespace brinell::io
