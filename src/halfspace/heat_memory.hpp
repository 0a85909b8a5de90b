// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/heat_response.hpp"
#include "buried_heat.hpp"
#include "depth_sums.hpp"
#include "independent_rows_fft.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// A row of waves of the temperature at one depth, and what its potential psi, lap(psi) = -T with d psi/dz = 0 at the surface, is
/// there.
struct HeatRow
{
  double depth; ///< [m]
  std::span<const SurfaceWave> waves;
  std::span<const double> decay;                 ///< e^{-kz}; nothing at the surface
  std::span<const Complex> temperature;          ///< [K]
  std::span<const Complex> potential, slope;     ///< k psi and d psi/dz [K m]
  std::span<const Complex> potential_at_surface; ///< k psi for z = 0 [K m]
};

/// The memory of one periodic surface: for each wave in depth and in the plane, the heat that has decayed since it entered.
class HeatMemory
{
public:
  /// Of each wave along the surface and in depth: of some neighbouring columns of a row one wave in depth after the other,
  /// [row][block][wave] [K m].
  using Heat = AlignedVector<ComplexLanes>;

  /// @param grid      where flux and temperature are; periods px, py cells of it
  /// @param symmetry  of all fluxes: half of the waves along y tell all
  /// @param layers    in which heat may arise; nullptr: in none
  /// @param surface  factors of all waves at the surface, of which those of this memory are the last ones
  HeatMemory(const SurfaceGrid& grid, int px, int py, const Thermal& thermal, DepthWaves waves,
             const DepthFactors& surface, Symmetry symmetry,
             const std::shared_ptr<const LayeredConduction>& layers = nullptr);

  [[nodiscard]] const SurfaceGrid& grid() const { return fft_.all().grid(); }
  [[nodiscard]] int period_x() const { return fft_.all().px(); } ///< [cells]
  [[nodiscard]] int period_y() const { return fft_.all().py(); }
  [[nodiscard]] std::size_t spectrum_bytes() const { return fft_.plane() * sizeof(Complex); } ///< of one field

  /// Adds `factor` times the temperature of the surface that remains after `duration`, of cells with a uniform flux each.
  /// @param heated  those cells
  void add_remaining(double duration, double factor, const SurfaceGrid& heated, std::span<double> temperature) const;

  /// Adds `factor` times the temperature of the surface that the heat in the body gives as it is.
  void add_buried(double factor, std::span<double> temperature) const;

  using Window = IndependentRowsFft::Window;
  [[nodiscard]] Window whole() const { return fft_.whole(); }
  /// Some fields at one depth.
  struct FieldsOfHeat
  {
    /// A row of their waves from those of the heat: to the beginning of each of `out`.
    std::function<void(const HeatRow&, std::span<Complex* const> out)> waves;
    std::vector<bool> is_odd; ///< in y, of a flux that is even
  };
  /// `factor` times the fields that remain after `duration`, of a flux that is the trigonometric polynomial through its values.
  /// For duration = 0 they are those at the end of the last step. What has arisen in the body is in them as it is.
  /// @param depths  factors of all waves, of which those of this memory are the last ones; for each depth
  /// @param out   as many at each depth, [depth][field][cell]
  /// @param adds    to what is there; otherwise it is overwritten
  /// @param window  of the cells that are wanted
  void fields(double duration, double factor, std::span<const DepthFactors> depths, const FieldsOfHeat& fields_of_heat,
              const std::vector<std::span<double>>& out, bool adds, const Window& window) const;

  /// All decays over the motion, and its flux comes in.
  /// @param before  gets the heat as it was; nullptr: nothing does
  void take_up(std::span<const double> flux, const HeatMotion& motion, Heat* before = nullptr);
  /// More flux comes in over the last motion, which all has decayed over already.
  void amend(std::span<const double> flux, const HeatMotion& motion);

  /// A step of the heat in the body: `BuriedHeat::take_up`.
  /// @param rise  of each of its layers [K], a field each; empty ones are zero
  void take_up_in_body(const std::vector<std::vector<double>>& rise, double duration);
  void go_back_in_body() { buried_->go_back(); }

