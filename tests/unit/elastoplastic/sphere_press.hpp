// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/increment.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace brinell::elastoplastic
{

/// What a small press of two equal steel spheres is made of.
struct PressOptions
{
  Settings settings;
  double unit = 1.0;     ///< metres per unit of length; forces stay in newtons
  int spare_columns = 0; ///< of the material grids, beyond those of the contact
  bool lower_plastic = true, upper_plastic = true;
  double hardening_modulus = 0.0; ///< [Pa]
  std::vector<constitutive::KinematicTerm> kinematic{};
  Friction friction{};                            ///< the upper sphere slides towards +x
  bool sticks = false;                            ///< where friction can hold it
  double upper_stiffness = 1.0;                   ///< Young's modulus of the upper sphere over that of the lower one
  std::vector<halfspace::Inclusion> inclusions{}; ///< of the lower sphere
  double strength = 1.0;                          ///< factor on the yield stress of the inclusions
  bool is_mirrored = false;                       ///< solve one side of y = 0
};

/// Two spheres of radius 1 m pressed together on 13 x 13 cells, 12 layers: about 5 cells to the contact radius at six
/// critical interferences. Constants of the paper's case (E = 200 GPa, nu = 0.32, S_y = 0.9115 GPa), so that first yield
/// is at alpha_c = 2.21429e-4 m.
class SpherePress
{
public:
  static constexpr double alpha_c = 2.214290e-4;   // m
  static constexpr double yield_stress = 0.9115e9; // Pa
  static constexpr int n = 13, nz = 12;

  explicit SpherePress(const PressOptions& options = {})
      : options_(options),
        grid_{n, n, 4.6e-3 / options.unit, 4.6e-3 / options.unit, Boundary::open, Boundary::open, options.is_mirrored},
        contact_(grid_, volume(), volume(), material(options.lower_plastic),
                 material(options.upper_plastic, options.upper_stiffness),
                 Scales{alpha_c / options.unit, 6.0 * alpha_c / options.unit}, options.settings, Twin::none,
                 Textures{{}, {}, inclusions(), {}}, 0.0, {options.friction, 1, options.sticks})
  {
  }

  [[nodiscard]] std::vector<Inclusion> inclusions() const
  {
    std::vector<Inclusion> all;
    all.reserve(options_.inclusions.size());
    for (const halfspace::Inclusion& one : options_.inclusions)
      all.push_back({one, options_.strength});
    return all;
  }

  /// Gap of the undeformed spheres at an interference in units of alpha_c.
  [[nodiscard]] std::vector<double> rigid_gap(double interference) const
  {
    std::vector<double> gap(grid_.size());
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
      {
        const double x = (i - n / 2) * grid_.dx, y = (j - n / 2) * grid_.dy;
        gap[static_cast<std::size_t>(i + n * j)] =
            (x * x + y * y) * options_.unit - interference * alpha_c / options_.unit; // 1/(2 R1) + 1/(2 R2) = 1/m
      }
    return gap;
  }

  [[nodiscard]] IncrementReport press(double interference, Integration integration = Integration::path, int offset = 0)
  {
    Strategy strategy;
    strategy.integration = integration;
    strategy.max_evaluations = options_.settings.max_evaluations;
    strategy.anderson_depth = options_.settings.anderson_depth;
    return press(interference, strategy, offset);
  }
  /// @param along  of spheres that may stick, see Motion
  [[nodiscard]] IncrementReport press(double interference, const Strategy& strategy, int offset = 0,
                                      const contact::TangentialDrive& along = {}, bool slides = true)
  {
    return contact_.advance(rigid_gap(interference), {}, Placement{{offset}, {offset}}, strategy,
                            {.along = along, .slides = slides});
  }

  /// Normal force [N].
  [[nodiscard]] double load() const
  {
    double sum = 0.0;
    for (const double p : contact_.pressure())
      sum += p;
    return sum * grid_.cell_area();
  }
  /// Energy in the bodies, reversible or not, since the start [N m / unit].
  [[nodiscard]] double stored_and_dissipated() const
  {
    double energy = contact_.elastic_energy();
    for (const BodyView& body : {contact_.lower(), contact_.upper()})
      energy += body.solved().state().dissipation + body.solved().state().locked_in_energy;
    return energy;
  }

  [[nodiscard]] const CoupledContact& contact() const { return contact_; }
  [[nodiscard]] CoupledContact& contact() { return contact_; }
  [[nodiscard]] VolumeGrid volume() const
  {
    VolumeGrid v{grid_, nz, 3e-3 / options_.unit};
    v.surface.nx += options_.spare_columns;
    return v;
  }
  [[nodiscard]] constitutive::Material material(bool plastic = true, double stiffness = 1.0) const
  {
    const double area = options_.unit * options_.unit;
    constitutive::Material m{{200e9 * area * stiffness, 0.32}, {}};
    if (plastic)
      m.kinematic = options_.kinematic;
    if (plastic && options_.hardening_modulus > 0.0)
      m.hardening = constitutive::LinearHardening{yield_stress * area, options_.hardening_modulus * area};
    else if (plastic)
      m.hardening = constitutive::PerfectPlasticity{yield_stress * area};
    return m;
  }

private:
  PressOptions options_;
  SurfaceGrid grid_;
  CoupledContact contact_;
};

/// Tolerances so tight that what is compared is not their doing.
inline Settings tight_settings()
{
  Settings s;
  s.yield_tolerance = 1e-9;
  s.displacement_tolerance = 1e-9;
  s.contact_tolerance = 1e-12;
  s.max_evaluations = 400;
  return s;
}

} // namespace brinell::elastoplastic
