// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/quality.hpp"
#include "brinell/simulation/scenario.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>

/// How a scenario comes to its `Quality`: it says its facts, the judgement is the same for all.
namespace brinell::simulation
{

/// Error that a number had with that many cells per contact radius, and the order by which it falls.
struct Documented
{
  const char* quantity;
  const char* name; ///< in the summary, with * for what is any; empty: it is not there
  double error, cells, order;
  bool elastic = false; ///< also where nothing yields
};

/// What the judgement needs of any scenario.
struct Facts
{
  std::span<const Documented> documented;
  bool forgets_if_elastic = false; ///< without plastic strain a step does not depend on those before: no friction
  std::array<double, 3> cell{};
  double half_x = 0.0, half_y = 0.0; ///< of the contact, estimate [m]
  bool moves = false;                ///< along x
  double approach = 0.0;             ///< largest, estimate [m]
  std::optional<double> first_yield; ///< approach there [m], where the estimate holds
  bool can_yield = false;
  std::optional<double> shift; ///< if it is not one cell [m]
  bool is_plane = false;       ///< nothing varies along y
  bool is_patchy = false; ///< the contact may lie anywhere in a period, so that its extent says nothing of its patches
  std::optional<double> cells_per_wave; ///< the shortest one, of rough flats over a period
  std::array<const Texture*, 2> textures{nullptr, nullptr};
  std::array<const constitutive::Material*, 2> materials{nullptr, nullptr};
  bool is_heated = false; ///< by friction
  /// Under the largest shear that it carries a surface flows on without end: then strain gathers in its uppermost layer, however
  /// thin that is.
  bool flows_freely = false;
  elastoplastic::Settings solver;
};

/// Those that follow from any scenario's bodies, numerics and plan.
/// @param half_x, half_y  half-lengths of the contact, estimates [m]
[[nodiscard]] Facts facts_of(const Numerics& numerics, const ShapedBody& lower, const ShapedBody& upper,
                             const Plan& plan, double half_x, double half_y);

/// What can be told before a run.
/// @param of_scenario  what the scenario itself has to tell
[[nodiscard]] Quality quality_before(const Facts& facts, std::optional<Warning> of_scenario = std::nullopt);

/// What can be told after it, with what the run has seen.
/// @param of_course  what the scenario itself found
[[nodiscard]] Quality quality_after(const Facts& facts, const RunTotals& totals,
                                    std::optional<Warning> of_course = std::nullopt);

/// "2.5 %"
[[nodiscard]] std::string percent_text(double share);

} // namespace brinell::simulation
