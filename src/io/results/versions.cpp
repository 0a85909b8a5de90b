// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/versions.hpp"

#include "brinell/foundation/processor.hpp"
#include "brinell/version.hpp"
#include "io/embedded.hpp"

#include <fmt/format.h>
#include <hdf5.h>

namespace brinell::io
{

Versions library_versions()
{
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return {.brinell = std::string(version),
          .git_hash = std::string(git_hash),
          .hdf5 = fmt::format("{}.{}.{}", major, minor, release),
          .processor = chosen_processor()};
}

std::string licenses()
{
  return fmt::format("{}\n{}", embedded_text("LICENSE"), embedded_text("src/io/licenses.txt"));
}

} // namespace brinell::io
