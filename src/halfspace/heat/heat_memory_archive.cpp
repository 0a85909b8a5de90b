// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/require_size.hpp"
#include "heat_memory.hpp"

#include <algorithm>

/// Conversion of the state of a heat memory from and to the layout in which it is stored.
namespace brinell::halfspace
{

/// The heat, [wave][row][column].
AlignedVector<Complex> HeatMemory::planes() const
{
  AlignedVector<Complex> planes(waves_.in_depth.waves.size() * waves_.fft.plane());
  for (std::size_t w = 0; w < waves_.in_depth.waves.size(); ++w)
    for (int row = 0; row < waves_.fft.rows(); ++row)
      for (std::size_t i = 0; i < waves_.columns(); ++i)
      {
        const ComplexLanes& value =
            heat_.waves[(waves_.block_of(row) + i / lane_count) * waves_.in_depth.waves.size() + w];
        planes[w * waves_.fft.plane() + waves_.begin_of(row) + i] = {value.re[i % lane_count],
                                                                     value.im[i % lane_count]};
      }
  return planes;
}

HeatMemory::WholeHeat HeatMemory::whole_heat() const
{
  return {waves_.whole(planes()), waves_.whole(heat_.amended), heat_.motion};
}

void HeatMemory::set_whole_heat(const WholeHeat& heat)
{
  const std::size_t all = 2 * waves_.fft.whole_plane();
  require_size("HeatMemory::set_whole_heat: the heat", heat.waves, waves_.in_depth.waves.size() * all);
  require_size("HeatMemory::set_whole_heat: the amended heat", heat.amended, heat.amended.empty() ? 0 : all);
  const AlignedVector<Complex> planes = waves_.independent_rows_of(heat.waves);
  heat_.amended = waves_.independent_rows_of(heat.amended);
  heat_.motion = heat.motion;
  if (!heat_.amended.empty())
    plan_step(heat_.motion);
  const std::size_t waves = waves_.in_depth.waves.size();
  sums_.reset();
  for (std::size_t w = 0; w < waves; ++w)
    for (int row = 0; row < waves_.fft.rows(); ++row)
      for (std::size_t i = 0; i < waves_.columns(); ++i)
      {
        ComplexLanes& value = heat_.waves[(waves_.block_of(row) + i / lane_count) * waves + w];
        const Complex& given = planes[w * waves_.fft.plane() + waves_.begin_of(row) + i];
        value.re[i % lane_count] = given.real();
        value.im[i % lane_count] = given.imag();
      }
}

std::vector<double> HeatMemory::whole_heat_in_body() const
{
  return buried_ && !buried_->is_cold() ? waves_.whole(buried_->modes(waves_.fft.plane())) : std::vector<double>{};
}

void HeatMemory::set_whole_heat_in_body(std::span<const double> values)
{
  if (!buried_)
    return;
  require_size("HeatMemory::set_whole_heat_in_body: the heat", values,
               values.empty() ? 0 : 2 * buried_->layers().size() * waves_.fft.whole_plane());
  buried_->set_modes(waves_.independent_rows_of(values), waves_.fft.plane());
}

} // namespace brinell::halfspace
