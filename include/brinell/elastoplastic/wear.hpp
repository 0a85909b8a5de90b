// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/effect.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

/// Wear of two surfaces where they slip on each other: docs/theory/elastoplastic.md (wear).
namespace brinell::elastoplastic
{

/// A wear law of a user: the intensity w(p, q) of the wear of a cell as a function of its pressure and shear.
/// Functions cannot be compared: only copies of this object are equal to it.
class UserWear
{
public:
  using Intensity = std::function<double(double pressure, double shear)>;

  UserWear() = default; ///< no law
  /// @param intensity  w [Pa], >= 0 and finite for pressures > 0. Where it falls with the pressure, large increments may not
  ///                   converge.
  /// @throws InputError if w is not >= 0 and finite at one of the sampled pressures, from 1 Pa to 100 GPa
  explicit UserWear(Intensity intensity);

  /// @param pressure  [Pa], > 0
  /// @param shear     magnitude [Pa]
  /// @throws InputError if w is not >= 0 and finite
  [[nodiscard]] double intensity_at(double pressure, double shear) const;
  bool operator==(const UserWear&) const = default;

private:
  std::shared_ptr<const Intensity> intensity_;
};

/// Wear law, with a coefficient for each surface: worn depth = coefficient x intensity x length slipped.
struct WearLaw
{
  /// The intensity of wear.
  enum class Kind
  {
    archard, ///< pressure
    energy,  ///< shear: the worn depth is the coefficient times the friction work per area
    user     ///< function of both: `function`; not in case files
  };
  double lower = 0.0, upper = 0.0; ///< coefficients [1/Pa], >= 0
  Kind kind = Kind::archard;
  UserWear function{}; ///< of Kind::user

  /// Intensity under a pressure > 0 and a shear, its magnitude [Pa].
  [[nodiscard]] double intensity(double pressure, double shear) const
  {
    switch (kind)
    {
    case Kind::archard:
      return pressure;
    case Kind::energy:
      return shear;
    case Kind::user:
      break;
    }
    return function.intensity_at(pressure, shear);
  }

  [[nodiscard]] double sum() const { return lower + upper; }
  [[nodiscard]] bool wears() const { return sum() > 0.0; }
  /// Whether mirror images stay mirror images.
  [[nodiscard]] bool is_alike() const { return lower == upper; }
  bool operator==(const WearLaw&) const = default;
};

/// Wear of the lower and the upper surface since the start; zero without wear.
struct WearTotals
{
  double worn_volume_lower = 0.0, worn_volume_upper = 0.0;       ///< [m^3]
  double max_worn_depth_lower = 0.0, max_worn_depth_upper = 0.0; ///< [m]
  double max_wear_step = 0.0; ///< largest depth lost by both surfaces together in one increment [m]
  double work_of_wear = 0.0;  ///< work of the pressure on the worn depth since the start [J]
};

inline constexpr auto wear_columns = columns_of<WearTotals>(
    "wear", {},
    {
        {"volume_lower_m3",
         {"worn_volume_lower", "m^3", &WearTotals::worn_volume_lower, "worn volume of the lower body"}},
        {"volume_upper_m3",
         {"worn_volume_upper", "m^3", &WearTotals::worn_volume_upper, "worn volume of the upper body"}},
        {"max_depth_lower_m",
         {"max_worn_depth_lower", "m", &WearTotals::max_worn_depth_lower, "largest worn depth of the lower surface"}},
        {"max_depth_upper_m",
         {"max_worn_depth_upper", "m", &WearTotals::max_worn_depth_upper, "largest worn depth of the upper surface"}},
        {"max_depth_of_an_increment_m",
         {"max_wear_step", "m", &WearTotals::max_wear_step,
          "largest worn depth of both surfaces together in one increment so far"}},
        {"work_J",
         {"work_of_wear", "J", &WearTotals::work_of_wear, "work of the pressure on the worn depth since the start"}},
    });

/// Worn depth of both surfaces, on their own material grids, and the wear of the current increment.
///
/// The worn depth of an increment follows from the pressure at its end (backward Euler) and is solved together with it: for the
/// contact solver wear is a compliant layer whose deflection is proportional to the local pressure. Solution is therefore stable
/// for any amount of wear in an increment. Where surfaces may stick, a point slips while the pressure on it changes, in a contact
/// that rolls by as much as itself: half of the slip counts under the pressure at which it begins (trapezoidal rule), and less of
/// it the more the wear of the increment exceeds what an explicit scheme would bear.
class Wear final : public Effect
{
public:
  /// @param modulus  of the contact [Pa]
  Wear(const SurfaceGrid& contact, const SurfaceGrid& lower, const SurfaceGrid& upper, const WearLaw& law,
       double modulus);

