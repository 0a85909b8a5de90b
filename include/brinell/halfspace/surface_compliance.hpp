// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/halfspace/surface_load.hpp"

#include <memory>

namespace brinell::halfspace
{

/// Surface load -> sum of the elastic displacements of two half spaces on one surface grid, non-periodic
/// (DC-FFT of the rectangle's closed form, Love 1929): docs/theory/half-space.md (surface-displacement).
///
/// The work on a block of neighbouring columns, transform, product and transform back, is done in one go in the cache.
class SurfaceCompliance
{
public:
  /// @param contact_modulus  E' of the pair [Pa]: u = 1/(pi E') * integral of p / r.
  SurfaceCompliance(const SurfaceGrid& grid, double contact_modulus);
  ~SurfaceCompliance();
  SurfaceCompliance(SurfaceCompliance&&) noexcept;
  SurfaceCompliance& operator=(SurfaceCompliance&&) noexcept;
  SurfaceCompliance(const SurfaceCompliance&) = delete;
  SurfaceCompliance& operator=(const SurfaceCompliance&) = delete;

  /// Buffers of one application; make one per concurrent caller, once.
  class Scratch;
  [[nodiscard]] Scratch make_scratch() const;

  [[nodiscard]] const SurfaceGrid& grid() const;
  /// Of the same bodies on another grid.
  [[nodiscard]] SurfaceCompliance on(const SurfaceGrid& grid) const;
  /// Displacement [m] of the load: symmetric and positive definite.
  void apply(const SurfaceLoad& load, const SurfaceDisplacement& displacement, Scratch& scratch) const;
  /// Largest response of a wave [m/Pa], and that of the longest wave along x.
  [[nodiscard]] double largest() const;
  [[nodiscard]] double longest_wave() const;

private:
  struct Operator; ///< transform and spectrum
  std::unique_ptr<Operator> operator_;
};

class SurfaceCompliance::Scratch
{
public:
  ~Scratch();
  Scratch(Scratch&&) noexcept;
  Scratch& operator=(Scratch&&) noexcept;
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

private:
  friend class SurfaceCompliance;
  struct Buffers;
  explicit Scratch(std::unique_ptr<Buffers> buffers);
  std::unique_ptr<Buffers> buffers_;
};

} // namespace brinell::halfspace
