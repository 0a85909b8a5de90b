// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/contact/constriction.hpp"
#include "brinell/contact/contact_voltage.hpp"
#include "brinell/elastoplastic/film.hpp"
#include "brinell/elastoplastic/wear.hpp"

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

/// Electric current between two bodies: docs/theory/electrical.md.
namespace brinell::elastoplastic
{

/// Drive of a current between two bodies that conduct, and a film between them. Without current and voltage only the
/// resistance is found.
struct CurrentDrive
{
  std::vector<double>
      current{}; ///< at the end of `steps` [A], >= 0; over a period, that of one period; empty: not given
  std::vector<double>
      voltage{}; ///< between points far from the contact, at the end of `steps` [V], >= 0; empty: not given
  std::vector<double> steps{}; ///< rows of the history, ascending; empty: 0, 1, 2, ...
  FilmLaw film{};

  /// A drive at the end of a step: linear between the given steps, constant before the first and after the last; none if empty.
  [[nodiscard]] std::optional<double> at(double step, std::span<const double> values) const;
  /// Whether a current other than 0 flows in some step.
  [[nodiscard]] bool drives() const;
  bool operator==(const CurrentDrive&) const = default;
};

class SpotSoftening;

/// Numbers of the current at the end of a step; zero unless both bodies conduct, NaN where there is no steady state.
struct CurrentTotals
{
  double contact_resistance = 0.0;  ///< [ohm]; infinite without contact
  double current = 0.0;             ///< [A]
  double voltage = 0.0;             ///< [V]; infinite for a current without contact
  double electric_power = 0.0;      ///< [W]
  double max_current_density = 0.0; ///< largest mean over a cell [A/m^2]
  int current_spots = 0;            ///< patches of the contact
  double largest_spot_share = 0.0;  ///< of a patch in the current
  double contact_temperature = 0.0; ///< largest one, steady, by the current alone [deg C]
  double film_resistance = 0.0;     ///< mean over the contact of the area resistance of the film [ohm m^2]
  // Since the start
  double softening_error = 0.0;        ///< largest change of a factor on the yield stress that was not iterated further
  double min_contact_resistance = 0.0; ///< [ohm]
  double max_contact_temperature = 0.0; ///< [deg C]
};

inline constexpr auto current_columns = columns_of<CurrentTotals>(
    "current", {.acts_at_rest = true, .may_be_infinite = true},
    {
        {"resistance_ohm",
         {"contact_resistance", "ohm", &CurrentTotals::contact_resistance,
          "resistance between points far from the contact in both bodies; 0 unless both conduct"}},
        {"current_A", {"current", "A", &CurrentTotals::current, "electric current"}},
        {"voltage_V", {"voltage", "V", &CurrentTotals::voltage, "voltage between points far from the contact"}},
        {"power_W", {"electric_power", "W", &CurrentTotals::electric_power, "voltage times current"}},
        {"max_density_A_m2",
         {"max_current_density", "A/m^2", &CurrentTotals::max_current_density,
          "largest density of the current, mean over a cell"}},
        {"spots", {"current_spots", "1", &CurrentTotals::current_spots, "patches of the contact"}},
        {"largest_spot_share",
         {"largest_spot_share", "1", &CurrentTotals::largest_spot_share, "largest share of a patch in the current"}},
        {"temperature_degC",
         {"contact_temperature", "degC", &CurrentTotals::contact_temperature,
          "largest temperature by the current alone, steady"}},
        {"film_resistance_ohm_m2",
         {"film_resistance", "ohm m^2", &CurrentTotals::film_resistance,
          "area resistance of the film between the surfaces, mean over the contact"}},
        {"min_resistance_ohm",
         {"min_contact_resistance", "ohm", &CurrentTotals::min_contact_resistance,
          "smallest resistance of the contact since the start"}},
        {"max_temperature_degC",
         {"max_contact_temperature", "degC", &CurrentTotals::max_contact_temperature,
          "largest temperature by the current since the start"}},
    });

/// Resistivity, at its surface, conductivity and temperature of a body that has a resistivity.
[[nodiscard]] contact::HotConductor conductor(const constitutive::Material& material);

/// Potential of a flow between layered bodies, on the grid of their contact; nullptr for homogeneous bodies, which the compliance
/// of the contact serves.
/// @param stack  resistances of a body and its layers
[[nodiscard]] std::unique_ptr<const halfspace::SurfaceCompliance>
layered_conductors(const halfspace::SurfaceCompliance& compliance,
                   const std::array<const constitutive::Material*, 2>& materials,
                   ConductiveStack (*stack)(const constitutive::Material&));

/// Current through the contact at the end of each increment. It heats the bodies where their heat is computed.
class Current final : public Effect
{
public:
  using Materials = std::array<const constitutive::Material*, 2>; ///< of the lower and the upper body

