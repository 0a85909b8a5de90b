// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/pressure_stress.hpp"

#include "brinell/foundation/sym_tensor.hpp"
#include "brinell/green/rectangle.hpp"

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

PressureStress::PressureStress(const VolumeGrid& grid, double poisson_ratio, const PaddedFft& fft)
    : grid_(grid), fft_(fft), rows_(fft.py() / 2 + 1),
      spectra_(static_cast<std::size_t>(kernel_count) * static_cast<std::size_t>(grid.nz) *
               static_cast<std::size_t>(rows_) * static_cast<std::size_t>(fft.kx()))
{
#pragma omp parallel for schedule(dynamic)
  for (int layer = 0; layer < grid_.nz; ++layer)
    tabulate(layer, poisson_ratio);
}

const double* PressureStress::kernel(int which, int layer, int row) const
{
  const int folded = std::min(row, fft_.py() - row);
  const auto index = (static_cast<std::size_t>(which * grid_.nz + layer) * static_cast<std::size_t>(rows_)) +
                     static_cast<std::size_t>(folded);
  return spectra_.data() + index * static_cast<std::size_t>(fft_.kx());
}

void PressureStress::tabulate(int layer, double poisson_ratio)
{
  const SurfaceGrid& s = grid_.surface;
  const int px = fft_.px();
  const int py = fft_.py();

  // Values at the cells of the first quadrant, from one lattice of corners per depth.
  std::vector<SymTensor> quadrant(s.size(), SymTensor{});
  std::vector<SymTensor> corner(static_cast<std::size_t>((s.nx + 1) * (s.ny + 1)));
  const auto corner_at = [&](int i, int j) -> SymTensor&
  { return corner[static_cast<std::size_t>(i + (s.nx + 1) * j)]; };
  for (std::size_t g = 0; g < gauss_point.size(); ++g)
  {
    const double z = (layer + 0.5 + gauss_point[g]) * grid_.dz;
    for (int j = 0; j <= s.ny; ++j)
      for (int i = 0; i <= s.nx; ++i)
        corner_at(i, j) = green::rectangle_stress_corner((i - 0.5) * s.dx, (j - 0.5) * s.dy, z, poisson_ratio);
    for (int j = 0; j < s.ny; ++j)
      for (int i = 0; i < s.nx; ++i)
        for (std::size_t c = 0; c < 6; ++c)
          quadrant[static_cast<std::size_t>(i + s.nx * j)][c] +=
              gauss_weight[g] *
              (corner_at(i + 1, j + 1)[c] + corner_at(i, j)[c] - corner_at(i + 1, j)[c] - corner_at(i, j + 1)[c]);
  }

  AlignedVector<double> plane(static_cast<std::size_t>(px) * static_cast<std::size_t>(py));
  AlignedVector<Complex> transformed(fft_.plane());
  for (int which = 0; which < kernel_count; ++which)
  {
    const bool odd_x = which == xz || which == xy;
    const bool odd_y = which == yz || which == xy;
    std::fill(plane.begin(), plane.end(), 0.0);
    for (int j = 1 - s.ny; j < s.ny; ++j)
      for (int i = 1 - s.nx; i < s.nx; ++i)
      {
        const SymTensor& t = quadrant[static_cast<std::size_t>(std::abs(i) + s.nx * std::abs(j))];
        const std::array<double, kernel_count> value{t[0] - t[2], t[1] - t[2], t[3], t[4], t[5], t[0] + t[1] + t[2]};
        const double sign = (odd_x && i < 0 ? -1.0 : 1.0) * (odd_y && j < 0 ? -1.0 : 1.0);
        plane[static_cast<std::size_t>((j + py) % py * px + (i + px) % px)] =
            sign * value[static_cast<std::size_t>(which)];
      }
    fft_.forward_padded(plane, transformed.data());
    const bool imaginary = odd_x != odd_y;
    auto* out = const_cast<double*>(kernel(which, layer, 0));
    for (int k = 0; k < rows_ * fft_.kx(); ++k)
      out[k] =
          imaginary ? transformed[static_cast<std::size_t>(k)].imag() : transformed[static_cast<std::size_t>(k)].real();
  }
}

