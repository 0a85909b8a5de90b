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
  // The last wave has s = 0.
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
  // For waves faster than the first one, the heat is quasi-steady and proportional to 1/s^2, and their potential to 1/s^4. They
  // contribute only at the surface.
  factors.at_surface.front() *= 1.0 + waves.beyond(4);
  return factors;
}

std::size_t columns_that_reach(double depth, std::span<const SurfaceWave> along)
{
  constexpr double nothing = 20.0; // e^{-20} = 2e-9, while sums over waves hold to some 1e-5
  const auto end = std::partition_point(along.begin(), along.end(),
                                        [&](const SurfaceWave& wave) { return !(wave.k * depth > nothing); });
  return static_cast<std::size_t>(end - along.begin());
}

DepthSums::DepthSums(std::span<const DepthWave> waves, std::span<const DepthFactors> factors,
                     std::span<const double> left)
    : slow_weight_(waves.back().weight)
{
  const std::size_t count = waves.size() - 1, skipped = factors.front().at_surface.size() - waves.size();
  constexpr double nothing = 1e-20;
  for (std::size_t w = 0; w < count; ++w)
  {
    numbers2_.push_back(waves[w].number * waves[w].number);
    at_surface_.push_back(left[w] * factors.front().at_surface[skipped + w]);
    if (!(left[w] > nothing))
      first_left_ = w + 1;
  }
  for (std::size_t d = 0; d < factors.size(); d += together)
  {
    Group group{count, {}, std::vector<Factors>(count)};
    const std::size_t depths = std::min(together, factors.size() - d);
    for (std::size_t n = 0; n < depths; ++n)
      group.depths[n] = factors[d + n].depth;
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
        if (w >= first_left_ && turned > hardly * waves[w].weight)
          group.first = w;
      }
    groups_.push_back(std::move(group));
  }
}

DepthSums::Row DepthSums::make_row(std::size_t columns) const
{
  const std::size_t blocks = (columns + lane_count - 1) / lane_count;
  Row row;
  row.pitch = 2 * lane_count * blocks;
  row.integrated.resize(blocks * (numbers2_.size() + 1));
  row.at_surface.resize(row.pitch);
  for (AlignedVector<double>* sum : {&row.temperature, &row.potential, &row.slope})
    sum->resize(together * row.pitch);
  return row;
}

void DepthSums::gather(const Along& along, Row& row) const
{
  row.along = along;
  const std::size_t waves = numbers2_.size() + 1;
  for (std::size_t block = 0; 2 * lane_count * block < row.pitch; ++block)
  {
    const ComplexLanes* heat = along.heat + block * waves;
    ComplexLanes* integrated = row.integrated.data() + block * waves;
    const Lanes k = along.k[block], k2 = k * k;
    ComplexLanes sum;
    for (std::size_t w = first_left_; w < numbers2_.size(); ++w)
    {
      integrated[w] = 1.0 / (numbers2_[w] + k2) * heat[w];
      sum = sum + at_surface_[w] * integrated[w];
    }
    store_lanes(along.left[block] * (k * sum + along.slow_share[block] * heat[waves - 1]),
                reinterpret_cast<Complex*>(row.at_surface.data()) + block * lane_count);
  }
}

void DepthSums::sum(std::size_t first, std::size_t columns, Row& row) const
{
  const Group& group = groups_[first / together];
  const std::size_t waves = numbers2_.size() + 1;
  for (std::size_t block = 0; block * lane_count < columns; ++block)
  {
    const ComplexLanes *heat = row.along.heat + block * waves, *integrated = row.integrated.data() + block * waves;
    std::array<ComplexLanes, together> temperature{}, potential{}, slope{};
    for (std::size_t w = group.first; w < numbers2_.size(); ++w)
    {
      const ComplexLanes of_wave = heat[w], divided = integrated[w];
      const Factors& factors = group.factors[w];
      for (std::size_t d = 0; d < together; ++d)
      {
        temperature[d] = temperature[d] + factors.temperature[d] * of_wave;
        potential[d] = potential[d] + factors.potential[d] * divided;
        slope[d] = slope[d] + factors.slope[d] * divided;
      }
    }
    const Lanes k = row.along.k[block], share = row.along.slow_share[block], left = row.along.left[block];
    const ComplexLanes slowest = heat[waves - 1];
    for (std::size_t d = 0; d < together; ++d)
    {
      const auto put = [&](const ComplexLanes& value, AlignedVector<double>& sums)
      { store_lanes(left * value, reinterpret_cast<Complex*>(sums.data() + d * row.pitch) + block * lane_count); };
      put(temperature[d] + slow_weight_ * slowest, row.temperature);
      put(k * potential[d] + share * slowest, row.potential);
      put(slope[d] - group.depths[d] * (slow_weight_ - k * share) * slowest, row.slope);
    }
  }
}

/// Rounding errors of about 1e-16 per depth accumulate.
std::span<const double> DecayInDepth::at(double depth, std::span<const SurfaceWave> along)
{
  const std::size_t count = along.size();
  const double way = depth - depth_;
  constexpr double rounding = 1e-13, nothing = 1e-290;
  const bool goes_on = way >= 0.0 && count <= columns_;
  if (goes_on && (count > stepped_ || std::abs(way - spacing_) > rounding * depth))
  {
    // The distance between the middles of the first two layers is twice the depth of the first one.
    const bool is_twice = count <= columns_ && std::abs(way - 2.0 * depth_) <= rounding * depth;
    for (std::size_t i = 0; i < count; ++i)
      step_[i] = is_twice ? decay_[i] * decay_[i] : std::exp(-along[i].k * way);
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
      decay[i] = next > nothing ? next : 0.0; // arithmetic with subnormal numbers is slow
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
