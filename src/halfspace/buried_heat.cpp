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

/// The same integral from left = e^{-kz}, with a relative error of about 1e-13. It avoids expm1, which would double the time at
/// depths that are not the middle of a layer.
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
Decay decay(double rate, double left, const Lanes& rates, const Lanes& lefts)
{
  const Lanes x = rate + rates, remains = left * lefts;
  const auto is_small = x < 1e-4;
  const Lanes series = 1.0 - x * (0.5 - x * (1.0 / 6.0));
  const Lanes of_all = (1.0 - remains) / (is_small ? Lanes{} + 1.0 : x);
  return {remains, is_small ? series : of_all};
}

} // namespace

BuriedHeat::BuriedHeat(std::shared_ptr<const LayeredConduction> layers, std::span<const SurfaceWave> along,
                       std::size_t plane, double diffusivity)
    : layers_(std::move(layers)), plane_(plane), diffusivity_(diffusivity)
{
  const double half = 0.5 * layers_->thickness(), next = std::numbers::sqrt2 * layers_->thickness();
  for (AlignedVector<double>* of_part :
       {&decays_.half_left, &decays_.half_sum, &decays_.next_left, &decays_.next_sum, &decays_.k})
    of_part->reserve(2 * plane);
  for (std::size_t n = 0; n < 2 * plane; ++n)
  {
    const double k = along[std::min(n / 2, along.size() - 1)].k;
    decays_.k.push_back(k);
    decays_.half_left.push_back(std::exp(-k * half));
    decays_.half_sum.push_back(sum_of(k, half));
    decays_.next_left.push_back(std::exp(-k * next));
    decays_.next_sum.push_back(sum_of(k, next));
  }
}

void BuriedHeat::take_up(const std::vector<AlignedVector<Complex>>& rise, double duration)
{
  const std::size_t n = layers_->size();
  Step step{duration, rise, n, 0, {}, {}};
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
  for (AlignedVector<Complex>* field : {&modes_, &before_, &temperature_})
    field->resize(n * plane_);
  modes_.swap(before_);
  for (const double s2 : layers_->squared_numbers())
  {
    step.rates.push_back(diffusivity_ * s2 * duration);
    step.left.push_back(std::exp(-step.rates.back()));
  }
  plan_step(duration);
  const auto make_scratch = [&]
  {
    const AlignedVector<double> lanes(n * lane_count);
    const Scratch half{lanes, lanes, lanes, lanes};
    return std::array<Scratch, 2>{half, half};
  };
  if (!is_shared(plane_))
  {
    std::array<Scratch, 2> scratch = make_scratch();
    for (std::size_t wave = 0; wave < plane_; wave += lane_count) // a plane has whole cache lines
      step_waves(wave, step, scratch);
  }
  else
  {
#pragma omp parallel
    {
      std::array<Scratch, 2> scratch = make_scratch();
#pragma omp for schedule(static)
      for (std::size_t wave = 0; wave < plane_; wave += lane_count)
        step_waves(wave, step, scratch);
    }
  }
  find_potential_at_surface();
}

/// Decay factors are stored, as most steps have the same duration as the one before.
void BuriedHeat::plan_step(double duration)
{
  if (planned_ && planned_->duration == duration)
    return;
  planned_ = Planned{duration, {}, {}};
  for (std::size_t wave = 0; wave < plane_; ++wave)
  {
    const double k = decays_.k[2 * wave];
    planned_->rates.push_back(diffusivity_ * k * k * duration);
    planned_->left.push_back(std::exp(-planned_->rates.back()));
  }
}

