// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Templates of case files, for `brinell new`: the tested cases in the folders named like the scenarios, with all other keys as
/// comments (src/io/case/template.toml) and explanations from the schema.
namespace brinell::io
{

/// Names of the scenarios, as in the key `scenario`.
[[nodiscard]] const std::vector<std::string>& scenario_names();

/// A case that runs as it is: required keys with sensible values, and all other keys as comments with default and meaning.
/// @param scenario  one of scenario_names()
/// @throws InputError
[[nodiscard]] std::string case_template(std::string_view scenario);

/// Writes the template to a file.
/// @param replace  whether an existing file may be replaced
/// @throws InputError if the file exists and is not to be replaced, IoError
void write_case_template(std::string_view scenario, const std::filesystem::path& file, bool replace);

} // namespace brinell::io
