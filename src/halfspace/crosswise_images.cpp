// SPDX-License-Identifier: BSD-3-Clause
#include "halfspace/crosswise_images.hpp"

#include "foundation/lane_functions.hpp"

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
/// Waves that have decayed to e^-8 = 3e-4 of what they were are left out; images of long ones are not summed beyond e^-12.
constexpr double decay = 8.0;
constexpr double far_decay = 12.0;

/// A lattice whose periods are as 1 to this has images that a polynomial still follows.
constexpr double tolerated_aspect = 1.2;

using Plane = Eigen::Map<Eigen::MatrixXd>;
using ConstPlane = Eigen::Map<const Eigen::MatrixXd>;

/// From the edge of the grid to the next image of its other edge [m].
double gap(int cells, double spacing, double period)
{
  return period - (cells - 1) * spacing;
}

} // namespace

int CrosswiseImages::multiple(double period_x, double period_y)
{
  const double aspect = std::max(period_x, period_y) / std::min(period_x, period_y);
  return std::max(1, static_cast<int>(std::ceil(aspect - (tolerated_aspect - 1.0))));
}

CrosswiseImages::CrosswiseImages(const VolumeGrid& grid, const Elastic& elastic, double period_x, double period_y)
    : grid_(grid), along_x_(period_x > period_y), multiple_(multiple(period_x, period_y)), waves_(0),
      depth_(grid, along_x_ ? gap(grid.surface.ny, grid.surface.dy, period_y)
                            : gap(grid.surface.nx, grid.surface.dx, period_x))
{
  const SurfaceGrid& s = grid.surface;
  const double period_along = std::max(period_x, period_y);
  const double period_across = std::min(period_x, period_y);
  const double nearest = along_x_ ? gap(s.ny, s.dy, period_y) : gap(s.nx, s.dx, period_x);
  waves_ = static_cast<int>(decay / nearest * period_along / (2.0 * pi)) + 1;
  const int cells_along = along_x_ ? s.nx : s.ny;
  const double spacing = along_x_ ? s.dx : s.dy;
  waves_ = std::min(waves_, cells_along); // at most all waves that the padded cells tell
  along_.resize(cells_along, 2 * waves_);
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
  coupling_.assign(static_cast<std::size_t>(waves_), empty_coupling());
#pragma omp parallel for schedule(dynamic)
  for (int wave = 0; wave < waves_; ++wave)
    fit(wave, elastic, period_along, period_across);
}

const std::array<int, stresses>& CrosswiseImages::odd_along() const
{
  return along_x_ ? images::odd_in_x : images::odd_in_y;
}

const std::array<int, stresses>& CrosswiseImages::odd_across() const
{
  return along_x_ ? images::odd_in_y : images::odd_in_x;
}

/// Moments in the order [component][depth][power].
MomentCoupling CrosswiseImages::empty_coupling() const
{
  std::vector<Moment> moments;
  for (int c = 0; c < stresses; ++c)
    for (int q = 0; q < depth_.count; ++q)
      for (int b = 0; b < powers; ++b)
        moments.push_back({static_cast<int>(moments.size()), (b + odd_across()[static_cast<std::size_t>(c)]) % 2, b});
  const std::vector<Moment> of_strain(moments.begin(), moments.begin() + strains * depth_.count * powers);
  return {moments, of_strain, degree};
}

/// The waves across the grid for one along it, on the lattice of images minus that on the one which is left. Images so far
/// away that this wave has decayed need not be told apart from none.
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

void CrosswiseImages::fit(int wave, const Elastic& elastic, double period_along, double period_across)
{
  const std::vector<images::WaveRow> waves = waves_across(wave, period_along, period_across);
  const std::vector<double> samples = images::sampled(waves, depth_.nodes, elastic);
  const std::array<int, 2> distances{along_x_ ? 1 : images::offset_nodes, along_x_ ? images::offset_nodes : 1};
  for (int c = 0; c < stresses; ++c)
    for (int e = 0; e < strains; ++e)
    {
      std::vector<images::Powers> terms;
      for (int b = images::is_odd(odd_across(), c, e) ? 1 : 0; b <= degree; b += 2)
        terms.push_back(along_x_ ? images::Powers{0, b} : images::Powers{b, 0});
      couple(c, e, terms, images::fitted(samples, c, e, distances, depth_, terms),
             coupling_[static_cast<std::size_t>(wave)]);
    }
}

