// SPDX-License-Identifier: BSD-3-Clause
// Fatigue against closed forms, and how it is stored and resumed.
#include "order.hpp"
#include "scenario_runs.hpp"

#include "brinell/green/stack.hpp"
#include "brinell/simulation/sliding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace brinell::verification::fatigue_test
{
namespace
{

using constitutive::Fatigue;
using simulation::FatigueSummary;
using simulation::RollingCase;
using simulation::Shakedown;

constexpr double p0 = 1e9, radius = 10e-3;
const constitutive::Material steel{{210e9, 0.3}, {}};
const constitutive::Material rigid{{std::numeric_limits<double>::infinity(), 0.0}, {}};

/// A rigid roller on a flat, in plane strain.
RollingCase rolling_line(const constitutive::Material& material, double hertz_pressure, double half_widths,
                         double resolution)
{
  RollingCase c;
  c.lower = {simulation::Plane{}, material};
  c.lower.fatigue = Fatigue{};
  c.upper = {simulation::Roller{radius, 1.0}, rigid};
  c.domain.y = {Boundary::periodic, 1.0, 1};
  const double modulus = contact_modulus(material.elastic, rigid.elastic);
  const double half_width = 2.0 * hertz_pressure * radius / modulus; // Johnson (1985), Eq. 4.43 and 4.45
  c.drive = load(0.5 * std::numbers::pi * hertz_pressure * half_width);
  c.distance = half_widths * half_width;
  c.load_steps = 2;
  c.resolution = resolution;
  return c;
}

/// Value and depth of the vertex of the parabola through the largest value of a field in a column and its neighbours.
struct Vertex
{
  double value, depth;
};

Vertex largest_in_depth(const std::vector<double>& values, double dz)
{
  const auto k = std::max_element(values.begin(), values.end()) - values.begin();
  const double left = values.at(k - 1), here = values.at(k), right = values.at(k + 1);
  const double shift = 0.5 * (left - right) / (left - 2.0 * here + right);
  return {here - 0.25 * (left - right) * shift, (static_cast<double>(k) + 0.5 + shift) * dz};
}

/// The orthogonal shear under the middle of the track, at the end of the run.
template <typename Case>
Vertex orthogonal_shear(const Case& scenario)
{
  simulation::Run<Case> run(scenario);
  simulation::finish(run);
  const simulation::StepFields fields = run.fields();
  const VolumeGrid& grid = fields.surfaces.lower.grid;
  const std::vector<double> field = fields.lower.fatigue.at(0)().whole();
  std::vector<double> profile;
  for (int k = 0; k < grid.nz; ++k)
    profile.push_back(field[grid.index(grid.surface.nx / 2, grid.surface.ny / 2, k)]);
  return largest_in_depth(profile, grid.dz);
}

// Johnson (1985), section 4.2: tau_xz reaches 0.25 p0 at a depth of 0.5 b under x = +-0.87 b.
TEST(FatigueTest, OrthogonalShearOfALineContactConverges)
{
  const double half_width = 2.0 * p0 * radius / contact_modulus(steel.elastic, rigid.elastic);
  std::vector<double> errors;
  for (const double resolution : {4.0, 8.0, 16.0})
  {
    const Vertex found = orthogonal_shear(rolling_line(steel, p0, 8.0, resolution));
    errors.push_back(std::abs(found.value / (0.25 * p0) - 1.0));
    if (resolution == 16.0)
    {
      EXPECT_NEAR(found.value, 0.25 * p0, 0.005 * 0.25 * p0);
      EXPECT_NEAR(found.depth, 0.5 * half_width, 0.02 * 0.5 * half_width);
    }
    RecordProperty("error_of_" + std::to_string(static_cast<int>(resolution)), std::to_string(errors.back()));
  }
  EXPECT_LT(errors[1], 0.5 * errors[0]);
  EXPECT_LT(errors[2], 0.5 * errors[1]);
}

// Of a round contact, nu = 0.3: 0.21389 p0 at a depth of 0.35086 a under the line of the centre, 0.848 a in front of and behind it.
TEST(FatigueTest, OrthogonalShearOfAPointContact)
{
  const auto rolling_ball = [](double resolution)
  {
    RollingCase c = ball_on_flat(steel, p0, 0.0);
    const double a = 0.5 * std::numbers::pi * p0 * radius / contact_modulus(steel.elastic, steel.elastic);
    c.lower.fatigue = Fatigue{};
    c.distance = 6.0 * a;
    c.load_steps = 1;
    c.resolution = resolution;
    return std::pair{c, a};
  };
  std::vector<double> errors;
  for (const double resolution : {4.0, 8.0, 12.0})
  {
    const auto [c, a] = rolling_ball(resolution);
    const Vertex found = orthogonal_shear(c);
    errors.push_back(std::abs(found.value / (0.21389 * p0) - 1.0));
    if (resolution == 12.0)
    {
      EXPECT_NEAR(found.value, 0.21389 * p0, 0.005 * 0.21389 * p0);
      EXPECT_NEAR(found.depth, 0.35086 * a, 0.03 * 0.35086 * a);
    }
    RecordProperty("error_of_" + std::to_string(static_cast<int>(resolution)), std::to_string(errors.back()));
  }
  EXPECT_LT(errors[1], 0.5 * errors[0]);
}

FatigueSummary after_passes(double p0_over_k, int passes)
{
  constexpr double k = 300e6;
  const constitutive::Material perfect{{210e9, 0.3}, constitutive::PerfectPlasticity{k * std::numbers::sqrt3}};
  RollingCase c = rolling_line(perfect, p0_over_k * k, 8.0, 6.0);
  c.passes = passes;
  return *simulation::run(c).fatigue[0];
}

// Johnson (1962): a line contact that rolls without friction first yields at p0 = 3.1 k (of von Mises), and shakes down up to
// p0 = 4 k, for which the orthogonal shear is k.
TEST(FatigueTest, ShakedownLimitOfALineContact)
{
  EXPECT_EQ(after_passes(2.9, 1).worst(), Shakedown::elastic);
  EXPECT_EQ(after_passes(3.6, 6).worst(), Shakedown::elastic_shakedown);
  const FatigueSummary beyond = after_passes(4.5, 6);
  EXPECT_EQ(beyond.worst(), Shakedown::ratchetting);
  EXPECT_GT(beyond.ratchetting, 20.0 * after_passes(3.6, 6).plastic_strain);
}

// The shoulder of a dent is worst, nearer to the surface than the worst layer under the smooth track.
TEST(FatigueTest, ADentIsWorstAtItsShoulder)
{
  constexpr double edge = 70e-6;
  RollingCase c = ball_on_flat(steel, 1.4e9, 0.7e-3);
  c.lower.fatigue = Fatigue{.criterion = Fatigue::Criterion::dang_van, .torsion_limit = 400e6, .bending_limit = 600e6};
  c.load_steps = 2;
  c.resolution = 10.0;
  const FatigueSummary smooth = *simulation::run(c).fatigue[0];
  EXPECT_NEAR(smooth.life, 1.0, 0.02);
  c.lower.texture = simulation::Texture{simulation::Dent{.depth = 3e-6, .edge_radius = edge}};
  const FatigueSummary dented = *simulation::run(c).fatigue[0];
  const double off = std::hypot(dented.utilisation->x, dented.utilisation->y);
  EXPECT_GT(off, 0.7 * edge);
  EXPECT_LT(off, 1.7 * edge);
  EXPECT_LT(dented.utilisation->depth, 0.6 * smooth.utilisation->depth);
  EXPECT_GT(dented.utilisation->value, 1.05 * smooth.utilisation->value);
}

/// A dented flat that stays elastic, judged by Findley's criterion.
RollingCase dented_flat(bool whole_map)
{
  RollingCase c = ball_on_flat(steel, 1.4e9, 0.5e-3);
  c.lower.fatigue = Fatigue{
      .criterion = Fatigue::Criterion::findley, .torsion_limit = 400e6, .bending_limit = 600e6, .whole_map = whole_map};
  c.lower.texture = simulation::Texture{simulation::Dent{.depth = 3e-6, .edge_radius = 70e-6}};
  c.load_steps = 1;
  c.resolution = 5.0;
  return c;
}

TEST(FatigueTest, TheMapOfTheWorstCellsIsAPartOfTheWholeMap)
{
  const auto map_of = [](bool whole)
  {
    simulation::Run<RollingCase> run(dented_flat(whole));
    simulation::finish(run);
    return std::pair{run.fields().lower.fatigue.at(7)().whole(), *run.totals().fatigue[0]};
  };
  const auto [whole, of_whole] = map_of(true);
  const auto [part, of_part] = map_of(false);
  EXPECT_EQ(of_whole.judged_share, 1.0);
  EXPECT_LT(of_part.judged_share, 0.5);
  EXPECT_GT(of_part.judged_share, 0.0);
  EXPECT_EQ(of_part.utilisation->value, of_whole.utilisation->value);
  EXPECT_EQ(of_part.utilisation->x, of_whole.utilisation->x);
  EXPECT_EQ(of_part.utilisation->depth, of_whole.utilisation->depth);
  ASSERT_EQ(part.size(), whole.size());
  const VolumeGrid grid = simulation::plan(dented_flat(true)).lower;
  int left_out = 0;
  for (std::size_t n = 0; n < whole.size(); ++n)
  {
    EXPECT_FALSE(std::isnan(whole[n]));
    if (!std::isnan(part[n]))
    {
      EXPECT_EQ(part[n], whole[n]);
    }
    // What is left out of the columns that are judged is not among the worst.
    const double x = grid.surface.x(static_cast<int>(n % static_cast<std::size_t>(grid.surface.nx)));
    if (std::isnan(part[n]) && x > of_part.first_column - 1e-9 && x < of_part.last_column + 1e-9)
    {
      EXPECT_LT(whole[n], simulation::fatigue_map_share * of_whole.utilisation->value);
      ++left_out;
    }
  }
  EXPECT_GT(left_out, 0);
}

// A wave of amplitude A that slides over a flat, pressed so that they touch everywhere, has the pressure E' k A/2 cos kx about its mean
// (Westergaard 1939). Each point of the flat then sees the shear xz of amplitude E' k A/2 kz exp(-kz), which is largest at kz = 1.
TEST(FatigueTest, OrthogonalShearUnderASlidingWave)
{
  constexpr double wavelength = 1e-3, amplitude = 1e-6, k = 2.0 * std::numbers::pi / wavelength;
  const double largest = 0.5 * contact_modulus(steel.elastic, steel.elastic) * k * amplitude;
  const auto sliding_wave = [&](int cells)
  {
    simulation::SlidingCase c;
    c.lower = {simulation::Plane{}, steel};
    c.lower.fatigue = Fatigue{};
    c.upper = {simulation::Plane{}, steel};
    c.upper.texture = simulation::Sinusoid{.amplitude = amplitude, .wavelength_x = wavelength};
    c.domain.x = {Boundary::periodic, wavelength, cells};
    c.domain.y = {Boundary::periodic, wavelength, 1};
    c.press = load(1.2 * largest * wavelength * wavelength);
    c.press_steps = 1;
    c.distance = wavelength;
    return c;
  };
  std::vector<double> errors;
  for (const int cells : {8, 16, 32})
  {
    const Vertex found = orthogonal_shear(sliding_wave(cells));
    errors.push_back(std::abs(found.value / (largest / std::numbers::e) - 1.0));
    if (cells == 32)
    {
      EXPECT_NEAR(found.depth, 1.0 / k, 0.03 / k);
    }
  }
  EXPECT_GT(test::Orders("fatigue under a sliding wave, orthogonal shear", errors).last, 1.8);
  EXPECT_LT(errors.back(), 0.005);
  // More steps than are kept: the error is within the bound that is stated.
  const simulation::SlidingCase fine = sliding_wave(64);
  const FatigueSummary all = *simulation::run(fine).fatigue[0];
  EXPECT_GT(all.path_error, 0.0);
  EXPECT_NEAR(orthogonal_shear(fine).value, largest / std::numbers::e,
              (all.path_error + errors.back()) * largest / std::numbers::e);
  EXPECT_FALSE(all.is_short) << "a periodic contact passes all columns";
  EXPECT_NEAR(all.life, 1.0, 0.02);
}

/// The fatigue of a flat with a coat, on which a wave slides that touches it everywhere.
struct UnderACoat
{
  std::vector<double> shear; ///< orthogonal, of each layer of cells [Pa]
  FatigueSummary summary;
  VolumeGrid grid;
};

UnderACoat under_a_coat(const constitutive::Material& flat, double load_per_area, double amplitude, int cells)
{
  constexpr double wavelength = 1e-3;
  simulation::SlidingCase c;
  c.lower = {simulation::Plane{}, flat};
  c.lower.fatigue = Fatigue{
      .criterion = Fatigue::Criterion::findley, .torsion_limit = 400e6, .bending_limit = 600e6, .whole_map = true};
  c.upper = {simulation::Plane{}, steel};
  c.upper.texture = simulation::Sinusoid{.amplitude = amplitude, .wavelength_x = wavelength};
  c.domain.x = {Boundary::periodic, wavelength, cells};
  c.domain.y = {Boundary::periodic, wavelength, 1};
  c.press = load(load_per_area * wavelength * wavelength);
  c.press_steps = 1;
  c.distance = wavelength;
  simulation::Run<simulation::SlidingCase> run(c);
  simulation::finish(run);
  const simulation::StepFields fields = run.fields();
  UnderACoat result{{}, *run.totals().fatigue[0], fields.surfaces.lower.grid};
  const std::vector<double> field = fields.lower.fatigue.at(0)().whole();
  for (int k = 0; k < result.grid.nz; ++k)
    result.shear.push_back(field[result.grid.index(cells / 2, 0, k)]);
  return result;
}

// Beneath coats, which are not judged, the shear is that of the wave in the stack, and that of the homogeneous body beneath a coat of
// its own constants.
TEST(FatigueTest, IsThatOfTheBodyBeneathItsCoats)
{
  constexpr double k = 2.0 * std::numbers::pi / 1e-3, amplitude = 1e-6, thickness = 0.25 / k;
  for (const double modulus : {70e9, 210e9, 600e9})
  {
    SCOPED_TRACE(modulus);
    constitutive::Material coated = steel;
    coated.layers = {{thickness, {modulus, 0.3}, {}, {}}};
    const green::StackWave wave(coated.stack(), k);
    const double pressure =
        amplitude / (wave.compliance().normal + green::StackWave({{}, steel.elastic}, k).compliance().normal);
    const green::StackWave::Field field = wave.field_of(green::WaveLoad::pressure);
    constexpr int cells = 16;
    const UnderACoat found = under_a_coat(coated, 1.5 * pressure, amplitude, cells);
    const VolumeGrid& grid = found.grid;
    const int coat = static_cast<int>(std::lround(thickness / grid.dz));
    ASSERT_NEAR(coat * grid.dz, thickness, 1e-9 * thickness);
    for (int layer = 0; layer < grid.nz; ++layer)
    {
      EXPECT_EQ(std::isnan(found.shear[layer]), layer < coat) << layer;
      if (layer < coat)
        continue;
      const double exact =
          wave.mean_stress(green::WaveLoad::pressure, field, 1, layer * grid.dz, (layer + 1) * grid.dz).lz;
      EXPECT_NEAR(found.shear[layer] / pressure, std::abs(exact), 2e-7) << layer; // of numbers in single precision
    }
    EXPECT_GT(found.summary.orthogonal_shear.depth, thickness);
    EXPECT_FALSE(std::isnan(found.summary.stress_volume));
    if (modulus == steel.elastic.young_modulus)
    {
      const UnderACoat plain = under_a_coat(steel, 1.5 * pressure, amplitude, cells);
      EXPECT_NEAR(found.summary.utilisation->value, plain.summary.utilisation->value,
                  0.02 * plain.summary.utilisation->value);
    }
  }
}

TEST(FatigueTest, NeedsCellsBeneathTheCoats)
{
  RollingCase c = rolling_line(steel, p0, 6.0, 4.0);
  c.lower.material.layers = {{1e-3, {300e9, 0.3}, {}, {}}};
  try
  {
    static_cast<void>(simulation::plan(c));
    FAIL();
  }
  catch (const std::exception& error)
  {
    EXPECT_NE(std::string(error.what()).find("that of the body beneath its layers is computed"), std::string::npos)
        << error.what();
  }
}

TEST(FatigueTest, AShortPassHasNoLife)
{
  RollingCase c = rolling_line(steel, p0, 0.5, 4.0);
  const FatigueSummary brief = *simulation::run(c).fatigue[0];
  EXPECT_TRUE(brief.is_short);
  EXPECT_TRUE(std::isnan(brief.life));
  c = rolling_line(steel, p0, 6.0, 4.0);
  const FatigueSummary whole = *simulation::run(c).fatigue[0];
  EXPECT_FALSE(whole.is_short);
  EXPECT_FALSE(std::isnan(whole.life));
}

// The orthogonal shear is largest at a depth of 0.35 a, the grid ends above.
TEST(FatigueTest, AWorstPointInTheLastLayerIsAtTheEdge)
{
  RollingCase c = ball_on_flat(steel, p0, 0.6e-3);
  c.lower.fatigue = Fatigue{};
  c.load_steps = 1;
  const FatigueSummary deep = *simulation::run(c).fatigue[0];
  EXPECT_FALSE(deep.orthogonal_shear.is_at_edge);
  c.extent = 0.1;
  const FatigueSummary shallow = *simulation::run(c).fatigue[0];
  EXPECT_TRUE(shallow.orthogonal_shear.is_at_edge);
  EXPECT_LT(shallow.orthogonal_shear.depth, deep.orthogonal_shear.depth);
}

RollingCase yielding_line()
{
  constexpr double k = 300e6;
  const constitutive::Material hardening{{210e9, 0.3}, constitutive::LinearHardening{k * std::numbers::sqrt3, 5e9}};
  RollingCase c = rolling_line(hardening, 4.2 * k, 6.0, 5.0);
  c.lower.fatigue =
      Fatigue{.criterion = Fatigue::Criterion::fatemi_socie, .torsion_limit = 400e6, .bending_limit = 600e6};
  c.passes = 2;
  return c;
}

void expect_equal(const simulation::StepFields& one, const simulation::StepFields& other)
{
  ASSERT_EQ(one.lower.fatigue.size(), simulation::fatigue_fields.size());
  ASSERT_EQ(other.lower.fatigue.size(), one.lower.fatigue.size());
  const auto is_same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  for (std::size_t n = 0; n < one.lower.fatigue.size(); ++n)
    EXPECT_TRUE(std::ranges::equal(one.lower.fatigue[n]().whole(), other.lower.fatigue[n]().whole(), is_same))
        << simulation::fatigue_fields[n].name;
}

TEST(FatigueTest, GoesOnFromACheckpointWithTheSameDigits)
{
  const RollingCase c = yielding_line();
  simulation::Run<RollingCase> whole(c), first(c);
  while (!whole.is_done())
    static_cast<void>(whole.step());
  for (int step = 0; step < 3 * first.step_count() / 4; ++step) // within the second pass
    static_cast<void>(first.step());
  const Archive::Fields checkpoint = first.checkpoint();
  simulation::Run<RollingCase> second(c, {}, &checkpoint);
  while (!second.is_done())
    static_cast<void>(second.step());
  expect_equal(whole.fields(), second.fields());
  EXPECT_EQ(whole.totals().fatigue[0]->utilisation->value, second.totals().fatigue[0]->utilisation->value);
}

TEST(FatigueTest, CostsNothingWithoutARequest)
{
  RollingCase c = yielding_line();
  const double with = simulation::memory_of_fatigue(simulation::plan(c), c.lower, c.upper);
  EXPECT_GT(with, 0.0);
  c.lower.fatigue.reset();
  EXPECT_EQ(simulation::memory_of_fatigue(simulation::plan(c), c.lower, c.upper), 0.0);
  simulation::Run<RollingCase> run(c);
  static_cast<void>(run.step());
  EXPECT_FALSE(run.totals().fatigue[0]);
  EXPECT_TRUE(run.fields().lower.fatigue.empty());
}

} // namespace
} // namespace brinell::verification::fatigue_test
