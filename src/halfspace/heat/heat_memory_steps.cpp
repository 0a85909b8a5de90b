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

/// Adds the response to the heat of each wave to the sums. Not inlined, like HeatWaves::sum_row.
[[gnu::noinline]] void add_response(const SurfaceSums& response, const AlignedVector<Complex>& heat, SurfaceSums& sums)
{
  for (const auto sum :
       {&SurfaceSums::temperature, &SurfaceSums::potential, &SurfaceSums::potential_now, &SurfaceSums::slowest})
    for (std::size_t i = 0; i < (sums.*sum).size() && i < heat.size(); ++i)
      (sums.*sum)[i] += (response.*sum)[i] * heat[i];
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
  if (!heat_.amended.empty())
    plan_step(heat_.motion);
}

/// Decay and phase are stored, as most steps have the same motion as the one before.
void HeatMemory::plan_step(const HeatMotion& motion)
{
  if (step_ && step_->motion == motion)
    return;
  step_ = Step{motion, AlignedVector<StepOfBlock>(waves_.k.size()), {}, waves_.left_in_depth(motion.duration)};
  for (const DepthWave& wave : waves_.in_depth.waves)
    step_->rates.push_back(waves_.diffusivity * wave.number * wave.number * motion.duration);
  for_rows(waves_.fft.rows(), waves_.fft.plane(),
           [&](int row)
           {
             for (std::size_t i = 0; i < waves_.columns(); ++i)
             {
               const SurfaceWave& wave = waves_.row_of_waves(row)[i];
               StepOfBlock& block = step_->blocks[waves_.block_of(row) + i / lane_count];
               const std::size_t lane = i % lane_count;
               const double angle = (wave.odd_x * motion.velocity_x + wave.odd_y * motion.velocity_y) * motion.duration;
               block.rate[lane] = waves_.diffusivity * wave.k * wave.k * motion.duration;
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

/// (1 - e^{-x})/x of one wave in depth for neighbouring waves along the surface, with x = rate + z (see StepOfBlock): the heat
/// after a step in which unit heat entered.
template <typename Along>
ComplexLanes gain(const Along& along, double rate, double left_in_depth)
{
  constexpr double surely_large = 2e-3; // its square exceeds `small`, so that the series is not needed for any wave
  return gain_of(rate + along.rate, along.phase, {left_in_depth * along.left_re, left_in_depth * along.left_im},
                 rate < surely_large);
}

ComplexLanes operator*(const ComplexLanes& a, const ComplexLanes& b)
{
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

} // namespace

/// Moves the heat so far into `before`, unchanged to the last digit, also where the next step has another motion.
void HeatMemory::add_step(std::span<const double> flux, const HeatMotion& motion, Heat* before)
{
  if (before != nullptr)
  {
    before->waves.resize(heat_.waves.size());
    std::swap(heat_, *before);
  }
  const Heat* from = before != nullptr ? before : &heat_;
  if (!from->amended.empty() && motion != from->motion)
  {
    add_amended(*from);
    from = &heat_;
  }
  plan_step(motion);
  step_from(*from, waves_.heat_of(flux, motion));
  heat_.amended.clear();
}

void HeatMemory::add_to_last_step(std::span<const double> flux, const HeatMotion& motion)
{
  if (!heat_.amended.empty()) // a second time: the sums are computed anew when they are needed
    sums_.reset();
  if (!heat_.amended.empty() && motion != heat_.motion)
    add_amended(heat_);
  plan_step(motion);
  const AlignedVector<Complex> more = waves_.heat_of(flux, motion);
  heat_.motion = motion;
  heat_.amended.resize(more.size());
  for (std::size_t i = 0; i < more.size(); ++i)
    heat_.amended[i] += more[i];
  if (!sums_)
    return;
  if (sums_->duration != motion.duration)
    return sums_.reset();
  if (!step_->response)
    step_->response = find_response();
  add_response(*step_->response, more, *sums_);
}

/// A step of the planned motion from `before`, which may be `heat_` itself: the heat decays, and new heat is added.
/// What was amended in the step before had the same motion, so that both are added with the same factor.
void HeatMemory::step_from(const Heat& before, const AlignedVector<Complex>& heat)
{
  const std::size_t waves = waves_.in_depth.waves.size();
  sums_ = waves_.empty_sums(step_->motion.duration);
  const SurfaceWeights weights = waves_.surface_weights(step_->motion.duration);
  const bool has_amended = !before.amended.empty();
  const auto step_row = [&](int row)
  {
    ComplexLanes* const of_row = heat_.waves.data() + waves_.block_of(row) * waves;
    for (std::size_t block = 0; block < waves_.blocks(); ++block)
    {
      const std::size_t number = waves_.block_of(row) + block, first = block * lane_count;
      const std::size_t count = std::min<std::size_t>(lane_count, waves_.columns() - first);
      const ComplexLanes in = load_lanes(heat.data() + waves_.begin_of(row) + first, count);
      const ComplexLanes amended =
          has_amended ? load_lanes(before.amended.data() + waves_.begin_of(row) + first, count) : ComplexLanes{};
      const StepOfBlock along = step_->blocks[number];
      const ComplexLanes* heat_before = before.waves.data() + number * waves;
      for (std::size_t w = 0; w < waves; ++w)
      {
        const Lanes remains = step_->left[w] * along.left;
        of_row[block * waves + w] =
            remains * heat_before[w] + gain(along, step_->rates[w], step_->left[w]) * (in + remains * amended);
      }
    }
    waves_.sum_row(row, of_row, weights, *sums_); // while the row is in the cache
  };
  for_rows(waves_.fft.rows(), waves_.fft.plane(), step_row);
}

/// The waves of a row with what was amended.
void HeatMemory::fill_amended(int row, const Complex* amended, const ComplexLanes* before, ComplexLanes* heat) const
{
  const std::size_t waves = waves_.in_depth.waves.size();
  for (std::size_t block = 0; block < waves_.blocks(); ++block)
  {
    const std::size_t first = block * lane_count;
    const std::size_t count = std::min<std::size_t>(lane_count, waves_.columns() - first);
    const ComplexLanes in = load_lanes(amended + waves_.begin_of(row) + first, count);
    const StepOfBlock along = step_->blocks[waves_.block_of(row) + block];
    for (std::size_t w = 0; w < waves; ++w)
    {
      const ComplexLanes added = gain(along, step_->rates[w], step_->left[w]) * in;
      heat[block * waves + w] = before != nullptr ? before[block * waves + w] + added : added;
    }
  }
}

/// All waves of a row.
/// @param buffer  used if heat was amended
const ComplexLanes* HeatMemory::heat_of_row(int row, RowOfHeat& buffer) const
{
  const ComplexLanes* waves = heat_.waves.data() + waves_.block_of(row) * waves_.in_depth.waves.size();
  if (heat_.amended.empty())
    return waves;
  buffer.resize(waves_.blocks() * waves_.in_depth.waves.size());
  fill_amended(row, heat_.amended.data(), waves, buffer.data());
  return buffer.data();
}

/// Computes the waves of `from`, which may be `heat_` itself, with what was amended, before a step of another motion.
void HeatMemory::add_amended(const Heat& from)
{
  for_rows(waves_.fft.rows(), waves_.fft.plane(),
           [&](int row)
           {
             const std::size_t first = waves_.block_of(row) * waves_.in_depth.waves.size();
             fill_amended(row, from.amended.data(), from.waves.data() + first, heat_.waves.data() + first);
           });
  heat_.amended.clear();
}

/// Response of the sums to unit heat in each wave along the surface, in a step of the planned motion.
SurfaceSums HeatMemory::find_response() const
{
  SurfaceSums response = waves_.empty_sums(step_->motion.duration);
  const SurfaceWeights weights = waves_.surface_weights(step_->motion.duration);
  const AlignedVector<Complex> unit(waves_.fft.plane(), Complex{1.0, 0.0});
  for_rows(waves_.fft.rows(), waves_.fft.plane(),
           [&](int row)
           {
             RowOfHeat heat(waves_.blocks() * waves_.in_depth.waves.size());
             fill_amended(row, unit.data(), nullptr, heat.data());
             waves_.sum_row(row, heat.data(), weights, response);
           });
  return response;
}

/// After the duration of the amended step, what was amended is added to the sums of the rest as `add_to_last_step` does, so that a run that
/// goes on from a checkpoint gets the same digits.
SurfaceSums HeatMemory::find_sums(double duration) const
{
  SurfaceSums sums = waves_.empty_sums(duration);
  const SurfaceWeights weights = waves_.surface_weights(duration);
  const bool adds_response = !heat_.amended.empty() && duration == heat_.motion.duration;
  for_rows(waves_.fft.rows(), waves_.fft.plane(),
           [&](int row)
           {
             RowOfHeat buffer;
             waves_.sum_row(row,
                            adds_response ? heat_.waves.data() + waves_.block_of(row) * waves_.in_depth.waves.size()
                                          : heat_of_row(row, buffer),
                            weights, sums);
           });
  if (adds_response)
    add_response(step_->response ? *step_->response : find_response(), heat_.amended, sums);
  return sums;
}

} // namespace brinell::halfspace
