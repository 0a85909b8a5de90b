// SPDX-License-Identifier: BSD-3-Clause
#include "halfspace/pressure_stress.hpp"

#include "brinell/foundation/sym_tensor.hpp"
#include "cell_response.hpp"
#include "foundation/lane_functions.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace brinell::halfspace
{

namespace
{

/// Three-point Gauss-Legendre rule on [-1/2, 1/2]: the mean over a layer.
constexpr std::array<double, 3> gauss_point{-0.38729833462074168852, 0.0, 0.38729833462074168852};
constexpr std::array<double, 3> gauss_weight{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};

} // namespace

PressureStress::PressureStress(const VolumeGrid& grid, double poisson_ratio, const BlockedFft& fft)
    : grid_(grid), fft_(fft), rows_(fft.py() / 2 + 1),
      kernels_(static_cast<std::size_t>(fft.blocks()) * static_cast<std::size_t>(rows_) *
               static_cast<std::size_t>(grid.nz))
{
  const PaddedFft padded(grid.surface, fft.px(), fft.py());
#pragma omp parallel for schedule(dynamic)
  for (int layer = 0; layer < grid_.nz; ++layer)
    if (grid.surface.is_periodic())
      tabulate_waves(layer, poisson_ratio, padded);
    else
      tabulate_cells(layer, poisson_ratio, padded);
}

PressureStress::Kernels& PressureStress::kernels_at(int row, int column, int layer)
{
  return kernels_[(static_cast<std::size_t>(column / lane_count) * static_cast<std::size_t>(rows_) +
                   static_cast<std::size_t>(row)) *
                      static_cast<std::size_t>(grid_.nz) +
                  static_cast<std::size_t>(layer)];
}

const PressureStress::Kernels* PressureStress::kernels(int block, int row) const
{
  const int folded = std::min(row, fft_.py() - row);
  return kernels_.data() + static_cast<std::size_t>(block * rows_ + folded) * static_cast<std::size_t>(grid_.nz);
}

namespace
{

/// Mean over a layer of the stress of a unit pressure on one cell.
Quadrant<SymTensor> mean_over_layer(const VolumeGrid& grid, int layer, double poisson_ratio)
{
  Quadrant<SymTensor> mean(grid.surface);
  for (std::size_t g = 0; g < gauss_point.size(); ++g)
  {
    const Quadrant<SymTensor> part = cell_stress(grid.surface, (layer + 0.5 + gauss_point[g]) * grid.dz, poisson_ratio);
    for (std::size_t n = 0; n < mean.values.size(); ++n)
      for (std::size_t c = 0; c < 6; ++c)
        mean.values[n][c] += gauss_weight[g] * part.values[n][c];
  }
  return mean;
}

} // namespace

void PressureStress::tabulate_cells(int layer, double poisson_ratio, const PaddedFft& fft)
{
  const SurfaceGrid& s = grid_.surface;
  const int px = fft.px();
  const int py = fft.py();
  const Offsets along_x(s.nx, s.boundary_x);
  const Offsets along_y(s.ny, s.boundary_y);
  const Quadrant<SymTensor> response = mean_over_layer(grid_, layer, poisson_ratio);
  AlignedVector<double> plane(static_cast<std::size_t>(px) * static_cast<std::size_t>(py));
  AlignedVector<Complex> transformed(fft.plane());
  enum : int
  {
    xx,
    yy,
    yz,
    xz,
    xy,
    trace
  };
  constexpr std::array<Lanes Kernels::*, kernel_count> member{&Kernels::xx, &Kernels::yy, &Kernels::yz,
                                                              &Kernels::xz, &Kernels::xy, &Kernels::trace};
  for (int which = 0; which < kernel_count; ++which)
  {
    const bool odd_x = which == xz || which == xy;
    const bool odd_y = which == yz || which == xy;
    std::fill(plane.begin(), plane.end(), 0.0);
    for (int j = along_y.first(); j <= along_y.last(); ++j)
      for (int i = along_x.first(); i <= along_x.last(); ++i)
      {
        const SymTensor& t = response.at(i, j);
        const std::array<double, kernel_count> value{t[0] - t[2], t[1] - t[2], t[3], t[4], t[5], t[0] + t[1] + t[2]};
        const double sign = (odd_x ? along_x.sign(i) : 1.0) * (odd_y ? along_y.sign(j) : 1.0);
        plane[static_cast<std::size_t>((j + py) % py * px + (i + px) % px)] =
            sign * value[static_cast<std::size_t>(which)];
      }
    fft.forward_padded(plane, transformed.data());
    const bool imaginary = odd_x != odd_y;
    for (int row = 0; row < rows_; ++row)
      for (int i = 0; i < fft.kx(); ++i)
      {
        const Complex value = transformed[static_cast<std::size_t>(row * fft.kx() + i)];
        (kernels_at(row, i, layer).*member[static_cast<std::size_t>(which)])[i % lane_count] =
            imaginary ? value.imag() : value.real();
      }
  }
}

/// With l along the wavevector, t across it, a wave of unit pressure gives, times e^{-kz},
///     ll = -(1 - k z)    zz = -(1 + k z)    tt = -2 nu    lz = i k z
/// (Johnson 1985, section 13.2); a uniform one, with no mean strain in the plane, zz = -1 and xx = yy = -nu / (1 - nu).
void PressureStress::tabulate_waves(int layer, double poisson_ratio, const PaddedFft& fft)
{
  const double nu = poisson_ratio;
  for (int row = 0; row < rows_; ++row)
    for (int i = 0; i < fft.kx(); ++i)
    {
      Kernels& kernel = kernels_at(row, i, layer);
      const auto lane = static_cast<std::size_t>(i % lane_count);
      const double m = fft.wavenumber_x(i);
      const double n = fft.wavenumber_y(row);
      const double k = std::hypot(m, n);
      if (k == 0.0)
      {
        kernel.xx[lane] = kernel.yy[lane] = (1.0 - 2.0 * nu) / (1.0 - nu);
        kernel.trace[lane] = -(1.0 + nu) / (1.0 - nu);
        continue;
      }
      const double thickness = k * grid_.dz;
      const double top = layer * thickness;
      const double q = std::exp(-thickness);
      const double mean = -std::expm1(-thickness) / thickness;
      const double decay = std::exp(-top) * mean;                      // mean of e^{-kz} over the layer
      const double rising = std::exp(-top) * ((1.0 + top) * mean - q); // and of k z e^{-kz}
      const double ll = rising - decay;
      const double zz = -rising - decay;
      const double tt = -2.0 * nu * decay;
      // At the shortest wave of an even number of cells nothing that is odd can be told.
      const double lx = 2 * i == fft.px() ? 0.0 : m / k;
      const double ly = 2 * row == fft.py() ? 0.0 : n / k;
      const double lx2 = m * m / (k * k);
      kernel.xx[lane] = lx2 * ll + (1.0 - lx2) * tt - zz;
      kernel.yy[lane] = (1.0 - lx2) * ll + lx2 * tt - zz;
      kernel.yz[lane] = ly * rising;
      kernel.xz[lane] = lx * rising;
      kernel.xy[lane] = lx * ly * (ll - tt);
      kernel.trace[lane] = ll + zz + tt;
    }
}

namespace
{

/// Rows of negative wavenumbers in y are stored with those of the positive ones; kernels odd in y change sign.
double sign_of_row(int row, int py)
{
  return row > py / 2 ? -1.0 : 1.0;
}

void add_lanes(const ComplexLanes& value, Complex* to)
{
  store_lanes(load_lanes(to) + value, to);
}

} // namespace

void PressureStress::add_deviator(int block, int first, int count, const Complex* pressure, Complex* stress) const
{
  const std::ptrdiff_t plane = static_cast<std::ptrdiff_t>(fft_.py()) * lane_count;
  const auto add_to_row = [&](int row, const Kernels* kernel)
  {
    const ComplexLanes p = load_lanes(pressure + row * lane_count);
    const ComplexLanes third = (1.0 / 3.0) * p;
    const ComplexLanes p_y = sign_of_row(row, fft_.py()) * p;
    Complex* s = stress + row * lane_count;
    for (int layer = 0; layer < count; ++layer, ++kernel, s += Deviator::size * plane)
    {
      add_lanes((2.0 * kernel->xx - kernel->yy) * third, s);
      add_lanes((2.0 * kernel->yy - kernel->xx) * third, s + plane);
      add_lanes(kernel->yz * times_i(p_y), s + 2 * plane);
      add_lanes(kernel->xz * times_i(p), s + 3 * plane);
      add_lanes(kernel->xy * p_y, s + 4 * plane);
    }
  };
  for (int row = 0; row < rows_; ++row)
  {
    const Kernels* kernel = kernels(block, row) + first;
    add_to_row(row, kernel);
    if (const int mirrored = fft_.mirrored(row); mirrored != row)
      add_to_row(mirrored, kernel);
  }
}

void PressureStress::add_trace(int block, int row, const Complex* pressure, Complex* trace) const
{
  const Kernels* kernel = kernels(block, row);
  const ComplexLanes p = load_lanes(pressure);
  for (int layer = 0; layer < grid_.nz; ++layer, ++kernel, trace += lane_count)
    add_lanes(kernel->trace * p, trace);
}

void PressureStress::displacement(int block, int row, const Complex* strain, Complex* displacement, int layers) const
{
  const Kernels* kernel = kernels(block, row);
  ComplexLanes even;  // conj(K) : eps; the kernels odd in one direction are imaginary,
  ComplexLanes odd;   // conj(i K) = -i K,
  ComplexLanes odd_y; // and those odd in y change sign with the row
  ComplexLanes odd_xy;
  for (int layer = 0; layer < layers; ++layer, ++kernel, strain += Deviator::size * lane_count)
  {
    even = even + kernel->xx * load_lanes(strain) + kernel->yy * load_lanes(strain + lane_count);
    odd_y = odd_y + kernel->yz * load_lanes(strain + 2 * lane_count);
    odd = odd + kernel->xz * load_lanes(strain + 3 * lane_count);
    odd_xy = odd_xy + kernel->xy * load_lanes(strain + 4 * lane_count);
  }
  const double sign = sign_of_row(row, fft_.py());
  const ComplexLanes shear = 2.0 * (sign * odd_xy - times_i(sign * odd_y + odd));
  store_lanes(grid_.dz * (even + shear), displacement);
}

} // namespace brinell::halfspace
