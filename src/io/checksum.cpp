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
  m_state = (m_state ^ word) * 0xff51afd7ed558ccd;
  m_state ^= m_state >> 32;
}

void Checksum::add(std::string_view bytes)
{
  constexpr std::size_t size = sizeof(m_word);
  while (!bytes.empty())
  {
    const std::size_t filled = m_size % size;
    if (filled == 0 && bytes.size() >= size)
    {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes.data(), size);
      mix(word);
      m_size += size;
      bytes.remove_prefix(size);
      continue;
    }
    m_word |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes.front())) << (8 * filled);
    ++m_size;
    bytes.remove_prefix(1);
    if (m_size % size == 0)
      mix(std::exchange(m_word, 0));
  }
}

std::string Checksum::text() const
{
  Checksum whole = *this;
  whole.mix(m_word);
  whole.mix(m_size);
  return fmt::format("{:016x}", whole.m_state);
}

std::string checksum(std::string_view bytes)
{
  Checksum sum;
  sum.add(bytes);
  return sum.text();
}

} // namespace brinell::io
