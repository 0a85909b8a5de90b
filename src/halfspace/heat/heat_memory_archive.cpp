// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/require_size.hpp"
#include "heat_memory.hpp"

#include <algorithm>

/// Conversion of the state of a heat memory from and to the layout in which it is stored.
namespace brinell::halfspace
{

std::vector<double> HeatMemory::whole(const AlignedVector<Complex>& planes) const
{
  const std::size_t all = fft_.whole_plane();
  AlignedVector<Complex> plane(all);
  std::vector<double> values;
  values.reserve(2 * planes.size() / fft_.plane() * all);
  for (std::size_t at = 0; at < planes.size(); at += fft_.plane())
  {
    fft_.complete(planes.data() + at, plane.data());
    const auto* parts = reinterpret_cast<const double*>(plane.data());
    values.insert(values.end(), parts, parts + 2 * all);
  }
  return values;
}

AlignedVector<Complex> HeatMemory::independent_rows_of(std::span<const double> values) const
{
  const std::size_t all = 2 * fft_.whole_plane(), planes = values.size() / all;
  AlignedVector<Complex> rows(planes * fft_.plane());
  for (std::size_t p = 0; p < planes; ++p)
    std::copy_n(values.data() + p * all, 2 * columns() * static_cast<std::size_t>(fft_.rows()),
                reinterpret_cast<double*>(rows.data() + p * fft_.plane()));
  return rows;
}

/// The heat, [wave][row][column].
AlignedVector<Complex> HeatMemory::planes() const
{
  AlignedVector<Complex> planes(waves_.waves.size() * fft_.plane());
  for (std::size_t w = 0; w < waves_.waves.size(); ++w)
    for (int row = 0; row < fft_.rows(); ++row)
      for (std::size_t i = 0; i < columns(); ++i)
      {
        const ComplexLanes& value = heat_.waves[(block_of(row) + i / lane_count) * waves_.waves.size() + w];
        planes[w * fft_.plane() + begin_of(row) + i] = {value.re[i % lane_count], value.im[i % lane_count]};
      }
  return planes;
}

HeatMemory::WholeHeat HeatMemory::whole_heat() const
{
  return {whole(planes()), whole(heat_.amended), heat_.motion};
}

void HeatMemory::set_whole_heat(const WholeHeat& heat)
{
  const std::size_t all = 2 * fft_.whole_plane();
  require_size("HeatMemory::set_whole_heat: the heat", heat.waves, waves_.waves.size() * all);
  require_size("HeatMemory::set_whole_heat: the amended heat", heat.amended, heat.amended.empty() ? 0 : all);
  const AlignedVector<Complex> planes = independent_rows_of(heat.waves);
  heat_.amended = independent_rows_of(heat.amended);
  heat_.motion = heat.motion;
  if (!heat_.amended.empty())
    plan_step(heat_.motion);
  const std::size_t waves = waves_.waves.size();
  sums_.reset();
  for (std::size_t w = 0; w < waves; ++w)
    for (int row = 0; row < fft_.rows(); ++row)
      for (std::size_t i = 0; i < columns(); ++i)
      {
        ComplexLanes& value = heat_.waves[(block_of(row) + i / lane_count) * waves + w];
        const Complex& given = planes[w * fft_.plane() + begin_of(row) + i];
        value.re[i % lane_count] = given.real();
        value.im[i % lane_count] = given.imag();
      }
}

std::vector<double> HeatMemory::whole_heat_in_body() const
{
  return buried_ && !buried_->is_cold() ? whole(buried_->modes(fft_.plane())) : std::vector<double>{};
}

void HeatMemory::set_whole_heat_in_body(std::span<const double> values)
{
  if (!buried_)
    return;
  require_size("HeatMemory::set_whole_heat_in_body: the heat", values,
               values.empty() ? 0 : 2 * buried_->layers().size() * fft_.whole_plane());
  buried_->set_modes(independent_rows_of(values), fft_.plane());
}

} // namespace brinell::halfspace
