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

/// A complex running sum of `width` wavenumbers.
struct Lane
{
  alignas(64) std::array<double, width> re{};
  alignas(64) std::array<double, width> im{};
};

double* row_of(Complex* planes, const PaddedFft& fft, int nz, int component, int layer, int row, int first)
{
  const auto plane = static_cast<std::size_t>(component * nz + layer);
  return reinterpret_cast<double*>(planes + plane * fft.plane() + static_cast<std::size_t>(row * fft.kx() + first));
}

} // namespace

EigenstrainStress::EigenstrainStress(const VolumeGrid& grid, const Elastic& elastic, const PaddedFft& fft)
    : grid_(grid), nu_(elastic.poisson_ratio), mu_(elastic.shear_modulus()), fft_(fft)
{
  const int rows = fft.py() / 2 + 1;
  const auto n = static_cast<std::size_t>(rows * fft.kx());
  for (auto* v : {&factor_.lx, &factor_.ly, &factor_.lx2, &factor_.ly2, &factor_.lxly, &factor_.q, &factor_.e0,
                  &factor_.e1, &factor_.e2, &factor_.e3, &factor_.m0, &factor_.m1, &factor_.m2, &factor_.s0,
                  &factor_.s1, &factor_.x})
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

void EigenstrainStress::apply(Complex* strain_hat, Complex* stress_hat, int layers, Complex* trace_hat) const
{
  const int blocks = (fft_.kx() + width - 1) / width;
#pragma omp parallel for collapse(2) schedule(static)
  for (int row = 0; row < fft_.py(); ++row)
    for (int block = 0; block < blocks; ++block)
      apply_block(row, block * width, std::min(width, fft_.kx() - block * width), strain_hat, stress_hat, layers,
                  trace_hat);
}

/// The factors of one block, copied to full width so that every loop has a constant length.
struct EigenstrainStress::Block
{
  alignas(64) std::array<double, width> lx{}, ly{}, lx2{}, ly2{}, lxly{}, q{}, e0{}, e1{}, e2{}, e3{}, m0{}, m1{}, m2{},
      s0{}, s1{}, x{};

  Block(const Factors& f, std::size_t at, int count, double sign_y)
  {
    const auto copy = [&](const std::vector<double>& from, std::array<double, width>& to, double scale = 1.0)
    {
      for (int i = 0; i < count; ++i)
        to[static_cast<std::size_t>(i)] = scale * from[at + static_cast<std::size_t>(i)];
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
};

void EigenstrainStress::apply_block(int row, int first, int count, Complex* strain_hat, Complex* stress_hat, int layers,
                                    Complex* trace_hat) const
{
  const int folded = std::min(row, fft_.py() - row);
  const Block f(factor_, static_cast<std::size_t>(folded * fft_.kx() + first), count, row > fft_.py() / 2 ? -1.0 : 1.0);
  const auto strain = [&](int component, int layer)
  { return row_of(strain_hat, fft_, grid_.nz, component, layer, row, first); };
  const auto stress = [&](int component, int layer)
  { return row_of(stress_hat, fft_, grid_.nz, component, layer, row, first); };
  const double one_minus_2nu = 1.0 - 2.0 * nu_;

  // Upwards: what the layers below give, kept in `stress`; the strain is rotated to (a, d, lz, lt, tz) on the way.
  Lane u_a;
  Lane u_c;
  Lane u_c1;
  Lane u_w;
  for (int layer = layers - 1; layer >= 0; --layer)
  {
    double* e0 = strain(0, layer);
    double* e1 = strain(1, layer);
    double* e2 = strain(2, layer);
    double* e3 = strain(3, layer);
    double* e4 = strain(4, layer);
    double* o0 = stress(0, layer);
    double* o1 = stress(1, layer);
    double* o2 = stress(2, layer);
    double* o3 = stress(3, layer);
    const auto work = [&](std::size_t i, std::size_t c, std::array<double, width>& a0, std::array<double, width>& c0,
                          std::array<double, width>& c1, std::array<double, width>& w0)
    {
      const double ea = f.e0[i] * a0[i];
      const double ec = f.e0[i] * c0[i];
      const double sc = f.e1[i] * c1[i] - f.e2[i] * c0[i];
      o0[2 * i + c] = ea + 2.0 * ec - sc;
      o1[2 * i + c] = sc - ea;
      o2[2 * i + c] = ea + ec - sc;
      o3[2 * i + c] = f.e3[i] * w0[i];
      c1[i] = f.q[i] * (c1[i] + c0[i]);
      c0[i] *= f.q[i];
      a0[i] *= f.q[i];
      w0[i] *= f.q[i];
    };
#pragma omp simd
    for (int n = 0; n < count; ++n)
    {
      const auto i = static_cast<std::size_t>(n);
      work(i, 0, u_a.re, u_c.re, u_c1.re, u_w.re);
      work(i, 1, u_a.im, u_c.im, u_c1.im, u_w.im);
      std::array<double, 2> d{};
      std::array<double, 2> lz{};
      std::array<double, 2> lt{};
      std::array<double, 2> tz{};
      std::array<double, 2> a{};
      for (std::size_t c = 0; c < 2; ++c)
      {
        const double xx = e0[2 * i + c];
        const double yy = e1[2 * i + c];
        const double yz = e2[2 * i + c];
        const double xz = e3[2 * i + c];
        const double xy = e4[2 * i + c];
        const double ll = f.lx2[i] * xx + f.ly2[i] * yy + 2.0 * f.lxly[i] * xy;
        const double zz = -xx - yy;
        a[c] = one_minus_2nu * (ll + zz);
        d[c] = ll - zz;
        lz[c] = f.lx[i] * xz + f.ly[i] * yz;
        lt[c] = f.lxly[i] * (yy - xx) + (f.lx2[i] - f.ly2[i]) * xy;
        tz[c] = f.lx[i] * yz - f.ly[i] * xz;
        e0[2 * i + c] = a[c];
        e1[2 * i + c] = d[c];
        e2[2 * i + c] = lz[c];
        e3[2 * i + c] = lt[c];
        e4[2 * i + c] = tz[c];
      }
      // c_- = d - 2 i lz, w_- = lt - i tz
      const double c_re = d[0] + 2.0 * lz[1];
      const double c_im = d[1] - 2.0 * lz[0];
      u_a.re[i] += a[0];
      u_a.im[i] += a[1];
      u_c.re[i] += c_re;
      u_c.im[i] += c_im;
      u_c1.re[i] += c_re;
      u_c1.im[i] += c_im;
      u_w.re[i] += lt[0] + tz[1];
      u_w.im[i] += lt[1] - tz[0];
    }
  }

  // The sums have arrived at the surface: amplitudes of the image and of the pressure that frees it.
  Lane image_f;
  Lane image_c;
  Lane image_w;
  const double stiffness = mu_ / (2.0 * (1.0 - nu_));
  const auto amplitude = [&](std::size_t i, double a0, double c0, double c1, double w0, double& out_f, double& out_c,
                             double& out_w)
  {
    const double p = stiffness * f.x[i];
    out_f = p * (f.s0[i] * a0 - f.x[i] * f.s0[i] * (c1 - 0.5 * c0) + f.s1[i] * c0);
    out_c = p * f.s0[i] * c0;
    out_w = mu_ * f.x[i] * f.s0[i] * w0;
  };
  for (std::size_t i = 0; i < width; ++i)
  {
    amplitude(i, u_a.re[i], u_c.re[i], u_c1.re[i], u_w.re[i], image_f.re[i], image_c.re[i], image_w.re[i]);
    amplitude(i, u_a.im[i], u_c.im[i], u_c1.im[i], u_w.im[i], image_f.im[i], image_c.im[i], image_w.im[i]);
  }

  // Downwards: the layers above, the layer itself, the image; back to the axes x, y, z.
  Lane d_a;
  Lane d_c;
  Lane d_c1;
  Lane d_w;
  alignas(64) std::array<double, width> decay{};
  decay.fill(1.0);
  for (int layer = 0; layer < layers; ++layer)
  {
    const double* e0 = strain(0, layer);
    const double* e1 = strain(1, layer);
    const double* e2 = strain(2, layer);
    const double* e3 = strain(3, layer);
    const double* e4 = strain(4, layer);
    double* o0 = stress(0, layer);
    double* o1 = stress(1, layer);
    double* o2 = stress(2, layer);
    double* o3 = stress(3, layer);
    double* o4 = stress(4, layer);
    double* tr = trace_hat == nullptr ? nullptr : row_of(trace_hat, fft_, grid_.nz, 0, layer, row, first);
    const double depth = layer + 0.5;
#pragma omp simd
    for (int n = 0; n < count; ++n)
    {
      const auto i = static_cast<std::size_t>(n);
      const double mean_e = decay[i] * f.s0[i];
      const double mean_z = decay[i] * (depth * f.x[i] * f.s0[i] - f.s1[i]);
      decay[i] *= f.q[i];
      std::array<double, 2> ll{};
      std::array<double, 2> zz{};
      std::array<double, 2> shear{};  // sigma_lz = i * shear + self
      std::array<double, 2> across{}; // sigma_tz = i * across + self
      std::array<double, 2> lt{};
      const auto add = [&](std::size_t c, double a0, double c0, double c1, double w0, double big_f, double big_c,
                           double big_w)
      {
        const double ea = f.e0[i] * a0;
        const double ec = f.e0[i] * c0;
        const double sc = f.e1[i] * c1 - f.e2[i] * c0;
        const double v = big_c + 2.0 * big_f;
        const double w = f.e3[i] * w0 + mean_e * big_w;
        const double a_self = f.m0[i] * e0[2 * i + c];
        const double d_self = e1[2 * i + c];
        ll[c] = o0[2 * i + c] + ea + 2.0 * ec - sc + a_self + (2.0 * f.m0[i] - f.m1[i]) * d_self +
                mean_e * (big_f + v + big_c) - mean_z * v;
        zz[c] = o1[2 * i + c] + sc - ea - a_self + f.m1[i] * d_self + mean_e * big_f + mean_z * v;
        shear[c] = ea + ec - sc - o2[2 * i + c] + mean_e * (big_f + big_c) - mean_z * v;
        across[c] = w - o3[2 * i + c];
        lt[c] = w + o3[2 * i + c] + f.m2[i] * e3[2 * i + c];
      };
      add(0, d_a.re[i], d_c.re[i], d_c1.re[i], d_w.re[i], image_f.re[i], image_c.re[i], image_w.re[i]);
      add(1, d_a.im[i], d_c.im[i], d_c1.im[i], d_w.im[i], image_f.im[i], image_c.im[i], image_w.im[i]);
      const double lz_self = -2.0 * (f.m0[i] - f.m1[i]);
      const std::array<double, 2> lz{lz_self * e2[2 * i] - shear[1], lz_self * e2[2 * i + 1] + shear[0]};
      const std::array<double, 2> tz{-f.m2[i] * e4[2 * i] - across[1], -f.m2[i] * e4[2 * i + 1] + across[0]};
      for (std::size_t c = 0; c < 2; ++c)
      {
        const double tt = nu_ * (ll[c] + zz[c]);
        const double mean = (ll[c] + tt + zz[c]) / 3.0;
        const double dl = ll[c] - mean;
        const double dt = tt - mean;
        o0[2 * i + c] = f.lx2[i] * dl + f.ly2[i] * dt - 2.0 * f.lxly[i] * lt[c];
        o1[2 * i + c] = f.ly2[i] * dl + f.lx2[i] * dt + 2.0 * f.lxly[i] * lt[c];
        o2[2 * i + c] = f.ly[i] * lz[c] + f.lx[i] * tz[c];
        o3[2 * i + c] = f.lx[i] * lz[c] - f.ly[i] * tz[c];
        o4[2 * i + c] = f.lxly[i] * (ll[c] - tt) + (f.lx2[i] - f.ly2[i]) * lt[c];
        if (tr != nullptr)
          tr[2 * i + c] = 3.0 * mean;
      }
      const auto advance = [&](Lane& lane, double re, double im)
      {
        lane.re[i] = f.q[i] * lane.re[i] + re;
        lane.im[i] = f.q[i] * lane.im[i] + im;
      };
      // c_+ = d + 2 i lz, w_+ = lt + i tz
      const double c_re = e1[2 * i] - 2.0 * e2[2 * i + 1];
      const double c_im = e1[2 * i + 1] + 2.0 * e2[2 * i];
      d_c1.re[i] = f.q[i] * (d_c1.re[i] + d_c.re[i]) + c_re;
      d_c1.im[i] = f.q[i] * (d_c1.im[i] + d_c.im[i]) + c_im;
      advance(d_a, e0[2 * i], e0[2 * i + 1]);
      advance(d_c, c_re, c_im);
      advance(d_w, e3[2 * i] - e4[2 * i + 1], e3[2 * i + 1] + e4[2 * i]);
    }
  }
}

} // namespace brinell::halfspace
