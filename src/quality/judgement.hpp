// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/quality/quality.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Derives the `Quality` of a result: each scenario supplies its facts, and the rules are the same for all.
namespace brinell::quality
{

/// Documented discretization error of a number with a given number of cells per contact radius, and its order of convergence: a
/// row of the tables in the files of the scenarios.
struct Documented
{
  const char* quantity;
  const char* name; ///< pattern of the name in the summary, * matches anything; empty: not in the summary
  double error, cells, order;
  /// Region that the cells must resolve.
  enum class Of
  {
    contact,         ///< of bodies that yield
    elastic_contact, ///< of any bodies
    plastic_zone     ///< as finely as the contact
  };
  Of of = Of::contact;
  double of_steps = 0.0; ///< further error over that of the plastic work, if steps are few: see error_of_steps
  bool is_of_lower =
      false; ///< a dent of the lower body, whose relative error grows where the upper body has the larger dents
  double further = 0.0;     ///< further error, which depends neither on the cells nor on the steps
  double on_textures = 1.0; ///< factor on `error` where a body has a texture, with its shortest length in cells
  double on_coats = 1.0;    ///< factor on `error` where a body that yields has layers
};

/// Regions of the rows.
using Of = Documented::Of;

/// Documented::error of the temperature rise with 8 cells where surfaces stick in places: the heat arises in few cells
/// at the rim.
inline constexpr double temperature_error_of_sticking = 0.12;

/// Facts about a run of any scenario that the rules need.
struct Facts
{
  Documented temperature_rise{.quantity = "temperature rise",
                              .name = "",
                              .error = 0.015,
                              .cells = 8.0,
                              .order = 1.0,
                              .of = Documented::Of::elastic_contact,
                              .of_steps = 0.2}; ///< without sticking
  Documented slip{.quantity = "slip",
                  .name = "",
                  .error = 0.015,
                  .cells = 8.0,
                  .order = 1.0,
                  .of = Documented::Of::elastic_contact,
                  .of_steps = 0.3}; ///< of the slip and of all that it accumulates; without sticking
  std::vector<Documented> documented;
  bool forgets_if_elastic =
      false; ///< without plastic strain a step does not depend on earlier ones: there is no friction
  std::array<double, 3> cell{};
  double half_x = 0.0, half_y = 0.0; ///< of the contact, estimate [m]
  bool moves = false;                ///< the contact moves along x
  double approach = 0.0;             ///< estimate of the largest approach [m]
  std::optional<double> first_yield; ///< approach at first yield [m]; none where the estimate does not hold
  bool can_yield = false;
  std::optional<double> shift; ///< motion per step [m]; none if it is one cell
  std::optional<int> steps;    ///< by which a contact that does not move gets from one load to the next
  bool is_plane = false;       ///< nothing varies along y
  bool is_patchy =
      false; ///< the contact may lie anywhere in a period, so that its extent does not show the size of its patches
  std::optional<double> between_ends;      ///< length of a contact that ends at the plane ends of a roller [m]
  bool is_smooth = false;                  ///< neither body has a texture
  std::optional<double> cells_per_wave;    ///< cells per shortest wave, for rough flats over a period
  std::optional<double> cells_per_texture; ///< cells per shortest wave of any textured bodies; see roughness.hpp
  std::array<const simulation::Texture*, 2> textures{nullptr, nullptr};
  std::array<const constitutive::Material*, 2> materials{nullptr, nullptr};
  std::array<simulation::EmbeddedCells, 2> inclusions{}; ///< of each body
  bool is_heated = false;                                ///< by friction or a source
  bool has_source = false;                               ///< of heat, other than friction
  std::vector<std::string_view> effects;                 ///< names of those that act
  elastoplastic::Effects effect_settings;
  std::array<bool, 2> is_softened_by_current{}; ///< yield stress of each body
  bool has_thermal_stress = false;              ///< thermal stress is part of the yield condition
  /// In which a point is heated [s]: the contact passes it, on the body over which it moves faster; or half a cycle.
  std::optional<double> heating_time;
  const char* while_heated = "while the contact passes a point";
  double shear_limit = std::numeric_limits<double>::infinity(); ///< given [Pa]
  bool hardens = true;                                          ///< every surface that yields
  /// The surfaces slide everywhere in the contact, and do not stick anywhere.
  bool slides = false;
  bool may_stick = false;       ///< the surfaces may stick in places
  double friction = 0.0;        ///< coefficient
  double peak_pressure = 0.0;   ///< see Plan
  double peak_over_yield = 0.0; ///< see Plan
  bool is_yield_exact = false;  ///< whether that of first yield is exact: of round contacts and endless lines
  elastoplastic::Settings solver;
  std::optional<Warning> warning{};        ///< of the scenario, before those of the solver
  std::vector<Warning> further_warnings{}; ///< of the scenario, after all others
};

/// Facts that follow from bodies, numerics and plan in any scenario.
/// @param half_x, half_y  half-lengths of the contact, estimates [m]
[[nodiscard]] Facts facts_of(const simulation::PairCase& c, const simulation::Plan& plan, double half_x, double half_y);

/// Quality before a run.
[[nodiscard]] Quality quality_before(const Facts& facts);

/// Quality after a run, from its totals.
[[nodiscard]] Quality quality_after(const Facts& facts, const simulation::RunTotals& totals);

} // namespace brinell::quality
