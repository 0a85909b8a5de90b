// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/heating.hpp"
#include "elastoplastic/body/touching_cells.hpp"
#include "heated_side.hpp"

#include <array>
#include <list>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Arguments of the constructor of Heating, from which the sides are built again when a checkpoint has other thermal grids.
struct HeatingPlan
{
  std::array<Heating::Partner, 2> bodies; ///< with the grids at the start of the run
  HeatedRun run;
  Twin twin;
  HeatNumerics numerics;
};

/// Heat and work since the start [J].
struct HeatTotals
{
  double of_friction = 0.0, of_source = 0.0, of_effects = 0.0, work_on_tractions = 0.0;
  int most_held = 0;               ///< largest number of held cells in an increment
  double passed = 0.0, held = 0.0; ///< through the surfaces, and the part of it through held cells that are open

  static constexpr auto table()
  {
    using S = HeatTotals;
    return std::tuple{listed(&S::of_friction, {"heat_of_friction"}),
                      listed(&S::of_source, {"heat_of_source"}),
                      listed(&S::of_effects, {"heat_of_effects"}),
                      listed(&S::work_on_tractions, {"work_on_tractions"}),
                      listed(&S::most_held, {"most_held_cells"}, {.range = std::pair{0.0, 2e9}}),
                      listed(&S::passed, {"heat_passed"}),
                      listed(&S::held, {"heat_of_held"})};
  }
};

struct Heating::State
{
  SurfaceGrid contact;
  HeatingPlan plan;
  std::array<HeatedSide, 2> sides;
  double copies; ///< number of bodies that each solved body represents: 2 for twins
  HeatSettings settings = plan.run.settings;
  std::vector<double> imposed = flux_on(settings.source, contact); ///< flux of a source on one body [W/m^2]
  /// Response of the sum of both surface temperatures to a flux into both bodies, for a pair of motions.
  struct BothResponses
  {
    std::array<halfspace::HeatMotion, 2> motions;
    halfspace::HeatResponse response;
    halfspace::HeatResponse::Scratch scratch;
  };
  std::list<BothResponses> cached_responses{}; ///< cache, most recently used first
  // Of the current increment
  double duration = 0.0;
  bool slides = false;
  std::vector<double> pressure_before{};
  std::array<std::vector<double>, 2> along_before{}; ///< relative displacement, lower minus upper, along x and y [m]
  bool is_source_on = false;                         ///< whether a source acts
  bool do_effects_heat = false;                      ///< whether effects between the surfaces release heat
  TouchingCells touching{};
  double friction_of_increment = 0.0, power_of_source = 0.0,
         power_of_effects = 0.0; ///< heat of friction [J], and powers that acted [W]
  HeatTotals totals{};

  [[nodiscard]] bool is_source_between() const
  {
    return is_source_on && settings.source.shape == HeatSource::Shape::contact;
  }
  /// Whether the heat of the increment is counted, but is no steady source: without sliding it comes only from work that the
  /// deformation returns.
  [[nodiscard]] bool heats_without_flux() const { return settings.regime == HeatRegime::steady && !slides; }
  [[nodiscard]] double add_source_between(std::span<const double> pressure, std::vector<double>& heat) const;
  [[nodiscard]] double add_effects(std::span<const double> of_effects, std::vector<double>& heat) const;
  [[nodiscard]] std::vector<double> power_of(std::span<const double> heat_per_area) const;
  [[nodiscard]] std::vector<double> relative_displacement(std::size_t axis) const;
  [[nodiscard]] double work_along(const std::array<std::span<const double>, 2>& shears) const;
  void add_heat_without_flux(double heat);
  void count_held();
  [[nodiscard]] bool is_parted(std::span<const double> pressure) const;
  [[nodiscard]] BothResponses& combined_response();
  [[nodiscard]] double share_flux(const std::vector<double>& heat, std::span<const double> pressure, Sharing sharing);
  [[nodiscard]] std::vector<double> exchanged_flux(const std::vector<double>& heat, std::span<const double> pressure,
                                                   Sharing sharing);
};

} // namespace brinell::elastoplastic
