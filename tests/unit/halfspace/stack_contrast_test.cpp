// SPDX-License-Identifier: BSD-3-Clause
// Responses of the cells of layered bodies, hard and soft coatings up to 1:100, thin and thick, against integrals of the waves.
#include "gauss.hpp"
#include "halfspace/traction/stack_cells.hpp"
#include "halfspace/traction/stack_shears.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

namespace brinell::halfspace::stack_contrast_test
{
namespace
{

using std::numbers::pi;

/// Calls use(k, weight) for a rule from the longest waves to those that have decayed by e^{-36}.
/// @param decay     waves fall as e^{-k decay}
/// @param distance  no interval contains more than half a wave over this distance
template <typename Use>
void over_wavenumbers(double decay, double longest, double distance, const Use& use)
{
  const double end = 36.0 / decay;
  for (double low = 0.0, high = 1e-6 / longest; low < end;)
  {
    const test::Gauss rule(12, low, high);
    for (std::size_t n = 0; n < rule.point.size(); ++n)
      use(rule.point[n], rule.weight[n]);
    low = high;
    high = std::min(1.5 * low, low + pi / std::max(distance, decay));
  }
}

/// The mean over a cell of 1 x 1, centred at (x, y), of a function of a point. Where the function is sharp, near the load, by 12 x 12
/// points; three points a side are exact to 1e-9 ten cells away.
template <typename Function>
std::array<double, 6> over_cell(double x, double y, const Function& f)
{
  const test::Gauss along(x + y > 10.0 ? 3 : 12, -0.5, 0.5);
  std::array<double, 6> sum{};
  for (std::size_t i = 0; i < along.point.size(); ++i)
    for (std::size_t j = 0; j < along.point.size(); ++j)
    {
      const std::array<double, 6> value = f(x + along.point[i], y + along.point[j]);
      for (std::size_t c = 0; c < sum.size(); ++c)
        sum[c] += along.weight[i] * along.weight[j] * value[c];
    }
  return sum;
}

struct Coat
{
  double contrast, thickness;
  [[nodiscard]] ElasticStack stack() const { return {{{thickness, {contrast, 0.25}}}, {1.0, 0.35}}; }
  /// Over this distance a hard coating carries a shear before it is that of the substrate.
  [[nodiscard]] double longest() const { return thickness * std::max(contrast, 1.0 / contrast); }
};

class StackContrast : public testing::TestWithParam<std::tuple<double, double>>
{
protected:
  [[nodiscard]] static Coat coat() { return {std::get<0>(GetParam()), std::get<1>(GetParam())}; }
};
/// What takes longer.
class LargestContrast : public StackContrast
{
};
std::string name_of(const testing::TestParamInfo<std::tuple<double, double>>& p)
{
  return "contrast_" + std::to_string(std::lround(1000.0 * std::get<0>(p.param))) + "_thickness_" +
         std::to_string(std::lround(10.0 * std::get<1>(p.param)));
}
INSTANTIATE_TEST_SUITE_P(Coats, StackContrast,
                         testing::Combine(testing::Values(0.01, 0.1, 10.0, 100.0),
                                          testing::Values(0.5, 1.0, 4.0, 32.0)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Coats, LargestContrast,
                         testing::Combine(testing::Values(0.01, 100.0), testing::Values(0.5, 4.0)), name_of);

TEST_P(StackContrast, DisplacementsAreTheLayeredIntegrals)
{
  const ElasticStack stack = coat().stack();
  const SurfaceGrid grid{32, 24, 1.0, 1.0};
  const Quadrant<SurfaceExcess> found = excess_surface(grid, stack, 0.0);
  const Elastic& top = stack.top();
  const double nu = top.poisson_ratio, mu = top.shear_modulus();
  struct Wave
  {
    double k, normal, along, across, coupling;
  };
  const auto waves_to = [&](double distance)
  {
    std::vector<Wave> waves;
    over_wavenumbers(2.0 * coat().thickness, coat().longest(), distance,
                     [&](double k, double weight)
                     {
                       const green::WaveCompliance c = green::StackWave(stack, k).compliance();
                       const double w = 0.5 / pi * weight;
                       waves.push_back({k, w * (k * c.normal - (1.0 - nu) / mu), w * (k * c.along - (1.0 - nu) / mu),
                                        w * (k * c.across - 1.0 / mu),
                                        w * (k * c.coupling + 0.5 * (1.0 - 2.0 * nu) / mu)});
                     });
    return waves;
  };
  const auto of_point = [](const std::vector<Wave>& waves, double x, double y)
  {
    const double r = std::hypot(x, y), cosine = x / r, sine = y / r, twice = cosine * cosine - sine * sine;
    SurfaceExcess sum{};
    for (const Wave& wave : waves)
    {
      const double J0 = std::cyl_bessel_j(0, wave.k * r), J1 = std::cyl_bessel_j(1, wave.k * r);
      const double J2 = std::cyl_bessel_j(2, wave.k * r);
      const double mean = 0.5 * (wave.along + wave.across) * J0, turned = 0.5 * (wave.along - wave.across) * J2;
      sum[excess::zz] += wave.normal * J0;
      sum[excess::xx] += mean - twice * turned;
      sum[excess::yy] += mean + twice * turned;
      sum[excess::xy] -= 2.0 * cosine * sine * turned;
      sum[excess::x] -= wave.coupling * J1 * cosine;
      sum[excess::y] -= wave.coupling * J1 * sine;
    }
    return sum;
  };
  // Of the whole displacement under the load: that of the top material is 0.56 of that of a wave of one cell (Love).
  const double of_top = 0.56 * (1.0 - stack.top().poisson_ratio) / stack.top().shear_modulus();
  const double scale = of_top + std::min(found.at(0, 0)[excess::zz], found.at(0, 0)[excess::xx]);
  for (const auto& [i, j] : {std::pair{0, 0}, {3, 2}, {31, 23}})
  {
    const std::vector<Wave> waves = waves_to(std::hypot(i + 0.5, j + 0.5));
    const SurfaceExcess expected = over_cell(i, j, [&](double x, double y) { return of_point(waves, x, y); });
    for (std::size_t t = 0; t < excess::count; ++t)
      EXPECT_NEAR(found.at(i, j)[t], expected[t], 1e-7 * scale) << "term " << t << " at " << i << ' ' << j;
  }
}

/// Fields of WaveStress around a load on a point: those of (stack-waves) in cylindrical coordinates, turned to x and y.
SymTensor around(Traction traction, const green::WaveStress& p, const green::WaveStress& q, double kr, double cosine,
                 double sine)
{
  const double J0 = std::cyl_bessel_j(0, kr), J1 = std::cyl_bessel_j(1, kr), J2 = std::cyl_bessel_j(2, kr),
               J3 = std::cyl_bessel_j(3, kr);
  const double cos2 = cosine * cosine - sine * sine, sin2 = 2.0 * cosine * sine;
  if (traction == Traction::pressure)
  {
    const double mean = 0.5 * (p.ll + p.tt) * J0, turned = 0.5 * (p.ll - p.tt) * J2;
    return {mean - turned * cos2, mean + turned * cos2, p.zz * J0,
            -p.lz * J1 * sine,    -p.lz * J1 * cosine,  -turned * sin2};
  }
  const double cos3 = cosine * (1.0 - 4.0 * sine * sine), sin3 = sine * (4.0 * cosine * cosine - 1.0);
  const double third = 0.25 * (p.ll - p.tt - 2.0 * q.lt) * J3;
  const double xx = 0.25 * (3.0 * p.ll + p.tt + 2.0 * q.lt) * J1, yy = 0.25 * (p.ll + 3.0 * p.tt - 2.0 * q.lt) * J1;
  const double xy = 0.25 * (p.ll - p.tt + 2.0 * q.lt) * J1;
  return {third * cos3 - xx * cosine,
          -third * cos3 - yy * cosine,
          -p.zz * J1 * cosine,
          -0.5 * (p.lz - q.tz) * J2 * sin2,
          0.5 * (p.lz + q.tz) * J0 - 0.5 * (p.lz - q.tz) * J2 * cos2,
          third * sin3 - xy * sine};
}

/// A wave less that of a homogeneous body with Poisson's ratio of the layer, times its weight.
struct StressWave
{
  double k;
  green::WaveStress along, across; ///< by a pressure or a shear along the wavevector, and by a shear across
};

green::WaveStress difference(const green::WaveStress& a, const green::WaveStress& b, double factor)
{
  return {factor * (a.ll - b.ll), factor * (a.tt - b.tt), factor * (a.zz - b.zz),
          factor * (a.lz - b.lz), factor * (a.lt - b.lt), factor * (a.tz - b.tz)};
}

std::vector<StressWave> waves_to(double distance, const Coat& coat, Traction traction, std::size_t layer, double from,
                                 double to)
{
  using enum green::WaveLoad;
  const ElasticStack stack = coat.stack(), alone{{}, {1.0, stack.of_layer(layer).poisson_ratio}};
  std::vector<StressWave> waves;
  over_wavenumbers(coat.thickness, coat.longest(), distance,
                   [&](double k, double weight)
                   {
                     const green::StackWave wave(stack, k), other(alone, k);
                     const auto excess = [&](green::WaveLoad load)
                     {
                       return difference(wave.mean_stress(load, wave.field_of(load), layer, from, to),
                                         other.mean_stress(load, other.field_of(load), 0, from, to),
                                         0.5 / pi * weight * k);
                     };
                     waves.push_back({k, excess(traction == Traction::pressure ? pressure : along), excess(across)});
                   });
  return waves;
}

TEST_P(LargestContrast, StressesAreTheLayeredIntegrals)
{
  const ElasticStack stack = coat().stack();
  const double dz = std::min(coat().thickness, 2.0);
  const int above = static_cast<int>(std::lround(coat().thickness / dz)) - 1;
  const VolumeGrid grid{{24, 20, 1.0, 1.0}, above + 3, dz};
  for (const Traction traction : {Traction::pressure, Traction::shear_x})
  {
    const ExcessStress excess(grid, stack, traction);
    for (const int layer : {above, above + 1}) // above and beneath the interface
    {
      const Quadrant<SymTensor> found = excess.of_layer(layer);
      for (const auto& [i, j] : {std::pair{0, 0}, {2, 1}, {11, 5}})
      {
        const std::vector<StressWave> waves = waves_to(std::hypot(i + 0.5, j + 0.5), coat(), traction,
                                                       layer > above ? 1 : 0, layer * dz, (layer + 1) * dz);
        const SymTensor expected = over_cell(i, j,
                                             [&](double x, double y)
                                             {
                                               const double r = std::hypot(x, y);
                                               SymTensor sum{};
                                               for (const StressWave& w : waves)
                                               {
                                                 const SymTensor a =
                                                     around(traction, w.along, w.across, w.k * r, x / r, y / r);
                                                 for (std::size_t c = 0; c < 6; ++c)
                                                   sum[c] += a[c];
                                               }
                                               return sum;
                                             });
        // Of the unit of the traction.
        for (std::size_t c = 0; c < 6; ++c)
          EXPECT_NEAR(found.at(i, j)[c], expected[c], 1e-7)
              << "layer " << layer << " component " << c << " at " << i << ' ' << j;
      }
    }
  }
}

/// With one periodic axis: a sum over the waves along it and an integral over those along the open one.
SurfaceExcess banded(const Coat& coat, const SurfaceGrid& grid, int i, int j, int reference)
{
  const bool along_x = grid.is_periodic_y();
  const double open_cell = along_x ? grid.dx : grid.dy, cell = along_x ? grid.dy : grid.dx;
  const double period = cell * (along_x ? grid.ny : grid.nx);
  const double at = open_cell * (along_x ? i : j), from = open_cell * reference, beside = cell * (along_x ? j : i);
  const auto box = [](double x) { return x == 0.0 ? 1.0 : std::sin(x) / x; };
  SurfaceExcess sum{};
  const int shortest = static_cast<int>(18.0 / coat.thickness * period / (2.0 * pi));
  for (int w = -shortest; w <= shortest; ++w)
    over_wavenumbers(2.0 * coat.thickness, coat.longest(), std::max(at, from),
                     [&](double k, double weight)
                     {
                       const double n = 2.0 * pi * w / period;
                       for (const double m : {k, -k})
                       {
                         const SurfaceExcess wave =
                             along_x ? excess_wave(coat.stack(), m, n) : excess_wave(coat.stack(), n, m);
                         const double size = weight * open_cell * cell / (2.0 * pi * period) *
                                             box(0.5 * m * open_cell) * box(0.5 * n * cell);
                         const double phase = m * at + n * beside, other = m * from;
                         for (std::size_t t = 0; t < excess::count; ++t)
                           sum[t] += size * wave[t] *
                                     (t == excess::x || t == excess::y ? std::sin(other) - std::sin(phase)
                                                                       : std::cos(phase) - std::cos(other));
                       }
                     });
  return sum;
}

TEST_P(LargestContrast, PeriodicRowsAreSumsOfWaves)
{
  for (const SurfaceGrid& grid : {SurfaceGrid{20, 4, 1.0, 1.5, Boundary::open, Boundary::periodic},
                                  SurfaceGrid{4, 16, 1.2, 1.0, Boundary::periodic, Boundary::open}})
  {
    const Quadrant<SurfaceExcess> found = excess_surface(grid, coat().stack(), 30.0);
    const double of_top = 0.5 / coat().stack().top().shear_modulus();
    const double scale =
        of_top + std::abs(found.at(0, 0)[excess::zz] - found.at(found.nx - 1, found.ny - 1)[excess::zz]);
    for (const auto& [i, j] : {std::pair{0, 0}, {1, 2}, {2, 1}}) // differences, since the sum is logarithmic
    {
      const SurfaceExcess expected = banded(coat(), grid, i, j, 5);
      const SurfaceExcess& other = grid.is_periodic_y() ? found.at(5, 0) : found.at(0, 5);
      for (std::size_t t = 0; t < excess::count; ++t)
        EXPECT_NEAR(found.at(i, j)[t] - other[t], expected[t], 1e-6 * scale) << "term " << t << " at " << i << ' ' << j;
    }
  }
}

} // namespace
} // namespace brinell::halfspace::stack_contrast_test
