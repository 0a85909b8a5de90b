// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/thermal_response.hpp"

#include "brinell/halfspace/thermal_field.hpp"
#include "foundation/fft.hpp"
#include "foundation/require_size.hpp"

namespace brinell::halfspace
{

namespace
{

/// The offsets between the cells of one axis, as cells of a grid of their own.
struct Offsets
{
  int cells, count, middle;

  Offsets(int cells_of_grid, bool is_periodic)
      : cells(cells_of_grid), count(is_periodic ? cells_of_grid : 2 * cells_of_grid - 1),
        middle(is_periodic ? 0 : cells_of_grid - 1)
  {
  }
  /// Where the cell with the number n among offsets is in a transform of this length.
  [[nodiscard]] int wrapped(int n, int length) const { return n >= middle ? n - middle : n - middle + length; }
};

} // namespace

struct ThermalResponse::Operator
{
  PaddedFft fft;
  AlignedVector<Complex> spectrum;

  Operator(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic, const HeatMotion& motion)
      : fft(grid), spectrum(fft.plane())
  {
    const Offsets x(grid.nx, grid.is_periodic_x()), y(grid.ny, grid.is_periodic_y());
    SurfaceGrid offsets = grid;
    offsets.nx = x.count;
    offsets.ny = y.count;
    std::vector<double> flux(offsets.size()), displacement(offsets.size());
    flux[offsets.index(x.middle, y.middle)] = 1.0;
    ThermalField field(offsets, thermal, elastic, {motion.duration, motion.duration});
    field.take_up(flux, motion);
    field.displacement({displacement, {}, {}});

    AlignedVector<double> response(static_cast<std::size_t>(fft.px()) * static_cast<std::size_t>(fft.py()));
    for (int j = 0; j < y.count; ++j)
      for (int i = 0; i < x.count; ++i)
        response[static_cast<std::size_t>(y.wrapped(j, fft.py())) * static_cast<std::size_t>(fft.px()) +
                 static_cast<std::size_t>(x.wrapped(i, fft.px()))] = displacement[offsets.index(i, j)];
    fft.forward_padded(response, spectrum.data());
  }
};

struct ThermalResponse::Buffers
{
  AlignedVector<double> rows;
  AlignedVector<Complex> spectrum;
};

ThermalResponse::ThermalResponse(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic,
                                 const HeatMotion& motion)
    : operator_(make_hidden<Operator>(grid, thermal, elastic, motion))
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
