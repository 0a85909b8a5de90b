// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/halfspace/thermal_response.hpp"

#include <array>
#include <cstddef>
#include <list>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace brinell::elastoplastic
{

/// Whether a flux is zero in all cells.
[[nodiscard]] bool is_zero(std::span<const double> flux);

/// Temperature and displacement of the surface of a body by a flux into it during one step, on the contact grid. The operators of
/// the last few motions are kept.
class FluxResponse
{
public:
  /// @param swells         whether the displacement is needed
  /// @param reference      reference distance of the displacement by a stationary steady flux [m]
  /// @param along_surface  HeatNumerics::along_surface
  FluxResponse(const SurfaceGrid& contact, constitutive::Material material, bool swells,
               std::optional<double> reference, bool along_surface)
      : contact_(contact), material_(std::move(material)), swells_(swells), reference_(reference),
        along_surface_(along_surface)
  {
  }

  /// Displacement along z (positive into the body), x and y [m]; only the `parts` are filled.
  using Displacement = std::array<std::vector<double>, 3>;
  [[nodiscard]] std::size_t parts() const { return along_surface_ ? 3 : 1; }

  void set_motion(const halfspace::HeatMotion& motion) { motion_ = motion; } ///< of the flux in the current step
  [[nodiscard]] const halfspace::HeatMotion& motion() const { return motion_; }
  [[nodiscard]] const halfspace::HeatResponse& temperature() { return operators().temperature; }
  /// Temperature rise at the end of the step by a flux [W/m^2] in the step.
  void find_rise(std::span<const double> flux, std::span<double> rise);
  /// Displacement at the end of the step by a flux [W/m^2] in the step.
  void find_displacement(std::span<const double> flux, Displacement& out);
  void move_to(const SurfaceGrid& contact);

private:
  /// Responses to a flux with a given motion, with their buffers.
  struct Operators
  {
    halfspace::HeatMotion motion;
    halfspace::HeatResponse temperature;
    std::optional<halfspace::ThermalResponse> displacement;
    halfspace::HeatResponse::Scratch temperature_scratch;
    halfspace::ThermalResponse::Scratch displacement_scratch;
  };
  [[nodiscard]] Operators& operators();

  SurfaceGrid contact_;
  constitutive::Material material_;
  bool swells_;
  std::optional<double> reference_;
  bool along_surface_;
  halfspace::HeatMotion motion_{};
  std::list<Operators> cached_; ///< most recently used first
};

} // namespace brinell::elastoplastic
