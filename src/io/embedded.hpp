// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

/// Text files of the source tree that CMake embeds in the library (embedded.cpp.in).
namespace brinell::io
{

/// Text of an embedded file: the licences, the references, the examples of keys (src/io/case/template.toml) or a tested
/// case from which `brinell new` makes a template.
/// @param file  path relative to the root of the source tree: "cases/rolling/case.toml"
/// @throws InternalError if the file is not embedded
[[nodiscard]] std::string_view embedded_text(std::string_view file);

} // namespace brinell::io
