// SPDX-License-Identifier: BSD-3-Clause
#include "checksum.hpp"

#include <cstring>
#include <fmt/format.h>
#include <utility>

namespace brinell::io
{

/// Multiplication by an odd number carries damage upwards, the shift brings it down again.
void Checksum::mix(std::uint64_t word)
{
  state_ = (state_ ^ word) * 0xff51afd7ed558ccd;
  state_ ^= state_ >> 32;
}

void Checksum::add(std::string_view bytes)
{
  constexpr std::size_t size = sizeof(word_);
  while (!bytes.empty())
  {
    const std::size_t filled = size_ % size;
    if (filled == 0 && bytes.size() >= size)
    {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes.data(), size);
      mix(word);
      size_ += size;
      bytes.remove_prefix(size);
      continue;
    }
    word_ |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes.front())) << (8 * filled);
    ++size_;
    bytes.remove_prefix(1);
    if (size_ % size == 0)
      mix(std::exchange(word_, 0));
  }
}

std::string Checksum::text() const
{
  Checksum whole = *this;
  whole.mix(word_);
  whole.mix(size_);
  return fmt::format("{:016x}", whole.state_);
}

std::string checksum(std::string_view bytes)
{
  Checksum sum;
  sum.add(bytes);
  return sum.text();
}

} // namespace brinell::io
