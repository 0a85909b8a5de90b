// SPDX-License-Identifier: BSD-3-Clause
#include "tractions.hpp"

#include "halfspace/transform/cell_response.hpp"
#include "halfspace/transform/parity_spectrum.hpp"
#include "shear_waves.hpp"

#include <algorithm>

namespace brinell::halfspace
{

namespace
{

/// Indices into green::SurfaceTerms.
enum : std::size_t
{
  xx,
  yy,
  xy,
  x,
  y,
  term_count
};
constexpr std::array<Parity, term_count> parities{
    {{false, false}, {false, false}, {true, true}, {true, false}, {false, true}}};

} // namespace

Tractions::Tractions(const SurfaceGrid& grid, const green::PairConstants& constants, double reference)
    : constants_(constants), product_(grid, padded_lengths(grid), {false, false, true}), terms_(product_.fft())
{
  const PaddedFft padded(grid);
  if (grid.is_periodic())
    tabulate_waves(padded);
  else
    tabulate_cells(padded, reference);
  for (int row = 0; row < terms_.rows(); ++row)
    for (int i = 0; i < padded.kx(); ++i)
    {
      const Terms& term = terms_.of_column(row, i);
      const auto lane = static_cast<std::size_t>(i % lane_count);
      const ShearWave wave = ShearWave::of_terms(term[xx][lane], term[yy][lane], term[xy][lane], constants);
      largest_of_shear_ = std::max(largest_of_shear_, wave.largest());
    }
}

void Tractions::tabulate_cells(const PaddedFft& padded, double reference)
{
  const Quadrant<green::SurfaceTerms> response = cell_surface_terms(padded.grid(), reference);
  for (std::size_t t = 0; t < term_count; ++t)
    parity_spectrum(
        padded, parities[t], [&](int i, int j) { return response.at(i, j)[t]; },
        [&](int row, int column, double number) { terms_.of_column(row, column)[t][column % lane_count] = number; });
}

void Tractions::tabulate_waves(const PaddedFft& padded)
{
  for (int row = 0; row < terms_.rows(); ++row)
    for (int i = row == 0 ? 1 : 0; i < padded.kx(); ++i) // uniform tractions cause no displacement
    {
      const green::SurfaceTerms value = green::surface_wave_terms(padded.wavenumber_x(i), padded.wavenumber_y(row));
      for (std::size_t t = 0; t < term_count; ++t)
      {
        // At the Nyquist wave an odd function cannot be represented on the grid.
        const bool is_resolved =
            !(parities[t].odd_x && 2 * i == padded.px()) && !(parities[t].odd_y && 2 * row == padded.py());
        terms_.of_column(row, i)[t][i % lane_count] = is_resolved ? value[t] : 0.0;
      }
    }
}

Tractions::Product::Values Tractions::displaced(const Terms& term, int row, const Product::Values& load) const
{
  const auto& [pressure, shear_x, shear_y] = load;
  const auto times = [&](std::size_t t, double factor, const ComplexLanes& value)
  { return (factor * term[t]) * parities[t].phased(row, product_.fft().py(), value); };
  const Lanes inverse_distance = constants_.normal * (term[xx] + term[yy]);
  const double along = constants_.along, coupling = constants_.coupling;
  return {inverse_distance * pressure + times(x, coupling, shear_x) + times(y, coupling, shear_y),
          inverse_distance * shear_x + times(xx, along, shear_x) + times(xy, along, shear_y) -
              times(x, coupling, pressure),
          inverse_distance * shear_y + times(xy, along, shear_x) + times(yy, along, shear_y) -
              times(y, coupling, pressure)};
}

void Tractions::apply(const SurfaceLoad& load, const SurfaceDisplacement& displacement, Product::Scratch& scratch) const
{
  const auto product = [&](int block)
  {
    return [this, terms = terms_.of_block(block)](int row, const Product::Values& tractions)
    { return displaced(terms[row], row, tractions); };
  };
  product_.apply({load.pressure, load.shear_x, load.shear_y}, {displacement.z, displacement.x, displacement.y}, scratch,
                 product);
}

} // namespace brinell::halfspace