/// Adds the kernel of one pair of components. Its part along the grid, cos or sin of m (x - x'), is made of products of
/// cos and sin. Sorted by u = (cos of an even component, sin of an odd one), v = (sin of an even one, -cos of an odd one),
/// it multiplies u into u and v into v, by the same matrix; a stress that is even, of a strain that is odd, changes the sign.
void CrosswiseImages::couple(int c, int e, const std::vector<images::Powers>& terms,
                             const std::vector<Eigen::MatrixXd>& values, MomentCoupling& coupling) const
{
  const bool changes_sign =
      odd_along()[static_cast<std::size_t>(e)] != 0 && odd_along()[static_cast<std::size_t>(c)] == 0;
  const double factor = (changes_sign ? -1.0 : 1.0) * grid_.cell_volume();
  for (std::size_t t = 0; t < terms.size(); ++t)
  {
    const int b = terms[t][0] + terms[t][1];
    for (int pb = 0; pb <= b; ++pb)
    {
      const double split = factor * images::binomial(b, pb) * ((b - pb) % 2 == 0 ? 1.0 : -1.0);
      for (int qi = 0; qi < depth_.count; ++qi)
        for (int qj = 0; qj < depth_.count; ++qj)
          coupling.add((c * depth_.count + qi) * powers + pb, (e * depth_.count + qj) * powers + b - pb,
                       split * values[t](qi, qj));
    }
  }
}

CrosswiseImages::Response CrosswiseImages::make_response() const
{
  const auto values = [&](int count) { return std::vector<double>(static_cast<std::size_t>(count * block())); };
  return {values(strains * grid_.nz), values(strains * depth_.count), values(stresses * depth_.count),
          std::vector<double>(static_cast<std::size_t>(waves_) * sorted_size())};
}

std::size_t CrosswiseImages::sorted_size() const
{
  return coupling_.front().columns().size() + coupling_.front().rows().size();
}

void CrosswiseImages::take(const Columns& strain, int first, int end, int component, int layer,
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

void CrosswiseImages::respond(int layers, Response& response, Symmetry symmetry, bool with_trace) const
{
  const int parities = along_x_ && symmetry != Symmetry::none ? 1 : 2; // across the grid
#pragma omp parallel for schedule(static)
  for (int e = 0; e < strains; ++e)
  {
    const ConstPlane of_layers(response.of_layers.data() + static_cast<std::ptrdiff_t>(e * grid_.nz * block()), block(),
                               layers);
    Plane(response.moments.data() + static_cast<std::ptrdiff_t>(e * depth_.count * block()), block(), depth_.count)
        .noalias() = of_layers * depth_.means.topRows(layers);
  }
#pragma omp parallel for schedule(static)
  for (int wave = 0; wave < waves_; ++wave)
    multiply(wave, response, parities, with_trace);
}

/// Moments of the strain for one wave -> coefficients of the stress, for u and v (see `couple`).
void CrosswiseImages::multiply(int wave, Response& response, int parities, bool with_trace) const
{
  const MomentCoupling& coupling = coupling_[static_cast<std::size_t>(wave)];
  const std::span<double> sorted =
      std::span(response.sorted).subspan(static_cast<std::size_t>(wave) * sorted_size(), sorted_size());
  const std::span<double> in = sorted.first(coupling.columns().size());
  const std::span<double> all = sorted.last(coupling.rows().size());
  const std::span<double> out =
      all.first(with_trace ? all.size() : static_cast<std::size_t>(strains * depth_.count * powers));
  for (const bool is_v : {false, true})
  {
    const auto place = [&](int moment) // [component][depth][power] -> [component][depth][power][wave]
    {
      const bool is_odd = odd_along()[static_cast<std::size_t>(moment / (depth_.count * powers))] != 0;
      return static_cast<std::size_t>(moment * 2 * waves_ + 2 * wave + (is_odd != is_v ? 1 : 0));
    };
    const auto sign = [&](int moment)
    { return is_v && odd_along()[static_cast<std::size_t>(moment / (depth_.count * powers))] != 0 ? -1.0 : 1.0; };
    for (std::size_t i = 0; i < in.size(); ++i)
      in[i] = sign(coupling.columns()[i]) * response.moments[place(coupling.columns()[i])];
    coupling.multiply(in.data(), out.data(), parities, out.size());
    for (std::size_t i = 0; i < out.size(); ++i)
      response.stress[place(coupling.rows()[i])] = sign(coupling.rows()[i]) * out[i];
  }
}

Eigen::VectorXd CrosswiseImages::amplitudes(const Response& response, int component, int layer) const
{
  const ConstPlane of_depths(response.stress.data() + static_cast<std::ptrdiff_t>(component * depth_.count * block()),
                             block(), depth_.count);
  return of_depths * depth_.means.row(layer).transpose();
}

Lanes CrosswiseImages::sum_of_waves(const double* amplitudes, int first, std::size_t cells) const
{
  Lanes sum{};
  for (int wave = 0; wave < 2 * waves_; ++wave)
    sum += amplitudes[wave] * load_lanes(along_.col(wave).data() + first, cells);
  return sum;
}

CrosswiseImages::Columns CrosswiseImages::stress(const Response& response, int component, int layer) const
{
  const Eigen::VectorXd in_layer = amplitudes(response, component, layer);
  return along_ * ConstPlane(in_layer.data(), 2 * waves_, powers);
}

} // namespace brinell::halfspace