/// A step of the `lane_count` waves from `wave` on. The decay, which is the same for real and imaginary parts, is computed once.
void BuriedHeat::step_waves(std::size_t wave, const Step& step, std::array<Scratch, 2>& halves)
{
  constexpr std::size_t half = lane_count / 2;
  const std::size_t n = layers_->size();
  for (std::size_t h = 0; h < halves.size(); ++h)
  {
    Scratch& scratch = halves[h];
    for (std::size_t j = step.first; j < step.last; ++j)
      store_lanes(step.rise[j].empty()
                      ? Lanes{}
                      : load_lanes(reinterpret_cast<const double*>(step.rise[j].data() + wave + h * half)),
                  lane_count, scratch.rise.data() + j * lane_count);
    if (step.last > 0)
      layers_->to_modes().multiply(scratch.rise.data(), step.first, step.last, scratch.in.data());
  }
  const Lanes rates = load_lanes(planned_->rates.data() + wave), left = load_lanes(planned_->left.data() + wave);
  for (std::size_t l = 0; l < n; ++l)
  {
    const Decay of_mode = decay(step.rates[l], step.left[l], rates, left);
    const auto advance = [&](std::size_t h, const Lanes& remains, const Lanes& share)
    {
      const std::size_t at = l * plane_ + wave + h * half;
      const Lanes mode = remains * load_lanes(reinterpret_cast<const double*>(before_.data() + at)) +
                         share * load_lanes(halves[h].in.data() + l * lane_count);
      store_lanes(mode, lane_count, halves[h].modes.data() + l * lane_count);
      store_lanes(mode, lane_count, reinterpret_cast<double*>(modes_.data() + at));
    };
    const auto twice_low = [](int lane) { return lane / 2; };
    const auto twice_high = [](int lane) { return (lane + lane_count) / 2; };
    advance(0, shuffled(of_mode.left, of_mode.left, twice_low), shuffled(of_mode.in, of_mode.in, twice_low));
    advance(1, shuffled(of_mode.left, of_mode.left, twice_high), shuffled(of_mode.in, of_mode.in, twice_high));
  }
  for (std::size_t h = 0; h < halves.size(); ++h)
    find_temperature_from(wave + h * half, halves[h]);
}

/// Computes the temperatures of neighbouring waves from the modes in `scratch`.
void BuriedHeat::find_temperature_from(std::size_t wave, Scratch& scratch)
{
  const std::size_t n = layers_->size();
  layers_->to_layers().multiply(scratch.modes.data(), 0, n, scratch.warm.data());
  for (std::size_t j = 0; j < n; ++j)
    std::copy_n(scratch.warm.data() + j * lane_count, lane_count,
                reinterpret_cast<double*>(temperature_.data() + j * plane_ + wave));
}

void BuriedHeat::find_temperature()
{
  const std::size_t n = layers_->size();
  temperature_.resize(n * plane_);
  const AlignedVector<double> lanes(n * lane_count);
  Scratch scratch{{}, {}, lanes, lanes};
  for (std::size_t wave = 0; wave < plane_; wave += lane_count / 2)
  {
    for (std::size_t l = 0; l < n; ++l)
      std::copy_n(reinterpret_cast<const double*>(modes_.data() + l * plane_ + wave), lane_count,
                  scratch.modes.data() + l * lane_count);
    find_temperature_from(wave, scratch);
  }
  find_potential_at_surface();
}

void BuriedHeat::go_back()
{
  is_cold_ = was_cold_;
  if (is_cold_)
  {
    std::fill(modes_.begin(), modes_.end(), Complex{});
    std::fill(before_.begin(), before_.end(), Complex{});
    return;
  }
  modes_.swap(before_);
  find_temperature();
}

void BuriedHeat::set_modes(const AlignedVector<Complex>& modes)
{
  modes_ = modes;
  before_.assign(modes.size(), Complex{});
  is_cold_ = was_cold_ = std::all_of(modes.begin(), modes.end(), [](const Complex& mode) { return mode == Complex{}; });
  if (!is_cold_)
    find_temperature();
}

/// The surface is insulated, so the temperature is extrapolated by T = a + b z^2 with the means of the first two layers.
void BuriedHeat::add_surface(std::size_t begin, std::size_t count, Complex* temperature) const
{
  if (is_cold_)
    return;
  const Complex *first = temperature_.data() + begin, *second = first + plane_;
  for (std::size_t i = 0; i < count; ++i)
    temperature[i] += first[i] + (first[i] - second[i]) / 6.0;
}

