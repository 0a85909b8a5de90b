// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

/// The keys of the cases of `brinell new`.
namespace brinell::io
{

/// The case of the folder cases/NAME of the scenario, whose keys are in use, table by table, in each table followed by what else it
/// may have as comments: "# key = example" (src/io/case/template.toml), "# key = default" (the schema), and last the keys that
/// have neither, as "#   key:".
/// @throws InternalError if there is no such case
[[nodiscard]] std::string keys_of_template(std::string_view scenario);

} // namespace brinell::io
