// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body_view.hpp"

#include <algorithm>

namespace brinell::elastoplastic
{

namespace
{

/// Reverses every row of a field, and multiplies it by the sign of its parity in x.
void reverse_rows(std::span<double> field, int nx, double sign)
{
  for (auto row = field.begin(); row != field.end(); row += nx)
  {
    std::reverse(row, row + nx);
    std::for_each(row, row + nx, [sign](double& value) { value *= sign; });
  }
}

/// Mirrors one or several deviator fields of `cells` cells in x.
void reverse_deviators(std::vector<double>& fields, int nx, std::size_t cells)
{
  for (std::size_t begin = 0; begin < fields.size(); begin += cells)
  {
    const auto component = static_cast<int>(begin / cells % Deviator::size);
    const bool is_odd = component == Deviator::xz || component == Deviator::xy;
    reverse_rows(std::span(fields).subspan(begin, cells), nx, is_odd ? -1.0 : 1.0);
  }
}

} // namespace

BodyState BodyView::state() const
{
  BodyState state = solved_->state();
  for_fields([&](const Traits& traits, std::vector<double>& field) { turn_field(traits.in_mirror, field); }, state);
  return state;
}

std::vector<double> BodyView::field(std::vector<double> BodyState::*member) const
{
  std::vector<double> copy = solved_->state().*member;
  turn_field(traits_of(member).in_mirror, copy);
  return copy;
}

void BodyView::turn_field(InMirror in_mirror, std::vector<double>& field) const
{
  if (!is_mirrored())
    return;
  if (in_mirror == InMirror::deviator)
    reverse_deviators(field, grid().surface.nx, solved_->own_grid().size());
  else
    reverse_rows(field, grid().surface.nx, in_mirror == InMirror::odd ? -1.0 : 1.0);
}

void BodyView::turn(std::vector<double>& deviators, std::vector<double>& scalars) const
{
  if (!is_mirrored())
    return;
  reverse_deviators(deviators, grid().surface.nx, solved_->own_grid().size());
  reverse_rows(scalars, grid().surface.nx, 1.0);
}

std::size_t BodyView::solved_cell(std::size_t cell) const
{
  if (!is_mirrored())
    return cell;
  const auto nx = static_cast<std::size_t>(grid().surface.nx);
  return cell - cell % nx + (nx - 1 - cell % nx);
}

Deviator BodyView::turned(const Deviator& of_solved) const
{
  Deviator result = of_solved;
  for (const int component : {Deviator::xz, Deviator::xy})
    if (is_mirrored())
      result[component] = -result[component];
  return result;
}

std::vector<double> BodyView::turned(std::span<const double> surface, double parity) const
{
  std::vector<double> copy(surface.begin(), surface.end());
  if (is_mirrored())
    reverse_rows(copy, grid().surface.nx, parity);
  return copy;
}

std::vector<double> BodyView::residual_displacement(std::size_t axis) const
{
  return turned(solved_->residual_displacement(axis), axis == 1 ? -1.0 : 1.0);
}

std::vector<double> BodyView::shear_strength(double along_x, double along_y) const
{
  std::vector<double> strength = solved_->shear_strength(is_mirrored() ? -along_x : along_x, along_y);
  if (is_mirrored())
    reverse_rows(strength, grid().surface.nx, 1.0);
  return strength;
}

} // namespace brinell::elastoplastic
