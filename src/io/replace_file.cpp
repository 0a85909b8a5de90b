// SPDX-License-Identifier: BSD-3-Clause
#include "replace_file.hpp"

#include "brinell/foundation/error.hpp"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <fstream>

namespace brinell::io
{

void replace_file(const std::filesystem::path& path, std::string_view content)
{
  std::filesystem::path part = path;
  part += ".part";
  std::ofstream stream(part, std::ios::binary | std::ios::trunc);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  const int cause = errno;
  std::error_code error;
  if (stream)
    std::filesystem::rename(part, path, error);
  if (stream && !error)
    return;
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  throw IoError(
      fmt::format("{}: cannot be written: {}", path.string(), error ? error.message() : std::strerror(cause)));
}

} // namespace brinell::io
