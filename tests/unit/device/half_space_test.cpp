// SPDX-License-Identifier: BSD-3-Clause
#include "device/half_space.hpp"

#include "brinell/halfspace/half_space.hpp"
#include "device/host_executor.hpp"
#include "direct/direct_executor.hpp"
#include "random_field.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

/// The kernels of a device, run on the processor, against the half space of the engine: the mathematics is one text, the order of
/// wavenumbers, layers and transforms is not.
namespace brinell::device::half_space_test
{
namespace
{

const Elastic steel{210e9, 0.3}, cork{1.0, 0.0}, rubber{3.0, 0.49};

VolumeGrid grid_of(Boundary along_x, Boundary along_y, int nx, int ny, int nz, double dx, double dy, double dz)
{
  return {{nx, ny, dx, dy, along_x, along_y}, nz, dz};
}

/// Even and odd numbers of cells, one row, one column, one layer, long transforms and long cells.
std::vector<VolumeGrid> grids()
{
  constexpr Boundary open = Boundary::open, periodic = Boundary::periodic;
  return {grid_of(periodic, periodic, 16, 12, 5, 1.0, 1.0, 1.0),
          grid_of(periodic, periodic, 15, 9, 7, 1.0, 1.5, 0.5),
          grid_of(periodic, periodic, 32, 1, 8, 1.0, 1.0, 1.0),
          grid_of(periodic, periodic, 1, 10, 3, 1.0, 1.0, 1.0),
          grid_of(periodic, periodic, 8, 21, 1, 2e-6, 1e-6, 1e-6),
          grid_of(periodic, periodic, 64, 48, 24, 1e-6, 1e-6, 1e-6),
          grid_of(periodic, periodic, 13, 22, 4, 1.0, 1.0, 30.0),
          grid_of(periodic, periodic, 24, 20, 32, 1.0, 1.0, 0.01),
          grid_of(open, open, 14, 11, 6, 1.0, 1.0, 1.0),
          grid_of(open, open, 9, 14, 5, 1.5e-6, 1e-6, 0.5e-6),
          grid_of(open, open, 33, 26, 12, 1.0, 1.0, 0.3),
          grid_of(open, open, 70, 9, 4, 1.0, 1.0, 1.0),
          grid_of(open, open, 8, 45, 3, 1.0, 1.0, 0.7),
          grid_of(open, open, 20, 1, 3, 1.0, 1.0, 1.0),
          grid_of(open, periodic, 17, 8, 4, 1.0, 1.0, 1.0),
          grid_of(periodic, open, 8, 15, 4, 1.0, 1.0, 1.0),
          grid_of(open, periodic, 12, 1, 6, 1.0, 1.0, 1.0)};
}

double largest(const std::vector<double>& values)
{
  double most = 0.0;
  for (const double value : values)
    most = std::max(most, std::abs(value));
  return most;
}

/// Rounding of sums over layers and transforms, relative to the largest value.
constexpr double tolerance = 1e-13;

void expect_same(const std::vector<double>& here, const std::vector<double>& there, const char* field)
{
  const double most = largest(there);
  double error = 0.0;
  for (std::size_t n = 0; n < here.size(); ++n)
    error = std::max(error, std::abs(here[n] - there[n]));
  EXPECT_GT(most, 0.0) << field;
  EXPECT_LE(error, tolerance * most) << field;
}

/// A strain as large as the stress of the loads.
std::vector<double> random_strain(const VolumeGrid& grid, const Elastic& body, unsigned seed)
{
  std::vector<double> strain = test::random_field(Deviator::size * grid.size(), seed);
  for (double& value : strain)
    value /= body.young_modulus;
  return strain;
}

struct Loads
{
  std::vector<double> pressure, shear_x, shear_y;

