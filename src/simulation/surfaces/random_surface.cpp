// SPDX-License-Identifier: BSD-3-Clause
#include "random_surface.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/fft.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <random>

namespace brinell::simulation
{

namespace
{

constexpr double rounding = 1e-9;
constexpr double longest_in_cutoffs = 4096.0; ///< largest ratio of size to cutoff: some 26 million waves, 0.5 GB

InputError out_of_range(const char* name, double value, const char* allowed)
{
  return InputError(fmt::format("{} = {:g} of a random surface; allowed: {}", name, value, allowed));
}

void require_valid(const SelfAffine& p)
{
  if (!(p.hurst >= 0.0 && p.hurst <= 1.0))
    throw out_of_range("hurst", p.hurst, "0 to 1");
  if (p.rms_height.has_value() == p.rms_slope.has_value())
    throw InputError("a random surface needs rms_height or rms_slope, one of them");
  for (const auto& [name, value] : {std::pair{"rms_height", p.rms_height}, {"rms_slope", p.rms_slope}})
    if (value && !(*value >= 0.0 && std::isfinite(*value)))
      throw out_of_range(name, *value, ">= 0");
  for (const auto& [name, value] : {std::pair{"size_x", p.size_x}, {"size_y", p.size_y}})
    if (!(value > 0.0 && std::isfinite(value)))
      throw out_of_range(name, value, "> 0");
  if (!(p.cutoff > 0.0 && p.cutoff <= std::min(p.size_x, p.size_y) * (1.0 + rounding)))
    throw out_of_range("cutoff", p.cutoff, "> 0 and not longer than the size of the surface");
  if (std::max(p.size_x, p.size_y) / p.cutoff > longest_in_cutoffs)
    throw out_of_range("cutoff", p.cutoff,
                       fmt::format("at least 1/{:g} of the size of the surface", longest_in_cutoffs).c_str());
  if (!(p.rolloff >= p.cutoff))
    throw out_of_range("rolloff", p.rolloff, "not shorter than the cutoff");
}

/// Pairs of normal random numbers (Box and Muller 1958). The C++ standard fixes the integers of its generators but not the
/// results of its distributions, which therefore are not used.
class NormalPairs
{
public:
  explicit NormalPairs(std::uint64_t seed) : generator_(seed) {}

  Complex next()
  {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    const double angle = 2.0 * std::numbers::pi * uniform();
    return {radius * std::cos(angle), radius * std::sin(angle)};
  }

private:
  /// Uniform in (0, 1], from the upper 53 bits.
  double uniform() { return (static_cast<double>(generator_() >> 11) + 1.0) * 0x1p-53; }

