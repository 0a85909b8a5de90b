// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/elastoplastic/body_view.hpp"
#include "brinell/elastoplastic/heat_source.hpp"
#include "brinell/elastoplastic/placement.hpp"
#include "brinell/foundation/archive.hpp"
#include "brinell/foundation/hidden.hpp"
#include "brinell/halfspace/surface_temperature.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Which heat determines the temperature of a surface.
enum class HeatRegime
{
  transient, ///< all heat since the start
  steady     ///< steady state: as if the flux of the current step had always acted and moved as in that step
};

/// Behaviour of a run when a surface reaches the melting temperature of its softening law.
enum class AtMelting
{
  go_on, ///< the melt counts as a solid with little strength, and the run warns at its end
  stop   ///< the run ends before this step
};

/// Settings for the heat of friction, of plastic work and from outside: docs/theory/heat.md (heat-of-friction).
struct HeatSettings
{
  double fraction = 1.0; ///< share of the friction power that enters the bodies as heat, [0, 1]
  /// Share of the plastic work that becomes heat where it is done, [0, 1] (Taylor and Quinney 1934: about 0.9 for metals).
  double of_plastic_work = 0.9;
  /// Share of the heat of friction that enters the lower body, everywhere, before any heat passes between the surfaces, [0, 1];
  /// none: half.
  std::optional<double> partition{};
  /// Thermal contact conductance between the surfaces where they touch [W/(m^2 K)], >= 0. None: with a given partition no heat
  /// passes between the surfaces; without a partition there is no thermal resistance, and both surfaces have the same
  /// temperature.
  std::optional<double> conductance{};
  HeatRegime regime = HeatRegime::transient;
  /// Distance from a stationary steady flux at which the displacement of the surface is counted as zero [m], > 0.
  std::optional<double> reference{};
  bool displacement = true; ///< whether thermal expansion of the surfaces changes the gap
  bool stress = true;       ///< whether thermal stress contributes to yielding
  AtMelting at_melting = AtMelting::go_on;
  HeatSource source{};

  [[nodiscard]] double share() const { return partition.value_or(0.5); }
  /// Whether heat passes between the surfaces.
  [[nodiscard]] bool exchanges() const { return conductance ? *conductance > 0.0 : !partition; }
  bool operator==(const HeatSettings&) const = default;
};

/// Settings and durations of a whole run.
struct HeatedRun
{
  HeatSettings settings{};
  halfspace::HeatTimes times{}; ///< durations of the increments
  int layers = 0;               ///< layers that the waves in depth resolve, if the grids of the bodies have fewer
};

/// Numerical settings of the computation of heat.
struct HeatNumerics
{
  bool shortcuts = true;      ///< Settings::shortcuts
  bool along_surface = false; ///< whether the thermal displacement along the surface is needed: partial slip
};

/// Heat of friction, of plastic work and from outside in two bodies: its partition, the temperatures, and the thermal
/// displacement of the surfaces and thermal stress that follow. It takes part in each increment like an `Interface`.
///
/// A rigid body without thermal constants neither conducts nor expands. The heat of each body is kept on a separate grid, at rest
/// on the body and somewhat wider than its material grid at the start of the run; the thermal grid never grows.
class Heating
{
public:
  /// One of the two bodies.
  struct Partner
  {
    VolumeGrid grid;
    constitutive::Material material;
  };
  /// @param twin  mirror_image: the thermal fields of the upper body are those of the lower one in reverse order
  /// @throws InputError if neither body conducts, or a body that deforms does not
  Heating(const SurfaceGrid& contact, const std::array<Partner, 2>& bodies, const HeatedRun& run, Twin twin,
          const HeatNumerics& numerics = {});

