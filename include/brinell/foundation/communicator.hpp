// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace brinell
{

/// The processes ("ranks") that compute one case together. This class is that of a process alone: size 1, every call
/// returns its argument. A derived class passes numbers between processes.
///
/// Every function is called by all ranks, in the same order, each by one thread at a time. Sums are those of the caller, over
/// what all ranks receive in the order of the ranks or of the data, so that they do not depend on the number of ranks.
class Communicator
{
public:
  Communicator() = default;
  virtual ~Communicator() = default;
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;

  [[nodiscard]] virtual int rank() const { return 0; }
  [[nodiscard]] virtual int size() const { return 1; }
  [[nodiscard]] bool is_alone() const { return size() == 1; }

  /// Sends a part of `send` to each rank, one after the other, and receives one from each.
  /// @param sent, received  numbers of values of the parts, by rank
  virtual void all_to_all(std::span<const double> send, std::span<const std::size_t> sent, std::span<double> receive,
                          std::span<const std::size_t> received) const
  {
    static_cast<void>(sent);
    static_cast<void>(received);
    std::copy(send.begin(), send.end(), receive.begin());
  }
  /// The values of all ranks, one after the other.
  /// @param counts  numbers of values by rank
  virtual void all_gather(std::span<const double> own, std::span<const std::size_t> counts, std::span<double> all) const
  {
    static_cast<void>(counts);
    std::copy(own.begin(), own.end(), all.begin());
  }
  /// Values of one rank for all.
  virtual void broadcast(std::span<double> values, int from) const
  {
    static_cast<void>(values);
    static_cast<void>(from);
  }
  /// Values of all ranks for the first one; the others receive nothing.
  /// @param all  only of the first rank
  virtual void gather(std::span<const double> own, std::span<const std::size_t> counts, std::span<double> all) const
  {
    static_cast<void>(counts);
    std::copy(own.begin(), own.end(), all.begin());
  }

  /// One number of each rank.
  [[nodiscard]] std::vector<double> all_values(double own) const
  {
    std::vector<double> values(static_cast<std::size_t>(size()), own);
    if (!is_alone())
      all_gather({&own, 1}, std::vector<std::size_t>(values.size(), 1), values);
    return values;
  }
  [[nodiscard]] std::vector<std::size_t> all_counts(std::size_t own) const
  {
    const std::vector<double> values = all_values(static_cast<double>(own));
    std::vector<std::size_t> counts;
    counts.reserve(values.size());
    for (const double value : values)
      counts.push_back(static_cast<std::size_t>(value));
    return counts;
  }
  /// The values of all ranks, whose numbers may differ, one after the other.
  [[nodiscard]] std::vector<double> joined(std::span<const double> own) const
  {
    if (is_alone())
      return {own.begin(), own.end()};
    const std::vector<std::size_t> counts = all_counts(own.size());
    std::size_t size = 0;
    for (const std::size_t count : counts)
      size += count;
    std::vector<double> all(size);
    all_gather(own, counts, all);
    return all;
  }
  /// The largest of the values; NaN if any is NaN.
  [[nodiscard]] double largest(double own) const
  {
    double result = own;
    for (const double value : is_alone() ? std::vector<double>{} : all_values(own))
      result = value <= result || result != result ? result : value;
    return result;
  }
  [[nodiscard]] bool any(bool own) const { return largest(own ? 1.0 : 0.0) > 0.0; }
};

} // namespace brinell
