// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/heat_response.hpp"
#include "buried_heat.hpp"
#include "heat_waves.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// A row of waves of the temperature T at one depth, and its potential psi there: lap(psi) = -T with d psi/dz = 0 at the surface.
struct HeatRow
{
  double depth; ///< [m]
  std::span<const SurfaceWave> waves;
  std::span<const double> decay;                 ///< e^{-kz}; empty at the surface
  std::span<const Complex> temperature;          ///< [K]
  std::span<const Complex> potential, slope;     ///< k psi and d psi/dz [K m]
  std::span<const Complex> potential_at_surface; ///< k psi for z = 0 [K m]
  /// Of a coated body, instead of the potential: stress along the wavevector, zz, and lz without the factor i [Pa]; at the surface, where
  /// the waves of the temperature are not summed: displacement along z, and along the wavevector without the factor -i [m].
  std::span<const Complex> ll{}, zz{}, lz{}, moved{}, moved_along{};
};

/// Memory of one periodic surface: for each wave in depth and along the surface, the heat that is left of all that has entered.
/// On a grid that is mirrored only the independent rows of waves are stored.
class HeatMemory
{
public:
  /// Heat of each wave along the surface and in depth. What `add_to_last_step` adds is the same for all waves in depth except for a factor
  /// that depends on the motion only. It is therefore stored separately, and added to the waves by the next step, which changes
  /// all of them anyway.
  struct Heat
  {
    /// [row][block][wave] [K m]: a block holds neighbouring columns of a row in lanes, one wave in depth after the other.
    AlignedVector<ComplexLanes> waves;
    AlignedVector<Complex> amended{};   ///< heat per step that is not yet in the waves, [plane] [K m]; empty: none
    HeatMotion motion{.duration = 0.0}; ///< of the step that was amended
  };

  /// @param grid      grid of flux and temperature
  /// @param px, py    periods, in cells of the grid
  /// @param surface   factors of all waves in depth at the surface, of which `waves` are the last ones
  /// @param layers    layers in which heat may be generated; nullptr: none
  /// @param coat      of a coated body, whose memory has the constants `thermal`; nullptr: none
  HeatMemory(const SurfaceGrid& grid, int px, int py, const Thermal& thermal, DepthWaves waves,
             const DepthFactors& surface, const std::shared_ptr<const LayeredConduction>& layers = nullptr,
             std::shared_ptr<const HeatCoat> coat = nullptr);

  [[nodiscard]] const SurfaceGrid& grid() const { return waves_.fft.grid(); }
  [[nodiscard]] int period_x() const { return waves_.fft.px(); } ///< [cells]
  [[nodiscard]] int period_y() const { return waves_.fft.py(); }
  [[nodiscard]] std::size_t spectrum_bytes() const { return waves_.fft.plane() * sizeof(Complex); } ///< of one field

  /// Adds `factor` times the temperature of the surface that remains after `duration`, for a flux that is uniform in each cell.
  /// @param heated  grid of these cells
  void add_remaining(double duration, double factor, const SurfaceGrid& heated, std::span<double> temperature) const;

  /// Adds `factor` times the temperature of the surface due to the heat generated in the body, in its present state.
  void add_buried(double factor, std::span<double> temperature) const;

  using Window = PaddedFft::Window;
  [[nodiscard]] Window whole() const { return waves_.fft.whole(); }
  /// Definition of some fields at one depth.
  struct FieldsOfHeat
  {
    /// Computes a row of their waves from a row of the heat and writes it to the beginning of each of `out`.
    std::function<void(const HeatRow&, std::span<Complex* const> out)> waves;
    std::vector<bool> is_odd; ///< whether each field is odd in y if the flux is even
  };
  /// `factor` times the fields that remain after `duration`, for a flux that is the trigonometric interpolant of its cell values.
  /// For duration = 0 they are those at the end of the last step. Heat generated in the body is included in its present state.
  /// @param depths  for each depth, the factors of all waves in depth, of which those of this memory are the last ones
  /// @param out     [depth][field][cell], with the same fields at each depth
  /// @param adds    whether the result is added to `out`; otherwise `out` is overwritten
  /// @param window  cells for which the fields are computed
  void fields(double duration, double factor, std::span<const DepthFactors> depths, const FieldsOfHeat& fields_of_heat,
              const std::vector<std::span<double>>& out, bool adds, const Window& window) const;

  /// A step: the stored heat decays over the duration of the motion, and the heat of its flux is added.
  /// @param before  receives the heat before the step; may be nullptr
  void add_step(std::span<const double> flux, const HeatMotion& motion, Heat* before = nullptr);
  /// Adds more flux to the last step, over whose duration the stored heat has already decayed.
  void add_to_last_step(std::span<const double> flux, const HeatMotion& motion);

  /// A step of the heat generated in the body: `BuriedHeat::add_step`.
  /// @param rise  of each of its layers [K], one field each; empty ones are zero
  void add_heat_in_body(const std::vector<std::vector<double>>& rise, double duration);
  void restore_heat_in_body() { buried_->restore(); }

  [[nodiscard]] const Heat& heat() const { return heat_; }
  void set_heat(const Heat& heat);
  /// The heat in the layout of a grid that is not mirrored; real and imaginary parts alternate.
  struct WholeHeat
  {
    std::vector<double> waves, amended;
    HeatMotion motion{.duration = 0.0};
  };
  [[nodiscard]] WholeHeat whole_heat() const;
  void set_whole_heat(const WholeHeat& heat);
  /// Heat in the body in the layout of a grid that is not mirrored; empty if no heat can be generated there.
  [[nodiscard]] std::vector<double> whole_heat_in_body() const;
  void set_whole_heat_in_body(std::span<const double> values);

private:
  using RowOfHeat = AlignedVector<ComplexLanes>;
  struct Row;
  struct RowOfFields;
  struct CoatedRow;
  void coated_row(int row, const CoatedRow& wanted) const;
  void find_coated(double duration, double factor, std::span<const DepthFactors> depths,
                   const FieldsOfHeat& fields_of_heat, Complex* spectra) const;
  [[nodiscard]] const ComplexLanes* heat_of_row(int row, RowOfHeat& buffer) const;
  [[nodiscard]] AlignedVector<Complex> planes() const;

  /// Decay and shift of neighbouring waves along the surface in a step.
  struct StepOfBlock
  {
    Lanes rate, phase;            ///< z = rate + i phase, both times the duration
    Lanes left, left_re, left_im; ///< e^{-rate} and e^{-z}
  };
  struct Step
  {
    HeatMotion motion;
    AlignedVector<StepOfBlock> blocks;     ///< [row][block]
    std::vector<double> rates, left;       ///< of the waves in depth: kappa s^2 t, and e^{-that}
    std::optional<SurfaceSums> response{}; ///< of unit heat in each wave along the surface; planned when it is needed
  };
  void plan_step(const HeatMotion& motion);
  void step_from(const Heat& before, const AlignedVector<Complex>& heat);
  void add_amended(const Heat& from);
  void fill_amended(int row, const Complex* amended, const ComplexLanes* before, ComplexLanes* heat) const;
  [[nodiscard]] SurfaceSums find_response() const;
  [[nodiscard]] Lanes left_along(std::size_t block, double duration) const;
  [[nodiscard]] SurfaceSums find_sums(double duration) const;

  HeatWaves waves_;
  Heat heat_;
  std::optional<Step> step_;        ///< the last step that was planned
  std::optional<SurfaceSums> sums_; ///< of the present heat
  std::optional<BuriedHeat> buried_;
};

} // namespace brinell::halfspace
