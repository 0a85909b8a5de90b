// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace brinell::elastoplastic
{

/// Largest shear of each cell in an increment: friction times pressure, cut off at what the surfaces can carry.
class ShearBound
{
public:
  ShearBound(double coefficient, std::size_t cells) : coefficient_(coefficient), before_(cells), now_(cells) {}

  /// Begins an increment with the bound of the pressure before it.
  /// @param limit      largest shear that the surfaces can carry in each cell [Pa]
  /// @param is_held    Interface::Start::holds_law
  /// @param pressure   before the increment, of the surface points that now lie in each cell [Pa]
  void begin(std::vector<double> limit, bool is_held, std::span<const double> pressure)
  {
    limit_ = std::move(limit);
    is_held_ = is_held;
    set(pressure);
    before_ = now_;
    is_known_ = false;
  }
  void set_limit(std::vector<double> limit) { limit_ = std::move(limit); }
  /// Follows the pressure; where the law is held, only once per increment or after `renew`.
  /// @returns whether the bound has been set anew
  bool follow(std::span<const double> pressure)
  {
    if (is_held_ && is_known_)
      return false;
    is_known_ = true;
    set(pressure);
    return true;
  }
  /// Lets the next `follow` set the bound again. Until then the bound of the present solution stays, because its shear is compared
  /// with it.
  /// @returns the largest change that this will make [Pa]
  double renew(std::span<const double> pressure)
  {
    is_known_ = false;
    double change = 0.0;
    for (std::size_t i = 0; i < now_.size(); ++i)
      change = larger(change, std::abs(at(i, pressure[i]) - now_[i]));
    return change;
  }

  /// Before the increment, and now [Pa].
  [[nodiscard]] const std::vector<double>& before() const { return before_; }
  [[nodiscard]] const std::vector<double>& now() const { return now_; }
  /// Whether the surface, not friction, bounds the shear of a cell under a pressure [Pa].
  [[nodiscard]] bool is_limited(std::size_t cell, double pressure) const
  {
    return coefficient_ * pressure > limit_[cell];
  }

private:
  [[nodiscard]] double at(std::size_t cell, double pressure) const
  {
    return std::min(coefficient_ * pressure, limit_[cell]);
  }
  void set(std::span<const double> pressure)
  {
    for (std::size_t i = 0; i < now_.size(); ++i)
      now_[i] = at(i, pressure[i]);
  }

  double coefficient_; ///< of friction
  bool is_held_ = false;
  bool is_known_ = false; ///< whether `now_` is already that of this increment
  std::vector<double> limit_, before_, now_;
};

} // namespace brinell::elastoplastic
