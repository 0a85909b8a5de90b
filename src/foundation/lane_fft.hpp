// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/aligned.hpp"
#include "foundation/lanes.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace brinell
{

/// e^{-2 pi i numerator / denominator}, also accurate for large numerators.
[[nodiscard]] Complex root_of_one(long long numerator, long long denominator);

/// Fourier transforms of `lane_count` complex series of one length side by side, one in each lane.
///
/// Stockham's self-sorting algorithm with radices up to 13. The lanes do not interact, so every instruction works on whole
/// vectors; the padding is not read, and only the wanted values are written. A length with a larger prime factor is
/// computed as a convolution with a chirp (Bluestein 1970). Planned once; every function is const and may be called
/// from several threads, each with its own buffer.
class LaneFft
{
public:
  explicit LaneFft(int length);
  ~LaneFft();
  LaneFft(LaneFft&&) noexcept;
  LaneFft& operator=(LaneFft&&) noexcept;
  LaneFft(const LaneFft&) = delete;
  LaneFft& operator=(const LaneFft&) = delete;

  [[nodiscard]] int length() const { return length_; }
  /// Number of values that a transform needs as a buffer.
  [[nodiscard]] std::size_t work_size() const;

  /// to_k = sum over j < given of from_j e^{-2 pi i j k / length}, unnormalised; `to` is not `from`.
  void forward(const ComplexLanes* from, int given, ComplexLanes* to, ComplexLanes* work) const;
  /// to_j = sum over all k of from_k e^{2 pi i j k / length} for j < wanted; `to` is not `from`.
  void inverse(const ComplexLanes* from, ComplexLanes* to, int wanted, ComplexLanes* work) const;

  struct Step;   ///< one radix of the length
  struct Source; ///< values, some of them given
  struct Target; ///< values, some of them wanted

private:
  struct Chirp;
  void transform(const Source& from, const Target& to, ComplexLanes* work) const;
  void convolve(const Source& from, const Target& to, ComplexLanes* work) const;

  int length_;
  std::vector<Step> steps_;
  std::unique_ptr<Chirp> chirp_; ///< only for a length with a large prime factor
};

} // namespace brinell
