// SPDX-License-Identifier: BSD-3-Clause
#include "tugging_peaks.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::simulation
{

namespace
{

bool continues(const TuggingRecord& before, const TuggingRecord& now)
{
  return now.step > 0 && now.pass == before.pass;
}

void at_alignment(const TuggingRecord& before, const TuggingRecord& now, TuggingPeaks& peaks)
{
  const double t = before.X / (before.X - now.X);
  const auto between = [t](double a, double b) { return a + t * (b - a); };
  peaks.F_X_aligned = between(before.F_X, now.F_X);
  peaks.F_Z_aligned = between(before.F_Z, now.F_Z);
  peaks.work_to_alignment = between(before.work, now.work);
  if (peaks.F_Z_aligned > 0.0)
    peaks.load_ratio_aligned = peaks.F_X_aligned / peaks.F_Z_aligned;
}

} // namespace

double work_between(const TuggingRecord& before, const TuggingRecord& now)
{
  if (!continues(before, now))
    return 0.0;
  return 0.5 * (now.F_X + before.F_X) * (now.X - before.X) -
         0.5 * (now.F_Z + before.F_Z) * (now.height - before.height);
}

double friction_work_between(const TuggingRecord& before, const TuggingRecord& now)
{
  if (!continues(before, now))
    return 0.0;
  return 0.5 * (now.F_X_friction + before.F_X_friction) * (now.X - before.X) -
         0.5 * (now.F_Z_friction + before.F_Z_friction) * (now.height - before.height);
}

void add(const TuggingRecord& before, const TuggingRecord& now, TuggingPeaks& peaks)
{
  if (now.F_X > peaks.peak_F_X)
  {
    peaks.peak_F_X = now.F_X;
    peaks.X_at_peak_F_X = now.X;
  }
  peaks.min_F_X = std::min(peaks.min_F_X, now.F_X);
  if (std::abs(now.F_Y) > std::abs(peaks.peak_F_Y))
    peaks.peak_F_Y = now.F_Y;
  peaks.peak_F_Z = std::max(peaks.peak_F_Z, now.F_Z);
  if (now.F_Z > 0.0)
    peaks.load_ratio_end = now.F_X / now.F_Z;
  if (continues(before, now) && now.pass == 1 && before.X < 0.0 && now.X >= 0.0)
    at_alignment(before, now, peaks);
}

void TuggingPeaks::exchange(Archive& archive)
{
  archive("peak_F_X", peak_F_X);
  archive("X_at_peak_F_X", X_at_peak_F_X);
  archive("min_F_X", min_F_X);
  archive("peak_F_Y", peak_F_Y);
  archive("peak_F_Z", peak_F_Z);
  archive("F_X_aligned", F_X_aligned);
  archive("F_Z_aligned", F_Z_aligned);
  archive("load_ratio_aligned", load_ratio_aligned);
  archive("load_ratio_end", load_ratio_end);
  archive("work_to_alignment", work_to_alignment);
}

} // namespace brinell::simulation
