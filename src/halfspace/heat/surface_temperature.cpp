// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/surface_temperature.hpp"

#include "open_heat_memory.hpp"

namespace brinell::halfspace
{

struct SurfaceTemperature::State
{
  OpenHeatMemory memory;
};

SurfaceTemperature::SurfaceTemperature(const SurfaceGrid& grid, const Thermal& thermal, const HeatTimes& times)
    : state_(make_hidden<State>(OpenHeatMemory("SurfaceTemperature", grid, thermal, times, {})))
{
}

const SurfaceGrid& SurfaceTemperature::grid() const
{
  return state_->memory.grid();
}

double SurfaceTemperature::time() const
{
  return state_->memory.time();
}

void SurfaceTemperature::remaining(double duration, std::span<double> temperature) const
{
  state_->memory.remaining("SurfaceTemperature::remaining", duration, temperature);
}

void SurfaceTemperature::add_step(std::span<const double> flux, const HeatMotion& motion)
{
  state_->memory.add_step("SurfaceTemperature::add_step", flux, motion);
}

} // namespace brinell::halfspace
