// SPDX-License-Identifier: BSD-3-Clause
#include "halfspace/image_samples.hpp"

#include "brinell/green/eigenstrain_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace brinell::halfspace::images
{

namespace
{

constexpr double pi = std::numbers::pi;
constexpr int pairs = stresses * strains;

double chebyshev(int order, double t)
{
  return std::cos(order * std::acos(std::clamp(t, -1.0, 1.0)));
}

/// Adds the stress at depth z of a sheet at depth z_source with one wave, [stress][strain][distance in x].
void add_wave(const WaveRow::Wave& k, double n, double z, double z_source, const Elastic& elastic, double* sum)
{
  const auto stresses_of = green::unit_sheet_stresses(k.m, n, z, z_source, elastic);
  const std::size_t along_x = k.in_x[0].size();
  for (int c = 0; c < stresses; ++c)
    for (int e = 0; e < strains; ++e)
    {
      const green::SheetStress& stress = stresses_of[static_cast<std::size_t>(e)];
      const auto value = c < strains ? stress.deviator[static_cast<std::size_t>(c)] : stress.trace;
      const bool odd_x = is_odd(odd_in_x, c, e);
      const bool odd_y = is_odd(odd_in_y, c, e);
      // Sum of K e^{ik.r} over the signs of m and n, K being real if odd in both or none, else imaginary.
      const double amplitude = k.weight * (odd_x == odd_y ? (odd_x ? -value.real() : value.real()) : -value.imag());
      const double* in_x = k.in_x[odd_x ? 1 : 0].data();
      for (std::size_t ox = 0; ox < along_x; ++ox)
        *sum++ += amplitude * in_x[ox];
    }
}

/// Adds the stress of a row of waves, [stress][strain][distance in y][distance in x].
void add_row(const WaveRow& row, double z, double z_source, const Elastic& elastic, double* sum)
{
  const std::size_t along_x = row.waves.front().in_x[0].size();
  std::vector<double> in_row(pairs * along_x, 0.0);
  for (const WaveRow::Wave& wave : row.waves)
    add_wave(wave, row.n, z, z_source, elastic, in_row.data());
  const double* from = in_row.data();
  for (int c = 0; c < stresses; ++c)
    for (int e = 0; e < strains; ++e, from += along_x)
      for (const double in_y : row.in_y[is_odd(odd_in_y, c, e) ? 1 : 0])
        for (std::size_t ox = 0; ox < along_x; ++ox)
          *sum++ += in_y * from[ox];
}

/// Polynomials of z that resolve fields which vary over the length `distance`, on a grid of the given thickness. A field
/// with its next singularity beside the interval of depth, at this distance, has Chebyshev coefficients that fall by
/// s = t + sqrt(1 + t^2), t = 2 distance / thickness, from one to the next.
int polynomials_in_depth(double thickness, double distance)
{
  constexpr int fewest = 5;
  constexpr int most = 16;
  const double t = 2.0 * distance / thickness;
  const double fall = std::log(t + std::sqrt(1.0 + t * t));
  return std::clamp(static_cast<int>(std::ceil(8.0 / fall)), fewest, most);
}

} // namespace

const std::array<double, offset_nodes>& offsets()
{
  static const std::array<double, offset_nodes> nodes = []
  {
    std::array<double, offset_nodes> x{};
    for (std::size_t i = 0; i < offset_nodes; ++i)
      x[i] = std::cos((2.0 * static_cast<double>(i) + 1.0) * pi / (4.0 * offset_nodes));
    return x;
  }();
  return nodes;
}

DepthBasis::DepthBasis(const VolumeGrid& grid, double distance)
    : count(polynomials_in_depth(grid.nz * grid.dz, distance)), means(grid.nz, count), from_nodes(count, count)
{
  const double thickness = grid.nz * grid.dz;
  for (int i = 0; i < count; ++i)
    nodes.push_back(0.5 * thickness * (1.0 - std::cos((2 * i + 1) * pi / (2.0 * count))));
  for (int q = 0; q < count; ++q)
  {
    // Discrete orthogonality.
    for (int i = 0; i < count; ++i)
      from_nodes(q, i) =
          (q == 0 ? 1.0 : 2.0) / count * chebyshev(q, 2.0 * nodes[static_cast<std::size_t>(i)] / thickness - 1.0);
    // Mean over a layer: int T_q = [T_{q+1} / (q + 1) - T_{q-1} / (q - 1)] / 2.
    const auto integral = [&](double t)
    {
      if (q == 0)
        return t;
      if (q == 1)
        return 0.5 * t * t;
      return 0.5 * (chebyshev(q + 1, t) / (q + 1) - chebyshev(q - 1, t) / (q - 1));
    };
    for (int layer = 0; layer < grid.nz; ++layer)
      means(layer, q) =
          0.5 * grid.nz * (integral(2.0 * (layer + 1) / grid.nz - 1.0) - integral(2.0 * layer / grid.nz - 1.0));
  }
}

double blur(double k, double width)
{
  const double x = 0.5 * k * k * width * width;
  return (1.0 + x + 0.5 * x * x) * std::exp(-x);
}

Phases phases(double k, double largest)
{
  Phases result;
  for (const double offset : offsets())
  {
    result[0].push_back(std::cos(k * largest * offset));
    result[1].push_back(std::sin(k * largest * offset));
  }
  return result;
}

std::vector<double> sampled(std::span<const WaveRow> rows, const std::vector<double>& depths, const Elastic& elastic)
{
  const auto count = static_cast<int>(depths.size());
  const std::size_t block = pairs * rows.front().waves.front().in_x[0].size() * rows.front().in_y[0].size();
  std::vector<double> value(static_cast<std::size_t>(count * count) * block, 0.0);
#pragma omp parallel for schedule(dynamic) collapse(2)
  for (int zi = 0; zi < count; ++zi)
    for (int zj = 0; zj < count; ++zj)
      for (const WaveRow& row : rows)
        add_row(row, depths[static_cast<std::size_t>(zi)], depths[static_cast<std::size_t>(zj)], elastic,
                value.data() + static_cast<std::size_t>(zi * count + zj) * block);
  return value;
}

std::vector<Eigen::MatrixXd> fitted(const std::vector<double>& samples, int c, int e,
                                    const std::array<int, 2>& distances, const DepthBasis& depth,
                                    const std::vector<Powers>& powers)
{
  const auto terms = static_cast<Eigen::Index>(powers.size());
  const int places = distances[0] * distances[1];
  Eigen::MatrixXd basis(places, terms);
  for (int oy = 0; oy < distances[1]; ++oy)
    for (int ox = 0; ox < distances[0]; ++ox)
      for (Eigen::Index t = 0; t < terms; ++t)
        basis(ox + distances[0] * oy, t) =
            std::pow(offsets()[static_cast<std::size_t>(ox)], powers[static_cast<std::size_t>(t)][0]) *
            std::pow(offsets()[static_cast<std::size_t>(oy)], powers[static_cast<std::size_t>(t)][1]);
  const int depth_pairs = depth.count * depth.count;
  Eigen::MatrixXd right(places, depth_pairs);
  for (int z = 0; z < depth_pairs; ++z)
    for (int o = 0; o < places; ++o)
      right(o, z) = samples[static_cast<std::size_t>((z * pairs + c * strains + e) * places + o)];
  const Eigen::MatrixXd at_nodes = basis.colPivHouseholderQr().solve(right);
  std::vector<Eigen::MatrixXd> result;
  for (Eigen::Index t = 0; t < terms; ++t)
  {
    const Eigen::VectorXd row = at_nodes.row(t);
    const Eigen::Map<const Eigen::MatrixXd> transposed(row.data(), depth.count, depth.count); // [z'][z]
    result.emplace_back(depth.from_nodes * transposed.transpose() * depth.from_nodes.transpose());
  }
  return result;
}

double binomial(int n, int k)
{
  double value = 1.0;
  for (int i = 0; i < k; ++i)
    value = value * (n - i) / (i + 1);
  return value;
}

Eigen::MatrixXd coordinate_powers(int cells, int degree)
{
  Eigen::MatrixXd table(cells, degree + 1);
  const double whole = std::max(1, cells - 1);
  for (int power = 0; power <= degree; ++power)
    for (int i = 0; i < cells; ++i)
      table(i, power) = std::pow((i - 0.5 * (cells - 1)) / whole, power);
  return table;
}

} // namespace brinell::halfspace::images
