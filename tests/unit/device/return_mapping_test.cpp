// SPDX-License-Identifier: BSD-3-Clause
#include "device/return_mapping.hpp"

#include "brinell/foundation/deviator.hpp"
#include "constitutive/lane_return.hpp"
#include "device/host_executor.hpp"
#include "random_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <span>
#include <string>
#include <vector>

/// The kernel of the return mapping, run on the processor, against that of the engine: in lanes for laws that are linear, else point
/// by point.
namespace brinell::device::return_mapping_test
{
namespace
{

using namespace brinell::constitutive;

constexpr double mu = 80.0;
constexpr double stiffness = 2.0 * mu;

std::vector<HardeningLaw> laws()
{
  return {PerfectPlasticity{1.0},          LinearHardening{1.0, 5.0},
          LinearHardening{1.0, 10.0 * mu},                                 // stiffer than elastic
          SwiftHardening{2.0, 0.01, 0.2},  LudwikHardening{1.0, 3.0, 0.5}, // infinitely steep for a virgin cell
          VoceHardening{1.0, 0.5, 20.0},   TabulatedHardening({0.0, 0.01, 0.02, 0.1}, {1.0, 1.2, 1.2, 1.5})};
}

/// Cells that were virgin or had flowed, with trials from none at all to a million times the yield stress.
struct Cells
{
  static constexpr std::size_t layers = 4, of_layer = 300, count = layers * of_layer;
  std::vector<double> start = std::vector<double>(Deviator::size * count), trial = start;
  std::vector<double> equivalent = std::vector<double>(count), layer_factor{1.0, 0.7, 1.3, 2.0},
                      softening = test::random_field(count, 9, 0.5, 1.0);

