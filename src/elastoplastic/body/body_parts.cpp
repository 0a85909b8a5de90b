// SPDX-License-Identifier: BSD-3-Clause
#include "body_parts.hpp"

/// Access to the parts of a body.
namespace brinell::elastoplastic
{

Deviator BodyParts::backstress(std::size_t cell, std::size_t term) const
{
  const std::size_t n = grid.size();
  Deviator b;
  for (int c = 0; c < Deviator::size; ++c)
    b[c] = state.backstress[(term * Deviator::size + static_cast<std::size_t>(c)) * n + cell];
  return b;
}

Deviator BodyParts::centre(std::size_t cell) const
{
  Deviator sum;
  for (std::size_t term = 0; term < yield.material.kinematic.size(); ++term)
    sum = sum + backstress(cell, term);
  return sum;
}

const VolumeGrid& Body::grid() const
{
  return parts_->grid;
}

const constitutive::Material& Body::material() const
{
  return parts_->yield.material;
}

const BodyState& Body::state() const
{
  return parts_->state;
}

BodyState Body::take_state() &&
{
  return std::move(parts_->state);
}

const PlasticZone& Body::plastic_zone() const
{
  return parts_->zone;
}

void Body::require(Scope scope)
{
  parts_->evaluation.require(scope);
}

Scope Body::scope() const
{
  return parts_->evaluation.scope();
}

double Body::cost() const
{
  return parts_->is_plastic() ? parts_->evaluation.cost() : 0.0;
}

const ActiveCells& Body::active() const
{
  return parts_->trial.active;
}

std::vector<double>& Body::trial()
{
  return parts_->trial.active.trials();
}

double Body::yield_error() const
{
  return parts_->trial.yield_error;
}

std::span<const double> Body::residual_displacement(std::size_t axis) const
{
  return parts_->evaluation.displacement(axis);
}

void Body::full_stress(const halfspace::SurfaceLoad& load, std::span<double> deviator, std::span<double> trace,
                       int layers)
{
  parts_->evaluation.full_stress(load, parts_->state.plastic_strain, deviator, trace, layers);
}

std::vector<Body::CellStress> Body::stress_at(std::span<const std::size_t> cells, const halfspace::SurfaceLoad& load)
{
  return parts_->evaluation.stress_at(cells, load, parts_->state);
}

} // namespace brinell::elastoplastic
