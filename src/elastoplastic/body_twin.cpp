// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body.hpp"

namespace brinell::elastoplastic
{

namespace
{

/// Mirrors a field in x, row by row, with the sign of its parity.
void mirror(const std::vector<double>& from, int nx, std::size_t begin, std::size_t end, double sign,
            std::vector<double>& to)
{
  const auto row_length = static_cast<std::size_t>(nx);
  for (std::size_t row = begin; row < end; row += row_length)
    for (std::size_t i = 0; i < row_length; ++i)
      to[row + i] = sign * from[row + row_length - 1 - i];
}

void mirror(const std::vector<double>& from, int nx, std::vector<double>& to)
{
  mirror(from, nx, 0, from.size(), 1.0, to);
}

/// One or several deviator fields of `n` cells.
void mirror_deviator(const std::vector<double>& from, int nx, std::size_t n, std::vector<double>& to)
{
  for (std::size_t begin = 0; begin < from.size(); begin += n)
  {
    const auto component = static_cast<int>(begin / n % Deviator::size);
    mirror(from, nx, begin, begin + n, component == Deviator::xz || component == Deviator::xy ? -1.0 : 1.0, to);
  }
}

} // namespace

void Body::follow(const Body& other, Twin twin)
{
  if (twin == Twin::alike)
    displacement_ = other.displacement_;
  else
    mirror(other.displacement_, grid().surface.nx, displacement_);
}

void Body::adopt(const Body& other, Twin twin)
{
  if (twin == Twin::alike)
  {
    state_ = other.state_;
    displacement_ = other.displacement_;
    return;
  }
  const int nx = grid().surface.nx;
  const std::size_t n = grid().size();
  mirror_deviator(other.state_.plastic_strain, nx, n, state_.plastic_strain);
  mirror_deviator(other.state_.stress, nx, n, state_.stress);
  mirror_deviator(other.state_.backstress, nx, n, state_.backstress);
  mirror(other.state_.equivalent, nx, state_.equivalent);
  mirror(other.state_.residual_displacement, nx, state_.residual_displacement);
  state_.dissipation = other.state_.dissipation;
  state_.locked_in_energy = other.state_.locked_in_energy;
  displacement_ = state_.residual_displacement;
}

} // namespace brinell::elastoplastic
