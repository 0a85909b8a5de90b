// SPDX-License-Identifier: BSD-3-Clause
#include "shear_stiffness.hpp"

#include "foundation/fft.hpp"
#include "halfspace/transform/cell_response.hpp"
#include "halfspace/transform/kernel_places.hpp"
#include "shear_waves.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::halfspace
{

namespace
{

/// Compliance of all waves of the periodic operator, row by row.
std::vector<ShearWave> waves(const SurfaceGrid& grid, const green::PairConstants& constants, double reference,
                             const std::vector<LayeredBody>& layered)
{
  std::vector<ShearWave> result = grid.is_periodic() ? periodic_shear_waves(grid, constants)
                                                     : shear_waves(grid, KernelPlaces::periodic(grid),
                                                                   cell_surface_terms(grid, reference), constants);
  if (!layered.empty())
    add_excess(grid, layered, reference, result);
  return result;
}

} // namespace

ShearStiffness::ShearStiffness(const SurfaceGrid& grid, const green::PairConstants& constants, double reference,
                               const std::vector<LayeredBody>& layered)
    : ShearStiffness(grid, with_fast_lengths(grid), constants, reference, layered)
{
}

ShearStiffness::ShearStiffness(const SurfaceGrid& grid, const SurfaceGrid& larger,
                               const green::PairConstants& constants, double reference,
                               const std::vector<LayeredBody>& layered)
    : product_(grid, {larger.nx, larger.ny}, {false, true}), stiffness_(product_.fft())
{
  const std::vector<ShearWave> compliance = waves(larger, constants, reference, layered);
  // Uniform shears, which cause no displacement, are assigned a stiffness: see `inverse` in surface_compliance.cpp.
  constexpr double share = 1.0 / 64.0;
  const double uniform = share * largest(compliance);
  double sum = 0.0;
  double count = 0.0;
  const ShearWave* wave = compliance.data();
  for (int row = 0; row < stiffness_.rows(); ++row)
    for (int i = 0; i < product_.fft().kx(); ++i, ++wave)
    {
      const ShearWave given = wave->smallest() > 0.0 ? *wave : ShearWave{uniform, uniform, 0.0};
      const ShearWave inverse = given.inverse();
      std::array<Lanes, 3>& entry = stiffness_.of_column(row, i);
      entry[0][i % lane_count] = inverse.xx;
      entry[1][i % lane_count] = inverse.yy;
      entry[2][i % lane_count] = inverse.xy;
      sum += 0.5 * (inverse.xx + inverse.yy);
      count += 1.0;
    }
  of_one_cell_ = sum / count;
}

void ShearStiffness::apply(const std::array<std::span<const double>, 2>& displacement,
                           const std::array<std::span<double>, 2>& shear, Scratch& scratch, double added) const
{
  const auto product_of_row =
      [added, py = product_.fft().py()](const auto& stiffness, int row, const Product::Values& u)
  {
    const auto& [xx, yy, xy] = stiffness[row];
    const Lanes determinant = xx * yy - xy * xy;
    const Lanes share = 1.0 / (1.0 + added * (xx + yy + added * determinant));
    const Lanes across = row > py / 2 ? -share * xy : share * xy; // odd along both axes
    return Product::Values{share * (xx + added * determinant) * u[0] + across * u[1],
                           across * u[0] + share * (yy + added * determinant) * u[1]};
  };
  product_.apply(displacement, shear, scratch,
                 [&](int block)
                 {
                   return [&product_of_row, stiffness = stiffness_.of_block(block)](int row, const Product::Values& u)
                   { return product_of_row(stiffness, row, u); };
                 });
}

} // namespace brinell::halfspace
