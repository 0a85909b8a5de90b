// SPDX-License-Identifier: BSD-3-Clause
// Layered bodies that slide with friction: each surface by itself, limits in which they are bodies that are computed in another
// way, admissibility and energy.
#include "admissible.hpp"
#include "brinell/elastoplastic/increment.hpp"
#include "elastoplastic/interface/sheared_surfaces.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace brinell::elastoplastic::coated_sliding_test
{
namespace
{

using constitutive::Material;
using halfspace::SurfaceCompliance;

constexpr int n = 15, nz = 16;
constexpr double cell = 1e-6, dz = 0.5e-6, radius = 50e-6;
const Elastic steel{210e9, 0.3}, diamond{1140e9, 0.07}, rigid{std::numeric_limits<double>::infinity(), 0.0};
const ElasticStack plain{{}, steel}, stiff{{}, diamond}, unyielding{{}, rigid};
const ElasticStack coated{{{1e-6, {400e9, 0.2}}}, steel}, twice{{{2e-6, {80e9, 0.4}}, {1e-6, {400e9, 0.2}}}, steel};

double dot_of(const std::vector<double>& a, const std::vector<double>& b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

double largest(const std::vector<double>& values)
{
  return std::transform_reduce(
      values.begin(), values.end(), 0.0, [](double a, double b) { return std::max(a, b); },
      [](double v) { return std::abs(v); });
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected, double tolerance,
                 const char* what)
{
  ASSERT_EQ(found.size(), expected.size());
  const double scale = largest(expected);
  for (std::size_t i = 0; i < found.size(); ++i)
    ASSERT_NEAR(found[i], expected[i], tolerance * scale) << what << " at " << i;
}

/// Displacements of both surfaces under a pressure and a shear along x.
struct Displaced
{
  std::vector<double> depth, lower_depth, lower, upper;

  Displaced(const ShearedSurfaces& surfaces, const std::vector<double>& pressure, const std::vector<double>& shear)
      : depth(pressure.size()), lower_depth(pressure.size()), lower(pressure.size()), upper(pressure.size())
  {
    surfaces.find_depth(shear, depth);
    surfaces.find_lower_depth(shear, depth, lower_depth);
    surfaces.add_along(pressure, shear, lower, upper);
  }
};

std::vector<std::pair<ElasticStack, ElasticStack>> pairs()
{
  return {{coated, stiff},      {stiff, coated}, {coated, unyielding},
          {unyielding, coated}, {coated, twice}, {twice, twice}};
}

TEST(CoatedSliding, EachSurfaceIsDisplacedLikeTheBodyAlone)
{
  const SurfaceGrid grid{n, n, cell, cell};
  const std::vector<double> pressure = test::random_field(grid.size(), 1), shear = test::random_field(grid.size(), 2);
  for (const auto& [lower, upper] : pairs())
  {
    const Displaced found(ShearedSurfaces(grid, lower, upper, true, 0.0), pressure, shear);
    std::vector<double> z(grid.size()), x(grid.size()), upper_z(grid.size()), upper_x(grid.size());
    SurfaceCompliance(grid, lower, unyielding).apply({.pressure = pressure, .shear_x = shear}, {.x = x});
    SurfaceCompliance(grid, lower, unyielding).apply({.shear_x = shear}, {.z = z});
    SurfaceCompliance(grid, unyielding, upper).apply({.pressure = pressure, .shear_x = shear}, {.x = upper_x});
    SurfaceCompliance(grid, unyielding, upper).apply({.shear_x = shear}, {.z = upper_z});
    for (std::size_t i = 0; i < z.size(); ++i)
    {
      upper_x[i] = -upper_x[i];
      upper_z[i] += z[i];
    }
    expect_near(found.lower, x, 1e-12, "lower along x");
    expect_near(found.upper, upper_x, 1e-12, "upper along x");
    const double scale = largest(x); // the sum of equal bodies vanishes
    for (std::size_t i = 0; i < z.size(); ++i)
    {
      ASSERT_NEAR(found.lower_depth[i], z[i], 1e-12 * scale);
      ASSERT_NEAR(found.depth[i], upper_z[i], 1e-12 * scale);
    }
  }
}

TEST(CoatedSliding, PressureAndShearAreReciprocal)
{
  // The work of the pressure on the gap that the shear opens is that of the shear on the slip by the pressure, with and without
  // coupling and with all boundaries.
  for (const Boundary boundary : {Boundary::open, Boundary::periodic})
  {
    const SurfaceGrid grid{n, n, cell, cell, boundary, boundary};
    const std::vector<double> pressure = test::random_field(grid.size(), 1), shear = test::random_field(grid.size(), 2);
    const std::vector<double> none(grid.size());
    for (const auto& [lower, upper] : pairs())
      for (const bool couples : {true, false})
      {
        const ShearedSurfaces surfaces(grid, lower, upper, couples, 0.0);
        const Displaced by_shear(surfaces, none, shear), by_pressure(surfaces, pressure, none);
        std::vector<double> slip(grid.size());
        for (std::size_t i = 0; i < slip.size(); ++i)
          slip[i] = by_pressure.lower[i] - by_pressure.upper[i];
        const double on_gap = dot_of(pressure, by_shear.depth), on_slip = dot_of(shear, slip);
        const double scale = dot_of(shear, by_shear.lower) - dot_of(shear, by_shear.upper);
        EXPECT_NEAR(on_gap, on_slip, 1e-12 * scale);
        EXPECT_EQ(largest(by_shear.depth) > 0.0, couples && lower != upper);
        // Each body is reciprocal, too: with coupling by itself, without it with the mean of both.
        EXPECT_NEAR(dot_of(pressure, by_shear.lower_depth), dot_of(shear, by_pressure.lower), 1e-12 * scale);
      }
  }
}

TEST(CoatedSliding, AThickLayerIsTheBody)
{
  // The substrate is some grids away: it moves the surface nearly as a whole, by the inverse of its distance.
  const SurfaceGrid grid{n, n, cell, cell};
  const Elastic coat{400e9, 0.2};
  std::vector<double> pressure(grid.size()), shear(grid.size());
  for (int j = 5; j < 10; ++j)
    for (int i = 5; i < 10; ++i)
      shear[grid.index(i, j)] = 0.4 * (pressure[grid.index(i, j)] = 1e9);
  const Displaced body(ShearedSurfaces(grid, {{}, coat}, stiff, true, 0.0), pressure, shear);
  std::array<double, 2> along{}, depth{};
  for (const int grids : {16, 32})
  {
    const ElasticStack thick{{{grids * n * cell, coat}}, steel};
    const Displaced found(ShearedSurfaces(grid, thick, stiff, true, 0.0), pressure, shear);
    const std::size_t at = grids == 16 ? 0 : 1;
    for (std::size_t i = 0; i < grid.size(); ++i)
    {
      along[at] = std::max(along[at], std::abs(found.lower[i] - body.lower[i]));
      depth[at] = std::max(depth[at], std::abs(found.lower_depth[i] - body.lower_depth[i]));
    }
    expect_near(found.upper, body.upper, 1e-12, "upper along x");
  }
  EXPECT_LT(along[1], 0.05 * largest(body.lower));
  EXPECT_NEAR(along[1], 0.5 * along[0], 0.01 * along[0]);
  EXPECT_LT(depth[1], 0.26 * depth[0]); // of a shear, the coupling falls by the square
  EXPECT_LT(depth[1], 1e-2 * largest(body.lower));
}

/// A diamond ball that slides towards +x on a flat with the same cells.
class Slide
{
public:
  explicit Slide(const Material& flat, double friction = 0.3, const Settings& settings = {},
                 Boundary boundary = Boundary::open)
      : grid_{n, n, cell, cell, boundary, boundary}, friction_(friction),
        contact_(grid_, {grid_, nz, dz}, {grid_, nz, dz}, flat, Material{diamond, {}}, Scales{20e-9, 400e-9}, settings,
                 Twin::none, Textures{}, 0.0, {Friction{friction}, 1})
  {
  }

  [[nodiscard]] std::vector<double> rigid_gap(double interference) const
  {
    std::vector<double> gap(grid_.size());
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
      {
        const double x = (i - n / 2) * cell, y = (j - n / 2) * cell;
        gap[grid_.index(i, j)] = (x * x + y * y) / (2.0 * radius) - interference;
      }
    return gap;
  }

  /// @returns whether it converged
  bool press(double interference)
  {
    const double before = load();
    const bool converged =
        contact_.advance(rigid_gap(interference), {}, Placement{{0}, {0}}, Strategy{}, {.slides = true}).converged;
    work_ += 0.5 * (before + load()) * (interference - at_);
    at_ = interference;
    return converged;
  }

  [[nodiscard]] double load() const
  {
    return std::accumulate(contact_.pressure().begin(), contact_.pressure().end(), 0.0) * grid_.cell_area();
  }
  /// Work of the load and of the shear on the bodies.
  [[nodiscard]] double work() const { return work_ + contact_.sliding()->work(); }
  [[nodiscard]] double energy() const
  {
    return contact_.elastic_energy() + flat().dissipation + flat().locked_in_energy;
  }
  [[nodiscard]] const BodyState& flat() const { return contact_.lower().solved().state(); }
  [[nodiscard]] const CoupledContact& contact() const { return contact_; }
  [[nodiscard]] std::vector<double> pressure() const
  {
    return {contact_.pressure().begin(), contact_.pressure().end()};
  }
  [[nodiscard]] std::vector<double> shear() const
  {
    const std::span<const double> shear = contact_.sliding()->shears()[0];
    return {shear.begin(), shear.end()};
  }
  [[nodiscard]] double friction() const { return friction_; }

private:
  SurfaceGrid grid_;
  double friction_;
  CoupledContact contact_;
  double work_ = 0.0, at_ = 0.0;
};

/// Hard on soft, soft on hard, and coats that stay elastic.
std::vector<Material> coated_bodies()
{
  Material hard{steel, constitutive::LinearHardening{1e9, 10e9}},
      soft{steel, constitutive::VoceHardening{2e9, 1e9, 20.0}}, elastic = hard;
  hard.layers = {{1e-6, {450e9, 0.2}, constitutive::HardeningLaw(constitutive::LinearHardening{6e9, 20e9})}};
  soft.layers = {{2e-6, {80e9, 0.35}, constitutive::HardeningLaw(constitutive::SwiftHardening{1e9, 1e-3, 0.2})}};
  elastic.layers = {{1e-6, {450e9, 0.2}, {}}, {0.5e-6, {120e9, 0.3}, {}}};
  return {hard, soft, elastic};
}

Settings tight()
{
  Settings settings;
  settings.yield_tolerance = settings.displacement_tolerance = 1e-9;
  settings.contact_tolerance = 1e-12;
  settings.max_evaluations = 400;
  return settings;
}

TEST(CoatedSliding, LayersOfNearlyTheSubstrateAreTheHomogeneousBody)
{
  // Layers of exactly the substrate's constants are merged with it. Those that differ in the eighth digit are not: they change
  // as much where waves are exact, and without periods by the error of the images of the strain.
  const constitutive::HardeningLaw law = constitutive::LinearHardening{1e9, 10e9};
  Material body{steel, law}, same = body, near = body;
  same.layers = {{1e-6, steel, law}, {2e-6, steel, law}};
  near.layers = {{1e-6, {steel.young_modulus * (1.0 + 1e-8), steel.poisson_ratio}, law},
                 {2e-6, {steel.young_modulus, steel.poisson_ratio - 1e-8}, law}};
  for (const Boundary boundary : {Boundary::open, Boundary::periodic})
  {
    Slide a(body, 0.3, tight(), boundary), b(same, 0.3, tight(), boundary), c(near, 0.3, tight(), boundary);
    for (const double interference : {100e-9, 200e-9, 120e-9})
      for (Slide* slide : {&a, &b, &c})
        ASSERT_TRUE(slide->press(interference));
    EXPECT_GT(largest(a.flat().equivalent), 5e-3);
    for (const auto& [slide, tolerance] : {std::pair{&b, 1e-9}, {&c, boundary == Boundary::open ? 1e-3 : 1e-6}})
    {
      EXPECT_NEAR(slide->load(), a.load(), tolerance * a.load());
      EXPECT_NEAR(slide->contact().sliding()->work(), a.contact().sliding()->work(), tolerance * a.work());
      expect_near(slide->shear(), a.shear(), tolerance, "shear");
      expect_near(slide->flat().equivalent, a.flat().equivalent, tolerance, "strain");
      expect_near(slide->flat().residual_displacement_x, a.flat().residual_displacement_x, tolerance, "displacement");
    }
  }
}

TEST(CoatedSliding, TheGapHasTheShearInIt)
{
  // Pressure and shear of the solution, in an operator of their own: no gap under pressure, none closed elsewhere.
  for (const Elastic& coat : {Elastic{450e9, 0.2}, {80e9, 0.4}})
  {
    Material flat{steel, {}};
    flat.layers = {{1e-6, coat, {}}};
    Slide slide(flat, 0.5, tight()), smooth(flat, 1e-9, tight());
    ASSERT_TRUE(slide.press(200e-9));
    ASSERT_TRUE(smooth.press(200e-9));
    const std::vector<double> pressure = slide.pressure(), shear = slide.shear();
    std::vector<double> gap = slide.rigid_gap(200e-9), u(gap.size());
    const double tolerance = 3.0 * tight().contact_tolerance * 400e-9;
    const SurfaceCompliance compliance(slide.contact().grid(), flat.stack(), stiff);
    compliance.apply({.pressure = pressure}, {.z = u});
    std::vector<double> by_shear(u.size());
    compliance.apply({.shear_x = shear}, {.z = by_shear});
    for (std::size_t i = 0; i < gap.size(); ++i)
    {
      gap[i] += u[i] + by_shear[i];
      EXPECT_NEAR(shear[i], 0.5 * pressure[i], 1e-9 * largest(pressure));
      EXPECT_GE(gap[i], -tolerance);
      EXPECT_TRUE(pressure[i] == 0.0 || std::abs(gap[i]) <= tolerance) << gap[i];
    }
    EXPECT_GT(std::abs(slide.load() / smooth.load() - 1.0), 1e-5);
  }
}

TEST(CoatedSliding, EveryLayerIsAdmissibleByItsOwnLaw)
{
  for (const Material& material : coated_bodies())
  {
    Slide slide(material);
    for (const double interference : {100e-9, 200e-9, 150e-9})
      ASSERT_TRUE(slide.press(interference));
    const BodyState& state = slide.flat();
    EXPECT_GT(largest(state.equivalent), 1e-3);
    const VolumeGrid grid = slide.contact().lower().grid();
    const halfspace::HalfSpace half_space(grid, material.stack());
    const std::vector<double> pressure = slide.pressure(), shear = slide.shear();
    const auto stress =
        test::StressField::of(half_space, {.pressure = pressure, .shear_x = shear}, state.plastic_strain);
    test::expect_admissible(stress, state, material, grid);
  }
}

TEST(CoatedSliding, TheWorkIsDissipatedOrStored)
{
  for (const Material& material : coated_bodies())
  {
    Slide slide(material);
    for (int step = 1; step <= 40; ++step)
      ASSERT_TRUE(slide.press(step * 5e-9));
    const double loaded = slide.work();
    EXPECT_NEAR(slide.energy(), loaded, 5e-3 * loaded);
    EXPECT_GT(slide.contact().sliding()->work(), 0.01 * loaded);
    for (int step = 39; step >= 0; --step)
      ASSERT_TRUE(slide.press(step * 5e-9));
    EXPECT_EQ(slide.load(), 0.0);
    EXPECT_NEAR(slide.energy(), slide.work(), 5e-3 * loaded);
  }
}

} // namespace
} // namespace brinell::elastoplastic::coated_sliding_test
