// SPDX-License-Identifier: BSD-3-Clause
#include "stack_cells.hpp"

#include "brinell/halfspace/surface_compliance.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/fft.hpp"
#include "radial_table.hpp"
#include "stack_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <utility>

namespace brinell::halfspace
{

namespace
{

using green::WaveLoad;
using std::numbers::pi;

/// (1 - nu) / mu [1/Pa]; zero for a rigid body.
double normal_compliance(const Elastic& body)
{
  return body.is_rigid() ? 0.0 : (1.0 - body.poisson_ratio) / body.shear_modulus();
}

} // namespace

void require_resolved(const SurfaceGrid& grid, const ElasticStack& stack)
{
  if (stack.is_homogeneous() || grid.is_periodic())
    return;
  constexpr double least = 0.25; // of a cell
  const bool is_row = grid.ny == 1 && grid.is_periodic_y(), is_column = grid.nx == 1 && grid.is_periodic_x();
  const double cell = is_row ? grid.dx : is_column ? grid.dy : std::max(grid.dx, grid.dy);
  if (const double thickness = stack.layers.front().thickness; thickness < least * cell)
    throw InputError(fmt::format("the first layer is {:.4g} m thick on cells of {:.4g} m along the surface; allowed: a "
                                 "thickness of {:.4g} m at least, or smaller cells",
                                 thickness, cell, least * cell));
}

Quadrant<double> excess_displacement(const SurfaceGrid& surface, const ElasticStack& stack, double reference)
{
  const SurfaceGrid grid = surface.whole();
  const double of_top = normal_compliance(stack.top()), of_substrate = normal_compliance(stack.substrate);
  const double depth = depth_of_forms(grid, stack);
  // Without the long waves of the substrate at the depth H.
  const auto rest = [&](double k)
  {
    return green::StackWave(stack, k).compliance().normal -
           (of_top + (of_substrate - of_top) * std::exp(-k * depth)) / k;
  };
  const double step = long_wave(std::max(reach(stack), depth));
  const LongWaves at_zero = extrapolated({rest(step), rest(2.0 * step), rest(3.0 * step), rest(4.0 * step)}, step);
  const double of_angle = -at_zero.rising / depth; // such that the rest has no term in k
  const Lattice lattice = lattice_of(grid, stack);
  const WaveRange range = range_of(grid, lattice);
  std::vector<std::array<double, 1>> values;
  for (const double k : RadialTable<1>::wavenumbers(range.smallest, range.largest))
    values.push_back({rest(k) - of_angle * std::exp(-k * depth)});
  const RadialTable<1> table(range.smallest, values);
  const PaddedFft fft(grid, lattice.px, lattice.py);
  std::vector<Complex> spectrum(fft.plane());
  for (int row = 0; row < lattice.py; ++row)
    for (int i = 0; i < fft.kx(); ++i)
      spectrum[static_cast<std::size_t>(row * fft.kx() + i)] =
          (i == 0 && row == 0 ? at_zero.level - of_angle : 0.0) +
          folded<double>(grid, lattice, i, row,
                         [&](double m, double n, double cell, double& sum)
                         { sum += cell * table.at(std::hypot(m, n))[0]; });
  std::vector<double> field(grid.size());
  fft.inverse(spectrum.data(), field);
  const Quadrant<std::array<double, 2>> buried = buried_cell(grid, depth, reference);
  Quadrant<double> out(grid);
  for (int j = 0; j < out.ny; ++j)
    for (int i = 0; i < out.nx; ++i)
      out.at(i, j) = field[grid.index(i, j)] +
                     0.5 / pi * ((of_substrate - of_top) * buried.at(i, j)[0] + of_angle * buried.at(i, j)[1]);
  return out;
}

namespace
{

/// Values of a wave in the axes x, y, z.
SymTensor in_axes(Traction traction, const ExcessStress::Parts& p, double lx, double ly)
{
  const auto& [ll, tt, zz, lz, lt, tz] = p;
  const double xx = lx * lx, yy = ly * ly;
  if (traction == Traction::pressure)
    return {xx * ll + yy * tt, yy * ll + xx * tt, zz, ly * lz, lx * lz, lx * ly * (ll - tt)};
  // A shear along x is lx along l and -ly along t.
  return {lx * (xx * ll + yy * (tt + 2.0 * lt)),
          lx * (yy * (ll - 2.0 * lt) + xx * tt),
          lx * zz,
          lx * ly * (lz - tz),
          xx * lz + yy * tz,
          ly * (xx * (ll - tt) + (yy - xx) * lt)};
}

std::vector<WaveLoad> loads_of(Traction traction)
{
  return traction == Traction::pressure ? std::vector{WaveLoad::pressure}
                                        : std::vector{WaveLoad::along, WaveLoad::across};
}

/// Mean over a range of depths, which may contain interfaces.
ExcessStress::Parts mean_parts(const ElasticStack& stack, const green::StackWave& wave,
                               const std::vector<green::StackWave::Field>& fields, Traction traction, double from,
                               double to)
{
  ExcessStress::Parts sum{};
  const std::vector<WaveLoad> loads = loads_of(traction);
  double top = 0.0;
  for (std::size_t layer = 0; layer <= stack.layers.size(); ++layer)
  {
    const double bottom =
        layer < stack.layers.size() ? top + stack.layers[layer].thickness : std::numeric_limits<double>::infinity();
    const double begin = std::max(from, top), end = std::min(to, bottom);
    // An interface on a boundary of cells is not cut by rounding.
    if (end - begin > 1e-9 * (to - from) && !stack.of_layer(layer).is_rigid())
      for (std::size_t load = 0; load < loads.size(); ++load)
      {
        const green::WaveStress s = wave.mean_stress(loads[load], fields[load], layer, begin, end);
        const double share = (end - begin) / (to - from);
        const ExcessStress::Parts parts{s.ll, s.tt, s.zz, s.lz, s.lt, s.tz};
        for (std::size_t p = 0; p < parts.size(); ++p)
          sum[p] += share * parts[p];
      }
    top = bottom;
  }
  return sum;
}

std::vector<green::StackWave::Field> fields_of(const green::StackWave& wave, Traction traction)
{
  std::vector<green::StackWave::Field> fields;
  for (const WaveLoad load : loads_of(traction))
    fields.push_back(wave.field_of(load));
  return fields;
}

} // namespace

SymTensor stack_wave_stress(const ElasticStack& stack, Traction traction, double k, double lx, double ly, double from,
                            double to)
{
  if (traction == Traction::shear_y)
    return xy_exchanged(stack_wave_stress(stack, Traction::shear_x, k, ly, lx, from, to));
  const green::StackWave wave(stack, k);
  return in_axes(traction, mean_parts(stack, wave, fields_of(wave, traction), traction, from, to), lx, ly);
}

namespace
{

std::array<Quadrant<SymTensor>, 2> forms_of(const SurfaceGrid& grid, double depth, Traction traction)
{
  return {cell_stress(grid, depth, 0.0, traction), cell_stress(grid, depth, 0.5, traction)};
}

} // namespace

ExcessStress::ExcessStress(const VolumeGrid& grid, const ElasticStack& stack, Traction traction)
    : grid_{grid.surface.whole(), grid.nz, grid.dz}, stack_(stack), traction_(traction),
      depth_(depth_of_forms(grid_.surface, stack)), by_pressure_(forms_of(grid_.surface, depth_, Traction::pressure)),
      by_shear_x_(forms_of(grid_.surface, depth_, Traction::shear_x)),
      by_shear_y_(forms_of(grid_.surface, depth_, Traction::shear_y))
{
  const WaveRange range = range_of(grid_.surface, lattice_of(grid_.surface, stack));
  smallest_ = range.smallest;
  for (const double k : RadialTable<part_count>::wavenumbers(range.smallest, range.largest))
    nodes_.push_back(node_at(k));
  const double step = long_wave(std::max({reach(stack), depth_, grid.nz * grid.dz}));
  for (const int times : {1, 2, 3, 4})
    long_nodes_.push_back(node_at(times * step));
}

ExcessStress::Node ExcessStress::node_at(double k) const
{
  green::StackWave wave(stack_, k);
  std::vector<green::StackWave::Field> fields = fields_of(wave, traction_);
  return {std::move(wave), k, std::move(fields)};
}

ExcessStress::Parts ExcessStress::excess(const Node& node, int layer) const
{
  const double from = layer * grid_.dz, to = (layer + 1) * grid_.dz;
  Parts parts = mean_parts(stack_, node.wave, node.fields, traction_, from, to);
  const ElasticStack alone{{}, {1.0, stack_.at(0.5 * (from + to)).poisson_ratio}};
  const green::StackWave wave(alone, node.k);
  const Parts homogeneous = mean_parts(alone, wave, fields_of(wave, traction_), traction_, from, to);
  for (std::size_t p = 0; p < parts.size(); ++p)
    parts[p] -= homogeneous[p];
  return parts;
}

std::array<LongWaves, ExcessStress::part_count> ExcessStress::long_waves_of(int layer) const
{
  std::array<Parts, 4> values{};
  for (std::size_t n = 0; n < values.size(); ++n)
    values[n] = excess(long_nodes_[n], layer);
  std::array<LongWaves, part_count> result{};
  for (std::size_t p = 0; p < part_count; ++p)
  {
    const LongWaves found =
        extrapolated({values[0][p], values[1][p], values[2][p], values[3][p]}, long_nodes_.front().k);
    // The wave e^{-kH} has a slope of its own.
    result[p] = {found.level, found.level + found.rising / depth_};
  }
  // zz, and lz of a pressure, begin with k^2 or with components of the wavevector, which do not reach far.
  result[2] = {};
  if (traction_ == Traction::pressure)
    result[3] = {};
  return result;
}

/// The stress in bodies with Poisson's ratios 0 and 1/2, by pressure and by shear, contains each form in some difference.
ExcessStress::Forms ExcessStress::forms_at(int i, int j) const
{
  const SymTensor &p0 = by_pressure_[0].at(i, j), &p5 = by_pressure_[1].at(i, j);
  Forms f;
  f.xx.level = p0[1] - p5[1];
  f.yy.level = p0[0] - p5[0];
  f.xy.level = p5[5] - p0[5];
  f.xx.rising = p0[0] + f.xx.level;
  f.yy.rising = p0[1] + f.yy.level;
  f.xy.rising = p0[5] + f.xy.level;
  if (traction_ == Traction::pressure)
    return f;
  const auto of_shear =
      [](const SymTensor& q0, const SymTensor& q5, std::size_t x, std::size_t y, LongWaves& xxx, LongWaves& xyy)
  {
    xyy.level = q5[x] - q0[x];
    xxx.level = 0.5 * trace(q0) - xyy.level;
    xyy.rising = -q0[y];
    xxx.rising = q0[2] - xyy.rising;
  };
  of_shear(by_shear_x_[0].at(i, j), by_shear_x_[1].at(i, j), 0, 1, f.xxx, f.xyy);
  of_shear(by_shear_y_[0].at(i, j), by_shear_y_[1].at(i, j), 1, 0, f.yyy, f.xxy);
  return f;
}

Quadrant<SymTensor> ExcessStress::of_layer(int layer) const
{
  const std::array<LongWaves, part_count> far = long_waves_of(layer);
  std::vector<Parts> values;
  for (const Node& node : nodes_)
  {
    Parts parts = excess(node, layer);
    const double kH = node.k * depth_, decay = std::exp(-kH);
    for (std::size_t p = 0; p < part_count; ++p)
      parts[p] -= decay * (far[p].level + kH * far[p].rising);
    values.push_back(parts);
  }
  const RadialTable<part_count> table(smallest_, values);
  const SurfaceGrid& grid = grid_.surface;
  const Lattice lattice = lattice_of(grid, stack_);
  const PaddedFft fft(grid, lattice.px, lattice.py);
  std::array<std::vector<Complex>, 6> spectra;
  spectra.fill(std::vector<Complex>(fft.plane()));
  // xz and yz of a pressure are imaginary, and all others of a shear.
  const auto is_imaginary = [&](std::size_t c) { return (c == 3 || c == 4) == (traction_ == Traction::pressure); };
  for (int row = 0; row < lattice.py; ++row)
    for (int i = 0; i < fft.kx(); ++i)
    {
      const auto sum = folded<SymTensor>(grid, lattice, i, row,
                                         [&](double m, double n, double cell, SymTensor& total)
                                         {
                                           const double k = std::hypot(m, n);
                                           const SymTensor wave = in_axes(traction_, table.at(k), m / k, n / k);
                                           for (std::size_t c = 0; c < 6; ++c)
                                             total[c] += cell * wave[c];
                                         });
      for (std::size_t c = 0; c < 6; ++c)
        spectra[c][static_cast<std::size_t>(row * fft.kx() + i)] =
            is_imaginary(c) ? Complex(0.0, sum[c]) : Complex(sum[c]);
    }
  std::array<std::vector<double>, 6> fields;
  for (std::size_t c = 0; c < 6; ++c)
  {
    fields[c].resize(grid.size());
    fft.inverse(spectra[c].data(), fields[c]);
  }
  Quadrant<SymTensor> out(grid);
  const auto& [ll, tt, zz, lz, lt, tz] = far;
  const auto times = [](const LongWaves& a, const LongWaves& form)
  { return a.level * form.level + a.rising * form.rising; };
  for (int j = 0; j < out.ny; ++j)
    for (int i = 0; i < out.nx; ++i)
    {
      const Forms f = forms_at(i, j);
      SymTensor& value = out.at(i, j);
      if (traction_ == Traction::pressure)
        value = {times(ll, f.xx) + times(tt, f.yy), times(ll, f.yy) + times(tt, f.xx), 0.0, 0.0, 0.0,
                 times(ll, f.xy) - times(tt, f.xy)};
      else
        value = {times(ll, f.xxx) + times(tt, f.xyy) + 2.0 * times(lt, f.xyy),
                 times(ll, f.xyy) - 2.0 * times(lt, f.xyy) + times(tt, f.xxx),
                 0.0,
                 times(lz, f.xy) - times(tz, f.xy),
                 times(lz, f.xx) + times(tz, f.yy),
                 times(ll, f.xxy) - times(tt, f.xxy) + times(lt, f.yyy) - times(lt, f.xxy)};
      for (std::size_t c = 0; c < 6; ++c)
        value[c] += fields[c][grid.index(i, j)];
    }
  return out;
}

} // namespace brinell::halfspace
