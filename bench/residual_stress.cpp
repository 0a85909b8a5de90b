// SPDX-License-Identifier: BSD-3-Clause
// How far is one residual-stress evaluation from its floor, the Fourier transforms of the same planes, and does its cost
// grow as N log N?
#include "brinell/foundation/deviator.hpp"
#include "brinell/halfspace/half_space.hpp"
#include "foundation/blocked_fft.hpp"
#include "foundation/fft.hpp"

#include <benchmark/benchmark.h>
#include <chrono>
#include <cmath>
#include <fstream>
#include <unistd.h>
#include <vector>

namespace
{

using namespace brinell;

/// The paper's mesh along a whole track, 45 x 13 x 31 cells, refined.
VolumeGrid refined_grid(int refinement)
{
  const double r = refinement;
  return {{45 * refinement, 13 * refinement, 3.85e-3 / r, 7.7e-3 / r}, 31 * refinement, 1.925e-3 / r};
}

double resident_bytes()
{
  std::ifstream file("/proc/self/statm");
  double total = 0.0;
  double resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// The same transforms, of 5 strains forward and 5 stresses back in every layer: what any route by layers has to pay.
void transform_all(const BlockedFft& fft, const BlockedFft& of_plane, const std::vector<double>& strain,
                   AlignedVector<ComplexLanes>& rows, AlignedVector<ComplexLanes>& spectrum,
                   std::vector<double>& stress)
{
  const std::size_t cells = fft.grid().size();
#pragma omp parallel
  {
    BlockedFft::Scratch scratch = fft.make_scratch();
    AlignedVector<ComplexLanes> plane_rows(of_plane.rows_size());
#pragma omp for schedule(static)
    for (int plane = 0; plane < fft.planes(); ++plane)
      fft.rows_forward(strain.data() + static_cast<std::size_t>(plane) * cells, plane, rows.data(), scratch);
    for (int block = 0; block < fft.blocks(); ++block)
    {
#pragma omp for schedule(static)
      for (int plane = 0; plane < fft.planes(); ++plane)
        fft.columns_forward(rows.data(), block, plane, spectrum.data() + fft.plane_at(0, plane), scratch);
    }
#pragma omp for schedule(static)
    for (int plane = 0; plane < fft.planes(); ++plane)
    {
      for (int block = 0; block < fft.blocks(); ++block)
        of_plane.columns_inverse(spectrum.data() + fft.plane_at(0, plane), block, 0, plane_rows.data(), scratch);
      of_plane.rows_inverse(plane_rows.data(), 0, stress.data() + static_cast<std::size_t>(plane) * cells, scratch);
    }
  }
}

void evaluate(benchmark::State& state, const VolumeGrid& grid)
{
  using Clock = std::chrono::steady_clock;
  const double before = resident_bytes();
  const halfspace::HalfSpace half_space(grid, {200e9, 0.32});
  halfspace::HalfSpace::Work work = half_space.make_work();
  std::vector<double> strain(Deviator::size * grid.size());
  std::vector<double> stress(strain.size());
  std::vector<double> pressure(grid.surface.size(), 1e9);
  std::vector<double> displacement(grid.surface.size());
  for (std::size_t i = 0; i < strain.size(); ++i)
    strain[i] = 1e-3 * std::sin(0.37 * static_cast<double>(i));
  // Evaluation and bare transforms by turns, so that both see the same machine.
  double seconds = 0.0;
  double bare = 0.0;
  const double memory = resident_bytes() - before;
  const BlockedFft fft(grid.surface, fast_length(2 * grid.surface.nx - 1), fast_length(2 * grid.surface.ny - 1),
                       Deviator::size * grid.nz);
  const BlockedFft of_plane(grid.surface, fft.px(), fft.py(), 1);
  AlignedVector<ComplexLanes> rows(fft.rows_size());
  AlignedVector<ComplexLanes> spectrum(fft.block_size());
  for (auto _ : state)
  {
    const auto begin = Clock::now();
    const halfspace::HalfSpace::Loaded loaded = half_space.load(strain, grid.nz, work);
    loaded.displacement({.z = displacement});
    loaded.stress({.pressure = pressure}, stress);
    const auto end = Clock::now();
    benchmark::DoNotOptimize(stress.data());
    transform_all(fft, of_plane, strain, rows, spectrum, stress);
    const double once = std::chrono::duration<double>(end - begin).count();
    bare += std::chrono::duration<double>(Clock::now() - end).count();
    seconds += once;
    state.SetIterationTime(once);
  }
  state.counters["over_transforms"] = seconds / bare;
  state.counters["ns_per_cell"] =
      1e9 * seconds / (static_cast<double>(state.iterations()) * static_cast<double>(grid.size()));
  state.counters["bytes_per_cell"] = memory / static_cast<double>(grid.size());
}

void residual_stress(benchmark::State& state)
{
  const VolumeGrid grid = refined_grid(static_cast<int>(state.range(0)));
  evaluate(state, grid);
  state.SetComplexityN(static_cast<benchmark::IterationCount>(grid.size()));
}
BENCHMARK(residual_stress)
    ->Arg(1)
    ->Arg(2)
    ->Arg(4)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);

/// Of a body whose two sides are mirror images: half of it is read and written.
void symmetric_residual_stress(benchmark::State& state)
{
  VolumeGrid grid = refined_grid(static_cast<int>(state.range(0)));
  grid.surface.is_mirrored_y = true;
  evaluate(state, grid);
}
BENCHMARK(symmetric_residual_stress)->Arg(1)->Arg(2)->Arg(4)->UseManualTime()->Unit(benchmark::kMillisecond);

/// Powers of two in every direction: strides that fall into few sets of the caches.
void residual_stress_of_powers(benchmark::State& state)
{
  evaluate(state, {{static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), 1e-5, 1e-5},
                   static_cast<int>(state.range(2)),
                   1e-5});
}
BENCHMARK(residual_stress_of_powers)
    ->ArgNames({"nx", "ny", "nz"})
    ->Args({256, 128, 64})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// Tabulating the coefficients, once per run.
void planning(benchmark::State& state)
{
  const VolumeGrid grid = refined_grid(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    const halfspace::HalfSpace half_space(grid, {200e9, 0.32});
    benchmark::DoNotOptimize(&half_space);
  }
}
BENCHMARK(planning)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);

} // namespace
