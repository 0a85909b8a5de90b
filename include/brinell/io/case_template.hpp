// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Case files to begin with, for `brinell new`: the tested cases of the folders that are called as the scenarios, with all
/// other keys as comments (src/io/case/template.toml); the schema explains them.
namespace brinell::io
{

/// Names of the scenarios, as in the key `scenario`.
[[nodiscard]] const std::vector<std::string>& scenario_names();

/// A case that runs as it is: what it needs with sensible values; everything else as comments with default and meaning.
/// @param scenario  one of scenario_names()
/// @throws InputError
[[nodiscard]] std::string case_template(std::string_view scenario);

/// The same into a file.
/// @param replace  an existing file
/// @throws InputError if the file exists and is not to be replaced, IoError
void write_case_template(std::string_view scenario, const std::filesystem::path& file, bool replace);

} // namespace brinell::io
