// SPDX-License-Identifier: BSD-3-Clause
// Dilatation -> residual stress and displacement of the surface: closed forms, symmetry, boundaries.
#include "brinell/halfspace/half_space.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "brinell/green/cuboid.hpp"
#include "brinell/green/stack_strain.hpp"
#include "direct/smooth_strain.hpp"
#include "gauss.hpp"
#include "mirrored_grid.hpp"
#include "order.hpp"
#include "periodic_grids.hpp"
#include "random_field.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <utility>
#include <vector>

namespace brinell::halfspace::dilatation_test
{
namespace
{

const Elastic steel{1.0, 0.3};

/// All fields of a dilatation.
struct Fields
{
  std::vector<double> deviator, trace, z, x, y;

  Fields(const HalfSpace& body, const std::vector<double>& dilatation)
      : deviator(Deviator::size * body.grid().size()), trace(body.grid().size()), z(body.grid().surface.size()),
        x(z.size()), y(z.size())
  {
    HalfSpace::DilatationWork work = body.make_dilatation_work();
    body.add_dilatation(dilatation, body.grid().nz, work, {deviator, trace, {z, x, y}});
  }
  [[nodiscard]] SymTensor at(std::size_t cell) const
  {
    return to_tensor(test::deviator_at(deviator, cell), trace[cell]);
  }
};

template <typename Profile>
std::vector<double> sampled(const VolumeGrid& g, const Profile& profile)
{
  std::vector<double> field(g.size());
  for (int k = 0; k < g.nz; ++k)
    for (int j = 0; j < g.surface.ny; ++j)
      for (int i = 0; i < g.surface.nx; ++i)
        field[g.index(i, j, k)] = profile(i * g.surface.dx, j * g.surface.dy, (k + 0.5) * g.dz);
  return field;
}

// As EigenstrainClosedFormTest: exact for a strain that is constant in each layer and smooth in the plane.
TEST(Dilatation, SmoothBlobUnderAFreeSurfaceMeetsTheSumOfCuboids)
{
  const double dz = 2.5;
  const VolumeGrid grid{{33, 27, 1.0, 1.2}, 7, dz};
  const double sx = 2.5, sy = 3.0;
  const std::array<double, 7> profile{1.0, 0.0, 0.0, -0.7, 0.0, 0.0, 0.0};
  const auto blob = [&](double x, double y)
  {
    const double r2 = std::pow((x - 12.7) / sx, 2) + std::pow((y - 13.2 * 1.2) / sy, 2);
    return r2 < 24.0 ? std::exp(-0.5 * r2) : 0.0;
  };
  const direct::LayeredStrain layered = [&](double x, double y, int layer)
  {
    const double e = profile[static_cast<std::size_t>(layer)] * blob(x, y);
    return SymTensor{e, e, e, 0.0, 0.0, 0.0};
  };
  const Fields found(HalfSpace(grid, steel),
                     sampled(grid, [&](double x, double y, double z)
                             { return profile[static_cast<std::size_t>(z / dz)] * blob(x, y); }));
  struct Point
  {
    int i, j, k, parts;
  };
  const double scale = 2.0 * steel.shear_modulus();
  double worst = 0.0;
  for (const auto& [i, j, k, parts] :
       {Point{13, 13, 0, 5}, Point{15, 11, 3, 3}, Point{16, 14, 6, 3}, Point{31, 25, 0, 3}})
  {
    const SymTensor expected = direct::extrapolated_strain_stress(grid, layered, i, j, k, parts, steel);
    const SymTensor stress = found.at(grid.index(i, j, k));
    for (std::size_t c = 0; c < 6; ++c)
    {
      EXPECT_NEAR(stress[c], expected[c], 1e-4 * scale) << "component " << c << " at " << i << ' ' << j << ' ' << k;
      worst = std::max(worst, std::abs(stress[c] - expected[c]) / scale);
    }
  }
  std::printf("dilatation: largest difference %.2e of 2 mu max|e|, bound 1e-4\n", worst);
}

// Mindlin and Cheng (1950): under a free surface a ball of dilatation lifts the surface by 4 (1 + nu)/3 e a^3 c/R^3 and shifts it by
// 4 (1 + nu)/3 e a^3 r/R^3. A ball f(r) e of any profile does so like its volume, the integral of f. At its centre it has
// Eshelby's stress -4 mu/3 (1 + nu)/(1 - nu) e in all directions, and that of its image.
TEST(Dilatation, BallUnderAFreeSurfaceIsMindlinAndChengs)
{
  const double s = 2.0, depth = 5.0 * s, nu = steel.poisson_ratio;
  const double volume = std::pow(2.0 * std::numbers::pi, 1.5) * s * s * s;
  const double strength = 4.0 * (1.0 + nu) / 3.0 * volume * 3.0 / (4.0 * std::numbers::pi);
  const SymTensor unit{1.0, 1.0, 1.0, 0.0, 0.0, 0.0};
  const SymTensor half = green::cuboid_stress_half_space(0.0, 0.0, depth, depth, 0.1, 0.1, 0.1, unit, steel);
  const SymTensor full = green::cuboid_stress(0.0, 0.0, 0.0, 0.1, 0.1, 0.1, unit, steel);
  std::vector<double> of_surface, of_stress;
  for (const int layers_per_s : {1, 2, 4})
  {
    const double dz = depth / (5 * layers_per_s + 0.5);
    const VolumeGrid grid{{33, 31, 1.2, 1.25}, 10 * layers_per_s + 1, dz};
    const double x0 = 16.0 * grid.surface.dx, y0 = 15.0 * grid.surface.dy;
    const Fields found(HalfSpace(grid, steel),
                       sampled(grid,
                               [&](double x, double y, double z) {
                                 return std::exp(-0.5 *
                                                 (std::pow(x - x0, 2) + std::pow(y - y0, 2) + std::pow(z - depth, 2)) /
                                                 (s * s));
                               }));
    double error = 0.0;
    for (int j = 0; j < grid.surface.ny; ++j)
      for (int i = 0; i < grid.surface.nx; ++i)
      {
        const double x = i * grid.surface.dx - x0, y = j * grid.surface.dy - y0;
        const test::Gauss along_x(3, x - 0.5 * grid.surface.dx, x + 0.5 * grid.surface.dx);
        const test::Gauss along_y(3, y - 0.5 * grid.surface.dy, y + 0.5 * grid.surface.dy);
        std::array<double, 3> mean{}; // the displacement is the mean over a cell
        for (std::size_t a = 0; a < 3; ++a)
          for (std::size_t b = 0; b < 3; ++b)
          {
            const double px = along_x.point[a], py = along_y.point[b];
            const double lift = along_x.weight[a] * along_y.weight[b] / (grid.surface.dx * grid.surface.dy) * strength /
                                std::pow(px * px + py * py + depth * depth, 1.5);
            mean[0] -= lift * depth;
            mean[1] += lift * px;
            mean[2] += lift * py;
          }
        const std::size_t cell = grid.surface.index(i, j);
        error = std::max({error, std::abs(found.z[cell] - mean[0]), std::abs(found.x[cell] - mean[1]),
                          std::abs(found.y[cell] - mean[2])});
      }
    of_surface.push_back(error / (strength / (depth * depth)));
    const SymTensor stress = found.at(grid.index(16, 15, 5 * layers_per_s));
    const double inside = -4.0 / 3.0 * steel.shear_modulus() * (1.0 + nu) / (1.0 - nu);
    double worst = 0.0;
    for (std::size_t c = 0; c < 6; ++c)
      worst = std::max(worst, std::abs(stress[c] - (c < 3 ? inside : 0.0) - volume * 1e3 * (half[c] - full[c])));
    of_stress.push_back(worst / std::abs(inside));
  }
  EXPECT_GT(test::Orders("Mindlin-Cheng, surface", of_surface).last, 1.8);
  EXPECT_LT(of_surface.back(), 1e-3);
  EXPECT_GT(test::Orders("Mindlin-Cheng, centre of the ball", of_stress).last, 1.8);
  EXPECT_LT(of_stress.back(), 5e-3);
}

struct Shape
{
  const char* name;
  VolumeGrid grid;
};

std::vector<Shape> shapes()
{
  return {{"open", {{12, 9, 1.0, 1.2}, 5, 0.9}},
          {"long", {{56, 9, 1.0, 1.2}, 5, 0.9}},
          {"long_in_y", {{9, 56, 1.0, 1.2}, 5, 0.9}},
          {"mirrored", test::mirrored(VolumeGrid{{12, 9, 1.0, 1.2}, 5, 0.9})},
          {"mirrored_even", test::mirrored(VolumeGrid{{12, 10, 1.0, 1.2}, 5, 0.9})},
          {"periodic", {periodic(12, 10, 1.0, 1.2), 5, 0.9}},
          {"periodic_in_y", {periodic_in_y(12, 10, 1.0, 1.2), 5, 0.9}},
          {"plane", {periodic_in_y(14, 1, 1.0, 1.2), 5, 0.9}}};
}

/// A random dilatation with the symmetry of the grid, and a random plastic strain.
std::vector<double> random_dilatation(const VolumeGrid& grid, unsigned seed)
{
  std::vector<double> e = test::random_field(grid.size(), seed);
  if (grid.surface.is_mirrored_y)
    complete_in_y(grid.surface, 1.0, e.data(), e.size());
  return e;
}
std::vector<double> random_strain(const VolumeGrid& grid, unsigned seed)
{
  std::vector<double> strain = test::random_field(Deviator::size * grid.size(), seed);
  if (grid.surface.is_mirrored_y)
    complete_in_y(grid, strain);
  return strain;
}
Fields completed(const VolumeGrid& grid, Fields fields)
{
  if (grid.surface.is_mirrored_y)
  {
    complete_in_y(grid, fields.deviator);
    complete_in_y(grid.surface, 1.0, fields.trace.data(), fields.trace.size());
  }
  return fields;
}

class DilatationOn : public testing::TestWithParam<Shape>
{
};

TEST_P(DilatationOn, OperatorIsSymmetricAndNegative)
{
  const VolumeGrid& grid = GetParam().grid;
  const HalfSpace body(grid, steel);
  const std::vector<double> a = random_dilatation(grid, 1), b = random_dilatation(grid, 2);
  const Fields of_a = completed(grid, Fields(body, a)), of_b = completed(grid, Fields(body, b));
  const double scale = std::sqrt(test::dot(a, of_a.trace) * test::dot(b, of_b.trace));
  EXPECT_LT(test::dot(a, of_a.trace), 0.0);
  EXPECT_NEAR(test::dot(a, of_b.trace), test::dot(b, of_a.trace), 1e-12 * scale);
}

// Betti's theorem between both kinds of strain: the work of the stress of one on the other.
TEST_P(DilatationOn, IsReciprocalWithPlasticStrain)
{
  const VolumeGrid& grid = GetParam().grid;
  const HalfSpace body(grid, steel);
  const std::vector<double> e = random_dilatation(grid, 3), strain = random_strain(grid, 4);
  const Fields of_e = completed(grid, Fields(body, e));
  const test::StressField of_strain(body, {}, strain);
  const double scale = std::sqrt(test::dot(e, e) * test::contracted(of_strain.deviator, of_strain.deviator));
  EXPECT_NEAR(test::contracted(strain, of_e.deviator), test::dot(e, of_strain.trace), 1e-12 * scale);
}

// ... and with a load on the surface: the work of the traction on the displacement is that of its stress on the dilatation.
TEST_P(DilatationOn, IsReciprocalWithTractions)
{
  const VolumeGrid& grid = GetParam().grid;
  const HalfSpace body(grid, steel);
  const std::vector<double> e = random_dilatation(grid, 5);
  const Fields of_e(body, e);
  for (int t = 0; t < 3; ++t)
  {
    std::vector<double> load = test::random_field(grid.surface.size(), 6);
    if (grid.surface.is_mirrored_y)
      complete_in_y(grid.surface, t == 2 ? -1.0 : 1.0, load.data(), load.size());
    SurfaceLoad on_surface;
    (t == 0 ? on_surface.pressure : t == 1 ? on_surface.shear_x : on_surface.shear_y) = load;
    const test::StressField stress = test::StressField::of(body, on_surface);
    const std::vector<double>& u = t == 0 ? of_e.z : t == 1 ? of_e.x : of_e.y;
    const double scale = std::sqrt(test::dot(load, load) * test::dot(e, e)) * grid.cell_volume();
    EXPECT_NEAR(test::dot(load, u) * grid.surface.dx * grid.surface.dy, test::dot(e, stress.trace) * grid.cell_volume(),
                1e-12 * scale)
        << "traction " << t;
  }
}

INSTANTIATE_TEST_SUITE_P(Grids, DilatationOn, testing::ValuesIn(shapes()), [](const auto& p) { return p.param.name; });

// As EigenstrainClosedFormTest.PeriodicImagesAreNotFelt; a long grid removes the images beside it by waves.
TEST(Dilatation, PeriodicImagesAreNotFelt)
{
  for (const VolumeGrid& grid : {VolumeGrid{{24, 18, 1.0, 1.2}, 8, 1.0}, VolumeGrid{{96, 12, 1.0, 1.2}, 8, 1.0}})
  {
    VolumeGrid wide = grid;
    wide.surface.nx *= 3;
    wide.surface.ny *= 4;
    const double x0 = grid.surface.nx / 2.0 - 0.5, y0 = grid.surface.ny * 0.6 - 0.6;
    const double sx = grid.surface.nx / 12.0;
    const auto blob = [&](double x, double y, double z)
    {
      const double u = (x - x0) / sx, v = (y - y0) / 1.8;
      const bool inside = x < grid.surface.nx - 0.5 && y < (grid.surface.ny - 0.5) * 1.2;
      return inside ? std::exp(-0.5 * (u * u + v * v)) * (1.0 - z / 10.0) : 0.0;
    };
    const Fields narrow(HalfSpace(grid, steel), sampled(grid, blob));
    const Fields far(HalfSpace(wide, steel), sampled(wide, blob));
    double worst = 0.0;
    for (int k = 0; k < grid.nz; ++k)
      for (int j = 0; j < grid.surface.ny; ++j)
        for (int i = 0; i < grid.surface.nx; ++i)
          for (std::size_t c = 0; c < 6; ++c)
            worst = std::max(worst, std::abs(narrow.at(grid.index(i, j, k))[c] - far.at(wide.index(i, j, k))[c]));
    worst /= 2.0 * steel.shear_modulus();
    std::printf("dilatation, %d x %d cells: images leave %.2e of 2 mu max|e|\n", grid.surface.nx, grid.surface.ny,
                worst);
    EXPECT_LE(worst, 1e-4);
  }
}

// One wave on a periodic surface, against another derivation of its waves (green/stack_strain), meaned over the layer by quadrature.
TEST(Dilatation, WaveOnAPeriodicSurfaceIsThatOfTheSheets)
{
  const VolumeGrid grid{periodic(16, 12, 1.0, 1.25), 6, 1.3};
  const double m = 2.0 * std::numbers::pi * 2 / 16.0, n = 2.0 * std::numbers::pi / 15.0, k = std::hypot(m, n);
  const int strained = 2;
  const Fields found(HalfSpace(grid, steel),
                     sampled(grid, [&](double x, double y, double z)
                             { return static_cast<int>(z / 1.3) == strained ? std::cos(m * x + n * y) : 0.0; }));
  const green::StackWave wave({{}, steel}, k);
  const green::StackStrain strain(wave, 0, strained * grid.dz, (strained + 1) * grid.dz,
                                  {1.0, 1.0, 1.0, 0.0, 0.0, 0.0});
  const double lx = m / k, ly = n / k;
  for (int layer = 0; layer < grid.nz; ++layer)
  {
    const test::Gauss points(12, layer * grid.dz, (layer + 1) * grid.dz);
    const auto mean = [&](std::complex<double> green::StrainedField::*component)
    {
      std::complex<double> sum{};
      for (std::size_t q = 0; q < points.point.size(); ++q)
        sum += points.weight[q] / grid.dz * (strain.at(0, points.point[q]).*component);
      return sum;
    };
    using S = green::StrainedField;
    const double ll = mean(&S::ll).real(), tt = mean(&S::tt).real(), zz = mean(&S::zz).real(), lz = mean(&S::lz).imag();
    for (const auto& [i, j] : {std::pair{0, 0}, std::pair{3, 5}, std::pair{9, 7}})
    {
      const double phase = m * i + n * j * 1.25, c = std::cos(phase), s = std::sin(phase);
      const SymTensor stress = found.at(grid.index(i, j, layer));
      const SymTensor expected{(lx * lx * ll + ly * ly * tt) * c,
                               (ly * ly * ll + lx * lx * tt) * c,
                               zz * c,
                               -ly * lz * s,
                               -lx * lz * s,
                               lx * ly * (ll - tt) * c};
      for (std::size_t component = 0; component < 6; ++component)
        EXPECT_NEAR(stress[component], expected[component], 1e-9) << layer << ' ' << component;
    }
  }
}

// A dilatation that is uniform along a periodic surface is held in the plane, and lifts the surface by its free growth times
// (1 + nu)/(1 - nu).
TEST(Dilatation, UniformLayerIsHeldInItsPlane)
{
  const VolumeGrid grid{periodic(8, 6, 1.0, 1.0), 4, 0.5};
  const double nu = steel.poisson_ratio, e = 1e-3;
  const Fields found(HalfSpace(grid, steel),
                     sampled(grid, [&](double, double, double z) { return z < 1.0 ? e : 0.0; }));
  const double held = -steel.young_modulus * e / (1.0 - nu);
  for (int k = 0; k < grid.nz; ++k)
  {
    const SymTensor stress = found.at(grid.index(3, 2, k)), expected{k < 2 ? held : 0.0, k < 2 ? held : 0.0, 0.0};
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(stress[c], expected[c], 1e-15);
  }
  EXPECT_NEAR(found.z[11], -(1.0 + nu) / (1.0 - nu) * e * 1.0, 1e-15);
}

TEST(Dilatation, MirrorImagesAreThoseOfTheWholeGrid)
{
  for (const int ny : {9, 10})
  {
    const VolumeGrid whole{{12, ny, 1.0, 1.2}, 5, 0.9}, half = test::mirrored(whole);
    const std::vector<double> e = random_dilatation(half, 7);
    const Fields of_whole(HalfSpace(whole, steel), e), of_half = completed(half, Fields(HalfSpace(half, steel), e));
    for (std::size_t i = 0; i < of_whole.deviator.size(); ++i)
      EXPECT_NEAR(of_half.deviator[i], of_whole.deviator[i], 1e-13);
    for (std::size_t i = 0; i < of_whole.trace.size(); ++i)
      EXPECT_NEAR(of_half.trace[i], of_whole.trace[i], 1e-13);
    for (std::size_t i = 0; i < of_whole.z.size(); ++i)
    {
      EXPECT_NEAR(of_half.z[i], of_whole.z[i], 1e-13);
      EXPECT_NEAR(of_half.x[i], of_whole.x[i], 1e-13);
      EXPECT_NEAR(of_half.y[i], of_whole.y[i], 1e-13);
    }
  }
}

TEST(Dilatation, IsRefusedInLayers)
{
  const VolumeGrid grid{{8, 8, 1.0, 1.0}, 4, 1.0};
  const HalfSpace layered(grid, ElasticStack{{{2.0, {3.0, 0.2}}}, steel});
  EXPECT_THROW((void)layered.make_dilatation_work(), InputError);
}

} // namespace
} // namespace brinell::halfspace::dilatation_test
