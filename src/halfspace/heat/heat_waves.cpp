// SPDX-License-Identifier: BSD-3-Clause
#include "heat_waves.hpp"

#include "foundation/lane_functions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brinell::halfspace
{

HeatWaves::HeatWaves(const SurfaceGrid& grid, int px, int py, const Thermal& thermal, DepthWaves waves,
                     const DepthFactors& surface, std::shared_ptr<const HeatCoat> coat_of_body)
    : fft(grid, px, py), diffusivity(thermal.diffusivity()), conductivity(thermal.conductivity),
      coat(std::move(coat_of_body)), in_depth(std::move(waves)),
      at_surface(surface.at_surface.end() - static_cast<std::ptrdiff_t>(in_depth.waves.size()),
                 surface.at_surface.end() - 1)
{
  for (int row = 0; row < fft.rows(); ++row)
    for (int i = 0; i < fft.kx(); ++i)
    {
      const double kx = fft.wavenumber_x(i), ky = fft.wavenumber_y(row);
      along.push_back({kx, ky, std::hypot(kx, ky), 2 * i == px ? 0.0 : kx, 2 * row == py ? 0.0 : ky});
    }
  for (int row = 0; row < fft.rows(); ++row)
    for (std::size_t i = 0; i < lane_count * blocks(); ++i)
    {
      if (i % lane_count == 0)
        k.emplace_back();
      k.back()[i % lane_count] = row_of_waves(row)[std::min(i, columns() - 1)].k;
    }
  for (std::size_t n = 0; in_depth.has_fields && n < k.size(); ++n)
  {
    Lanes& share = slow_share.emplace_back();
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      share[lane] = in_depth.slow_share(k[n][lane]);
  }
}

std::span<const SurfaceWave> HeatWaves::row_of_waves(int row) const
{
  return std::span(along).subspan(begin_of(row), columns());
}

std::vector<double> HeatWaves::left_in_depth(double duration) const
{
  std::vector<double> left;
  left.reserve(in_depth.waves.size());
  for (const DepthWave& wave : in_depth.waves)
    left.push_back(std::exp(-diffusivity * wave.number * wave.number * duration));
  return left;
}

AlignedVector<Complex> HeatWaves::heat_of(std::span<const double> flux, const HeatMotion& motion) const
{
  AlignedVector<Complex> heat = fft.forward(flux);
  const double scale = diffusivity / conductivity * motion.duration;
  for (Complex& wave : heat)
    wave *= scale;
  return heat;
}

SurfaceWeights HeatWaves::surface_weights(double duration) const
{
  constexpr double nothing = 1e-20;
  const std::vector<double> left = left_in_depth(duration);
  SurfaceWeights weights;
  weights.left = left;
  for (std::size_t w = 0; w < left.size(); ++w)
  {
    if (left[w] <= nothing)
      weights.first_left = w + 1;
    weights.temperature.push_back(left[w] * in_depth.waves[w].weight);
  }
  for (std::size_t w = 0; w < at_surface.size(); ++w)
  {
    weights.potential.push_back(w < weights.first_left ? 0.0 : left[w] * at_surface[w]);
    weights.potential_now.push_back(at_surface[w]);
  }
  return weights;
}

SurfaceSums HeatWaves::empty_sums(double duration) const
{
  const AlignedVector<Complex> plane(fft.plane()), none;
  const AlignedVector<Complex>& of_fields = in_depth.has_fields ? plane : none;
  return {duration, plane, of_fields, of_fields, of_fields};
}

namespace
{

void store_first(const ComplexLanes& value, std::size_t count, Complex* to)
{
  if (count == lane_count)
    return store_lanes(value, to);
  for (std::size_t lane = 0; lane < count; ++lane)
    to[lane] = {value.re[lane], value.im[lane]};
}

} // namespace

ComplexLanes HeatWaves::coated_sum(HeatCoat::Part part, std::size_t depth, const HeatCoat::Place& place,
                                   const ComplexLanes* heat, std::span<const double> left,
                                   std::span<Lanes> buffer) const
{
  coat->weights(part, depth, place, buffer);
  ComplexLanes sum;
  for (std::size_t w = 0; w < buffer.size(); ++w)
    sum = sum + left[w] * buffer[w] * heat[w];
  return sum;
}

void HeatWaves::sum_row(int row, const ComplexLanes* heat, const SurfaceWeights& weights, SurfaceSums& sums) const
{
  const std::size_t waves = in_depth.waves.size();
  AlignedVector<Lanes> coated(coat ? waves : 0);
  for (std::size_t block = 0; block < blocks(); ++block, heat += waves)
  {
    const std::size_t number = block_of(row) + block, first = block * lane_count;
    const std::size_t count = std::min<std::size_t>(lane_count, columns() - first), to = begin_of(row) + first;
    const Lanes k2 = k[number] * k[number];
    ComplexLanes temperature, potential, potential_now;
    for (std::size_t w = weights.first_left; w < waves && !(coat && coat->is_excess()); ++w)
      temperature = temperature + weights.temperature[w] * heat[w];
    if (coat)
      temperature =
          temperature + coated_sum(HeatCoat::Part::surface, 0, coat->place_of(k[number]), heat, weights.left, coated);
    store_first(temperature, count, sums.temperature.data() + to);
    if (!in_depth.has_fields || coat)
      continue;
    for (std::size_t w = 0; w + 1 < waves; ++w)
    {
      const double number_of_wave = in_depth.waves[w].number;
      const ComplexLanes integrated = 1.0 / (number_of_wave * number_of_wave + k2) * heat[w];
      potential = potential + weights.potential[w] * integrated;
      potential_now = potential_now + weights.potential_now[w] * integrated;
    }
    store_first(potential, count, sums.potential.data() + to);
    store_first(potential_now, count, sums.potential_now.data() + to);
    store_first(heat[waves - 1], count, sums.slowest.data() + to);
  }
}

std::vector<double> HeatWaves::whole(const AlignedVector<Complex>& planes) const
{
  const std::size_t all = fft.whole_plane();
  AlignedVector<Complex> plane(all);
  std::vector<double> values;
  values.reserve(2 * planes.size() / fft.plane() * all);
  for (std::size_t at = 0; at < planes.size(); at += fft.plane())
  {
    fft.complete(planes.data() + at, plane.data());
    const auto* parts = reinterpret_cast<const double*>(plane.data());
    values.insert(values.end(), parts, parts + 2 * all);
  }
  return values;
}

AlignedVector<Complex> HeatWaves::independent_rows_of(std::span<const double> values) const
{
  const std::size_t all = 2 * fft.whole_plane(), planes = values.size() / all;
  AlignedVector<Complex> rows(planes * fft.plane());
  for (std::size_t p = 0; p < planes; ++p)
    std::copy_n(values.data() + p * all, 2 * columns() * static_cast<std::size_t>(fft.rows()),
                reinterpret_cast<double*>(rows.data() + p * fft.plane()));
  return rows;
}

} // namespace brinell::halfspace
