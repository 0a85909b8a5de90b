// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"
#include "brinell/halfspace/thermal_field.hpp"
#include "halfspace/transform/coarser_surface.hpp"
#include "heat_memory.hpp"
#include "images_of_heat.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace brinell::halfspace
{

/// Memory of a surface whose axes may be open: that of a periodic surface, and corrections that remove its images. With the
/// temperature T_P for the period P,
///     T = T_P + (T_2P - T_P) + (T_4P - T_2P) + ...
/// docs/theory/heat.md (images-of-heat).
class OpenHeatMemory
{
public:
  using Wanted = WantedOfHeat;
  /// @throws InputError if a constant or a time is not above 0
  OpenHeatMemory(const char* owner, const SurfaceGrid& grid, const Thermal& thermal, const HeatTimes& times,
                 const Wanted& wanted);

  [[nodiscard]] const SurfaceGrid& grid() const { return near_.grid(); }
  [[nodiscard]] double time() const { return time_; } ///< total duration of all steps so far [s]
  [[nodiscard]] const DepthWaves& waves() const { return waves_; }
  [[nodiscard]] const HeatCoat* coat() const { return coat_.get(); } ///< nullptr: a homogeneous body

  /// The temperature of the surface that remains after `duration`.
  void remaining(const char* function_name, double duration, std::span<double> temperature) const;
  /// Temperature of the surface at the end of the last step by the part of a coated body that does not begin at once: HeatCoat::Surface::excess.
  void present_excess(std::span<double> temperature) const;
  /// Fields that remain after `duration`; for duration = 0, the present fields.
  /// @param out     [depth][field], with the same fields at each depth
  /// @param window  cells for which the fields are computed
  void fields(const char* function_name, double duration, std::span<const DepthFactors> depths,
              const HeatMemory::FieldsOfHeat& fields_of_heat, const std::vector<std::span<double>>& out,
              const HeatMemory::Window& window) const;
  [[nodiscard]] HeatMemory::Window whole() const { return near_.whole(); }
  struct Heat;
  /// @param before  receives the memory before the step; may be nullptr
  void add_step(const char* function_name, std::span<const double> flux, const HeatMotion& motion,
                Heat* before = nullptr);
  void add_to_last_step(const char* function_name, std::span<const double> flux, const HeatMotion& motion);

  /// A step of the heat generated in the body: ThermalField::add_heat_in_body.
  /// @param rise  temperature rise of the heated layers if they retained all of the new heat [K], [layer][cell]
  void add_heat_in_body(const char* function_name, std::span<const double> rise, double duration);
  void restore_heat_in_body();
  /// Adds the temperature of the surface due to the heat generated in the body, in its present state.
  void add_temperature_of_body(std::span<double> temperature) const;

  /// The state of the memory: heat of every lattice, and the time.
  struct Heat
  {
    std::vector<HeatMemory::Heat> lattices;
    double time = 0.0;
  };
  [[nodiscard]] Heat heat() const;
  void set_heat(const Heat& heat);
  void exchange(Archive& archive);

private:
  OpenHeatMemory(const SurfaceGrid& grid, const Thermal& thermal, const HeatTimes& times, const Wanted& wanted,
                 const DepthWaves& waves);
  OpenHeatMemory(const SurfaceGrid& grid, const Thermal& thermal, const HeatTimes& times, const Wanted& wanted,
                 DepthWaves waves, const ImagesOfHeat& images);
  /// Two lattices whose difference removes the images that the lattice `once` has but the lattice with twice the period has not;
  /// on cells that are as coarse as the distance of these images allows.
  struct Lattices
  {
    HeatMemory twice, once;
    std::shared_ptr<const LayeredConduction> layers; ///< of both; nullptr: no heat is generated in the body
  };
  struct FartherImages
  {
    CoarserSurface cells;
    std::optional<Lattices> lattices{}; ///< empty: this level only transfers fields between finer and coarser cells
  };
  using Fields = std::vector<std::vector<double>>;
  using Add = std::function<void(const HeatMemory&, double factor, Fields&)>;

  template <typename Use>
  void for_each_lattice(std::span<const double> flux, const Use& use);
  [[nodiscard]] std::vector<HeatMemory*> lattices();
  void add_images(double duration, std::span<const DepthFactors> depths, const HeatMemory::FieldsOfHeat& fields_of_heat,
                  const std::vector<std::span<double>>& out, const HeatMemory::Window& window) const;
  [[nodiscard]] std::pair<std::size_t, std::size_t> nodes_around(double depth) const;
  void add_surface(double duration, std::span<double> temperature) const;
  void plan_images(const Thermal& thermal, const Wanted& wanted, const ImagesOfHeat& images);
  void require_step(const char* function_name, double duration) const;
  [[nodiscard]] Fields sum_of_images(std::size_t count, double factor_of_farthest, const Add& add) const;

  [[nodiscard]] std::vector<std::vector<double>> on_conducting_layers(std::span<const double> rise) const;

  HeatTimes times_;
  HeatedLayers heated_;
  std::shared_ptr<const LayeredConduction> layers_; ///< nullptr: no heat is generated in the body
  double time_ = 0.0;
  DepthWaves waves_;
  std::shared_ptr<const HeatCoat> coat_; ///< nullptr: a homogeneous body
  HeatMemory near_;
  std::vector<FartherImages> farther_;
  /// Depths between which fields of images are interpolated, in each layer by its own; empty without fields.
  std::vector<DepthFactors> image_depths_;
};

} // namespace brinell::halfspace
