// SPDX-License-Identifier: BSD-3-Clause
#include "device/elastic_contact.hpp"

#include "device/host_executor.hpp"
#include "random_field.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

/// The contact of a device, run on the processor, against that of the engine.
namespace brinell::device::elastic_contact_test
{
namespace
{

using halfspace::SurfaceCompliance;

constexpr double modulus = 2.0;

SurfaceCompliance compliance_of(const SurfaceGrid& grid)
{
  return {grid, modulus, grid.is_periodic_x() != grid.is_periodic_y() ? 100.0 : 0.0};
}

std::vector<SurfaceGrid> grids()
{
  constexpr Boundary open = Boundary::open, periodic = Boundary::periodic;
  return {{20, 16, 1.0, 1.0, open, open},         {13, 21, 1.0, 1.5, open, open},
          {24, 20, 1.0, 1.0, periodic, periodic}, {17, 9, 1.0, 1.0, periodic, periodic},
          {16, 12, 1.0, 1.0, open, periodic},     {30, 1, 1.0, 1.0, open, periodic}};
}

/// A rough ball, whose contact has many edges.
std::vector<double> rough_ball(const SurfaceGrid& grid)
{
  std::vector<double> distance = test::random_field(grid.size(), 3, 0.0, 0.3);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      distance[grid.index(i, j)] += 0.01 * (grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j));
  return distance;
}

TEST(DeviceElasticContact, ProductsAreThoseOfTheEngine)
{
  for (const SurfaceGrid& grid : grids())
  {
    const SurfaceCompliance compliance = compliance_of(grid);
    const SurfaceCompliance::NormalSpectra spectra = compliance.normal_spectra();
    const std::vector<double> field = test::random_field(grid.size(), 1);
    std::vector<double> there(field.size()), here(field.size());
    const HostExecutor host;
    const auto expect_same = [&]
    {
      double most = 0.0, error = 0.0;
      for (std::size_t n = 0; n < here.size(); ++n)
      {
        most = std::max(most, std::abs(there[n]));
        error = std::max(error, std::abs(here[n] - there[n]));
      }
      EXPECT_LE(error, 1e-13 * most) << grid.nx << " x " << grid.ny; // rounding of the transforms
    };
    compliance.apply({.pressure = field}, {.z = there});
    SurfaceProduct<HostExecutor>(grid, spectra.compliance, host).apply(field.data(), here.data());
    expect_same();
    auto scratch = compliance.make_scratch();
    compliance.apply_inverse(field, there, scratch);
    SurfaceProduct<HostExecutor>(grid, spectra.stiffness, host).apply(field.data(), here.data());
    expect_same();
  }
}

/// Whether pressure and gap are a solution is seen with the operator of the engine. The iterations are those of the engine: sums
/// in another order may move the end by an iteration.
TEST(DeviceElasticContact, SolvesContactsAsTheEngine)
{
  constexpr double tolerance = 1e-9;
  constexpr int most = 500;
  const HostExecutor host;
  for (const SurfaceGrid& grid : grids())
    for (const contact::Drive& drive :
         {contact::Drive{contact::Drive::Kind::approach, 0.25}, contact::Drive{contact::Drive::Kind::load, 6.0}})
    {
      SCOPED_TRACE(testing::Message() << grid.nx << " x " << grid.ny << ", kind " << static_cast<int>(drive.kind));
      const SurfaceCompliance compliance = compliance_of(grid);
      const std::vector<double> distance = rough_ball(grid);
      std::vector<double> pressure(grid.size()), gap(grid.size()), there(grid.size()), gap_there(grid.size());
      ElasticContact<HostExecutor> twin(grid, compliance.normal_spectra(), host);
      const contact::Report report = twin.solve(distance, drive, tolerance, most, pressure, gap);
      contact::ElasticContact engine(compliance);
      const contact::Report of_engine = engine.solve(distance, drive, tolerance, most, there, gap_there);
      ASSERT_TRUE(report.converged);
      ASSERT_TRUE(of_engine.converged);
      EXPECT_NEAR(report.iterations, of_engine.iterations, 1);
      EXPECT_NEAR(report.approach, of_engine.approach, 2.0 * tolerance);

      std::vector<double> u(grid.size());
      compliance.apply({.pressure = pressure}, {.z = u});
      double load = 0.0, pressed = 0.0;
      for (std::size_t n = 0; n < grid.size(); ++n)
      {
        const double own_gap = u[n] + distance[n] - report.approach;
        EXPECT_NEAR(gap[n], own_gap, 1e-12); // rounding of displacements around 1
        EXPECT_GE(pressure[n], 0.0);
        EXPECT_GE(own_gap, -1.001 * tolerance);
        EXPECT_LE(pressure[n] > 0.0 ? std::abs(own_gap) : 0.0, 1.001 * tolerance);
        load += pressure[n] * grid.cell_area();
        pressed += pressure[n] > 0.0 ? 1.0 : 0.0;
      }
      EXPECT_GT(pressed, 0.0);
      EXPECT_LT(pressed, static_cast<double>(grid.size()));
      EXPECT_NEAR(load, drive.kind == contact::Drive::Kind::load ? drive.value : load, 1e-12 * load);
    }
}

TEST(DeviceElasticContact, BeginsWithAGuess)
{
  const SurfaceGrid grid = grids().front();
  const SurfaceCompliance compliance = compliance_of(grid);
  const std::vector<double> distance = rough_ball(grid);
  const contact::Drive drive{contact::Drive::Kind::approach, 0.25};
  const HostExecutor host;
  ElasticContact<HostExecutor> twin(grid, compliance.normal_spectra(), host);
  std::vector<double> pressure(grid.size()), gap(grid.size());
  ASSERT_TRUE(twin.solve(distance, drive, 1e-9, 500, pressure, gap).converged);
  EXPECT_EQ(twin.solve(distance, drive, 1e-9, 500, pressure, gap).iterations, 0);
  // A pressure that is NaN must not pass for a solution.
  pressure.assign(grid.size(), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(twin.solve(distance, drive, 1e-9, 5, pressure, gap).converged);
  EXPECT_THROW((void)twin.solve(distance, {contact::Drive::Kind::mean_gap, 0.1}, 1e-9, 5, pressure, gap),
               InternalError);
}

TEST(DeviceSums, AddAllTermsInOneOrder)
{
  const HostExecutor host;
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{127}, std::size_t{100000}})
  {
    std::vector<double> values(count);
    for (std::size_t n = 0; n < count; ++n)
      values[n] = static_cast<double>(n + 1); // whole numbers, whose sum is exact
    Sums<HostExecutor, double> sums(count, host);
    const auto sum = [&] { return sums("sum", count, Summed<double>{values.data()}); };
    EXPECT_EQ(sum(), 0.5 * static_cast<double>(count) * static_cast<double>(count + 1));
    EXPECT_EQ(sum(), sum());
  }
}

} // namespace
} // namespace brinell::device::elastic_contact_test