BuriedHeat::Row BuriedHeat::make_row(std::size_t columns) const
{
  Row row;
  row.pitch = (2 * columns + lane_count - 1) / lane_count * lane_count;
  const std::size_t kinds = 1 + layers_->size() - layers_->heated();
  for (AlignedVector<double>* of_kind : {&row.left, &row.sum})
    of_kind->resize(kinds * row.pitch);
  row.to_surface.resize(layers_->heated() * row.pitch);
  for (AlignedVector<double>* of_layer : {&row.from_above, &row.from_below})
    of_layer->resize((layers_->size() + 1) * row.pitch);
  return row;
}

/// e^{-kh} and its integral for each thickness h, [kind][pitch]; for twice the thickness the factor is the square.
void BuriedHeat::find_decay_over_layers(std::size_t begin, std::size_t parts, std::size_t pitch, double* left,
                                        double* sum) const
{
  const double *half_left = decays_.half_left.data() + 2 * begin, *half_sum = decays_.half_sum.data() + 2 * begin;
#pragma omp simd
  for (std::size_t n = 0; n < parts; ++n)
  {
    left[n] = half_left[n] * half_left[n];
    sum[n] = half_sum[n] * (1.0 + half_left[n]);
  }
  std::copy_n(decays_.next_left.data() + 2 * begin, parts, left + pitch);
  std::copy_n(decays_.next_sum.data() + 2 * begin, parts, sum + pitch);
  for (std::size_t m = 2; m < 1 + layers_->size() - layers_->heated(); ++m)
  {
    const double *once_left = left + (m - 2) * pitch, *once_sum = sum + (m - 2) * pitch;
    double *twice_left = left + m * pitch, *twice_sum = sum + m * pitch;
#pragma omp simd
    for (std::size_t n = 0; n < parts; ++n)
    {
      twice_left[n] = once_left[n] * once_left[n];
      twice_sum[n] = once_sum[n] * (1.0 + once_left[n]);
    }
  }
}

/// Processes the waves in pieces that fit into the cache.
void BuriedHeat::find_potential_at_surface()
{
  constexpr std::size_t piece = 64;
  const std::size_t count = layers_->size(), heated = layers_->heated(), kinds = 1 + count - heated;
  potential_.assign(2 * plane_, 0.0);
#pragma omp parallel if (is_shared(plane_))
  {
    AlignedVector<double> left(kinds * piece), sum(kinds * piece);
#pragma omp for schedule(static)
    for (std::size_t begin = 0; begin < 2 * plane_; begin += piece)
    {
      const std::size_t parts = std::min(piece, 2 * plane_ - begin);
      find_decay_over_layers(begin / 2, parts, piece, left.data(), sum.data());
      double* potential = potential_.data() + begin;
      for (std::size_t j = count; j-- > 0;)
      {
        const std::size_t kind = (j < heated ? 0 : 1 + j - heated) * piece;
        const double *of_left = left.data() + kind, *of_sum = sum.data() + kind, *warm = layer(j, begin / 2);
#pragma omp simd
        for (std::size_t n = 0; n < parts; ++n)
          potential[n] = of_left[n] * potential[n] + warm[n] * of_sum[n];
      }
    }
  }
}

void BuriedHeat::gather(std::size_t begin, std::size_t count, Row& row) const
{
  row.begin = begin;
  row.parts = 2 * count;
  const std::size_t layers = layers_->size(), heated = layers_->heated();
  find_decay_over_layers(begin, row.parts, row.pitch, row.left.data(), row.sum.data());
  const auto pass = [&](std::size_t j, const double* from, double* to)
  {
    const std::size_t kind = (j < heated ? 0 : 1 + j - heated) * row.pitch;
    const double *left = row.left.data() + kind, *sum = row.sum.data() + kind, *warm = layer(j, begin);
#pragma omp simd
    for (std::size_t n = 0; n < row.parts; ++n)
      to[n] = left[n] * from[n] + warm[n] * sum[n];
  };
  const auto of_top = [&](AlignedVector<double>& field, std::size_t j) { return field.data() + j * row.pitch; };
  std::fill_n(of_top(row.from_below, layers), row.parts, 0.0);
  for (std::size_t j = layers; j-- > 0;)
    pass(j, of_top(row.from_below, j + 1), of_top(row.from_below, j));
  std::fill_n(of_top(row.from_above, 0), row.parts, 0.0);
  for (std::size_t j = 0; j + 1 < layers; ++j)
    pass(j, of_top(row.from_above, j), of_top(row.from_above, j + 1));
  std::copy_n(decays_.half_left.data() + 2 * begin, row.parts, row.to_surface.data());
  for (std::size_t j = 1; j < heated; ++j)
  {
    const double *above = of_top(row.to_surface, j - 1), *left = row.left.data();
    double* here = of_top(row.to_surface, j);
#pragma omp simd
    for (std::size_t n = 0; n < row.parts; ++n)
      here[n] = above[n] * left[n];
  }
}

