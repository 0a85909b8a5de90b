// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/lane_functions.hpp"
#include "foundation/sharing.hpp"
#include "heat_memory.hpp"

#include <algorithm>
#include <array>
#include <vector>

/// Fields of a coated body from the waves of its heat memory: docs/theory/heat.md (coated-heat).
namespace brinell::halfspace
{

namespace
{

using Part = HeatCoat::Part;
constexpr std::array<Part, 2> parts_at_surface{Part::displacement, Part::along_surface};
constexpr std::array<Part, 4> parts_in_body{Part::temperature, Part::ll, Part::zz, Part::lz};

} // namespace

/// Task of `find_coated`, the same for every row.
struct HeatMemory::CoatedRow
{
  double duration, factor;
  std::vector<double> left; ///< decay of the waves in depth
  std::span<const DepthFactors> depths;
  std::vector<std::size_t> numbers; ///< of the depths; empty: the surface
  const FieldsOfHeat& fields_of_heat;
  Complex* spectra; ///< [depth][field][plane]
};

void HeatMemory::coated_row(int row, const CoatedRow& wanted) const
{
  const std::size_t waves = waves_.in_depth.waves.size(), pitch = lane_count * waves_.blocks();
  const std::size_t count = wanted.fields_of_heat.is_odd.size();
  const bool is_surface = wanted.numbers.empty();
  const std::span<const Part> parts = is_surface ? std::span<const Part>(parts_at_surface) : parts_in_body;
  RowOfHeat amended;
  const ComplexLanes* const heat = heat_of_row(row, amended);
  AlignedVector<Lanes> buffer(waves);
  AlignedVector<Complex> sums(parts.size() * pitch);
  std::vector<HeatCoat::Place> places;
  places.reserve(waves_.blocks());
  for (std::size_t block = 0; block < waves_.blocks(); ++block)
    places.push_back(waves_.coat->place_of(waves_.k[waves_.block_of(row) + block]));
  std::vector<Complex*> out(count);
  for (std::size_t d = 0; d < wanted.depths.size(); ++d)
  {
    const std::span<const SurfaceWave> all = waves_.row_of_waves(row);
    const std::size_t columns = columns_that_reach(wanted.depths[d].depth, all);
    for (std::size_t block = 0; block * lane_count < columns; ++block)
    {
      const Lanes along = wanted.factor * left_along(waves_.block_of(row) + block, wanted.duration);
      for (std::size_t p = 0; p < parts.size(); ++p)
      {
        const ComplexLanes sum = along * waves_.coated_sum(parts[p], is_surface ? 0 : wanted.numbers[d], places[block],
                                                           heat + block * waves, wanted.left, buffer);
        store_lanes(sum, sums.data() + p * pitch + block * lane_count);
      }
    }
    for (std::size_t f = 0; f < count; ++f)
      out[f] = wanted.spectra + (d * count + f) * waves_.fft.plane() + waves_.begin_of(row);
    const auto part = [&](std::size_t p) {
      return p < parts.size() ? std::span<const Complex>(sums.data() + p * pitch, columns) : std::span<const Complex>();
    };
    HeatRow of_row{.depth = wanted.depths[d].depth,
                   .waves = all.first(columns),
                   .decay = {},
                   .temperature = {},
                   .potential = {},
                   .slope = {},
                   .potential_at_surface = {}};
    if (is_surface)
      of_row.moved = part(0), of_row.moved_along = part(1);
    else
      of_row.temperature = part(0), of_row.ll = part(1), of_row.zz = part(2), of_row.lz = part(3);
    wanted.fields_of_heat.waves(of_row, out);
    for (Complex* field : out)
      std::fill(field + columns, field + waves_.columns(), Complex{});
  }
}

void HeatMemory::find_coated(double duration, double factor, std::span<const DepthFactors> depths,
                             const FieldsOfHeat& fields_of_heat, Complex* spectra) const
{
  CoatedRow wanted{duration, factor, waves_.left_in_depth(duration), depths, {}, fields_of_heat, spectra};
  if (!depths.front().temperature.empty())
  {
    for (const DepthFactors& depth : depths)
      wanted.numbers.push_back(waves_.coat->number_of(depth.depth));
    waves_.coat->require_depths(*std::max_element(wanted.numbers.begin(), wanted.numbers.end()) + 1);
  }
  if (!is_shared(waves_.fft.plane()))
  {
    for (int row = 0; row < waves_.fft.rows(); ++row)
      coated_row(row, wanted);
    return;
  }
#pragma omp parallel for schedule(static)
  for (int row = 0; row < waves_.fft.rows(); ++row)
    coated_row(row, wanted);
}

} // namespace brinell::halfspace
