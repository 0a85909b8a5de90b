// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/current.hpp"

#include <memory>

namespace brinell::elastoplastic
{

/// Numbers of the heat conduction between the bodies at the end of a step; zero unless the conductivities of both are known.
struct ConductionTotals
{
  double thermal_contact_conductance = 0.0; ///< [W/K]; 0 without contact, infinite where bodies touch everywhere
};

inline constexpr auto conduction_columns = columns_of<ConductionTotals>(
    "conduction", {.acts_at_rest = true, .may_be_infinite = true},
    {
        {"conductance_W_K",
         {"thermal_contact_conductance", "W/K", &ConductionTotals::thermal_contact_conductance,
          "heat that would flow through the contact, without a film, per difference of the bulk temperatures; 0 unless "
          "the conductivities of both bodies are known"}},
    });

/// Conduction of heat through the contact, if the bodies had different temperatures: the constriction of the current with
/// 1/conductivity in place of the resistivity: docs/theory/electrical.md (conduction). It acts on nothing.
class Conduction final : public Effect
{
public:
  /// @param current  nullptr unless both bodies conduct current; must outlive this object
  Conduction(const halfspace::SurfaceCompliance& compliance, double modulus, const Current::Materials& materials,
             const Current* current);

  /// Whether the conductivities of both bodies are known: by their thermal constants, or by their resistivities; with layers by the
  /// resistivities of all of them.
  [[nodiscard]] static bool is_known(const Current::Materials& materials);

  [[nodiscard]] std::string_view name() const override { return "conduction"; }
  void begin(const Interaction& /*before*/) override {}
  double evaluate(const Interaction& /*trial*/) override { return 0.0; }
  void commit(const Interaction& found, const Placement& placement) override;
  void report(EffectTotals& totals) const override;
  void exchange(Archive& archive) override { exchange_members(archive, state_); }
  void embed(const Effect& smaller_grids) override;

private:
  struct State
  {
    double conductance = 0.0;    ///< [W/K]
    std::vector<double> density; ///< guess of the next solution

    static constexpr auto table()
    {
      return std::tuple{listed(&State::conductance, {"conductance"}),
                        listed(&State::density, {"density"}, {.is_sized = true})};
    }
  };

  std::unique_ptr<const halfspace::SurfaceCompliance> layered_; ///< nullptr: homogeneous bodies
  double spreading_; ///< sum of 1/conductivity of the bodies, at their surfaces [K m/W]
  contact::Constriction constriction_;
  const Current* current_;
  State state_;
};

} // namespace brinell::elastoplastic
