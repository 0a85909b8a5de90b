// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "halfspace/transform/cell_response.hpp"
#include "radial_table.hpp"
#include "wave_terms.hpp"

#include <array>
#include <vector>

namespace brinell::halfspace
{

/// Fields of a unit traction on one cell of a surface that is open along both axes, from their waves. The field of a point load is
/// a Hankel integral of each part, a smooth function of the distance that is tabulated by polynomials; the cell is integrated by Gauss.
/// There is no lattice, and so there are no images. Several fields with the same terms are computed together.
class RadialFields
{
public:
  using Table = RadialTable<std::tuple_size_v<WaveParts>>;

  /// @param waves  [field] parts
  RadialFields(const SurfaceGrid& grid, const WaveScales& scales, WaveTerms terms, const std::vector<Table>& waves);
  [[nodiscard]] Quadrant<WaveComponents> cells(std::size_t field) const;

private:
  static constexpr std::size_t nodes = 14; ///< polynomials in an interval of distances
  using Series = ChebyshevSeries<std::tuple_size_v<WaveParts>, nodes>;
  struct Interval
  {
    double low, high;
  };
  /// Points along one axis of a cell, relative to its middle, in cells.
  struct Rule
  {
    std::vector<double> point, weight;
    explicit Rule(int order);
  };
  void tabulate(const Interval& interval, std::size_t number, const std::vector<Table>& waves);
  [[nodiscard]] WaveParts at(std::size_t field, double r) const;
  [[nodiscard]] const Rule& rule_of(double cell, double from_middle, double across) const;

  SurfaceGrid grid_;
  WaveScales scales_;
  std::vector<WaveTerm> terms_;
  std::array<int, std::tuple_size_v<WaveParts>> orders_{};
  std::vector<Interval> intervals_;         ///< of the distance
  std::vector<std::vector<Series>> radial_; ///< [field][interval]
  std::vector<Rule> rules_;                 ///< [order - 1]
};

} // namespace brinell::halfspace
