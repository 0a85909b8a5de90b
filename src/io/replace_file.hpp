// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

namespace brinell::io
{

/// Replaces a file in one piece: readers see the old content or the new one. @throws IoError
void replace_file(const std::filesystem::path& path, std::string_view content);

} // namespace brinell::io
