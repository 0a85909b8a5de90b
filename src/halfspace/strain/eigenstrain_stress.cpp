// SPDX-License-Identifier: BSD-3-Clause
#include "eigenstrain_stress.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace brinell::halfspace
{

/// Factors of one block of wavenumbers. All couplings are zero for k = 0 and in lanes without a wavenumber.
/// At a Nyquist index lx or ly is zero, or reduced; this also drops the couplings of even order through the shears yz and xz,
/// which are negligible for a strain that the cells resolve. The contribution of couplings of odd order there is imaginary in a
/// row along x and is ignored by the inverse transform of the row.
struct EigenstrainStress::Factors : green::WaveDirection<Lanes>
{
  Lanes q{};                    ///< e^{-x}, x = k dz: decay over a layer
  Lanes e0{}, e1{}, e2{}, e3{}; ///< stress of arriving waves in the next layer
  Lanes m0{}, m1{}, m2{};       ///< stress of a layer in the layer itself
  Lanes x{}, rise{}, lag{};     ///< conversion of a wave at the surface to that of the image

  /// @param kept_x, kept_y  fractions of m / k and n / k that are retained
  void set(std::size_t lane, double m, double n, double kept_x, double kept_y, double dz, double nu, double mu);
};

void EigenstrainStress::Factors::set(std::size_t lane, double m, double n, double kept_x, double kept_y, double dz,
                                     double nu, double mu)
{
  const double k = std::hypot(m, n);
  if (k == 0.0)
  {
    lx2[lane] = 1.0; // any direction: every non-local factor is zero
    return;
  }
  lx2[lane] = m * m / (k * k);
  ly2[lane] = n * n / (k * k);
  lx[lane] = kept_x * m / k;
  ly[lane] = kept_y * n / k;
  lxly[lane] = lx[lane] * ly[lane];
  const double stiffness = mu / (2.0 * (1.0 - nu));
  const double x_ = k * dz;
  const double q_ = std::exp(-x_);
  const double s0 = -std::expm1(-x_) / x_; // mean of e^{-kz} over a layer
  const double s1 = 0.5 * (1.0 + q_) - s0; // mean of k (dz / 2 - z) e^{-kz} over a layer
  const double g1 = -std::expm1(-2.0 * x_) / (2.0 * x_) - s0 * s0;
  x[lane] = x_;
  q[lane] = q_;
  e0[lane] = stiffness * x_ * s0 * s0;
  e1[lane] = e0[lane] * x_;
  e2[lane] = 2.0 * stiffness * x_ * g1;
  e3[lane] = mu * x_ * s0 * s0;
  m0[lane] = stiffness * 2.0 * (1.0 - s0);
  m1[lane] = -stiffness * 2.0 * (x_ * s0 - 2.0 * (1.0 - s0));
  m2[lane] = mu * 2.0 * (1.0 - s0);
  rise[lane] = s1 / s0;
  lag[lane] = 0.5 - s1 / (x_ * s0) + 2.0 * g1 / (x_ * s0 * s0);
}

namespace
{

using Factors = EigenstrainStress::Factors;
using Layer = EigenstrainStress::Layer;

/// Amplitudes of the waves in one direction, each a running sum over the layers passed.
struct Wave
{
  ComplexLanes a, c, c1, w; ///< sum of a, of c, of c times the number of layers passed, and of w
};

/// Stress in the frame of the wavevector; lz and lt also stand for the shears lz and tz, without their factor +-i.
struct Field
{
  ComplexLanes ll, zz, lz, lt;
};

/// Mean stress in the next layer of the waves that arrive there.
Field emit(const Factors& f, const Wave& wave)
{
  const ComplexLanes ea = f.e0 * wave.a;
  const ComplexLanes ec = f.e0 * wave.c;
  const ComplexLanes sc = f.e1 * wave.c1 - f.e2 * wave.c;
  const ComplexLanes lz = ea + ec - sc;
  return {lz + ec, sc - ea, lz, f.e3 * wave.w};
}

/// Propagates the waves through one layer and adds those of its strain; g = +1 downwards, -1 upwards.
void advance(const Factors& f, const green::SheetStrain<ComplexLanes>& strain, double g, Wave& wave)
{
  const green::SheetWave<ComplexLanes> source = green::wave_of(strain, g);
  wave.c1 = f.q * (wave.c1 + wave.c) + source.c;
  wave.c = f.q * wave.c + source.c;
  wave.a = f.q * wave.a + source.a;
  wave.w = f.q * wave.w + source.w;
}

/// Propagates the waves through one layer without strain.
void pass(const Factors& f, Wave& wave)
{
  wave.c1 = f.q * (wave.c1 + wave.c);
  wave.c = f.q * wave.c;
  wave.a = f.q * wave.a;
  wave.w = f.q * wave.w;
}

/// The image of the waves that have arrived at the surface, on its way down. The amplitudes are such that `emit` gives
/// the mean over the first layer of a sheet at the surface, where it expects layers above.
Wave reflect(const Factors& f, const Wave& up)
{
  const ComplexLanes lagging = f.x * (up.c1 - 0.5 * up.c) - f.rise * up.c;
  const auto image = green::reflected<ComplexLanes>({up.a, up.c, up.w}, lagging);
  return {image.a, image.c, f.lag * image.c, image.w};
}

/// Adds the stress of a layer in itself and that of the layers below to the stress `s` of the layers above. @returns the total
/// tz: for the layers above and below it follows from lt up to the factor +-i, but not for the layer itself.
ComplexLanes add_own(const Factors& f, const Layer& layer, Field& s)
{
  const green::SheetStrain<ComplexLanes>& own = layer.strain;
  const ComplexLanes held = f.m0 * own.a - f.m1 * own.d;
  const Lanes twice = 2.0 * f.m0;
  const ComplexLanes tz = times_i(s.lt - layer.below_lt) - f.m2 * own.tz;
  s.ll = s.ll + layer.below_ll + held + twice * own.d;
  s.zz = s.zz + layer.below_zz - held;
  s.lz = times_i(s.lz - layer.below_lz) - (twice - 2.0 * f.m1) * own.lz;
  s.lt = s.lt + layer.below_lt + f.m2 * own.lt;
  return tz;
}

} // namespace

EigenstrainStress::~EigenstrainStress() = default;

EigenstrainStress::EigenstrainStress(const VolumeGrid& grid, const Elastic& elastic, const BlockedFft& fft,
                                     double shortest)
    : grid_(grid), nu_(elastic.poisson_ratio), mu_(elastic.shear_modulus()), fft_(fft),
      spectra_bytes_(static_cast<std::size_t>(fft.blocks()) * static_cast<std::size_t>(fft.py()) *
                     static_cast<std::size_t>(Deviator::size * grid.nz) * sizeof(ComplexLanes))
{
  const int rows = fft.py() / 2 + 1;
  factors_.resize(static_cast<std::size_t>(fft.blocks() * rows));
  for (int i = 0; i < fft.kx(); ++i)
    for (int row = 0; row < rows; ++row)
    {
      const double m = 2.0 * std::numbers::pi * i / (fft.px() * grid.surface.dx);
      const double n = 2.0 * std::numbers::pi * row / (fft.py() * grid.surface.dy);
      factors_[static_cast<std::size_t>(i / lane_count * rows + row)].set(
          static_cast<std::size_t>(i % lane_count), m, n, 2 * i == fft.px() ? std::sqrt(shortest) : 1.0,
          2 * row == fft.py() ? 0.0 : 1.0, grid.dz, nu_, mu_);
    }
}

void EigenstrainStress::add_local(int component, const std::array<const double*, Deviator::size>& strain,
                                  std::size_t cells, double* stress) const
{
  const double stiffness = -2.0 * mu_ / (1.0 - nu_);
  const auto add = [&](double factor, Deviator::Component of)
  {
    const double* e = strain[of];
#pragma omp simd
    for (std::size_t i = 0; i < cells; ++i)
      stress[i] += factor * e[i];
  };
  const double own = stiffness * (2.0 - nu_) / 3.0;
  const double other = stiffness * (2.0 * nu_ - 1.0) / 3.0;
  const double sum = stiffness * (1.0 + nu_);
  constexpr int trace = Deviator::size;
  if (component == Deviator::xy)
    add(-2.0 * mu_, Deviator::xy);
  else if (component == Deviator::xx || component == Deviator::yy || component == trace)
  {
    add(component == trace ? sum : component == Deviator::xx ? own : other, Deviator::xx);
    add(component == trace ? sum : component == Deviator::xx ? other : own, Deviator::yy);
  }
}

/// Rows that are propagated through the layers together.
struct EigenstrainStress::Tile
{
  std::array<const Factors*, SpectrumRows::most> factors;
  std::array<Wave, SpectrumRows::most> waves;
};

void EigenstrainStress::apply(int block, const SpectrumRows& rows, const Spectra& spectra, Scratch& scratch) const
{
  const auto factors_at = [&](int r)
  { return &factors_[static_cast<std::size_t>(block * (fft_.py() / 2 + 1) + fft_.folded(rows.first + r))]; };
  Tile tile;
  for (int r = 0; r < rows.count; ++r)
    tile.factors[static_cast<std::size_t>(r)] = factors_at(r);
  if (rows.first == fft_.folded(rows.first))
    return go_through(rows, spectra, tile, scratch);
  std::array<Factors, SpectrumRows::most> opposite;
  for (int r = 0; r < rows.count; ++r)
  {
    Factors& f = opposite[static_cast<std::size_t>(r)] = *factors_at(r);
    f.ly = -f.ly;
    f.lxly = -f.lxly;
    tile.factors[static_cast<std::size_t>(r)] = &f;
  }
  go_through(rows, spectra, tile, scratch);
}

void EigenstrainStress::go_through(const SpectrumRows& rows, const Spectra& spectra, Tile& tile, Scratch& scratch) const
{
  go_up(rows, spectra, tile, scratch);
  for (int r = 0; r < rows.count; ++r)
  {
    Wave& wave = tile.waves[static_cast<std::size_t>(r)];
    wave = reflect(*tile.factors[static_cast<std::size_t>(r)], wave);
  }
  go_down(rows, spectra, tile, scratch);
}

/// Upward pass: stores the stress of the layers below; the sums that reach the surface determine the image.
void EigenstrainStress::go_up(const SpectrumRows& rows, const Spectra& spectra, Tile& tile, Scratch& scratch) const
{
  const std::ptrdiff_t pitch = fft_.pitch();
  for (std::ptrdiff_t i = spectra.strained - 1; i >= 0; --i)
    for (std::ptrdiff_t r = 0; r < rows.count; ++r)
    {
      const Factors& f = *tile.factors[static_cast<std::size_t>(r)];
      Wave& up = tile.waves[static_cast<std::size_t>(r)];
      Layer& layer = scratch[static_cast<std::size_t>(i * SpectrumRows::most + r)];
      const Field below = emit(f, up);
      const ComplexLanes* strain = spectra.strain + i * Deviator::size * pitch + rows.first + r;
      if (i > 0)
        for (int c = 1; c <= Deviator::size; ++c)
          fetch_soon(strain - c * pitch); // of the next layer: so far apart that the processor does not expect it
      layer = {green::in_wave_frame<Lanes>(f, nu_, strain[0], strain[pitch], strain[2 * pitch], strain[3 * pitch],
                                           strain[4 * pitch]),
               below.ll, below.zz, below.lz, below.lt};
      advance(f, layer.strain, -1.0, up);
    }
}

/// Downward pass: adds the stress of the image, of the layers above, of those below and of the layer itself, and transforms it to
/// the axes x, y, z.
void EigenstrainStress::go_down(const SpectrumRows& rows, const Spectra& spectra, Tile& tile,
                                const Scratch& scratch) const
{
  const bool past_caches = spectra_bytes_ > cached_bytes;
  const std::ptrdiff_t pitch = fft_.pitch();
  for (std::ptrdiff_t i = 0; i < spectra.layers; ++i)
    for (std::ptrdiff_t r = 0; r < rows.count; ++r)
    {
      const Factors& f = *tile.factors[static_cast<std::size_t>(r)];
      Wave& down = tile.waves[static_cast<std::size_t>(r)];
      Field s = emit(f, down);
      ComplexLanes tz;
      if (i < spectra.strained)
      {
        const Layer& layer = scratch[static_cast<std::size_t>(i * SpectrumRows::most + r)];
        tz = add_own(f, layer, s);
        advance(f, layer.strain, 1.0, down);
      }
      else
      {
        tz = times_i(s.lt);
        s.lz = times_i(s.lz);
        pass(f, down);
      }
      const auto axes = green::in_axes<Lanes>(f, nu_, s.ll, s.zz, s.lz, s.lt, tz);
      ComplexLanes* stress = spectra.stress + i * Deviator::size * pitch + rows.first + r;
      for (int c = 0; !past_caches && i + 1 < spectra.layers && c < Deviator::size; ++c)
        write_soon(stress + (Deviator::size + c) * pitch); // of the next layer
      for (const ComplexLanes& component : {axes.xx, axes.yy, axes.yz, axes.xz, axes.xy})
      {
        store_lanes(component, stress, past_caches);
        stress += pitch;
      }
      if (spectra.trace != nullptr)
        spectra.trace[i * pitch + rows.first + r] = axes.trace;
    }
  end_streaming();
}

} // namespace brinell::halfspace