void PressureStress::add_deviator(const Complex* pressure_hat, Complex* stress_hat, int layers) const
{
  const int kx = fft_.kx();
  const std::size_t component = static_cast<std::size_t>(grid_.nz) * fft_.plane();
#pragma omp parallel for schedule(static)
  for (int layer = 0; layer < layers; ++layer)
    for (int row = 0; row < fft_.py(); ++row)
    {
      const double sign = row > fft_.py() / 2 ? -1.0 : 1.0; // kernels odd in y
      const double* a = kernel(xx_minus_zz, layer, row);
      const double* b = kernel(yy_minus_zz, layer, row);
      const double* k_yz = kernel(yz, layer, row);
      const double* k_xz = kernel(xz, layer, row);
      const double* k_xy = kernel(xy, layer, row);
      const auto* p = reinterpret_cast<const double*>(pressure_hat + row * kx);
      auto* out = reinterpret_cast<double*>(stress_hat + static_cast<std::size_t>(layer) * fft_.plane() +
                                            static_cast<std::size_t>(row * kx));
      const std::size_t next = 2 * component;
#pragma omp simd
      for (int i = 0; i < kx; ++i)
      {
        const double re = p[2 * i];
        const double im = p[2 * i + 1];
        const double xx = (2.0 * a[i] - b[i]) / 3.0;
        const double yy = (2.0 * b[i] - a[i]) / 3.0;
        out[2 * i] += xx * re;
        out[2 * i + 1] += xx * im;
        out[next + 2 * i] += yy * re;
        out[next + 2 * i + 1] += yy * im;
        out[2 * next + 2 * i] -= sign * k_yz[i] * im;
        out[2 * next + 2 * i + 1] += sign * k_yz[i] * re;
        out[3 * next + 2 * i] -= k_xz[i] * im;
        out[3 * next + 2 * i + 1] += k_xz[i] * re;
        out[4 * next + 2 * i] += sign * k_xy[i] * re;
        out[4 * next + 2 * i + 1] += sign * k_xy[i] * im;
      }
    }
}

void PressureStress::trace(const Complex* pressure_hat, Complex* trace_hat) const
{
  for (int layer = 0; layer < grid_.nz; ++layer)
    for (int row = 0; row < fft_.py(); ++row)
    {
      const double* k = kernel(tr, layer, row);
      const Complex* p = pressure_hat + row * fft_.kx();
      Complex* out =
          trace_hat + static_cast<std::size_t>(layer) * fft_.plane() + static_cast<std::size_t>(row * fft_.kx());
      for (int i = 0; i < fft_.kx(); ++i)
        out[i] = k[i] * p[i];
    }
}

void PressureStress::displacement(const Complex* strain_hat, Complex* displacement_hat, int layers) const
{
  const int kx = fft_.kx();
  const std::size_t next = 2 * static_cast<std::size_t>(grid_.nz) * fft_.plane();
#pragma omp parallel for schedule(static)
  for (int row = 0; row < fft_.py(); ++row)
  {
    const double sign = row > fft_.py() / 2 ? -1.0 : 1.0;
    auto* out = reinterpret_cast<double*>(displacement_hat + row * kx);
    std::fill_n(out, 2 * kx, 0.0);
    for (int layer = 0; layer < layers; ++layer)
    {
      const double* a = kernel(xx_minus_zz, layer, row);
      const double* b = kernel(yy_minus_zz, layer, row);
      const double* k_yz = kernel(yz, layer, row);
      const double* k_xz = kernel(xz, layer, row);
      const double* k_xy = kernel(xy, layer, row);
      const auto* e = reinterpret_cast<const double*>(strain_hat + static_cast<std::size_t>(layer) * fft_.plane() +
                                                      static_cast<std::size_t>(row * kx));
#pragma omp simd
      for (int i = 0; i < kx; ++i)
      {
        // conj(K) : eps; conj(i k) = -i k for the kernels odd in one direction.
        const double yz_factor = 2.0 * sign * k_yz[i];
        const double xz_factor = 2.0 * k_xz[i];
        const double xy_factor = 2.0 * sign * k_xy[i];
        out[2 * i] += a[i] * e[2 * i] + b[i] * e[next + 2 * i] + yz_factor * e[2 * next + 2 * i + 1] +
                      xz_factor * e[3 * next + 2 * i + 1] + xy_factor * e[4 * next + 2 * i];
        out[2 * i + 1] += a[i] * e[2 * i + 1] + b[i] * e[next + 2 * i + 1] - yz_factor * e[2 * next + 2 * i] -
                          xz_factor * e[3 * next + 2 * i] + xy_factor * e[4 * next + 2 * i + 1];
      }
    }
    for (int i = 0; i < 2 * kx; ++i)
      out[i] *= grid_.dz;
  }
}

} // namespace brinell::halfspace