  [[nodiscard]] std::string_view name() const override { return "wear"; }
  void begin(const Interaction& before) override;
  /// Sets the worn depth per pressure.
  /// @returns the largest change of the worn depth of both surfaces together [m]
  double evaluate(const Interaction& trial) override;
  /// Depth that both surfaces lose in the increment per pressure at its end [m/Pa], on the contact grid.
  [[nodiscard]] std::span<const double> compliance() const override { return compliance_; }
  /// Adds the depth that both surfaces lose in the increment whatever the pressure at its end [m].
  void add_to_gap(std::span<double> gap) const override;
  [[nodiscard]] double held_energy(std::span<const double> pressure) const override;
  /// Adds the wear of the increment to the worn depths.
  void commit(const Interaction& found, const Placement& placement) override;

  [[nodiscard]] const WearLaw& law() const { return law_; }
  /// Worn depth since the start of the lower (0) or upper (1) surface.
  [[nodiscard]] std::span<const double> depth(std::size_t side) const { return state_.depth.at(side); } ///< [m]
  [[nodiscard]] double largest_depth(std::size_t side) const;                                           ///< [m]
  [[nodiscard]] double largest_depth() const override { return std::max(largest_depth(0), largest_depth(1)); }
  /// Worn volume, summed from the increments on the contact grid [m^3]; equals the sum of the depth over the cells up to
  /// rounding.
  [[nodiscard]] double volume(std::size_t side) const { return state_.volume.at(side); }
  /// Largest depth lost by both surfaces together in one increment [m].
  [[nodiscard]] double largest_step() const { return state_.largest_step; }
  /// Work of the pressure on the worn depth [J].
  [[nodiscard]] double work() const { return state_.work; }
  /// Adds the worn depth of a surface to the cells of the contact grid above it [m].
  void add_depth(std::size_t side, const Place& place, std::span<double> out) const override;

  void report(EffectTotals& totals) const override;
  void exchange(Archive& archive) override { exchange_members(archive, state_); }
  void embed(const Effect& smaller_grids) override;

private:
  struct Side
  {
    SurfaceGrid grid;
    double share; ///< share of this surface in the wear of both
  };
  /// Wear since the start.
  struct State
  {
    std::array<std::vector<double>, 2> depth; ///< on the grids of the surfaces [m]
    std::array<double, 2> volume{};           ///< [m^3]
    double work = 0.0, largest_step = 0.0;

    static constexpr auto table()
    {
      return std::tuple{listed(&State::depth, {"lower.depth", "upper.depth"}),
                        listed(&State::volume, {"lower.volume", "upper.volume"}), listed(&State::work, {"work"}),
                        listed(&State::largest_step, {"largest_step"})};
    }
  };

  SurfaceGrid contact_;
  WearLaw law_;
  double explicit_limit_; ///< worn depth per pressure that an explicit scheme bears in an increment [m/Pa]
  std::array<Side, 2> sides_;
  State state_;
  std::vector<double> compliance_, pressure_before_; ///< of the current increment
  std::vector<double> from_onset_; ///< depth lost in it by both surfaces whatever the pressure at its end [m]
};

inline constexpr std::array wear_fields{EffectField{.effect = "wear",
                                                    .name = "worn_depth",
                                                    .unit = "m",
                                                    .text = "depth that the surface has lost by wear since the start",
                                                    .on = EffectField::On::bodies,
                                                    .lowers_surface = true,
                                                    .values = [](const Effect& wear, std::size_t side)
                                                    { return static_cast<const Wear&>(wear).depth(side); }}};

} // namespace brinell::elastoplastic
