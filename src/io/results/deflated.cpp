// SPDX-License-Identifier: BSD-3-Clause
#include "deflated.hpp"

#include "brinell/foundation/error.hpp"

#include <cstddef>
#include <zlib.h>

namespace brinell::io
{

std::vector<unsigned char> shuffled_and_deflated(std::span<const double> numbers, int level)
{
  const std::span<const std::byte> bytes = std::as_bytes(numbers);
  std::vector<unsigned char> shuffled(bytes.size());
  for (std::size_t byte = 0; byte < sizeof(double); ++byte)
    for (std::size_t i = 0; i < numbers.size(); ++i)
      shuffled[byte * numbers.size() + i] = std::to_integer<unsigned char>(bytes[i * sizeof(double) + byte]);
  uLongf size = compressBound(shuffled.size());
  std::vector<unsigned char> deflated(size);
  if (compress2(deflated.data(), &size, shuffled.data(), shuffled.size(), level) != Z_OK)
    throw InternalError("a field cannot be deflated");
  deflated.resize(size);
  deflated.shrink_to_fit();
  return deflated;
}

} // namespace brinell::io
