// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/depth_profile.hpp"
#include "brinell/constitutive/hardening.hpp"
#include "brinell/constitutive/kinematic.hpp"
#include "brinell/constitutive/softening.hpp"
#include "brinell/green/conductive_stack.hpp"
#include "brinell/green/elastic_stack.hpp"
#include "brinell/green/thermal_stack.hpp"

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

namespace brinell::constitutive
{

/// Electrical constants of a material.
struct Electrical
{
  double resistivity = 0.0;             ///< at 20 deg C [ohm m], > 0
  double temperature_coefficient = 0.0; ///< of the resistivity, of that at 20 deg C [1/K], >= 0

  /// @param t  [deg C]
  [[nodiscard]] double resistivity_at(double t) const ///< [ohm m]
  {
    return resistivity * (1.0 + temperature_coefficient * (t - 20.0));
  }
  bool operator==(const Electrical&) const = default;
};

/// A layer of a coating, bonded to what is above and beneath.
struct Coat
{
  double thickness = 0.0; ///< [m], > 0
  Elastic elastic;
  std::optional<HardeningLaw> hardening{}; ///< empty: the layer stays elastic
  std::optional<Electrical> electrical{};  ///< of the layers of a body that conducts
  std::optional<Thermal> thermal{};        ///< of the layers of a body whose temperature is computed
  bool operator==(const Coat&) const = default;
};

/// A material: elastic, or elastic-plastic if it has a hardening law.
struct Material
{
  Elastic elastic;
  std::optional<HardeningLaw> hardening;  ///< size of the yield surface; empty: the body stays elastic
  std::vector<KinematicTerm> kinematic{}; ///< back stresses, which move the yield surface, of the substrate
  DepthProfile yield_factor{};      ///< factor on the yield stress, e.g. of a case-hardened body; 1 without points
  DepthProfile initial_stress{};    ///< biaxial stress xx = yy before the first load [Pa], tension positive
  std::optional<Thermal> thermal{}; ///< empty: the temperature of the body is not computed
  double temperature = 20.0;        ///< of the bulk [deg C]
  std::optional<Electrical> electrical{};  ///< empty: the body insulates
  std::optional<SofteningLaw> softening{}; ///< factor on the yield stress as a function of temperature; empty: 1
  /// From the surface down, on the substrate, which has the constants above; without kinematic hardening and softening.
  std::vector<Coat> layers{};

  [[nodiscard]] bool is_plastic() const;
  /// Whether a part of it is plastic and never hardens.
  [[nodiscard]] bool is_perfectly_plastic() const;
  /// The law that sets the units of results: that of the substrate or, if that stays elastic, of the uppermost layer that
  /// yields. The material must be plastic.
  [[nodiscard]] const HardeningLaw& law() const;
  /// Laws of the layers and, last, of the substrate.
  [[nodiscard]] std::vector<std::optional<HardeningLaw>> laws() const;
  [[nodiscard]] ElasticStack stack() const;
  /// Resistivities at the temperature of the bulk; the material and its layers must conduct.
  [[nodiscard]] ConductiveStack conductors() const;
  /// Thermal constants of all layers; the material and its layers must have them.
  [[nodiscard]] ThermalStack thermal_stack() const;
  /// Whether heat expands a part of it.
  [[nodiscard]] bool expands() const;
  /// Constants at the surface.
  [[nodiscard]] const Elastic& top() const { return layers.empty() ? elastic : layers.front().elastic; }
  /// The constants, among those of the substrate and the layers, with the largest contact compliance.
  [[nodiscard]] const Elastic& softest() const;
  bool operator==(const Material&) const = default;
};

} // namespace brinell::constitutive
