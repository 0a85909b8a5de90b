// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/thermal_response.hpp"

#include "brinell/halfspace/thermal_field.hpp"
#include "foundation/require_size.hpp"
#include "halfspace/transform/require_surface.hpp"
#include "require_thermal.hpp"
#include "steady_displacement.hpp"

#include <array>
#include <cmath>

namespace brinell::halfspace
{

namespace
{

/// Displacements along z, x and y by a unit flux through one cell at all offsets; empty if they are not prepared.
using OfCell = std::array<std::vector<double>, 3>;

std::size_t parts_of(Displacements components)
{
  return components == Displacements::normal ? 1 : (components == Displacements::along_x ? 2 : 3);
}

/// For a step of finite duration of an initially cold body.
OfCell displacement_of_cell(const SurfaceGrid& grid, const ThermalStack& thermal, const ElasticStack& elastic,
                            const HeatMotion& motion, Displacements components)
{
  require_along_x("ThermalResponse", grid, motion);
  SurfaceGrid offsets = grid;
  offsets.nx = grid.is_periodic_x() ? grid.nx : 2 * grid.nx - 1;
  offsets.ny = grid.is_periodic_y() ? grid.ny : 2 * grid.ny - 1;
  std::vector<double> flux(offsets.size());
  OfCell displacement;
  for (std::size_t part = 0; part < parts_of(components); ++part)
    displacement[part].resize(offsets.size());
  flux[offsets.index(grid.is_periodic_x() ? 0 : grid.nx - 1, grid.is_periodic_y() ? 0 : grid.ny - 1)] = 1.0;
  // The heated cell is in the middle row, so both sides of it are mirror images.
  offsets.is_mirrored_y = !grid.is_periodic_y() && motion.velocity_y == 0.0;
  ThermalField field(offsets, thermal, elastic, {motion.duration, motion.duration}, {}, HeatImages::fine);
  field.add_step(flux, motion);
  field.displacement({displacement[0], displacement[1], displacement[2]});
  return displacement;
}

/// For a flux that has acted for an infinite time; the normal displacement only.
OfCell steady_displacement_of_cell(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic,
                                   const HeatMotion& motion, std::optional<double> reference, Displacements components)
{
  if (components != Displacements::normal)
    throw InternalError("ThermalResponse: of a flux that has always been there only the normal displacement is known");
  const SteadyMotion steady{motion.velocity_x, reference};
  require_steady("ThermalResponse", grid, thermal, steady);
  if (motion.velocity_y != 0.0)
    throw InputError("ThermalResponse: a flux that has always been there moves along x; allowed: velocity_y = 0");
  return {steady_displacement(SteadyLattices(grid, thermal, motion.velocity_x), thermal, elastic, steady), {}, {}};
}

} // namespace

struct ThermalResponse::Operator
{
  PaddedFft fft;
  std::array<AlignedVector<Complex>, 3> spectra; ///< of the displacements along z, x and y; empty: not prepared

  Operator(const SurfaceGrid& grid, const OfCell& displacement) : fft(grid)
  {
    for (std::size_t part = 0; part < spectra.size(); ++part)
      if (!displacement[part].empty())
        spectra[part] = spectrum_of_offsets(fft, displacement[part]);
  }
};

struct ThermalResponse::Buffers
{
  AlignedVector<Complex> flux, spectrum;
};

ThermalResponse::ThermalResponse(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic,
                                 const HeatMotion& motion, std::optional<double> reference, Displacements components)
    : operator_(make_hidden<Operator>(
          grid, std::isinf(motion.duration)
                    ? steady_displacement_of_cell(grid, thermal, elastic, motion, reference, components)
                    : displacement_of_cell(grid, ThermalStack{{}, thermal}, {{}, elastic}, motion, components)))
{
}

ThermalResponse::ThermalResponse(const SurfaceGrid& grid, const ThermalStack& thermal, const ElasticStack& elastic,
                                 const HeatMotion& motion, Displacements components)
{
  if (std::isinf(motion.duration) && !thermal.is_homogeneous())
    throw InputError("ThermalResponse: a coated body that is heated for ever; allowed: a finite duration");
  operator_ = make_hidden<Operator>(grid, displacement_of_cell(grid, thermal, elastic, motion, components));
}

const SurfaceGrid& ThermalResponse::grid() const
{
  return operator_->fft.grid();
}

ThermalResponse::Scratch ThermalResponse::make_scratch() const
{
  Scratch scratch = make_hidden<Buffers>();
  scratch->flux.resize(operator_->fft.plane());
  scratch->spectrum.resize(operator_->fft.plane());
  return scratch;
}

void ThermalResponse::apply(std::span<const double> flux, const SurfaceDisplacement& displacement,
                            Scratch& scratch) const
{
  require_size("ThermalResponse::apply: the flux", flux, grid().size());
  require_displacement("ThermalResponse::apply", displacement, grid().size());
  operator_->fft.forward(flux, scratch->flux.data());
  const std::array<std::span<double>, 3> out{displacement.z, displacement.x, displacement.y};
  for (std::size_t part = 0; part < out.size(); ++part)
  {
    if (out[part].empty())
      continue;
    const AlignedVector<Complex>& response = operator_->spectra[part];
    if (response.empty())
      throw InternalError("ThermalResponse::apply: a component of the displacement that is not prepared");
    for (std::size_t i = 0; i < response.size(); ++i)
      scratch->spectrum[i] = scratch->flux[i] * response[i];
    operator_->fft.inverse(scratch->spectrum.data(), out[part], part == 2);
  }
}

} // namespace brinell::halfspace
