// SPDX-License-Identifier: BSD-3-Clause
#include "stress_samples.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>
#include <utility>

namespace brinell::simulation
{

StressSamples::StressSamples(const VolumeGrid& grid, int numbers)
    : columns_(grid.surface.nx), rows_(grid.surface.independent_rows()), layers_(grid.nz), numbers_(numbers)
{
}

double StressSamples::error() const
{
  float largest = 0.0F;
  for (const Sample& sample : samples_)
    largest = std::max(largest, sample.error);
  return largest;
}

Sample& StressSamples::add(int first, int count)
{
  Sample& sample = samples_.emplace_back();
  sample.first = first;
  sample.count = count;
  if (!spare_.empty())
  {
    sample.values = std::move(spare_.back());
    spare_.pop_back();
  }
  sample.values.resize(size(count));
  return sample;
}

/// Largest distance of a cell from the chord between its neighbours in time, over the columns of all three.
float StressSamples::off_chord(const Sample& before, const Sample& here, const Sample& after) const
{
  const int first = std::max({before.first, here.first, after.first}),
            end = std::min({before.first + before.count, here.first + here.count, after.first + after.count});
  if (end <= first)
    return std::numeric_limits<float>::infinity();
  float farthest = 0.0F;
#pragma omp parallel for schedule(static) reduction(max : farthest)
  for (int s = 0; s < strips(); ++s)
  {
    const auto at = [&](const Sample& sample, int n) { return strip(sample, s) + n * sample.count - sample.first; };
    for (int i = first; i < end; ++i)
    {
      float along = 0.0F, chord = 0.0F, square = 0.0F;
      for (int n = 0; n < numbers_; ++n)
      {
        const float from = at(before, n)[i], d = at(after, n)[i] - from, e = at(here, n)[i] - from;
        along += d * e;
        chord += d * d;
        square += e * e;
      }
      const float share = chord > 0.0F ? std::clamp(along / chord, 0.0F, 1.0F) : 0.0F;
      farthest = std::max(farthest, square - share * (2.0F * along - share * chord));
    }
  }
  return std::sqrt(std::max(0.0F, farthest));
}

/// Finds what leaving out a sample would cost; samples beside it that are left out already lie near a hull that this one carries.
void StressSamples::find_cost(std::size_t n)
{
  if (n > 0 && n + 1 < samples_.size())
    samples_[n].cost =
        off_chord(samples_[n - 1], samples_[n], samples_[n + 1]) + std::max(samples_[n].error, samples_[n + 1].error);
}

void StressSamples::thin()
{
  if (samples_.size() < 3)
    return;
  std::size_t stored = 0;
  for (const Sample& sample : samples_)
    stored += sample.values.size();
  while (stored > size(columns_) * fatigue_samples && samples_.size() > 3)
  {
    for (std::size_t n = 1; n + 1 < samples_.size(); ++n)
      if (samples_[n].cost < 0.0F)
        find_cost(n);
    const auto least = std::min_element(samples_.begin() + 1, samples_.end() - 1,
                                        [](const Sample& one, const Sample& other) { return one.cost < other.cost; });
    if (!std::isfinite(least->cost))
      return;
    stored -= least->values.size();
    (least + 1)->error = least->cost;
    (least - 1)->cost = (least + 1)->cost = -1.0F;
    spare_.push_back(std::move(least->values));
    samples_.erase(least);
  }
}

void StressSamples::restart()
{
  for (; samples_.size() > 1; samples_.erase(samples_.begin()))
    spare_.push_back(std::move(samples_.front().values));
  for (Sample& sample : samples_)
  {
    sample.error = 0.0F;
    sample.cost = -1.0F;
  }
}

void StressSamples::move_to(const VolumeGrid& grid, int columns, int rows, const Sample& untouched)
{
  StressSamples moved(grid, numbers_);
  for (const Sample& old : samples_)
  {
    const bool is_whole = old.first == 0 && old.count == columns_;
    Sample& sample = is_whole ? moved.add(0, grid.surface.nx) : moved.add(old.first + columns, old.count);
    sample.error = old.error;
    for (int k = 0; k < moved.layers_; ++k)
      for (int j = 0; j < moved.rows_; ++j)
        for (int n = 0; n < numbers_; ++n)
        {
          const int strip_here = k * moved.rows_ + j, row = j - rows;
          float* to = sample.values.data() +
                      static_cast<std::size_t>(strip_here * numbers_ + n) * static_cast<std::size_t>(sample.count);
          std::copy_n(moved.strip(untouched, strip_here) + n * untouched.count + sample.first, sample.count, to);
          if (k < layers_ && row >= 0 && row < rows_)
            std::copy_n(strip(old, k * rows_ + row) + n * old.count, old.count,
                        to + (old.first + columns - sample.first));
        }
  }
  *this = std::move(moved);
}

void StressSamples::exchange(Archive& archive)
{
  std::size_t count = samples_.size();
  archive("count", count, 0, std::size_t{1} << 24);
  samples_.resize(count);
  for (std::size_t n = 0; n < count; ++n)
  {
    Sample& sample = samples_[n];
    const std::string name = fmt::format("sample_{}", n);
    archive(name + ".first", sample.first, 0, columns_);
    archive(name + ".count", sample.count, 0, columns_ - sample.first);
    archive(name + ".error", sample.error);
    std::vector<double> values(sample.values.begin(), sample.values.end());
    values.resize(size(sample.count));
    archive(name + ".values", values);
    if (archive.gives())
    {
      sample.values.resize(values.size());
      std::ranges::transform(values, sample.values.begin(), [](double value) { return static_cast<float>(value); });
    }
  }
}

} // namespace brinell::simulation
