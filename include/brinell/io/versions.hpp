// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace brinell::io
{

/// Of the files of a run: docs/reference/results-format.md. It changes with the names and the meaning of what they hold.
inline constexpr int format_version = 3;

/// What computed a result.
struct Versions
{
  std::string brinell, git_hash, fftw, hdf5;
};

[[nodiscard]] Versions library_versions();

} // namespace brinell::io
