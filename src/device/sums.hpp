// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/host_device.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace brinell::device
{

/// Adds every `pieces`-th term from its own on.
/// @tparam Term  term(n), a Sum
template <typename Sum, typename Term>
struct SumOfPiece
{
  Term term;
  std::size_t count, pieces;
  Sum* sums;

  BRINELL_HOST_DEVICE void operator()(std::size_t piece) const
  {
    Sum total{};
    for (std::size_t n = piece; n < count; n += pieces)
      total += term(n);
    sums[piece] = total;
  }
};

/// Terms that have been summed before.
template <typename Sum>
struct Summed
{
  const Sum* sums;
  BRINELL_HOST_DEVICE Sum operator()(std::size_t n) const { return sums[n]; }
};

inline constexpr std::size_t first_pieces_of_sums = 32768,
                             last_pieces_of_sums = 128; ///< enough threads, and little to copy

/// Sums over up to a given number of terms on an executor. Their order depends on the number of terms alone, so the last digits do not
/// depend on where and when threads run.
/// @tparam Sum  has += and is zero when it is made, like double
template <typename Executor, typename Sum>
class Sums
{
public:
  Sums(std::size_t most, const Executor& executor)
      : executor_(&executor), pieces_(executor.template allocate<Sum>(std::min(most, first_pieces))),
        last_(executor.template allocate<Sum>(last_pieces)), host_(last_pieces)
  {
  }

  template <typename Term>
  [[nodiscard]] Sum operator()(const char* name, std::size_t count, const Term& term)
  {
    const std::size_t pieces = std::min(count, first_pieces);
    executor_->run(name, pieces, SumOfPiece<Sum, Term>{term, count, pieces, pieces_.data()});
    executor_->run(name, last_pieces,
                   SumOfPiece<Sum, Summed<Sum>>{{pieces_.data()}, pieces, last_pieces, last_.data()});
    executor_->read(last_, std::span<Sum>(host_));
    Sum total{};
    for (const Sum& sum : host_)
      total += sum;
    return total;
  }

private:
  static constexpr std::size_t first_pieces = first_pieces_of_sums, last_pieces = last_pieces_of_sums;

  const Executor* executor_;
  typename Executor::template Memory<Sum> pieces_, last_;
  std::vector<Sum> host_;
};

} // namespace brinell::device