  /// @param compliance  of the contact; must outlive this object
  /// @param modulus     of the contact [Pa]
  /// @param wear        which takes the film away; must outlive this object; nullptr: none
  Current(const halfspace::SurfaceCompliance& compliance, const VolumeGrid& lower, const VolumeGrid& upper,
          double modulus, const Materials& materials, const CurrentDrive& drive, const Wear* wear);
  ~Current() override;
  Current(const Current&) = delete;
  Current& operator=(const Current&) = delete;

  [[nodiscard]] static bool flows(const Materials& materials)
  {
    return materials[0]->electrical && materials[1]->electrical;
  }

  [[nodiscard]] std::string_view name() const override { return "current"; }
  void begin(const Interaction& before) override;
  double evaluate(const Interaction& /*trial*/) override { return 0.0; }
  /// Finds film, resistance and current of the contact.
  void settle(const Interaction& found, const Placement& placement) override;
  void restore() override;
  void commit(const Interaction& found, const Placement& placement) override;
  [[nodiscard]] bool heats() const override { return drive_.drives(); }
  /// Whether the steady temperature around the spots softens a body: under a current, on grids that are open or periodic in both
  /// directions.
  [[nodiscard]] static bool softens(const constitutive::Material& material, const CurrentDrive& drive,
                                    const SurfaceGrid& contact);
  bool renews_softening(const Interaction& found, const Placement& placement, int turn) override;
  [[nodiscard]] std::span<const double> softening(std::size_t side) const override { return softening_.at(side); }
  /// Density of the current times the voltage: the heat of the constriction in both bodies, and of the film.
  [[nodiscard]] std::span<const double> heat() const override { return heat_; }
  /// Area resistance of the film in each cell of the contact grid [ohm m^2]; empty without a film.
  [[nodiscard]] std::span<const double> film() const { return state_.film; }
  /// Density of the current, mean over each cell of the contact grid [A/m^2].
  [[nodiscard]] std::span<const double> density() const { return state_.density; }

  /// Conductance of the last contact times the sum of the resistivities, if no film is between the surfaces and the bodies have no
  /// layers [m]: it depends on the contact only.
  [[nodiscard]] std::optional<double> clean_conductance() const { return clean_conductance_; }

  void report(EffectTotals& totals) const override;
  void exchange(Archive& archive) override;
  void embed(const Effect& smaller_grids) override;

private:
  struct State
  {
    std::vector<double> density;  ///< [A/m^2]
    std::vector<double> film;     ///< area resistance of the film on the contact grid [ohm m^2]; empty: none
    std::vector<double> per_volt; ///< guess of the next solution [A/(V m^2)]
    double resistance = 0.0, current = 0.0, voltage = 0.0, largest_density = 0.0, largest_share = 0.0,
           temperature = 0.0, mean_film = 0.0;
    double softening_error = 0.0;
    double heating_voltage = 0.0; ///< voltage times current is the heat [V]; 0 where the heat is not known
    double least_resistance = std::numeric_limits<double>::infinity();
    double largest_temperature = -std::numeric_limits<double>::infinity();
    int spots = 0;
    std::array<std::vector<double>, 2> softening; ///< of the lower and the upper body; empty: none

