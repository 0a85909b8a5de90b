// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/eigenstrain_sheet.hpp"

#include "green/sheet_stress.hpp"

#include <cmath>
#include <complex>

namespace brinell::green
{

SheetStress eigenstrain_sheet_stress(double m, double n, double z, double z_source, const Deviator& strain,
                                     const Elastic& elastic)
{
  using Complex = std::complex<double>;
  using D = Deviator;
  const double k = std::hypot(m, n), s = k * std::abs(z - z_source);
  const double down_share = z > z_source ? 1.0 : z < z_source ? 0.0 : 0.5;
  const SheetPath<double> path{
      s, k * z, k * z_source, std::exp(-s), std::exp(-k * z), std::exp(-k * z_source), down_share, 1.0 - down_share};
  const auto towards = direction_of(m, n);
  const double nu = elastic.poisson_ratio;
  const SheetSource<Complex> sheet(in_wave_frame<double, Complex>(towards, nu, strain[D::xx], strain[D::yy],
                                                                  strain[D::yz], strain[D::xz], strain[D::xy]));
  const AxesStress<Complex> stress = sheet_stress(sheet, path, SheetStiffness(k, elastic), towards, nu);
  return {{stress.xx, stress.yy, stress.yz, stress.xz, stress.xy}, stress.trace};
}

} // namespace brinell::green
