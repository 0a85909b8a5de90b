// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/increment.hpp"
#include "brinell/foundation/archive.hpp"

#include "ranks_as_threads.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <omp.h>

/// Several ranks that solve a contact together find the digits of one process.
namespace brinell::elastoplastic
{
namespace
{

using Ranks = std::shared_ptr<const Communicator>;

constitutive::Material steel(double yield)
{
  constitutive::Material material;
  material.elastic = {.young_modulus = 200e9, .poisson_ratio = 0.32};
  material.hardening = constitutive::LinearHardening{yield, 4e9};
  return material;
}

constexpr double alpha_c = 2.214290e-4; // [m], of spheres with a radius of 1 m

/// A sphere pressed into another one, moved over it and lifted.
struct Press
{
  SurfaceGrid contact{.nx = 24, .ny = 20, .dx = 2.6e-3, .dy = 2.6e-3};
  int layers = 13;
  constitutive::Material lower = steel(0.9115e9), upper = steel(1.1e9);
  Twin twin = Twin::none;
  Sliding sliding{};
  Settings settings{};
  int moves = 2; ///< columns per increment
  int spare = 24;
  bool softens = false;
  double load = 0.0; ///< the drive is a load if it is not 0 [N]

  [[nodiscard]] VolumeGrid volume() const
  {
    VolumeGrid grid{contact, layers, 2.6e-3};
    grid.surface.nx += spare;
    return grid;
  }
  [[nodiscard]] CoupledContact pair(const Ranks& ranks) const
  {
    return {contact,
            volume(),
            volume(),
            lower,
            twin == Twin::none ? upper : lower,
            Scales{alpha_c, 6.0 * alpha_c},
            settings,
            twin,
            {},
            0.0,
            sliding,
            ranks};
  }
  /// @param interference  in units of alpha_c
  [[nodiscard]] std::vector<double> distance(double interference) const
  {
    std::vector<double> field(contact.size());
    for (int j = 0; j < contact.ny; ++j)
      for (int i = 0; i < contact.nx; ++i)
        field[contact.index(i, j)] = std::pow(contact.x(i), 2) + std::pow(contact.y(j), 2) - interference * alpha_c;
    return field;
  }
};

/// All numbers after some increments.
struct Outcome
{
  Archive::Fields state;
  std::vector<double> stress, trace, energies, largest;
  bool operator==(const Outcome&) const = default;
};

Placement placement_of(const Press& press, int step)
{
  const int middle = press.spare / 2;
  return {{middle + press.moves * step}, {press.twin == Twin::none ? middle : middle + press.moves * step}};
}

void advance(CoupledContact& pair, const Press& press, int step, Outcome& outcome)
{
  const std::array interferences{3.0, 6.0, 6.5, 2.0};
  contact::Drive drive;
  if (press.load > 0.0)
    drive = {contact::Drive::Kind::load, press.load * interferences.at(static_cast<std::size_t>(step)) / 6.5};
  Motion motion;
  motion.slides = press.sliding.friction.coefficient > 0.0 && step > 0;
  motion.slid = 1e-4 * step;
  motion.duration = 1e-3;
  if (press.softens)
  {
    std::vector<double> factor(press.volume().size());
    for (std::size_t cell = 0; cell < factor.size(); ++cell)
      factor[cell] = 0.7 + 0.3 * static_cast<double>(cell % 17) / 17.0;
    pair.set_softening(factor, {});
  }
  const IncrementReport report =
      pair.advance(press.distance(press.load > 0.0 ? 0.0 : interferences.at(static_cast<std::size_t>(step))), drive,
                   placement_of(press, step), {}, motion);
  outcome.energies.insert(outcome.energies.end(),
                          {report.energy, report.approach, report.yield_error, report.converged ? 1.0 : 0.0,
                           static_cast<double>(report.evaluations)});
}

Outcome outcome_of(const Press& press, const Ranks& ranks)
{
  CoupledContact pair = press.pair(ranks);
  Outcome outcome;
  for (int step = 0; step < 4; ++step)
    advance(pair, press, step, outcome);
  Archive archive;
  pair.exchange(archive);
  outcome.state = std::move(archive).fields();
  const CoupledContact::Stress stress = pair.stress(0, placement_of(press, 3).lower);
  const Body& lower = pair.lower().solved();
  for (std::size_t first = 0; first < stress.deviator.size(); first += stress.trace.size())
  {
    const std::vector<double> component =
        lower
            .layered({{stress.deviator.begin() + static_cast<std::ptrdiff_t>(first),
                       stress.deviator.begin() + static_cast<std::ptrdiff_t>(first + stress.trace.size())}})
            .whole();
    outcome.stress.insert(outcome.stress.end(), component.begin(), component.end());
  }
  outcome.trace = lower.layered({stress.trace}).whole();
  for (const Body* body : {&pair.lower().solved(), &pair.upper().solved()})
    for (const double largest : body->largest_of_layers())
      outcome.largest.push_back(largest);
  outcome.largest.push_back(pair.lower().solved().equivalent_at(press.volume().index(20, 12, 4)));
  for (const double value : pair.lower().shear_strength(1.0))
    outcome.largest.push_back(value);
  return outcome;
}

void expect_alike(const Press& press, const std::vector<int>& counts = {2, 3})
{
  const Outcome alone = outcome_of(press, nullptr);
  EXPECT_GT(alone.largest.front(), 0.0);
  for (const int count : counts)
    test::RanksAsThreads::run(count,
                              [&](const Ranks& rank)
                              {
                                omp_set_num_threads(rank->rank() == 0 ? 2 : 1);
                                const Outcome shared = outcome_of(press, rank);
                                EXPECT_EQ(shared.energies, alone.energies);
                                EXPECT_EQ(shared.largest, alone.largest);
                                if (rank->rank() > 0)
                                  return;
                                EXPECT_EQ(shared.stress, alone.stress);
                                EXPECT_EQ(shared.trace, alone.trace);
                                ASSERT_EQ(shared.state.size(), alone.state.size());
                                for (const auto& [name, values] : alone.state)
                                  EXPECT_EQ(shared.state.at(name), values) << name;
                              });
}

TEST(SharedContact, HasTheDigitsOfOneProcess)
{
  expect_alike({});
}

/// Back stresses, an initial stress and a yield stress that depend on depth.
TEST(SharedContact, KinematicAndLayeredHasTheDigitsOfOneProcess)
{
  Press press;
  press.lower.kinematic = {{.modulus = 20e9, .recall = 30.0}};
  press.lower.yield_factor = constitutive::DepthProfile({0.0, 10e-3, 50e-3}, {1.3, 1.0, 0.9});
  press.lower.initial_stress = constitutive::DepthProfile({0.0, 12e-3}, {-2e8, 1e8});
  expect_alike(press, {3});
}

TEST(SharedContact, SoftenedHasTheDigitsOfOneProcess)
{
  Press press;
  press.softens = true;
  expect_alike(press, {2});
}

/// The heat itself is computed by each rank; its stress acts on the layers of all.
TEST(SharedContact, HeatedHasTheDigitsOfOneProcess)
{
  Press press;
  press.sliding.friction.coefficient = 0.2;
  press.moves = 0;
  for (constitutive::Material* material : {&press.lower, &press.upper})
  {
    material->thermal = Thermal{50.0, 7800.0, 460.0, 12e-6};
    material->softening = constitutive::JohnsonCookSoftening{20.0, 1500.0, 1.0};
  }
  press.sliding.heat = HeatedRun{{}, {1e-3, 1e-2}};
  expect_alike(press, {2});
}

/// What three ranks have stored two and one go on with.
TEST(SharedContact, GoesOnWithAnotherNumberOfRanks)
{
  const Press press;
  const auto after = [&](CoupledContact& pair)
  {
    Outcome outcome;
    advance(pair, press, 3, outcome);
    return outcome.energies;
  };
  Archive::Fields stored;
  std::vector<double> expected;
  test::RanksAsThreads::run(3,
                            [&](const Ranks& rank)
                            {
                              CoupledContact pair = press.pair(rank);
                              Outcome outcome;
                              for (int step = 0; step < 3; ++step)
                                advance(pair, press, step, outcome);
                              Archive archive;
                              pair.exchange(archive);
                              const std::vector<double> energies = after(pair);
                              if (rank->rank() > 0)
                                return;
                              stored = std::move(archive).fields();
                              expected = energies;
                            });
  const auto resumed = [&](const Ranks& rank)
  {
    CoupledContact pair = press.pair(rank);
    Archive archive(stored);
    pair.exchange(archive);
    EXPECT_EQ(after(pair), expected);
  };
  test::RanksAsThreads::run(2, resumed);
  resumed(nullptr);
}

/// A body that has outgrown its grid goes on in a larger one.
TEST(SharedContact, GrowsWithTheDigitsOfOneProcess)
{
  const Press press;
  Press larger = press;
  larger.layers += 4;
  larger.spare += 4;
  const auto outcome = [&](const Ranks& rank)
  {
    CoupledContact small = press.pair(rank), large = larger.pair(rank);
    Outcome result;
    advance(small, press, 0, result);
    advance(small, press, 1, result);
    large.continue_from(std::move(small).take_history());
    advance(large, larger, 2, result);
    return result.energies;
  };
  const std::vector<double> alone = outcome(nullptr);
  test::RanksAsThreads::run(3, [&](const Ranks& rank) { EXPECT_EQ(outcome(rank), alone); });
}

TEST(SharedContact, MirroredHasTheDigitsOfOneProcess)
{
  Press press;
  press.contact.is_mirrored_y = true;
  expect_alike(press);
  press.twin = Twin::mirror_image;
  expect_alike(press, {2});
}

TEST(SharedContact, WithFrictionHasTheDigitsOfOneProcess)
{
  Press press;
  press.sliding.friction.coefficient = 0.3;
  expect_alike(press, {3});
  press.sliding.sticks = true;
  press.moves = 0;
  expect_alike(press, {2});
}

TEST(SharedContact, PeriodicHasTheDigitsOfOneProcess)
{
  Press press;
  press.contact.boundary_x = press.contact.boundary_y = Boundary::periodic;
  press.layers = 7;
  press.spare = 0;
  press.moves = 1;
  press.load = 6e6;
  expect_alike(press, {2});
}

} // namespace
} // namespace brinell::elastoplastic
