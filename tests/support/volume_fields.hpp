// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/sym_tensor.hpp"
#include "brinell/halfspace/half_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

/// Deviator fields as the operators want them: 5 values per cell, component by component.
namespace brinell::test
{

inline constexpr std::array deviator_names{"xx", "yy", "yz", "xz", "xy"};

inline Deviator unit_deviator(int component)
{
  Deviator d;
  d[component] = 1.0;
  return d;
}

inline SymTensor as_tensor(const Deviator& d)
{
  return {d[Deviator::xx], d[Deviator::yy], -d[Deviator::xx] - d[Deviator::yy],
          d[Deviator::yz], d[Deviator::xz], d[Deviator::xy]};
}

inline Deviator deviator_at(const std::vector<double>& field, std::size_t cell)
{
  const std::size_t cells = field.size() / Deviator::size;
  Deviator d;
  for (int c = 0; c < Deviator::size; ++c)
    d[c] = field[static_cast<std::size_t>(c) * cells + cell];
  return d;
}

/// The field strain * profile(x, y, z), sampled at the cell centres; x = y = 0 is the centre of cell (0, 0).
template <class Profile>
std::vector<double> sampled_strain(const VolumeGrid& g, const Deviator& strain, Profile profile)
{
  std::vector<double> field(Deviator::size * g.size());
  for (int k = 0; k < g.nz; ++k)
    for (int j = 0; j < g.surface.ny; ++j)
      for (int i = 0; i < g.surface.nx; ++i)
      {
        const double f = profile(i * g.surface.dx, j * g.surface.dy, (k + 0.5) * g.dz);
        for (int c = 0; c < Deviator::size; ++c)
          field[static_cast<std::size_t>(c) * g.size() + g.index(i, j, k)] = f * strain[c];
      }
  return field;
}

/// Sum over all cells of a : b (double contraction of two deviator fields).
inline double contracted(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t cell = 0; cell < a.size() / Deviator::size; ++cell)
    sum += contract(deviator_at(a, cell), deviator_at(b, cell));
  return sum;
}

/// Stress of a pressure and a plastic strain; an empty field is zero.
class StressField
{
public:
  StressField(const halfspace::HalfSpace& half_space, const std::vector<double>& pressure, std::vector<double> strain)
  {
    compute(half_space, {.pressure = pressure}, std::move(strain));
  }
  /// Of anything that acts on the surface.
  static StressField of(const halfspace::HalfSpace& half_space, const halfspace::SurfaceLoad& load,
                        std::vector<double> strain = {})
  {
    StressField field;
    field.compute(half_space, load, std::move(strain));
    return field;
  }

  [[nodiscard]] SymTensor at(std::size_t cell) const
  {
    SymTensor t = as_tensor(deviator_at(deviator, cell));
    for (std::size_t c = 0; c < 3; ++c)
      t[c] += trace[cell] / 3.0;
    return t;
  }

  std::vector<double> deviator, trace;

private:
  StressField() = default;
  void compute(const halfspace::HalfSpace& half_space, const halfspace::SurfaceLoad& load, std::vector<double> strain)
  {
    deviator.resize(Deviator::size * half_space.grid().size());
    trace.resize(half_space.grid().size());
    strain.resize(deviator.size(), 0.0);
    halfspace::HalfSpace::Work work = half_space.make_work();
    half_space.full_stress(load, strain, work, deviator, trace);
  }
};

/// Of two fields on grids that are alike but for their rows: the largest difference of a component between the cells of the
/// smaller one and those of the other that lie `rows` rows further along y.
inline double largest_difference(const VolumeGrid& small, const StressField& here, const VolumeGrid& large,
                                 const StressField& there, int rows)
{
  double difference = 0.0;
  for (int k = 0; k < small.nz; ++k)
    for (int j = 0; j < small.surface.ny; ++j)
      for (int i = 0; i < small.surface.nx; ++i)
        for (std::size_t c = 0; c < 6; ++c)
          difference = std::max(difference,
                                std::abs(here.at(small.index(i, j, k))[c] - there.at(large.index(i, j + rows, k))[c]));
  return difference;
}

} // namespace brinell::test
