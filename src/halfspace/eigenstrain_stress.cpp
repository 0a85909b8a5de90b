// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/eigenstrain_stress.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace brinell::halfspace
{

namespace
{

constexpr int width = 16; ///< wavenumbers worked on together: their running sums stay in registers and L1

/// Values of `width` wavenumbers, real and imaginary parts apart: every loop below has this length and no branches, so
/// that it becomes vector instructions.
using Row = std::array<double, width>;
struct Lane
{
  alignas(64) Row re{};
  alignas(64) Row im{};
};

/// Amplitudes of the waves that travel one way, each a running sum over the layers passed.
struct Wave
{
  Lane a, c, c1, w; ///< sum of a, of c, of c times the number of layers passed, and of w
};

/// Plastic strain of one layer in the frame of the wavevector.
struct Source
{
  Lane a, d, lz, lt, tz; ///< (1 - 2 nu)(ll + zz), ll - zz, and the shears
};

/// Stress in the frame of the wavevector; lz and tz without the factor +-i of the direction of travel.
struct Field
{
  Lane ll, zz, lz, lt;
};

void gather(const double* from, int count, Lane& to)
{
  if (count == width) // the usual case, with a constant length
  {
#pragma omp simd
    for (std::size_t i = 0; i < width; ++i)
    {
      to.re[i] = from[2 * i];
      to.im[i] = from[2 * i + 1];
    }
    return;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
  {
    to.re[i] = from[2 * i];
    to.im[i] = from[2 * i + 1];
  }
}

void scatter(const Lane& from, int count, double* to)
{
  if (count == width)
  {
#pragma omp simd
    for (std::size_t i = 0; i < width; ++i)
    {
      to[2 * i] = from.re[i];
      to[2 * i + 1] = from.im[i];
    }
    return;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
  {
    to[2 * i] = from.re[i];
    to[2 * i + 1] = from.im[i];
  }
}

} // namespace

EigenstrainStress::EigenstrainStress(const VolumeGrid& grid, const Elastic& elastic, const PaddedFft& fft)
    : grid_(grid), nu_(elastic.poisson_ratio), mu_(elastic.shear_modulus()), fft_(fft)
{
  const int rows = fft.py() / 2 + 1;
  const auto n = static_cast<std::size_t>(rows * fft.kx());
  for (auto* v :
       {&factor_.lx, &factor_.ly, &factor_.lx2, &factor_.ly2, &factor_.lxly, &factor_.q, &factor_.e0, &factor_.e1,
        &factor_.e2, &factor_.e3, &factor_.m0, &factor_.m1, &factor_.m2, &factor_.s0, &factor_.s1, &factor_.x})
    v->assign(n, 0.0);
  const double stiffness = mu_ / (2.0 * (1.0 - nu_));
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < fft.kx(); ++i)
    {
      const auto j = static_cast<std::size_t>(row * fft.kx() + i);
      const double m = fft.wavenumber_x(i);
      const double n_y = fft.wavenumber_y(row);
      const double k = std::hypot(m, n_y);
      if (k == 0.0)
      {
        factor_.lx2[j] = 1.0; // any direction: every non-local factor is zero
        factor_.q[j] = 1.0;
        continue;
      }
      const bool nyquist_x = 2 * i == fft.px();
      const bool nyquist_y = 2 * row == fft.py();
      factor_.lx2[j] = m * m / (k * k);
      factor_.ly2[j] = n_y * n_y / (k * k);
      factor_.lx[j] = nyquist_x ? 0.0 : m / k;
      factor_.ly[j] = nyquist_y ? 0.0 : n_y / k;
      factor_.lxly[j] = factor_.lx[j] * factor_.ly[j];
      const double x = k * grid.dz;
      const double q = std::exp(-x);
      const double s0 = -std::expm1(-x) / x;
      const double g0 = s0 * s0;
      const double g1 = -std::expm1(-2.0 * x) / (2.0 * x) - g0;
      factor_.x[j] = x;
      factor_.q[j] = q;
      factor_.s0[j] = s0;
      factor_.s1[j] = 0.5 * (1.0 + q) - s0;
      factor_.e0[j] = stiffness * x * g0;
      factor_.e1[j] = stiffness * x * x * g0;
      factor_.e2[j] = 2.0 * stiffness * x * g1;
      factor_.e3[j] = mu_ * x * g0;
      factor_.m0[j] = stiffness * 2.0 * (1.0 - s0);
      factor_.m1[j] = -stiffness * 2.0 * (x * s0 - 2.0 * (1.0 - s0));
      factor_.m2[j] = mu_ * 2.0 * (1.0 - s0);
    }
}

Deviator EigenstrainStress::local_stress(const Deviator& strain) const
{
  const double f = -2.0 * mu_ / (1.0 - nu_);
  const double xx = f * (strain[Deviator::xx] + nu_ * strain[Deviator::yy]);
  const double yy = f * (strain[Deviator::yy] + nu_ * strain[Deviator::xx]);
  const double mean = (xx + yy) / 3.0;
  return {{xx - mean, yy - mean, 0.0, 0.0, -2.0 * mu_ * strain[Deviator::xy]}};
}

double EigenstrainStress::local_trace(const Deviator& strain) const
{
  return -2.0 * mu_ * (1.0 + nu_) / (1.0 - nu_) * (strain[Deviator::xx] + strain[Deviator::yy]);
}

/// The factors of one block, copied to full width so that every loop has a constant length.
struct EigenstrainStress::Block
{
  alignas(64) Row lx{}, ly{}, lx2{}, ly2{}, lxly{}, q{}, e0{}, e1{}, e2{}, e3{}, m0{}, m1{}, m2{}, s0{}, s1{}, x{};

  Block(const Factors& f, std::size_t at, int count, double sign_y)
  {
    const auto copy = [&](const std::vector<double>& from, Row& to, double scale = 1.0)
    {
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        to[i] = scale * from[at + i];
    };
    copy(f.lx, lx);
    copy(f.ly, ly, sign_y);
    copy(f.lx2, lx2);
    copy(f.ly2, ly2);
    copy(f.lxly, lxly, sign_y);
    copy(f.q, q);
    copy(f.e0, e0);
    copy(f.e1, e1);
    copy(f.e2, e2);
    copy(f.e3, e3);
    copy(f.m0, m0);
    copy(f.m1, m1);
    copy(f.m2, m2);
    copy(f.s0, s0);
    copy(f.s1, s1);
    copy(f.x, x);
  }

  /// Strain from the axes x, y, z to the frame of the wavevector.
  void rotate(const std::array<Lane, Deviator::size>& e, double one_minus_2nu, Source& out) const
  {
    const auto part = [&](const Row& xx, const Row& yy, const Row& yz, const Row& xz, const Row& xy, Row& a, Row& d,
                          Row& lz, Row& lt, Row& tz)
    {
#pragma omp simd
      for (std::size_t i = 0; i < width; ++i)
      {
        const double ll = lx2[i] * xx[i] + ly2[i] * yy[i] + 2.0 * lxly[i] * xy[i];
        const double zz = -xx[i] - yy[i];
        a[i] = one_minus_2nu * (ll + zz);
        d[i] = ll - zz;
        lz[i] = lx[i] * xz[i] + ly[i] * yz[i];
        lt[i] = lxly[i] * (yy[i] - xx[i]) + (lx2[i] - ly2[i]) * xy[i];
        tz[i] = lx[i] * yz[i] - ly[i] * xz[i];
      }
    };
    part(e[0].re, e[1].re, e[2].re, e[3].re, e[4].re, out.a.re, out.d.re, out.lz.re, out.lt.re, out.tz.re);
    part(e[0].im, e[1].im, e[2].im, e[3].im, e[4].im, out.a.im, out.d.im, out.lz.im, out.lt.im, out.tz.im);
  }

  /// Mean stress in the next layer of the waves that arrive there.
  void emit(const Wave& wave, Field& out) const
  {
    const auto part = [&](const Row& a, const Row& c, const Row& c1, const Row& w, Row& ll, Row& zz, Row& lz, Row& lt)
    {
#pragma omp simd
      for (std::size_t i = 0; i < width; ++i)
      {
        const double ea = e0[i] * a[i];
        const double ec = e0[i] * c[i];
        const double sc = e1[i] * c1[i] - e2[i] * c[i];
        ll[i] = ea + 2.0 * ec - sc;
        zz[i] = sc - ea;
        lz[i] = ea + ec - sc;
        lt[i] = e3[i] * w[i];
      }
    };
    part(wave.a.re, wave.c.re, wave.c1.re, wave.w.re, out.ll.re, out.zz.re, out.lz.re, out.lt.re);
    part(wave.a.im, wave.c.im, wave.c1.im, wave.w.im, out.ll.im, out.zz.im, out.lz.im, out.lt.im);
  }

  /// The waves pass one layer and take up its strain; g = +1 downwards, -1 upwards.
  void advance(Wave& wave, const Source& s, double g) const
  {
    // c = d + 2 i g lz and w = lt + i g tz: the imaginary part of the shear goes to the real part and back.
    const auto part = [&](Row& a, Row& c, Row& c1, Row& w, const Row& source_a, const Row& d, const Row& lz,
                          const Row& lt, const Row& tz, double sign)
    {
#pragma omp simd
      for (std::size_t i = 0; i < width; ++i)
      {
        const double source_c = d[i] + 2.0 * sign * lz[i];
        c1[i] = q[i] * (c1[i] + c[i]) + source_c;
        c[i] = q[i] * c[i] + source_c;
        a[i] = q[i] * a[i] + source_a[i];
        w[i] = q[i] * w[i] + lt[i] + sign * tz[i];
      }
    };
    part(wave.a.re, wave.c.re, wave.c1.re, wave.w.re, s.a.re, s.d.re, s.lz.im, s.lt.re, s.tz.im, -g);
    part(wave.a.im, wave.c.im, wave.c1.im, wave.w.im, s.a.im, s.d.im, s.lz.re, s.lt.im, s.tz.re, g);
  }

  /// Amplitudes F, C and W of the image (times the stiffness) from the waves that have arrived at the surface.
  void image(const Wave& wave, double stiffness, double mu, Lane& f, Lane& c, Lane& w) const
  {
    const auto part =
        [&](const Row& a0, const Row& c0, const Row& c1, const Row& w0, Row& out_f, Row& out_c, Row& out_w)
    {
      for (std::size_t i = 0; i < width; ++i)
      {
        const double p = stiffness * x[i];
        out_f[i] = p * (s0[i] * a0[i] - x[i] * s0[i] * (c1[i] - 0.5 * c0[i]) + s1[i] * c0[i]);
        out_c[i] = p * s0[i] * c0[i];
        out_w[i] = mu * x[i] * s0[i] * w0[i];
      }
    };
    part(wave.a.re, wave.c.re, wave.c1.re, wave.w.re, f.re, c.re, w.re);
    part(wave.a.im, wave.c.im, wave.c1.im, wave.w.im, f.im, c.im, w.im);
  }

  /// Adds to the field of the waves from above (`down`) that from below (`up`), of the layer itself and of the image.
  /// @param mean_e, mean_z  means of e^{-kz} and k z e^{-kz} over the layer.
  /// @param out  ll, zz, lz, lt, tz with their factors i applied.
  void assemble(const Field& down, const Field& up, const Source& s, const Lane& f, const Lane& c, const Lane& w,
                const Row& mean_e, const Row& mean_z, std::array<Lane, Deviator::size>& out) const
  {
    const auto normal = [&](const Row& d_ll, const Row& u_ll, const Row& d_zz, const Row& u_zz, const Row& d_lt,
                            const Row& u_lt, const Row& a, const Row& d, const Row& lt, const Row& big_f,
                            const Row& big_c, const Row& big_w, Row& ll, Row& zz, Row& out_lt)
    {
#pragma omp simd
      for (std::size_t i = 0; i < width; ++i)
      {
        const double v = big_c[i] + 2.0 * big_f[i];
        ll[i] = d_ll[i] + u_ll[i] + m0[i] * a[i] + (2.0 * m0[i] - m1[i]) * d[i] +
                mean_e[i] * (big_f[i] + v + big_c[i]) - mean_z[i] * v;
        zz[i] = d_zz[i] + u_zz[i] - m0[i] * a[i] + m1[i] * d[i] + mean_e[i] * big_f[i] + mean_z[i] * v;
        out_lt[i] = d_lt[i] + u_lt[i] + m2[i] * lt[i] + mean_e[i] * big_w[i];
      }
    };
    normal(down.ll.re, up.ll.re, down.zz.re, up.zz.re, down.lt.re, up.lt.re, s.a.re, s.d.re, s.lt.re, f.re, c.re, w.re,
           out[0].re, out[1].re, out[3].re);
    normal(down.ll.im, up.ll.im, down.zz.im, up.zz.im, down.lt.im, up.lt.im, s.a.im, s.d.im, s.lt.im, f.im, c.im, w.im,
           out[0].im, out[1].im, out[3].im);
    // sigma_lz = i (...) + self: `sign` is that of i times the other part.
    const auto shear = [&](const Row& d_lz, const Row& u_lz, const Row& d_lt, const Row& u_lt, const Row& big_f,
                           const Row& big_c, const Row& big_w, const Row& lz, const Row& tz, double sign, Row& out_lz,
                           Row& out_tz)
    {
#pragma omp simd
      for (std::size_t i = 0; i < width; ++i)
      {
        const double v = big_c[i] + 2.0 * big_f[i];
        const double l = d_lz[i] - u_lz[i] + mean_e[i] * (big_f[i] + big_c[i]) - mean_z[i] * v;
        const double t = d_lt[i] - u_lt[i] + mean_e[i] * big_w[i];
        out_lz[i] = sign * l - 2.0 * (m0[i] - m1[i]) * lz[i];
        out_tz[i] = sign * t - m2[i] * tz[i];
      }
    };
    shear(down.lz.im, up.lz.im, down.lt.im, up.lt.im, f.im, c.im, w.im, s.lz.re, s.tz.re, -1.0, out[2].re, out[4].re);
    shear(down.lz.re, up.lz.re, down.lt.re, up.lt.re, f.re, c.re, w.re, s.lz.im, s.tz.im, 1.0, out[2].im, out[4].im);
  }

  /// (ll, zz, lz, lt, tz) to the deviator in the axes x, y, z, in place; the trace besides.
  void rotate_back(double nu, std::array<Lane, Deviator::size>& stress, Lane& trace) const
  {
    const auto part = [&](Row& s0_, Row& s1_, Row& s2_, Row& s3_, Row& s4_, Row& tr)
    {
#pragma omp simd
      for (std::size_t i = 0; i < width; ++i)
      {
        const double ll = s0_[i];
        const double zz = s1_[i];
        const double lz = s2_[i];
        const double lt = s3_[i];
        const double tz = s4_[i];
        const double tt = nu * (ll + zz); // plane strain across the wavevector
        const double mean = (ll + tt + zz) / 3.0;
        s0_[i] = lx2[i] * (ll - mean) + ly2[i] * (tt - mean) - 2.0 * lxly[i] * lt;
        s1_[i] = ly2[i] * (ll - mean) + lx2[i] * (tt - mean) + 2.0 * lxly[i] * lt;
        s2_[i] = ly[i] * lz + lx[i] * tz;
        s3_[i] = lx[i] * lz - ly[i] * tz;
        s4_[i] = lxly[i] * (ll - tt) + (lx2[i] - ly2[i]) * lt;
        tr[i] = 3.0 * mean;
      }
    };
    part(stress[0].re, stress[1].re, stress[2].re, stress[3].re, stress[4].re, trace.re);
    part(stress[0].im, stress[1].im, stress[2].im, stress[3].im, stress[4].im, trace.im);
  }
};

void EigenstrainStress::apply(const Complex* strain_hat, Complex* stress_hat, int layers, Complex* trace_hat) const
{
  const int blocks = (fft_.kx() + width - 1) / width;
#pragma omp parallel for collapse(2) schedule(static)
  for (int row = 0; row < fft_.py(); ++row)
    for (int block = 0; block < blocks; ++block)
      apply_block(row, block * width, std::min(width, fft_.kx() - block * width), strain_hat, stress_hat, layers,
                  trace_hat);
}

void EigenstrainStress::apply_block(int row, int first, int count, const Complex* strain_hat, Complex* stress_hat,
                                    int layers, Complex* trace_hat) const
{
  const int folded = std::min(row, fft_.py() - row);
  const Block f(factor_, static_cast<std::size_t>(folded * fft_.kx() + first), count, row > fft_.py() / 2 ? -1.0 : 1.0);
  const auto in_plane = static_cast<std::size_t>(row * fft_.kx() + first);
  const auto offset = [&](int component, int layer)
  { return static_cast<std::size_t>(component * grid_.nz + layer) * fft_.plane() + in_plane; };
  const auto stress = [&](int component, int layer)
  { return reinterpret_cast<double*>(stress_hat + offset(component, layer)); };
  std::array<Lane, Deviator::size> block{};
  Source source;
  const auto load_source = [&](int layer)
  {
    for (int c = 0; c < Deviator::size; ++c)
      gather(reinterpret_cast<const double*>(strain_hat + offset(c, layer)), count, block[static_cast<std::size_t>(c)]);
    f.rotate(block, 1.0 - 2.0 * nu_, source);
  };

  // Upwards: what the layers below give is parked in `stress`; the sums that reach the surface make the image.
  Wave up;
  Field field;
  for (int layer = layers - 1; layer >= 0; --layer)
  {
    f.emit(up, field);
    scatter(field.ll, count, stress(0, layer));
    scatter(field.zz, count, stress(1, layer));
    scatter(field.lz, count, stress(2, layer));
    scatter(field.lt, count, stress(3, layer));
    load_source(layer);
    f.advance(up, source, -1.0);
  }
  Lane image_f;
  Lane image_c;
  Lane image_w;
  f.image(up, mu_ / (2.0 * (1.0 - nu_)), mu_, image_f, image_c, image_w);

  // Downwards: the layers above, the layer itself, the image; then back to the axes x, y, z.
  Wave down;
  Field from_above;
  Lane trace;
  alignas(64) Row decay;
  alignas(64) Row mean_e{};
  alignas(64) Row mean_z{};
  decay.fill(1.0);
  for (int layer = 0; layer < layers; ++layer)
  {
    const double depth = layer + 0.5;
    for (std::size_t i = 0; i < width; ++i)
    {
      mean_e[i] = decay[i] * f.s0[i];
      mean_z[i] = decay[i] * (depth * f.x[i] * f.s0[i] - f.s1[i]);
      decay[i] *= f.q[i];
    }
    gather(stress(0, layer), count, field.ll);
    gather(stress(1, layer), count, field.zz);
    gather(stress(2, layer), count, field.lz);
    gather(stress(3, layer), count, field.lt);
    f.emit(down, from_above);
    load_source(layer);
    f.assemble(from_above, field, source, image_f, image_c, image_w, mean_e, mean_z, block);
    f.advance(down, source, 1.0);
    f.rotate_back(nu_, block, trace);
    for (int c = 0; c < Deviator::size; ++c)
      scatter(block[static_cast<std::size_t>(c)], count, stress(c, layer));
    if (trace_hat != nullptr)
      scatter(trace, count, reinterpret_cast<double*>(trace_hat + offset(0, layer)));
  }
}

} // namespace brinell::halfspace
