// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"
#include "brinell/simulation/columns.hpp"

#include <limits>
#include <string>
#include <variant>

namespace brinell::simulation
{

/// Sums and means of all columns over some rows of a history.
template <typename Record>
class ColumnSums
{
public:
  void add(const Record& record)
  {
    for (std::size_t i = 0; i < sums_.size(); ++i)
      sums_[i] +=
          std::visit([&](auto member) { return static_cast<double>(record.*member); }, columns<Record>[i].member);
    ++count_;
  }
  [[nodiscard]] int count() const { return count_; }
  /// Sum of a column. @param member  &SlidingRecord::F_n
  template <typename T, typename Part>
  [[nodiscard]] double sum(T Part::*member) const
  {
    const typename Column<Record>::Member wanted = static_cast<T Record::*>(member);
    for (std::size_t i = 0; i < sums_.size(); ++i)
      if (columns<Record>[i].member == wanted)
        return sums_[i];
    throw InternalError("a sum of what is not a column");
  }
  template <typename T, typename Part>
  [[nodiscard]] double mean(T Part::*member) const
  {
    return sum(member) / count_;
  }

  void exchange(Archive& archive)
  {
    for (std::size_t i = 0; i < sums_.size(); ++i)
      archive(std::string(columns<Record>[i].name), sums_[i]);
    archive("count", count_, 0, std::numeric_limits<int>::max() - 1);
  }

private:
  std::array<double, columns<Record>.size()> sums_{};
  int count_ = 0;
};

} // namespace brinell::simulation