  Cells()
  {
    for (std::size_t cell = 0; cell < count; ++cell)
    {
      const auto seed = static_cast<unsigned>(cell);
      const double sizes[] = {0.0, 0.3, 0.999, 1.001, 1.5, 4.0, 50.0, 1e6};
      equivalent[cell] = cell % 3 == 0 ? 0.0 : cell % 3 == 1 ? 0.013 : 7.0;
      if (cell % 5 != 0)
        store(test::random_deviator(seed + 5000, 0.15 * static_cast<double>(cell % 5)), start, count, cell);
      const double size = sizes[cell % 8];
      if (size > 0.0)
        store(test::random_deviator(seed, size), trial, count, cell);
    }
  }
};

/// Of two terms, one of which is linear.
const std::vector<KinematicTerm> terms{{20.0, 50.0}, {3.0, 0.0}};

struct Flow
{
  std::vector<double> strain = std::vector<double>(Deviator::size * Cells::count),
                      increment = std::vector<double>(Cells::count), dissipation = increment;
  std::vector<double> backstress = test::random_field(2 * Deviator::size * Cells::count, 11, -0.1, 0.1);
};

Flow of_device(const HardeningLaw& law, Integration integration, const Cells& cells, bool has_factors,
               std::span<const KinematicTerm> kinematic = {})
{
  const HostExecutor host;
  const ReturnMapping<HostExecutor> mapping(law, integration, host, kinematic);
  Flow flow;
  mapping.flow({.cells = Cells::count,
                .cells_of_layer = Cells::of_layer,
                .stiffness = stiffness,
                .start = cells.start.data(),
                .trial = cells.trial.data(),
                .equivalent = cells.equivalent.data(),
                .layer_factor = has_factors ? cells.layer_factor.data() : nullptr,
                .softening = has_factors ? cells.softening.data() : nullptr,
                .backstress = flow.backstress.data(),
                .strain = flow.strain.data(),
                .increment = flow.increment.data(),
                .dissipation = flow.dissipation.data()});
  return flow;
}

double factor_of(const Cells& cells, std::size_t cell, bool has_factors)
{
  return has_factors ? cells.layer_factor[cell / Cells::of_layer] * cells.softening[cell] : 1.0;
}

/// As elastoplastic::flow does: several points at once where the law is linear, otherwise one after the other.
template <typename Law>
Flow of_engine(const Law& law, Integration integration, const Cells& cells, bool has_factors)
{
  Flow flow;
  const auto keep = [&](std::size_t cell, const PlasticIncrement& result)
  {
    store(result.strain, flow.strain, Cells::count, cell);
    flow.increment[cell] = result.equivalent;
    flow.dissipation[cell] = result.dissipation;
  };
  const auto scaled = [&](std::size_t cell) { return ScaledLaw<Law>{law, factor_of(cells, cell, has_factors)}; };
  if (is_linear<Law> && integration == Integration::path)
    for (std::size_t first = 0; first < Cells::count; first += lane_count)
    {
      LanePoints points;
      for (std::size_t lane = 0; lane < lane_count && first + lane < Cells::count; ++lane)
        points.set(lane, deviator_at(cells.start, Cells::count, first + lane),
                   deviator_at(cells.trial, Cells::count, first + lane),
                   scaled(first + lane).yield_stress_at(cells.equivalent[first + lane]),
                   scaled(first + lane).modulus_at(cells.equivalent[first + lane]));
      path_return(points, mu);
      for (std::size_t lane = 0; lane < lane_count && first + lane < Cells::count; ++lane)
        keep(first + lane, points.increment(lane));
    }
  else
    for (std::size_t cell = 0; cell < Cells::count; ++cell)
      keep(cell,
           constitutive::flow(scaled(cell), {}, integration, deviator_at(cells.start, Cells::count, cell),
                              deviator_at(cells.trial, Cells::count, cell), cells.equivalent[cell], stiffness, {}));
  return flow;
}

/// Rounding, of strains relative to the elastic strain of the trial and of works to that times its stress: those are what a small
/// increment is a difference of.
constexpr double tolerance = 1e-13;

void expect_same(const Flow& here, const Flow& there, const Cells& cells)
{
  std::size_t flowing = 0;
  for (std::size_t cell = 0; cell < Cells::count; ++cell)
  {
    const double size = std::max(1.0, von_mises(deviator_at(cells.trial, Cells::count, cell)));
    const Deviator apart = deviator_at(here.strain, Cells::count, cell) - deviator_at(there.strain, Cells::count, cell);
    EXPECT_LE(von_mises(apart), tolerance * size / mu) << cell;
    EXPECT_NEAR(here.increment[cell], there.increment[cell], tolerance * size / mu) << cell;
    EXPECT_NEAR(here.dissipation[cell], there.dissipation[cell], tolerance * size * size / mu) << cell;
    EXPECT_EQ(here.increment[cell] > 0.0, there.increment[cell] > 0.0) << cell;
    flowing += here.increment[cell] > 0.0 ? 1U : 0U;
  }
  EXPECT_GT(flowing, Cells::count / 8); // some cells flow, and some do not
  EXPECT_LT(flowing, Cells::count);
}

TEST(DeviceReturnMapping, IsThatOfTheEngineForAllLaws)
{
  const Cells cells;
  for (const HardeningLaw& law : laws())
    for (const Integration integration : {Integration::path, Integration::backward_euler})
      for (const bool has_factors : {false, true})
      {
        SCOPED_TRACE(testing::Message() << "law " << law.index() << ", integration " << static_cast<int>(integration)
                                        << (has_factors ? ", with factors" : ""));
        const Flow engine =
            std::visit([&](const auto& l) { return of_engine(l, integration, cells, has_factors); }, law);
        expect_same(of_device(law, integration, cells, has_factors), engine, cells);
      }
}

TEST(DeviceReturnMapping, IsThatOfTheEngineWithBackStresses)
{
  const Cells cells;
  for (const HardeningLaw& law : laws())
    for (const Integration integration : {Integration::path, Integration::backward_euler})
    {
      const Flow here = of_device(law, integration, cells, false, terms);
      Flow there;
      const auto back_at = [&](std::vector<double>& of, std::size_t term)
      { return std::span(of).subspan(term * Deviator::size * Cells::count, Deviator::size * Cells::count); };
      for (std::size_t cell = 0; cell < Cells::count; ++cell)
      {
        std::array<Deviator, 2> back{deviator_at(back_at(there.backstress, 0), Cells::count, cell),
                                     deviator_at(back_at(there.backstress, 1), Cells::count, cell)};
        const PlasticIncrement result = std::visit(
            [&](const auto& l)
            {
              return constitutive::flow(l, terms, integration, deviator_at(cells.start, Cells::count, cell),
                                        deviator_at(cells.trial, Cells::count, cell), cells.equivalent[cell], stiffness,
                                        back);
            },
            law);
        store(result.strain, there.strain, Cells::count, cell);
        there.increment[cell] = result.equivalent;
        there.dissipation[cell] = result.dissipation;
        for (std::size_t term = 0; term < 2; ++term)
          store(back[term], back_at(there.backstress, term), Cells::count, cell);
      }
      expect_same(here, there, cells);
      for (std::size_t n = 0; n < here.backstress.size(); ++n)
      {
        const double size = std::max(1.0, von_mises(deviator_at(cells.trial, Cells::count, n % Cells::count)));
        EXPECT_NEAR(here.backstress[n], there.backstress[n], tolerance * size);
      }
    }
}

TEST(DeviceReturnMapping, RefusesManyBackStresses)
{
  const HostExecutor host;
  const std::vector<KinematicTerm> many(5, {1.0, 1.0});
  EXPECT_THROW((ReturnMapping<HostExecutor>(PerfectPlasticity{1.0}, Integration::path, host, many)), InputError);
}

TEST(DeviceReturnMapping, KeepsACopyOfATable)
{
  const HostExecutor host;
  const auto mapping_of_a_table_that_is_gone = [&]
  {
    const TabulatedHardening table({0.0, 0.1}, {1.0, 2.0});
    return ReturnMapping<HostExecutor>(table, Integration::path, host);
  };
  const ReturnMapping<HostExecutor> mapping = mapping_of_a_table_that_is_gone();
  const std::vector<double> start(5), trial{3.0, 0.0, 0.0, 0.0, 0.0}, equivalent{0.05};
  std::vector<double> strain(5), increment(1), dissipation(1);
  mapping.flow({.cells = 1,
                .cells_of_layer = 1,
                .stiffness = stiffness,
                .start = start.data(),
                .trial = trial.data(),
                .equivalent = equivalent.data(),
                .strain = strain.data(),
                .increment = increment.data(),
                .dissipation = dissipation.data()});
  // |q| - 3 mu x = 1.5 + 10 x: the path is straight.
  EXPECT_NEAR(increment[0], (3.0 * std::sqrt(3.0) - 1.5) / (3.0 * mu + 10.0), tolerance / mu);
}

TEST(DeviceReturnMapping, RefusesALawOfAUser)
{
  const UserHardening law([](double) { return 1.0; }, [](double) { return 0.0; });
  const HostExecutor host;
  try
  {
    const ReturnMapping<HostExecutor> mapping(law, Integration::path, host);
    FAIL() << "accepted a program of the processor";
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("tabulated"), std::string::npos);
  }
}

} // namespace
} // namespace brinell::device::return_mapping_test
