// SPDX-License-Identifier: BSD-3-Clause
#include "crosswise_images.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell::halfspace
{

namespace
{

using images::strains;
using images::stresses;

constexpr double pi = std::numbers::pi;
constexpr double blurred_share = 1.0 / 10.0; ///< width of the blur over the short period
/// Waves that have decayed by e^-8 = 3e-4 are omitted; images of long waves are summed until they have decayed by e^-12.
constexpr double decay = 8.0;
constexpr double far_decay = 12.0;

/// Largest ratio of the periods of a lattice whose images a polynomial can represent.
constexpr double tolerated_aspect = 1.2;

/// Distance from the edge of the grid to the nearest image of its other edge [m].
double gap(int cells, double spacing, double period)
{
  return period - (cells - 1) * spacing;
}

/// Pairs of values, at most as many as there are lanes, as complex numbers.
ComplexLanes load_pairs(const double* from, std::size_t count)
{
  if (count == lane_count)
    return load_lanes(reinterpret_cast<const Complex*>(from));
  std::array<Complex, lane_count> pairs{};
  std::copy_n(from, 2 * count, reinterpret_cast<double*>(pairs.data()));
  return load_lanes(pairs.data());
}

void store_pairs(const ComplexLanes& value, std::size_t count, double* to)
{
  std::array<Complex, lane_count> pairs;
  store_lanes(value, pairs.data());
  std::copy_n(reinterpret_cast<const double*>(pairs.data()), 2 * count, to);
}

ComplexLanes times_minus_i(const ComplexLanes& a)
{
  return {a.im, -a.re};
}

} // namespace

int CrosswiseImages::multiple(double period_x, double period_y)
{
  const double aspect = std::max(period_x, period_y) / std::min(period_x, period_y);
  return std::max(1, static_cast<int>(std::ceil(aspect - (tolerated_aspect - 1.0))));
}

CrosswiseImages::CrosswiseImages(const VolumeGrid& grid, const ElasticStack& stack, images::Source source,
                                 double period_x, double period_y)
    : grid_(grid), along_x_(period_x > period_y), multiple_(multiple(period_x, period_y)), waves_(0),
      depth_(grid, stack,
             along_x_ ? gap(grid.surface.ny, grid.surface.dy, period_y)
                      : gap(grid.surface.nx, grid.surface.dx, period_x)),
      coupling_(0, depth_.count, degree, odd_across())
{
  const SurfaceGrid& s = grid.surface;
  const double period_along = std::max(period_x, period_y);
  const double period_across = std::min(period_x, period_y);
  const double nearest = along_x_ ? gap(s.ny, s.dy, period_y) : gap(s.nx, s.dx, period_x);
  waves_ = static_cast<int>(decay / nearest * period_along / (2.0 * pi)) + 1;
  const int cells_along = along_x_ ? s.nx : s.ny;
  const double spacing = along_x_ ? s.dx : s.dy;
  waves_ = std::min(waves_, cells_along); // no more than the padded cells can resolve
  along_ = Matrix(cells_along, 2 * waves_);
  for (int wave = 0; wave < waves_; ++wave)
    for (int i = 0; i < cells_along; ++i)
    {
      const double phase = 2.0 * pi * wave / period_along * i * spacing;
      along_(i, 2 * wave) = std::cos(phase);
      along_(i, 2 * wave + 1) = std::sin(phase);
    }
  along_of_cell_.resize(static_cast<std::size_t>(cells_along * lanes()));
  for (int i = 0; i < cells_along; ++i)
    for (int wave = 0; wave < 2 * waves_; ++wave)
      along_of_cell_[static_cast<std::size_t>(i * lanes() + wave / lane_count)][wave % lane_count] = along_(i, wave);
  coupling_ = WaveCoupling(waves_, depth_.count, degree, odd_across());
#pragma omp parallel for schedule(dynamic)
  for (int wave = 0; wave < waves_; ++wave)
    fit(wave, stack, source, period_along, period_across);
}

const std::array<int, stresses>& CrosswiseImages::odd_along() const
{
  return along_x_ ? images::odd_in_x : images::odd_in_y;
}

const std::array<int, stresses>& CrosswiseImages::odd_across() const
{
  return along_x_ ? images::odd_in_y : images::odd_in_x;
}

/// The waves across the grid for one wave along it, on the lattice with images minus those on the lattice that remains. Images at
/// such a distance that this wave has decayed are omitted.
std::vector<images::WaveRow> CrosswiseImages::waves_across(int wave, double period_along, double period_across) const
{
  const SurfaceGrid& s = grid_.surface;
  const double along = 2.0 * pi * wave / period_along;
  const double width = blurred_share * period_across;
  const int periods =
      wave == 0 ? multiple_ : std::min(multiple_, 2 + static_cast<int>(far_decay / (along * period_across)));
  const double largest = std::max(1, along_x_ ? s.ny - 1 : s.nx - 1) * (along_x_ ? s.dy : s.dx);
  const images::Phases one{std::vector{1.0}, std::vector{1.0}};
  std::vector<images::WaveRow> rows;
  if (!along_x_)
    rows.push_back({along, one, {}});
  for (int j = wave == 0 ? 1 : 0;; ++j)
  {
    const double across = 2.0 * pi * j / (periods * period_across);
    const double k = std::hypot(along, across);
    if (k * width > images::shortest)
      return rows;
    const double copies = (wave == 0 ? 1.0 : 2.0) * (j == 0 ? 1.0 : 2.0);
    const double weight = copies * images::blur(k, width) * ((j % periods == 0 ? 1.0 : 0.0) - 1.0 / periods) /
                          (period_along * period_across);
    if (along_x_)
      rows.push_back({across, images::phases(across, largest), {{along, weight, one}}});
    else
      rows.front().waves.push_back({across, weight, images::phases(across, largest)});
  }
}

/// The factor of the kernel along the grid, cos or sin of m (x - x'), is a sum of products of cos and sin. With the moments
/// sorted as u = (cos of an even component, sin of an odd one) and v = (sin of an even one, -cos of an odd one), the kernel maps
/// u to u and v to v by the same matrix; the sign changes for an even stress by an odd strain.
void CrosswiseImages::fit(int wave, const ElasticStack& stack, images::Source source, double period_along,
                          double period_across)
{
  const std::vector<images::WaveRow> waves = waves_across(wave, period_along, period_across);
  const std::vector<double> samples = images::sampled(waves, depth_.nodes, stack, source);
  const std::array<int, 2> distances{along_x_ ? 1 : images::offset_nodes, along_x_ ? images::offset_nodes : 1};
  for (int c = 0; c < stresses; ++c)
    for (int e = 0; e < images::components_of(source); ++e)
    {
      std::vector<images::Powers> terms;
      for (int b = images::is_odd(odd_across(), c, e) ? 1 : 0; b <= degree; b += 2)
        terms.push_back(along_x_ ? images::Powers{0, b} : images::Powers{b, 0});
      const std::vector<Matrix> values = images::fitted(samples, c, e, distances, depth_, terms);
      const bool changes_sign = is_odd_along(e) && !is_odd_along(c);
      for (std::size_t t = 0; t < terms.size(); ++t)
        coupling_.set(wave, c, e, terms[t][0] + terms[t][1], (changes_sign ? -1.0 : 1.0) * grid_.cell_volume(),
                      values[t]);
    }
}

CrosswiseImages::Response CrosswiseImages::make_response() const
{
  const auto values = [&](int count) { return std::vector<double>(static_cast<std::size_t>(count * block())); };
  return {values(strains * grid_.nz), values(strains * depth_.count), values(stresses * depth_.count),
          AlignedVector<ComplexLanes>(static_cast<std::size_t>(strains * powers * depth_.count)),
          AlignedVector<ComplexLanes>(static_cast<std::size_t>(stresses * powers * depth_.count))};
}

void CrosswiseImages::find_moments_of_layer(const Columns& strain, int first, int end, int component, int layer,
                                            Response& response) const
{
  double* moments = response.of_layers.data() + static_cast<std::ptrdiff_t>((component * grid_.nz + layer) * block());
  for (int part = 0; part < lanes(); ++part)
  {
    std::array<Lanes, powers> sum{};
    for (int i = first; i < end; ++i)
    {
      const Lanes& along = along_of_cell_[static_cast<std::size_t>(i * lanes() + part)];
      for (int b = 0; b < powers; ++b)
        sum[static_cast<std::size_t>(b)] += strain(i, b) * along;
    }
    const int used = std::min(lane_count, 2 * waves_ - part * lane_count);
    for (int b = 0; b < powers; ++b)
      store_lanes(sum[static_cast<std::size_t>(b)], static_cast<std::size_t>(used),
                  moments + b * 2 * waves_ + part * lane_count);
  }
}

void CrosswiseImages::respond(int layers, Response& response, bool is_mirrored, bool with_trace) const
{
#pragma omp parallel for schedule(static)
  for (int e = 0; e < strains; ++e)
    assign_product({response.of_layers.data() + static_cast<std::ptrdiff_t>(e * grid_.nz * block()), block(), layers},
                   {depth_.means, layers, depth_.count},
                   response.moments.data() + static_cast<std::ptrdiff_t>(e * depth_.count * block()));
  for (int part = 0; part < coupling_.parts(); ++part)
    multiply(part, response, along_x_ && is_mirrored, with_trace ? stresses : strains);
}

/// Moments of the strain for some waves -> coefficients of the stress, for u and v (see `fit`).
/// @param is_mirrored  whether the fields are mirror images across the grid
void CrosswiseImages::multiply(int part, Response& response, bool is_mirrored, int components) const
{
  const auto used = static_cast<std::size_t>(std::min(lane_count, waves_ - part * lane_count));
  const auto in_wave_part = [&](int component, int depth, int power) // of cosines and sines by turns
  { return ((component * depth_.count + depth) * powers + power) * 2 * waves_ + 2 * part * lane_count; };
  const auto in_coupling = [&](int component, int depth, int power)
  { return static_cast<std::size_t>((component * powers + power) * depth_.count + depth); };
  const auto for_moments = [&](int count, const auto& use)
  {
    for (int component = 0; component < count; ++component)
      for (int q = 0; q < depth_.count; ++q)
        for (int b = 0; b < powers; ++b)
          use(in_wave_part(component, q, b), in_coupling(component, q, b), b, is_odd_along(component));
  };
  for_moments(strains,
              [&](int from, std::size_t to, int b, bool is_odd)
              {
                const ComplexLanes wave = load_pairs(response.moments.data() + from, used);
                response.of_strain[to] = WaveCoupling::of_strain(b) * (is_odd ? times_minus_i(wave) : wave);
              });
  std::fill(response.of_stress.begin(), response.of_stress.end(), ComplexLanes{});
  coupling_.multiply(part, response.of_strain.data(), is_mirrored, components, response.of_stress.data());
  for_moments(components,
              [&](int to, std::size_t from, int b, bool is_odd)
              {
                const ComplexLanes wave = WaveCoupling::of_stress(b) * response.of_stress[from];
                store_pairs(is_odd ? times_i(wave) : wave, used, response.stress.data() + to);
              });
}

AlignedVector<double> CrosswiseImages::amplitudes(const Response& response, int component, int layer) const
{
  AlignedVector<double> means, in_layer(static_cast<std::size_t>(block()));
  for (int q = 0; q < depth_.count; ++q)
    means.push_back(depth_.means(layer, q));
  assign_product(
      {response.stress.data() + static_cast<std::ptrdiff_t>(component * depth_.count * block()), block(), depth_.count},
      {means.data(), depth_.count, 1}, in_layer.data());
  return in_layer;
}

CrosswiseImages::Columns CrosswiseImages::stress(const Response& response, int component, int layer) const
{
  const AlignedVector<double> in_layer = amplitudes(response, component, layer);
  Columns sums(along_.rows(), powers);
  assign_product(along_, {in_layer.data(), 2 * waves_, powers}, sums.column(0));
  return sums;
}

} // namespace brinell::halfspace
