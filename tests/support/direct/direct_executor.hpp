// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "device/host_executor.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace brinell::test
{

/// Executor of kernels on the processor whose transforms are sums over all cells, as the contract of executors has them: the order
/// in memory and the factors that cuFFT and the transforms of the engine have to have.
class DirectExecutor : public device::HostExecutor
{
public:
  class Transform
  {
  public:
    Transform(const SurfaceGrid& grid, int px, int py, int planes)
        : nx_(grid.nx), ny_(grid.ny), px_(px), py_(py), columns_(px / 2 + 1), planes_(planes)
    {
    }

    void forward(const double* fields, ComplexNumber* spectra) const
    {
      for (int plane = 0; plane < planes_; ++plane)
        for (int row = 0; row < py_; ++row)
          for (int column = 0; column < columns_; ++column)
          {
            ComplexNumber sum;
            for (int j = 0; j < ny_; ++j)
              for (int i = 0; i < nx_; ++i)
                sum = sum + fields[(plane * ny_ + j) * nx_ + i] * turned(-1.0, i, j, column, row);
            spectra[(plane * py_ + row) * columns_ + column] = sum;
          }
    }
    void inverse(const ComplexNumber* spectra, double* fields) const
    {
      for (int plane = 0; plane < planes_; ++plane)
        for (int j = 0; j < ny_; ++j)
          for (int i = 0; i < nx_; ++i)
          {
            double sum = 0.0;
            for (int row = 0; row < py_; ++row)
              for (int column = 0; column < columns_; ++column)
              {
                const ComplexNumber wave = spectra[(plane * py_ + row) * columns_ + column];
                const ComplexNumber turn = turned(1.0, i, j, column, row);
                const bool has_opposite = column > 0 && 2 * column != px_;
                sum += (has_opposite ? 2.0 : 1.0) * (wave.re * turn.re - wave.im * turn.im);
              }
            fields[(plane * ny_ + j) * nx_ + i] = sum;
          }
    }

  private:
    [[nodiscard]] ComplexNumber turned(double sign, int i, int j, int column, int row) const
    {
      const double turns = static_cast<double>(i * column % px_) / px_ + static_cast<double>(j * row % py_) / py_;
      const double angle = sign * 2.0 * std::numbers::pi * turns;
      return {std::cos(angle), std::sin(angle)};
    }

    int nx_, ny_, px_, py_, columns_, planes_;
  };
  [[nodiscard]] Transform transform(const SurfaceGrid& grid, int px, int py, int planes) const
  {
    return {grid, px, py, planes};
  }
};

} // namespace brinell::test