  explicit Loads(const SurfaceGrid& grid)
      : pressure(test::random_field(grid.size(), 2)), shear_x(test::random_field(grid.size(), 3)),
        shear_y(test::random_field(grid.size(), 4))
  {
  }
};

void expect_like_the_engine(const VolumeGrid& grid, const Elastic& body)
{
  SCOPED_TRACE(testing::Message() << grid.surface.nx << " x " << grid.surface.ny << " x " << grid.nz << ", nu "
                                  << body.poisson_ratio);
  const std::vector<double> strain = random_strain(grid, body, 1);
  const Loads loads(grid.surface);
  const halfspace::HalfSpace engine(grid, body);
  halfspace::HalfSpace::Work engine_work = engine.make_work();
  const auto loaded = engine.load(strain, grid.nz, engine_work, halfspace::Displacements::all);
  const HostExecutor host;
  const HalfSpace<HostExecutor> twin(grid, body, boundary_of(grid, body, true), host);
  auto work = twin.make_work();
  twin.load(strain.data(), work);

  std::vector<double> z(grid.surface.size()), x(z), y(z), here(z);
  loaded.displacement({.z = z, .x = x, .y = y});
  for (const auto& [along, there] :
       {std::pair{Traction::pressure, &z}, {Traction::shear_x, &x}, {Traction::shear_y, &y}})
  {
    twin.displacement(along, work, here.data());
    if (largest(*there) > 0.0) // one cell along an axis: nothing goes along it
      expect_same(here, *there, "displacement");
    else
      EXPECT_EQ(largest(here), 0.0);
  }

  std::vector<double> there(strain.size()), stress(strain.size());
  loaded.stress({.pressure = loads.pressure, .shear_x = loads.shear_x, .shear_y = loads.shear_y}, there);
  twin.stress({loads.pressure.data(), loads.shear_x.data(), loads.shear_y.data()}, strain.data(), work, stress.data());
  expect_same(stress, there, "stress of everything");
  loaded.stress({}, there);
  twin.stress({}, strain.data(), work, stress.data());
  expect_same(stress, there, "residual stress");
  loaded.stress({.shear_x = loads.shear_x}, there);
  twin.stress({.shear_x = loads.shear_x.data()}, strain.data(), work, stress.data());
  expect_same(stress, there, "stress with shear");
}

TEST(DeviceHalfSpace, IsThatOfTheEngine)
{
  for (const VolumeGrid& grid : grids())
    for (const Elastic& body : {steel, cork, rubber})
      expect_like_the_engine(grid, body);
}

TEST(DeviceHalfSpace, OfALoadAloneIsThatOfTheEngine)
{
  for (const VolumeGrid& grid : grids())
  {
    const Loads loads(grid.surface);
    const halfspace::HalfSpace engine(grid, steel);
    halfspace::HalfSpace::Work engine_work = engine.make_work();
    std::vector<double> none(Deviator::size * grid.size()), there(none), stress(none),
        z(grid.surface.size(), std::numeric_limits<double>::quiet_NaN());
    engine.load(none, grid.nz, engine_work).stress({.pressure = loads.pressure, .shear_y = loads.shear_y}, there);
    const HostExecutor host;
    const HalfSpace<HostExecutor> twin(grid, steel, boundary_of(grid, steel, true), host);
    auto work = twin.make_work();
    twin.load(nullptr, work);
    twin.stress({loads.pressure.data(), nullptr, loads.shear_y.data()}, nullptr, work, stress.data());
    expect_same(stress, there, "stress of a load");
    twin.stress({}, nullptr, work, stress.data());
    EXPECT_EQ(largest(stress), 0.0);
    twin.displacement(Traction::pressure, work, z.data());
    EXPECT_EQ(z, std::vector<double>(z.size()));
  }
}

/// The order of spectra in memory, and their factors, are what the contract of executors says: otherwise cuFFT would not do.
TEST(DeviceHalfSpace, WithDirectSumsIsThatOfTheEngine)
{
  for (const VolumeGrid& grid : grids())
  {
    if (grid.size() > 1000)
      continue;
    const std::vector<double> strain = random_strain(grid, steel, 5);
    const Loads loads(grid.surface);
    const halfspace::HalfSpace engine(grid, steel);
    halfspace::HalfSpace::Work engine_work = engine.make_work();
    std::vector<double> there(strain.size()), stress(strain.size());
    engine.load(strain, grid.nz, engine_work).stress({.pressure = loads.pressure, .shear_x = loads.shear_x}, there);
    const test::DirectExecutor direct;
    const HalfSpace<test::DirectExecutor> twin(grid, steel, boundary_of(grid, steel, true), direct);
    auto work = twin.make_work();
    twin.load(strain.data(), work);
    twin.stress({.pressure = loads.pressure.data(), .shear_x = loads.shear_x.data()}, strain.data(), work,
                stress.data());
    expect_same(stress, there, "stress");
  }
}

TEST(DeviceHalfSpace, RefusesATractionThatWasNotPrepared)
{
  const VolumeGrid grid = grid_of(Boundary::open, Boundary::open, 8, 8, 2, 1.0, 1.0, 1.0);
  const HostExecutor host;
  const HalfSpace<HostExecutor> twin(grid, steel, boundary_of(grid, steel, false), host);
  auto work = twin.make_work();
  const std::vector<double> shear(grid.surface.size());
  std::vector<double> stress(Deviator::size * grid.size());
  twin.load(nullptr, work);
  EXPECT_THROW(twin.stress({.shear_x = shear.data()}, nullptr, work, stress.data()), InternalError);
}

} // namespace
} // namespace brinell::device::half_space_test
