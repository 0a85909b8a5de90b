// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/elastoplastic/body_view.hpp"
#include "brinell/elastoplastic/placement.hpp"
#include "brinell/foundation/archive.hpp"
#include "brinell/foundation/hidden.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "brinell/halfspace/surface_temperature.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// What makes a surface warm.
enum class HeatRegime
{
  transient, ///< all heat since the start
  steady     ///< as if the flux of a step had always been there and moved as it does in that step
};

/// What the heat of friction and of plastic work does: docs/theory/heat.md (heat-of-friction).
struct HeatSettings
{
  double fraction = 1.0; ///< of the friction power that goes into the bodies as heat, [0, 1]
  /// Share of the plastic work that becomes heat where it is done, [0, 1] (Taylor and Quinney 1934: about 0.9 of metals).
  double of_plastic_work = 0.9;
  /// Share of the lower body in it, everywhere, before any passes between the surfaces, [0, 1]; none: half.
  std::optional<double> partition{};
  /// Between the surfaces where they touch [W/(m^2 K)], >= 0. None: nothing passes with a given partition; without one nothing
  /// resists, and both have one temperature.
  std::optional<double> conductance{};
  HeatRegime regime = HeatRegime::transient;
  /// Distance from a steady flux that rests on a body at which its surface counts as not displaced [m], > 0.
  std::optional<double> reference{};
  bool displacement = true; ///< whether what the surfaces swell by moves the gap
  bool stress = true;       ///< whether thermal stress counts when the material yields

  [[nodiscard]] double share() const { return partition.value_or(0.5); }
  /// Whether heat passes between the surfaces.
  [[nodiscard]] bool exchanges() const { return conductance ? *conductance > 0.0 : !partition; }
  bool operator==(const HeatSettings&) const = default;
};

/// The heat of a whole run.
struct HeatedRun
{
  HeatSettings settings{};
  halfspace::HeatTimes times{}; ///< of the increments
};

/// How the heat is computed.
struct HeatNumerics
{
  bool shortcuts = true;              ///< Settings::shortcuts
  Symmetry symmetry = Symmetry::none; ///< of all fluxes
};

/// The heat of friction between two bodies: how it is shared, how warm it makes both, and what that does to the surfaces and to
/// the stress. A participant of the increment, as `Interface` is.
///
/// A rigid body without thermal constants neither conducts nor swells. The heat of each body is kept on a grid of its own, at rest
/// on the body and somewhat wider than its material grid when the run begins; it never grows.
class Heating
{
public:
  /// One of the two bodies.
  struct Partner
  {
    VolumeGrid grid;
    constitutive::Material material;
  };
  /// @param twin  mirror_image: the heat of the upper body is that of the lower one in reverse order
  /// @throws InputError if neither body conducts, or a body that deforms does not
  Heating(const SurfaceGrid& contact, const std::array<Partner, 2>& bodies, const HeatedRun& run, Twin twin,
          const HeatNumerics& numerics = {});

  /// How an increment begins.
  struct Start
  {
    std::array<VolumeGrid, 2> grids;        ///< of the bodies today, lower and upper
    std::array<Place, 2> places;            ///< of the contact grid on them, at the end of the increment
    std::array<double, 2> columns;          ///< by which the contact grid moves on them; if `is_steady`, the contact
    double duration = 0.0;                  ///< [s]; 0: nothing happens to the heat
    double slid = 0.0;                      ///< by which the surfaces slide on each other [m], >= 0
    std::span<const double> shear_before{}; ///< along x, at the beginning [Pa]
  };
  void begin(const Start& start);
  [[nodiscard]] bool is_steady() const;
  /// How well two surfaces that touch have the temperatures at which they share the heat.
  enum class Sharing
  {
    rough, ///< to 1e-3 of the difference that the shares make up for: while the pressure is looked for
    fine   ///< to 1e-6
  };
  /// Sets the fluxes that belong to a pressure and a shear, and what they add to the gap.
  /// @returns by how much that changed at most [m]
  double follow(std::span<const double> pressure, std::span<const double> shear, Sharing sharing);
  /// Adds what the surfaces have swollen by [m].
  void add_to_gap(std::span<double> gap) const;
  /// Ends an increment.
  /// @param heat_per_area  of friction in the increment, without the fraction [J/m^2]
  void settle(std::span<const double> pressure, std::span<const double> heat_per_area);
  /// The plastic work of the increment in a body that is solved, before `settle`.
  /// @param side  0: lower, 1: upper, unless it is a twin
  /// @param work  [J/m^3] per cell of its grid
  void settle_work(std::size_t side, std::span<const double> work, const VolumeGrid& body);
  /// Whether plastic work heats that body.
  [[nodiscard]] bool takes_work(std::size_t side) const;
  /// The increment has failed: as it was before it began.
  void restore();

  /// Deviator of the thermal stress at the end of the increment at hand, 5 values per cell [Pa]: of all heat before, and of the
  /// flux that is expected in it. Empty where there is none.
  /// @param side  0: lower, 1: upper, unless it is a twin
  [[nodiscard]] std::span<const double> stress(std::size_t side) const;
  /// Factors on the yield stress at the same temperature, one per cell; empty where nothing softens.
  [[nodiscard]] std::span<const double> softening(std::size_t side) const;

  /// What the end of the last increment shows on the contact grid. A body that does not conduct has its bulk temperature.
  [[nodiscard]] std::span<const double> temperature(std::size_t side) const; ///< of the surface [deg C]
  [[nodiscard]] std::span<const double> flux(std::size_t side) const;        ///< into the body [W/m^2]
  [[nodiscard]] double heat(std::size_t side) const;                         ///< since the start [J]
  /// Heat of friction since the start, times the fraction [J].
  [[nodiscard]] double heat_of_friction() const;
  /// Heat of the plastic work of both bodies since the start [J].
  [[nodiscard]] double heat_of_plastic_work() const;
  /// What the swelling surfaces have done against the pressure since the start [J].
  [[nodiscard]] double work_on_pressure() const;
  /// Most cells, in one increment since the start, that were taken as touching though they kept opening and closing by their own heat:
  /// docs/theory/heat.md (In the increment).
  [[nodiscard]] int most_held_cells() const;
  /// Adds the depth of the surface under the contact grid by which it has shrunk [m]; swollen: negative.
  void add_depth(std::size_t side, const SurfaceGrid& body, const Place& place, std::span<double> out) const;
  /// Temperature [deg C] and thermal stress [Pa] of all layers as of the last increment; an empty part is not wanted.
  struct Layers
  {
    std::span<double> temperature, deviator, trace;
  };
  void layers(std::size_t side, const VolumeGrid& body, const Layers& out) const;

  /// Everything that the next increment depends on.
  void exchange(Archive& archive);
  /// Goes on with a larger contact grid that has the same middle.
  void move_to(const SurfaceGrid& contact);

private:
  struct State;
  Hidden<State> state_;
};

} // namespace brinell::elastoplastic
