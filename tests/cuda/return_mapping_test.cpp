// SPDX-License-Identifier: BSD-3-Clause
#include "cuda/return_mapping.hpp"

#include "cuda/device.hpp"
#include "random_field.hpp"
#include "visible_device.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace brinell::cuda::return_mapping_test
{
namespace
{

using namespace brinell::constitutive;

constexpr double mu = 80.0;
constexpr double tolerance = 1e-12; // functions of the device round in other last digits

TEST(CudaReturnMapping, IsThatOfTheProcessorForAllLaws)
{
  if (!test::has_device())
    GTEST_SKIP() << "no GPU here";
  open_device();
  const std::vector<HardeningLaw> laws{
      PerfectPlasticity{1.0},         LinearHardening{1.0, 5.0},
      SwiftHardening{2.0, 0.01, 0.2}, LudwikHardening{1.0, 3.0, 0.5},
      VoceHardening{1.0, 0.5, 20.0},  TabulatedHardening({0.0, 0.01, 0.02, 0.1}, {1.0, 1.2, 1.2, 1.5})};
  constexpr std::size_t count = 1000;
  std::vector<double> start(Deviator::size * count), trial(start), strain(start), increment(count), dissipation(count);
  const std::vector<double> equivalent = test::random_field(count, 1, 0.0, 0.2);
  for (std::size_t cell = 0; cell < count; ++cell)
  {
    store(test::random_deviator(static_cast<unsigned>(cell), 0.2 * static_cast<double>(cell % 5)), start, count, cell);
    store(test::random_deviator(static_cast<unsigned>(cell + count), 0.3 * static_cast<double>(cell % 12)), trial,
          count, cell);
  }
  for (const HardeningLaw& law : laws)
    for (const Integration integration : {Integration::path, Integration::backward_euler})
    {
      ReturnMappingOnDevice mapping(law, integration, count);
      mapping.flow({start, trial, equivalent}, 2.0 * mu, {strain, increment, dissipation});
      for (std::size_t cell = 0; cell < count; ++cell)
      {
        const Deviator q = deviator_at(trial, count, cell);
        const PlasticIncrement there = std::visit(
            [&](const auto& l)
            { return flow(l, {}, integration, deviator_at(start, count, cell), q, equivalent[cell], 2.0 * mu, {}); },
            law);
        const double size = std::max(1.0, von_mises(q));
        EXPECT_LE(von_mises(deviator_at(strain, count, cell) - there.strain), tolerance * size / mu);
        EXPECT_NEAR(increment[cell], there.equivalent, tolerance * size / mu);
        EXPECT_NEAR(dissipation[cell], there.dissipation, tolerance * size * size / mu);
      }
    }
}

} // namespace
} // namespace brinell::cuda::return_mapping_test
