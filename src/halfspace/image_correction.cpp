// SPDX-License-Identifier: BSD-3-Clause
#include "halfspace/image_correction.hpp"

#include "brinell/foundation/deviator.hpp"
#include "brinell/green/eigenstrain_sheet.hpp"
#include "foundation/lane_functions.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell::halfspace
{

namespace
{

constexpr double pi = std::numbers::pi;
constexpr int enlargement = 4; ///< the second lattice has periods this many times the first one's
constexpr int offset_nodes = 5;

constexpr std::array<int, Deviator::size + 1> odd_in_x{0, 0, 0, 1, 1, 0}; // xx yy yz xz xy, trace
constexpr std::array<int, Deviator::size + 1> odd_in_y{0, 0, 1, 0, 1, 0};

/// Place of x^a y^b among the monomials.
int monomial(int a, int b)
{
  const int n = a + b;
  return n * (n + 1) / 2 + b;
}

double binomial(int n, int k)
{
  double value = 1.0;
  for (int i = 0; i < k; ++i)
    value = value * (n - i) / (i + 1);
  return value;
}

/// Positive zeros of a Chebyshev polynomial: where the offset polynomials are fitted.
std::array<double, offset_nodes> fit_offsets()
{
  std::array<double, offset_nodes> x{};
  for (int i = 0; i < offset_nodes; ++i)
    x[static_cast<std::size_t>(i)] = std::cos((2 * i + 1) * pi / (4.0 * offset_nodes));
  return x;
}

/// Powers of one coordinate: of the parity of the first one.
struct PowerRange
{
  int first, last;
};

/// Powers (a, b) within the ranges whose sum is within the larger one.
std::vector<std::array<int, 2>> powers_of_parity(PowerRange x, PowerRange y)
{
  std::vector<std::array<int, 2>> result;
  for (int a = x.first; a <= x.last; a += 2)
    for (int b = y.first; b <= y.last && a + b <= std::max(x.last, y.last); b += 2)
      result.push_back({a, b});
  return result;
}

double chebyshev(int order, double t)
{
  return std::cos(order * std::acos(std::clamp(t, -1.0, 1.0)));
}

} // namespace

ImageCorrection::ImageCorrection(const VolumeGrid& grid, const Elastic& elastic, const BlockedFft& fft)
    : grid_(grid), has_images_(!grid.surface.is_periodic())
{
  if (!has_images_)
    return;
  const SurfaceGrid& s = grid.surface;
  const auto tabulate = [](int cells, std::vector<double>& table)
  {
    table.resize(static_cast<std::size_t>((degree + 1) * cells));
    const double half = std::max(1, cells - 1);
    for (int power = 0; power <= degree; ++power)
      for (int i = 0; i < cells; ++i)
        table[static_cast<std::size_t>(power * cells + i)] = std::pow((i - 0.5 * (cells - 1)) / half, power);
  };
  tabulate(s.nx, x_);
  tabulate(s.ny, y_);
  // Mean of T_q over a layer by three Gauss points: exact up to the fifth power, more than depths = 5 needs.
  chebyshev_.resize(static_cast<std::size_t>(depths * grid.nz));
  for (int q = 0; q < depths; ++q)
    for (int layer = 0; layer < grid.nz; ++layer)
    {
      const auto at = [&](double shift) { return chebyshev(q, 2.0 * (layer + 0.5 + shift) / grid.nz - 1.0); };
      const double d = 0.5 * std::sqrt(0.6);
      chebyshev_[static_cast<std::size_t>(q * grid.nz + layer)] = (5.0 * (at(-d) + at(d)) + 8.0 * at(0.0)) / 18.0;
    }
  fit(elastic, fft.px() * s.dx, fft.py() * s.dy);
}

namespace
{

/// Depths, and distances in x and y over the largest ones, at which the stress of the images is sampled.
struct Nodes
{
  std::array<double, offset_nodes> offset = fit_offsets();
  std::vector<double> depth;         ///< zeros of a Chebyshev polynomial over the thickness [m]
  double half_x = 0.0, half_y = 0.0; ///< largest distances within the grid [m]

  Nodes(const VolumeGrid& grid, int depths)
      : half_x(std::max(1, grid.surface.nx - 1) * grid.surface.dx),
        half_y(std::max(1, grid.surface.ny - 1) * grid.surface.dy)
  {
    for (int i = 0; i < depths; ++i)
      depth.push_back(0.5 * grid.nz * grid.dz * (1.0 - std::cos((2 * i + 1) * pi / (2.0 * depths))));
  }
};

constexpr int strain_count = Deviator::size;
constexpr int stress_count = Deviator::size + 1;
constexpr int pairs = stress_count * strain_count;
constexpr int places = offset_nodes * offset_nodes;

/// Whether the stress c of a strain e is odd in a direction, given the parities of the components in it.
bool is_odd(const std::array<int, stress_count>& parity, int c, int e)
{
  return (parity[static_cast<std::size_t>(c)] + parity[static_cast<std::size_t>(e)]) % 2 != 0;
}

/// One wavevector and its mirror images in x and y, at all offsets.
struct Wavevector
{
  double m, n, weight;
  std::array<double, offset_nodes> cos_x{}, sin_x{}, cos_y{}, sin_y{};

  Wavevector(double m_, double n_, double weight_, const Nodes& nodes) : m(m_), n(n_), weight(weight_)
  {
    for (std::size_t o = 0; o < offset_nodes; ++o)
    {
      cos_x[o] = std::cos(m * nodes.half_x * nodes.offset[o]);
      sin_x[o] = std::sin(m * nodes.half_x * nodes.offset[o]);
      cos_y[o] = std::cos(n * nodes.half_y * nodes.offset[o]);
      sin_y[o] = std::sin(n * nodes.half_y * nodes.offset[o]);
    }
  }
};

/// Adds the stress at depth z of sheets at depth z_source, [stress][strain][place].
void add_wave(const Wavevector& k, double z, double z_source, const Elastic& elastic, double* sum)
{
  for (int e = 0; e < strain_count; ++e)
  {
    Deviator unit;
    unit[e] = 1.0;
    const auto stress = green::eigenstrain_sheet_stress(k.m, k.n, z, z_source, unit, elastic);
    for (int c = 0; c < stress_count; ++c)
    {
      const Complex value = c < strain_count ? stress.deviator[static_cast<std::size_t>(c)] : stress.trace;
      const bool odd_x = is_odd(odd_in_x, c, e);
      const bool odd_y = is_odd(odd_in_y, c, e);
      // Sum of K e^{ik.r} over the signs of m and n, K being real if odd in both or none, else imaginary.
      const double amplitude = k.weight * (odd_x == odd_y ? (odd_x ? -value.real() : value.real()) : -value.imag());
      const auto& in_x = odd_x ? k.sin_x : k.cos_x;
      const auto& in_y = odd_y ? k.sin_y : k.cos_y;
      double* to = sum + static_cast<std::ptrdiff_t>((c * strain_count + e) * places);
      for (std::size_t oy = 0; oy < offset_nodes; ++oy)
        for (std::size_t ox = 0; ox < offset_nodes; ++ox)
          to[ox + offset_nodes * oy] += amplitude * in_x[ox] * in_y[oy];
    }
  }
}

/// Period of the body along one axis, and by what it is enlarged in the second lattice.
struct Period
{
  double length; ///< [m]
  bool is_open;
  [[nodiscard]] int enlarged() const { return is_open ? enlargement : 1; }
  /// Index of the shortest wave on the second lattice. Along a periodic axis the copies of a source belong to the body; what
  /// comes from those of the other axis is uniform along it, since `padded_lengths` lets no other wave come so far.
  [[nodiscard]] int last_wave(double k_max) const
  {
    return is_open ? static_cast<int>(k_max * enlargement * length / (2.0 * pi)) : 0;
  }
  [[nodiscard]] double wavenumber(int index) const { return 2.0 * pi * index / (enlarged() * length); }
};

/// The waves that make the stress of the images: the lattice with the padded lengths minus the large one, times the
/// extrapolation from there to an infinite one.
std::vector<Wavevector> waves_of_images(const Period& x, const Period& y, const Nodes& nodes)
{
  const double width = (!x.is_open ? y.length : !y.is_open ? x.length : std::min(x.length, y.length)) / 10.0;
  const double k_max = 6.5 / width;
  const double larger = x.enlarged() * y.enlarged(); // lattice, by so much
  const double fewer = enlargement * larger;         // images of points decay as 1/r^3, those of lines as 1/r^2
  std::vector<Wavevector> waves;
  for (int j = 0; j <= y.last_wave(k_max); ++j)
    for (int i = 0; i <= x.last_wave(k_max); ++i)
    {
      const double m = x.wavenumber(i);
      const double n = y.wavenumber(j);
      const double k2 = m * m + n * n;
      if (k2 == 0.0 || k2 > k_max * k_max)
        continue;
      const bool on_small = i % x.enlarged() == 0 && j % y.enlarged() == 0;
      const double copies = (i == 0 ? 1.0 : 2.0) * (j == 0 ? 1.0 : 2.0);
      const double blur = (1.0 + 0.5 * k2 * width * width) * std::exp(-0.5 * k2 * width * width);
      waves.emplace_back(
          m, n, copies * blur * ((on_small ? 1.0 : 0.0) - 1.0 / larger) / (x.length * y.length) * fewer / (fewer - 1.0),
          nodes);
    }
  return waves;
}

/// Stress of the images. @returns [depth of stress][depth of strain][stress][strain][place].
std::vector<double> sample_images(const Elastic& elastic, const Period& x, const Period& y, const Nodes& nodes)
{
  const auto depths = static_cast<int>(nodes.depth.size());
  std::vector<double> value(static_cast<std::size_t>(depths * depths * pairs * places), 0.0);
  const std::vector<Wavevector> waves = waves_of_images(x, y, nodes);
#pragma omp parallel for schedule(dynamic) collapse(2)
  for (int zi = 0; zi < depths; ++zi)
    for (int zj = 0; zj < depths; ++zj)
      for (const Wavevector& k : waves)
        add_wave(k, nodes.depth[static_cast<std::size_t>(zi)], nodes.depth[static_cast<std::size_t>(zj)], elastic,
                 value.data() + static_cast<std::ptrdiff_t>((zi * depths + zj) * pairs * places));
  return value;
}

/// Least-squares coefficients of the monomials `powers_here` in the offsets, for one pair of components: [term][zi, zj].
Eigen::MatrixXd fit_offset_polynomial(const std::vector<double>& samples, int pair,
                                      const std::vector<std::array<int, 2>>& powers_here, const Nodes& nodes)
{
  const auto terms = static_cast<Eigen::Index>(powers_here.size());
  const auto depth_pairs = static_cast<Eigen::Index>(nodes.depth.size() * nodes.depth.size());
  Eigen::MatrixXd basis(places, terms);
  for (std::size_t oy = 0; oy < offset_nodes; ++oy)
    for (std::size_t ox = 0; ox < offset_nodes; ++ox)
      for (Eigen::Index t = 0; t < terms; ++t)
        basis(static_cast<Eigen::Index>(ox + offset_nodes * oy), t) =
            std::pow(nodes.offset[ox], powers_here[static_cast<std::size_t>(t)][0]) *
            std::pow(nodes.offset[oy], powers_here[static_cast<std::size_t>(t)][1]);
  Eigen::MatrixXd right(places, depth_pairs);
  for (Eigen::Index z = 0; z < depth_pairs; ++z)
    for (Eigen::Index o = 0; o < places; ++o)
      right(o, z) = samples[static_cast<std::size_t>((z * pairs + pair) * places + o)];
  return basis.colPivHouseholderQr().solve(right);
}

} // namespace

void ImageCorrection::fit(const Elastic& elastic, double period_x, double period_y)
{
  const Nodes nodes(grid_, depths);
  const SurfaceGrid& s = grid_.surface;
  const std::vector<double> samples =
      sample_images(elastic, {period_x, !s.is_periodic_x()}, {period_y, !s.is_periodic_y()}, nodes);

  // Node values in depth -> Chebyshev coefficients (discrete orthogonality).
  Eigen::MatrixXd to_chebyshev(depths, depths);
  const double thickness = grid_.nz * grid_.dz;
  for (int q = 0; q < depths; ++q)
    for (int i = 0; i < depths; ++i)
      to_chebyshev(q, i) = (q == 0 ? 1.0 : 2.0) / depths *
                           chebyshev(q, 2.0 * nodes.depth[static_cast<std::size_t>(i)] / thickness - 1.0);

  sort_moments();
  for (int c = 0; c < stresses; ++c)
    for (int e = 0; e < strains; ++e)
    {
      const bool odd_x = is_odd(odd_in_x, c, e);
      const bool odd_y = is_odd(odd_in_y, c, e);
      if ((s.is_periodic_x() && odd_x) || (s.is_periodic_y() && odd_y))
        continue;
      const auto powers_here = powers_of_parity({odd_x ? 1 : 0, s.is_periodic_x() ? 0 : degree},
                                                {odd_y ? 1 : 0, s.is_periodic_y() ? 0 : degree});
      const Eigen::MatrixXd fitted = fit_offset_polynomial(samples, c * strains + e, powers_here, nodes);
      for (std::size_t t = 0; t < powers_here.size(); ++t)
      {
        Eigen::Matrix<double, depths, depths> at_nodes;
        for (int zi = 0; zi < depths; ++zi)
          for (int zj = 0; zj < depths; ++zj)
            at_nodes(zi, zj) = fitted(static_cast<Eigen::Index>(t), zi * depths + zj);
        // The sum over cells stands for an integral.
        const Eigen::MatrixXd coefficient = grid_.cell_volume() * (to_chebyshev * at_nodes * to_chebyshev.transpose());
        for (int qi = 0; qi < depths; ++qi)
          for (int qj = 0; qj < depths; ++qj)
            couple(c * depths + qi, e * depths + qj, powers_here[t], coefficient(qi, qj));
      }
    }
}

/// Sorts the moments into classes of like parity.
void ImageCorrection::sort_moments()
{
  for (int c = 0; c < stresses; ++c)
    for (int q = 0; q < depths; ++q)
      for (int a = 0; a <= degree; ++a)
        for (int b = 0; a + b <= degree; ++b)
        {
          const auto component = static_cast<std::size_t>(c);
          const int parity = (a + odd_in_x[component]) % 2 + 2 * ((b + odd_in_y[component]) % 2);
          ParityClass& members = classes_[static_cast<std::size_t>(parity)];
          const auto moment = static_cast<std::size_t>((c * depths + q) * powers + monomial(a, b));
          place_[moment] = {parity, members.members.size()};
          members.members.push_back(static_cast<int>(moment));
          members.strains += c < strains ? 1 : 0;
        }
  for (ParityClass& c : classes_)
    c.coupling.assign(c.members.size() * c.strains, 0.0);
}

/// Adds one term of the kernel, value (x - x')^a (y - y')^b, as products of monomials of the point and of the source.
/// @param stress, strain  component and depth polynomial of either, component * depths + polynomial.
void ImageCorrection::couple(int stress, int strain, const std::array<int, 2>& power, double value)
{
  const auto [a, b] = power;
  for (int pa = 0; pa <= a; ++pa)
    for (int pb = 0; pb <= b; ++pb)
    {
      const double split = binomial(a, pa) * binomial(b, pb) * ((a - pa + b - pb) % 2 == 0 ? 1.0 : -1.0);
      const Place& row = place_[static_cast<std::size_t>(stress * powers + monomial(pa, pb))];
      const Place& column = place_[static_cast<std::size_t>(strain * powers + monomial(a - pa, b - pb))];
      ParityClass& parity = classes_[static_cast<std::size_t>(row.parity)];
      parity.coupling[row.index * parity.strains + column.index] += split * value;
    }
}

ImageCorrection::Response ImageCorrection::make_response() const
{
  if (!has_images_)
    return {};
  return {std::vector<double>(static_cast<std::size_t>(strains * grid_.nz * powers)),
          std::vector<double>(strain_moments), std::vector<double>(stress_moments)};
}

void ImageCorrection::respond(std::span<const double> strain, int layers, Response& response) const
{
  if (!has_images_)
    return;
  const SurfaceGrid& s = grid_.surface;
  const std::size_t cells = s.size();
  const auto of_layer = [&](int component, int layer)
  { return response.of_layers.data() + static_cast<std::ptrdiff_t>((component * grid_.nz + layer) * powers); };

#pragma omp parallel for collapse(2) schedule(static)
  for (int e = 0; e < strains; ++e)
    for (int layer = 0; layer < layers; ++layer)
    {
      const double* field = strain.data() + static_cast<std::size_t>(e * grid_.nz + layer) * cells;
      double* moment = of_layer(e, layer);
      std::array<Lanes, powers> sum{};
      for (int first = 0; first < s.nx; first += lane_count)
      {
        const auto used = static_cast<std::size_t>(std::min(lane_count, s.nx - first));
        std::array<Lanes, degree + 1> of_columns{};
        for (int j = 0; j < s.ny; ++j)
        {
          const Lanes value = load_lanes(field + s.nx * j + first, used);
          for (std::size_t b = 0; b <= degree; ++b)
            of_columns[b] += y_[b * static_cast<std::size_t>(s.ny) + static_cast<std::size_t>(j)] * value;
        }
        for (int a = 0; a <= degree; ++a)
        {
          const Lanes x = load_lanes(x_.data() + a * s.nx + first, used);
          for (int b = 0; a + b <= degree; ++b)
            sum[static_cast<std::size_t>(monomial(a, b))] += x * of_columns[static_cast<std::size_t>(b)];
        }
      }
      for (std::size_t p = 0; p < powers; ++p)
      {
        moment[p] = 0.0;
        for (std::size_t lane = 0; lane < lane_count; ++lane)
          moment[p] += sum[p][lane];
      }
    }

  std::fill(response.moments.begin(), response.moments.end(), 0.0);
  for (int e = 0; e < strains; ++e)
    for (int q = 0; q < depths; ++q)
      for (int layer = 0; layer < layers; ++layer)
        for (int p = 0; p < powers; ++p)
          response.moments[static_cast<std::size_t>((e * depths + q) * powers + p)] +=
              chebyshev_[static_cast<std::size_t>(q * grid_.nz + layer)] * of_layer(e, layer)[p];
  for (const ParityClass& c : classes_)
  {
    std::array<double, strain_moments> in_class{};
    for (std::size_t i = 0; i < c.strains; ++i)
      in_class[i] = response.moments[static_cast<std::size_t>(c.members[i])];
    for (std::size_t row = 0; row < c.members.size(); ++row)
    {
      double sum = 0.0;
#pragma omp simd reduction(+ : sum)
      for (std::size_t column = 0; column < c.strains; ++column)
        sum += c.coupling[row * c.strains + column] * in_class[column];
      response.stress[static_cast<std::size_t>(c.members[row])] = sum;
    }
  }
}

void ImageCorrection::subtract(const Response& response, int component, int layer, double* stress) const
{
  if (!has_images_)
    return;
  const SurfaceGrid& s = grid_.surface;
  std::array<double, powers> of_depth{};
  for (int q = 0; q < depths; ++q)
    for (int p = 0; p < powers; ++p)
      of_depth[static_cast<std::size_t>(p)] +=
          chebyshev_[static_cast<std::size_t>(q * grid_.nz + layer)] *
          response.stress[static_cast<std::size_t>((component * depths + q) * powers + p)];
  for (int j = 0; j < s.ny; ++j)
  {
    std::array<double, degree + 1> of_row{};
    for (int a = 0; a <= degree; ++a)
      for (int b = 0; a + b <= degree; ++b)
        of_row[static_cast<std::size_t>(a)] +=
            of_depth[static_cast<std::size_t>(monomial(a, b))] * y_[static_cast<std::size_t>(b * s.ny + j)];
    double* row = stress + static_cast<std::ptrdiff_t>(s.nx) * j;
#pragma omp simd
    for (int i = 0; i < s.nx; ++i)
    {
      double sum = 0.0;
      for (int a = 0; a <= degree; ++a)
        sum += of_row[static_cast<std::size_t>(a)] * x_[static_cast<std::size_t>(a * s.nx + i)];
      row[i] -= sum;
    }
  }
}

} // namespace brinell::halfspace
