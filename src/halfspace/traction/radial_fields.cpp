// SPDX-License-Identifier: BSD-3-Clause
#include "radial_fields.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace brinell::halfspace
{

using std::numbers::pi;

namespace
{

constexpr std::size_t part_count = std::tuple_size_v<WaveParts>;
constexpr int most_points = 24; // of a rule along one axis of a cell

/// Bessel functions of the orders 0 ... 3. Short of 1/2 the recurrence would cancel.
std::array<double, 4> bessel(double x)
{
  std::array<double, 4> J{::j0(x), ::j1(x)};
  if (x > 0.5)
  {
    J[2] = 2.0 / x * J[1] - J[0];
    J[3] = 4.0 / x * J[2] - J[1];
    return J;
  }
  const double half = 0.5 * x, square = half * half;
  double term2 = 0.5 * square, term3 = half * square / 6.0;
  for (int n = 1; n <= 8; ++n)
  {
    J[2] += term2;
    J[3] += term3;
    term2 *= -square / (n * (n + 2.0));
    term3 *= -square / (n * (n + 3.0));
  }
  return J;
}

/// Factor of Hankel's integral: i^order, and once more i if the order is odd.
double phase(int order)
{
  return order == 1 || order == 2 ? -1.0 : 1.0;
}

} // namespace

RadialFields::Rule::Rule(int order)
{
  for (int i = 0; i < order; ++i)
  {
    double t = std::cos(pi * (i + 0.75) / (order + 0.5)), slope = 0.0;
    for (int iteration = 0; iteration < 10; ++iteration) // Newton on Legendre's polynomial
    {
      double p0 = 1.0, p1 = t;
      for (int n = 2; n <= order; ++n)
        p0 = std::exchange(p1, ((2 * n - 1) * t * p1 - (n - 1) * p0) / n);
      slope = order * (t * p1 - p0) / (t * t - 1.0);
      t -= p1 / slope;
    }
    point.push_back(0.5 * t);
    weight.push_back(1.0 / ((1.0 - t * t) * slope * slope));
  }
}

RadialFields::RadialFields(const SurfaceGrid& grid, const WaveScales& scales, WaveTerms terms,
                           const std::vector<Table>& waves)
    : grid_(grid), scales_(scales), terms_(terms.begin(), terms.end()), radial_(waves.size())
{
  for (const WaveTerm& term : terms)
    orders_[term.part] = term.order;
  const double farthest = std::hypot((grid.nx - 0.5) * grid.dx, (grid.ny - 0.5) * grid.dy);
  for (double low = 0.0, high = std::min(scales.decay, farthest); low < farthest; low = high, high *= 2.0)
    intervals_.push_back({low, high});
  for (auto& field : radial_)
    field.resize(intervals_.size());
  for (std::size_t number = 0; number < intervals_.size(); ++number)
    tabulate(intervals_[number], number, waves);
  rules_.reserve(most_points);
  for (int order = 1; order <= most_points; ++order)
    rules_.emplace_back(order);
}

namespace
{

/// Waves times k / 2 pi and the weights of a part of a quadrature, [wave][field].
std::vector<WaveParts> weighted(const WaveNodes& quadrature, std::size_t first, std::size_t count,
                                const WaveScales& scales, const std::vector<RadialFields::Table>& waves)
{
  std::vector<WaveParts> amplitudes(count * waves.size());
#pragma omp parallel for schedule(static)
  for (std::size_t n = 0; n < count; ++n)
  {
    const double k = quadrature.k[first + n];
    const double factor = quadrature.weight[first + n] * (scales.is_over_k ? 1.0 : k) / (2.0 * pi);
    for (std::size_t f = 0; f < waves.size(); ++f)
    {
      WaveParts& amplitude = amplitudes[n * waves.size() + f] = waves[f].at(k);
      for (double& value : amplitude)
        value *= factor;
    }
  }
  return amplitudes;
}

} // namespace

/// Integral of the parts times k J(k r) / 2 pi at the nodes of an interval of distances, and its polynomials.
void RadialFields::tabulate(const Interval& interval, std::size_t number, const std::vector<Table>& waves)
{
  constexpr std::size_t at_a_time = 1024; // waves, so that they need little memory
  const WaveNodes quadrature(scales_, interval.high);
  const std::size_t fields = waves.size();
  std::vector<WaveParts> values(nodes * fields);
  for (std::size_t first = 0; first < quadrature.k.size(); first += at_a_time)
  {
    const std::size_t count = std::min(at_a_time, quadrature.k.size() - first);
    const std::vector<WaveParts> amplitudes = weighted(quadrature, first, count, scales_, waves);
#pragma omp parallel for schedule(static)
    for (std::size_t node = 0; node < nodes; ++node)
    {
      const double r = interval.low + 0.5 * (interval.high - interval.low) * (1.0 + Series::node(node));
      WaveParts* const sums = values.data() + node * fields;
      for (std::size_t n = 0; n < count; ++n)
      {
        const std::array<double, 4> J = bessel(quadrature.k[first + n] * r);
        WaveParts of_order;
        for (std::size_t p = 0; p < part_count; ++p)
          of_order[p] = phase(orders_[p]) * J[static_cast<std::size_t>(orders_[p])];
        const WaveParts* const amplitude = amplitudes.data() + n * fields;
        for (std::size_t f = 0; f < fields; ++f)
          for (std::size_t p = 0; p < part_count; ++p)
            sums[f][p] += of_order[p] * amplitude[f][p];
      }
    }
  }
  for (std::size_t f = 0; f < fields; ++f)
    radial_[f][number] = Series([&](std::size_t node) { return values[node * fields + f]; });
}

WaveParts RadialFields::at(std::size_t field, double r) const
{
  const double first = intervals_.front().high;
  const auto number = r < first ? std::size_t{0} : static_cast<std::size_t>(std::ilogb(r / first)) + 1;
  const std::size_t inside = std::min(number, intervals_.size() - 1);
  const auto [low, high] = intervals_[inside];
  return radial_[field][inside].at(2.0 * (r - low) / (high - low) - 1.0);
}

/// Along an axis the next singularity of a function of the distance is at i times the root of the squares of the distance across
/// and of the decay. Seen from the middle of the cell in half cells it is at z, and Gauss with n points errs by about
/// |z + sqrt(z^2 - 1)|^{-2n}.
const RadialFields::Rule& RadialFields::rule_of(double cell, double from_middle, double across) const
{
  constexpr double digits = 18.5; // ln 1e8
  const std::complex<double> z(2.0 * from_middle / cell, 2.0 * std::hypot(across, scales_.decay) / cell);
  const std::complex<double> root = std::sqrt(z * z - 1.0);
  const double fall = std::log(std::max(std::abs(z + root), std::abs(z - root)));
  return rules_[static_cast<std::size_t>(std::clamp(static_cast<int>(std::ceil(0.5 * digits / fall)), 1, most_points) -
                                         1)];
}

Quadrant<WaveComponents> RadialFields::cells(std::size_t field) const
{
  Quadrant<WaveComponents> out(grid_);
  const auto gap = [](int offset, double cell) { return std::max(0.0, (offset - 0.5) * cell); };
  for (int j = 0; j < out.ny; ++j)
    for (int i = 0; i < out.nx; ++i)
    {
      const Rule& along_x = rule_of(grid_.dx, i * grid_.dx, gap(j, grid_.dy));
      const Rule& along_y = rule_of(grid_.dy, j * grid_.dy, gap(i, grid_.dx));
      WaveComponents& sum = out.at(i, j);
      for (std::size_t b = 0; b < along_y.point.size(); ++b)
        for (std::size_t a = 0; a < along_x.point.size(); ++a)
        {
          const double x = (i + along_x.point[a]) * grid_.dx, y = (j + along_y.point[b]) * grid_.dy;
          const double r = std::hypot(x, y), weight = along_x.weight[a] * along_y.weight[b] * grid_.cell_area();
          const WaveComponents value =
              components_of(terms_, at(field, r), r > 0.0 ? x / r : 1.0, r > 0.0 ? y / r : 0.0);
          for (std::size_t c = 0; c < value.size(); ++c)
            sum[c] += weight * value[c];
        }
    }
  return out;
}

} // namespace brinell::halfspace
