// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body.hpp"
#include "brinell/elastoplastic/placement.hpp"
#include "window.hpp"

namespace brinell::elastoplastic
{

namespace
{

/// Copies fields of a grid into the centre of a larger grid, from the surface downwards. Values outside stay; they are 0 if the
/// field had no values before.
void embed(const VolumeGrid& small, std::span<const double> from, const VolumeGrid& large, std::vector<double>& to)
{
  const std::size_t fields = from.size() / small.size();
  to.resize(fields * large.size());
  for (std::size_t field = 0; field < fields; ++field)
    for (int k = 0; k < small.nz; ++k)
      embed_field(small.surface, from.subspan(field * small.size() + small.index(0, 0, k)), large.surface,
                  std::span(to).subspan(field * large.size() + large.index(0, 0, k)));
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
  state_.softening.assign(history.softening.empty() ? 0 : grid().size(), softening_far_away(material_));
  for_parts(
      [&](std::string_view /*name*/, const Traits& traits, const auto& before, auto& now)
      {
        if constexpr (requires { before.size(); })
        {
          if (!traits.is_derived)
            embed(from, before, grid(), now);
        }
        else if (!traits.is_derived)
          now = before;
      },
      history, state_);
  zone_ = PlasticZone(grid(), state_.equivalent);
  has_own_thermal_stress_ = false;
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
