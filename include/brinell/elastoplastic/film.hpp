// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/effect.hpp"
#include "brinell/foundation/field_table.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// A film between two surfaces that conducts badly, such as an oxide, and how slip and wear change it:
/// docs/theory/electrical.md (film).
struct FilmLaw
{
  double resistance = 0.0;       ///< area resistance of both surfaces together at the start [ohm m^2], >= 0
  double growth = 0.0;           ///< area resistance gained per slip path under pressure [ohm m], >= 0
  std::optional<double> limit{}; ///< area resistance that slip does not exceed [ohm m^2], >= resistance
  double wear = 0.0;             ///< area resistance that a surface loses per worn depth [ohm m], >= 0
  /// Resistivity of what covers the lower and the upper surface with the thickness `cover` [ohm m], >= 0; 0: no cover.
  double resistivity = 0.0;
  /// Thickness at the start [m], >= 0, on the surface grids of the bodies; empty: none.
  std::array<std::vector<double>, 2> cover{};

  [[nodiscard]] bool exists() const { return resistance > 0.0 || growth > 0.0 || resistivity > 0.0; }
  /// Whether it may differ from place to place, and so moves with the surfaces.
  [[nodiscard]] bool varies() const { return growth > 0.0 || resistivity > 0.0 || (wear > 0.0 && resistance > 0.0); }
  bool operator==(const FilmLaw&) const = default;
};

/// The film on both surfaces, which moves with them: what covers each at the start, half of the rest and half of what grows.
class Film
{
public:
  /// Film on the grids of the lower and the upper body; empty where it is uniform.
  struct State
  {
    std::array<std::vector<double>, 2> resistance; ///< area resistance [ohm m^2]
    std::array<std::vector<double>, 2> worn;       ///< worn depth that has taken film away [m]

    static constexpr auto table()
    {
      return std::tuple{listed(&State::resistance, {"lower.film", "upper.film"}, {.is_sized = true}),
                        listed(&State::worn, {"lower.film_worn", "upper.film_worn"}, {.is_sized = true})};
    }
  };

  Film(const SurfaceGrid& contact, const SurfaceGrid& lower, const SurfaceGrid& upper, const FilmLaw& law);

  [[nodiscard]] const FilmLaw& law() const { return law_; }
  [[nodiscard]] State start() const;
  /// The film after an increment: slip has made it grow where there is pressure, and wear has removed some.
  /// @param worn  worn depths of the surfaces before the increment [m]; empty spans without wear
  void advance(State& state, const Interaction& found, const Placement& placement,
               const std::array<std::span<const double>, 2>& worn) const;
  /// Area resistance between the surfaces in each cell of the contact grid [ohm m^2]; empty without a film.
  [[nodiscard]] std::vector<double> resistance(const State& state, const Placement& placement) const;
  /// The film of smaller grids with the same centres; where they end it is as at the start.
  [[nodiscard]] State embedded(const Film& smaller, const State& state) const;

private:
  SurfaceGrid contact_;
  std::array<SurfaceGrid, 2> grids_;
  FilmLaw law_;
};

} // namespace brinell::elastoplastic
