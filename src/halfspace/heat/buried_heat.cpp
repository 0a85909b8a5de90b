// SPDX-License-Identifier: BSD-3-Clause
#include "buried_heat.hpp"

#include "foundation/lane_functions.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell::halfspace
{

namespace
{

/// Integral of e^{-kz} from 0 to z [m].
double sum_of(double k, double z)
{
  return k > 0.0 ? -std::expm1(-k * z) / k : z;
}

/// Integral of e^{-kz} from 0 to z [m], given left = e^{-kz}, with a relative error of about 1e-13. It avoids expm1, which would
/// double the time at depths that are not the middle of a layer.
double sum_of(double k, double z, double left)
{
  constexpr double is_small = 1e-3;
  const double x = k * z;
  return x < is_small ? z * (1.0 - x * (0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0)))) : (1.0 - left) / k;
}

/// Fraction that remains after a step, of the earlier heat of a mode and of the heat generated at a constant rate during the
/// step.
struct Decay
{
  Lanes left, in;
};

/// @param rate, left    kappa s^2 t of the mode, and e^{-rate}
/// @param rates, lefts  kappa k^2 t of the waves in the lanes, and e^{-rates}
Decay decay_of(double rate, double left, const Lanes& rates, const Lanes& lefts)
{
  const Lanes x = rate + rates, remains = left * lefts;
  const auto is_small = x < 1e-4;
  const Lanes series = 1.0 - x * (0.5 - x * (1.0 / 6.0));
  const Lanes of_all = (1.0 - remains) / (is_small ? Lanes{} + 1.0 : x);
  return {remains, is_small ? series : of_all};
}

/// Calls work(block, scratch) for all blocks, by several threads if there are many of them.
template <typename MakeScratch, typename Work>
void for_blocks(std::size_t blocks, const MakeScratch& make_scratch, const Work& work)
{
  if (!is_shared(blocks * lane_count))
  {
    auto scratch = make_scratch();
    for (std::size_t block = 0; block < blocks; ++block)
      work(block, scratch);
    return;
  }
#pragma omp parallel
  {
    auto scratch = make_scratch();
#pragma omp for schedule(static)
    for (std::size_t block = 0; block < blocks; ++block)
      work(block, scratch);
  }
}

void add_lanes(const ComplexLanes& value, double* to)
{
  auto* at = reinterpret_cast<Complex*>(to);
  store_lanes(load_lanes(at) + value, at);
}

} // namespace

BuriedHeat::BuriedHeat(std::shared_ptr<const LayeredConduction> layers, std::span<const SurfaceWave> along,
                       std::size_t columns, double diffusivity)
    : layers_(std::move(layers)), blocks_in_row_((columns + lane_count - 1) / lane_count), diffusivity_(diffusivity)
{
  const double half = 0.5 * layers_->thickness(), next = std::numbers::sqrt2 * layers_->thickness();
  for (std::size_t row = 0; row < along.size(); row += columns)
    for (std::size_t first = 0; first < columns; first += lane_count)
    {
      Block block{row + first, std::min<std::size_t>(lane_count, columns - first), {}, {}, {}, {}, {}};
      for (std::size_t lane = 0; lane < lane_count; ++lane)
      {
        const double k = along[block.wave + std::min(lane, block.count - 1)].k;
        block.k[lane] = k;
        block.half_left[lane] = std::exp(-k * half);
        block.half_sum[lane] = sum_of(k, half);
        block.next_left[lane] = std::exp(-k * next);
        block.next_sum[lane] = sum_of(k, next);
      }
      blocks_.push_back(block);
    }
}

BuriedHeat::Scratch BuriedHeat::make_scratch() const
{
  const AlignedVector<ComplexLanes> waves(layers_->size());
  const AlignedVector<Lanes> decay(kinds());
  return {waves, waves, decay, decay};
}

void BuriedHeat::add_step(const std::vector<AlignedVector<Complex>>& rise, double duration)
{
  const std::size_t n = layers_->size();
  Step step{rise, n, 0, {}, {}};
  for (std::size_t j = 0; j < n; ++j)
    if (!rise[j].empty())
    {
      step.first = std::min(step.first, j);
      step.last = j + 1;
    }
  was_cold_ = is_cold_;
  if (is_cold_ && step.last == 0)
    return;
  is_cold_ = false;
  for (AlignedVector<ComplexLanes>* field : {&modes_, &before_, &temperature_})
    field->resize(n * blocks_.size());
  potential_.resize(blocks_.size());
  modes_.swap(before_);
  for (const double s2 : layers_->squared_numbers())
  {
    step.rates.push_back(diffusivity_ * s2 * duration);
    step.left.push_back(std::exp(-step.rates.back()));
  }
  plan_step(duration);
  for_blocks(
      blocks_.size(), [&] { return make_scratch(); },
      [&](std::size_t block, Scratch& scratch) { step_block(block, step, scratch); });
}

