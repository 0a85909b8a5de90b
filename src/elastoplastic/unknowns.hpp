// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/body.hpp"

#include <cstddef>
#include <vector>

namespace brinell::elastoplastic
{

/// The trial deviators of both bodies as one vector, in which cells that become active later come at the end.
class Unknowns
{
public:
  /// Appends what the bodies have gained since the last call.
  void grow(const Body& lower, const Body& upper)
  {
    append(lower_, lower.unknowns());
    append(upper_, upper.unknowns());
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  void pack(const std::vector<double>& lower, const std::vector<double>& upper, std::vector<double>& x) const
  {
    x.resize(size_);
    for (std::size_t i = 0; i < lower.size(); ++i)
      x[lower_[i]] = lower[i];
    for (std::size_t i = 0; i < upper.size(); ++i)
      x[upper_[i]] = upper[i];
  }
  void unpack(const std::vector<double>& x, std::vector<double>& lower, std::vector<double>& upper) const
  {
    for (std::size_t i = 0; i < lower.size(); ++i)
      lower[i] = x[lower_[i]];
    for (std::size_t i = 0; i < upper.size(); ++i)
      upper[i] = x[upper_[i]];
  }

private:
  void append(std::vector<std::size_t>& slots, std::size_t count)
  {
    while (slots.size() < count)
      slots.push_back(size_++);
  }

  std::vector<std::size_t> lower_, upper_; ///< places in the common vector
  std::size_t size_ = 0;
};

/// Notices when an accelerated iteration runs in circles.
class StallRule
{
public:
  /// @returns whether the error has not halved within the last evaluations with the same active cells.
  bool stalls(double error, bool grew)
  {
    if (grew)
      *this = {};
    else if (error < 0.5 * best_)
    {
      best_ = error;
      since_ = 0;
    }
    else
      ++since_;
    return since_ > patience;
  }

private:
  static constexpr int patience = 20;
  double best_ = 1e300;
  int since_ = 0;
};

} // namespace brinell::elastoplastic
