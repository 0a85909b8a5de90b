// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "brinell/green/elastic.hpp"
#include "brinell/halfspace/surface_load.hpp"
#include "brinell/halfspace/surface_temperature.hpp"

#include <vector>

namespace brinell::halfspace
{

/// Where the fields at one depth go: one value per cell of the surface grid in each part, in the middle of the cell; an empty
/// part is not wanted.
struct ThermalLayer
{
  std::span<double> temperature{}; ///< rise [K]
  std::span<double> deviator{};    ///< of the stress [Pa], five components one after the other (order of Deviator)
  std::span<double> trace{};       ///< of the stress [Pa]
};

/// How well the images of open axes are taken off: some 1e-4 of the largest value and better; or some 3e-4, with half of the memory and
/// of the work.
enum class HeatImages
{
  fine,
  coarse
};

/// Layers from the surface down in which heat may arise.
struct HeatedLayers
{
  int count = 0;          ///< 0: heat comes through the surface only
  double thickness = 0.0; ///< of each [m]
};

/// What the heat that has entered the surface of an elastic half space does to it: displacement of the surface, and temperature and
/// stress in the body, step by step: docs/theory/heat.md (thermal-displacement, thermal-stress).
///
/// It remembers as `SurfaceTemperature` does. The surface is free of traction, and beside the flux insulated. Displacement and
/// stress follow the temperature at once, without inertia. Along open axes they are those of a half space without images, to
/// some 1e-3 of the largest one; if both axes are periodic, the mean strain along the surface is zero, and the displacement counts
/// from deep in the body.
class ThermalField
{
public:
  /// @param depths  of the layers [m], >= 0, in any order
  /// @param symmetry  of all fluxes to come, which then move along x only: half of the memory and of the work
  /// @throws InputError if a constant or a time is not above 0, a depth is below 0, or a rigid body has depths
  ThermalField(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic, const HeatTimes& times,
               std::vector<double> depths = {}, HeatImages images = HeatImages::fine,
               Symmetry symmetry = Symmetry::none, const HeatedLayers& heated = {});

  [[nodiscard]] const SurfaceGrid& grid() const;
  [[nodiscard]] const std::vector<double>& depths() const;
  [[nodiscard]] double time() const; ///< of all steps taken up [s]

  /// Takes up a step: `SurfaceTemperature::take_up`.
  void take_up(std::span<const double> flux, const HeatMotion& motion);

  /// More flux of the last step, whose motion has to be the same: as if it had been taken up with the sum of both.
  void amend(std::span<const double> flux, const HeatMotion& motion);

  /// Heat that arises in the body, evenly over the step that begins; what has arisen before spreads over that step. It comes before
  /// the flux of the step. `layers` and `displacement` have it at once as it is at the end of the step, whatever duration they
  /// are asked for; `remaining_temperature` leaves it out. docs/theory/heat.md (buried)
  /// @param heat  [J/m^3] per cell, [layer][cell]; more layers than are planned are thinner than what they are kept in
  void take_up_in_body(std::span<const double> heat, double duration);
  /// As before the last `take_up_in_body`.
  void go_back_in_body();
  /// Adds the rise of the temperature of the surface that the heat in the body gives as it is [K].
  void add_temperature_of_body(std::span<double> temperature) const;

  /// What it remembers of the flux, to go back to it.
  struct Heat;
  [[nodiscard]] Hidden<Heat> heat() const;
  /// Takes up a step and leaves what it remembered before, without a copy: `before` may have room for it.
  void take_up(std::span<const double> flux, const HeatMotion& motion, Hidden<Heat>& before);
  void go_back(const Hidden<Heat>& heat);
  /// Everything that later steps depend on.
  void exchange(Archive& archive);

  /// What is there at the end of the last step, for the duration 0; or what remains of all steps some time later, without what
  /// enters meanwhile.
  /// @param duration  [s], 0 or >= HeatTimes::shortest_step
  void displacement(const SurfaceDisplacement& displacement, double duration = 0.0) const;
  /// @param layer  number of the depth
  void layer(std::size_t layer, const ThermalLayer& out, double duration = 0.0) const;
  /// The layers from the first one on, at less cost than one by one. The same parts of all of them.
  void layers(std::size_t first, std::span<const ThermalLayer> out, double duration = 0.0) const;
  /// Fields of a body at the end of the last step, whose layers begin with the first one. Each component has all layers one after the
  /// other.
  /// @param body  cells in the middle of the grid: `holds`
  void in_body(const VolumeGrid& body, const ThermalLayer& out) const;
  /// Whether cells of another surface are cells in the middle of the grid, and as many lie on both sides of them.
  [[nodiscard]] bool holds(const SurfaceGrid& cells) const;
  /// Of the surface, after a step or more: `SurfaceTemperature::remaining`.
  void remaining_temperature(double duration, std::span<double> temperature) const;

private:
  struct State;
  Hidden<State> state_;
};

} // namespace brinell::halfspace
