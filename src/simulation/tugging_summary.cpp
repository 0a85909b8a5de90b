// SPDX-License-Identifier: BSD-3-Clause
#include "tugging_summary.hpp"

#include "records.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brinell::simulation
{

void Summariser::add(TuggingRecord record)
{
  const bool continues = record.step > 0 && record.pass == last_.pass;
  record.work = last_.work;
  if (continues)
    record.work += 0.5 * (record.F_X + last_.F_X) * (record.X - last_.X) -
                   0.5 * (record.F_Z + last_.F_Z) * (record.height - last_.height);
  ++summary_.steps;
  summary_.iterations += record.iterations;
  if (record.F_X > summary_.peak_F_X)
  {
    summary_.peak_F_X = record.F_X;
    summary_.X_at_peak_F_X = record.X;
  }
  summary_.min_F_X = std::min(summary_.min_F_X, record.F_X);
  summary_.peak_F_Z = std::max(summary_.peak_F_Z, record.F_Z);
  if (record.F_Z > 0.0)
    summary_.load_ratio_end = record.F_X / record.F_Z;
  if (continues && record.pass == 0 && last_.X < 0.0 && record.X >= 0.0)
    at_alignment(last_, record);
  largest_work_ = std::max(largest_work_, std::abs(record.work));
  last_ = record;
}

void Summariser::at_alignment(const TuggingRecord& before, const TuggingRecord& now)
{
  const double t = before.X / (before.X - now.X);
  const auto between = [t](double a, double b) { return a + t * (b - a); };
  summary_.F_X_aligned = between(before.F_X, now.F_X);
  summary_.F_Z_aligned = between(before.F_Z, now.F_Z);
  summary_.work_to_alignment = between(before.work, now.work);
  if (summary_.F_Z_aligned > 0.0)
    summary_.load_ratio_aligned = summary_.F_X_aligned / summary_.F_Z_aligned;
}

void Summariser::exchange(Archive& archive)
{
  archive("last", last_);
  archive("largest_work", largest_work_);
  archive("steps", summary_.steps, 0, std::numeric_limits<int>::max() - 1);
  archive("iterations", summary_.iterations, 0, std::numeric_limits<long>::max());
  archive("peak_F_X", summary_.peak_F_X);
  archive("X_at_peak_F_X", summary_.X_at_peak_F_X);
  archive("min_F_X", summary_.min_F_X);
  archive("peak_F_Z", summary_.peak_F_Z);
  archive("F_X_aligned", summary_.F_X_aligned);
  archive("F_Z_aligned", summary_.F_Z_aligned);
  archive("load_ratio_aligned", summary_.load_ratio_aligned);
  archive("load_ratio_end", summary_.load_ratio_end);
  archive("work_to_alignment", summary_.work_to_alignment);
}

TuggingSummary Summariser::result() const
{
  TuggingSummary s = summary_;
  take_totals(last_, largest_work_, s);
  s.last = last_;
  return s;
}

} // namespace brinell::simulation
