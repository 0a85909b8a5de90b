// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

/// Text files of the source tree that CMake embeds in the library (embedded.cpp.in).
namespace brinell::io
{

/// The papers, what cases may have (src/io/case/template.toml), and the tested cases that `brinell new` begins with.
/// @param file  from the root of the tree: "cases/rolling/case.toml"
/// @throws InternalError if there is none
[[nodiscard]] std::string_view embedded_text(std::string_view file);

} // namespace brinell::io