void BuriedHeat::add_potential_at_surface(std::size_t begin, std::size_t count, double factor, Complex* potential) const
{
  auto* parts = reinterpret_cast<double*>(potential);
  for (std::size_t n = 0; n < 2 * count; ++n)
    parts[n] += factor * potential_[2 * begin + n];
}

void BuriedHeat::add(double depth, double factor, const Row& row, const Sums& sums) const
{
  const std::size_t j = layers_->layer_at(depth);
  const double *warm = layer(j, row.begin), *above = row.from_above.data() + j * row.pitch,
               *below = row.from_below.data() + (j + 1) * row.pitch, *surface = row.from_below.data();
  const auto add_part =
      [&](std::size_t n, double left_above, double sum_above, double left_below, double sum_below, double to_surface)
  {
    const double down = left_above * above[n] + sum_above * warm[n], up = left_below * below[n] + sum_below * warm[n],
                 image = to_surface * surface[n];
    sums.potential[n] += 0.5 * factor * (down + up + image);
    sums.slope[n] += 0.5 * factor * (up - down - image);
  };
  if (constexpr double rounding = 1e-9;
      j < layers_->heated() && std::abs(depth - layers_->middle(j)) < rounding * layers_->thickness())
  {
    const double *left = decays_.half_left.data() + 2 * row.begin, *sum = decays_.half_sum.data() + 2 * row.begin,
                 *to_surface = row.to_surface.data() + j * row.pitch;
#pragma omp simd
    for (std::size_t n = 0; n < row.parts; ++n)
    {
      sums.temperature[n] += factor * warm[n];
      add_part(n, left[n], sum[n], left[n], sum[n], to_surface[n]);
    }
    return;
  }
  const double from_top = depth - layers_->top(j), to_bottom = std::max(0.0, layers_->bottom(j) - depth);
  for (std::size_t n = 0; n < row.parts; n += 2)
  {
    const double k = decays_.k[2 * row.begin + n], left_above = std::exp(-k * from_top),
                 left_below = std::exp(-k * to_bottom), to_surface = std::exp(-k * depth),
                 sum_above = sum_of(k, from_top, left_above), sum_below = sum_of(k, to_bottom, left_below);
    for (std::size_t part = n; part < n + 2; ++part)
      add_part(part, left_above, sum_above, left_below, sum_below, to_surface);
  }
  add_temperature_between(depth, factor, row, sums.temperature);
}

/// Above the middle of the first layer the extrapolation of `add_surface` is used, otherwise linear interpolation between the
/// middles.
void BuriedHeat::add_temperature_between(double depth, double factor, const Row& row, double* temperature) const
{
  const LayeredConduction& layers = *layers_;
  std::size_t upper = layers.layer_at(depth);
  if (depth < layers.middle(upper) && upper > 0)
    --upper;
  upper = std::min(upper, layers.size() - 2);
  const double *warm = layer(upper, row.begin), *next = layer(upper + 1, row.begin);
  const double h = layers.thickness(),
               linear = (depth - layers.middle(upper)) / (layers.middle(upper + 1) - layers.middle(upper));
  const double share = depth < layers.middle(0) ? 0.5 * depth * depth / (h * h) - 1.0 / 6.0 : std::min(1.0, linear);
  for (std::size_t n = 0; n < row.parts; ++n)
    temperature[n] += factor * (warm[n] + share * (next[n] - warm[n]));
}

} // namespace brinell::halfspace
