// SPDX-License-Identifier: BSD-3-Clause
#include "cuda/half_space.hpp"

#include "cuda/device.hpp"
#include "device/half_space.hpp"
#include "direct/direct_executor.hpp"
#include "random_field.hpp"
#include "visible_device.hpp"

#include <algorithm>
#include <array>
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

constexpr Elastic body{2.0, 0.3};

/// Periodic, or padded, then with kernels of the longer periods and any functions for the images: device and twin have to do the same
/// with them.
device::BoundaryParts parts_of(const VolumeGrid& grid)
{
  const int nx = grid.surface.nx, ny = grid.surface.ny;
  if (grid.surface.is_periodic())
    return {nx, ny, {}, {}, {}, {}};
  device::BoundaryParts parts{2 * nx, ny == 1 ? 1 : 2 * ny, {}, {}, {}, {}};
  const device::SurfaceWaves waves{parts.px, parts.py, grid.surface.dx, grid.surface.dy};
  for (const Traction traction : {Traction::pressure, Traction::shear_x, Traction::shear_y})
  {
    std::vector<double>& table = parts.kernels[static_cast<std::size_t>(traction)];
    table.resize(waves.stored() * static_cast<std::size_t>(Deviator::size * grid.nz));
    const device::TractionKernels kernels{waves, traction, grid.nz, grid.dz, body.poisson_ratio};
    for (int layer = 0; layer < grid.nz; ++layer)
      for (std::size_t wave = 0; wave < waves.stored(); ++wave)
        for (std::size_t c = 0; c < Deviator::size; ++c)
          table[(static_cast<std::size_t>(layer) * Deviator::size + c) * waves.stored() + wave] =
              kernels.at(wave, layer)[c];
  }
  parts.x_functions = test::random_field(static_cast<std::size_t>(4 * nx), 20);
  parts.y_functions = test::random_field(static_cast<std::size_t>(3 * ny), 21);
  parts.images = [](std::span<const double> moments, std::span<double> coefficients)
  {
    for (std::size_t n = 0; n < moments.size(); ++n)
      coefficients[n] = 0.1 * moments[moments.size() - 1 - n];
  };
  return parts;
}

void expect_like_its_twin(const VolumeGrid& grid)
{
  const std::vector<double> strain = test::random_field(Deviator::size * grid.size(), 1);
  const std::vector<double> pressure = test::random_field(grid.surface.size(), 2),
                            shear = test::random_field(grid.surface.size(), 3);
  const test::DirectExecutor direct;
  const device::BoundaryParts parts = parts_of(grid);
  const device::HalfSpace<test::DirectExecutor> twin(grid, body, parts, direct);
  auto work = twin.make_work();
  twin.load(strain.data(), work);
  HalfSpaceOnDevice half_space(grid, body, parts);
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
  for (const Boundary boundary : {Boundary::periodic, Boundary::open})
    for (const auto [nx, ny, nz] : {std::array{16, 12, 5}, {15, 9, 7}, {32, 1, 8}, {1, 10, 3}, {20, 24, 12}})
      expect_like_its_twin({{nx, ny, 1.0, 1.5, boundary, boundary}, nz, 0.5});
}

TEST(CudaHalfSpace, SaysThatThereIsNoDevice)
{
  if (test::has_device())
    GTEST_SKIP() << "there is a GPU";
  const VolumeGrid grid{{8, 8, 1.0, 1.0, Boundary::periodic, Boundary::periodic}, 2, 1.0};
  EXPECT_THROW(HalfSpaceOnDevice(grid, {1.0, 0.3}, parts_of(grid)), DeviceError);
}

} // namespace
} // namespace brinell::cuda::half_space_test
