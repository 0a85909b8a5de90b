// SPDX-License-Identifier: BSD-3-Clause
#include "stack_stress.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell::halfspace
{

using layer_waves::Field;
using layer_waves::Layer;
using layer_waves::Wave;

void StackStress::Matrix::set(std::size_t lane, const green::StackWave::Matrix& matrix, double in_plane, double across)
{
  aa[lane] = in_plane * matrix.aa;
  ac[lane] = in_plane * matrix.ac;
  ca[lane] = in_plane * matrix.ca;
  cc[lane] = in_plane * matrix.cc;
  ww[lane] = across * matrix.ww;
}

StackStress::StackStress(const VolumeGrid& grid, const ElasticStack& stack, const BlockedFft& fft,
                         const layer_waves::Shortest& shortest, const Portion& blocks)
    : grid_(grid), fft_(fft), blocks_(blocks), parts_(stack_parts(grid, stack)),
      spectra_bytes_(static_cast<std::size_t>(fft.blocks()) * static_cast<std::size_t>(fft.py()) *
                     static_cast<std::size_t>(Deviator::size * grid.nz) * sizeof(ComplexLanes))
{
  for (const StackPart& part : parts_)
    stiffness_.push_back({part.elastic.shear_modulus() / (2.0 * (1.0 - part.elastic.poisson_ratio)),
                          part.elastic.shear_modulus(), part.elastic.poisson_ratio});
  const int rows = fft.py() / 2 + 1;
  factors_.resize(static_cast<std::size_t>(blocks.count() * rows));
  surface_.resize(factors_.size());
  couplings_.resize(factors_.size() * parts_.size());
#pragma omp parallel for schedule(static)
  for (int block = blocks.first; block < blocks.end; ++block)
    for (int i = lane_count * block; i < std::min(fft.kx(), lane_count * (block + 1)); ++i)
      for (int row = 0; row < rows; ++row)
        set(i, row, stack, shortest);
}

/// The waves of a material are in units of its stiffness; StackWave has them in units of stress.
void StackStress::set(int column, int row, const ElasticStack& stack, const layer_waves::Shortest& shortest)
{
  const double m = 2.0 * std::numbers::pi * column / (fft_.px() * grid_.surface.dx);
  const double n = 2.0 * std::numbers::pi * row / (fft_.py() * grid_.surface.dy);
  const auto lane = static_cast<std::size_t>(column % lane_count);
  const std::size_t wave = wave_at(column / lane_count, row);
  constexpr double unit_nu = 0.5, unit_mu = 1.0; // mu / 2 (1 - nu) = 1
  factors_[wave].set(lane, m, n, 2 * column == fft_.px() ? std::sqrt(shortest.x) : 1.0,
                     2 * row == fft_.py() ? std::sqrt(shortest.y) : 1.0, grid_.dz, unit_nu, unit_mu);
  const double k = std::hypot(m, n);
  if (k == 0.0)
    return;
  const green::StackWave waves(stack, k);
  surface_[wave].set(lane, waves.from_free_surface(), 1.0, 1.0);
  for (std::size_t p = 0; p < parts_.size(); ++p)
  {
    Coupling& coupling = couplings_[wave * parts_.size() + p];
    const green::StackWave::Layer& layer = waves.layers()[p];
    const double x = k * (parts_[p].end - parts_[p].first) * grid_.dz;
    coupling.way[lane] = x;
    coupling.decay[lane] = std::exp(-x);
    if (p + 1 < parts_.size())
    {
      const double in_plane = stiffness_[p].in_plane / stiffness_[p + 1].in_plane;
      const double across = stiffness_[p].across / stiffness_[p + 1].across;
      coupling.reflected.set(lane, layer.reflected, 1.0, 1.0);
      coupling.transmitted.set(lane, layer.transmitted, in_plane, across);
      coupling.lifted.set(lane, layer.lifted, 1.0 / in_plane, 1.0 / across);
      coupling.returned.set(lane, layer.returned, 1.0, 1.0);
      continue;
    }
    // Beneath the cells the last material goes on.
    green::StackWave::Layer rest = layer;
    rest.x = std::max(0.0, layer.x - x);
    coupling.reflected.set(lane, green::StackWave::seen_from_top(rest), 1.0, 1.0);
  }
}

StackStress::Scratch StackStress::make_scratch() const
{
  constexpr auto rows = static_cast<std::size_t>(SpectrumRows::most);
  return {AlignedVector<Layer>(static_cast<std::size_t>(grid_.nz) * rows), AlignedVector<Ends>(parts_.size() * rows)};
}

StackStress::Point StackStress::travelled(const Coupling& over, const Point& wave)
{
  return {over.decay * (wave.a - over.way * wave.c), over.decay * wave.c, over.decay * wave.w};
}

StackStress::Factors StackStress::scaled(const Factors& unit, std::size_t part) const
{
  const auto& [in_plane, across, nu] = stiffness_[part];
  Factors f = unit;
  for (Lanes* value : {&f.e0, &f.e1, &f.e2, &f.m0, &f.m1})
    *value *= in_plane;
  f.e3 *= across;
  f.m2 *= across;
  return f;
}

/// Rows that are propagated through the layers together.
struct StackStress::Tile
{
  SpectrumRows rows;
  std::array<Factors, SpectrumRows::most> units;
  std::array<const Matrix*, SpectrumRows::most> surface;
  std::array<const Coupling*, SpectrumRows::most> couplings; ///< [material]

  [[nodiscard]] static std::size_t place(int index, int row)
  {
    return static_cast<std::size_t>(index * SpectrumRows::most + row);
  }
};

void StackStress::apply(int block, const SpectrumRows& rows, const EigenstrainStress::Spectra& spectra,
                        Scratch& scratch) const
{
  Tile tile{rows, {}, {}, {}};
  const bool is_opposite = rows.first != fft_.folded(rows.first);
  for (int r = 0; r < rows.count; ++r)
  {
    const auto at = static_cast<std::size_t>(r);
    const std::size_t wave = wave_at(block, fft_.folded(rows.first + r));
    Factors& f = tile.units[at] = factors_[wave];
    if (is_opposite)
    {
      f.ly = -f.ly;
      f.lxly = -f.lxly;
    }
    tile.surface[at] = &surface_[wave];
    tile.couplings[at] = &couplings_[wave * parts_.size()];
  }
  gather(spectra, tile, scratch);
  join(tile, scratch);
  go_up(spectra, tile, scratch);
  go_down(spectra, tile, scratch);
}

namespace
{

/// Arithmetic with subnormal numbers is slow.
Lanes without_subnormals(const Lanes& value)
{
  constexpr double nothing = 1e-290;
  return value > nothing ? value : Lanes{};
}

green::SheetWave<ComplexLanes> sum(const green::SheetWave<ComplexLanes>& p, const green::SheetWave<ComplexLanes>& q)
{
  return {p.a + q.a, p.c + q.c, p.w + q.w};
}

} // namespace

/// Strain in the frame of the waves, and the waves of the strain at the ends of its material. Those that arrive at the bottom are summed
/// upwards, too, each with its decay.
void StackStress::gather(const EigenstrainStress::Spectra& spectra, const Tile& tile, Scratch& scratch) const
{
  const std::ptrdiff_t pitch = fft_.pitch();
  for (int p = 0; p < static_cast<int>(parts_.size()); ++p)
  {
    const StackPart& part = parts_[static_cast<std::size_t>(p)];
    std::array<Wave, SpectrumRows::most> up{}, down{};
    std::array<Lanes, SpectrumRows::most> decay;
    decay.fill(Lanes{} + 1.0);
    for (int i = part.end - 1; i >= part.first && part.first < spectra.strained; --i)
      for (int r = 0; r < tile.rows.count; ++r)
      {
        const auto at = static_cast<std::size_t>(r);
        const Factors& f = tile.units[at];
        if (i < spectra.strained)
        {
          const ComplexLanes* strain =
              spectra.strain + static_cast<std::ptrdiff_t>(i) * Deviator::size * pitch + tile.rows.first + r;
          for (int c = 1; i > 0 && c <= Deviator::size; ++c)
            fetch_soon(strain - c * pitch);
          Layer& layer = scratch.layers[Tile::place(i, r)];
          layer.strain = green::in_wave_frame<Lanes>(f, part.elastic.poisson_ratio, strain[0], strain[pitch],
                                                     strain[2 * pitch], strain[3 * pitch], strain[4 * pitch]);
          layer_waves::advance(f, layer.strain, -1.0, up[at]);
          const green::SheetWave<ComplexLanes> source = green::wave_of(layer.strain, 1.0);
          Wave& arriving = down[at];
          const ComplexLanes c = decay[at] * source.c;
          arriving.a = arriving.a + decay[at] * source.a;
          arriving.c = arriving.c + c;
          arriving.c1 = arriving.c1 + static_cast<double>(part.end - i) * c;
          arriving.w = arriving.w + decay[at] * source.w;
        }
        decay[at] = without_subnormals(decay[at] * f.q);
      }
    for (int r = 0; r < tile.rows.count; ++r)
    {
      const auto at = static_cast<std::size_t>(r);
      Ends& ends = scratch.ends[Tile::place(p, r)];
      ends.source_down = layer_waves::at_boundary(tile.units[at], down[at]);
      ends.up_at_top = layer_waves::at_boundary(tile.units[at], up[at]);
    }
  }
}

/// Waves that start at the surface and at the interfaces: docs/theory/stacks.md (stack-sources).
void StackStress::join(const Tile& tile, Scratch& scratch) const
{
  const int count = static_cast<int>(parts_.size());
  for (int r = 0; r < tile.rows.count; ++r)
  {
    const Coupling* couplings = tile.couplings[static_cast<std::size_t>(r)];
    const auto ends = [&](int p) -> Ends& { return scratch.ends[Tile::place(p, r)]; };
    ends(count - 1).from_beneath = {};
    for (int p = count - 1; p >= 0; --p)
    {
      Ends& own = ends(p);
      own.up_at_top =
          sum(own.up_at_top, travelled(couplings[p], sum(couplings[p].reflected * own.source_down, own.from_beneath)));
      if (p > 0)
        ends(p - 1).from_beneath = couplings[p - 1].lifted * own.up_at_top;
    }
    ends(0).down = *tile.surface[static_cast<std::size_t>(r)] * ends(0).up_at_top;
    for (int p = 0; p < count; ++p)
    {
      Ends& own = ends(p);
      const Point at_bottom = sum(travelled(couplings[p], own.down), own.source_down);
      own.up = sum(couplings[p].reflected * at_bottom, own.from_beneath);
      if (p + 1 < count)
        ends(p + 1).down = sum(couplings[p].transmitted * at_bottom, couplings[p].returned * ends(p + 1).up_at_top);
    }
  }
}

/// Stress of the waves from below.
void StackStress::go_up(const EigenstrainStress::Spectra& spectra, const Tile& tile, Scratch& scratch) const
{
  for (std::size_t p = 0; p < parts_.size() && parts_[p].first < spectra.layers; ++p)
    for (int r = 0; r < tile.rows.count; ++r)
    {
      const Factors f = scaled(tile.units[static_cast<std::size_t>(r)], p);
      Wave up = layer_waves::from_boundary(f, scratch.ends[Tile::place(static_cast<int>(p), r)].up);
      for (int i = parts_[p].end - 1; i >= parts_[p].first; --i)
      {
        Layer& layer = scratch.layers[Tile::place(i, r)];
        const Field below = layer_waves::emit(f, up);
        layer.below_ll = below.ll;
        layer.below_zz = below.zz;
        layer.below_lz = below.lz;
        layer.below_lt = below.lt;
        if (i < spectra.strained)
          layer_waves::advance(f, layer.strain, -1.0, up);
        else
          layer_waves::pass(f, up);
      }
    }
}

/// Adds the stress of the waves from above and of each layer in itself, and transforms the sum to the axes x, y, z.
void StackStress::go_down(const EigenstrainStress::Spectra& spectra, const Tile& tile, const Scratch& scratch) const
{
  const bool past_caches = spectra_bytes_ > cached_bytes;
  const std::ptrdiff_t pitch = fft_.pitch();
  for (std::size_t p = 0; p < parts_.size(); ++p)
  {
    std::array<Factors, SpectrumRows::most> factors;
    std::array<Wave, SpectrumRows::most> waves;
    for (int r = 0; r < tile.rows.count; ++r)
    {
      const auto at = static_cast<std::size_t>(r);
      factors[at] = scaled(tile.units[at], p);
      waves[at] = layer_waves::from_boundary(factors[at], scratch.ends[Tile::place(static_cast<int>(p), r)].down);
    }
    for (int i = parts_[p].first; i < std::min(parts_[p].end, spectra.layers); ++i)
      for (int r = 0; r < tile.rows.count; ++r)
      {
        const auto at = static_cast<std::size_t>(r);
        const Factors& f = factors[at];
        const Layer& layer = scratch.layers[Tile::place(i, r)];
        Field s = layer_waves::emit(f, waves[at]);
        ComplexLanes tz;
        if (i < spectra.strained)
        {
          tz = layer_waves::add_own(f, layer, s);
          layer_waves::advance(f, layer.strain, 1.0, waves[at]);
        }
        else
        {
          tz = times_i(s.lt - layer.below_lt);
          s = {s.ll + layer.below_ll, s.zz + layer.below_zz, times_i(s.lz - layer.below_lz), s.lt + layer.below_lt};
          layer_waves::pass(f, waves[at]);
        }
        const auto axes = green::in_axes<Lanes>(f, stiffness_[p].nu, s.ll, s.zz, s.lz, s.lt, tz);
        ComplexLanes* stress =
            spectra.stress + static_cast<std::ptrdiff_t>(i) * Deviator::size * pitch + tile.rows.first + r;
        for (int c = 0; !past_caches && i + 1 < spectra.layers && c < Deviator::size; ++c)
          write_soon(stress + (Deviator::size + c) * pitch); // of the next layer
        for (const ComplexLanes& component : {axes.xx, axes.yy, axes.yz, axes.xz, axes.xy})
        {
          store_lanes(component, stress, past_caches);
          stress += pitch;
        }
        if (spectra.trace != nullptr)
          spectra.trace[static_cast<std::ptrdiff_t>(i) * pitch + tile.rows.first + r] = axes.trace;
      }
  }
  for (int i = parts_.back().end; i < spectra.layers; ++i) // in a rigid base
    for (int r = 0; r < tile.rows.count; ++r)
    {
      for (std::ptrdiff_t c = 0; c < Deviator::size; ++c)
        spectra.stress[(i * Deviator::size + c) * pitch + tile.rows.first + r] = {};
      if (spectra.trace != nullptr)
        spectra.trace[i * pitch + tile.rows.first + r] = {};
    }
  end_streaming();
}

} // namespace brinell::halfspace