  [[nodiscard]] const Heat& heat() const { return heat_; }
  void set_heat(const Heat& heat);
  /// The same with or without symmetry: real and imaginary parts in turn.
  [[nodiscard]] std::vector<double> whole_heat() const;
  void set_whole_heat(std::span<const double> values);
  /// Likewise in the body; nothing where none can arise.
  [[nodiscard]] std::vector<double> whole_heat_in_body() const;
  void set_whole_heat_in_body(std::span<const double> values);

private:
  [[nodiscard]] std::size_t columns() const { return static_cast<std::size_t>(fft_.all().kx()); }
  /// Where the waves of a row begin.
  [[nodiscard]] std::size_t begin_of(int row) const { return static_cast<std::size_t>(row) * columns(); }
  [[nodiscard]] std::span<const SurfaceWave> row_of_waves(int row) const;
  /// Columns of a row that lie side by side in the memory; zero beyond the last one.
  [[nodiscard]] std::size_t blocks() const { return (columns() + lane_count - 1) / lane_count; }
  [[nodiscard]] std::size_t block_of(int row) const { return static_cast<std::size_t>(row) * blocks(); }
  [[nodiscard]] const ComplexLanes* heat_of_block(std::size_t block) const
  {
    return heat_.data() + block * waves_.waves.size();
  }
  /// What `fields` wants of every row.
  struct RowOfFields
  {
    double duration, factor;
    bool has_buried;           ///< whether there is heat in the body
    const DepthSums* sums;     ///< nullptr: of the surface alone
    const Complex* at_surface; ///< potential, without its factor k; where there are no other sums
    std::span<const DepthFactors> depths;
    const FieldsOfHeat& fields_of_heat;
    Complex* spectra;                 ///< [depth][field][plane]
    std::span<const int> significant; ///< columns that count in any row; for each depth
  };
  [[nodiscard]] std::vector<double> left_in_depth(double duration) const;
  /// Sums of a row, of the heat of the surface and of that in the body.
  struct Row
  {
    DepthSums::Row of_surface;
    DecayInDepth decay;
    AlignedVector<Lanes> left{}; ///< of each wave along the surface, times the factor: [block]
    std::vector<Complex*> out{}; ///< fields at a depth
    BuriedHeat::Row buried{};
  };
  [[nodiscard]] Row make_row(const RowOfFields& wanted) const;
  void add_row(int row, const RowOfFields& wanted, Row& sums) const;
  void put_fields(int row, std::size_t number, std::size_t columns, const RowOfFields& wanted, Row& sums) const;
  [[nodiscard]] std::vector<int> significant_columns(std::span<const DepthFactors> depths, bool has_buried) const;
  void add_buried_row(double depth, double factor, std::size_t columns, std::size_t number, Row& sums) const;
  [[nodiscard]] std::vector<double> whole(const AlignedVector<Complex>& planes) const;
  [[nodiscard]] AlignedVector<Complex> independent_rows_of(std::span<const double> values) const;
  void finish_surface(int row, const Complex* potential, Row& sums) const;
  [[nodiscard]] AlignedVector<Complex> planes() const;

  /// What a step does to some waves along the surface.
  struct StepOfBlock
  {
    Lanes rate, turn;             ///< z = rate + i turn, both times the duration
    Lanes left, left_re, left_im; ///< e^{-rate} and e^{-z}
  };
  struct Step
  {
    HeatMotion motion;
    AlignedVector<StepOfBlock> blocks; ///< [row][block]
  };
  /// Sums over the waves in depth at the surface, without what is the same for all of them; [row][column]. For as long as a step lasts.
  struct SurfaceSums
  {
    double duration;
    AlignedVector<Complex> temperature;              ///< that remains then
    AlignedVector<Complex> potential, potential_now; ///< then, and as it is; empty where only the temperature is wanted
  };
  /// What the waves in depth count in them.
  struct SurfaceWeights
  {
    std::size_t first_left = 0; ///< faster waves have decayed by then
    std::vector<double> temperature, potential, potential_now;
  };
  void plan_step(const HeatMotion& motion);
  void take_up_from(const Heat& before, std::span<const double> flux, const HeatMotion& motion, bool decays,
                    bool is_settled);
  [[nodiscard]] Lanes left_along(std::size_t block, double duration) const;
  [[nodiscard]] SurfaceWeights surface_weights(double duration) const;
  [[nodiscard]] SurfaceSums empty_sums(double duration) const;
  void sum_row(int row, const SurfaceWeights& weights, SurfaceSums& sums) const;
  [[nodiscard]] SurfaceSums find_sums(double duration) const;

  IndependentRowsFft fft_;
  double diffusivity_, conductivity_;
  DepthWaves waves_;
  std::vector<double> at_surface_; ///< weights of the waves but the last one in the potential there
  std::vector<SurfaceWave> along_; ///< [plane]
  AlignedVector<Lanes> k_;         ///< [row][block]
  Heat heat_;
  AlignedVector<Lanes> slow_share_; ///< [row][block], for fields
  std::optional<Step> step_;        ///< the last one
  std::optional<SurfaceSums> sums_; ///< of the heat as it is
  std::optional<BuriedHeat> buried_;
};

} // namespace brinell::halfspace
