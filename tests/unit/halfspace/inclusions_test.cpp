// SPDX-License-Identifier: BSD-3-Clause
// Inclusions of other elastic constants: Eshelby's ellipsoid, a direct solution, reciprocity, limits.
#include "brinell/halfspace/inclusions.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "brinell/green/stack.hpp"
#include "eshelby.hpp"
#include "mirrored_grid.hpp"
#include "order.hpp"
#include "periodic_grids.hpp"
#include "random_field.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

namespace brinell::halfspace::inclusions_test
{
namespace
{

const Elastic body_material{1.0, 0.3};

/// Cells whose centre lies in an ellipsoid; coordinates in cells from the corner of the grid.
std::vector<std::size_t> ellipsoid(const VolumeGrid& g, const std::array<double, 3>& centre,
                                   const std::array<double, 3>& axes)
{
  std::vector<std::size_t> cells;
  for (int k = 0; k < g.nz; ++k)
    for (int j = 0; j < g.surface.ny; ++j)
      for (int i = 0; i < g.surface.nx; ++i)
      {
        const double u = ((i + 0.5) * g.surface.dx - centre[0]) / axes[0];
        const double v = ((j + 0.5) * g.surface.dy - centre[1]) / axes[1];
        const double w = ((k + 0.5) * g.dz - centre[2]) / axes[2];
        if (u * u + v * v + w * w < 1.0)
          cells.push_back(g.index(i, j, k));
      }
  return cells;
}

InclusionField uniform(const Inclusions& inclusions, const SymTensor& stress)
{
  InclusionField field = inclusions.make_field();
  const std::size_t n = field.volumetric.size();
  const Deviator d = to_deviator(stress);
  for (std::size_t i = 0; i < n; ++i)
  {
    store(d, field.deviator, n, i);
    field.volumetric[i] = trace(stress);
  }
  return field;
}

/// The stress in the inclusions, all parts together.
std::vector<SymTensor> total(Inclusions& inclusions, const InclusionField& given, const InclusionField& equivalent)
{
  InclusionField caused = inclusions.make_field();
  inclusions.stress(equivalent, caused);
  const std::size_t n = caused.volumetric.size();
  std::vector<SymTensor> stress(n);
  for (std::size_t i = 0; i < n; ++i)
    stress[i] = to_tensor(brinell::deviator_at(given.deviator, n, i) + brinell::deviator_at(caused.deviator, n, i),
                          given.volumetric[i] + caused.volumetric[i]);
  return stress;
}

std::vector<SymTensor> strains(const InclusionField& strain)
{
  const std::size_t n = strain.volumetric.size();
  std::vector<SymTensor> all(n);
  for (std::size_t i = 0; i < n; ++i)
    all[i] = to_tensor(brinell::deviator_at(strain.deviator, n, i), 3.0 * strain.volumetric[i]);
  return all;
}

SymTensor mean(const std::vector<SymTensor>& values)
{
  SymTensor sum{};
  for (const SymTensor& value : values)
    for (std::size_t c = 0; c < 6; ++c)
      sum[c] += value[c] / static_cast<double>(values.size());
  return sum;
}
SymTensor difference(const SymTensor& a, const SymTensor& b)
{
  SymTensor d{};
  for (std::size_t c = 0; c < 6; ++c)
    d[c] = a[c] - b[c];
  return d;
}
double norm(const SymTensor& a)
{
  double sum = 0.0;
  for (std::size_t c = 0; c < 6; ++c)
    sum += (c < 3 ? 1.0 : 2.0) * a[c] * a[c];
  return std::sqrt(sum);
}

struct Contrast
{
  const char* name;
  Elastic elastic;
};

class EshelbysEllipsoid : public testing::TestWithParam<Contrast>
{
};

// Deep in the body stress and equivalent strain in an ellipsoid are uniform (Eshelby 1957). The mean equivalent strain times the volume is what
// the body around it and the surface notice. Cells whose centres lie in the ellipsoid have steps of up to half a cell: errors of first order, of
// the ratio of half a cell to an axis at most. The stress of single cells at the steps is not that of theory.
TEST_P(EshelbysEllipsoid, HasTheFieldsOfTheory)
{
  const SymTensor remote{1.0, -0.4, 0.3, 0.2, -0.5, 0.6};
  const std::array<double, 3> axes{1.3, 1.0, 0.8};
  const test::InEllipsoid expected = test::in_ellipsoid(axes, body_material, GetParam().elastic, remote);
  std::vector<double> errors;
  for (const int per_axis : {3, 6})
  {
    const double d = 1.0 / per_axis;
    const int across = 4 * per_axis + 1, depth = 6 * per_axis;
    const VolumeGrid grid{{across, across, d, d}, depth + 2 * per_axis, d};
    const double middle = 0.5 * across * d;
    const HalfSpace body(grid, body_material);
    Inclusions inclusions(body, {{GetParam().elastic, ellipsoid(grid, {middle, middle, (depth + 0.5) * d}, axes)}});
    const InclusionField given = uniform(inclusions, remote);
    InclusionField equivalent = inclusions.make_field();
    const Inclusions::Report report = inclusions.solve(given, equivalent, 1e-6);
    const SymTensor strain = mean(strains(equivalent)), stress = mean(total(inclusions, given, equivalent));
    std::printf("%-8s %d cells per axis, %4zu cells: %3d iterations, equivalent strain off by %.2e, stress by %.2e\n",
                GetParam().name, per_axis, inclusions.cells().size(), report.iterations,
                norm(difference(strain, expected.equivalent)) / norm(expected.equivalent),
                norm(difference(stress, expected.stress)) / norm(remote));
    EXPECT_LE(report.residual, 1e-6);
    EXPECT_LE(report.iterations, 120);
    errors.push_back(norm(difference(strain, expected.equivalent)) / norm(expected.equivalent));
    EXPECT_LE(errors.back(), 0.5 * d);
    EXPECT_LE(norm(difference(stress, expected.stress)), 0.5 * d * std::max(norm(remote), norm(expected.stress)));
  }
  EXPECT_LT(errors.back(), errors.front());
}

INSTANTIATE_TEST_SUITE_P(Contrasts, EshelbysEllipsoid,
                         testing::Values(Contrast{"void", {0.0, 0.3}}, Contrast{"tenth", {0.1, 0.25}},
                                         Contrast{"tenfold", {10.0, 0.25}}, Contrast{"rigid", {1e3, 0.3}},
                                         Contrast{"mixed", {0.6, 0.495}}),
                         [](const auto& p) { return std::string(p.param.name); });

// A misfitting ball, for instance one that has cooled more than the body: with its own dilatation e and constants it is under
// -12 mu_0 K_1/(3 K_1 + 4 mu_0) e in all directions (Eshelby 1957).
TEST(InclusionsTest, MisfittingBallIsUnderEshelbysPressure)
{
  const int per_radius = 6, across = 25, depth = 30;
  const double d = 1.0 / per_radius;
  const VolumeGrid grid{{across, across, d, d}, 40, d};
  const Elastic stiff{3.0, 0.2};
  const double e = 1e-3;
  const HalfSpace body(grid, body_material);
  Inclusions inclusions(body,
                        {{stiff, ellipsoid(grid, {12.5 * d, 12.5 * d, (depth + 0.5) * d}, {1.0, 1.0, 1.0}), {{}, e}}});
  EXPECT_TRUE(inclusions.has_own_strain());
  InclusionField given = inclusions.make_field(), equivalent = given;
  inclusions.stress(inclusions.own_strain(), given);
  (void)inclusions.solve(given, equivalent, 1e-8);
  const double k1 = stiff.young_modulus / (3.0 * (1.0 - 2.0 * stiff.poisson_ratio)), mu = body_material.shear_modulus();
  const double expected = -12.0 * mu * k1 / (3.0 * k1 + 4.0 * mu) * e;
  const SymTensor stress = mean(total(inclusions, given, equivalent));
  for (std::size_t c = 0; c < 6; ++c)
    EXPECT_NEAR(stress[c], c < 3 ? expected : 0.0, 0.04 * std::abs(expected)) << c;
}

/// Two inclusions near the surface, close to each other, one soft and one stiff.
std::vector<Inclusion> soft_and_stiff(const VolumeGrid& g)
{
  Inclusion soft{{0.2, 0.1}, {}}, stiff{{5.0, 0.45}, {}};
  for (int k = 0; k < 3; ++k)
    for (const int j : {3, 4, 5})
      for (const int i : {3, 4, 6, 7})
        (i < 5 ? soft : stiff).cells.push_back(g.index(i, j, k));
  return {soft, stiff};
}

InclusionField random_stress(const Inclusions& inclusions, unsigned seed)
{
  InclusionField field = inclusions.make_field();
  field.deviator = test::random_field(field.deviator.size(), seed);
  field.volumetric = test::random_field(field.volumetric.size(), seed + 1);
  return field;
}

// An inclusion that fills the uppermost layers of a periodic surface is a coating: displacement and stress under a wave of pressure are those of the
// waves in bonded layers (green/stack), which know no equivalent strain. Cells halved in all directions: second order.
TEST(InclusionsTest, WholeLayersAreACoating)
{
  const double length = 16.0, thickness = 4.0, k = 2.0 * std::numbers::pi / length;
  for (const Elastic& coating : {Elastic{4.0, 0.2}, Elastic{0.3, 0.4}})
  {
    const ElasticStack stack{{{thickness, coating}}, body_material};
    const green::StackWave wave(stack, k);
    const double mu = body_material.shear_modulus(), nu = body_material.poisson_ratio;
    const double homogeneous = (1.0 - nu) / (mu * k);
    std::vector<double> of_displacement, of_stress;
    for (const int cells : {12, 24, 48})
    {
      const double d = length / cells, dz = thickness * 6.0 / cells;
      const VolumeGrid grid{periodic(cells, 2, d, d), cells / 6, dz};
      const HalfSpace body(grid, body_material);
      std::vector<std::size_t> all(grid.size());
      std::iota(all.begin(), all.end(), std::size_t{0});
      Inclusions inclusions(body, {{coating, all}});
      std::vector<double> pressure(grid.surface.size());
      for (int j = 0; j < 2; ++j)
        for (int i = 0; i < cells; ++i)
          pressure[grid.surface.index(i, j)] = std::cos(k * i * d);
      const test::StressField load(body, pressure, {});
      InclusionField given = inclusions.make_field(), equivalent = given;
      inclusions.gather(load.deviator, load.trace, given);
      (void)inclusions.solve(given, equivalent, 1e-10);
      std::vector<double> u(grid.surface.size());
      inclusions.add(equivalent, 0, {{}, {}, {u, {}, {}}});
      const double expected = wave.compliance().normal - homogeneous;
      of_displacement.push_back(std::abs(u[0] - expected) / std::abs(expected));
      // Layer in the lower half of the coating.
      const int layer = grid.nz / 2;
      const green::WaveStress mean = wave.mean_stress(
          green::WaveLoad::pressure, wave.field_of(green::WaveLoad::pressure), 0, layer * dz, (layer + 1) * dz);
      const SymTensor stress = total(inclusions, given, equivalent)[grid.index(0, 0, layer)];
      of_stress.push_back(
          std::max({std::abs(stress[0] - mean.ll), std::abs(stress[1] - mean.tt), std::abs(stress[2] - mean.zz)}));
    }
    EXPECT_GT(test::Orders("coating of cells, displacement", of_displacement).last, 1.6);
    EXPECT_LT(of_displacement.back(), 0.01);
    EXPECT_GT(test::Orders("coating of cells, stress", of_stress).last, 1.6);
    EXPECT_LT(of_stress.back(), 0.01);
  }
}

// The equations of all cells as a matrix, solved directly for the stress: sigma + H (1/C_1 - 1/C_0) sigma = sigma_0.
TEST(InclusionsTest, TwoInclusionsAreThoseOfADirectSolution)
{
  const VolumeGrid grid{{11, 9, 1.0, 1.1}, 5, 0.8};
  const HalfSpace body(grid, body_material);
  const std::vector<Inclusion> both = soft_and_stiff(grid);
  Inclusions inclusions(body, both);
  const std::size_t n = inclusions.cells().size();
  const auto bulk = [](const Elastic& m) { return m.young_modulus / (3.0 * (1.0 - 2.0 * m.poisson_ratio)); };
  const auto number_of = [&](std::size_t i) -> const Elastic&
  {
    const auto& cells = both[0].cells;
    return std::find(cells.begin(), cells.end(), inclusions.cells()[i]) == cells.end() ? both[1].elastic
                                                                                       : both[0].elastic;
  };
  const auto size = static_cast<Eigen::Index>(6 * n);
  Eigen::MatrixXd matrix(size, size);
  Eigen::VectorXd compliance(size);
  InclusionField unit = inclusions.make_field(), caused = unit;
  const auto value = [&](InclusionField& f, std::size_t i) -> double&
  { return i < 5 * n ? f.deviator[i] : f.volumetric[i - 5 * n]; };
  for (std::size_t i = 0; i < 6 * n; ++i)
  {
    const Elastic& m = number_of(i % n);
    compliance[static_cast<Eigen::Index>(i)] = i < 5 * n ? 0.5 / m.shear_modulus() - 0.5 / body_material.shear_modulus()
                                                         : 1.0 / (9.0 * bulk(m)) - 1.0 / (9.0 * bulk(body_material));
    value(unit, i) = 1.0;
    inclusions.stress(unit, caused);
    value(unit, i) = 0.0;
    for (std::size_t j = 0; j < 6 * n; ++j)
      matrix(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) = value(caused, j);
  }
  InclusionField given = random_stress(inclusions, 1), equivalent = inclusions.make_field();
  Eigen::VectorXd right(size);
  for (std::size_t i = 0; i < 6 * n; ++i)
    right[static_cast<Eigen::Index>(i)] = value(given, i);
  const Eigen::MatrixXd system = Eigen::MatrixXd::Identity(size, size) - matrix * compliance.asDiagonal();
  const Eigen::VectorXd expected = compliance.asDiagonal() * system.partialPivLu().solve(right);
  const Inclusions::Report report = inclusions.solve(given, equivalent, 1e-11);
  for (std::size_t i = 0; i < 6 * n; ++i)
    EXPECT_NEAR(value(equivalent, i), expected[static_cast<Eigen::Index>(i)], 1e-9 * expected.cwiseAbs().maxCoeff());
  // A start at the solution is the end.
  EXPECT_GT(report.iterations, 5);
  EXPECT_EQ(inclusions.solve(given, equivalent, 1e-10).iterations, 0);
}

// Of a body with inclusions, too: the work of one pressure on the displacement by another one is the same the other way round. And what inclusions
// add to the work of a pressure is half of its stress on the equivalent strain.
TEST(InclusionsTest, BodyWithInclusionsIsReciprocal)
{
  for (const VolumeGrid& grid :
       {VolumeGrid{{11, 9, 1.0, 1.1}, 5, 0.8}, VolumeGrid{periodic(12, 10, 1.0, 1.1), 5, 0.8},
        VolumeGrid{periodic_in_y(12, 10, 1.0, 1.1), 5, 0.8}, test::mirrored(VolumeGrid{{11, 9, 1.0, 1.1}, 5, 0.8})})
  {
    const HalfSpace body(grid, body_material);
    Inclusions inclusions(body, soft_and_stiff(grid));
    std::array<std::vector<double>, 2> pressure, displacement;
    for (unsigned i = 0; i < 2; ++i)
    {
      pressure[i] = test::random_field(grid.surface.size(), 3 + i, 0.0, 1.0);
      if (grid.surface.is_mirrored_y)
        complete_in_y(grid.surface, 1.0, pressure[i].data(), pressure[i].size());
      const test::StressField load(body, pressure[i], {});
      InclusionField given = inclusions.make_field(), equivalent = given;
      inclusions.gather(load.deviator, load.trace, given);
      (void)inclusions.solve(given, equivalent, 1e-12);
      displacement[i].resize(grid.surface.size());
      inclusions.add(equivalent, 0, {{}, {}, {displacement[i], {}, {}}});
      const double work = test::dot(pressure[i], displacement[i]) * grid.surface.dx * grid.surface.dy;
      EXPECT_NEAR(work, inclusions.work(given, equivalent), 1e-11 * std::abs(work));
    }
    EXPECT_NEAR(test::dot(pressure[0], displacement[1]), test::dot(pressure[1], displacement[0]),
                1e-10 * std::abs(test::dot(pressure[0], displacement[0])));
  }
}

// The fields that `add` gives are those in the cells, which `stress` gives, up to the mean over a cell; and on a mirrored grid those of the whole.
TEST(InclusionsTest, MirroredGridsGiveTheFieldsOfWholeOnes)
{
  const VolumeGrid whole{{11, 9, 1.0, 1.1}, 5, 0.8}, half = test::mirrored(whole);
  std::array<std::vector<double>, 2> deviator, trace, u;
  for (const VolumeGrid& grid : {whole, half})
  {
    const std::size_t i = grid.surface.is_mirrored_y ? 1 : 0;
    const HalfSpace body(grid, body_material);
    Inclusions inclusions(body, soft_and_stiff(grid));
    const test::StressField load(body, std::vector<double>(grid.surface.size(), 1.0), {});
    InclusionField given = inclusions.make_field(), equivalent = given;
    inclusions.gather(load.deviator, load.trace, given);
    (void)inclusions.solve(given, equivalent, 1e-12);
    deviator[i].resize(Deviator::size * grid.size());
    trace[i].resize(grid.size());
    u[i].resize(grid.surface.size());
    inclusions.add(equivalent, grid.nz, {deviator[i], trace[i], {u[i], {}, {}}});
  }
  complete_in_y(half, deviator[1]);
  complete_in_y(half.surface, 1.0, trace[1].data(), trace[1].size());
  for (std::size_t i = 0; i < deviator[0].size(); ++i)
    EXPECT_NEAR(deviator[1][i], deviator[0][i], 1e-11);
  for (std::size_t i = 0; i < trace[0].size(); ++i)
    EXPECT_NEAR(trace[1][i], trace[0][i], 1e-11);
  for (std::size_t i = 0; i < u[0].size(); ++i)
    EXPECT_NEAR(u[1][i], u[0][i], 1e-11);
}

// An inclusion of the body's own constants is none; a soft one beneath the load lets the surface sink, a stiff one holds it.
TEST(InclusionsTest, SignsAreRight)
{
  const VolumeGrid grid{{11, 9, 1.0, 1.1}, 5, 0.8};
  const HalfSpace body(grid, body_material);
  const test::StressField load(body, std::vector<double>(grid.surface.size(), 1.0), {});
  const auto sinks = [&](const Elastic& elastic)
  {
    Inclusions inclusions(body, {{elastic, ellipsoid(grid, {5.5, 5.0, 2.0}, {2.0, 2.0, 1.5})}});
    InclusionField given = inclusions.make_field(), equivalent = given;
    inclusions.gather(load.deviator, load.trace, given);
    EXPECT_LE(inclusions.solve(given, equivalent, 1e-8).residual, 1e-8);
    std::vector<double> u(grid.surface.size());
    inclusions.add(equivalent, 0, {{}, {}, {u, {}, {}}});
    return u[grid.surface.index(5, 4)];
  };
  EXPECT_EQ(sinks(body_material), 0.0);
  const double by_void = sinks({0.0, 0.3}), by_tenth = sinks({0.1, 0.3});
  EXPECT_GT(by_void, by_tenth);
  EXPECT_GT(by_tenth, 0.0);
  const double by_tenfold = sinks({10.0, 0.3}), by_rigid = sinks({std::numeric_limits<double>::infinity(), 0.3});
  EXPECT_LT(by_tenfold, 0.0);
  EXPECT_LT(by_rigid, by_tenfold);
  EXPECT_NEAR(sinks({1e4, 0.3}), by_rigid, 2e-3 * std::abs(by_rigid));
}

TEST(InclusionsTest, RefusesWhatItCannotHave)
{
  const VolumeGrid grid{{8, 8, 1.0, 1.0}, 4, 1.0};
  const HalfSpace body(grid, body_material);
  EXPECT_THROW(Inclusions(body, {{{-1.0, 0.3}, {5}}}), InputError);
  EXPECT_THROW(Inclusions(body, {{{1.0, 0.5}, {5}}}), InputError);
  EXPECT_THROW(Inclusions(body, {{{2.0, 0.3}, {grid.size()}}}), InputError);
  EXPECT_THROW(Inclusions(body, {{{2.0, 0.3}, {5, 6}}, {{3.0, 0.3}, {6}}}), InputError);
  const HalfSpace mirrored(test::mirrored(grid), body_material);
  EXPECT_THROW(Inclusions(mirrored, {{{2.0, 0.3}, {5}}}), InputError);
  const std::size_t image = mirrored_cell(grid.surface, 5);
  Deviator shear;
  shear[Deviator::xy] = 1e-3;
  EXPECT_NO_THROW(Inclusions(mirrored, {{{2.0, 0.3}, {5}, {shear, 0.0}}, {{2.0, 0.3}, {image}, {-1.0 * shear, 0.0}}}));
  EXPECT_THROW(Inclusions(mirrored, {{{2.0, 0.3}, {5, image}, {shear, 0.0}}}), InputError);
}

} // namespace
} // namespace brinell::halfspace::inclusions_test
