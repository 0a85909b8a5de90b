// SPDX-License-Identifier: BSD-3-Clause
// Increments of layered bodies: limits in which they are bodies that are computed in another way, admissibility and energy.
#include "admissible.hpp"
#include "brinell/elastoplastic/increment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace brinell::elastoplastic::coated_test
{
namespace
{

using constitutive::Material;

constexpr int n = 15, nz = 16;
constexpr double cell = 1e-6, dz = 0.5e-6, radius = 50e-6;
const Elastic steel{210e9, 0.3}, diamond{1140e9, 0.07};

/// A diamond ball on a flat with the same cells.
class Press
{
public:
  explicit Press(const Material& flat, Boundary boundary = Boundary::open)
      : grid_{n, n, cell, cell, boundary, boundary}, contact_(grid_, {grid_, nz, dz}, {grid_, nz, dz}, flat,
                                                              Material{diamond, {}}, Scales{20e-9, 400e-9}, Settings{})
  {
  }

  /// @returns whether it converged
  bool press(double interference)
  {
    std::vector<double> gap(grid_.size());
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
      {
        const double x = (i - n / 2) * cell, y = (j - n / 2) * cell;
        gap[grid_.index(i, j)] = (x * x + y * y) / (2.0 * radius) - interference;
      }
    const double before = load();
    const bool converged = contact_.advance(gap, {}, Placement{{0}, {0}}, Strategy{}).converged;
    work_ += 0.5 * (before + load()) * (interference - at_);
    at_ = interference;
    return converged;
  }

  [[nodiscard]] double load() const
  {
    double sum = 0.0;
    for (const double p : contact_.pressure())
      sum += p;
    return sum * grid_.cell_area();
  }
  [[nodiscard]] double work() const { return work_; }
  [[nodiscard]] double energy() const
  {
    const BodyState& state = flat();
    return contact_.elastic_energy() + state.dissipation + state.locked_in_energy;
  }
  [[nodiscard]] const BodyState& flat() const { return contact_.lower().solved().state(); }
  [[nodiscard]] const CoupledContact& contact() const { return contact_; }

private:
  SurfaceGrid grid_;
  CoupledContact contact_;
  double work_ = 0.0, at_ = 0.0;
};

double largest(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
}

/// Largest difference over the largest value.
double difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double most = 0.0, size = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    most = std::max(most, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(b[i]));
  }
  return most / size;
}

TEST(CoatedIncrement, LayersOfTheSubstrateAreTheHomogeneousBody)
{
  const constitutive::HardeningLaw law = constitutive::LinearHardening{1e9, 10e9};
  Material plain{steel, law}, layered = plain;
  layered.layers = {{1e-6, steel, law}, {2e-6, steel, law}};
  Press a(plain), b(layered);
  for (const double interference : {100e-9, 200e-9, 120e-9})
  {
    ASSERT_TRUE(a.press(interference));
    ASSERT_TRUE(b.press(interference));
  }
  EXPECT_GT(largest(a.flat().equivalent), 5e-3);
  EXPECT_NEAR(b.load(), a.load(), 1e-9 * a.load());
  EXPECT_LT(difference(b.flat().equivalent, a.flat().equivalent), 1e-9);
}

TEST(CoatedIncrement, LawsOfLayersAreAProfileOfTheYieldStress)
{
  // The same elastic constants; perfect plasticity of three strengths, as three laws and as one law with a stepped factor.
  const auto perfect = [](double yield) { return constitutive::HardeningLaw(constitutive::PerfectPlasticity{yield}); };
  Material profile{steel, perfect(1e9)}, layered = profile;
  layered.layers = {{1e-6, steel, perfect(2e9)}, {2e-6, steel, perfect(1.5e9)}};
  profile.yield_factor = constitutive::DepthProfile({0.99e-6, 1.01e-6, 2.99e-6, 3.01e-6}, {2.0, 1.5, 1.5, 1.0});
  Press a(profile), b(layered);
  for (const double interference : {100e-9, 250e-9})
  {
    ASSERT_TRUE(a.press(interference));
    ASSERT_TRUE(b.press(interference));
  }
  EXPECT_GT(largest(a.flat().equivalent), 5e-3);
  EXPECT_NEAR(b.load(), a.load(), 1e-9 * a.load());
  EXPECT_LT(difference(b.flat().equivalent, a.flat().equivalent), 1e-8);
}