    /// Heat in a cell [W/m^2]; 0 without a heating voltage, also where the density has no limit.
    [[nodiscard]] double heat(std::size_t cell) const
    {
      return heating_voltage == 0.0 ? 0.0 : heating_voltage * density[cell];
    }

    static constexpr auto table()
    {
      return std::tuple{listed(&State::density, {"density"}, {.is_sized = true}),
                        listed(&State::film, {"film"}, {.is_sized = true}),
                        listed(&State::per_volt, {"per_volt"}, {.is_sized = true}),
                        listed(&State::resistance, {"resistance"}),
                        listed(&State::current, {"current"}),
                        listed(&State::voltage, {"voltage"}),
                        listed(&State::largest_density, {"largest_density"}),
                        listed(&State::largest_share, {"largest_share"}),
                        listed(&State::temperature, {"temperature"}),
                        listed(&State::mean_film, {"mean_film"}),
                        listed(&State::softening_error, {"softening_error"}),
                        listed(&State::heating_voltage, {"heating_voltage"}),
                        listed(&State::least_resistance, {"least_resistance"}),
                        listed(&State::largest_temperature, {"largest_temperature"}),
                        listed(&State::spots, {"spots"}),
                        listed(&State::softening, {"lower.softening", "upper.softening"}, {.is_sized = true})};
    }
  };

  struct FilmHeat
  {
    std::vector<double> density; ///< [A/m^2]
    std::array<contact::Conductor, 2> bodies;
    contact::Constriction::Heat heat;
  };
  struct Hot
  {
    contact::HotContact contact{};
    double current = 0.0; ///< [A]
  };

  [[nodiscard]] std::vector<double> film_after(const Interaction& found, const Placement& placement);
  [[nodiscard]] std::optional<std::array<std::vector<double>, 2>> softening_by_current(const Interaction& found,
                                                                                       const Placement& placement);
  [[nodiscard]] FilmHeat heat_of_film(const Hot& hot, const contact::Flow& flow, std::span<const double> film,
                                      std::span<const double> pressure);
  double drive_through(const contact::Flow& flow, const Interaction& found);
  [[nodiscard]] std::optional<Hot> hot_contact(const contact::Flow& flow, std::span<const double> film,
                                               double step) const;
  void find_density(const contact::Flow& flow, double current);
  void heat_up(const Hot& hot, const contact::Flow& flow, std::span<const double> pressure);
  void find_means(std::span<const double> pressure);

  std::unique_ptr<const halfspace::SurfaceCompliance> layered_; ///< nullptr: homogeneous bodies
  SurfaceGrid grid_;
  std::array<contact::HotConductor, 2> bodies_;
  double spreading_; ///< sum of the resistivities at the surfaces, at the temperatures far from the contact [ohm m]
  contact::Constriction constriction_;
  CurrentDrive drive_;
  Film film_law_;
  const Wear* wear_;
  std::unique_ptr<const SpotSoftening> spot_softening_; ///< none: nothing softens
  State state_;
  Film::State film_state_;
  // Of the current increment
  std::array<std::vector<double>, 2> softening_; ///< see State
  double softening_error_ = 0.0;
  State next_; ///< end of the increment
  Film::State next_film_;
  std::vector<double> heat_; ///< see `heat`
  std::optional<double> clean_conductance_{};
};

inline constexpr std::array current_fields{EffectField{.effect = "current",
                                                       .name = "current_density",
                                                       .unit = "A/m^2",
                                                       .text = "density of the electric current, mean over each cell",
                                                       .values = [](const Effect& current, std::size_t)
                                                       { return static_cast<const Current&>(current).density(); }},
                                           EffectField{.effect = "current",
                                                       .name = "film_resistance",
                                                       .unit = "ohm m^2",
                                                       .text = "area resistance of the film between the surfaces",
                                                       .values = [](const Effect& current, std::size_t)
                                                       { return static_cast<const Current&>(current).film(); }}};

} // namespace brinell::elastoplastic
