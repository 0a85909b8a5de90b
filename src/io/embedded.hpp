// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

/// Text files of the source tree that the library carries inside: CMake writes them into it (embedded.cpp.in).
namespace brinell::io
{

/// cite/references.bib; case/templates/*.toml, keys of the cases of `brinell new`, and those that all of them end with.
/// @param name  of the file without its ending: "references", "common", or a scenario
/// @throws InternalError if there is none
[[nodiscard]] std::string_view embedded_text(std::string_view name);

} // namespace brinell::io
