// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

/// Text for terminals and for Python, which takes UTF-8 only.
namespace brinell::io
{

/// The text with bytes that are not UTF-8 as \xb5. Names of files may have such bytes.
[[nodiscard]] std::string printable(std::string_view text);

} // namespace brinell::io
