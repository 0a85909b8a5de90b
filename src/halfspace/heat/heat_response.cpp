// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/heat_response.hpp"

#include "brinell/green/spread_cell.hpp"
#include "foundation/fft.hpp"
#include "foundation/require_size.hpp"
#include "heat_quadrature.hpp"
#include "open_heat_memory.hpp"
#include "require_thermal.hpp"
#include "steady_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace brinell::halfspace
{

namespace
{

/// Spreading along one axis of the heat that a cell received at one time before the end, at the centres of all cells of the
/// padded length.
struct SpreadAlong
{
  int cells, length;
  double size, velocity;
  bool is_periodic;

  void at(double time, double spread, std::vector<double>& values) const
  {
    const double half = 0.5 * size, period = cells * size;
    for (int i = 0; i < length; ++i)
    {
      // The centre of the cell was velocity * time further back. Offsets beyond the grid are negative ones, wrapped.
      const int offset = i < cells ? i : i - length;
      const double x = offset * size + velocity * time;
      double& value = values[static_cast<std::size_t>(i)];
      if (is_periodic)
        value = green::spread_cells(x, half, spread, period);
      else
        value = offset > -cells ? green::spread_cell(x, half, spread) : 0.0;
    }
  }
};

} // namespace

struct HeatResponse::Operator
{
  PaddedFft fft;
  AlignedVector<Complex> spectrum;

  Operator(const SurfaceGrid& grid, const Thermal& thermal, const HeatMotion& motion)
      : fft(grid), spectrum(fft.forward_padded(tabulate(thermal, motion)))
  {
  }

  Operator(const Operator& one, const Operator& other) : fft(one.fft.grid()), spectrum(one.spectrum)
  {
    for (std::size_t i = 0; i < spectrum.size(); ++i)
      spectrum[i] += other.spectrum[i];
  }

  /// Temperature by a unit flux through one cell [K m^2/W].
  [[nodiscard]] AlignedVector<double> tabulate(const Thermal& thermal, const HeatMotion& motion) const
  {
    const SurfaceGrid& g = fft.grid();
    const double diffusivity = thermal.diffusivity();
    const double factor = std::sqrt(diffusivity * std::numbers::inv_pi) / thermal.conductivity;
    const std::vector<PastTime> times = past_times(g, diffusivity, motion);
    const auto px = static_cast<std::size_t>(fft.px()), py = static_cast<std::size_t>(fft.py());
    const SpreadAlong along_x{g.nx, fft.px(), g.dx, motion.velocity_x, g.is_periodic_x()};
    const SpreadAlong along_y{g.ny, fft.py(), g.dy, motion.velocity_y, g.is_periodic_y()};
    AlignedVector<double> response(px * py);
    std::vector<double> of_x(px), of_y(py);
    for (const PastTime& past : times)
    {
      const double spread = std::sqrt(4.0 * diffusivity * past.time);
      along_x.at(past.time, spread, of_x);
      along_y.at(past.time, spread, of_y);
      for (std::size_t j = 0; j < py; ++j)
      {
        const double weight = factor * past.weight * of_y[j];
        if (weight == 0.0)
          continue; // the heat has not reached this row
        double* row = response.data() + j * px;
#pragma omp simd
        for (std::size_t i = 0; i < px; ++i)
          row[i] += weight * of_x[i];
      }
    }
    return response;
  }
};

struct HeatResponse::Buffers
{
  AlignedVector<Complex> spectrum;
};

HeatResponse::HeatResponse(const SurfaceGrid& grid, const Thermal& thermal, const HeatMotion& motion)
{
  require_thermal("HeatResponse", thermal);
  if (!(motion.duration > 0.0) || !std::isfinite(motion.velocity_x) || !std::isfinite(motion.velocity_y))
    throw InputError(fmt::format("HeatResponse: a duration of {} s at {} and {} m/s; allowed: a duration above 0 and "
                                 "finite velocities",
                                 motion.duration, motion.velocity_x, motion.velocity_y));
  require_along_x("HeatResponse", grid, motion);
  const bool stays =
      (grid.is_periodic_x() || motion.velocity_x == 0.0) && (grid.is_periodic_y() || motion.velocity_y == 0.0);
  if (std::isinf(motion.duration) && (grid.is_periodic_x() || grid.is_periodic_y()) && stays)
    throw InputError(
        "HeatResponse: there is no steady state of a body that is heated all along a periodic axis by a flux "
        "that never leaves; allowed: a duration, a velocity across the period, or open axes");
  operator_ = make_hidden<Operator>(grid, thermal, motion);
}

namespace
{

double longer_side(const SurfaceGrid& grid)
{
  return grid.ny == 1 && grid.is_periodic_y() ? grid.dx : std::max(grid.dx, grid.dy);
}

/// Cells of the excess: those between any two cells of a grid, along each axis by so many smaller ones.
struct ExcessCells
{
  SurfaceGrid grid;
  int finer, finer_y;
};

ExcessCells offsets_of(const SurfaceGrid& grid, const ThermalStack& thermal, bool moves_across)
{
  // The shortest waves of the cells should not reach the next layer.
  const int finer = thermal.thickness_of_first() < longer_side(grid) ? 3 : 1, finer_y = grid.ny == 1 ? 1 : finer;
  SurfaceGrid offsets = grid;
  offsets.nx = finer * (grid.is_periodic_x() ? grid.nx : 2 * grid.nx - 1);
  offsets.ny = finer_y * (grid.is_periodic_y() ? grid.ny : 2 * grid.ny - 1);
  offsets.dx = grid.dx / finer;
  offsets.dy = grid.dy / finer_y;
  offsets.is_mirrored_y = !grid.is_periodic_y() && !moves_across;
  return {offsets, finer, finer_y};
}

WantedOfHeat wanted_of_excess(const ThermalStack& thermal)
{
  WantedOfHeat wanted;
  wanted.coat = CoatOfBody{thermal, {}, HeatCoat::Surface::excess, {}};
  return wanted;
}

/// Excess of a coated body at all offsets between cells, by a unit flux through one cell.
std::vector<double> excess_of_cell(const SurfaceGrid& grid, const ThermalStack& thermal, const HeatMotion& motion)
{
  const auto [offsets, finer, finer_y] = offsets_of(grid, thermal, motion.velocity_y != 0.0);
  std::vector<double> flux(offsets.size()), temperature(offsets.size());
  const int first_x = finer * (grid.is_periodic_x() ? 0 : grid.nx - 1),
            first_y = finer_y * (grid.is_periodic_y() ? 0 : grid.ny - 1);
  for (int j = 0; j < finer_y; ++j)
    for (int i = 0; i < finer; ++i)
      flux[offsets.index(first_x + i, first_y + j)] = 1.0;
  OpenHeatMemory memory("HeatResponse", offsets, HeatCoat::of_memory(thermal), {motion.duration, motion.duration},
                        wanted_of_excess(thermal));
  memory.add_step("HeatResponse", flux, motion);
  memory.present_excess(temperature);
  std::vector<double> result;
  result.reserve(offsets.size() / static_cast<std::size_t>(finer * finer_y));
  for (int j = finer_y / 2; j < offsets.ny; j += finer_y)
    for (int i = finer / 2; i < offsets.nx; i += finer)
      result.push_back(temperature[offsets.index(i, j)]);
  return result;
}

} // namespace

double memory_of_response(const SurfaceGrid& grid, const ThermalStack& thermal, double duration)
{
  if (thermal.is_homogeneous() || std::isinf(thermal.thickness_of_first()))
    return 0.0;
  const ExcessCells offsets = offsets_of(grid, thermal, false);
  return memory_of_heat(offsets.grid, HeatCoat::of_memory(thermal), {duration, duration}, wanted_of_excess(thermal),
                        false);
}

void require_resolved(const SurfaceGrid& grid, const ThermalStack& stack)
{
  constexpr double least = 0.25; // of a cell
  const double cell = longer_side(grid), thickness = stack.thickness_of_first();
  if (!stack.is_homogeneous() && thickness < least * cell)
    throw InputError(fmt::format("the first layer that conducts is {:.4g} m thick on cells of {:.4g} m along the "
                                 "surface; allowed: a thickness of {:.4g} m at least, or smaller cells",
                                 thickness, cell, least * cell));
}

HeatResponse::HeatResponse(const SurfaceGrid& grid, const ThermalStack& thermal, const HeatMotion& motion)
    : HeatResponse(grid, thermal.top(), motion)
{
  require_thermal("HeatResponse", thermal);
  if (std::isinf(thermal.thickness_of_first()) || thermal.is_homogeneous())
    return;
  require_resolved(grid, thermal);
  if (std::isinf(motion.duration))
    throw InputError("HeatResponse: a coated body that is heated for ever; allowed: a finite duration");
  const AlignedVector<Complex> excess = spectrum_of_offsets(operator_->fft, excess_of_cell(grid, thermal, motion));
  for (std::size_t i = 0; i < excess.size(); ++i)
    operator_->spectrum[i] += excess[i];
}

HeatResponse::HeatResponse(Hidden<Operator> given) : operator_(std::move(given)) {}

HeatResponse HeatResponse::of_both(const HeatResponse& one, const HeatResponse& other)
{
  if (one.grid() != other.grid())
    throw InputError("HeatResponse::of_both: the responses are on different grids");
  return HeatResponse(make_hidden<Operator>(*one.operator_, *other.operator_));
}

const SurfaceGrid& HeatResponse::grid() const
{
  return operator_->fft.grid();
}

HeatResponse::Scratch HeatResponse::make_scratch() const
{
  auto buffers = make_hidden<Buffers>();
  buffers->spectrum.resize(operator_->fft.plane());
  return buffers;
}

void HeatResponse::apply(std::span<const double> flux, std::span<double> temperature, Scratch& scratch) const
{
  require_size("HeatResponse::apply: the flux", flux, grid().size());
  require_size("HeatResponse::apply: the temperature", temperature, grid().size());
  Buffers& buffers = *scratch;
  operator_->fft.forward(flux, buffers.spectrum.data());
  for (std::size_t i = 0; i < buffers.spectrum.size(); ++i)
    buffers.spectrum[i] *= operator_->spectrum[i];
  operator_->fft.inverse(buffers.spectrum.data(), temperature);
}

} // namespace brinell::halfspace
