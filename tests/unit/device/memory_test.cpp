// SPDX-License-Identifier: BSD-3-Clause
#include "device/memory.hpp"

#include "brinell/elastoplastic/increment.hpp"
#include "device/body_on_executor.hpp"
#include "device/elastic_contact.hpp"
#include "device/host_executor.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <utility>
#include <vector>

/// The memory that a body takes on a device, as `brinell check` tells it, against what is allocated.
namespace brinell::device::memory_test
{
namespace
{

/// Numbers of all arrays that there are, and that there were at most [bytes].
struct Count
{
  double now = 0.0, most = 0.0;
  void add(double bytes)
  {
    now += bytes;
    most = std::max(most, now);
  }
};

Count& count()
{
  static Count bytes;
  return bytes;
}

/// An array that is counted.
template <typename Value>
class Counted
{
public:
  Counted() = default;
  explicit Counted(std::size_t size) : values_(size) { count().add(bytes()); }
  Counted(Counted&& other) noexcept : values_(std::exchange(other.values_, {})) {}
  Counted& operator=(Counted&& other) noexcept
  {
    std::swap(values_, other.values_);
    return *this;
  }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  ~Counted() { count().add(-bytes()); }

  [[nodiscard]] Value* data() { return values_.data(); }
  [[nodiscard]] const Value* data() const { return values_.data(); }
  [[nodiscard]] std::size_t size() const { return values_.size(); }

private:
  [[nodiscard]] double bytes() const { return static_cast<double>(values_.size() * sizeof(Value)); }
  std::vector<Value> values_;
};

class CountingExecutor : public HostExecutor
{
public:
  template <typename Value>
  using Memory = Counted<Value>;

  template <typename Value>
  [[nodiscard]] Memory<Value> allocate(std::size_t size) const
  {
    return Memory<Value>(size);
  }
  template <typename Value>
  void write(std::span<const Value> from, Memory<Value>& to) const
  {
    std::copy(from.begin(), from.end(), to.data());
  }
  template <typename Value>
  void read(const Memory<Value>& from, std::span<Value> to) const
  {
    std::copy_n(from.data(), to.size(), to.begin());
  }
};

class CountingDevice : public elastoplastic::Device
{
public:
  [[nodiscard]] std::string name() const override { return "counting"; }
  [[nodiscard]] double free_memory() const override { return 0.0; }
  [[nodiscard]] std::unique_ptr<elastoplastic::BodyOnDevice>
  make_body(const VolumeGrid& grid, const constitutive::Material& material, bool with_shears) const override
  {
    return std::make_unique<BodyOnExecutor<CountingExecutor>>(grid, material, with_shears, executor_);
  }

  [[nodiscard]] std::unique_ptr<contact::ContactOnDevice>
  make_contact(const SurfaceGrid& grid, const halfspace::SurfaceCompliance::NormalSpectra& spectra) const override
  {
    return std::make_unique<ContactOnExecutor<CountingExecutor>>(grid, spectra, executor_);
  }

private:
  CountingExecutor executor_;
};

constitutive::Material steel()
{
  constitutive::Material material{{200e9, 0.3}, {}};
  material.hardening = constitutive::LinearHardening{0.9e9, 4e9};
  return material;
}

VolumeGrid grid_of(Boundary boundary, int nx, int ny, bool is_mirrored = false)
{
  return {{nx, ny, 2.6e-3, 2.6e-3, boundary, boundary, is_mirrored}, 9, 2.6e-3};
}

TEST(MemoryOnDevice, OfABodyAtRestIsExact)
{
  for (const VolumeGrid& grid :
       {grid_of(Boundary::periodic, 24, 18), grid_of(Boundary::open, 24, 23), grid_of(Boundary::open, 21, 20, true)})
    for (const bool with_shears : {false, true})
      for (const int terms : {0, 2})
      {
        constitutive::Material material = steel();
        material.kinematic.assign(static_cast<std::size_t>(terms), {1e9, 20.0});
        if (terms > 0)
          material.initial_stress = constitutive::DepthProfile({0.0, 1e-2}, {-1e8, 0.0});
        const double before = count().now;
        const auto body = CountingDevice().make_body(grid, material, with_shears);
        const MemoryOfBody told =
            memory_of_body(grid, {.backstresses = terms, .with_shears = with_shears, .has_initial_stress = terms > 0});
        EXPECT_DOUBLE_EQ(count().now - before, told.arrays)
            << grid.surface.nx << " x " << grid.surface.ny << ", " << terms << " terms";
        EXPECT_GT(told.buffers, 0.0);
      }
}

/// The images of long grids have functions that are left out.
TEST(MemoryOnDevice, OfLongGridsIsNearlyExact)
{
  const VolumeGrid grid = grid_of(Boundary::open, 100, 16);
  const double before = count().now;
  const auto body = CountingDevice().make_body(grid, steel(), false);
  const double counted = count().now - before;
  EXPECT_LE(memory_of_body(grid, {}).arrays, counted);
  EXPECT_GE(memory_of_body(grid, {}).arrays, 0.95 * counted);
}

TEST(MemoryOnDevice, OfAContactIsExact)
{
  for (const VolumeGrid& grid :
       {grid_of(Boundary::periodic, 24, 18), grid_of(Boundary::open, 25, 14), grid_of(Boundary::open, 21, 20, true)})
  {
    const halfspace::SurfaceCompliance compliance(grid.surface, 1e11);
    const double before = count().now;
    const auto contact = CountingDevice().make_contact(grid.surface, compliance.normal_spectra());
    EXPECT_DOUBLE_EQ(count().now - before, memory_of_contact(grid.surface).arrays);
  }
}

/// A sphere pressed into a flat, in which cells become active one by one.
TEST(MemoryOnDevice, OfAnIncrementIsAtMostThatTold)
{
  using namespace elastoplastic;
  const VolumeGrid grid = grid_of(Boundary::open, 24, 24);
  constexpr double alpha = 1.3e-3; // [m]
  std::vector<double> distance(grid.surface.size());
  for (int j = 0; j < grid.surface.ny; ++j)
    for (int i = 0; i < grid.surface.nx; ++i)
      distance[grid.surface.index(i, j)] = std::pow(grid.surface.x(i), 2) + std::pow(grid.surface.y(j), 2) - alpha;
  const double before = count().now;
  count().most = before;
  CoupledContact pair(grid.surface, grid, grid, steel(), {{400e9, 0.3}, {}}, {0.2 * alpha, alpha}, {}, Twin::none, {},
                      0.0, {}, nullptr, std::make_shared<const CountingDevice>());
  ASSERT_TRUE(pair.advance(distance, {}, {}, {}).converged);
  const std::size_t active = pair.lower().solved().active_of_all();
  EXPECT_GT(active, grid.size() / 50);
  const double counted = count().most - before, of_contact = memory_of_contact(grid.surface).arrays,
               at_rest = of_contact + memory_of_body(grid, {}).arrays,
               told = of_contact +
                      memory_of_body(grid, {.active_cells = static_cast<double>(active), .history = 6}).arrays;
  EXPECT_GT(counted, at_rest);
  EXPECT_LE(counted, told);
  EXPECT_GE(counted - at_rest, 0.3 * (told - at_rest)); // arrays grow by halves, and not all at once
}

} // namespace
} // namespace brinell::device::memory_test
