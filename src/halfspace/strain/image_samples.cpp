// SPDX-License-Identifier: BSD-3-Clause
#include "image_samples.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/lane_functions.hpp"
#include "green/sheet_stress.hpp"
#include "stack_image_samples.hpp"
#include "stack_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace brinell::halfspace::images
{

namespace
{

constexpr double pi = std::numbers::pi;
constexpr int components = stresses * strains;

double chebyshev(int order, double t)
{
  return std::cos(order * std::acos(std::clamp(t, -1.0, 1.0)));
}

/// Pairs of depths, of the point and of the sheet, one in each lane.
struct DepthPairs
{
  Lanes z{}, z_source{}, down_share{};

  /// The pairs from number `first` on; beyond the last pair, lanes repeat it.
  DepthPairs(const std::vector<double>& depths, std::size_t first)
  {
    const std::size_t count = depths.size();
    for (std::size_t lane = 0; lane < lane_count; ++lane)
    {
      const std::size_t pair = std::min(first + lane, count * count - 1);
      z[lane] = depths[pair / count];
      z_source[lane] = depths[pair % count];
      down_share[lane] = z[lane] > z_source[lane] ? 1.0 : z[lane] < z_source[lane] ? 0.0 : 0.5;
    }
  }
};

Lanes decay(const Lanes& distance)
{
  Lanes result;
  for (std::size_t lane = 0; lane < lane_count; ++lane)
    result[lane] = std::exp(-distance[lane]);
  return result;
}

green::SheetPath<Lanes> path_of(double k, const DepthPairs& pairs)
{
  const Lanes kz = k * pairs.z, kz_source = k * pairs.z_source, down = kz - kz_source;
  const Lanes s = down < 0.0 ? -down : down;
  return {s, kz, kz_source, decay(s), decay(kz), decay(kz_source), pairs.down_share, 1.0 - pairs.down_share};
}

ComplexLanes in_all_lanes(const Complex& value)
{
  return {value.real() - Lanes{}, value.imag() - Lanes{}};
}

/// The waves of a sheet whose strain has one component equal to 1 and all others zero.
green::SheetSource<ComplexLanes> unit_sheet(int component, const green::WaveDirection<double>& towards, double nu)
{
  std::array<Complex, strains> strain{};
  strain[static_cast<std::size_t>(component)] = 1.0;
  using D = Deviator;
  const green::SheetSource<Complex> sheet(green::in_wave_frame<double, Complex>(
      towards, nu, strain[D::xx], strain[D::yy], strain[D::yz], strain[D::xz], strain[D::xy]));
  const auto spread = [](const green::SheetWave<Complex>& wave) -> green::SheetWave<ComplexLanes> {
    return {in_all_lanes(wave.a), in_all_lanes(wave.c), in_all_lanes(wave.w)};
  };
  return {spread(sheet.down), spread(sheet.up)};
}

/// The waves of a sheet that would grow by 1 in all directions (stack-strain).
green::SheetSource<ComplexLanes> dilated_sheet(double nu)
{
  const ComplexLanes zero{};
  const green::SheetWave<ComplexLanes> wave{in_all_lanes(2.0 * (1.0 + nu)), zero, zero};
  return {wave, wave};
}

/// Adds the stress of sheets with one wave, [strain][stress][distance in x].
void add_wave(const WaveRow::Wave& wave, double n, const DepthPairs& depths, const Elastic& elastic, Source source,
              Lanes* sum)
{
  const double k = std::hypot(wave.m, n);
  const green::SheetPath<Lanes> path = path_of(k, depths);
  const green::WaveDirection<double> towards = green::direction_of(wave.m, n);
  const green::SheetStiffness stiffness(k, elastic);
  const double nu = elastic.poisson_ratio;
  for (int e = 0; e < components_of(source); ++e)
  {
    const auto sheet = source == Source::dilatation ? dilated_sheet(nu) : unit_sheet(e, towards, nu);
    const auto [xx, yy, yz, xz, xy, trace] = green::sheet_stress(sheet, path, stiffness, towards, nu);
    const std::array<const ComplexLanes*, stresses> values{&xx, &yy, &yz, &xz, &xy, &trace};
    for (int c = 0; c < stresses; ++c)
    {
      const bool odd_x = is_odd(odd_in_x, c, e);
      const bool odd_y = is_odd(odd_in_y, c, e);
      // Sum of K e^{ik.r} over the signs of m and n, K being real if odd in both or none, else imaginary.
      const ComplexLanes& value = *values[static_cast<std::size_t>(c)];
      const Lanes amplitude = wave.weight * (odd_x == odd_y ? (odd_x ? -value.re : value.re) : -value.im);
      for (const double in_x : wave.in_x[odd_x ? 1 : 0])
        *sum++ += in_x * amplitude;
    }
  }
}

/// Sums of the waves for the pairs of depths, [strain][stress][distance in y][distance in x].
std::vector<Lanes> sum_of_waves(std::span<const WaveRow> rows, const DepthPairs& depths, const Elastic& elastic,
                                Source source)
{
  const std::size_t along_x = rows.front().waves.front().in_x[0].size(), along_y = rows.front().in_y[0].size();
  std::vector<Lanes> sums(components * along_x * along_y), in_row(components * along_x);
  for (const WaveRow& row : rows)
  {
    std::fill(in_row.begin(), in_row.end(), Lanes{});
    for (const WaveRow::Wave& wave : row.waves)
      add_wave(wave, row.n, depths, elastic, source, in_row.data());
    const Lanes* from = in_row.data();
    Lanes* sum = sums.data();
    for (int e = 0; e < strains; ++e)
      for (int c = 0; c < stresses; ++c, from += along_x)
        for (const double in_y : row.in_y[is_odd(odd_in_y, c, e) ? 1 : 0])
          for (std::size_t ox = 0; ox < along_x; ++ox)
            *sum++ += in_y * from[ox];
  }
  return sums;
}

/// Polynomials of z that resolve fields which vary over the length `distance`, on a grid of the given thickness. A field
/// with its next singularity beside the interval of depth, at this distance, has Chebyshev coefficients that fall by
/// s = t + sqrt(1 + t^2), t = 2 distance / thickness, from one to the next.
/// @param fewest  more than one material have fewer each
int polynomials_in_depth(double thickness, double distance, int fewest)
{
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

namespace
{

/// Mean of a Chebyshev polynomial over one of `layers` layers: int T_q = [T_{q+1} / (q + 1) - T_{q-1} / (q - 1)] / 2.
double mean_over_layer(int q, int layer, int layers)
{
  const auto integral = [&](double t)
  {
    if (q == 0)
      return t;
    if (q == 1)
      return 0.5 * t * t;
    return 0.5 * (chebyshev(q + 1, t) / (q + 1) - chebyshev(q - 1, t) / (q - 1));
  };
  return 0.5 * layers * (integral(2.0 * (layer + 1) / layers - 1.0) - integral(2.0 * layer / layers - 1.0));
}

/// The materials of a layered body; a homogeneous one is one material.
std::vector<StackPart> materials(const VolumeGrid& grid, const ElasticStack& stack)
{
  if (stack.is_homogeneous())
    return {{0, grid.nz, stack.substrate}};
  return stack_parts(grid, stack);
}

std::vector<int> polynomials(const VolumeGrid& grid, const std::vector<StackPart>& parts, double distance)
{
  std::vector<int> counts;
  counts.reserve(parts.size());
  for (const StackPart& part : parts)
    counts.push_back(polynomials_in_depth((part.end - part.first) * grid.dz, distance, parts.size() == 1 ? 5 : 2));
  return counts;
}

} // namespace

DepthBasis::DepthBasis(const VolumeGrid& grid, const ElasticStack& stack, double distance)
{
  const std::vector<StackPart> parts = materials(grid, stack);
  const std::vector<int> counts = polynomials(grid, parts, distance);
  count = std::accumulate(counts.begin(), counts.end(), 0);
  means = Matrix(grid.nz, count);
  from_nodes = Matrix(count, count);
  int begin = 0;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    const auto& [first, end, elastic] = parts[p];
    const int own = counts[p];
    const double top = first * grid.dz, thickness = (end - first) * grid.dz;
    for (int i = 0; i < own; ++i)
      nodes.push_back(top + 0.5 * thickness * (1.0 - std::cos((2 * i + 1) * pi / (2.0 * own))));
    for (int q = 0; q < own; ++q)
    {
      // Discrete orthogonality.
      for (int i = 0; i < own; ++i)
        from_nodes(begin + q, begin + i) =
            (q == 0 ? 1.0 : 2.0) / own *
            chebyshev(q, 2.0 * (nodes[static_cast<std::size_t>(begin + i)] - top) / thickness - 1.0);
      for (int layer = first; layer < end; ++layer)
        means(layer, begin + q) = mean_over_layer(q, layer - first, end - first);
    }
    begin += own;
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

std::vector<double> sampled(std::span<const WaveRow> rows, const std::vector<double>& depths, const ElasticStack& stack,
                            Source source)
{
  if (!stack.is_homogeneous())
  {
    if (source != Source::plastic_strain)
      throw InternalError("images of a dilatation in a layered body are not known");
    return sampled_in_layers(rows, depths, stack);
  }
  const Elastic& elastic = stack.substrate;
  const std::size_t depth_pairs = depths.size() * depths.size();
  const std::size_t block = components * rows.front().waves.front().in_x[0].size() * rows.front().in_y[0].size();
  std::vector<double> value(depth_pairs * block);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t first = 0; first < depth_pairs; first += lane_count)
  {
    const std::vector<Lanes> sums = sum_of_waves(rows, DepthPairs(depths, first), elastic, source);
    const std::size_t used = std::min<std::size_t>(lane_count, depth_pairs - first);
    for (std::size_t lane = 0; lane < used; ++lane)
      for (std::size_t i = 0; i < block; ++i)
        value[(first + lane) * block + i] = sums[i][lane];
  }
  return value;
}

std::vector<Matrix> fitted(const std::vector<double>& samples, int c, int e, const std::array<int, 2>& distances,
                           const DepthBasis& depth, const std::vector<Powers>& powers)
{
  const int terms = static_cast<int>(powers.size());
  const int places = distances[0] * distances[1];
  Matrix basis(places, terms);
  for (int oy = 0; oy < distances[1]; ++oy)
    for (int ox = 0; ox < distances[0]; ++ox)
      for (int t = 0; t < terms; ++t)
        basis(ox + distances[0] * oy, t) =
            std::pow(offsets()[static_cast<std::size_t>(ox)], powers[static_cast<std::size_t>(t)][0]) *
            std::pow(offsets()[static_cast<std::size_t>(oy)], powers[static_cast<std::size_t>(t)][1]);
  const int depth_pairs = depth.count * depth.count;
  Matrix right(places, depth_pairs);
  for (int z = 0; z < depth_pairs; ++z)
    for (int o = 0; o < places; ++o)
      right(o, z) = samples[static_cast<std::size_t>((z * components + e * stresses + c) * places + o)];
  const Matrix at_nodes = least_squares(basis, right);
  Matrix of_depths(depth.count, depth.count); // from_nodes transposed
  for (int i = 0; i < depth.count; ++i)
    for (int q = 0; q < depth.count; ++q)
      of_depths(i, q) = depth.from_nodes(q, i);
  std::vector<Matrix> result;
  for (int t = 0; t < terms; ++t)
  {
    Matrix at_depths(depth.count, depth.count), along_z(depth.count, depth.count);
    for (int z = 0; z < depth.count; ++z)
      for (int z_source = 0; z_source < depth.count; ++z_source)
        at_depths(z, z_source) = at_nodes(t, z * depth.count + z_source);
    assign_product(depth.from_nodes, at_depths, along_z.column(0));
    assign_product(along_z, of_depths, result.emplace_back(depth.count, depth.count).column(0));
  }
  return result;
}

double factorial(int n)
{
  double value = 1.0;
  for (int i = 2; i <= n; ++i)
    value *= i;
  return value;
}

Matrix coordinate_powers(int cells, int degree)
{
  Matrix table(cells, degree + 1);
  const double whole = std::max(1, cells - 1);
  for (int power = 0; power <= degree; ++power)
    for (int i = 0; i < cells; ++i)
      table(i, power) = std::pow((i - 0.5 * (cells - 1)) / whole, power);
  return table;
}

} // namespace brinell::halfspace::images
