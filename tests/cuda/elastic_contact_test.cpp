// SPDX-License-Identifier: BSD-3-Clause
#include "cuda/elastic_contact.hpp"

#include "cuda/device.hpp"
#include "device/elastic_contact.hpp"
#include "direct/direct_executor.hpp"
#include "random_field.hpp"
#include "visible_device.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace brinell::cuda::elastic_contact_test
{
namespace
{

using halfspace::SurfaceCompliance;

/// A wave of unit pressure displaces the surface by 1 / k, a uniform one as the longest wave; the stiffness is the inverse.
SurfaceCompliance::NormalSpectra spectra_of(int px, int py)
{
  SurfaceCompliance::NormalSpectra spectra{{px, py, {}}, {px, py, {}}};
  const device::SurfaceWaves waves{px, py, 1.0, 1.0};
  for (std::size_t wave = 0; wave < waves.stored(); ++wave)
  {
    const double k = std::max(std::hypot(waves.m(wave), waves.n(wave)), 6.0 / std::max(px, py));
    spectra.compliance.factors.push_back(1.0 / k);
    spectra.stiffness.factors.push_back(k);
  }
  return spectra;
}

TEST(CudaElasticContact, IsItsTwinOnTheProcessor)
{
  if (!test::has_device())
    GTEST_SKIP() << "no GPU here";
  open_device();
  constexpr double tolerance = 1e-9;
  const SurfaceGrid grid{14, 11, 1.0, 1.0, Boundary::periodic, Boundary::periodic};
  const std::vector<double> distance = test::random_field(grid.size(), 1, 0.0, 1.0);
  const test::DirectExecutor direct;
  for (const int times : {1, 2})
    for (const contact::Drive& drive :
         {contact::Drive{contact::Drive::Kind::approach, 0.3}, contact::Drive{contact::Drive::Kind::load, 5.0}})
    {
      const SurfaceCompliance::NormalSpectra spectra = spectra_of(times * grid.nx, times * grid.ny);
      std::vector<double> pressure(grid.size()), gap(grid.size()), pressure_of_twin(grid.size()),
          gap_of_twin(grid.size());
      ElasticContactOnDevice on_device(grid, spectra);
      device::ElasticContact<test::DirectExecutor> twin(grid, spectra, direct);
      const contact::Report report = on_device.solve(distance, drive, tolerance, 500, pressure, gap);
      const contact::Report of_twin = twin.solve(distance, drive, tolerance, 500, pressure_of_twin, gap_of_twin);
      ASSERT_TRUE(report.converged);
      ASSERT_TRUE(of_twin.converged);
      EXPECT_NEAR(report.iterations, of_twin.iterations, 1);
      EXPECT_NEAR(report.approach, of_twin.approach, 2.0 * tolerance);
      for (std::size_t n = 0; n < grid.size();
           ++n) // both gaps are within the tolerance of the solution where pressure acts
        EXPECT_LE(pressure[n] > 0.0 ? std::abs(gap[n]) : std::max(0.0, -gap[n]), tolerance);
    }
}

} // namespace
} // namespace brinell::cuda::elastic_contact_test
