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
constexpr std::array<Parity, excess::count> parities_of_excess{
    {{false, false}, {false, false}, {false, false}, {true, true}, {true, false}, {false, true}}};

} // namespace

Tractions::Tractions(const SurfaceGrid& grid, const green::PairConstants& constants, double reference,
                     const std::vector<LayeredBody>& layered)
    : constants_(constants), product_(grid, padded_lengths(grid), {false, false, true}), terms_(product_.fft())
{
  const PaddedFft padded(grid);
  if (grid.is_periodic())
    tabulate_waves(padded);
  else
    tabulate_cells(padded, reference);
  if (!layered.empty())
    tabulate_excess(padded, reference, layered);
  for (int row = 0; row < terms_.rows(); ++row)
    for (int i = 0; i < padded.kx(); ++i)
    {
      const Terms& term = terms_.of_column(row, i);
      const auto lane = static_cast<std::size_t>(i % lane_count);
      ShearWave wave = ShearWave::of_terms(term[xx][lane], term[yy][lane], term[xy][lane], constants);
      if (excess_)
      {
        const Excess& more = excess_->of_column(row, i);
        wave.xx += more[excess::xx][lane];
        wave.yy += more[excess::yy][lane];
        wave.xy += more[excess::xy][lane];
      }
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

void Tractions::tabulate_excess(const PaddedFft& padded, double reference, const std::vector<LayeredBody>& layered)
{
  excess_.emplace(product_.fft());
  const auto store = [&](std::size_t t)
  {
    return [this, t](int row, int column, double number)
    { excess_->of_column(row, column)[t][column % lane_count] = number; };
  };
  if (!padded.grid().is_periodic())
  {
    const Quadrant<SurfaceExcess> response = excess_surface(padded.grid(), layered, reference);
    for (std::size_t t = 0; t < excess::count; ++t)
      parity_spectrum(
          padded, parities_of_excess[t], [&](int i, int j) { return response.at(i, j)[t]; }, store(t));
    return;
  }
  for (int row = 0; row < excess_->rows(); ++row)
    for (int i = row == 0 ? 1 : 0; i < padded.kx(); ++i)
    {
      const SurfaceExcess value = excess_wave(layered, padded.wavenumber_x(i), padded.wavenumber_y(row));
      for (std::size_t t = 0; t < excess::count; ++t)
      {
        const auto [odd_x, odd_y] = parities_of_excess[t];
        const bool is_resolved = !(odd_x && 2 * i == padded.px()) && !(odd_y && 2 * row == padded.py());
        store(t)(row, i, is_resolved ? value[t] : 0.0);
      }
    }
}

void Tractions::add_excess(const Excess& more, int row, const Product::Values& load,
                           Product::Values& displacement) const
{
  const auto& [pressure, shear_x, shear_y] = load;
  const auto times = [&](std::size_t t, const ComplexLanes& value)
  { return more[t] * parities_of_excess[t].phased(row, product_.fft().py(), value); };
  auto& [z, x, y] = displacement;
  z = z + times(excess::zz, pressure) + times(excess::x, shear_x) + times(excess::y, shear_y);
  x = x + times(excess::xx, shear_x) + times(excess::xy, shear_y) - times(excess::x, pressure);
  y = y + times(excess::xy, shear_x) + times(excess::yy, shear_y) - times(excess::y, pressure);
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
  const auto product_of_layered = [&](int block)
  {
    return [this, terms = terms_.of_block(block), more = excess_->of_block(block)](int row,
                                                                                   const Product::Values& tractions)
    {
      Product::Values sum = displaced(terms[row], row, tractions);
      add_excess(more[row], row, tractions, sum);
      return sum;
    };
  };
  const Product::In in{load.pressure, load.shear_x, load.shear_y};
  const Product::Out out{displacement.z, displacement.x, displacement.y};
  if (excess_)
    product_.apply(in, out, scratch, product_of_layered);
  else
    product_.apply(in, out, scratch, product);
}

} // namespace brinell::halfspace
