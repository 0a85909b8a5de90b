// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/surface_compliance.hpp"

#include <optional>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// to + factor * field.
void add_scaled(double factor, std::span<const double> field, std::span<double> to);

/// Elastic displacements of two surfaces under a pressure and a shear along x, each surface by itself. The shear is that on the
/// lower body.
///
/// Of homogeneous bodies, the displacement across the direction of the traction is one field times the weight
/// w = (1 - 2 nu)/(2 mu) of each (docs/theory/elastoplastic.md, coulomb). Of layered bodies, each has a field of its own: that of
/// one body is computed, and that of the other one is the rest of the pair.
class ShearedSurfaces
{
public:
  /// @param couples    whether the shear changes the gap; if not, each surface gets the mean of both across the traction
  /// @param reference  reference distance of the displacement with one periodic axis, see halfspace::SurfaceCompliance [m]
  ShearedSurfaces(const SurfaceGrid& grid, const ElasticStack& lower, const ElasticStack& upper, bool couples,
                  double reference);

  [[nodiscard]] const halfspace::SurfaceCompliance& pair() const { return pair_; }
  [[nodiscard]] const SurfaceGrid& grid() const { return pair_.grid(); }
  [[nodiscard]] bool changes_gap() const { return changes_gap_; }

  /// Change of the gap by a shear: the sum of the displacements of both surfaces along z, positive into each body [m].
  void find_depth(std::span<const double> shear, std::vector<double>& depth) const;
  /// Displacement along z of the lower surface by a shear, positive into it [m]; that of the upper one is the rest of the depth.
  void find_lower_depth(std::span<const double> shear, std::span<const double> depth, std::vector<double>& lower) const;
  /// Adds the displacements along x by pressure and shear to those of the lower and of the upper surface [m].
  void add_along(std::span<const double> pressure, std::span<const double> shear, std::vector<double>& lower,
                 std::vector<double>& upper) const;

private:
  /// How the displacement of the lower one of two bodies, one of them layered, follows from that of the pair.
  enum class Lower
  {
    is_rigid,
    is_pair,  ///< the upper body is rigid
    is_alone, ///< computed by itself
    is_rest   ///< the pair without the upper body, which is computed by itself
  };
  using Load = halfspace::SurfaceLoad;
  /// Makes displacements of the lower surface along z or x from those of the pair, which the fields hold.
  void take_lower(const Load& load, std::vector<double>* z, std::vector<double>* x) const;
  void add_along_of_stacks(const Load& pressure, const Load& shear, std::vector<double>& lower,
                           std::vector<double>& upper) const;

  halfspace::SurfaceCompliance pair_; ///< of both bodies
  halfspace::SurfaceCompliance unit_; ///< of a body with unit coupling weight
  std::optional<halfspace::SurfaceCompliance> alone_;
  Lower lower_ = Lower::is_pair;
  bool is_layered_, couples_, changes_gap_ = false;
  double lower_share_ =
      0.0; ///< of the lower body in the displacement of the pair along x under shear, if nothing is alone
  /// Coupling weights [1/Pa]: couple pressure to displacement along x, and shear to displacement along z.
  double lower_weight_ = 0.0, upper_weight_ = 0.0;
};

} // namespace brinell::elastoplastic
