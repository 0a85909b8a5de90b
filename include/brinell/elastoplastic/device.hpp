// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/flow.hpp"
#include "brinell/constitutive/material.hpp"
#include "brinell/contact/elastic_contact.hpp"
#include "brinell/elastoplastic/active_cells.hpp"
#include "brinell/elastoplastic/anderson.hpp"
#include "brinell/foundation/grid.hpp"
#include "brinell/halfspace/surface_compliance.hpp"
#include "brinell/halfspace/surface_load.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

/// Where a body may be evaluated other than on this processor: docs/developer/device.md.
namespace brinell::elastoplastic
{

/// The evaluations of a body's increment, and the acceleration of its trials, on a device that keeps the fields. A `Body` that has one
/// calls it in place of what it would compute itself, and takes what was found when an increment is committed: the state of the body is on
/// both sides then. Deviator fields are [component][cell]; active cells are in the order in which the processor would find them.
class BodyOnDevice
{
public:
  virtual ~BodyOnDevice() = default;

  /// BodyState before an increment, with the q of the last increment where there was flow (Trial::stress).
  struct State
  {
    std::span<const double> plastic_strain, equivalent, backstress, stress, guess;
  };
  /// Takes over a state, whatever was known.
  virtual void write(const State& state) = 0;
  /// Factors on the yield stress of the cells, and the deviator of the thermal stress [Pa]; empty: none.
  virtual void set_softening(std::span<const double> factor) = 0;
  virtual void set_thermal_stress(std::span<const double> deviator) = 0;

  /// Cells that have become active.
  struct Found
  {
    std::size_t cells = 0;
    int deepest = 0;          ///< layer of the deepest one
    double yield_error = 0.0; ///< Body::yield_error
  };
  struct Start
  {
    int shift = 0;            ///< by which the contact moves along x [cells]
    double stiffness = 0.0;   ///< c [Pa]
    double fraction = 0.0;    ///< of the yield stress above which cells are active; negative: every cell
    bool from_stress = false; ///< Body::Guess::stress
  };
  virtual Found begin(const Start& start) = 0;
  /// Plastic flow of the active cells, and the displacement of the surface along z, x and y [m] by the strain; empty parts are not
  /// computed.
  virtual void integrate(constitutive::Integration integration,
                         const std::array<std::span<double>, 3>& displacement) = 0;
  /// Displacement along x by the strain of the last `integrate`.
  virtual void find_displacement_x(std::span<double> displacement) = 0;
  /// Stress under a load and images of the trials; adds the cells of the layers [0, layers) that yield to the active ones.
  virtual Found update(const halfspace::SurfaceLoad& load, int layers) = 0;

  /// Copies the active cells, and their plastic strain into its field.
  virtual void read_active(ActiveCells& active, std::span<double> plastic_strain) = 0;
  /// Copies the stress of the last update.
  virtual void read_stress(std::span<double> stress) = 0;
  /// Replaces the trials of the active cells.
  virtual void write_trials(std::span<const double> trials) = 0;
  /// Makes the trial the state.
  virtual void commit() = 0;

  /// Adds the difference to the previous evaluation to the history of this increment, as Anderson does.
  /// @returns the scalar products of the differences
  [[nodiscard]] virtual std::vector<AndersonWeights::Products> record(const AndersonWeights::Entry& entry) = 0;
  /// Sets the trials to the combination of the evaluations with these weights.
  virtual void combine(std::span<const double> weights) = 0;
  /// Residual of this combination.
  [[nodiscard]] virtual std::vector<double> residual(std::span<const double> weights) = 0;
  virtual void deepen(const AndersonWeights::Moved& moved) = 0;
};

/// A device that bodies can be put on.
class Device
{
public:
  virtual ~Device() = default;

  [[nodiscard]] virtual std::string name() const = 0;
  /// Memory that it had left when it was opened [bytes].
  [[nodiscard]] virtual double free_memory() const = 0;
  /// @param with_shears  whether there are loads by shear, or displacements along the surface
  [[nodiscard]] virtual std::unique_ptr<BodyOnDevice>
  make_body(const VolumeGrid& grid, const constitutive::Material& material, bool with_shears) const = 0;
  [[nodiscard]] virtual std::unique_ptr<contact::ContactOnDevice>
  make_contact(const SurfaceGrid& grid, const halfspace::SurfaceCompliance::NormalSpectra& spectra) const = 0;
};

/// Why a body of this material cannot be on a device; empty if it can. A body that stays elastic needs none.
[[nodiscard]] std::string reason_against_device(const constitutive::Material& material);

} // namespace brinell::elastoplastic
