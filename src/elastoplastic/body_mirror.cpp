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

void mirror_deviator(const std::vector<double>& from, int nx, std::vector<double>& to)
{
  const std::size_t n = from.size() / Deviator::size;
  for (std::size_t c = 0; c < Deviator::size; ++c)
    mirror(from, nx, c * n, (c + 1) * n, c == Deviator::xz || c == Deviator::xy ? -1.0 : 1.0, to);
}

} // namespace

void Body::follow(const Body& other)
{
  mirror(other.displacement_, grid().surface.nx, displacement_);
}

void Body::adopt(const Body& other)
{
  const int nx = grid().surface.nx;
  mirror_deviator(other.state_.plastic_strain, nx, state_.plastic_strain);
  mirror_deviator(other.state_.stress, nx, state_.stress);
  mirror(other.state_.equivalent, nx, state_.equivalent);
  mirror(other.state_.residual_displacement, nx, state_.residual_displacement);
  state_.dissipation = other.state_.dissipation;
  state_.locked_in_energy = other.state_.locked_in_energy;
  displacement_ = state_.residual_displacement;
}

} // namespace brinell::elastoplastic
