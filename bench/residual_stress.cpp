// SPDX-License-Identifier: BSD-3-Clause
// How far is one residual-stress evaluation from its floor, the Fourier transforms of the same planes, and does its cost
// grow as N log N?
#include "brinell/halfspace/half_space.hpp"

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

/// 5 strains forward and 5 stresses back in every layer: what any route by layers has to pay.
void transform_all(const VolumeGrid& grid, const PaddedFft& fft, const std::vector<double>& strain,
                   AlignedVector<Complex>& spectra, std::vector<double>& stress)
{
  const std::size_t cells = grid.surface.size();
#pragma omp parallel
  {
    AlignedVector<double> scratch(fft.scratch_size());
#pragma omp for schedule(static)
    for (int plane = 0; plane < Deviator::size * grid.nz; ++plane)
      fft.forward(strain.data() + static_cast<std::size_t>(plane) * cells,
                  spectra.data() + static_cast<std::size_t>(plane) * fft.plane(), scratch);
#pragma omp for schedule(static)
    for (int plane = 0; plane < Deviator::size * grid.nz; ++plane)
      fft.inverse(spectra.data() + static_cast<std::size_t>(plane) * fft.plane(),
                  stress.data() + static_cast<std::size_t>(plane) * cells, scratch);
  }
}

void residual_stress(benchmark::State& state)
{
  using Clock = std::chrono::steady_clock;
  const VolumeGrid grid = refined_grid(static_cast<int>(state.range(0)));
  const double before = resident_bytes();
  const halfspace::HalfSpace half_space(grid, {200e9, 0.32});
  halfspace::HalfSpace::Work work = half_space.make_work();
  std::vector<double> strain(Deviator::size * grid.size());
  std::vector<double> stress(strain.size());
  std::vector<double> pressure(grid.surface.size(), 1e9);
  for (std::size_t i = 0; i < strain.size(); ++i)
    strain[i] = 1e-3 * std::sin(0.37 * static_cast<double>(i));
  // Evaluation and bare transforms by turns, so that both see the same machine.
  double seconds = 0.0;
  double bare = 0.0;
  AlignedVector<Complex> spectra(work.strain_hat.size());
  const double memory = resident_bytes() - before - static_cast<double>(spectra.size() * sizeof(Complex));
  for (auto _ : state)
  {
    const auto begin = Clock::now();
    half_space.load_strain(strain, grid.nz, work);
    half_space.deviatoric_stress(pressure, strain, grid.nz, work, stress);
    const auto end = Clock::now();
    benchmark::DoNotOptimize(stress.data());
    transform_all(grid, half_space.fft(), strain, spectra, stress);
    const double once = std::chrono::duration<double>(end - begin).count();
    bare += std::chrono::duration<double>(Clock::now() - end).count();
    seconds += once;
    state.SetIterationTime(once);
  }
  state.counters["over_transforms"] = seconds / bare;
  state.counters["ns_per_cell"] =
      1e9 * seconds / (static_cast<double>(state.iterations()) * static_cast<double>(grid.size()));
  state.counters["bytes_per_cell"] = memory / static_cast<double>(grid.size());
  state.SetComplexityN(static_cast<benchmark::IterationCount>(grid.size()));
}
BENCHMARK(residual_stress)
    ->Arg(1)
    ->Arg(2)
    ->Arg(4)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);

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
