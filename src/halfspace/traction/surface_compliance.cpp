// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/surface_compliance.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/require_size.hpp"
#include "halfspace/transform/cell_response.hpp"
#include "halfspace/transform/kernel_places.hpp"
#include "halfspace/transform/require_surface.hpp"
#include "halfspace/transform/wave_product.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace brinell::halfspace
{

namespace
{

/// Spectrum for bodies that are periodic along both axes, row by row: 2 / (E' k), the displacement by a wave of unit pressure.
std::vector<double> wave_spectrum(const SurfaceGrid& grid, double contact_modulus)
{
  std::vector<double> spectrum;
  for (int row = 0; row <= grid.ny / 2; ++row)
    for (int i = 0; i <= grid.nx / 2; ++i)
    {
      const double k = 2.0 * std::numbers::pi * std::hypot(i / (grid.nx * grid.dx), row / (grid.ny * grid.dy));
      spectrum.push_back(k > 0.0 ? 2.0 / (contact_modulus * k) : 0.0);
    }
  return spectrum;
}

/// Reciprocals of a spectrum. A uniform pressure, whose compliance is zero, must be assigned a stiffness: restricted to a nearly
/// full contact, its compliance is that of the open spots, much less than that of any wave on the grid.
std::vector<double> inverse(std::vector<double> spectrum)
{
  // Of the values 1, 1/4, 1/16, 1/64 and 1/1000, this one needs the fewest iterations over all contact areas.
  constexpr double share = 1.0 / 64.0;
  const double uniform = share * *std::max_element(spectrum.begin(), spectrum.end());
  for (double& response : spectrum)
    response = 1.0 / (response > 0.0 ? response : uniform);
  return spectrum;
}

/// Spectra of the operator and of its approximate inverse, row by row.
struct Spectra
{
  std::vector<double> compliance; ///< [m/Pa]
  std::vector<double> stiffness;  ///< [Pa/m]
};

Spectra spectra(const SurfaceGrid& grid, const SurfaceGrid& larger, double modulus, double reference)
{
  if (grid.is_periodic())
  {
    std::vector<double> waves = wave_spectrum(grid, modulus);
    return {waves, inverse(waves)};
  }
  const Quadrant<double> response = cell_displacement(larger, reference);
  const auto displacement = [&](int i, int j) { return response.at(i, j) / (std::numbers::pi * modulus); };
  return {spectrum_of(grid, KernelPlaces::padded(grid), displacement),
          inverse(spectrum_of(larger, KernelPlaces::periodic(larger), displacement))};
}

} // namespace

struct SurfaceCompliance::Buffers
{
  WaveProduct<1>::Scratch compliance, stiffness;
};

namespace
{

/// A product with a real and even spectrum.
struct EvenProduct
{
  WaveProduct<1> waves;
  WaveTable<Lanes> factors;

  /// @param spectrum  row by row
  EvenProduct(const SurfaceGrid& grid, const PaddedLengths& lengths, const std::vector<double>& spectrum)
      : waves(grid, lengths), factors(waves.fft())
  {
    const double* factor = spectrum.data();
    for (int row = 0; row < factors.rows(); ++row)
      for (int i = 0; i < waves.fft().kx(); ++i, ++factor)
        factors.of_column(row, i)[i % lane_count] = *factor;
  }

  void apply(std::span<const double> in, std::span<double> out, WaveProduct<1>::Scratch& scratch) const
  {
    waves.apply({in}, {out}, scratch,
                [this](int block)
                {
                  return [factor = factors.of_block(block)](int row, const WaveProduct<1>::Values& values)
                  { return WaveProduct<1>::Values{factor[row] * values[0]}; };
                });
  }
};

} // namespace

struct SurfaceCompliance::Operator
{
  SurfaceGrid larger;     ///< on which the stiffness is periodic
  double contact_modulus; ///< E' [Pa]
  double reference;       ///< [m]
  EvenProduct compliance, stiffness;
  double largest; ///< [m/Pa]

  Operator(const SurfaceGrid& grid, double modulus, double reference_distance)
      : Operator(grid, with_fast_lengths(grid), modulus, reference_distance,
                 spectra(grid, with_fast_lengths(grid), modulus, reference_distance))
  {
  }

private:
  Operator(const SurfaceGrid& grid, const SurfaceGrid& larger_grid, double modulus, double reference_distance,
           const Spectra& of)
      : larger(larger_grid), contact_modulus(modulus), reference(reference_distance),
        compliance(grid, padded_lengths(grid), of.compliance), stiffness(grid, {larger.nx, larger.ny}, of.stiffness),
        largest(*std::max_element(of.compliance.begin(), of.compliance.end()))
  {
  }
};

SurfaceCompliance::SurfaceCompliance(const SurfaceGrid& grid, double contact_modulus, double reference)
{
  if (grid.is_periodic_x() != grid.is_periodic_y() && !(reference > 0.0))
    throw InternalError("SurfaceCompliance: with one periodic axis the displacement needs a reference distance, > 0");
  if (grid.is_periodic() && grid.size() == 1)
    throw InputError("a surface grid of 1 x 1 cells that is periodic along both axes can only carry a uniform "
                     "pressure, which causes no displacement; allowed: more than one cell along x or y");
  operator_ = make_hidden<Operator>(grid, contact_modulus, reference);
}

const SurfaceGrid& SurfaceCompliance::grid() const
{
  return operator_->compliance.waves.fft().grid();
}

SurfaceCompliance SurfaceCompliance::on(const SurfaceGrid& grid) const
{
  return {grid, operator_->contact_modulus, operator_->reference};
}

double SurfaceCompliance::largest() const
{
  return operator_->largest;
}

SurfaceCompliance::Scratch SurfaceCompliance::make_scratch() const
{
  return make_hidden<Buffers>(operator_->compliance.waves.make_scratch(), operator_->stiffness.waves.make_scratch());
}

void SurfaceCompliance::apply(const SurfaceLoad& load, const SurfaceDisplacement& displacement, Scratch& scratch) const
{
  require_load("SurfaceCompliance::apply", load, grid().size());
  require_displacement("SurfaceCompliance::apply", displacement, grid().size());
  if (!load.shear_x.empty() || !load.shear_y.empty() || !displacement.x.empty() || !displacement.y.empty())
    throw InternalError(
        "SurfaceCompliance::apply: shears and displacements along the surface are those of TractionCompliance");
  if (!operator_->compliance.waves.fits(scratch->compliance))
    throw InternalError("SurfaceCompliance::apply: the scratch is of another operator; make_scratch makes one");
  if (load.pressure.empty())
    return std::fill(displacement.z.begin(), displacement.z.end(), 0.0);
  operator_->compliance.apply(load.pressure, displacement.z, scratch->compliance);
}

void SurfaceCompliance::apply_inverse(std::span<const double> displacement, std::span<double> pressure,
                                      Scratch& scratch) const
{
  require_size("SurfaceCompliance::apply_inverse: the displacement", displacement, grid().size());
  require_size("SurfaceCompliance::apply_inverse: the pressure", pressure, grid().size());
  if (!operator_->stiffness.waves.fits(scratch->stiffness))
    throw InternalError("SurfaceCompliance::apply_inverse: the scratch is of another operator; make_scratch makes one");
  operator_->stiffness.apply(displacement, pressure, scratch->stiffness);
}

} // namespace brinell::halfspace
