// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/thermal_field.hpp"
#include "halfspace/transform/depth_waves.hpp"
#include "heat_coat.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace brinell::halfspace
{

/// Distance in units of sqrt(4 kappa t) at which heat is negligible: it has decayed to e^{-9}.
inline constexpr double reach_of_heat = 3.0;

/// Whether images lie along one axis only, so that their fields decrease with the second power of the distance.
[[nodiscard]] bool is_strip(const SurfaceGrid& grid);

/// Periods of the lattices that remove the images of heat on a surface with open axes (OpenHeatMemory), in cells; and the
/// distances of the images. docs/theory/heat.md (images-of-heat)
struct ImagesOfHeat
{
  int period_x, period_y;          ///< of the first lattice
  bool x_is_coarser, y_is_coarser; ///< whether already the nearest images are removed on cells twice as long
  int twice_x, twice_y, once_x,
      once_y; ///< of the pairs of lattices, each on cells twice as long as those of the pair before
  double nearest = 0.0,
         end = 0.0;     ///< distances of the images of the first pair, and from which on none are removed [m]
  double decayed = 0.0; ///< waves in depth up to this number over the distance are kept

  /// @param thermal     in which heat spreads fastest
  /// @param slowest     constants of the memory, in which waves decay most slowly
  /// @param has_fields  whether fields in the body are wanted, not only the temperature of the surface
  ImagesOfHeat(const SurfaceGrid& grid, const Thermal& thermal, const Thermal& slowest, double duration,
               HeatImages images, bool has_fields);
};

/// Layers of a coated body, for its memory of heat.
struct CoatOfBody
{
  ThermalStack thermal;
  std::optional<ElasticStack> elastic{}; ///< none: nothing expands
  HeatCoat::Surface surface = HeatCoat::Surface::difference;
  std::vector<double> depths{}; ///< at which fields are wanted [m]
};

/// Requirements of the heat of a body beyond the temperature of its surface.
struct WantedOfHeat
{
  double deepest = -1.0; ///< largest depth of fields in the body [m]; negative: no fields in the body
  HeatImages images = HeatImages::fine;
  HeatedLayers heated{};            ///< layers of the body in which heat may be generated
  std::optional<CoatOfBody> coat{}; ///< none: a homogeneous body; its memory has the constants HeatCoat::of_memory
};

/// The waves in depth of a body.
/// @throws InputError if a constant, a thickness or a time is not above 0
[[nodiscard]] DepthWaves waves_of_heat(const char* owner, const SurfaceGrid& grid, const Thermal& thermal,
                                       const HeatTimes& times, const WantedOfHeat& wanted);

/// Chebyshev points in each layer, between which fields of images are interpolated [m].
[[nodiscard]] std::vector<double> nodes_of_images(const WantedOfHeat& wanted);

/// Weights of a coated body for all wavelengths of its lattices; nullptr: a homogeneous body.
[[nodiscard]] std::shared_ptr<const HeatCoat> planned_coat(const SurfaceGrid& grid, const WantedOfHeat& wanted,
                                                           const DepthWaves& waves, const ImagesOfHeat& images);

/// Memory of an OpenHeatMemory [bytes].
/// @param goes_back  with the state before a step, to take the step back
[[nodiscard]] double memory_of_heat(const SurfaceGrid& grid, const Thermal& thermal, const HeatTimes& times,
                                    const WantedOfHeat& wanted, bool goes_back);

} // namespace brinell::halfspace
