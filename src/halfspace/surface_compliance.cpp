// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/surface_compliance.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/green/rectangle.hpp"

#include <cmath>
#include <numbers>

namespace brinell::halfspace
{

SurfaceCompliance::SurfaceCompliance(const SurfaceGrid& grid, double contact_modulus) : fft_(grid)
{
  const int px = fft_.px();
  const int py = fft_.py();
  AlignedVector<double> kernel(static_cast<std::size_t>(px) * static_cast<std::size_t>(py), 0.0);
  for (int j = 1 - grid.ny; j < grid.ny; ++j)
    for (int i = 1 - grid.nx; i < grid.nx; ++i)
    {
      const int column = (i + px) % px;
      const int row = (j + py) % py;
      kernel[static_cast<std::size_t>(row * px + column)] =
          green::rectangle_displacement(i * grid.dx, j * grid.dy, grid.dx, grid.dy) /
          (std::numbers::pi * contact_modulus);
    }
  AlignedVector<Complex> transformed(fft_.plane());
  fft_.forward_padded(kernel, transformed.data());
  spectrum_.resize(fft_.plane());
  for (std::size_t k = 0; k < spectrum_.size(); ++k)
    spectrum_[k] = transformed[k].real(); // even in x and y: the imaginary part is rounding
}

void SurfaceCompliance::apply(std::span<const double> pressure, std::span<double> displacement, Scratch& scratch) const
{
  if (pressure.size() != grid().size() || displacement.size() != grid().size() ||
      scratch.spectrum.size() < fft_.plane())
    throw InternalError("SurfaceCompliance::apply: fields do not have the size of the grid");
  fft_.forward(pressure.data(), scratch.spectrum.data(), scratch.real);
  for (std::size_t k = 0; k < fft_.plane(); ++k)
    scratch.spectrum[k] *= spectrum_[k];
  fft_.inverse(scratch.spectrum.data(), displacement.data(), scratch.real);
}

} // namespace brinell::halfspace
