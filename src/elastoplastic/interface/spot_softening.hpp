// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/contact/constriction.hpp"
#include "brinell/contact/contact_voltage.hpp"
#include "brinell/elastoplastic/placement.hpp"
#include "brinell/halfspace/spreading_field.hpp"

#include <array>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Softening of the bodies by the temperature around the spots of a contact through which current flows:
/// docs/theory/electrical.md (spot-softening). For grids that are open, or periodic in both directions.
class SpotSoftening
{
public:
  /// @param materials  of the lower and the upper body; those without a softening law, or that cannot yield, do not soften
  /// @param spreading  sum of the resistivities of the bodies [ohm m]
  SpotSoftening(const SurfaceGrid& contact, const std::array<VolumeGrid, 2>& grids,
                const std::array<const constitutive::Material*, 2>& materials, double spreading);

  /// The lowest melting temperature of the bodies that soften [deg C]; infinite if none is known.
  [[nodiscard]] double melting_temperature() const { return melting_; }
  /// Factors on the yield stress of a body without a film, one per cell; empty if it does not soften.
  /// @param density  of the cold contact [A/(V m^2)], on the contact grid
  [[nodiscard]] std::vector<double> factors(std::size_t side, const Place& place, std::span<const double> density,
                                            const std::array<contact::HotConductor, 2>& bodies,
                                            const contact::HotContact& hot) const;
  /// Factors on the yield stress with a film.
  /// @param density      [A/m^2], on the contact grid
  /// @param flux         into this body: contact::Constriction::Heat
  /// @param resistivity  of this body when it is hot: contact::as_constant
  [[nodiscard]] std::vector<double> factors(std::size_t side, const Place& place, std::span<const double> density,
                                            std::span<const double> flux, double resistivity,
                                            const contact::HotConductor& body) const;

private:
  [[nodiscard]] std::vector<double> potential(std::size_t side, const Place& place, std::span<const double> flux) const;

  SurfaceGrid contact_;
  std::array<VolumeGrid, 2> grids_;
  std::array<const constitutive::SofteningLaw*, 2> laws_{};
  double spreading_;
  double melting_ = std::numeric_limits<double>::infinity();
  /// Flux -> potential per resistivity, in the layers of each body that softens.
  std::array<std::shared_ptr<const halfspace::SpreadingField>, 2> fields_;
};

} // namespace brinell::elastoplastic
