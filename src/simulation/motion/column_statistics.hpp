// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/simulation/columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

namespace brinell::simulation
{

/// Statistics of all columns over rows of a history that follow each other, such as those of a pass, a stroke or a cycle. A column
/// is named by its member, `&SlidingRecord::F_n`.
template <typename Record>
class ColumnStatistics
{
public:
  /// @param before  row before, which counts as the beginning if this one is the first
  void add(const Record& before, const Record& row)
  {
    if (count_ == 0)
      beginning_.set(before);
    last_.set(row);
    for (std::size_t i = 0; i < last_.of.size(); ++i)
    {
      sums_.of[i] += last_.of[i];
      smallest_.of[i] = count_ == 0 ? last_.of[i] : std::min(smallest_.of[i], last_.of[i]);
      magnitudes_.of[i] = std::max(magnitudes_.of[i], std::abs(last_.of[i]));
    }
    ++count_;
  }
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] double sum(auto member) const { return sums_.at(member); }
  [[nodiscard]] double mean(auto member) const { return sums_.at(member) / count_; }
  [[nodiscard]] double last(auto member) const { return last_.at(member); }
  [[nodiscard]] double smallest(auto member) const { return smallest_.at(member); }
  [[nodiscard]] double largest_magnitude(auto member) const { return magnitudes_.at(member); }
  /// Growth of the sum of these columns.
  [[nodiscard]] double growth(auto... members) const
  {
    return (last_.at(members) + ...) - (beginning_.at(members) + ...);
  }

  void exchange(Archive& archive)
  {
    archive("beginning", beginning_.of);
    archive("last", last_.of);
    archive("sums", sums_.of);
    archive("smallest", smallest_.of);
    archive("magnitudes", magnitudes_.of);
    archive("count", count_, 0, std::numeric_limits<int>::max() - 1);
  }

private:
  /// One number for each column.
  struct Values
  {
    std::vector<double> of = std::vector<double>(columns<Record>.size());

    void set(const Record& row)
    {
      for (std::size_t i = 0; i < of.size(); ++i)
        of[i] = std::visit([&](auto member) { return static_cast<double>(row.*member); }, columns<Record>[i].member);
    }
    template <typename T, typename Part>
    [[nodiscard]] double at(T Part::*member) const
    {
      const typename Column<Record>::Member wanted = static_cast<T Record::*>(member);
      for (std::size_t i = 0; i < of.size(); ++i)
        if (columns<Record>[i].member == wanted)
          return of[i];
      throw InternalError("statistics of what is not a column");
    }
  };

  Values beginning_, last_, sums_, smallest_, magnitudes_;
  int count_ = 0;
};

} // namespace brinell::simulation
