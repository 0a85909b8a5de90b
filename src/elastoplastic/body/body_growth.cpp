// SPDX-License-Identifier: BSD-3-Clause
#include "body_parts.hpp"
#include "brinell/foundation/embedding.hpp"

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
  BodyParts& b = *parts_;
  if (!b.is_plastic())
    return;
  b.state.softening.assign(history.softening.empty() ? 0 : b.grid.size(), softening_far_away(b.yield.material));
  for_parts(
      [&](std::string_view /*name*/, const Traits& traits, const auto& before, auto& now)
      {
        if constexpr (requires { before.size(); })
        {
          if (!traits.is_derived)
            embed(from, before, b.grid, now);
        }
        else if (!traits.is_derived)
          now = before;
      },
      history, b.state);
  b.zone = PlasticZone(b.grid, b.state.equivalent);
  b.yield.softening = b.state.softening;
  prepare_trial(b);
  b.evaluation.compute_anew(b.state, load, b.trial.stress);
  b.state.stress = b.trial.stress;
  b.evaluation.store(b.state);
  b.state.locked_in_energy = locked_in_energy(b, load, b.zone);
  recover_guess(b);
}

} // namespace brinell::elastoplastic
