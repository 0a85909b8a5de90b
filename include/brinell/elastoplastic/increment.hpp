// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"
#include "brinell/elastoplastic/body_view.hpp"
#include "brinell/elastoplastic/effects.hpp"
#include "brinell/elastoplastic/heating.hpp"
#include "brinell/elastoplastic/partial_slip.hpp"
#include "brinell/elastoplastic/sliding.hpp"
#include "brinell/elastoplastic/strategy.hpp"

#include <memory>
#include <vector>

/// One increment of two elastic-plastic bodies in contact: mutually consistent pressure, plastic strain and residual
/// displacement.
namespace brinell::elastoplastic
{

/// Textures of the surfaces before the first load, on the material grids, as depth into the body [m]; empty: smooth. And inclusions in
/// the bodies, in cells of these grids.
struct Textures
{
  std::vector<double> lower, upper;
  std::vector<Inclusion> lower_inclusions{}, upper_inclusions{};
};

/// Pressure, gap and approach at the end of an increment.
struct SurfaceState
{
  double approach = 0.0;             ///< [m]
  std::vector<double> pressure, gap; ///< on the contact grid [Pa], [m]

  static constexpr auto table()
  {
    using S = SurfaceState;
    return std::tuple{listed(&S::approach, {"approach"}), listed(&S::pressure, {"pressure"}),
                      listed(&S::gap, {"gap"}, {.is_derived = true})};
  }
};

/// All that lies between the bodies.
struct Between
{
  SurfaceState state{};
  Placement placement{};
  std::unique_ptr<Interface> interface = nullptr; ///< none without friction
  std::unique_ptr<Heating> heating{};             ///< none without heat
  std::vector<std::unique_ptr<Effect>> effects{};
};

/// The history of two bodies, with the grids of its fields.
struct History
{
  SurfaceGrid contact;
  std::array<VolumeGrid, 2> grids; ///< of the lower and the upper body
  Between between;
  std::vector<BodyState> solved{}; ///< the lower body, and the upper one unless it is a twin
};

/// Settings of what happens between the surfaces: friction, direction of sliding, heat, further effects.
struct Sliding
{
  Friction friction{};
  int direction = 1;   ///< in which the upper body slides over the lower one: +1 towards +x, or -1
  bool sticks = false; ///< partial slip: surfaces stick where friction can hold them; `direction` is not used then
  /// Heat of friction; none: heat is not computed. The steady regime is not available where surfaces may stick.
  std::optional<HeatedRun> heat{};
  Effects effects{};
};

struct ContactParts;

/// The solver of the coupled problem of contact and plastic flow, with its buffers. Bodies are named by their side: 0 is the lower
/// one, 1 the upper one.
class CoupledContact
{
public:
  /// @param contact    if the grids are mirrored, so are both bodies, their surfaces, and all later increments: half of each body
  ///                   is solved. Not where surfaces may stick.
  /// @param twin       unless none, the upper body has, and keeps, the grid, material and history of the lower one (or their
  ///                   mirror image): only the lower one is solved.
  /// @param reference  reference distance of the displacement with one periodic axis, see halfspace::SurfaceCompliance [m].
  /// @param ranks      that solve the contact together (docs/theory/ranks.md): all of them call the same functions at the same
  ///                   time. nullptr: this process alone.
  CoupledContact(const SurfaceGrid& contact, const VolumeGrid& lower, const VolumeGrid& upper,
                 const constitutive::Material& lower_material, const constitutive::Material& upper_material,
                 const Scales& scales, const Settings& settings, Twin twin = Twin::none, Textures textures = {},
                 double reference = 0.0, const Sliding& sliding = {},
                 const std::shared_ptr<const Communicator>& ranks = nullptr,
                 const std::shared_ptr<const Device>& device = nullptr);