/// Decay factors are stored, as most steps have the same duration as the one before.
void BuriedHeat::plan_step(double duration)
{
  if (planned_ == duration)
    return;
  planned_ = duration;
  for (Block& block : blocks_)
  {
    block.rates = diffusivity_ * block.k * block.k * duration;
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      block.left_along[lane] = std::exp(-block.rates[lane]);
  }
}

void BuriedHeat::step_block(std::size_t number, const Step& step, Scratch& scratch)
{
  const std::size_t n = layers_->size();
  const Block& block = blocks_[number];
  for (std::size_t j = step.first; j < step.last; ++j)
    scratch.rise[j] = step.rise[j].empty() ? ComplexLanes{} : load_lanes(step.rise[j].data() + block.wave, block.count);
  if (step.last > 0)
    layers_->to_modes().multiply(scratch.rise.data(), step.first, step.last, scratch.in.data());
  const ComplexLanes* before = before_.data() + number * n;
  ComplexLanes* modes = modes_.data() + number * n;
  for (std::size_t l = 0; l < n; ++l)
  {
    const Decay of_mode = decay_of(step.rates[l], step.left[l], block.rates, block.left_along);
    modes[l] = of_mode.left * before[l] + of_mode.in * scratch.in[l];
  }
  find_temperature(number, scratch);
}

/// Computes the temperatures of a block from its modes, and their potential at the surface.
void BuriedHeat::find_temperature(std::size_t block, Scratch& scratch)
{
  const std::size_t n = layers_->size();
  ComplexLanes* warm = temperature_.data() + block * n;
  layers_->to_layers().multiply(modes_.data() + block * n, 0, n, warm);
  find_decay_over_layers(blocks_[block], scratch.left.data(), scratch.sum.data());
  ComplexLanes potential;
  for (std::size_t j = n; j-- > 0;)
    potential = scratch.left[kind_of(j)] * potential + scratch.sum[kind_of(j)] * warm[j];
  potential_[block] = potential;
}

void BuriedHeat::restore()
{
  is_cold_ = was_cold_;
  if (is_cold_)
  {
    std::fill(modes_.begin(), modes_.end(), ComplexLanes{});
    std::fill(before_.begin(), before_.end(), ComplexLanes{});
    return;
  }
  modes_.swap(before_);
  for_blocks(
      blocks_.size(), [&] { return make_scratch(); },
      [&](std::size_t block, Scratch& scratch) { find_temperature(block, scratch); });
}

AlignedVector<Complex> BuriedHeat::modes(std::size_t plane) const
{
  const std::size_t n = layers_->size();
  AlignedVector<Complex> modes(n * plane);
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    for (std::size_t l = 0; l < n; ++l)
      for (std::size_t lane = 0; lane < blocks_[b].count; ++lane)
        modes[l * plane + blocks_[b].wave + lane] = {modes_[b * n + l].re[lane], modes_[b * n + l].im[lane]};
  return modes;
}

void BuriedHeat::set_modes(const AlignedVector<Complex>& modes, std::size_t plane)
{
  const std::size_t n = layers_->size();
  is_cold_ = was_cold_ = std::all_of(modes.begin(), modes.end(), [](const Complex& mode) { return mode == Complex{}; });
  for (AlignedVector<ComplexLanes>* field : {&modes_, &before_, &temperature_})
    field->assign(is_cold_ ? 0 : n * blocks_.size(), {});
  if (is_cold_)
    return;
  potential_.resize(blocks_.size());
  Scratch scratch = make_scratch();
  for (std::size_t b = 0; b < blocks_.size(); ++b)
  {
    for (std::size_t l = 0; l < n; ++l)
      modes_[b * n + l] = load_lanes(modes.data() + l * plane + blocks_[b].wave, blocks_[b].count);
    find_temperature(b, scratch);
  }
}

/// The surface is insulated, so the temperature is extrapolated by T = a + b z^2 with the means of the first two layers.
void BuriedHeat::add_surface(Complex* temperature) const
{
  for (std::size_t b = 0; b < blocks_.size() && !is_cold_; ++b)
  {
    const ComplexLanes first = temperature_of(b)[0], second = temperature_of(b)[1];
    const ComplexLanes rise = first + 1.0 / 6.0 * (first - second);
    for (std::size_t lane = 0; lane < blocks_[b].count; ++lane)
      temperature[blocks_[b].wave + lane] += Complex{rise.re[lane], rise.im[lane]};
  }
}

BuriedHeat::Row BuriedHeat::make_row() const
{
  Row row;
  for (AlignedVector<Lanes>* of_kind : {&row.left, &row.sum})
    of_kind->resize(kinds());
  row.to_surface.resize(layers_->heated() * blocks_in_row_);
  for (AlignedVector<ComplexLanes>* of_layer : {&row.from_above, &row.from_below})
    of_layer->resize((layers_->size() + 1) * blocks_in_row_);
  return row;
}