TEST(CoatedIncrement, BackStressesAreThoseOfTheSubstrate)
{
  // A coat of the same elastic constants that does not yield, and one body whose uppermost cells are too strong to; pressed, lifted and
  // pressed again, so that the back stresses have turned. Then one that yields without back stresses of its own.
  const constitutive::HardeningLaw perfect = constitutive::PerfectPlasticity{1e9};
  Material strong{steel, perfect, {{40e9, 100.0}, {5e9, 0.0}}}, layered = strong;
  layered.layers = {{1e-6, steel, {}}};
  strong.yield_factor = constitutive::DepthProfile({0.99e-6, 1.01e-6}, {1e3, 1.0});
  Press a(strong), b(layered);
  layered.layers = {{1e-6, steel, constitutive::HardeningLaw(constitutive::LinearHardening{1e9, 10e9})}};
  Press c(layered);
  for (const double interference : {150e-9, 300e-9, 0.0, 250e-9, 320e-9})
  {
    ASSERT_TRUE(a.press(interference));
    ASSERT_TRUE(b.press(interference));
    ASSERT_TRUE(c.press(interference));
  }
  EXPECT_GT(largest(a.flat().equivalent), 5e-3);
  EXPECT_GT(largest(a.flat().backstress), 1e7);
  EXPECT_NEAR(b.load(), a.load(), 1e-9 * a.load());
  EXPECT_LT(difference(b.flat().equivalent, a.flat().equivalent), 1e-8);
  EXPECT_LT(difference(b.flat().backstress, a.flat().backstress), 1e-8);
  const BodyState& state = c.flat();
  const std::size_t cells = state.equivalent.size(), in_coat = 2 * state.equivalent.size() / nz; // of dz = 0.5 um
  ASSERT_EQ(dz, 0.5e-6);
  EXPECT_GT(
      *std::max_element(state.equivalent.begin(), state.equivalent.begin() + static_cast<std::ptrdiff_t>(in_coat)),
      1e-3);
  for (std::size_t field = 0; field < state.backstress.size() / cells; ++field)
    for (std::size_t cell = 0; cell < in_coat; ++cell)
      ASSERT_EQ(state.backstress[field * cells + cell], 0.0);
  EXPECT_GT(largest(state.backstress), 1e7);
}

/// Hard on soft, soft on hard with different kinds of laws, and a coat that stays elastic.
std::vector<Material> coated()
{
  Material hard{steel, constitutive::LinearHardening{1e9, 10e9}},
      soft{steel, constitutive::VoceHardening{2e9, 1e9, 20.0}}, elastic = hard, alone{steel, {}};
  hard.layers = {{1e-6, {450e9, 0.2}, constitutive::HardeningLaw(constitutive::PerfectPlasticity{6e9})}};
  soft.layers = {{2e-6, {80e9, 0.35}, constitutive::HardeningLaw(constitutive::SwiftHardening{1e9, 1e-3, 0.2})}};
  elastic.layers = {{1e-6, {450e9, 0.2}, {}}, {0.5e-6, {120e9, 0.3}, {}}};
  alone.layers = {{1.5e-6, {120e9, 0.3}, constitutive::HardeningLaw(constitutive::LinearHardening{0.5e9, 1e9})}};
  return {hard, soft, elastic, alone};
}

TEST(CoatedIncrement, EveryLayerIsAdmissibleByItsOwnLaw)
{
  // The stress anew, from the committed strain and the pressure.
  for (const Material& material : coated())
    for (const Boundary boundary : {Boundary::open, Boundary::periodic})
    {
      Press press(material, boundary);
      for (const double interference : {100e-9, 200e-9, 150e-9})
        ASSERT_TRUE(press.press(interference));
      const BodyState& state = press.flat();
      EXPECT_GT(largest(state.equivalent), 1e-3);
      const VolumeGrid grid = press.contact().lower().grid();
      const halfspace::HalfSpace half_space(grid, material.stack());
      const std::vector<double> pressure(press.contact().pressure().begin(), press.contact().pressure().end());
      const test::StressField stress(half_space, pressure, state.plastic_strain);
      test::expect_admissible(stress, state, material, grid);
    }
}

TEST(CoatedIncrement, TheWorkIsDissipatedOrStored)
{
  for (const Material& material : coated())
  {
    Press press(material);
    for (int step = 1; step <= 40; ++step)
      ASSERT_TRUE(press.press(step * 5e-9));
    const double loaded = press.work();
    EXPECT_NEAR(press.energy(), loaded, 5e-3 * loaded);
    for (int step = 39; step >= 0; --step)
      ASSERT_TRUE(press.press(step * 5e-9));
    EXPECT_EQ(press.load(), 0.0);
    EXPECT_NEAR(press.energy(), press.work(), 5e-3 * loaded);
    EXPECT_GT(press.work(), 0.01 * loaded);
  }
}

} // namespace
} // namespace brinell::elastoplastic::coated_test