  /// Data of an increment at its beginning.
  struct Start
  {
    std::array<VolumeGrid, 2> grids; ///< current material grids of the lower and the upper body
    std::array<Place, 2> places;     ///< position of the contact grid on them at the end of the increment
    std::array<double, 2> columns;   ///< columns that the contact grid (if `is_steady`: the contact) moves on them
    double duration = 0.0;           ///< [s]; 0: no heat is generated or conducted
    bool slides = false;             ///< whether the bodies slide or roll on each other
    std::span<const double>
        pressure_before{};    ///< at the beginning [Pa]; may be empty without a source between the surfaces
    bool is_source_on = true; ///< whether HeatSource acts in this increment
    bool has_effects = false; ///< whether effects between the surfaces release heat in this increment
  };
  void begin(const Start& start);
  [[nodiscard]] bool is_steady() const;
  /// Accuracy with which the partition of the heat fulfils the temperature condition between touching surfaces.
  enum class Sharing
  {
    rough, ///< to 1e-3 of the temperature difference that the partition removes: while the pressure is still iterated
    fine   ///< to 1e-6
  };
  /// Computes the fluxes for a pressure and a heat of friction, and the thermal displacement that they cause.
  /// @param heat_per_area  friction work per area in the increment, not yet multiplied by the fraction [J/m^2]
  /// @param of_effects     heat that effects release between the surfaces [W/m^2]; empty: none
  /// @returns the largest change of that displacement [m]
  double follow(std::span<const double> pressure, std::span<const double> heat_per_area, Sharing sharing,
                std::span<const double> of_effects = {});
  /// Adds the thermal displacement of both surfaces to the gap [m].
  void add_to_gap(std::span<double> gap) const;
  /// Adds the thermal displacement of a surface along x (axis 0) or y (1) on the contact grid [m]: after `recall` that before the
  /// increment, after `begin` that of the trial; nothing without HeatNumerics::along_surface.
  /// @param side  0: lower, 1: upper
  void add_along(std::size_t side, std::size_t axis, std::span<double> out) const;
  /// Work of shears on the lower surface on the thermal displacement along the surfaces, lower minus upper, of the trial [J].
  [[nodiscard]] double work_of_shears(const std::array<std::span<const double>, 2>& shears) const;
  /// Before `begin`: returns to the displacement at the end of the last increment, of the points of the surfaces that lie under
  /// the contact grid at the end of the next one.
  /// @param columns  by which the contact grid moves on both bodies
  void recall(const std::array<VolumeGrid, 2>& grids, const std::array<Place, 2>& places,
              const std::array<double, 2>& columns);
  /// Finds the final fluxes of an increment, before `settle`.
  /// @param heat_per_area  as for `follow`, with the heat of points that left the contact
  /// @throws ConvergenceError if the partition of the heat between the surfaces does not converge
  void find_fluxes(std::span<const double> pressure, std::span<const double> heat_per_area,
                   std::span<const double> of_effects = {});
  /// Checks that the thermal grids reach as far as the pressure and the fluxes of the increment and its plastic work.
  /// @param works  plastic work of the bodies as in `settle_work`; empty where it does not heat
  /// @param grids  of the bodies
  /// @throws GridError
  void require_room(std::span<const double> pressure, const std::array<std::vector<double>, 2>& works,
                    const std::array<VolumeGrid, 2>& grids) const;
  /// Ends an increment, after `find_fluxes` and `require_room`, which find all that may fail.
  /// @param shears  mean shears of the increment on the lower surface, for their work on the thermal displacement [Pa]; empty parts
  ///                do no work
  void settle(std::span<const double> pressure, const std::array<std::span<const double>, 2>& shears = {});
  /// Adds the plastic work of the increment in a body that is solved; to be called before `settle`.
  /// @param side  0: lower, 1: upper, unless it is a twin
  /// @param work  plastic work per cell of the body's grid [J/m^3]
  void settle_work(std::size_t side, std::span<const double> work, const VolumeGrid& body);
  /// Whether plastic work heats that body.
  [[nodiscard]] bool takes_work(std::size_t side) const;
  /// After a failed increment: returns to the state before its beginning.
  void restore();

  /// Deviator of the thermal stress at the end of the current increment, 5 values per cell [Pa]: from all earlier heat and from
  /// the flux expected in this increment. Empty if there is none.
  /// @param side  0: lower, 1: upper, unless it is a twin
  [[nodiscard]] std::span<const double> stress(std::size_t side) const;
  /// Factors on the yield stress at the corresponding temperature, one per cell; empty if the material does not soften.
  [[nodiscard]] std::span<const double> softening(std::size_t side) const;

  /// Results at the end of the last increment, on the contact grid. A body that does not conduct has its bulk temperature.
  [[nodiscard]] std::span<const double> temperature(std::size_t side) const; ///< of the surface [deg C]
  [[nodiscard]] std::span<const double> flux(std::size_t side) const;        ///< into the body [W/m^2]
  [[nodiscard]] double heat(std::size_t side) const;                         ///< since the start [J]
  /// Heat of friction since the start, times the fraction [J].
  [[nodiscard]] double heat_of_friction() const;
  /// Heat of the HeatSource since the start [J].
  [[nodiscard]] double heat_of_source() const;
  /// Heat of effects between the surfaces since the start [J].
  [[nodiscard]] double heat_of_effects() const;
  /// Heat of the plastic work of both bodies since the start [J].
  [[nodiscard]] double heat_of_plastic_work() const;
  /// Work of the thermal displacement of the surfaces against the pressure and, with HeatNumerics::along_surface, the shear since
  /// the start [J].
  [[nodiscard]] double work_on_tractions() const;
  /// Largest number of cells, in one increment since the start, that were held in contact because their own heat kept opening and
  /// closing them: docs/theory/heat.md (In the increment).
  [[nodiscard]] int most_held_cells() const;
  /// Share of the heat since the start that passed through such cells while they were open.
  [[nodiscard]] double share_of_held_cells() const;
  /// Adds the thermal displacement of the surface under the contact grid, positive into the body [m]; expansion is negative.
  void add_depth(std::size_t side, const SurfaceGrid& body, const Place& place, std::span<double> out) const;
  /// Output of `layers`: temperature [deg C] and thermal stress [Pa] in all layers after the last increment; empty spans are
  /// skipped.
  struct Layers
  {
    std::span<double> temperature, deviator, trace;
  };
  void layers(std::size_t side, const VolumeGrid& body, const Layers& out) const;
  /// Temperature and thermal stress in one layer, in which all spans are filled; of a body that conducts no heat they are left as they are. It differs
  /// from that of all layers together by a small part of the error with which images are removed, halfspace::HeatImages.
  void layer(std::size_t side, const VolumeGrid& body, std::size_t layer, const Layers& out) const;

  /// Everything that the next increment depends on.
  void exchange(Archive& archive);
  /// Continues with a larger contact grid that has the same centre.
  void move_to(const SurfaceGrid& contact);

private:
  struct State;
  Hidden<State> state_;
};

} // namespace brinell::elastoplastic
