// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/thermal_response.hpp"

#include "brinell/halfspace/thermal_field.hpp"
#include "foundation/require_size.hpp"
#include "steady_displacement.hpp"

#include <cmath>

namespace brinell::halfspace
{

namespace
{

/// Displacement by a unit flux through one cell at all offsets, for a step of finite duration of an initially cold body.
std::vector<double> displacement_of_cell(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic,
                                         const HeatMotion& motion)
{
  SurfaceGrid offsets = grid;
  offsets.nx = grid.is_periodic_x() ? grid.nx : 2 * grid.nx - 1;
  offsets.ny = grid.is_periodic_y() ? grid.ny : 2 * grid.ny - 1;
  std::vector<double> flux(offsets.size()), displacement(offsets.size());
  flux[offsets.index(grid.is_periodic_x() ? 0 : grid.nx - 1, grid.is_periodic_y() ? 0 : grid.ny - 1)] = 1.0;
  // The heated cell is in the middle row, so the field is symmetric in y.
  const bool is_symmetric = !grid.is_periodic_y() && motion.velocity_y == 0.0;
  ThermalField field(offsets, thermal, elastic, {motion.duration, motion.duration}, {}, HeatImages::fine,
                     is_symmetric ? Symmetry::in_y : Symmetry::none);
  field.take_up(flux, motion);
  field.displacement({displacement, {}, {}});
  return displacement;
}

/// Likewise for a flux that has acted for an infinite time.
std::vector<double> steady_displacement_of_cell(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic,
                                                const HeatMotion& motion, std::optional<double> reference)
{
  const SteadyMotion steady{motion.velocity_x, reference};
  require_steady("ThermalResponse", grid, thermal, steady);
  if (motion.velocity_y != 0.0)
    throw InputError("ThermalResponse: a flux that has always been there moves along x; allowed: velocity_y = 0");
  return steady_displacement(SteadyLattices(grid, thermal, motion.velocity_x), thermal, elastic, steady);
}

} // namespace

struct ThermalResponse::Operator
{
  PaddedFft fft;
  AlignedVector<Complex> spectrum;

  Operator(const SurfaceGrid& grid, const std::vector<double>& offsets)
      : fft(grid), spectrum(spectrum_of_offsets(fft, offsets))
  {
  }
};

struct ThermalResponse::Buffers
{
  AlignedVector<double> rows;
  AlignedVector<Complex> spectrum;
};

ThermalResponse::ThermalResponse(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic,
                                 const HeatMotion& motion, std::optional<double> reference)
    : operator_(make_hidden<Operator>(grid, std::isinf(motion.duration)
                                                ? steady_displacement_of_cell(grid, thermal, elastic, motion, reference)
                                                : displacement_of_cell(grid, thermal, elastic, motion)))
{
}

const SurfaceGrid& ThermalResponse::grid() const
{
  return operator_->fft.grid();
}

ThermalResponse::Scratch ThermalResponse::make_scratch() const
{
  Scratch scratch = make_hidden<Buffers>();
  scratch->rows.resize(operator_->fft.scratch_size());
  scratch->spectrum.resize(operator_->fft.plane());
  return scratch;
}

void ThermalResponse::apply(std::span<const double> flux, std::span<double> displacement, Scratch& scratch) const
{
  require_size("ThermalResponse::apply: the flux", flux, grid().size());
  require_size("ThermalResponse::apply: the displacement", displacement, grid().size());
  operator_->fft.forward(flux.data(), scratch->spectrum.data(), scratch->rows);
  for (std::size_t i = 0; i < scratch->spectrum.size(); ++i)
    scratch->spectrum[i] *= operator_->spectrum[i];
  operator_->fft.inverse(scratch->spectrum.data(), displacement.data(), scratch->rows);
}

} // namespace brinell::halfspace
