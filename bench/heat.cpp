// SPDX-License-Identifier: BSD-3-Clause
// What does the heat of one body cost in a step, and does that grow with the steps that are done?
#include "brinell/foundation/deviator.hpp"
#include "brinell/halfspace/thermal_field.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

namespace
{

using namespace brinell;

constexpr Thermal steel{50.0, 7800.0, 470.0, 1.2e-5};

/// The heat of a body of cases/tugging-heat: 59 x 19 cells, 30 layers, a contact that moves by a cell in a step.
class HeatedBody
{
public:
  HeatedBody(int steps, bool is_mirrored)
      : grid_{.nx = 59, .ny = 19, .dx = 2.63e-5, .dy = 5.26e-5, .is_mirrored_y = is_mirrored}, motion_{grid_.dx / 1.0,
                                                                                                       1.0},
        field_(grid_, steel, {200e9, 0.32}, {motion_.duration, steps * motion_.duration}, depths(),
               halfspace::HeatImages::coarse),
        flux_(grid_.size()), surface_(grid_.size()), stress_(layers * Deviator::size * grid_.size())
  {
    for (int j = 0; j < grid_.ny; ++j)
      for (int i = 0; i < grid_.nx; ++i)
        flux_[grid_.index(i, j)] =
            1e8 * std::max(0.0, 1.0 - std::hypot(grid_.x(i) / (5.0 * grid_.dx), grid_.y(j) / (3.0 * grid_.dy)));
    for (std::size_t k = 0; k < layers; ++k)
      out_.push_back(
          {{}, std::span(stress_).subspan(k * Deviator::size * grid_.size(), Deviator::size * grid_.size()), {}});
  }

  /// All that an increment asks of it.
  void step()
  {
    if (field_.time() > 0.0)
    {
      field_.remaining_temperature(motion_.duration, surface_);
      field_.displacement({surface_, {}, {}}, motion_.duration);
    }
    field_.add_step(flux_, motion_, before_);
    field_.layers(0, out_);
    field_.add_to_last_step(flux_, motion_);
    field_.displacement({surface_, {}, {}});
  }

private:
  static constexpr std::size_t layers = 30;
  [[nodiscard]] static std::vector<double> depths()
  {
    std::vector<double> result;
    for (std::size_t k = 0; k < layers; ++k)
      result.push_back((static_cast<double>(k) + 0.5) * 1.315e-5);
    return result;
  }

  SurfaceGrid grid_;
  halfspace::HeatMotion motion_;
  halfspace::ThermalField field_;
  std::vector<double> flux_, surface_, stress_;
  std::vector<halfspace::ThermalLayer> out_;
  Hidden<halfspace::ThermalField::Heat> before_;
};

double processor_milliseconds()
{
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// So many steps; what one of the first ten takes, and one of the last ten.
void heated_steps(benchmark::State& state)
{
  const int steps = static_cast<int>(state.range(0));
  constexpr int some = 10;
  double first = 0.0, last = 0.0;
  for (auto _ : state)
  {
    state.PauseTiming();
    HeatedBody body(steps, state.range(1) != 0);
    state.ResumeTiming();
    double start = processor_milliseconds();
    for (int n = 0; n < steps; ++n)
    {
      if (n == steps - some)
        start = processor_milliseconds();
      body.step();
      if (n + 1 == some)
        first = processor_milliseconds() - start;
    }
    last = processor_milliseconds() - start;
  }
  state.counters["ms_per_step_first"] = first / some;
  state.counters["ms_per_step_last"] = last / some;
}
BENCHMARK(heated_steps)
    ->ArgNames({"steps", "one_side"})
    ->ArgsProduct({{20, 100, 500}, {0, 1}})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

} // namespace
