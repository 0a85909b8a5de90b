// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/increment.hpp"
#include "brinell/foundation/archive.hpp"
#include "device/host_device.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <vector>

/// Increments of bodies on a device, run on the processor, against those of the engine: the same number of evaluations, and the same
/// fields up to rounding.
namespace brinell::device::body_test
{
namespace
{

using namespace brinell::elastoplastic;
using constitutive::Material;

constexpr double alpha_c = 2.214290e-4; // [m], of spheres with a radius of 1 m

Material steel(constitutive::HardeningLaw law)
{
  Material material;
  material.elastic = {.young_modulus = 200e9, .poisson_ratio = 0.32};
  material.hardening = std::move(law);
  return material;
}

Material elastic(double modulus)
{
  Material material;
  material.elastic = {.young_modulus = modulus, .poisson_ratio = 0.3};
  return material;
}

/// A sphere pressed into another one, moved over it and lifted.
struct Press
{
  SurfaceGrid contact{.nx = 24, .ny = 20, .dx = 2.6e-3, .dy = 2.6e-3};
  int layers = 11, spare = 12;
  Material lower = steel(constitutive::LinearHardening{0.9115e9, 4e9}), upper = lower;
  Sliding sliding{};
  Settings settings{};
  Strategy strategy{};
  bool softens = false;
  std::vector<double> interferences{3.0, 6.0, 6.5, 2.0};
  std::array<int, 2> moves{2, 0}; ///< columns of the lower and the upper body per increment
  double load = 0.0;              ///< the drive is a load if it is not 0 [N]
  double reference = 0.0;         ///< of the displacement with one periodic axis [m]

