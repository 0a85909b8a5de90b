// SPDX-License-Identifier: BSD-3-Clause
#include "cuda/body.hpp"

#include "brinell/elastoplastic/increment.hpp"
#include "cuda/device.hpp"
#include "device/host_device.hpp"
#include "visible_device.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <vector>

/// Increments of bodies on a GPU against those of the same kernels on the processor.
namespace brinell::cuda::body_test
{
namespace
{

using namespace brinell::elastoplastic;

constexpr double alpha_c = 2.214290e-4, tolerance = 1e-10; // [m]; of the largest value

constitutive::Material steel(int terms)
{
  constitutive::Material material{{200e9, 0.32}, {}};
  material.hardening = constitutive::SwiftHardening{1.6e9, 0.004, 0.1};
  material.kinematic.assign(static_cast<std::size_t>(terms), {3e9, 40.0});
  return material;
}

std::vector<double> distance(const SurfaceGrid& grid, double interference)
{
  std::vector<double> field(grid.size());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      field[grid.index(i, j)] = std::pow(grid.x(i), 2) + std::pow(grid.y(j), 2) - interference * alpha_c;
  return field;
}

void expect_same(const std::vector<double>& here, const std::vector<double>& there, const char* what)
{
  ASSERT_EQ(here.size(), there.size()) << what;
  double error = 0.0, largest = 0.0;
  for (std::size_t n = 0; n < here.size(); ++n)
  {
    error = std::max(error, std::abs(here[n] - there[n]));
    largest = std::max(largest, std::abs(there[n]));
  }
  EXPECT_LE(error, tolerance * largest) << what;
}

void expect_like_its_twin(const SurfaceGrid& surface, int terms, double friction)
{
  const VolumeGrid volume{surface, 11, 2.6e-3};
  Sliding sliding;
  sliding.friction.coefficient = friction;
  const auto pair_on = [&](std::shared_ptr<const elastoplastic::Device> device)
  {
    return std::make_unique<CoupledContact>(surface, volume, volume, steel(terms), steel(0),
                                            Scales{alpha_c, 6.0 * alpha_c}, Settings{}, Twin::none, Textures{}, 0.0,
                                            sliding, nullptr, std::move(device));
  };
  const auto gpu = pair_on(cuda_device()), twin = pair_on(device::host_device());
  for (const double interference : {3.0, 6.0, 6.5, 2.0})
  {
    SCOPED_TRACE("interference " + std::to_string(interference));
    const std::vector<double> gap = distance(surface, interference);
    const IncrementReport here = gpu->advance(gap, {}, {}, {}), there = twin->advance(gap, {}, {}, {});
    ASSERT_TRUE(here.converged && there.converged);
    EXPECT_EQ(here.evaluations, there.evaluations);
    for (const auto& [a, b] : {std::pair{gpu->lower(), twin->lower()}, {gpu->upper(), twin->upper()}})
    {
      expect_same(a.solved().state().plastic_strain, b.solved().state().plastic_strain, "plastic strain");
      expect_same(a.solved().state().stress, b.solved().state().stress, "stress");
      expect_same(a.solved().state().backstress, b.solved().state().backstress, "back stress");
      expect_same(a.solved().state().residual_displacement, b.solved().state().residual_displacement, "displacement");
    }
  }
}

TEST(CudaBody, IsItsTwinOnTheProcessor)
{
  if (!test::has_device())
    GTEST_SKIP() << "no GPU here";
  expect_like_its_twin({.nx = 24, .ny = 21, .dx = 2.6e-3, .dy = 2.6e-3}, 0, 0.0);
  expect_like_its_twin({.nx = 21, .ny = 20, .dx = 2.6e-3, .dy = 2.6e-3, .is_mirrored_y = true}, 2, 0.0);
  expect_like_its_twin({.nx = 24, .ny = 20, .dx = 2.6e-3, .dy = 2.6e-3}, 1, 0.3);
}

TEST(CudaBody, SaysThatThereIsNoDevice)
{
  if (test::has_device())
    GTEST_SKIP() << "there is a GPU";
  EXPECT_THROW((void)cuda_device(), DeviceError);
}

} // namespace
} // namespace brinell::cuda::body_test
