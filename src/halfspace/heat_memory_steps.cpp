// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/lane_functions.hpp"
#include "foundation/sharing.hpp"
#include "heat_memory.hpp"

#include <algorithm>
#include <cmath>

/// Steps of the heat memory.
namespace brinell::halfspace
{

namespace
{

/// Loads the first `count` values of a block; zero in the other lanes.
ComplexLanes load_first(const Complex* from, std::size_t count)
{
  ComplexLanes value;
  if (count == lane_count)
    return load_lanes(from);
  for (std::size_t lane = 0; lane < count; ++lane)
  {
    value.re[lane] = from[lane].real();
    value.im[lane] = from[lane].imag();
  }
  return value;
}

void store_first(const ComplexLanes& value, std::size_t count, Complex* to)
{
  if (count == lane_count)
    return store_lanes(value, to);
  for (std::size_t lane = 0; lane < count; ++lane)
    to[lane] = {value.re[lane], value.im[lane]};
}

/// Calls work(row) for all rows of a plane, by several threads if the plane is large enough.
template <typename Work>
void for_rows(int rows, std::size_t plane, const Work& work)
{
  if (!is_shared(plane))
  {
    for (int row = 0; row < rows; ++row)
      work(row);
    return;
  }
#pragma omp parallel for schedule(static)
  for (int row = 0; row < rows; ++row)
    work(row);
}

} // namespace

void HeatMemory::set_heat(const Heat& heat)
{
  heat_ = heat;
  sums_.reset();
}

/// Decay and phase are stored, as most steps have the same motion as the one before.
void HeatMemory::plan_step(const HeatMotion& motion)
{
  if (step_ && step_->motion == motion)
    return;
  step_ = Step{motion, AlignedVector<StepOfBlock>(k_.size())};
  for_rows(fft_.rows(), fft_.plane(),
           [&](int row)
           {
             for (std::size_t i = 0; i < columns(); ++i)
             {
               const SurfaceWave& wave = row_of_waves(row)[i];
               StepOfBlock& block = step_->blocks[block_of(row) + i / lane_count];
               const std::size_t lane = i % lane_count;
               const double angle = (wave.odd_x * motion.velocity_x + wave.odd_y * motion.velocity_y) * motion.duration;
               block.rate[lane] = diffusivity_ * wave.k * wave.k * motion.duration;
               block.phase[lane] = -angle;
               block.left[lane] = std::exp(-block.rate[lane]);
               block.left_re[lane] = block.left[lane] * std::cos(angle);
               block.left_im[lane] = block.left[lane] * std::sin(angle);
             }
           });
}

namespace
{

/// (1 - e^{-z})/z
ComplexLanes gain_of(const Lanes& x, const Lanes& y, const ComplexLanes& left, bool may_be_small)
{
  constexpr double small = 1e-6;
  const Lanes norm = x * x + y * y, a = 1.0 - left.re, b = -left.im;
  if (!may_be_small)
  {
    const Lanes inverse = 1.0 / norm;
    return {(a * x + b * y) * inverse, (b * x - a * y) * inverse};
  }
  const auto is_small = norm < small; // there the series is used
  const Lanes inverse = 1.0 / (is_small ? Lanes{} + 1.0 : norm);
  const Lanes square_re = x * x - y * y, square_im = 2.0 * x * y;
  return {is_small ? 1.0 - 0.5 * x + square_re * (1.0 / 6.0) : (a * x + b * y) * inverse,
          is_small ? -0.5 * y + square_im * (1.0 / 6.0) : (b * x - a * y) * inverse};
}

/// Heat of one wave in depth after a step, for neighbouring waves along the surface: remains * before + (1 - e^{-x})/x * in, with
/// x = rate + z (see StepOfBlock).
/// @param decays  whether the heat before decays in this step; otherwise all of it remains
template <bool decays, typename Along>
ComplexLanes after_step(const Along& along, const ComplexLanes& in, double rate, double left_in_depth,
                        const ComplexLanes& before)
{
  constexpr double surely_large = 2e-3; // its square exceeds `small`, so that the series is not needed for any wave
  const ComplexLanes gain =
      gain_of(rate + along.rate, along.phase, {left_in_depth * along.left_re, left_in_depth * along.left_im},
              rate < surely_large);
  const Lanes remains = decays ? left_in_depth * along.left : Lanes{} + 1.0;
  return {remains * before.re + gain.re * in.re - gain.im * in.im,
          remains * before.im + gain.re * in.im + gain.im * in.re};
}

} // namespace

void HeatMemory::take_up(std::span<const double> flux, const HeatMotion& motion, Heat* before)
{
  if (before == nullptr)
    return step_from(heat_, flux, motion, true, true);
  before->resize(heat_.size());
  heat_.swap(*before);
  step_from(*before, flux, motion, true, false);
}

void HeatMemory::amend(std::span<const double> flux, const HeatMotion& motion)
{
  step_from(heat_, flux, motion, false, true);
}

/// @param before        `heat_` itself, or the complete heat before the step
/// @param sums_surface  whether the sums at the surface are computed as well, because the step is final
void HeatMemory::step_from(const Heat& before, std::span<const double> flux, const HeatMotion& motion, bool decays,
                           bool sums_surface)
{
  const AlignedVector<Complex> spectrum = fft_.forward(flux);
  const double scale = diffusivity_ / conductivity_ * motion.duration;
  plan_step(motion);
  const std::size_t waves = waves_.waves.size();
  const std::vector<double> left = left_in_depth(motion.duration);
  std::vector<double> rates(waves);
  for (std::size_t w = 0; w < waves; ++w)
    rates[w] = diffusivity_ * std::pow(waves_.waves[w].number, 2) * motion.duration;
  sums_.reset();
  SurfaceWeights weights;
  if (sums_surface)
  {
    sums_ = empty_sums(motion.duration);
    weights = surface_weights(motion.duration);
  }
  const auto step_row = [&](int row)
  {
    for (std::size_t block = 0; block < blocks(); ++block)
    {
      const std::size_t number = block_of(row) + block, first = block * lane_count;
      const std::size_t count = std::min<std::size_t>(lane_count, columns() - first);
      const ComplexLanes in = scale * load_first(spectrum.data() + begin_of(row) + first, count);
      const StepOfBlock along = step_->blocks[number];
      const ComplexLanes* heat_before = before.data() + number * waves;
      ComplexLanes* heat = heat_.data() + number * waves;
      for (std::size_t w = 0; w < waves; ++w)
        heat[w] = decays ? after_step<true>(along, in, rates[w], left[w], heat_before[w])
                         : after_step<false>(along, in, rates[w], left[w], heat_before[w]);
    }
    if (sums_surface) // while the row is in the cache
      sum_row(row, weights, *sums_);
  };
  for_rows(fft_.rows(), fft_.plane(), step_row);
}

HeatMemory::SurfaceWeights HeatMemory::surface_weights(double duration) const
{
  constexpr double nothing = 1e-20;
  const std::vector<double> left = left_in_depth(duration);
  SurfaceWeights weights;
  for (std::size_t w = 0; w < left.size(); ++w)
  {
    if (left[w] <= nothing)
      weights.first_left = w + 1;
    weights.temperature.push_back(left[w] * waves_.waves[w].weight);
  }
  for (std::size_t w = 0; w < at_surface_.size(); ++w)
  {
    weights.potential.push_back(w < weights.first_left ? 0.0 : left[w] * at_surface_[w]);
    weights.potential_now.push_back(at_surface_[w]);
  }
  return weights;
}

HeatMemory::SurfaceSums HeatMemory::empty_sums(double duration) const
{
  const AlignedVector<Complex> plane(fft_.plane() + IndependentRowsFft::slack), none;
  return {duration, plane, waves_.has_fields ? plane : none, waves_.has_fields ? plane : none};
}

void HeatMemory::sum_row(int row, const SurfaceWeights& weights, SurfaceSums& sums) const
{
  const std::size_t waves = waves_.waves.size();
  for (std::size_t block = 0; block < blocks(); ++block)
  {
    const std::size_t number = block_of(row) + block, first = block * lane_count;
    const std::size_t count = std::min<std::size_t>(lane_count, columns() - first), to = begin_of(row) + first;
    const ComplexLanes* heat = heat_of_block(number);
    const Lanes k2 = k_[number] * k_[number];
    ComplexLanes temperature, potential, potential_now;
    for (std::size_t w = weights.first_left; w < waves; ++w)
      temperature = temperature + weights.temperature[w] * heat[w];
    store_first(temperature, count, sums.temperature.data() + to);
    if (!waves_.has_fields)
      continue;
    for (std::size_t w = 0; w + 1 < waves; ++w)
    {
      const double number_of_wave = waves_.waves[w].number;
      const ComplexLanes integrated = 1.0 / (number_of_wave * number_of_wave + k2) * heat[w];
      potential = potential + weights.potential[w] * integrated;
      potential_now = potential_now + weights.potential_now[w] * integrated;
    }
    store_first(potential, count, sums.potential.data() + to);
    store_first(potential_now, count, sums.potential_now.data() + to);
  }
}

HeatMemory::SurfaceSums HeatMemory::find_sums(double duration) const
{
  SurfaceSums sums = empty_sums(duration);
  const SurfaceWeights weights = surface_weights(duration);
  for_rows(fft_.rows(), fft_.plane(), [&](int row) { sum_row(row, weights, sums); });
  return sums;
}

} // namespace brinell::halfspace
