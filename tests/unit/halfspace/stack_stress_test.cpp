// SPDX-License-Identifier: BSD-3-Clause
// Plastic strain in layered bodies -> residual stress and displacement of the surface.
#include "halfspace/strain/half_space_memory.hpp"
#include "halfspace/strain/stack_stress.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "brinell/green/stack_strain.hpp"
#include "brinell/halfspace/half_space.hpp"
#include "foundation/fft.hpp"
#include "gauss.hpp"
#include "mirrored_grid.hpp"
#include "random_field.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace brinell::halfspace::stack_stress_test
{
namespace
{

using std::numbers::pi;
using test::StressField;
using Complex = std::complex<double>;
constexpr auto open = Boundary::open, periodic = Boundary::periodic;

const ElasticStack hard_on_soft{{{1.0, {4.0, 0.2}}}, {1.0, 0.3}};
const ElasticStack three_layers{{{0.5, {3.0, 0.25}}, {1.0, {0.5, 0.45}}, {0.5, {8.0, 0.1}}}, {2.0, 0.3}};
const ElasticStack on_rigid{{{1.5, {1.0, 0.3}}, {1.5, {2.0, 0.2}}}, {std::numeric_limits<double>::infinity(), 0.0}};

const std::vector<VolumeGrid>& grids()
{
  static const std::vector<VolumeGrid> all{{{9, 7, 0.5, 0.6}, 6, 0.5},
                                           {{9, 7, 0.5, 0.6, open, periodic}, 6, 0.5},
                                           {{8, 10, 0.5, 0.6, periodic, periodic}, 6, 0.5},
                                           {{14, 1, 0.5, 2.0, open, periodic}, 6, 0.5}};
  return all;
}

double largest(const std::vector<double>& values)
{
  double most = 0.0;
  for (const double value : values)
    most = std::max(most, std::abs(value));
  return most;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

/// Displacement of the surface along z, x and y.
std::vector<double> displacement(const HalfSpace& body, const std::vector<double>& strain)
{
  const std::size_t n = body.grid().surface.size();
  std::vector<double> u(3 * n);
  HalfSpace::Work work = body.make_work();
  const auto part = [&](std::size_t f) { return std::span(u).subspan(f * n, n); };
  body.load(strain, body.grid().nz, work, Displacements::all).displacement({part(0), part(1), part(2)});
  return u;
}

/// Layers whose constants differ so little that the body is homogeneous to rounding, but is computed as a stack.
ElasticStack nearly(const Elastic& body)
{
  constexpr double little = 1e-13;
  const auto of = [&](double times) -> Elastic {
    return {body.young_modulus * (1.0 + times * little), body.poisson_ratio};
  };
  return {{{0.5, of(1.0)}, {1.0, of(-1.0)}, {0.5, of(2.0)}}, body};
}

TEST(StackStress, LayersOfOneMaterialAreTheHalfSpace)
{
  const Elastic steel{2.0, 0.3};
  for (const VolumeGrid& grid : grids())
  {
    const HalfSpace layered(grid, nearly(steel)), alone(grid, steel);
    const std::vector<double> strain = test::random_field(Deviator::size * grid.size(), 1);
    const StressField a(layered, {}, strain), b(alone, {}, strain);
    // Without images the operator is exact. Each material has polynomials of its own for the stress of images, of 1e-4 of the strain.
    const double tolerance = grid.surface.is_periodic() ? 1e-10 : 2e-4;
    EXPECT_LT(largest_difference(a.deviator, b.deviator), tolerance * largest(b.deviator)) << grid.surface.nx;
    EXPECT_LT(largest_difference(a.trace, b.trace), tolerance * largest(b.trace)) << grid.surface.nx;
    const std::vector<double> u = displacement(layered, strain), v = displacement(alone, strain);
    EXPECT_LT(largest_difference(u, v), 1e-9 * largest(v)) << grid.surface.nx; // as the stress of shears
  }
}

TEST(StackStress, EqualNeighboursAreOneLayer)
{
  const Elastic a{2.0, 0.3}, b{3.0, 0.2};
  const ElasticStack stack{{{0.5, b}, {0.25, b}, {0.5, a}}, a};
  EXPECT_EQ(stack.merged(), (ElasticStack{{{0.75, b}}, a}));
  EXPECT_TRUE((ElasticStack{{{0.5, a}, {0.2, a}}, a}).merged().is_homogeneous());
}

/// Mean over a layer of cells of the stress of a wave of strain in another one, in the axes x, y, z.
SymTensor mean_stress(const ElasticStack& stack, const VolumeGrid& grid, const green::StackStrain& strain, int target,
                      double lx, double ly, Complex phase)
{
  const std::size_t layer = stack.layer_at((target + 0.5) * grid.dz);
  const test::Gauss rule(10, target * grid.dz, (target + 1) * grid.dz);
  SymTensor mean{};
  for (std::size_t n = 0; n < rule.point.size(); ++n)
  {
    const green::StrainedField s = strain.at(layer, rule.point[n]);
    const std::array<Complex, 6> axes{lx * lx * s.ll + ly * ly * s.tt - 2.0 * lx * ly * s.lt,
                                      ly * ly * s.ll + lx * lx * s.tt + 2.0 * lx * ly * s.lt,
                                      s.zz,
                                      ly * s.lz + lx * s.tz,
                                      lx * s.lz - ly * s.tz,
                                      lx * ly * (s.ll - s.tt) + (lx * lx - ly * ly) * s.lt};
    for (std::size_t c = 0; c < 6; ++c)
      mean[c] += rule.weight[n] / grid.dz * (axes[c] * phase).real();
  }
  return mean;
}

class StackStressWave : public testing::TestWithParam<int>
{
};
INSTANTIATE_TEST_SUITE_P(Strains, StackStressWave, testing::Range(0, Deviator::size),
                         [](const auto& p)
                         { return std::string(test::deviator_names[static_cast<std::size_t>(p.param)]); });

TEST_P(StackStressWave, IsTheWaveOfTheStack)
{
  const VolumeGrid grid{{12, 10, 0.5, 0.6, periodic, periodic}, 6, 0.5};
  const double m = 2.0 * pi * 2.0 / (12 * 0.5), n = -2.0 * pi / (10 * 0.6), k = std::hypot(m, n);
  const double lx = m / k, ly = n / k;
  const SymTensor e = test::as_tensor(test::unit_deviator(GetParam()));
  const green::WaveStrain in_frame{lx * lx * e[0] + ly * ly * e[1] + 2.0 * lx * ly * e[5],
                                   ly * ly * e[0] + lx * lx * e[1] - 2.0 * lx * ly * e[5],
                                   e[2],
                                   lx * e[4] + ly * e[3],
                                   lx * ly * (e[1] - e[0]) + (lx * lx - ly * ly) * e[5],
                                   lx * e[3] - ly * e[4]};
  for (const ElasticStack& stack : {hard_on_soft, three_layers, on_rigid})
    for (const int source : {0, 2, 3, 5})
    {
      const std::vector<double> strain = test::sampled_strain(
          grid, test::unit_deviator(GetParam()),
          [&](double x, double y, double z) { return z == (source + 0.5) * grid.dz ? std::cos(m * x + n * y) : 0.0; });
      const HalfSpace body(grid, stack);
      const StressField found(body, {}, strain);
      const green::StackWave wave(stack, k);
      const green::StackStrain expected(wave, stack.layer_at((source + 0.5) * grid.dz), source * grid.dz,
                                        (source + 1) * grid.dz, in_frame);
      for (int target = 0; target < grid.nz; ++target)
        for (const auto& [i, j] : {std::pair{0, 0}, {3, 4}})
        {
          const Complex phase = std::polar(1.0, m * i * grid.surface.dx + n * j * grid.surface.dy);
          const SymTensor mean = mean_stress(stack, grid, expected, target, lx, ly, phase);
          for (std::size_t c = 0; c < 6; ++c)
            EXPECT_NEAR(found.at(grid.index(i, j, target))[c], mean[c], 1e-12)
                << "from " << source << " to " << target << " component " << c;
        }
      const std::vector<double> u = displacement(body, strain);
      const green::StrainedField surface = expected.at(0, 0.0);
      for (const auto& [i, j] : {std::pair{0, 0}, {3, 4}})
      {
        const Complex phase = std::polar(1.0, m * i * grid.surface.dx + n * j * grid.surface.dy);
        const std::size_t cell = grid.surface.index(i, j), cells = grid.surface.size();
        EXPECT_NEAR(u[cell], (phase * surface.u_z).real(), 1e-12);
        EXPECT_NEAR(u[cells + cell], (phase * (lx * surface.u_l - ly * surface.u_t)).real(), 1e-12);
        EXPECT_NEAR(u[2 * cells + cell], (phase * (ly * surface.u_l + lx * surface.u_t)).real(), 1e-12);
      }
    }
}

TEST(StackStress, StrainsAreReciprocalAndLockInEnergy)
{
  for (const VolumeGrid& grid : grids())
    for (const ElasticStack& stack : {three_layers, on_rigid})
    {
      const HalfSpace body(grid, stack);
      const std::vector<double> e = test::random_field(Deviator::size * grid.size(), 2);
      const std::vector<double> f = test::random_field(e.size(), 3);
      const std::vector<double> of_e = StressField(body, {}, e).deviator, of_f = StressField(body, {}, f).deviator;
      const double energy = -test::contracted(e, of_e);
      EXPECT_GT(energy, 0.0);
      EXPECT_NEAR(test::contracted(f, of_e), test::contracted(e, of_f), 1e-12 * energy);
    }
}

TEST(StackStress, DisplacementIsTheAdjointOfTheStressOfALoad)
{
  for (const VolumeGrid& grid : grids())
    for (const ElasticStack& stack : {hard_on_soft})
    {
      const HalfSpace body(grid, stack);
      const std::size_t n = grid.surface.size();
      const std::vector<double> e = test::random_field(Deviator::size * grid.size(), 4);
      const std::vector<double> load = test::random_field(3 * n, 5), u = displacement(body, e);
      const StressField s =
          StressField::of(body, {std::span(load).first(n), std::span(load).subspan(n, n), std::span(load).last(n)});
      double of_load = 0.0;
      for (std::size_t i = 0; i < u.size(); ++i)
        of_load += u[i] * load[i] * grid.surface.cell_area();
      const double of_strain = test::contracted(s.deviator, e) * grid.cell_volume();
      EXPECT_NEAR(of_load, of_strain, 1e-11 * (std::abs(of_load) + std::abs(of_strain)));
    }
}

TEST(StackStress, ImagesOfHardAndSoftCoatingsAreNotFelt)
{
  // A hard coating carries shear over its thickness times the ratio of the moduli, here up to 200 cells: far beyond the images.
  for (const double contrast : {0.01, 100.0})
    for (const double thickness : {0.5, 2.0})
      for (const Boundary along_y : {open, periodic})
      {
        const ElasticStack stack{{{thickness, {contrast, 0.25}}}, {1.0, 0.35}};
        const VolumeGrid small{{12, 10, 0.5, 0.5, open, along_y}, 4, 0.5};
        VolumeGrid wide = small;
        wide.surface.nx = 48;
        wide.surface.ny = along_y == open ? 40 : 10;
        const HalfSpace on_small(small, stack), on_wide(wide, stack);
        for (int component = 0; component < Deviator::size; ++component)
        {
          const auto blob = [&](const VolumeGrid& g) // which ends within the small grid
          {
            return test::sampled_strain(g, test::unit_deviator(component),
                                        [](double x, double y, double z)
                                        {
                                          const double dx = x - 5.5 * 0.5, dy = y - 4.5 * 0.5;
                                          return std::exp(-(dx * dx + dy * dy) / 0.45 - z);
                                        });
          };
          const StressField a(on_small, {}, blob(small)), b(on_wide, {}, blob(wide));
          EXPECT_LT(test::largest_difference(small, a, wide, b, 0), 1e-3 * largest(b.deviator))
              << contrast << ' ' << thickness << ' ' << component;
        }
      }
}

TEST(StackStress, ImagesAreNotFelt)
{
  // A strain that the cells resolve, on a grid and on one that is twice as wide: within 1e-3 of 2 mu max|eps|.
  for (const ElasticStack& stack : {hard_on_soft, three_layers})
    for (const Boundary along_y : {open, periodic})
    {
      const VolumeGrid small{{12, 10, 0.5, 0.5, open, along_y}, 4, 0.5};
      VolumeGrid wide = small;
      wide.surface.nx = 24;
      wide.surface.ny = along_y == open ? 20 : 10;
      double hardest = 0.0;
      for (const ElasticLayer& layer : stack.layers)
        hardest = std::max(hardest, layer.elastic.shear_modulus());
      const HalfSpace on_small(small, stack), on_wide(wide, stack);
      for (int component = 0; component < Deviator::size; ++component)
      {
        const auto blob = [&](const VolumeGrid& g)
        {
          return test::sampled_strain(g, test::unit_deviator(component),
                                      [](double x, double y, double z)
                                      {
                                        const double dx = x - 5.5 * 0.5, dy = y - 4.5 * 0.5;
                                        return std::exp(-(dx * dx + dy * dy) / 1.5) * std::exp(-z);
                                      });
        };
        const StressField a(on_small, {}, blob(small)), b(on_wide, {}, blob(wide));
        const double difference = test::largest_difference(small, a, wide, b, 0) / (2.0 * hardest);
        EXPECT_LT(difference, 1e-3) << component;
        RecordProperty("difference", std::to_string(difference));
      }
    }
}

TEST(StackStress, MirrorImagesAreComputedOnOneSide)
{
  const VolumeGrid grid{{10, 8, 0.5, 0.6}, 6, 0.5};
  const HalfSpace whole(grid, three_layers), half(test::mirrored(grid), three_layers);
  std::vector<double> strain = test::random_field(Deviator::size * grid.size(), 6);
  for (int c = 0; c < Deviator::size; ++c)
    complete_in_y(test::mirrored(grid.surface), is_odd_in_y(c) ? -1.0 : 1.0,
                  strain.data() + static_cast<std::size_t>(c) * grid.size(), grid.size());
  const StressField a(whole, {}, strain), b(half, {}, strain);
  EXPECT_LT(largest_difference(a.deviator, b.deviator), 1e-12 * largest(a.deviator));
  EXPECT_LT(largest_difference(a.trace, b.trace), 1e-12 * largest(a.trace));
}

TEST(StackStress, MemoryIsForetoldAlsoOnRanks)
{
  const VolumeGrid grid{{40, 30, 0.5, 0.6}, 6, 0.5};
  const PaddedLengths padded = padded_lengths(grid.surface);
  const BlockedFft fft(grid.surface, padded.x, padded.y, 1);
  for (const int ranks : {1, 3})
  {
    const StackStress first(grid, three_layers, fft, {}, {0, ranks, fft.blocks()});
    // Three layers and the substrate; a homogeneous body has the kernels of the loads in addition, as all bodies have.
    const double more =
        memory_of_half_space(grid, 0, ranks, 4).operators - memory_of_half_space(grid, 0, ranks).operators;
    EXPECT_DOUBLE_EQ(more, first.bytes()) << ranks;
  }
}

TEST(StackStress, LayersWithoutStrainMayBeLeftOut)
{
  const VolumeGrid grid{{8, 10, 0.5, 0.6, periodic, periodic}, 6, 0.5};
  const HalfSpace body(grid, three_layers);
  std::vector<double> strain = test::random_field(Deviator::size * grid.size(), 7);
  for (std::size_t i = 0; i < strain.size(); ++i)
    strain[i] *= i % grid.size() < 2 * grid.surface.size() ? 1.0 : 0.0;
  std::vector<double> nearly = strain;
  nearly[grid.size() - 1] = 1e-200; // the deepest layer counts as strained
  const StressField a(body, {}, strain), b(body, {}, nearly);
  EXPECT_LT(largest_difference(a.deviator, b.deviator), 1e-13 * largest(a.deviator));
  std::vector<double> some(strain.size());
  HalfSpace::Work work = body.make_work();
  body.load(strain, 3, work).stress({}, some);
  for (std::size_t i = 0; i < some.size(); ++i)
    EXPECT_NEAR(some[i], i % grid.size() < 3 * grid.surface.size() ? a.deviator[i] : 0.0, 1e-13);
}

TEST(StackStress, ShortWavesInThickLayersDoNotOverflow)
{
  // k times the thickness of a layer is up to 4000, and a strain in it is that of a body of its own.
  const VolumeGrid grid{{8, 8, 0.005, 0.005, periodic, periodic}, 6, 1.0};
  const ElasticStack stack{{{2.0, {4.0, 0.2}}, {2.0, {1.0, 0.4}}}, {2.0, 0.3}};
  std::vector<double> strain(Deviator::size * grid.size());
  for (std::size_t cell = 0; cell < grid.surface.size(); ++cell)
    strain[2 * grid.surface.size() + cell] = cell % 2 == 0 ? 1.0 : -1.0; // xx in the third layer
  const StressField found(HalfSpace(grid, stack), {}, strain), alone(HalfSpace(grid, Elastic{1.0, 0.4}), {}, strain);
  for (std::size_t cell = 0; cell < grid.surface.size(); ++cell)
  {
    const std::size_t at = 2 * grid.surface.size() + cell;
    EXPECT_TRUE(std::isfinite(found.deviator[at]));
    // The interface is felt over 1 / k of the thickness.
    EXPECT_NEAR(found.deviator[at], alone.deviator[at], 1e-3);
  }
}

TEST(StackStress, InterfacesWithinCellsAreRefused)
{
  const VolumeGrid grid{{4, 4, 0.5, 0.5}, 6, 0.4};
  EXPECT_FALSE(is_aligned(grid, hard_on_soft));
  EXPECT_TRUE(is_aligned({grid.surface, 6, 0.25}, hard_on_soft));
  EXPECT_TRUE(is_aligned({grid.surface, 2, 0.4}, hard_on_soft)); // the interface is beneath the cells
  const HalfSpace body(grid, hard_on_soft);
  HalfSpace::Work work = body.make_work();
  std::vector<double> strain(Deviator::size * grid.size());
  EXPECT_NO_THROW((void)body.load(strain, grid.nz, work));
  strain.front() = 1e-3;
  EXPECT_THROW((void)body.load(strain, grid.nz, work), InputError);
}

TEST(StackStress, StrainInARigidBaseIsRefused)
{
  const VolumeGrid grid{{4, 4, 0.5, 0.5}, 8, 0.5};
  const HalfSpace body(grid, on_rigid); // the base begins under the sixth layer
  HalfSpace::Work work = body.make_work();
  std::vector<double> strain(Deviator::size * grid.size());
  strain[grid.index(0, 0, 5)] = 1e-3;
  EXPECT_NO_THROW((void)body.load(strain, grid.nz, work));
  strain[grid.index(0, 0, 6)] = 1e-3;
  EXPECT_THROW((void)body.load(strain, grid.nz, work), InputError);
}

} // namespace
} // namespace brinell::halfspace::stack_stress_test
