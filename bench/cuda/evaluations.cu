// SPDX-License-Identifier: BSD-3-Clause
// How long does an evaluation of plastic strain and pressure take on a device, how long the return mapping of all cells, and how long
// the fields on their way to it and back?
#include "cuda/cuda_executor.cuh"
#include "cuda/device.hpp"
#include "device/half_space.hpp"
#include "device/return_mapping.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <span>
#include <utility>
#include <vector>

namespace
{

using namespace brinell;
using cuda::CudaExecutor;

/// Mean time of a call [s], once it has run before.
template <typename Work>
double time_of(const Work& work)
{
  constexpr int times = 10;
  const auto finish = [] { cuda::check(cudaDeviceSynchronize(), "waiting for the device"); };
  work();
  finish();
  const auto begin = std::chrono::steady_clock::now();
  for (int n = 0; n < times; ++n)
    work();
  finish();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / times;
}

void measure(const VolumeGrid& grid)
{
  const CudaExecutor executor;
  const std::size_t cells = grid.size();
  const auto tell = [&](const char* what, double seconds)
  {
    std::printf("%d x %d x %d, %s: %.3f ms, %.4f ns a cell\n", grid.surface.nx, grid.surface.ny, grid.nz, what,
                1e3 * seconds, 1e9 * seconds / static_cast<double>(cells));
  };
  std::vector<double> field(Deviator::size * cells);
  for (std::size_t n = 0; n < field.size(); ++n)
    field[n] = std::sin(0.1 * static_cast<double>(n));
  auto strain = executor.allocate<double>(field.size()), stress = executor.allocate<double>(field.size());
  auto pressure = executor.allocate<double>(grid.surface.size()), u = executor.allocate<double>(grid.surface.size());
  tell("fields to the device", time_of([&] { executor.write(std::span<const double>(field), strain); }));
  tell("fields from the device", time_of([&] { executor.read(strain, std::span<double>(field)); }));

  const device::BoundaryParts boundary{grid.surface.nx, grid.surface.ny, {}, {}, {}, {}};
  const device::HalfSpace<CudaExecutor> half_space(grid, {2.0, 0.3}, boundary, executor);
  auto work = half_space.make_work();
  tell("strain and pressure to displacement and stress",
       time_of(
           [&]
           {
             half_space.load(strain.data(), work);
             half_space.displacement(Traction::pressure, work, u.data());
             half_space.stress({.pressure = pressure.data()}, strain.data(), work, stress.data());
           }));

  auto equivalent = executor.allocate<double>(cells), increment = executor.allocate<double>(cells),
       dissipation = executor.allocate<double>(cells), flow = executor.allocate<double>(field.size()),
       start = executor.allocate<double>(field.size());
  const auto tell_mapping = [&](const char* what, const constitutive::HardeningLaw& law)
  {
    const device::ReturnMapping<CudaExecutor> mapping(law, constitutive::Integration::path, executor);
    tell(what, time_of(
                   [&]
                   {
                     mapping.flow({.cells = cells,
                                   .cells_of_layer = grid.surface.size(),
                                   .stiffness = 10.0,
                                   .start = start.data(),
                                   .trial = strain.data(),
                                   .equivalent = equivalent.data(),
                                   .strain = flow.data(),
                                   .increment = increment.data(),
                                   .dissipation = dissipation.data()});
                   }));
  };
  tell_mapping("return mapping, linear hardening", constitutive::LinearHardening{1.0, 0.5});
  tell_mapping("return mapping, Swift's law", constitutive::SwiftHardening{2.0, 0.01, 0.2});
}

} // namespace

int main()
{
  try
  {
    const cuda::Device device = cuda::open_device();
    std::printf("%s, compute capability %d.%d, %.1f GB free\n", device.name.c_str(), device.major, device.minor,
                1e-9 * static_cast<double>(device.free_memory));
    for (const auto& [n, layers] : {std::pair{64, 24}, {256, 24}, {1024, 32}})
      measure({{n, n, 1.0, 1.0, Boundary::periodic, Boundary::periodic}, layers, 1.0});
    return 0;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
