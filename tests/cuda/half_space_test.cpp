// SPDX-License-Identifier: BSD-3-Clause
#include "cuda/half_space.hpp"

#include "cuda/device.hpp"
#include "device/periodic_half_space.hpp"
#include "direct/direct_executor.hpp"
#include "random_field.hpp"
#include "visible_device.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace brinell::cuda::half_space_test
{
namespace
{

/// The functions of the device round in other last digits than those of the processor, and cuFFT sums in another order.
constexpr double tolerance = 1e-12;

void expect_same(const std::vector<double>& here, const std::vector<double>& there)
{
  double most = 0.0, error = 0.0;
  for (std::size_t n = 0; n < here.size(); ++n)
  {
    most = std::max(most, std::abs(there[n]));
    error = std::max(error, std::abs(here[n] - there[n]));
  }
  EXPECT_GT(most, 0.0);
  EXPECT_LE(error, tolerance * most);
}

void expect_like_its_twin(const VolumeGrid& grid)
{
  const Elastic body{2.0, 0.3};
  const std::vector<double> strain = test::random_field(Deviator::size * grid.size(), 1);
  const std::vector<double> pressure = test::random_field(grid.surface.size(), 2),
                            shear = test::random_field(grid.surface.size(), 3);
  const test::DirectExecutor direct;
  const device::PeriodicHalfSpace<test::DirectExecutor> twin(grid, body, direct);
  auto work = twin.make_work();
  twin.load(strain.data(), work);
  HalfSpaceOnDevice half_space(grid, body);
  half_space.load(strain);

  std::vector<double> z(grid.surface.size()), z_of_twin(z);
  twin.displacement(Traction::pressure, work, z_of_twin.data());
  half_space.displacement({.z = z});
  expect_same(z, z_of_twin);
  std::vector<double> stress(strain.size()), stress_of_twin(strain.size());
  twin.stress({.pressure = pressure.data(), .shear_y = shear.data()}, strain.data(), work, stress_of_twin.data());
  for (int turn = 0; turn < 2; ++turn) // an evaluation leaves nothing behind that changes the next one
  {
    half_space.stress({.pressure = pressure, .shear_y = shear}, stress);
    expect_same(stress, stress_of_twin);
  }
}

TEST(CudaHalfSpace, IsItsTwinOnTheProcessor)
{
  if (!test::has_device())
    GTEST_SKIP() << "no GPU here";
  open_device();
  const auto grid = [](int nx, int ny, int nz) {
    return VolumeGrid{{nx, ny, 1.0, 1.5, Boundary::periodic, Boundary::periodic}, nz, 0.5};
  };
  for (const VolumeGrid& of : {grid(16, 12, 5), grid(15, 9, 7), grid(32, 1, 8), grid(1, 10, 3), grid(20, 24, 12)})
    expect_like_its_twin(of);
}

TEST(CudaHalfSpace, SaysThatThereIsNoDevice)
{
  if (test::has_device())
    GTEST_SKIP() << "there is a GPU";
  const VolumeGrid grid{{8, 8, 1.0, 1.0, Boundary::periodic, Boundary::periodic}, 2, 1.0};
  EXPECT_THROW(HalfSpaceOnDevice(grid, {1.0, 0.3}), DeviceError);
}

} // namespace
} // namespace brinell::cuda::half_space_test
