// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/traction_compliance.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/green/surface_terms.hpp"
#include "halfspace/transform/parity_spectrum.hpp"
#include "halfspace/transform/require_surface.hpp"
#include "halfspace/transform/wave_product.hpp"
#include "shear_stiffness.hpp"
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

/// The displacement along z, x and y of a pressure and the shears along x and y.
using Product = WaveProduct<3>;
using Triple = Product::Values;
/// Spectra of the terms for `lane_count` wavenumbers: real or imaginary parts, according to their parities.
using Terms = std::array<Lanes, term_count>;

} // namespace

struct TractionCompliance::Operator
{
  green::PairConstants constants;
  double reference;
  Product product;
  WaveTable<Terms> terms;
  ShearStiffness stiffness;
  double largest_of_shear = 0.0; ///< [m/Pa]

  Operator(const SurfaceGrid& grid, const green::PairConstants& pair, double at)
      : constants(pair), reference(at), product(grid, padded_lengths(grid), {false, false, true}), terms(product.fft()),
        stiffness(grid, pair, reference)
  {
    const PaddedFft padded(grid);
    if (grid.is_periodic())
      tabulate_waves(padded);
    else
      tabulate_cells(padded);
    for (int row = 0; row < terms.rows(); ++row)
      for (int i = 0; i < padded.kx(); ++i)
        largest_of_shear = std::max(largest_of_shear, shear_wave(row, i).largest());
  }

  [[nodiscard]] ShearWave shear_wave(int row, int column)
  {
    const Terms& term = terms.of_column(row, column);
    const auto lane = static_cast<std::size_t>(column % lane_count);
    return ShearWave::of_terms(term[xx][lane], term[yy][lane], term[xy][lane], constants);
  }

  void tabulate_cells(const PaddedFft& padded)
  {
    const Quadrant<green::SurfaceTerms> response = cell_surface_terms(padded.grid(), reference);
    for (std::size_t t = 0; t < term_count; ++t)
      parity_spectrum(
          padded, parities[t], [&](int i, int j) { return response.at(i, j)[t]; },
          [&](int row, int column, double number) { terms.of_column(row, column)[t][column % lane_count] = number; });
  }

  void tabulate_waves(const PaddedFft& padded)
  {
    for (int row = 0; row < terms.rows(); ++row)
      for (int i = row == 0 ? 1 : 0; i < padded.kx(); ++i) // uniform tractions cause no displacement
      {
        const green::SurfaceTerms value = green::surface_wave_terms(padded.wavenumber_x(i), padded.wavenumber_y(row));
        for (std::size_t t = 0; t < term_count; ++t)
        {
          // At the Nyquist wave an odd function cannot be represented on the grid.
          const bool is_resolved =
              !(parities[t].odd_x && 2 * i == padded.px()) && !(parities[t].odd_y && 2 * row == padded.py());
          terms.of_column(row, i)[t][i % lane_count] = is_resolved ? value[t] : 0.0;
        }
      }
  }

  [[nodiscard]] Triple displaced(const Terms& term, int row, const Triple& load) const
  {
    const auto& [pressure, shear_x, shear_y] = load;
    const auto times = [&](std::size_t t, double factor, const ComplexLanes& value)
    { return (factor * term[t]) * parities[t].phased(row, product.fft().py(), value); };
    const Lanes inverse_distance = constants.normal * (term[xx] + term[yy]);
    const double along = constants.along, coupling = constants.coupling;
    return {inverse_distance * pressure + times(x, coupling, shear_x) + times(y, coupling, shear_y),
            inverse_distance * shear_x + times(xx, along, shear_x) + times(xy, along, shear_y) -
                times(x, coupling, pressure),
            inverse_distance * shear_y + times(xy, along, shear_x) + times(yy, along, shear_y) -
                times(y, coupling, pressure)};
  }
};

struct TractionCompliance::Buffers
{
  Product::Scratch tractions;
  ShearStiffness::Scratch stiffness;
};

TractionCompliance::TractionCompliance(const SurfaceGrid& grid, const Elastic& body1, const Elastic& body2,
                                       double reference)
{
  if (grid.is_periodic_x() != grid.is_periodic_y() && !(reference > 0.0))
    throw InternalError("TractionCompliance: with one periodic axis the displacement needs a reference distance, > 0");
  operator_ = make_hidden<Operator>(grid, green::pair_constants(body1, body2), reference);
}

TractionCompliance TractionCompliance::on(const SurfaceGrid& grid) const
{
  return TractionCompliance(make_hidden<Operator>(grid, operator_->constants, operator_->reference));
}

const SurfaceGrid& TractionCompliance::grid() const
{
  return operator_->product.fft().grid();
}

TractionCompliance::Scratch TractionCompliance::make_scratch() const
{
  return make_hidden<Buffers>(operator_->product.make_scratch(), operator_->stiffness.make_scratch());
}

bool TractionCompliance::couples() const
{
  return operator_->constants.coupling != 0.0;
}

double TractionCompliance::along_over_across() const
{
  return 1.0 + operator_->constants.along / operator_->constants.normal;
}

double TractionCompliance::largest_of_shear() const
{
  return operator_->largest_of_shear;
}

double TractionCompliance::stiffness_of_cell() const
{
  return operator_->stiffness.of_one_cell();
}

void TractionCompliance::apply(const SurfaceLoad& load, const SurfaceDisplacement& displacement, Scratch& scratch) const
{
  require_load("TractionCompliance::apply", load, grid().size());
  require_displacement("TractionCompliance::apply", displacement, grid().size());
  if (!operator_->product.fits(scratch->tractions))
    throw InternalError("TractionCompliance::apply: the scratch is of another operator; make_scratch makes one");
  const auto product = [&](int block)
  {
    return [&, terms = operator_->terms.of_block(block)](int row, const Triple& tractions)
    { return operator_->displaced(terms[row], row, tractions); };
  };
  operator_->product.apply({load.pressure, load.shear_x, load.shear_y},
                           {displacement.z, displacement.x, displacement.y}, scratch->tractions, product);
}

void TractionCompliance::apply(const SurfaceLoad& load, const SurfaceDisplacement& displacement) const
{
  Scratch scratch = make_scratch();
  apply(load, displacement, scratch);
}

void TractionCompliance::apply_inverse(const Pair<std::span<const double>>& displacement,
                                       const Pair<std::span<double>>& shear, Scratch& scratch, double added) const
{
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    require_size("TractionCompliance::apply_inverse: the displacement", displacement[axis], grid().size());
    require_size("TractionCompliance::apply_inverse: the shear", shear[axis], grid().size());
  }
  if (!operator_->stiffness.fits(scratch->stiffness))
    throw InternalError(
        "TractionCompliance::apply_inverse: the scratch is of another operator; make_scratch makes one");
  operator_->stiffness.apply(displacement, shear, scratch->stiffness, added);
}

} // namespace brinell::halfspace
