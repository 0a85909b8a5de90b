// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body.hpp"
#include "window.hpp"

#include <algorithm>

namespace brinell::elastoplastic
{

namespace
{

/// Copies fields of a grid into the centre of a larger grid, from the surface downwards.
void embed(const std::vector<double>& from, const VolumeGrid& small, std::vector<double>& to, const VolumeGrid& large)
{
  const SurfaceGrid& s = small.surface;
  const SurfaceGrid& l = large.surface;
  const int columns = (l.nx - s.nx) / 2;
  const int rows = (l.ny - s.ny) / 2;
  const std::size_t fields = from.size() / small.size();
  for (std::size_t field = 0; field < fields; ++field)
    for (int k = 0; k < small.nz; ++k)
      for (int j = 0; j < s.ny; ++j)
      {
        const double* row = from.data() + field * small.size() + small.index(0, j, k);
        const std::size_t at = field * large.size() + large.index(columns, j + rows, k);
        std::copy_n(row, s.nx, to.begin() + static_cast<std::ptrdiff_t>(at));
      }
}

/// Factor on the yield stress far from all heat, at the bulk temperature.
double softening_far_away(const constitutive::Material& material)
{
  return material.softening ? constitutive::softening_factor(*material.softening, material.temperature) : 1.0;
}

} // namespace

void Body::continue_from(const BodyState& history, const VolumeGrid& from, const halfspace::SurfaceLoad& load)
{
  if (!is_plastic())
    return;
  embed(history.plastic_strain, from, state_.plastic_strain, grid());
  embed(history.equivalent, from, state_.equivalent, grid());
  zone_ = PlasticZone(grid(), state_.equivalent);
  embed(history.backstress, from, state_.backstress, grid());
  state_.dissipation = history.dissipation;
  state_.thermal_work = history.thermal_work;
  state_.thermal_stress.assign(history.thermal_stress.empty() ? 0 : Deviator::size * grid().size(), 0.0);
  embed(history.thermal_stress, from, state_.thermal_stress, grid());
  has_own_thermal_stress_ = false;
  state_.softening.assign(history.softening.empty() ? 0 : grid().size(), softening_far_away(material_));
  embed(history.softening, from, state_.softening, grid());
  softening_ = state_.softening;
  prepare_trial();
  work_ = half_space_->make_work();
  const halfspace::Displacements wanted = displacements_per_evaluation();
  loaded_.emplace(half_space_->load(state_.plastic_strain, grid().nz, work_, wanted));
  find_displacements(wanted);
  loaded_->stress(load, stress_);
  add_initial_stress(grid().nz, grid().surface.ny, stress_);
  add_thermal_stress(grid().nz, grid().surface.ny, stress_);
  state_.stress = stress_;
  state_.residual_displacement = displacement_;
  state_.residual_displacement_x = displacement_x_;
  state_.residual_displacement_y = displacement_y_;
  state_.locked_in_energy = locked_in_energy(load, zone_);
  if (window_)
    copy_load(load, committed_load_);
  recover_guess();
}

} // namespace brinell::elastoplastic
