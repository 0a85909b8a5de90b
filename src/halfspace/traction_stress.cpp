// SPDX-License-Identifier: BSD-3-Clause
#include "halfspace/traction_stress.hpp"

#include "brinell/foundation/sym_tensor.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::halfspace
{

namespace
{

/// Three-point Gauss-Legendre rule on [-1/2, 1/2]: the mean over a layer.
constexpr std::array<double, 3> gauss_point{-0.38729833462074168852, 0.0, 0.38729833462074168852};
constexpr std::array<double, 3> gauss_weight{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};

} // namespace

TractionStress::TractionStress(const VolumeGrid& grid, double poisson_ratio, const BlockedFft& fft, Traction traction)
    : grid_(grid), fft_(fft), traction_(traction), rows_(fft.py() / 2 + 1),
      kernels_(static_cast<std::size_t>(fft.blocks()) * static_cast<std::size_t>(grid.nz) * kernel_count *
               static_cast<std::size_t>(rows_))
{
  const PaddedFft padded(grid.surface, fft.px(), fft.py());
#pragma omp parallel for schedule(dynamic)
  for (int layer = 0; layer < grid_.nz; ++layer)
    if (grid.surface.is_periodic())
      tabulate_waves(layer, poisson_ratio, padded);
    else
      tabulate_cells(layer, poisson_ratio, padded);
}

const Lanes* TractionStress::kernel(int block, int layer, int which) const
{
  return kernels_.data() + ((static_cast<std::ptrdiff_t>(block) * grid_.nz + layer) * kernel_count + which) * rows_;
}

double& TractionStress::number(int row, int column, int layer, int which)
{
  const std::ptrdiff_t at = kernel(column / lane_count, layer, which) + row - kernels_.data();
  return reinterpret_cast<double*>(kernels_.data() + at)[column % lane_count];
}

Parity TractionStress::parity(int which) const
{
  const bool odd_x = which == Deviator::xz || which == Deviator::xy;
  const bool odd_y = which == Deviator::yz || which == Deviator::xy;
  return {odd_x != (traction_ == Traction::shear_x), odd_y != (traction_ == Traction::shear_y)};
}

namespace
{

/// What is stored of a stress, in the order of the kernels.
std::array<double, 6> kernel_values(const SymTensor& t)
{
  return {t[0] - t[2], t[1] - t[2], t[3], t[4], t[5], trace(t)};
}

/// Mean over a layer of the stress of a unit traction on one cell.
Quadrant<SymTensor> mean_over_layer(const VolumeGrid& grid, int layer, double poisson_ratio, Traction traction)
{
  Quadrant<SymTensor> mean(grid.surface);
  for (std::size_t g = 0; g < gauss_point.size(); ++g)
  {
    const Quadrant<SymTensor> part =
        cell_stress(grid.surface, (layer + 0.5 + gauss_point[g]) * grid.dz, poisson_ratio, traction);
    for (std::size_t n = 0; n < mean.values.size(); ++n)
      for (std::size_t c = 0; c < 6; ++c)
        mean.values[n][c] += gauss_weight[g] * part.values[n][c];
  }
  return mean;
}

} // namespace

void TractionStress::tabulate_cells(int layer, double poisson_ratio, const PaddedFft& fft)
{
  const Quadrant<SymTensor> response = mean_over_layer(grid_, layer, poisson_ratio, traction_);
  for (int which = 0; which < kernel_count; ++which)
    parity_spectrum(
        fft, parity(which),
        [&](int i, int j) { return kernel_values(response.at(i, j))[static_cast<std::size_t>(which)]; },
        [&](int row, int column, double value) { number(row, column, layer, which) = value; });
}

namespace
{

/// Of a wave, means over a layer.
struct Decay
{
  double level;  ///< of e^{-kz}
  double rising; ///< of k z e^{-kz}
};

Decay mean_decay(double thickness, int layer)
{
  const double top = layer * thickness;
  const double mean = -std::expm1(-thickness) / thickness;
  return {std::exp(-top) * mean, std::exp(-top) * ((1.0 + top) * mean - std::exp(-thickness))};
}

/// With l along the wavevector, t across it, a wave of unit pressure gives, times e^{-kz},
///     ll = -(1 - k z)    zz = -(1 + k z)    tt = -2 nu    lz = i k z
/// one of a unit shear along l
///     ll = i (2 - k z)   zz = i k z         tt = 2 i nu   lz = -(1 - k z)
/// and one along t: lt = i, tz = -1 (Johnson 1985, section 13.2; docs/theory/half-space.md).
/// @param lx, ly  of the unit vector along l
/// @return  amplitudes, without the factor i in those that are odd in x and even in y, or the other way round
SymTensor wave_stress(Traction traction, double lx, double ly, const Decay& decay, double nu)
{
  if (traction == Traction::shear_y)
    return xy_exchanged(wave_stress(Traction::shear_x, ly, lx, decay, nu));
  const double xx = lx * lx, yy = ly * ly;
  if (traction == Traction::pressure)
  {
    const double ll = decay.rising - decay.level;
    const double tt = -2.0 * nu * decay.level;
    return {xx * ll + yy * tt, yy * ll + xx * tt, -decay.rising - decay.level,
            ly * decay.rising, lx * decay.rising, lx * ly * (ll - tt)};
  }
  const double ll = 2.0 * decay.level - decay.rising;
  const double tt = 2.0 * nu * decay.level;
  const double lz = decay.rising - decay.level;
  const double lt = decay.level;
  const double tz = -decay.level;
  return {lx * (xx * ll + yy * (tt + 2.0 * lt)),
          lx * (yy * (ll - 2.0 * lt) + xx * tt),
          lx * decay.rising,
          lx * ly * (lz - tz),
          xx * lz + yy * tz,
          ly * (xx * (ll - tt) + (yy - xx) * lt)};
}

/// Of a unit traction that is uniform, without mean strain in the plane.
SymTensor uniform_stress(Traction traction, double nu)
{
  const double held = -nu / (1.0 - nu);
  switch (traction)
  {
  case Traction::pressure:
    return {held, held, -1.0, 0.0, 0.0, 0.0};
  case Traction::shear_x:
    return {0.0, 0.0, 0.0, 0.0, -1.0, 0.0};
  case Traction::shear_y:
    break;
  }
  return {0.0, 0.0, 0.0, -1.0, 0.0, 0.0};
}

} // namespace

void TractionStress::tabulate_waves(int layer, double poisson_ratio, const PaddedFft& fft)
{
  for (int row = 0; row < rows_; ++row)
    for (int i = 0; i < fft.kx(); ++i)
    {
      const double m = fft.wavenumber_x(i);
      const double n = fft.wavenumber_y(row);
      const double k = std::hypot(m, n);
      const std::array<double, kernel_count> value = kernel_values(
          k == 0.0 ? uniform_stress(traction_, poisson_ratio)
                   : wave_stress(traction_, m / k, n / k, mean_decay(k * grid_.dz, layer), poisson_ratio));
      // At the shortest wave of an even number of cells nothing that is odd can be told.
      const bool shortest_x = 2 * i == fft.px(), shortest_y = 2 * row == fft.py();
      for (int which = 0; which < kernel_count; ++which)
      {
        const auto [odd_x, odd_y] = parity(which);
        const bool is_told = !(odd_x && shortest_x) && !(odd_y && shortest_y);
        number(row, i, layer, which) = is_told ? value[static_cast<std::size_t>(which)] : 0.0;
      }
    }
}

/// @param factor  of a stored row
template <bool is_imaginary, typename Factor>
void TractionStress::add_rows(const Factor& factor, int rows, const ComplexLanes* traction, const ComplexLanes* stress,
                              ComplexLanes* total) const
{
  const auto add_row = [&](int row, const Lanes& number)
  {
    const ComplexLanes product = number * traction[row];
    total[row] = stress[row] + (is_imaginary ? times_i(product) : product);
  };
  for (int row = 0; row < std::min(rows, rows_); ++row)
    add_row(row, factor(row, 1.0));
  for (int row = rows_; row < rows; ++row)
    add_row(row, factor(fft_.folded(row), -1.0));
}

void TractionStress::add(int block, int component, int layer, int rows, const ComplexLanes* traction,
                         const ComplexLanes* stress, ComplexLanes* total) const
{
  const auto [odd_x, odd_y] = parity(component);
  if (component == xx || component == yy) // stored are differences from zz
  {
    const Lanes* own = kernel(block, layer, component);
    const Lanes* other = kernel(block, layer, component == xx ? yy : xx);
    const auto deviator = [=, is_odd = odd_y](int row, double sign)
    { return ((is_odd ? sign : 1.0) / 3.0) * (2.0 * own[row] - other[row]); };
    return odd_x != odd_y ? add_rows<true>(deviator, rows, traction, stress, total)
                          : add_rows<false>(deviator, rows, traction, stress, total);
  }
  const Lanes* own = kernel(block, layer, component);
  const auto plain = [=, is_odd = odd_y](int row, double sign) { return (is_odd ? sign : 1.0) * own[row]; };
  return odd_x != odd_y ? add_rows<true>(plain, rows, traction, stress, total)
                        : add_rows<false>(plain, rows, traction, stress, total);
}

void TractionStress::add_displacement(int block, int component, int layer, int rows, const ComplexLanes* strain,
                                      ComplexLanes* displacement) const
{
  const Parity parity_of = parity(component);
  const bool is_shear = component != xx && component != yy;
  // Of the transpose, with conj(i K) = -i K; a shear is in two places of the tensor.
  const double weight = (parity_of.is_imaginary() ? -1.0 : 1.0) * (is_shear ? 2.0 : 1.0) * grid_.dz;
  const Lanes* own = kernel(block, layer, component);
  const auto factor = [=](int row, double sign) { return (parity_of.odd_y ? sign * weight : weight) * own[row]; };
  return parity_of.is_imaginary() ? add_rows<true>(factor, rows, strain, displacement, displacement)
                                  : add_rows<false>(factor, rows, strain, displacement, displacement);
}

} // namespace brinell::halfspace
