// SPDX-License-Identifier: BSD-3-Clause
#include "steady_lattices.hpp"

#include "foundation/fft.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell::halfspace
{

namespace
{

/// Low-pass factor on a wave of the far fields: 1 for wavelengths of `clear` and more, with a decrease so smooth that the omitted
/// part remains localised at its source.
double kept(double k, double clear)
{
  constexpr double middle = 38.0, width = 9.0;
  return 0.5 * std::erfc((k * clear - middle) / width);
}
constexpr double last_kept = 68.0; ///< k times clear

/// Chebyshev points, and barycentric interpolation by the polynomial through the values at these points.
struct Chebyshev
{
  std::vector<double> points, weights;

  Chebyshev(int count, double low, double high)
  {
    for (int n = 0; n < count; ++n)
    {
      const double angle = std::numbers::pi * (n + 0.5) / count;
      points.push_back(0.5 * (low + high) - 0.5 * (high - low) * std::cos(angle));
      weights.push_back((n % 2 == 0 ? 1.0 : -1.0) * std::sin(angle));
    }
  }

  void add_row(double place, std::vector<double>& rows) const
  {
    const std::size_t begin = rows.size();
    double sum = 0.0;
    for (std::size_t n = 0; n < points.size(); ++n)
    {
      if (place == points[n])
      {
        rows.resize(begin);
        rows.resize(begin + points.size(), 0.0);
        rows[begin + n] = 1.0;
        return;
      }
      rows.push_back(weights[n] / (place - points[n]));
      sum += rows.back();
    }
    for (std::size_t n = begin; n < rows.size(); ++n)
      rows[n] /= sum;
  }
};

/// Waves of the fields by a unit flux, at all depths.
struct WaveFields
{
  const SteadyLattices::Fields& fields;
  std::span<const double> depths;
  std::vector<Complex> values; ///< [depth][field]

  WaveFields(const SteadyLattices::Fields& wanted, std::span<const double> at)
      : fields(wanted), depths(at), values(at.size() * wanted.is_odd.size())
  {
  }

  void set(const MovingFlux& flux, const SurfaceWave& along)
  {
    const Complex at_surface = moving_wave(flux, along.odd_x, along.k, 0.0).potential;
    for (std::size_t d = 0; d < depths.size(); ++d)
    {
      ThermalWave heat = moving_wave(flux, along.odd_x, along.k, depths[d]);
      heat.potential_at_surface = at_surface;
      fields.waves(along, depths[d], heat, std::span(values).subspan(d * fields.is_odd.size(), fields.is_odd.size()));
    }
  }
};

} // namespace

SteadyLattices::SteadyLattices(const SurfaceGrid& grid, const Thermal& thermal, double velocity)
    : thermal_(thermal), velocity_(velocity), offsets_(grid)
{
  // On a small grid the lattice is larger, so that the waves of the far fields are longer than the cells.
  const double far_enough =
      last_kept / std::numbers::pi * (grid.is_periodic_y() ? grid.dx : std::max(grid.dx, grid.dy));
  const double length = std::max(grid.nx * grid.dx, far_enough), width = grid.ny * grid.dy;
  x_ = {fast_length(static_cast<int>(std::ceil(4.0 * length / grid.dx))), 1 - grid.nx, 2 * grid.nx - 1, grid.dx, true};
  // Distance to the omitted earlier heat, and to that of the nearest image.
  clear_ = 0.5 * x_.length * grid.dx - grid.nx * grid.dx;
  y_ = {grid.ny, 0, grid.ny, grid.dy, false};
  if (!grid.is_periodic_y())
  {
    const double free = std::max({width, far_enough, std::min(0.5 * length, 3.0 * width)});
    y_ = {fast_length(static_cast<int>(std::ceil((width + free) / grid.dy))), 1 - grid.ny, 2 * grid.ny - 1, grid.dy,
          true};
    clear_ = std::min(clear_, y_.length * grid.dy - width);
  }
  offsets_.nx = x_.count;
  offsets_.ny = y_.count;
}

/// The flux during the time in which it moves by half of the period, or in which heat spreads by that distance.
MovingFlux SteadyLattices::flux(int level) const
{
  const double way = 0.5 * x_.period(level), diffusivity = thermal_.diffusivity();
  const double duration = 1.0 / (std::abs(velocity_) / way + 4.0 * diffusivity / (way * way));
  return {thermal_.conductivity, diffusivity, velocity_, duration};
}

/// Number of levels of far fields after which the remainder follows its asymptotic law.
int SteadyLattices::levels(double deepest) const
{
  const double largest = std::max({x_.extent(), y_.extent(), deepest});
  constexpr int most = 60, of_rest = 12;
  if (velocity_ == 0.0)
    return of_rest;
  int level = 0;
  // The displacement by the wake converges slowest: in plane strain only with the square root of the distance.
  const double far = y_.is_open ? 128.0 : 1024.0, cooled = y_.is_open ? 400.0 : 1e4;
  while (level < most && (0.5 * x_.period(level) < far * largest ||
                          0.5 * x_.period(level) * std::abs(velocity_) / thermal_.diffusivity() < cooled))
    ++level;
  return level;
}

SurfaceWave SteadyLattices::wave(int a, int b, int level) const
{
  const double kx = 2.0 * std::numbers::pi * a / x_.period(level), ky = 2.0 * std::numbers::pi * b / y_.period(level);
  const auto shortest = [&](int n, const Axis& along)
  { return 2.0 * n == (along.is_open ? std::ldexp(along.length, level) : along.length); };
  return {kx, ky, std::hypot(kx, ky), shortest(a, x_) ? 0.0 : kx, shortest(b, y_) ? 0.0 : ky};
}

/// Adds the fields of all waves of the finest lattice.
void SteadyLattices::add_near(std::span<const double> depths, const Fields& fields, std::span<Values> out) const
{
  const PaddedFft fft(offsets_.whole(), x_.length, y_.length);
  const std::size_t count = fields.is_odd.size();
  std::vector<AlignedVector<Complex>> spectra(depths.size() * count, AlignedVector<Complex>(fft.plane()));
  const auto columns = static_cast<std::size_t>(fft.kx());
#pragma omp parallel
  {
    WaveFields here(fields, depths);
#pragma omp for schedule(dynamic)
    for (int b = 0; b <= y_.length / 2; ++b)
      for (int a = 0; a < fft.kx(); ++a)
      {
        const SurfaceWave along = wave(a, b, 0);
        here.set(flux(0), along);
        // The source is in the middle of the offsets.
        const Complex turn = std::polar(1.0, along.kx * x_.first * x_.size);
        const Complex turn_y = std::polar(1.0, along.ky * y_.first * y_.size);
        const auto column = static_cast<std::size_t>(a);
        for (std::size_t f = 0; f < spectra.size(); ++f)
        {
          const double sign = fields.is_odd[f % count] ? -1.0 : 1.0;
          const Complex value = turn * here.values[f];
          spectra[f][static_cast<std::size_t>(b) * columns + column] = turn_y * value;
          if (b > 0 && 2 * b != y_.length)
            spectra[f][static_cast<std::size_t>(y_.length - b) * columns + column] = sign * std::conj(turn_y) * value;
        }
      }
  }
  for (std::size_t f = 0; f < spectra.size(); ++f)
    fft.inverse(spectra[f].data(), out[f]);
}

/// Adds, at the nodes, the fields of a lattice with twice the period and more time minus those of this lattice.
void SteadyLattices::add_far(int level, double factor, std::span<const double> depths, const Fields& fields,
                             const Nodes& along_x, const Nodes& along_y, std::vector<Values>& out) const
{
  const double clear = std::ldexp(clear_, level), last = last_kept / clear;
  const auto waves = [&](const Axis& along)
  {
    const int spacing = along.is_open ? level + 1 : 0;
    const double most =
        std::min(std::ldexp(along.length, spacing) / 2.0, last * along.period(level + 1) / (2.0 * std::numbers::pi));
    return static_cast<int>(std::floor(most));
  };
  const double cell = x_.size * y_.size;
  const double of_twice = factor * cell / (x_.period(level + 1) * y_.period(level + 1));
  const double of_once = factor * cell / (x_.period(level) * y_.period(level));
  const MovingFlux more = flux(level + 1), less = flux(level);
  WaveFields twice(fields, depths), once(fields, depths);
  std::vector<Complex> rows(out.size() * along_y.size());
  const std::size_t count = fields.is_odd.size();
  const int last_b = waves(y_);
  std::vector<Complex> across; // e^{i ky y} [wave][node]
  for (int b = 0; b <= last_b; ++b)
    for (const double y : along_y.places)
      across.push_back(std::polar(1.0, 2.0 * std::numbers::pi * b / y_.period(level + 1) * y));
  for (int a = 0; a <= waves(x_); ++a)
  {
    std::fill(rows.begin(), rows.end(), Complex{});
    const double kx = wave(a, 0, level + 1).kx;
    const bool is_paired = wave(a, 0, level + 1).odd_x != 0.0;
    for (int b = 0; b <= last_b; ++b)
    {
      const SurfaceWave along = wave(a, b, level + 1);
      if (along.k > last)
        break;
      twice.set(more, along);
      const bool is_on_both = (!x_.is_open || a % 2 == 0) && (!y_.is_open || b % 2 == 0);
      if (is_on_both)
        once.set(less, along);
      const double weight = kept(along.k, clear) * (along.odd_y != 0.0 ? 2.0 : 1.0);
      const Complex* turn = across.data() + static_cast<std::size_t>(b) * along_y.size();
      for (std::size_t f = 0; f < out.size(); ++f)
      {
        Complex value = weight * of_twice * twice.values[f];
        if (is_on_both)
          value -= weight * of_once * once.values[f];
        Complex* row = rows.data() + f * along_y.size();
        if (fields.is_odd[f % count])
          for (std::size_t y = 0; y < along_y.size(); ++y)
            row[y] += Complex{-turn[y].imag() * value.imag(), turn[y].imag() * value.real()};
        else
          for (std::size_t y = 0; y < along_y.size(); ++y)
            row[y] += turn[y].real() * value;
      }
    }
    std::vector<Complex> turns;
    for (const double x : along_x.places)
      turns.push_back(std::polar(is_paired ? 2.0 : 1.0, kx * x));
    for (std::size_t f = 0; f < out.size(); ++f)
      for (std::size_t y = 0; y < along_y.size(); ++y)
      {
        const Complex value = rows[f * along_y.size() + y];
        for (std::size_t x = 0; x < along_x.size(); ++x)
          out[f][y * along_x.size() + x] += value.real() * turns[x].real() - value.imag() * turns[x].imag();
      }
  }
}

SteadyLattices::Nodes SteadyLattices::nodes(const Axis& along) const
{
  Nodes result;
  const int count = 16 + static_cast<int>(std::ceil(10.0 * along.extent() / clear_));
  const bool is_few = !along.is_open || along.count <= count;
  const Chebyshev chosen(is_few ? 1 : count, along.first * along.size, (along.first + along.count - 1) * along.size);
  if (!is_few)
    result.places = chosen.points;
  for (int n = 0; n < along.count; ++n)
    if (is_few)
    {
      result.places.push_back((along.first + n) * along.size);
      for (int m = 0; m < along.count; ++m)
        result.weights.push_back(m == n ? 1.0 : 0.0);
    }
    else
      chosen.add_row((along.first + n) * along.size, result.weights);
  return result;
}

SteadyLattices::Nodes SteadyLattices::nodes_in_depth(std::span<const double> depths) const
{
  Nodes result;
  const double deepest = *std::max_element(depths.begin(), depths.end());
  const int count = 8 + static_cast<int>(std::ceil(8.0 * deepest / clear_));
  if (depths.size() <= static_cast<std::size_t>(count))
  {
    result.places.assign(depths.begin(), depths.end());
    for (std::size_t n = 0; n < depths.size(); ++n)
      for (std::size_t m = 0; m < depths.size(); ++m)
        result.weights.push_back(m == n ? 1.0 : 0.0);
    return result;
  }
  const Chebyshev chosen(count, 0.0, deepest);
  result.places = chosen.points;
  for (const double depth : depths)
    chosen.add_row(depth, result.weights);
  return result;
}

std::vector<std::vector<double>> SteadyLattices::tables(std::span<const double> depths, const Fields& fields) const
{
  const std::size_t count = fields.is_odd.size();
  std::vector<Values> result(depths.size() * count, Values(offsets_.size()));
  if (depths.empty())
    return result;
  constexpr std::size_t at_once = 4; // depths per pass, to limit the memory of their spectra
  for (std::size_t d = 0; d < depths.size(); d += at_once)
  {
    const std::size_t some = std::min(at_once, depths.size() - d);
    add_near(depths.subspan(d, some), fields, std::span(result).subspan(d * count, some * count));
  }

  const Nodes along_x = nodes(x_), along_y = nodes(y_), down = nodes_in_depth(depths);
  const std::size_t plane = along_x.size() * along_y.size();
  std::vector<Values> far(down.size() * count, Values(plane));
  const int all = levels(down.places.back());
  // Further levels are a geometric series: for a flux at rest that of the temperature, otherwise that of the displacement by a
  // wake.
  const double ratio = velocity_ == 0.0 ? 0.5 : y_.is_open ? std::pow(0.5, 1.5) : std::sqrt(0.5);
  for (int level = 0; level < all; ++level)
    add_far(level, level + 1 == all ? 1.0 / (1.0 - ratio) : 1.0, down.places, fields, along_x, along_y, far);

  const auto nx = static_cast<std::size_t>(x_.count);
  Values in_depth(plane), row(along_x.size());
  for (std::size_t d = 0; d < depths.size(); ++d)
    for (std::size_t f = 0; f < count; ++f)
    {
      std::fill(in_depth.begin(), in_depth.end(), 0.0);
      for (std::size_t n = 0; n < down.size(); ++n)
        if (const double weight = down.weights[d * down.size() + n]; weight != 0.0)
          for (std::size_t p = 0; p < plane; ++p)
            in_depth[p] += weight * far[n * count + f][p];
      for (int j = 0; j < y_.count; ++j)
      {
        std::fill(row.begin(), row.end(), 0.0);
        for (std::size_t y = 0; y < along_y.size(); ++y)
          if (const double weight = along_y.weights[static_cast<std::size_t>(j) * along_y.size() + y]; weight != 0.0)
            for (std::size_t x = 0; x < along_x.size(); ++x)
              row[x] += weight * in_depth[y * along_x.size() + x];
        for (std::size_t i = 0; i < nx; ++i)
        {
          double sum = 0.0;
          for (std::size_t x = 0; x < along_x.size(); ++x)
            sum += along_x.weights[i * along_x.size() + x] * row[x];
          result[d * count + f][static_cast<std::size_t>(j) * nx + i] += sum;
        }
      }
    }
  return result;
}

} // namespace brinell::halfspace
