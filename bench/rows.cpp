// SPDX-License-Identifier: BSD-3-Clause
// What do the transforms of the rows of a surface cost, of one alone (plane strain) and of several together?
#include "foundation/row_fft.hpp"

#include <benchmark/benchmark.h>

#include <vector>

namespace
{

using namespace brinell;

/// There and back, half of the length being zero padding.
void rows(benchmark::State& state)
{
  const int length = static_cast<int>(state.range(0)), count = static_cast<int>(state.range(1)), given = length / 2;
  const RowFft fft(given, length);
  RowFft::Work work = fft.make_work();
  std::vector<double> field(static_cast<std::size_t>(given) * static_cast<std::size_t>(count), 1.0);
  AlignedVector<ComplexLanes> spectra(static_cast<std::size_t>(fft.blocks()) * static_cast<std::size_t>(count));
  const RowFft::Spectra layout{count, false};
  for (auto _ : state)
  {
    fft.forward(field.data(), count, spectra.data(), layout, work);
    fft.inverse(spectra.data(), layout, count, 1.0 / length, field.data(), work);
    benchmark::DoNotOptimize(field.data());
  }
  state.counters["ns_per_row"] =
      benchmark::Counter(1e-9 * count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(rows)
    ->ArgNames({"length", "rows"})
    ->ArgsProduct({{90, 250, 512, 1000, 1024, 4096}, {1, RowFft::most_rows}})
    ->Unit(benchmark::kNanosecond);

} // namespace
