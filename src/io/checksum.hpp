// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace brinell::io
{

/// 64 bits of what has been added, in whatever pieces. Every step is one to one, so that no single damaged word goes unnoticed;
/// of other damage one in 2^64 does. It is no signature: who damages on purpose can mend the checksum too.
class Checksum
{
public:
  void add(std::string_view bytes);
  /// Sixteen hexadecimal digits.
  [[nodiscard]] std::string text() const;

private:
  void mix(std::uint64_t word);

  std::uint64_t state_ = 0x9e3779b97f4a7c15; // any number that is not 0
  std::uint64_t size_ = 0;
  std::uint64_t word_ = 0; ///< bytes that do not make a word yet
};

[[nodiscard]] std::string checksum(std::string_view bytes);

} // namespace brinell::io
