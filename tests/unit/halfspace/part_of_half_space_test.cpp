// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/deviator.hpp"
#include "brinell/halfspace/half_space.hpp"
#include "mirrored_grid.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <omp.h>
#include <tuple>
#include <utility>
#include <vector>

/// The operators of some columns of a body against those of all of it.
namespace brinell::halfspace::part_of_half_space_test
{
namespace
{

const Elastic elastic{200e9, 0.32};
const VolumeGrid whole{{45, 13, 3.85e-3, 7.7e-3}, 24, 1.925e-3};
const VolumeGrid part{{20, 13, 3.85e-3, 7.7e-3}, 24, 1.925e-3};
constexpr int first_column = 11;

/// A strain that is nothing at the ends of the part, once as the cells resolve it and once changing its sign from cell to cell.
std::vector<double> strain_on(const VolumeGrid& grid, int column, bool alternates)
{
  std::vector<double> strain(Deviator::size * grid.size());
  const double share[Deviator::size] = {1.0, -0.3, 0.2, 0.5, 0.4};
  for (int c = 0; c < Deviator::size; ++c)
    for (int k = 0; k < grid.nz; ++k)
      for (int j = 0; j < part.surface.ny; ++j)
        for (int i = 0; i < part.surface.nx; ++i)
        {
          const double x = (i - 9.5) / 4.0, y = (j - 6.0) / 2.0, z = (k - 8.0) / 5.0;
          const double sign = alternates && (i + j + k) % 2 != 0 ? -1.0 : 1.0;
          strain[static_cast<std::size_t>(c) * grid.size() + grid.index(i + column, j, k)] =
              1e-3 * share[c] * sign * std::exp(-x * x - y * y - z * z);
        }
  return strain;
}

/// Stress and displacement within the part.
std::vector<double> answer(const HalfSpace& half_space, int column, bool alternates)
{
  const VolumeGrid& grid = half_space.grid();
  HalfSpace::Work work = half_space.make_work();
  const std::vector<double> strain = strain_on(grid, column, alternates);
  std::vector<double> pressure(grid.surface.size()), stress(strain.size()), displacement(grid.surface.size());
  for (int j = 3; j < 10; ++j)
    for (int i = 4; i < 15; ++i)
      pressure[grid.surface.index(i + column, j)] = 1e6 * (i + 2 * j);
  const auto loaded = half_space.load(strain, grid.nz, work);
  loaded.displacement({.z = displacement});
  loaded.stress({.pressure = pressure}, stress);
  std::vector<double> result;
  for (int c = 0; c < Deviator::size; ++c)
    for (int k = 0; k < grid.nz; ++k)
      for (int j = 0; j < part.surface.ny; ++j)
        for (int i = 0; i < part.surface.nx; ++i)
          result.push_back(stress[static_cast<std::size_t>(c) * grid.size() + grid.index(i + column, j, k)]);
  for (int j = 0; j < part.surface.ny; ++j)
    for (int i = 0; i < part.surface.nx; ++i)
      result.push_back(1e14 * displacement[grid.surface.index(i + column, j)]); // of the size of the stress
  return result;
}

/// Largest difference, over the largest value.
double difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = 0.0, apart = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max(largest, std::abs(b[i]));
    apart = std::max(apart, std::abs(a[i] - b[i]));
  }
  return apart / largest;
}

TEST(PartOfHalfSpace, AgreesWithTheWholeToWhatImagesAreTakenOffTo)
{
  EXPECT_LT(difference(answer(HalfSpace(part, elastic, whole.surface), 0, false),
                       answer(HalfSpace(whole, elastic), first_column, false)),
            1e-4);
}

TEST(PartOfHalfSpace, MakesNearlyTheSameOfStrainThatCellsDoNotResolve)
{
  const std::vector<double> of_whole = answer(HalfSpace(whole, elastic), first_column, true);
  const double told = difference(answer(HalfSpace(part, elastic, whole.surface), 0, true), of_whole);
  const double untold = difference(answer(HalfSpace(part, elastic), 0, true), of_whole);
  EXPECT_LT(told, 6e-3);
  EXPECT_LT(4.0 * told, untold);
}

TEST(PartOfHalfSpace, AGuestComputesTheSameWithTheBuffersOfItsHost)
{
  const std::vector<double> noise = test::random_field(Deviator::size * whole.size(), 5);
  const std::vector<double> strain = test::random_field(Deviator::size * part.size(), 6);
  std::vector<double> expected(strain.size()), found(strain.size()), of_noise(noise.size());
  for (const bool is_mirrored : {false, true})
  {
    const HalfSpace host(test::mirrored(whole, is_mirrored), elastic),
        guest(test::mirrored(part, is_mirrored), elastic, whole.surface);
    HalfSpace::Work hosts = host.make_work(), own = guest.make_work(), lent = guest.make_guest();
    const auto before = host.load(noise, whole.nz, hosts);
    before.stress({}, of_noise);
    guest.load(strain, part.nz, own).stress({}, expected);
    HalfSpace::exchange_buffers(lent, hosts);
    guest.load(strain, part.nz, lent).stress({}, found);
    HalfSpace::exchange_buffers(lent, hosts);
    EXPECT_EQ(found, expected);
    EXPECT_THROW(before.stress({}, of_noise), std::exception) << "the strain of the host is lost";
  }
}

// Whether each thread has a block of its own depends on the number of blocks, which a guest has fewer of than its host.
TEST(PartOfHalfSpace, AGuestComputesTheSameWhateverTheNumbersOfBlocksAndThreads)
{
  const int before = omp_get_max_threads();
  omp_set_num_threads(3);
  const HalfSpace guest({{16, 5, 1e-3, 1e-3}, 4, 1e-3}, elastic);
  const std::vector<double> strain = test::random_field(Deviator::size * guest.grid().size(), 6);
  const int layers = guest.grid().nz;
  HalfSpace::Work own = guest.make_work();
  std::vector<double> expected(strain.size()), of_surface(guest.grid().surface.size());
  const auto alone = guest.load(strain, layers, own);
  alone.stress({}, expected);
  alone.displacement({.z = of_surface});
  for (int columns = 17; columns < 60; columns += 3)
  {
    const HalfSpace host({{columns, 5, 1e-3, 1e-3}, layers, 1e-3}, elastic);
    HalfSpace::Work hosts = host.make_work(), lent = guest.make_guest();
    HalfSpace::exchange_buffers(lent, hosts);
    std::vector<double> found(strain.size()), displacement(of_surface.size());
    const auto loaded = guest.load(strain, layers, lent);
    loaded.stress({}, found);
    loaded.displacement({.z = displacement});
    EXPECT_LT(difference(found, expected), 1e-13) << columns;
    EXPECT_LT(difference(displacement, of_surface), 1e-13) << columns;
    HalfSpace::exchange_buffers(lent, hosts);
    const std::vector<double> of_host(Deviator::size * host.grid().size(), 1e-3);
    EXPECT_NO_THROW(std::ignore = host.load(of_host, layers, hosts)) << columns;
  }
  omp_set_num_threads(before);
}

} // namespace
} // namespace brinell::halfspace::part_of_half_space_test
