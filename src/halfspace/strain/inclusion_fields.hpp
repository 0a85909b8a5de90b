// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "inclusion_cells.hpp"

namespace brinell::halfspace
{

/// Fields of a body that the equivalent strain of inclusions causes.
class InclusionFields
{
public:
  /// @param body  must outlive this object
  explicit InclusionFields(const HalfSpace& body);

  /// Inclusions::stress
  void stress(const InclusionCells& cells, const InclusionField& equivalent, InclusionField& caused);
  /// Inclusions::add
  /// @param caused  nullptr, or becomes the stress in the cells, if the layers hold all of them
  void add(const InclusionCells& cells, const InclusionField& equivalent, int layers, const HalfSpace::Dilated& to,
           InclusionField* caused);
  /// Inclusions::gather
  void gather(const InclusionCells& cells, std::span<const double> deviators, std::span<const double> traces,
              InclusionField& out) const;

private:
  void spread(const InclusionCells& cells, const InclusionField& equivalent);
  void clear(const InclusionCells& cells);
  [[nodiscard]] InclusionField sharp_stress(const InclusionCells& cells, const InclusionField& equivalent) const;
  void add_stress(const InclusionCells& cells, const InclusionField& sharp, int layers, const HalfSpace::Dilated& to);

  const HalfSpace& body_;
  HalfSpace::Work work_;
  HalfSpace::DilatationWork dilatation_work_;
  std::vector<double> strain_, dilatation_; ///< fields of the body, zero between the calls
  std::vector<double> deviator_, trace_;
};

} // namespace brinell::halfspace