  [[nodiscard]] BodyView lower() const;
  [[nodiscard]] BodyView upper() const;
  /// Whether backward Euler minimises an energy in an increment, as Strategy::watch_energy requires. Under an imposed mean gap
  /// there is no such energy, because the approach that gives this gap changes with the plastic strain.
  [[nodiscard]] bool has_energy(contact::Drive::Kind drive) const;
  [[nodiscard]] std::span<const double> pressure() const
  {
    return between_->state.pressure;
  }                                                                                 ///< on the contact grid [Pa]
  [[nodiscard]] std::span<const double> gap() const { return between_->state.gap; } ///< on the contact grid [m]
  [[nodiscard]] double approach() const { return between_->state.approach; }        ///< of the last increment [m]
  [[nodiscard]] double load() const;                                                ///< sum of the pressure [N]
  [[nodiscard]] double elastic_energy() const; ///< recoverable, of pressure and shear [J]
  /// The shear between the surfaces; nullptr without friction.
  [[nodiscard]] const Interface* interface() const { return between_->interface.get(); }
  /// The interface of surfaces that slide everywhere; nullptr for others.
  [[nodiscard]] const SlidingInterface* sliding() const;
  /// The interface of surfaces that may stick; nullptr for others.
  [[nodiscard]] const PartialSlip* partial_slip() const;
  /// The heat of friction in both bodies; nullptr where none is computed.
  [[nodiscard]] const Heating* heating() const { return between_->heating.get(); }
  /// The effects that act between the surfaces.
  [[nodiscard]] std::span<const std::unique_ptr<Effect>> effects() const { return between_->effects; }
  /// Mechanical work of thermal expansion since the start, on the pressure and on the plastic strain [J].
  [[nodiscard]] double expansion_work() const;
  /// Elastic contact stiffness: change of load per change of approach, without yielding [N/m]: contact::stiffness.
  [[nodiscard]] double stiffness() const;
  [[nodiscard]] const SurfaceGrid& grid() const;

  /// Sets factors on the yield stress of the cells, see Body::set_softening. An upper twin follows the lower body.
  /// @throws InternalError if factors are given for an upper twin
  void set_softening(std::span<const double> lower, std::span<const double> upper);

  /// Solves one increment from the present state; commits it only if it converged.
  /// @param distance   of the smooth, undeformed surfaces on the contact grid where they touch without load [m], one per cell.
  /// @param placement  of the contact grid on the material grids.
  /// @throws Interrupted between two evaluations or within a contact solution; GridError. Without convergence, or after an
  /// exception, the state is that before the increment, but for the counts that decide when windows pay.
  [[nodiscard]] IncrementReport advance(std::span<const double> distance, const contact::Drive& drive,
                                        const Placement& placement, const Strategy& strategy,
                                        const Motion& motion = {});

  /// Adds to `out` the depth of a surface under the contact grid, from texture, residual displacement and effects such as wear
  /// [m]; zero outside the grid of the body.
  void add_depth(std::size_t side, const Place& place, std::span<double> out) const;
  /// Total stress in all layers of a body, or in the own ones if ranks share it [Pa]: from the load, the plastic strain, heat, and
  /// the initial stress before the first load.
  struct Stress
  {
    std::vector<double> deviator; ///< 5 values per cell
    std::vector<double> trace;    ///< [cell]
  };
  /// @throws InputError if the body is rigid
  [[nodiscard]] Stress stress(std::size_t side, const Place& place);
  /// State of one cell, in the axes of its side.
  struct CellState
  {
    Body::CellStress stress;
    Deviator plastic_strain;
    double equivalent = 0.0;                ///< accumulated equivalent plastic strain
    std::optional<double> temperature = {}; ///< [deg C]; none without heat
  };
  /// The states of some cells of a body, as in the fields up to rounding; asked for in each increment, they cost little.
  /// @throws InputError if the body is rigid
  [[nodiscard]] std::vector<CellState> cells(std::size_t side, const Place& place, std::span<const std::size_t> cells);
  /// Numbers of a cell in a sample: deviator xx, yy, yz, xz, xy of the stress and a third of its trace [Pa], and then the plastic
  /// strain in the same order.
  static constexpr int numbers_of_stress = 6, numbers_of_strain = 5;
  /// Prepares increments for `sample`, which then costs little in bodies that can yield.
  void keep_trace(std::size_t side);
  /// Copies columns of all layers and independent rows of a body, in the axes of its side.
  /// @param numbers  of a cell
  /// @param out      [layer][row][number][column]
  /// @throws InputError if the body is rigid
  void sample(std::size_t side, const Place& place, int first_column, int columns, int numbers, std::span<float> out);
  /// Temperature in all cells of a body [deg C]; empty without heat, or if the body is rigid.
  [[nodiscard]] std::vector<double> temperature(std::size_t side) const;
  /// Whether pressure acts on the outermost cells of the contact grid.
  [[nodiscard]] bool reaches_edge() const;
  /// Moves out the history, to be continued on other grids; this object must not be used afterwards.
  [[nodiscard]] History take_history() &&;
  /// Continues a history from smaller grids that have the same centres as these grids.
  /// @throws InternalError if the centres differ
  void continue_from(History history);

  /// Everything that the next increment depends on.
  void exchange(Archive& archive);

private:
  Hidden<ContactParts> parts_;
  const Between* between_; ///< one of the parts
};

} // namespace brinell::elastoplastic
