// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/contact/contact_voltage.hpp"
#include "brinell/elastoplastic/placement.hpp"
#include "brinell/halfspace/steady_field.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Softening of the bodies by the temperature around the spots of a contact without a film through which current flows:
/// docs/theory/electrical.md (spot-softening). For open grids.
class SpotSoftening
{
public:
  /// @param materials  of the lower and the upper body; those without a softening law, or that cannot yield, do not soften
  /// @param spreading  sum of the resistivities of the bodies [ohm m]
  SpotSoftening(const SurfaceGrid& contact, const std::array<VolumeGrid, 2>& grids,
                const std::array<const constitutive::Material*, 2>& materials, double spreading);

  /// Factors on the yield stress of a body, one per cell; empty if it does not soften.
  /// @param density  of the cold contact [A/(V m^2)], on the contact grid
  [[nodiscard]] std::vector<double> factors(std::size_t side, const Place& place, std::span<const double> density,
                                            const std::array<contact::HotConductor, 2>& bodies,
                                            const contact::HotContact& hot) const;

private:
  SurfaceGrid contact_;
  std::array<VolumeGrid, 2> grids_;
  std::array<const constitutive::SofteningLaw*, 2> laws_{};
  double spreading_;
  /// Flux -> potential per resistivity, in the layers of each body that softens.
  std::array<std::shared_ptr<const halfspace::SteadyField>, 2> fields_;
};

} // namespace brinell::elastoplastic
