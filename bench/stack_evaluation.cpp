// SPDX-License-Identifier: BSD-3-Clause
// How much longer does an evaluation of plastic strain and pressure take in a layered body than in a homogeneous one, and how long
// does planning take up to the end of the first one?
#include "brinell/foundation/deviator.hpp"
#include "brinell/halfspace/half_space.hpp"

#include <benchmark/benchmark.h>
#include <chrono>
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

/// A body with a strain and a pressure.
class Loaded
{
public:
  Loaded(const VolumeGrid& grid, std::int64_t layers)
      : body_(grid, stack_of(layers)), work_(body_.make_work()), strain_(Deviator::size * grid.size()),
        stress_(strain_.size()), pressure_(grid.surface.size(), 1.0), u_(pressure_.size())
  {
    for (std::size_t i = 0; i < strain_.size(); ++i)
      strain_[i] = std::sin(0.1 * static_cast<double>(i));
  }
  /// The first call tabulates the kernels of the pressure.
  void evaluate()
  {
    const halfspace::HalfSpace::Loaded loaded = body_.load(strain_, body_.grid().nz, work_);
    loaded.displacement({.z = u_});
    loaded.stress({.pressure = pressure_}, stress_);
    benchmark::DoNotOptimize(stress_.data());
  }

private:
  halfspace::HalfSpace body_;
  halfspace::HalfSpace::Work work_;
  std::vector<double> strain_, stress_, pressure_, u_;
};

VolumeGrid grid_of(const benchmark::State& state, Boundary boundary)
{
  const auto nx = static_cast<int>(state.range(1)), ny = static_cast<int>(state.range(2));
  return {{nx, ny, 1.0, 1.0, boundary, boundary}, static_cast<int>(state.range(3)), 0.5};
}

double seconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Evaluations of the layered and of the homogeneous body alternate; the time is that of the layered one.
void evaluate(benchmark::State& state, Boundary boundary)
{
  Loaded layered(grid_of(state, boundary), state.range(0)), homogeneous(grid_of(state, boundary), 0);
  layered.evaluate();
  homogeneous.evaluate();
  double of_layered = 0.0, of_homogeneous = 0.0;
  for (auto _ : state)
  {
    const double begin = seconds();
    layered.evaluate();
    const double middle = seconds();
    homogeneous.evaluate();
    of_layered += middle - begin;
    of_homogeneous += seconds() - middle;
    state.SetIterationTime(middle - begin);
  }
  state.counters["over_homogeneous"] = of_layered / of_homogeneous;
}

/// Both bodies alternate, too, from nothing to the end of the first evaluation.
void plan(benchmark::State& state, Boundary boundary)
{
  double of_layered = 0.0, of_homogeneous = 0.0;
  for (auto _ : state)
  {
    const double begin = seconds();
    Loaded(grid_of(state, boundary), state.range(0)).evaluate();
    const double middle = seconds();
    Loaded(grid_of(state, boundary), 0).evaluate();
    of_layered += middle - begin;
    of_homogeneous += seconds() - middle;
    state.SetIterationTime(middle - begin);
  }
  state.counters["over_homogeneous"] = of_layered / of_homogeneous;
}

void sizes(benchmark::internal::Benchmark* run)
{
  for (const std::vector<std::int64_t>& size : {std::vector<std::int64_t>{33, 13, 31}, {64, 64, 32}})
    for (const std::int64_t layers : {1, 3})
      run->Args({layers, size[0], size[1], size[2]});
}

void large_sizes(benchmark::internal::Benchmark* run)
{
  for (const std::vector<std::int64_t>& size : {std::vector<std::int64_t>{128, 128, 32}, {256, 256, 24}})
    for (const std::int64_t layers : {1, 3})
      run->Args({layers, size[0], size[1], size[2]});
}

} // namespace

BENCHMARK_CAPTURE(evaluate, open, Boundary::open)->Apply(sizes)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(evaluate, periodic, Boundary::periodic)->Apply(sizes)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan, open, Boundary::open)->Apply(large_sizes)->UseManualTime()->Unit(benchmark::kMillisecond);
