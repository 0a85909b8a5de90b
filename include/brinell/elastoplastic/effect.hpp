// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/interface.hpp"
#include "brinell/elastoplastic/placement.hpp"
#include "brinell/foundation/archive.hpp"
#include "brinell/foundation/column.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace brinell::elastoplastic
{

struct EffectTotals;

/// Pressure, shear and slip of a trial between the surfaces, one value per cell of the contact grid, as friction has found them and
/// effects read them.
class Interaction
{
public:
  /// @param friction  may be nullptr: then there is no shear, and the surfaces slip by `slid` everywhere
  /// @param pressure  [Pa]
  /// @param gap       [m]
  /// @param slid      sliding distance of the undeformed surfaces in the increment [m]
  /// @param step      see Motion::step
  Interaction(const Interface* friction, std::span<const double> pressure, std::span<const double> gap, double slid,
              double step = 0.0)
      : friction_(friction), pressure_(pressure), gap_(gap), slid_(slid), step_(step)
  {
  }

  [[nodiscard]] std::span<const double> pressure() const { return pressure_; } ///< [Pa]
  [[nodiscard]] std::span<const double> gap() const { return gap_; }           ///< [m], >= 0
  /// Pressure before the increment, on the points of the surfaces that lie in each cell at its end [Pa]. Only before the first
  /// trial.
  [[nodiscard]] std::span<const double> pressure_before() const;
  /// Whether the slip of the increment is known before its first trial.
  [[nodiscard]] bool knows_slip() const;
  /// Row of the history that the increment ends at; between two rows within a step.
  [[nodiscard]] double step() const { return step_; }
  /// Slip length in the increment [m].
  [[nodiscard]] std::vector<double> slip_length() const;
  /// Magnitude of the shear [Pa].
  [[nodiscard]] std::vector<double> shear() const;
  /// Of the slip in the increment.
  [[nodiscard]] Interface::Onset onset() const;

private:
  const Interface* friction_;
  std::span<const double> pressure_, gap_;
  double slid_, step_;
};

/// One physics between two surfaces that reads the interaction of a trial and may change the gap: wear, films, adhesion. In each
/// turn of an increment friction has found the shear before.
class Effect
{
public:
  Effect() = default;
  virtual ~Effect() = default;
  Effect(const Effect&) = delete;
  Effect& operator=(const Effect&) = delete;

  [[nodiscard]] virtual std::string_view name() const = 0; ///< in checkpoints
  /// Begins an increment.
  /// @param before  interaction before it
  virtual void begin(const Interaction& before) = 0;
  /// Takes over the interaction of a trial. Called where pressure and effects are solved in turns: with friction, with heat, and if
  /// `Effects::need_turns`; elsewhere what `begin` has set holds for the whole increment.
  /// @returns the largest change of the gap [m]
  virtual double evaluate(const Interaction& trial) = 0;
  /// Change of the gap per pressure, in each cell [m/Pa], >= 0; empty: none.
  [[nodiscard]] virtual std::span<const double> compliance() const { return {}; }
  /// Adds to the gap what does not depend on the pressure [m].
  virtual void add_to_gap(std::span<double> /*gap*/) const {}
  /// Contribution to the energy of the increment's convex problem, with the interaction held but for the pressure [J].
  [[nodiscard]] virtual double held_energy(std::span<const double> /*pressure*/) const { return 0.0; }
  /// Finds the end of a converged increment, before anything of it is committed. It may throw, and leaves the history as it is.
  virtual void settle(const Interaction& /*found*/, const Placement& /*placement*/) {}
  /// Whether the effect releases heat between the surfaces.
  [[nodiscard]] virtual bool heats() const { return false; }
  /// Heat that the effect releases between the surfaces, in each cell of the contact grid [W/m^2]; empty: none. Before `settle` that
  /// at the beginning of the increment, after it the mean of the increment.
  [[nodiscard]] virtual std::span<const double> heat() const { return {}; }
  /// After a converged increment, before `settle`: updates the softening of the bodies to the present contact.
  /// @param turn  of this increment, counts from 0
  /// @returns whether the softening changed so much that the increment has to be solved again with it
  virtual bool renews_softening(const Interaction& /*found*/, const Placement& /*placement*/, int /*turn*/)
  {
    return false;
  }
  /// Factors on the yield stress of the lower (0) or upper (1) body in the increment, one per cell; empty: none.
  [[nodiscard]] virtual std::span<const double> softening(std::size_t /*side*/) const { return {}; }
  /// After a failed increment: forgets what was found in it.
  virtual void restore() {}
  /// Ends an increment: its history goes on from this interaction. It must not fail for reasons that a user can mend; the grids
  /// hold all pressure.
  virtual void commit(const Interaction& found, const Placement& placement) = 0;
  /// Adds the depth that the lower (0) or upper (1) surface has lost or gained since the start to the cells of the contact grid [m].
  virtual void add_depth(std::size_t /*side*/, const Place& /*place*/, std::span<double> /*out*/) const {}
  /// Largest depth since the start of either surface [m].
  [[nodiscard]] virtual double largest_depth() const { return 0.0; }

  /// Writes its totals since the start.
  virtual void report(EffectTotals& /*totals*/) const {}
  /// Passes everything that the next increment depends on.
  virtual void exchange(Archive& archive) = 0;
  /// Takes over the history of the same effect on smaller grids with the same centres.
  virtual void embed(const Effect& smaller) = 0;
};

/// When an effect acts, and which values its totals may take.
struct EffectTraits
{
  bool acts_at_rest = false;    ///< acts between surfaces that never slide, too
  bool may_be_infinite = false; ///< totals may be infinite, as without contact, or not a number
};

/// A total of an effect in histories and summaries.
/// @tparam Totals  the totals of the effect, or those of all effects
template <typename Totals>
struct EffectColumnOf
{
  std::string_view in_summary{}; ///< name in the part of the summary that is called like the effect
  Column<Totals> column{};
  std::string_view effect{};
  EffectTraits traits{};
};

/// The columns of an effect.
template <typename Totals, std::size_t count>
constexpr auto columns_of(std::string_view effect, EffectTraits traits, const EffectColumnOf<Totals> (&columns)[count])
{
  std::array<EffectColumnOf<Totals>, count> all = std::to_array(columns);
  for (EffectColumnOf<Totals>& column : all)
  {
    column.effect = effect;
    column.traits = traits;
  }
  return all;
}

/// A field of an effect in snapshots and results.
struct EffectField
{
  enum class On
  {
    contact, ///< on the contact grid
    bodies   ///< of each surface, on its own grid
  };
  std::string_view effect{};
  const char *name = nullptr, *unit = nullptr, *text = nullptr;
  On on = On::contact;
  bool lowers_surface = false; ///< a depth by which the surface lies deeper than before
  /// @param side  lower (0) or upper (1) surface, of a field of the bodies
  std::span<const double> (*values)(const Effect&, std::size_t side) = nullptr;
};

} // namespace brinell::elastoplastic
