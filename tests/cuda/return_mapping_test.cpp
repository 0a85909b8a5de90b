// SPDX-License-Identifier: BSD-3-Clause
#include "cuda/return_mapping.hpp"

#include "cuda/device.hpp"
#include "random_field.hpp"
#include "visible_device.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <span>
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
  const std::vector<KinematicTerm> two{{20.0, 50.0}, {3.0, 0.0}};
  const std::size_t components = Deviator::size * count;
  for (const HardeningLaw& law : laws)
    for (const Integration integration : {Integration::path, Integration::backward_euler})
      for (const std::vector<KinematicTerm>& terms : {std::vector<KinematicTerm>{}, two})
      {
        std::vector<double> backstress = test::random_field(terms.size() * components, 2, -0.1, 0.1);
        const std::vector<double> back_before = backstress;
        ReturnMappingOnDevice mapping(law, integration, count, terms);
        mapping.flow({start, trial, equivalent}, 2.0 * mu, {strain, increment, dissipation, backstress});
        for (std::size_t cell = 0; cell < count; ++cell)
        {
          std::vector<Deviator> back;
          for (std::size_t term = 0; term < terms.size(); ++term)
            back.push_back(deviator_at(std::span(back_before).subspan(term * components, components), count, cell));
          const Deviator q = deviator_at(trial, count, cell);
          const PlasticIncrement there = std::visit(
              [&](const auto& l) {
                return flow(l, terms, integration, deviator_at(start, count, cell), q, equivalent[cell], 2.0 * mu,
                            back);
              },
              law);
          const double size = std::max(1.0, von_mises(q));
          EXPECT_LE(von_mises(deviator_at(strain, count, cell) - there.strain), tolerance * size / mu);
          EXPECT_NEAR(increment[cell], there.equivalent, tolerance * size / mu);
          EXPECT_NEAR(dissipation[cell], there.dissipation, tolerance * size * size / mu);
          for (std::size_t term = 0; term < terms.size(); ++term)
            EXPECT_LE(von_mises(deviator_at(std::span(backstress).subspan(term * components, components), count, cell) -
                                back[term]),
                      tolerance * size);
        }
      }
}

} // namespace
} // namespace brinell::cuda::return_mapping_test
