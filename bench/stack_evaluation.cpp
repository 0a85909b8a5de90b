// SPDX-License-Identifier: BSD-3-Clause
// How much longer does an evaluation of plastic strain and pressure take in a layered body than in a homogeneous one?
#include "brinell/foundation/deviator.hpp"
#include "brinell/halfspace/half_space.hpp"

#include <benchmark/benchmark.h>
#include <cmath>
#include <vector>

namespace
{

using namespace brinell;

const Elastic base{2.0, 0.3};

/// 0, 1 or 3 layers, in depths that are whole numbers of layers of cells.
ElasticStack stack_of(std::int64_t layers)
{
  if (layers == 0)
    return {{}, base};
  if (layers == 1)
    return {{{4.0, {4.0, 0.2}}}, base};
  return {{{2.0, {4.0, 0.2}}, {2.0, {1.0, 0.4}}, {4.0, {3.0, 0.25}}}, base};
}

void evaluate(benchmark::State& state, Boundary boundary)
{
  const auto nx = static_cast<int>(state.range(1)), ny = static_cast<int>(state.range(2));
  const VolumeGrid grid{{nx, ny, 1.0, 1.0, boundary, boundary}, static_cast<int>(state.range(3)), 0.5};
  const halfspace::HalfSpace body(grid, stack_of(state.range(0)));
  std::vector<double> strain(Deviator::size * grid.size()), stress(strain.size()), pressure(grid.surface.size(), 1.0),
      u(pressure.size());
  for (std::size_t i = 0; i < strain.size(); ++i)
    strain[i] = std::sin(0.1 * static_cast<double>(i));
  halfspace::HalfSpace::Work work = body.make_work();
  const auto once = [&]
  {
    const halfspace::HalfSpace::Loaded loaded = body.load(strain, grid.nz, work);
    loaded.displacement({.z = u});
    loaded.stress({.pressure = pressure}, stress);
    benchmark::DoNotOptimize(stress.data());
  };
  once(); // tabulates the kernels of the pressure
  for (auto _ : state)
    once();
}

void sizes(benchmark::internal::Benchmark* run)
{
  for (const std::vector<std::int64_t>& size : {std::vector<std::int64_t>{33, 13, 31}, {64, 64, 32}})
    for (const std::int64_t layers : {0, 1, 3})
      run->Args({layers, size[0], size[1], size[2]});
}

} // namespace

BENCHMARK_CAPTURE(evaluate, open, Boundary::open)->Apply(sizes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(evaluate, periodic, Boundary::periodic)->Apply(sizes)->Unit(benchmark::kMillisecond);