  std::mt19937_64 generator_;
};

/// Calls visit(i, j) once for each pair of opposite wavevectors, ring by ring of max(|i|, |j|) = 1, 2, ..., so that further rings
/// only extend the sequence.
template <typename Visit>
void in_rings(int rings, const Visit& visit)
{
  for (int r = 1; r <= rings; ++r)
  {
    for (int i = 1; i <= r; ++i)
      visit(i, -r);
    for (int j = 1 - r; j < r; ++j)
      visit(r, j);
    for (int i = 0; i <= r; ++i)
      visit(i, r);
  }
}

/// Largest number of waves in a size whose wavelength is not below the cutoff.
int most_waves(double size, double cutoff)
{
  return static_cast<int>(std::floor(size / cutoff * (1.0 + rounding)));
}

/// Amplitudes before scaling, with their mean squares of height and slope.
struct Unscaled
{
  RandomSurface::Waves waves;
  double height_squared = 0.0, slope_squared = 0.0;
};

Unscaled unscaled(const SelfAffine& p)
{
  Unscaled u;
  RandomSurface::Waves& w = u.waves;
  w.max_x = most_waves(p.size_x, p.cutoff);
  w.max_y = most_waves(p.size_y, p.cutoff);
  w.amplitudes.assign((static_cast<std::size_t>(w.max_x) + 1) * w.rows(), Complex{});
  NormalPairs random(p.seed);
  in_rings(std::max(w.max_x, w.max_y),
           [&](int i, int j)
           {
             const Complex drawn =
                 random.next(); // also beyond the cutoff, so that other waves do not depend on the cutoff
             const double frequency = std::hypot(i / p.size_x, j / p.size_y);
             if (frequency * p.cutoff > 1.0 + rounding)
               return;
             // The amplitude is the root of the spectral density C(q), which is q^(-2 (1 + H)) beyond the roll-off.
             const double bent = std::max(frequency, 1.0 / p.rolloff) * p.cutoff;
             const Complex amplitude = std::pow(bent, -1.0 - p.hurst) * drawn;
             w.amplitudes[w.index(i, j)] = amplitude;
             const double square = 0.5 * std::norm(amplitude);
             u.height_squared += square;
             u.slope_squared += square * std::pow(2.0 * std::numbers::pi * frequency, 2);
           });
  return u;
}

/// exp(2 pi I n x/size) for n = first to last. Whole periods are removed before taking the cosine, which would lose digits
/// otherwise.
std::vector<Complex> waves_at(double x, double size, int first, int last)
{
  std::vector<Complex> values;
  values.reserve(static_cast<std::size_t>(last - first) + 1);
  const double turns = x / size;
  for (int n = first; n <= last; ++n)
  {
    const double angle = 2.0 * std::numbers::pi * std::remainder(n * turns, 1.0);
    values.emplace_back(std::cos(angle), std::sin(angle));
  }
  return values;
}

/// Ratios `mean_over_cell` for the waves n = first to last.
std::vector<double> means_over_cell(double cell, double size, int first, int last)
{
  std::vector<double> factors;
  for (int n = first; n <= last; ++n)
    factors.push_back(n == 0 ? 1.0 : mean_over_cell(cell, size / n));
  return factors;
}

/// Amplitudes with respect to an origin at (x0, y0), averaged over cells.
std::vector<Complex> placed(const RandomSurface& surface, double x0, double y0, const Averaged& over)
{
  const SelfAffine& p = surface.parameters();
  const RandomSurface::Waves& w = surface.waves();
  const auto along_x = waves_at(x0, p.size_x, 0, w.max_x), along_y = waves_at(y0, p.size_y, -w.max_y, w.max_y);
  const auto mean_x = means_over_cell(over[0], p.size_x, 0, w.max_x),
             mean_y = means_over_cell(over[1], p.size_y, -w.max_y, w.max_y);
  std::vector<Complex> c = w.amplitudes;
  const std::size_t rows = w.rows();
  for (std::size_t i = 0; i < along_x.size(); ++i)
    for (std::size_t j = 0; j < rows; ++j)
      c[i * rows + j] *= (mean_x[i] * mean_y[j]) * (along_x[i] * along_y[j]);
  return c;
}

/// Number of cells of a period, if the transform is possible: it must be even.
std::optional<int> even_cells(double size, double cell)
{
  constexpr double most = 1 << 20;
  const double cells = size / cell;
  const double nearest = 2.0 * std::round(0.5 * cells);
  if (!(nearest >= 2.0) || !(nearest <= most) || !(std::abs(cells - nearest) < rounding * nearest))
    return std::nullopt;
  return static_cast<int>(nearest);
}

int wrapped(int index, int count)
{
  const int rest = index % count;
  return rest < 0 ? rest + count : rest;
}

/// Heights by one inverse transform of the period. Waves beyond the Nyquist limit of the cells are added to their aliases, which
/// have the same values at the cells.
void add_by_transform(const RandomSurface::Waves& w, const std::vector<Complex>& c, const SurfaceGrid& period,
                      const SurfaceGrid& grid, double factor, std::vector<double>& heights)
{
  const PaddedFft fft(period, period.nx, period.ny);
  std::vector<Complex> spectrum(fft.plane(), Complex{});
  const auto add = [&](int i, int j, Complex half)
  {
    const int column = wrapped(i, period.nx);
    if (column < fft.kx())
      spectrum[static_cast<std::size_t>(column) +
               static_cast<std::size_t>(fft.kx()) * static_cast<std::size_t>(wrapped(j, period.ny))] += half;
  };
  const double scale = 0.5 * factor * static_cast<double>(period.size()); // the transform divides by the size
  for (int i = 0; i <= w.max_x; ++i)
    for (int j = -w.max_y; j <= w.max_y; ++j)
    {
      const Complex half = scale * c[w.index(i, j)];
      add(i, j, half);
      add(-i, -j, std::conj(half));
    }
  std::vector<double> plane(period.size());
  fft.inverse(spectrum.data(), plane);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      heights[grid.index(i, j)] += plane[period.index(i % period.nx, j % period.ny)];
}

/// Real and imaginary parts in separate arrays, so that sums vectorise.
struct Planar
{
  std::vector<double> real, imaginary;

