// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace brinell::io
{

/// What computed a result.
struct Versions
{
  std::string brinell, git_hash, fftw, hdf5;
};

[[nodiscard]] Versions library_versions();

} // namespace brinell::io
