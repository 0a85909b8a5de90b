// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

/// Text files of the source tree that the library carries inside: CMake writes their definitions (embedded.cpp.in).
namespace brinell::io::embedded
{

extern const std::string_view references; ///< cite/references.bib
extern const std::string_view tugging, indentation,
    rolling;                          ///< case/templates/*.toml: keys of the cases of `brinell new`
extern const std::string_view common; ///< keys that all of them end with

} // namespace brinell::io::embedded