  explicit Planar(std::size_t size) : real(size, 0.0), imaginary(size, 0.0) {}
};

/// Sum along y: for each row of the grid the amplitudes of the waves along x, [row][wave].
Planar summed_along_y(const RandomSurface& surface, const std::vector<Complex>& c, const SurfaceGrid& grid)
{
  const RandomSurface::Waves& w = surface.waves();
  const std::size_t rows = w.rows(), waves = static_cast<std::size_t>(w.max_x) + 1;
  Planar turned(c.size()); // [wave along y][wave along x]
  for (std::size_t m = 0; m < waves; ++m)
    for (std::size_t n = 0; n < rows; ++n)
    {
      turned.real[n * waves + m] = c[m * rows + n].real();
      turned.imaginary[n * waves + m] = c[m * rows + n].imag();
    }
  Planar sums(waves * static_cast<std::size_t>(grid.ny));
  for (int j = 0; j < grid.ny; ++j)
  {
    const std::vector<Complex> along_y = waves_at(j * grid.dy, surface.parameters().size_y, -w.max_y, w.max_y);
    double* real = sums.real.data() + static_cast<std::size_t>(j) * waves;
    double* imaginary = sums.imaginary.data() + static_cast<std::size_t>(j) * waves;
    for (std::size_t n = 0; n < rows; ++n)
    {
      const double cosine = along_y[n].real(), sine = along_y[n].imag();
      const double *a = turned.real.data() + n * waves, *b = turned.imaginary.data() + n * waves;
      for (std::size_t m = 0; m < waves; ++m)
      {
        real[m] += cosine * a[m] - sine * b[m];
        imaginary[m] += sine * a[m] + cosine * b[m];
      }
    }
  }
  return sums;
}

/// Heights by sums over the waves, for any cells: along y, then along x.
void add_by_rows(const RandomSurface& surface, const std::vector<Complex>& c, const SurfaceGrid& grid, double factor,
                 std::vector<double>& heights)
{
  const Planar of_rows = summed_along_y(surface, c, grid);
  const std::size_t waves = static_cast<std::size_t>(surface.waves().max_x) + 1;
  constexpr int block = 64; // columns whose tables stay in the cache
  for (int first = 0; first < grid.nx; first += block)
  {
    const auto columns = static_cast<std::size_t>(std::min(block, grid.nx - first));
    Planar table(waves * columns); // [wave][column]
    for (std::size_t i = 0; i < columns; ++i)
    {
      const auto along_x =
          waves_at((first + static_cast<int>(i)) * grid.dx, surface.parameters().size_x, 0, surface.waves().max_x);
      for (std::size_t m = 0; m < waves; ++m)
      {
        table.real[m * columns + i] = factor * along_x[m].real();
        table.imaginary[m * columns + i] = factor * along_x[m].imag();
      }
    }
    for (int j = 0; j < grid.ny; ++j)
    {
      double* out = heights.data() + grid.index(first, j);
      for (std::size_t m = 0; m < waves; ++m)
      {
        const std::size_t n = static_cast<std::size_t>(j) * waves + m;
        const double real = of_rows.real[n], imaginary = of_rows.imaginary[n];
        const double *cosines = table.real.data() + m * columns, *sines = table.imaginary.data() + m * columns;
        for (std::size_t i = 0; i < columns; ++i)
          out[i] += real * cosines[i] - imaginary * sines[i];
      }
    }
  }
}

/// Whether a transform of the period is faster than the sums, by numbers of operations, which take twice as long in a transform.
bool is_cheaper_by_transform(const RandomSurface::Waves& w, const SurfaceGrid& period, const SurfaceGrid& grid)
{
  const double waves = w.max_x + 1.0;
  const double sums = waves * grid.ny * (static_cast<double>(w.rows()) + grid.nx);
  const auto cells = static_cast<double>(period.size());
  return cells * (4.0 * std::log2(cells) + 20.0) < sums;
}

} // namespace

RandomSurface::RandomSurface(const SelfAffine& parameters) : parameters_(parameters)
{
  require_valid(parameters_);
  Unscaled u = unscaled(parameters_);
  const double height = std::sqrt(u.height_squared), slope = std::sqrt(u.slope_squared);
  const double scale = parameters_.rms_height ? *parameters_.rms_height / height : *parameters_.rms_slope / slope;
  for (Complex& amplitude : u.waves.amplitudes)
    amplitude *= scale;
  rms_height_ = scale * height;
  rms_slope_ = scale * slope;
  waves_ = std::make_shared<const Waves>(std::move(u.waves));
}

double mean_over_cell(double cell, double wavelength)
{
  const double half = std::numbers::pi * cell / wavelength;
  return half == 0.0 ? 1.0 : std::sin(half) / half;
}

double height_of(const RandomSurface& surface, double x, double y, const Averaged& over)
{
  double sum = 0.0;
  for (const Complex& c : placed(surface, x, y, over))
    sum += c.real();
  return sum;
}

void add_heights(const RandomSurface& surface, const SurfaceGrid& grid, double x0, double y0, const Averaged& over,
                 double factor, std::vector<double>& heights, Route route)
{
  const SelfAffine& p = surface.parameters();
  const std::vector<Complex> c = placed(surface, x0, y0, over);
  const auto nx = even_cells(p.size_x, grid.dx), ny = even_cells(p.size_y, grid.dy);
  const SurfaceGrid period{nx.value_or(0), ny.value_or(0), grid.dx, grid.dy};
  if (route == Route::cheapest)
    route =
        nx && ny && is_cheaper_by_transform(surface.waves(), period, grid) ? Route::transform : Route::rows_and_columns;
  if (route == Route::rows_and_columns)
    return add_by_rows(surface, c, grid, factor, heights);
  if (!nx || !ny)
    throw InternalError("a transform of a random surface needs an even number of cells per period");
  add_by_transform(surface.waves(), c, period, grid, factor, heights);
}

double highest_point(const RandomSurface& surface)
{
  const SelfAffine& p = surface.parameters();
  const auto points = [&](double size) { return fast_length(static_cast<int>(std::ceil(4.0 * size / p.cutoff))); };
  const int nx = points(p.size_x), ny = points(p.size_y);
  const SurfaceGrid grid{nx, ny, p.size_x / nx, p.size_y / ny};
  std::vector<double> heights(grid.size(), 0.0);
  add_heights(surface, grid, 0.0, 0.0, {}, 1.0, heights);
  return std::max(0.0, *std::max_element(heights.begin(), heights.end()));
}

} // namespace brinell::simulation
