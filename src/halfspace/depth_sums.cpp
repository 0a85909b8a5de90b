// SPDX-License-Identifier: BSD-3-Clause
#include "depth_sums.hpp"

#include "foundation/lane_functions.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::halfspace
{

namespace
{

DepthFactors factors_at(const DepthWaves& waves, const TurnedWaves& turned_waves, double depth)
{
  DepthFactors factors = surface_factors(waves);
  factors.depth = depth;
  // The last wave does not turn at all.
  std::vector<TurnedWave> turned_at_depth = turned_waves(waves.waves.front().number * depth, waves.waves.size() - 1);
  turned_at_depth.push_back({1.0, 0.0});
  for (std::size_t w = 0; w < waves.waves.size(); ++w)
  {
    const DepthWave& wave = waves.waves[w];
    const TurnedWave& turned = turned_at_depth[w];
    factors.temperature.push_back(wave.weight * turned.cosine);
    factors.potential.push_back(wave.weight * turned.cosine);
    factors.slope.push_back(-wave.weight * wave.number * turned.sine);
  }
  if (depth == 0.0)
  {
    factors.temperature.front() *= 1.0 + waves.beyond(2);
    factors.potential.front() *= 1.0 + waves.beyond(4);
  }
  return factors;
}

} // namespace

std::vector<DepthFactors> depth_factors(const DepthWaves& waves, std::span<const double> depths)
{
  const TurnedWaves turned_waves(waves.step);
  std::vector<DepthFactors> factors;
  factors.reserve(depths.size());
  for (const double depth : depths)
    factors.push_back(factors_at(waves, turned_waves, depth));
  return factors;
}

DepthFactors surface_factors(const DepthWaves& waves)
{
  DepthFactors factors{0.0, {}, {}, {}, {}};
  for (const DepthWave& wave : waves.waves)
    factors.at_surface.push_back(wave.weight);
  // Of a flux that they are at rest in, waves faster than the first have 1/s^2; the potential, 1/s^4. Only at the surface they count.
  factors.at_surface.front() *= 1.0 + waves.beyond(4);
  return factors;
}

std::size_t columns_that_reach(double depth, std::span<const SurfaceWave> along)
{
  constexpr double nothing = 20.0; // e^{-20} = 2e-9, while sums over waves hold to some 1e-5
  const auto end =
      std::find_if(along.begin(), along.end(), [&](const SurfaceWave& wave) { return wave.k * depth > nothing; });
  return static_cast<std::size_t>(end - along.begin());
}

DepthSums::DepthSums(std::span<const DepthWave> waves, std::span<const DepthFactors> factors,
                     std::span<const double> left)
{
  const std::size_t count = waves.size() - 1, skipped = factors.front().at_surface.size() - waves.size();
  constexpr double nothing = 1e-20;
  for (std::size_t w = 0; w < count; ++w)
  {
    numbers2_.push_back(waves[w].number * waves[w].number);
    at_surface_.push_back(left[w] * factors.front().at_surface[skipped + w]);
    is_left_.push_back(left[w] > nothing);
  }
  if (factors.front().temperature.empty())
    return;
  for (std::size_t d = 0; d < factors.size(); d += together)
  {
    Group group{count, std::vector<Factors>(count)};
    const std::size_t depths = std::min(together, factors.size() - d);
    for (std::size_t w = count; w-- > 0;)
      for (std::size_t n = 0; n < depths; ++n)
      {
        const DepthFactors& f = factors[d + n];
        const std::size_t at = skipped + w;
        group.factors[w].temperature[n] = left[w] * f.temperature[at];
        group.factors[w].potential[n] = left[w] * f.potential[at];
        group.factors[w].slope[n] = left[w] * f.slope[at];
        constexpr double hardly = 1e-7;
        const double turned =
            std::max(std::abs(f.temperature[at]), std::abs(f.slope[at]) / std::max(waves[w].number, 1e-300));
        if (is_left_[w] && turned > hardly * waves[w].weight)
          group.first = w;
      }
    groups_.push_back(std::move(group));
  }
}

DepthSums::Row DepthSums::make_row(std::size_t columns) const
{
  Row row;
  row.pitch = (2 * columns + lane_count - 1) / lane_count * lane_count;
  const std::size_t stored = has_layers() ? numbers2_.size() * row.pitch : 0;
  row.heat.resize(stored);
  row.integrated.resize(stored);
  row.k2.assign(columns, 1.0);
  row.at_surface.resize(row.pitch);
  for (AlignedVector<double>* sum : {&row.temperature, &row.potential, &row.slope})
    sum->resize(has_layers() ? together * row.pitch : 0);
  return row;
}

namespace
{

/// A row divided by k^2 + s^2, with one division for both parts of a value. `take` gets some parts of it from a number on.
template <typename Take>
void divide_row(const double* from, const AlignedVector<double>& k2, double s2, std::size_t columns, const Take& take)
{
  std::size_t i = 0;
  for (; i + lane_count <= columns; i += lane_count)
  {
    const Lanes inverse = 1.0 / (s2 + load_lanes(k2.data() + i));
    const std::size_t low = 2 * i, high = low + lane_count;
    take(low, lane_count, load_lanes(from + low),
         __builtin_shufflevector(inverse, inverse, 0, 0, 1, 1, 2, 2, 3, 3) * load_lanes(from + low));
    take(high, lane_count, load_lanes(from + high),
         __builtin_shufflevector(inverse, inverse, 4, 4, 5, 5, 6, 6, 7, 7) * load_lanes(from + high));
  }
  for (; i < columns; ++i)
  {
    const Lanes value = load_lanes(from + 2 * i, 2);
    take(2 * i, 2, value, (1.0 / (s2 + k2[i])) * value);
  }
}

} // namespace

void DepthSums::gather(std::span<const SurfaceWave> along, const Complex* heat, std::size_t apart, Row& row) const
{
  for (std::size_t i = 0; i < along.size(); ++i)
    row.k2[i] = along[i].k * along[i].k;
  std::fill(row.at_surface.begin(), row.at_surface.end(), 0.0);
  for (std::size_t w = 0; w < numbers2_.size(); ++w)
  {
    if (!is_left_[w])
      continue;
    const auto* from = reinterpret_cast<const double*>(heat + w * apart);
    const double of_surface = at_surface_[w];
    double *sum = row.at_surface.data(), *packed = row.heat.data() + w * row.pitch,
           *integrated = row.integrated.data() + w * row.pitch;
    const auto add = [&](std::size_t n, std::size_t count, const Lanes& divided)
    { store_lanes(load_lanes(sum + n, count) + of_surface * divided, count, sum + n); };
    if (!has_layers())
      divide_row(from, row.k2, numbers2_[w], along.size(),
                 [&](std::size_t n, std::size_t count, const Lanes&, const Lanes& divided) { add(n, count, divided); });
    else
      divide_row(from, row.k2, numbers2_[w], along.size(),
                 [&](std::size_t n, std::size_t count, const Lanes& value, const Lanes& divided)
                 {
                   store_lanes(value, count, packed + n);
                   store_lanes(divided, count, integrated + n);
                   add(n, count, divided);
                 });
  }
}

void DepthSums::sum(std::size_t first, std::size_t columns, Row& row) const
{
  const Group& group = groups_[first / together];
  for (std::size_t n = 0; n < 2 * columns; n += lane_count)
  {
    std::array<Lanes, together> temperature{}, potential{}, slope{};
    for (std::size_t w = group.first; w < numbers2_.size(); ++w)
    {
      const Lanes heat = load_lanes(row.heat.data() + w * row.pitch + n);
      const Lanes integrated = load_lanes(row.integrated.data() + w * row.pitch + n);
      const Factors& factors = group.factors[w];
      for (std::size_t d = 0; d < together; ++d)
      {
        temperature[d] += factors.temperature[d] * heat;
        potential[d] += factors.potential[d] * integrated;
        slope[d] += factors.slope[d] * integrated;
      }
    }
    for (std::size_t d = 0; d < together; ++d)
    {
      store_lanes(temperature[d], lane_count, row.temperature.data() + d * row.pitch + n);
      store_lanes(potential[d], lane_count, row.potential.data() + d * row.pitch + n);
      store_lanes(slope[d], lane_count, row.slope.data() + d * row.pitch + n);
    }
  }
}

/// From depth to depth rounding adds up to some 1e-16 each.
std::span<const double> DecayInDepth::at(double depth, std::span<const SurfaceWave> along)
{
  const std::size_t count = along.size();
  const double way = depth - depth_;
  constexpr double rounding = 1e-13, nothing = 1e-290;
  const bool goes_on = way >= 0.0 && count <= columns_;
  if (goes_on && (count > stepped_ || std::abs(way - spacing_) > rounding * depth))
  {
    for (std::size_t i = 0; i < count; ++i)
      step_[i] = std::exp(-along[i].k * way);
    spacing_ = way;
    stepped_ = count;
  }
  if (goes_on)
  {
    double* decay = decay_.data();
    const double* step = step_.data();
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i)
    {
      const double next = decay[i] * step[i];
      decay[i] = next > nothing ? next : 0.0; // numbers below the normal ones are slow
    }
  }
  else
    for (std::size_t i = 0; i < count; ++i)
      decay_[i] = std::exp(-along[i].k * depth);
  columns_ = count;
  depth_ = depth;
  return std::span<const double>(decay_).first(count);
}

} // namespace brinell::halfspace
