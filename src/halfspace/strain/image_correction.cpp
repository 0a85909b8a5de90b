// SPDX-License-Identifier: BSD-3-Clause
#include "image_correction.hpp"

#include "halfspace/traction/stack_scales.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <omp.h>

namespace brinell::halfspace
{

namespace
{

using images::strains;
using images::stresses;

constexpr int enlargement = 2; ///< ratio of the periods of successive lattices

/// Range of powers of one coordinate; only those with the parity of the first one are used.
struct PowerRange
{
  int first, last;
};

/// Powers (a, b) within the ranges whose sum is at most the larger of the two last powers.
std::vector<images::Powers> powers_of_parity(PowerRange x, PowerRange y)
{
  std::vector<images::Powers> result;
  for (int a = x.first; a <= x.last; a += 2)
    for (int b = y.first; b <= y.last && a + b <= std::max(x.last, y.last); b += 2)
      result.push_back({a, b});
  return result;
}

/// Period of a lattice along one axis, and its enlargement in the next lattice.
struct Period
{
  double length; ///< [m]
  bool is_open;
  [[nodiscard]] int enlarged() const { return is_open ? enlargement : 1; }
  /// Index of the shortest wave on the larger lattice. Along a periodic axis the copies of a source belong to the body; the
  /// stress of images along the other axis is uniform along it, since the padding of `padded_lengths` lets all other waves decay.
  [[nodiscard]] int last_wave(double k_max) const
  {
    return is_open ? static_cast<int>(k_max * enlargement * length / (2.0 * std::numbers::pi)) : 0;
  }
  [[nodiscard]] double wavenumber(int index) const { return 2.0 * std::numbers::pi * index / (enlarged() * length); }
};

/// Smallest distance from a cell of the grid to an image of another cell: between the far edges of both.
double distance_of_images(const SurfaceGrid& s, const Period& x, const Period& y)
{
  const double in_x = x.length - (s.nx - 1) * s.dx;
  const double in_y = y.length - (s.ny - 1) * s.dy;
  return !x.is_open ? in_y : !y.is_open ? in_x : std::min(in_x, in_y);
}

/// Adds the waves of one lattice minus those of the next larger one, times `factor`.
/// @param largest_x, largest_y  distances within the grid [m]
void add_waves(const Period& x, const Period& y, double factor, double largest_x, double largest_y,
               std::vector<images::WaveRow>& rows)
{
  const double width = (!x.is_open ? y.length : !y.is_open ? x.length : std::min(x.length, y.length)) / 10.0;
  const double k_max = images::shortest / width;
  const double larger = x.enlarged() * y.enlarged(); // ratio of the areas of the two lattices
  for (int j = 0; j <= y.last_wave(k_max); ++j)
  {
    const double n = y.wavenumber(j);
    images::WaveRow row{n, images::phases(n, largest_y), {}};
    for (int i = 0; i <= x.last_wave(k_max); ++i)
    {
      const double m = x.wavenumber(i);
      const double k = std::hypot(m, n);
      if (k == 0.0 || k > k_max)
        continue;
      const bool on_small = i % x.enlarged() == 0 && j % y.enlarged() == 0;
      const double copies = (i == 0 ? 1.0 : 2.0) * (j == 0 ? 1.0 : 2.0);
      const double weight =
          factor * copies * images::blur(k, width) * ((on_small ? 1.0 : 0.0) - 1.0 / larger) / (x.length * y.length);
      row.waves.push_back({m, weight, images::phases(m, largest_x)});
    }
    if (!row.waves.empty())
      rows.push_back(std::move(row));
  }
}

/// Number of enlargements of a lattice: three, and more if a layered body responds like its substrate only over longer distances.
int enlargements(const ElasticStack& stack, double period)
{
  constexpr int least = 3;
  return stack.is_homogeneous() ? least
                                : least + std::max(0, static_cast<int>(std::ceil(std::log2(reach(stack) / period))));
}

/// The waves whose sum is the stress of the images: differences of successive lattices, and the extrapolation from the last to an
/// infinite lattice.
std::vector<images::WaveRow> waves_of_images(const ElasticStack& stack, Period x, Period y, double largest_x,
                                             double largest_y)
{
  const int levels = enlargements(stack, !x.is_open ? y.length : !y.is_open ? x.length : std::min(x.length, y.length));
  std::vector<images::WaveRow> rows;
  for (int level = 1; level <= levels; ++level)
  {
    const double fewer =
        enlargement * x.enlarged() * y.enlarged(); // images of points decay as 1/r^3, of lines as 1/r^2
    add_waves(x, y, level == levels ? fewer / (fewer - 1.0) : 1.0, largest_x, largest_y, rows);
    x.length *= x.enlarged();
    y.length *= y.enlarged();
  }
  return rows;
}

/// Periods of the lattice that remains after CrosswiseImages has removed the images beside a long grid.
std::array<Period, 2> periods_left(const SurfaceGrid& s, const BlockedFft& fft)
{
  std::array<Period, 2> p{Period{fft.px() * s.dx, !s.is_periodic_x()}, Period{fft.py() * s.dy, !s.is_periodic_y()}};
  if (p[0].is_open && p[1].is_open)
    p[p[0].length > p[1].length ? 1 : 0].length *= CrosswiseImages::multiple(p[0].length, p[1].length);
  return p;
}

} // namespace

ImageCorrection::ImageCorrection(const VolumeGrid& grid, const ElasticStack& stack, const BlockedFft& fft,
                                 images::Source source)
    : grid_(grid), has_images_(!grid.surface.is_periodic()), x_(images::coordinate_powers(grid.surface.nx, degree)),
      y_(images::coordinate_powers(grid.surface.ny, degree)),
      depth_(grid, stack,
             has_images_ ? distance_of_images(grid.surface, periods_left(grid.surface, fft)[0],
                                              periods_left(grid.surface, fft)[1])
                         : grid.nz * grid.dz),
      coupling_(depth_.count, degree)
{
  if (!has_images_)
    return;
  const SurfaceGrid& s = grid.surface;
  const double period_x = fft.px() * s.dx;
  const double period_y = fft.py() * s.dy;
  if (!s.is_periodic_x() && !s.is_periodic_y() && CrosswiseImages::multiple(period_x, period_y) > 1)
    crosswise_.emplace(grid, stack, source, period_x, period_y);
  fit(stack, source, periods_left(s, fft)[0].length, periods_left(s, fft)[1].length);
}

void ImageCorrection::fit(const ElasticStack& stack, images::Source source, double period_x, double period_y)
{
  const SurfaceGrid& s = grid_.surface;
  const double largest_x = std::max(1, s.nx - 1) * s.dx;
  const double largest_y = std::max(1, s.ny - 1) * s.dy;
  const std::vector<images::WaveRow> waves =
      waves_of_images(stack, {period_x, !s.is_periodic_x()}, {period_y, !s.is_periodic_y()}, largest_x, largest_y);
  const std::vector<double> samples = images::sampled(waves, depth_.nodes, stack, source);
  for (int c = 0; c < stresses; ++c)
    for (int e = 0; e < images::components_of(source); ++e)
    {
      const bool odd_x = images::is_odd(images::odd_in_x, c, e);
      const bool odd_y = images::is_odd(images::odd_in_y, c, e);
      if ((s.is_periodic_x() && odd_x) || (s.is_periodic_y() && odd_y))
        continue;
      const auto powers_of_pair = powers_of_parity({odd_x ? 1 : 0, s.is_periodic_x() ? 0 : degree},
                                                   {odd_y ? 1 : 0, s.is_periodic_y() ? 0 : degree});
      const auto fitted =
          images::fitted(samples, c, e, {images::offset_nodes, images::offset_nodes}, depth_, powers_of_pair);
      for (std::size_t t = 0; t < powers_of_pair.size(); ++t)
        coupling_.add(c, e, powers_of_pair[t], grid_.cell_volume(),
                      fitted[t]); // the sum over cells stands for an integral
    }
}

ImageCorrection::Response ImageCorrection::make_response() const
{
  if (!has_images_)
    return {};
  const auto values = [](int count) { return std::vector<double>(static_cast<std::size_t>(count * powers)); };
  return {values(strains * grid_.nz), values(strains * depth_.count), values(stresses * depth_.count),
          coupling_.make_work(), crosswise_ ? crosswise_->make_response() : CrosswiseImages::Response{}};
}

void ImageCorrection::respond(int layers, Response& response, bool with_trace) const
{
  if (!has_images_)
    return;
  const auto images_beside = [&]
  { crosswise_->respond(layers, response.crosswise, grid_.surface.is_mirrored_y, with_trace); };
  const auto other_images = [&]
  {
    find_moments(layers, response);
    coupling_.multiply(response.moments.data(), grid_.surface.is_mirrored_y, with_trace ? stresses : strains,
                       response.work, response.stress.data());
  };
  if (crosswise_ && omp_get_max_threads() > 1)
  {
#pragma omp parallel sections
    {
#pragma omp section
      images_beside();
#pragma omp section
      other_images();
    }
    return;
  }
  if (crosswise_)
    images_beside();
  other_images();
}

void ImageCorrection::find_moments(int layers, Response& response) const
{
  const auto of_layer = [&](int component, int layer)
  { return response.of_layers.data() + static_cast<std::ptrdiff_t>((component * grid_.nz + layer) * powers); };
  std::fill(response.moments.begin(), response.moments.end(), 0.0);
  for (int e = 0; e < strains; ++e)
    for (int q = 0; q < depth_.count; ++q)
      for (int layer = 0; layer < layers; ++layer)
        for (int p = 0; p < powers; ++p)
          response.moments[static_cast<std::size_t>((e * depth_.count + q) * powers + p)] +=
              depth_.means(layer, q) * of_layer(e, layer)[p];
}

} // namespace brinell::halfspace