/// e^{-kh} and its integral for each thickness h, [kind]; for twice the thickness the factor is the square.
void BuriedHeat::find_decay_over_layers(const Block& block, Lanes* left, Lanes* sum) const
{
  left[0] = block.half_left * block.half_left;
  sum[0] = block.half_sum * (1.0 + block.half_left);
  left[1] = block.next_left;
  sum[1] = block.next_sum;
  for (std::size_t m = 2; m < kinds(); ++m)
  {
    left[m] = left[m - 2] * left[m - 2];
    sum[m] = sum[m - 2] * (1.0 + left[m - 2]);
  }
}

void BuriedHeat::gather(std::size_t number, Row& row) const
{
  row.first = number * blocks_in_row_;
  const std::size_t layers = layers_->size(), heated = layers_->heated();
  for (std::size_t b = 0; b < blocks_in_row_; ++b)
  {
    const Block& block = blocks_[row.first + b];
    const ComplexLanes* warm = temperature_of(row.first + b);
    ComplexLanes *above = row.from_above.data() + b * (layers + 1), *below = row.from_below.data() + b * (layers + 1);
    find_decay_over_layers(block, row.left.data(), row.sum.data());
    below[layers] = above[0] = {};
    for (std::size_t j = layers; j-- > 0;)
      below[j] = row.left[kind_of(j)] * below[j + 1] + row.sum[kind_of(j)] * warm[j];
    for (std::size_t j = 0; j + 1 < layers; ++j)
      above[j + 1] = row.left[kind_of(j)] * above[j] + row.sum[kind_of(j)] * warm[j];
    Lanes* to_surface = row.to_surface.data() + b * heated;
    to_surface[0] = block.half_left;
    for (std::size_t j = 1; j < heated; ++j)
      to_surface[j] = to_surface[j - 1] * row.left[0];
  }
}

void BuriedHeat::add_potential_at_surface(std::size_t number, double factor, Complex* potential) const
{
  for (std::size_t b = 0; b < blocks_in_row_; ++b)
    add_lanes(factor * potential_[number * blocks_in_row_ + b], reinterpret_cast<double*>(potential + b * lane_count));
}

void BuriedHeat::add(double depth, double factor, const Row& row, const Sums& sums) const
{
  const std::size_t j = layers_->layer_at(depth), layers = layers_->size();
  constexpr double rounding = 1e-9;
  const bool is_middle =
      j < layers_->heated() && std::abs(depth - layers_->middle(j)) < rounding * layers_->thickness();
  const double from_top = depth - layers_->top(j), to_bottom = std::max(0.0, layers_->bottom(j) - depth);
  for (std::size_t b = 0; b < blocks_in_row_; ++b)
  {
    const Block& block = blocks_[row.first + b];
    const ComplexLanes warm = temperature_of(row.first + b)[j], surface = row.from_below[b * (layers + 1)];
    Lanes left_above = block.half_left, sum_above = block.half_sum, left_below = left_above, sum_below = sum_above,
          to_surface{};
    if (is_middle)
      to_surface = row.to_surface[b * layers_->heated() + j];
    for (std::size_t lane = 0; lane < lane_count && !is_middle; ++lane)
    {
      const double k = block.k[lane];
      left_above[lane] = std::exp(-k * from_top);
      left_below[lane] = std::exp(-k * to_bottom);
      to_surface[lane] = std::exp(-k * depth);
      sum_above[lane] = sum_of(k, from_top, left_above[lane]);
      sum_below[lane] = sum_of(k, to_bottom, left_below[lane]);
    }
    const ComplexLanes down = left_above * row.from_above[b * (layers + 1) + j] + sum_above * warm,
                       up = left_below * row.from_below[b * (layers + 1) + j + 1] + sum_below * warm,
                       image = to_surface * surface;
    const std::size_t at = 2 * lane_count * b;
    add_lanes(0.5 * factor * (down + up + image), sums.potential + at);
    add_lanes(0.5 * factor * (up - down - image), sums.slope + at);
    add_lanes(factor * (is_middle ? warm : temperature_between(depth, row.first + b)), sums.temperature + at);
  }
}

/// Above the middle of the first layer the extrapolation of `add_surface` is used, otherwise linear interpolation between the
/// middles.
ComplexLanes BuriedHeat::temperature_between(double depth, std::size_t block) const
{
  const LayeredConduction& layers = *layers_;
  std::size_t upper = layers.layer_at(depth);
  if (depth < layers.middle(upper) && upper > 0)
    --upper;
  upper = std::min(upper, layers.size() - 2);
  const ComplexLanes warm = temperature_of(block)[upper], next = temperature_of(block)[upper + 1];
  const double h = layers.thickness(),
               linear = (depth - layers.middle(upper)) / (layers.middle(upper + 1) - layers.middle(upper));
  const double share = depth < layers.middle(0) ? 0.5 * depth * depth / (h * h) - 1.0 / 6.0 : std::min(1.0, linear);
  return warm + share * (next - warm);
}

} // namespace brinell::halfspace