  Press() { settings.windows = false; } // a device has none
  [[nodiscard]] VolumeGrid volume() const
  {
    VolumeGrid grid{contact, layers, 2.6e-3};
    if (!contact.is_periodic_x())
      grid.surface.nx += spare;
    return grid;
  }
  [[nodiscard]] std::unique_ptr<CoupledContact> pair(const std::shared_ptr<const Device>& device) const
  {
    return std::make_unique<CoupledContact>(contact, volume(), volume(), lower, upper, Scales{alpha_c, 6.0 * alpha_c},
                                            settings, Twin::none, Textures{}, reference, sliding, nullptr, device);
  }
  [[nodiscard]] std::vector<double> distance(double interference) const
  {
    std::vector<double> field(contact.size());
    for (int j = 0; j < contact.ny; ++j)
      for (int i = 0; i < contact.nx; ++i)
        field[contact.index(i, j)] = std::pow(contact.x(i), 2) + std::pow(contact.y(j), 2) - interference * alpha_c;
    return field;
  }
  [[nodiscard]] IncrementReport advance(CoupledContact& pair, int step) const
  {
    const int middle = contact.is_periodic_x() ? 0 : spare / 4;
    const Placement placement{{middle + moves[0] * step}, {middle + moves[1] * step}};
    Motion motion;
    motion.slides = sliding.friction.coefficient > 0.0 && step > 0;
    motion.slid = 1e-4 * step;
    motion.duration = 1e-3;
    if (softens)
    {
      std::vector<double> factor(volume().size());
      for (std::size_t cell = 0; cell < factor.size(); ++cell)
        factor[cell] = 0.7 + 0.3 * static_cast<double>(cell % 17) / 17.0;
      pair.set_softening(factor, {});
    }
    const double interference = interferences[static_cast<std::size_t>(step)];
    contact::Drive drive;
    if (load > 0.0)
      drive = {contact::Drive::Kind::load, load * interference};
    return pair.advance(distance(load > 0.0 ? 0.0 : interference), drive, placement, strategy, motion);
  }
};

double largest(const std::vector<double>& values)
{
  double most = 0.0;
  for (const double value : values)
    most = std::max(most, std::abs(value));
  return most;
}

/// Of the largest value; evaluations pass rounding on, of stresses of the whole body to plastic strains of single cells.
constexpr double tolerance = 1e-12;

void expect_same(const std::vector<double>& here, const std::vector<double>& there, const char* what)
{
  ASSERT_EQ(here.size(), there.size()) << what;
  double error = 0.0;
  for (std::size_t n = 0; n < here.size(); ++n)
    error = std::max(error, std::abs(here[n] - there[n]));
  EXPECT_LE(error, tolerance * largest(there)) << what;
}

void expect_same_body(const Body& here, const Body& there)
{
  EXPECT_EQ(here.active_of_all(), there.active_of_all());
  expect_same(here.state().plastic_strain, there.state().plastic_strain, "plastic strain");
  expect_same(here.state().equivalent, there.state().equivalent, "equivalent plastic strain");
  expect_same(here.state().backstress, there.state().backstress, "back stress");
  expect_same(here.state().stress, there.state().stress, "stress");
  expect_same(here.state().residual_displacement, there.state().residual_displacement, "displacement");
  expect_same(here.state().residual_displacement_x, there.state().residual_displacement_x, "displacement along x");
  EXPECT_NEAR(here.state().dissipation, there.state().dissipation, tolerance * there.state().dissipation);
}

void expect_like_the_engine(const Press& press)
{
  const auto on_device = press.pair(host_device()), engine = press.pair(nullptr);
  EXPECT_TRUE(on_device->lower().solved().is_on_device());
  EXPECT_FALSE(engine->lower().solved().is_on_device());
  for (std::size_t step = 0; step < press.interferences.size(); ++step)
  {
    SCOPED_TRACE("increment " + std::to_string(step));
    const IncrementReport here = press.advance(*on_device, static_cast<int>(step)),
                          there = press.advance(*engine, static_cast<int>(step));
    ASSERT_TRUE(here.converged && there.converged);
    EXPECT_EQ(here.evaluations, there.evaluations);
    EXPECT_EQ(here.contact_iterations, there.contact_iterations);
    EXPECT_NEAR(here.energy, there.energy, tolerance * std::abs(there.energy));
    expect_same({on_device->pressure().begin(), on_device->pressure().end()},
                {engine->pressure().begin(), engine->pressure().end()}, "pressure");
    expect_same_body(on_device->lower().solved(), engine->lower().solved());
    expect_same_body(on_device->upper().solved(), engine->upper().solved());
  }
  EXPECT_GT(largest(engine->lower().solved().state().equivalent), 1e-4); // it has flowed
}

TEST(BodyOnDevice, TwoBodiesLikeTheEngine)
{
  Press press;
  press.upper = steel(constitutive::SwiftHardening{1.6e9, 0.004, 0.1});
  expect_like_the_engine(press);
}

TEST(BodyOnDevice, BesideABodyThatStaysElastic)
{
  Press press;
  press.upper = elastic(400e9);
  press.lower.yield_factor = constitutive::DepthProfile({0.0, 1e-2, 3e-2}, {1.4, 1.1, 1.0});
  press.lower.initial_stress = constitutive::DepthProfile({0.0, 2e-2}, {-2e8, 0.0});
  expect_like_the_engine(press);
}

TEST(BodyOnDevice, Periodic)
{
  Press press;
  press.contact.boundary_x = press.contact.boundary_y = Boundary::periodic;
  press.lower.kinematic = {{3e9, 40.0}, {1e9, 0.0}};
  press.load = 8e5;
  press.moves = {0, 0}; // and lifted at the same place
  expect_like_the_engine(press);
}

TEST(BodyOnDevice, PlaneAndLong)
{
  Press press;
  press.contact = {.nx = 48, .ny = 1, .dx = 2.6e-3, .dy = 1.0, .boundary_y = Boundary::periodic};
  press.reference = 0.1;
  press.load = 1e7;
  expect_like_the_engine(press);
  press.contact = {.nx = 30, .ny = 8, .dx = 2.6e-3, .dy = 2.6e-3, .boundary_y = Boundary::periodic};
  press.load = 6e5;
  expect_like_the_engine(press);
}

TEST(BodyOnDevice, MirrorImages)
{
  for (const int rows : {19, 20})
  {
    Press press;
    press.contact.ny = rows;
    press.contact.is_mirrored_y = true;
    press.lower.kinematic = {{3e9, 40.0}};
    expect_like_the_engine(press);
  }
}

TEST(BodyOnDevice, LawsOfAllKinds)
{
  for (const constitutive::HardeningLaw& law :
       {constitutive::HardeningLaw(constitutive::PerfectPlasticity{0.9e9}),
        constitutive::HardeningLaw(constitutive::LudwikHardening{0.8e9, 0.5e9, 0.5}),
        constitutive::HardeningLaw(constitutive::VoceHardening{0.8e9, 0.2e9, 50.0}),
        constitutive::HardeningLaw(constitutive::TabulatedHardening({0.0, 0.001, 0.02}, {0.7e9, 0.8e9, 1.2e9}))})
  {
    SCOPED_TRACE("law " + std::to_string(law.index()));
    Press press;
    press.lower = steel(law);
    press.softens = true;
    expect_like_the_engine(press);
  }
}

TEST(BodyOnDevice, EveryCellActiveAndPlainIteration)
{
  Press press;
  press.settings.shortcuts = false;
  expect_like_the_engine(press);
  press.strategy.anderson_depth = 0;
  press.strategy.integration = Integration::backward_euler;
  press.strategy.watch_energy = true;
  press.strategy.stiffness_share = 1.0;
  press.strategy.max_evaluations = 400;
  expect_like_the_engine(press);
}

TEST(BodyOnDevice, Heated)
{
  Press press;
  press.sliding.friction.coefficient = 0.2;
  press.moves = {0, 0};
  for (Material* material : {&press.lower, &press.upper})
  {
    material->thermal = Thermal{50.0, 7800.0, 460.0, 12e-6};
    material->softening = constitutive::JohnsonCookSoftening{20.0, 1500.0, 1.0};
  }
  press.sliding.heat = HeatedRun{{}, {1e-3, 1e-2}};
  expect_like_the_engine(press);
}

TEST(BodyOnDevice, ShearOnTheSurface)
{
  Press press;
  press.sliding.friction.coefficient = 0.3;
  press.upper = steel(constitutive::LinearHardening{1.1e9, 2e9});
  expect_like_the_engine(press);
  press.sliding.sticks = true;
  press.moves = {2, 2};
  press.lower.kinematic = {{3e9, 40.0}};
  expect_like_the_engine(press);
}

/// What has failed leaves nothing behind.
TEST(BodyOnDevice, AfterAnIncrementThatFailed)
{
  Press press;
  const auto on_device = press.pair(host_device()), engine = press.pair(nullptr);
  for (int step = 0; step < 3; ++step)
  {
    Press hasty = press;
    hasty.strategy.max_evaluations = 3;
    for (CoupledContact* pair : {on_device.get(), engine.get()})
      EXPECT_FALSE(hasty.advance(*pair, step).converged);
    const int here = press.advance(*on_device, step).evaluations, there = press.advance(*engine, step).evaluations;
    EXPECT_EQ(here, there);
    expect_same_body(on_device->lower().solved(), engine->lower().solved());
  }
}

/// A history is the same file, whoever has computed it, and may go on elsewhere.
TEST(BodyOnDevice, HistoryGoesOnElsewhere)
{
  Press press;
  press.settings.windows = true; // counts windows where there are any
  press.softens = true;
  const auto first = press.pair(nullptr), second = press.pair(host_device()), third = press.pair(nullptr);
  const auto pass_on = [](CoupledContact& from, CoupledContact& to)
  {
    Archive out;
    from.exchange(out);
    Archive in(std::move(out).fields());
    to.exchange(in);
  };
  (void)press.advance(*first, 0);
  pass_on(*first, *second);
  EXPECT_TRUE(press.advance(*second, 1).converged);
  (void)press.advance(*first, 1);
  expect_same_body(second->lower().solved(), first->lower().solved());
  pass_on(*second, *third);
  EXPECT_TRUE(press.advance(*third, 2).converged);
  (void)press.advance(*first, 2);
  expect_same_body(third->lower().solved(), first->lower().solved());
}

std::string refusal(const Press& press)
{
  try
  {
    (void)press.pair(host_device());
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return {};
}

TEST(BodyOnDevice, RefusesWhatItCannotCompute)
{
  EXPECT_EQ(refusal({}), "");
  Press press;
  press.lower.kinematic.assign(5, {1e9, 10.0});
  EXPECT_NE(refusal(press).find("kinematic hardening of 5 terms; allowed on a device: at most 4"), std::string::npos);
  press = {};
  press.upper.layers = {{2.6e-3, {300e9, 0.2}}};
  EXPECT_NE(refusal(press).find("layers"), std::string::npos);
  press.upper.hardening.reset(); // stays elastic, so that it needs no device
  EXPECT_EQ(refusal(press), "");
}

} // namespace
} // namespace brinell::device::body_test
