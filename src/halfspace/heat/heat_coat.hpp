// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/elastic_stack.hpp"
#include "brinell/green/thermal_stack.hpp"
#include "foundation/lanes.hpp"
#include "foundation/matrix.hpp"
#include "halfspace/transform/depth_waves.hpp"

#include <array>
#include <cstddef>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// Heat of a coated body in the waves of a heat memory: docs/theory/heat.md (coated-heat).
///
/// The memory is that of a half space of the material of the stack in which heat spreads most slowly. All that heat does in the stack
/// decays as fast or faster, and so it is a sum over the same waves, with other weights, which depend on the wavenumber along the
/// surface. They are fitted at some wavenumbers and interpolated between them.
class HeatCoat
{
public:
  /// Purpose of the temperature of the surface.
  enum class Surface
  {
    difference, ///< from that of the half space of the memory
    excess      ///< over that of a half space of the first layer, by the stack alone
  };
  struct Wanted
  {
    double longest, shortest; ///< wavelengths along the surface, between which the weights are fitted [m]
    bool is_periodic = false; ///< along both axes: the uniform part is held in its plane
    Surface surface = Surface::difference;
    std::vector<double> depths{}; ///< at which fields are wanted [m]; they need the elastic constants
  };
  /// @param elastic  none: nothing expands
  HeatCoat(ThermalStack thermal, std::optional<ElasticStack> elastic, const DepthWaves& waves, Wanted wanted);

  /// Thermal constants of the memory.
  [[nodiscard]] static const Thermal& of_memory(const ThermalStack& thermal) { return thermal.slowest(); }
  [[nodiscard]] bool is_excess() const { return wanted_.surface == Surface::excess; }

  /// A result that is a sum over the waves; those in the body are at one of the depths.
  enum class Part
  {
    surface,       ///< temperature of the surface
    displacement,  ///< along z, into the body
    along_surface, ///< displacement along the wavevector, without the factor -i
    temperature,
    ll, ///< stress along the wavevector
    zz,
    lz ///< without the factor i
  };
  static constexpr std::size_t parts_of_surface = 3, parts_of_depth = 4;
  /// Number of a depth.
  [[nodiscard]] std::size_t number_of(double depth) const;
  /// Layer in which a depth lies; at an interface the one beneath.
  [[nodiscard]] std::size_t layer_at(double depth) const;
  /// Fits the parts at all depths up to a number, unless they are; may be called from several threads.
  void require_depths(std::size_t count) const;

  /// Where the wavenumbers of neighbouring columns lie between those at which weights are fitted.
  struct Place
  {
    static constexpr std::size_t points = 6;
    std::array<std::size_t, lane_count> first{};
    std::array<std::array<double, points>, lane_count> factors{};
  };
  [[nodiscard]] Place place_of(const Lanes& k) const;
  /// Weights of the last waves, as many as `out` has.
  void weights(Part part, std::size_t depth, const Place& place, std::span<Lanes> out) const;

private:
  struct Fit;
  [[nodiscard]] double wavenumber(std::size_t node) const;
  void fit(std::size_t first_depth, std::size_t count) const;

  ThermalStack thermal_;
  std::optional<ElasticStack> elastic_;
  Wanted wanted_;
  std::size_t waves_, nodes_;
  double step_;               ///< of ln k between nodes
  std::vector<double> times_; ///< at which the sums are fitted [s]
  /// From values at the times to weights: of all times, and of those that the waves resolve.
  Matrix from_times_, from_late_times_;
  std::size_t resolved_ = 0;                        ///< number of the time from which on the waves tell times
  double deep_ = 0.0;                               ///< depth from which on nothing is felt before [m]
  mutable std::vector<std::vector<double>> tables_; ///< [part][node][wave]
  mutable std::size_t depths_done_ = 0;
  mutable std::mutex mutex_;
};

} // namespace brinell::halfspace
