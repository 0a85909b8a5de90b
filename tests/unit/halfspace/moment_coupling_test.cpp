// SPDX-License-Identifier: BSD-3-Clause
// Kernels that are polynomials of distances, applied by moments, against the kernels themselves.
#include "halfspace/strain/moment_coupling.hpp"
#include "halfspace/strain/wave_coupling.hpp"

#include "foundation/lane_functions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace brinell::halfspace::moment_coupling_test
{
namespace
{

using images::strains;
using images::stresses;

constexpr int degree = 6;
constexpr int monomials = (degree + 1) * (degree + 2) / 2;
constexpr double x = 0.3, y = -0.4, x_source = -0.2, y_source = 0.45; ///< of a point and of a source

double number()
{
  static std::mt19937 engine(5);
  return std::uniform_real_distribution(-1.0, 1.0)(engine);
}

class Coupling : public testing::TestWithParam<int>
{
protected:
  [[nodiscard]] std::vector<double> random_list(int count) const
  {
    std::vector<double> values(static_cast<std::size_t>(count));
    std::generate(values.begin(), values.end(), number);
    return values;
  }
  [[nodiscard]] Matrix random_matrix() const
  {
    Matrix matrix(depths, depths);
    for (int j = 0; j < depths; ++j)
      std::generate_n(matrix.column(j), depths, number);
    return matrix;
  }
  [[nodiscard]] std::size_t at(int component, int depth, int p) const
  {
    return static_cast<std::size_t>((component * depths + depth) * monomials + p);
  }

  int depths = GetParam();
};

TEST_P(Coupling, OfMonomialsIsTheKernel)
{
  MomentCoupling coupling(depths, degree);
  const std::vector<double> source = random_list(strains * depths);
  std::vector<double> stress(static_cast<std::size_t>(stresses * depths)), moments(at(strains, 0, 0));
  for (int c = 0; c < stresses; ++c)
    for (int e = 0; e < strains; ++e)
      for (int a = 0; a <= degree; ++a)
        for (int b = images::is_odd(images::odd_in_y, c, e) ? 1 : 0; a + b <= degree; b += 2)
        {
          const Matrix value = random_matrix();
          coupling.add(c, e, {a, b}, 0.7, value);
          for (int i = 0; i < depths; ++i)
            for (int j = 0; j < depths; ++j)
              stress[static_cast<std::size_t>(c * depths + i)] += 0.7 * std::pow(x - x_source, a) *
                                                                  std::pow(y - y_source, b) * value(i, j) *
                                                                  source[static_cast<std::size_t>(e * depths + j)];
        }
  for (int e = 0; e < strains; ++e)
    for (int j = 0; j < depths; ++j)
      for (int a = 0; a <= degree; ++a)
        for (int b = 0; a + b <= degree; ++b)
          moments[at(e, j, MomentCoupling::monomial(a, b))] =
              source[static_cast<std::size_t>(e * depths + j)] * std::pow(x_source, a) * std::pow(y_source, b);
  std::vector<double> found(at(stresses, 0, 0));
  MomentCoupling::Work work = coupling.make_work();
  coupling.multiply(moments.data(), false, stresses, work, found.data());
  for (int c = 0; c < stresses; ++c)
    for (int i = 0; i < depths; ++i)
    {
      double sum = 0.0;
      for (int a = 0; a <= degree; ++a)
        for (int b = 0; a + b <= degree; ++b)
          sum += found[at(c, i, MomentCoupling::monomial(a, b))] * std::pow(x, a) * std::pow(y, b);
      EXPECT_NEAR(sum, stress[static_cast<std::size_t>(c * depths + i)], 1e-12) << c << ' ' << i;
    }
}

// Moments of a strain that has the symmetry, alone.
TEST_P(Coupling, KeepsTheSymmetry)
{
  MomentCoupling coupling(depths, degree);
  for (int c = 0; c < stresses; ++c)
    for (int e = 0; e < strains; ++e)
      for (int b = images::is_odd(images::odd_in_y, c, e) ? 1 : 0; b < degree; b += 2)
        coupling.add(c, e, {1, b}, 1.0, random_matrix());
  std::vector<double> moments = random_list(static_cast<int>(at(strains, 0, 0)));
  for (int e = 0; e < strains; ++e)
    for (int j = 0; j < depths; ++j)
      for (int a = 0; a <= degree; ++a)
        for (int b = 0; a + b <= degree; ++b)
          if ((b + images::odd_in_y[static_cast<std::size_t>(e)]) % 2 != 0)
            moments[at(e, j, MomentCoupling::monomial(a, b))] = 0.0;
  std::vector<double> all(at(stresses, 0, 0)), half(all.size());
  MomentCoupling::Work work = coupling.make_work();
  coupling.multiply(moments.data(), false, stresses, work, all.data());
  coupling.multiply(moments.data(), true, stresses, work, half.data());
  EXPECT_EQ(half, all);
  EXPECT_GT(*std::max_element(all.begin(), all.end()), 0.1);
}

TEST_P(Coupling, OfWavesIsTheKernel)
{
  constexpr int waves = 11, powers = degree + 1;
  WaveCoupling coupling(waves, depths, degree, images::odd_in_y);
  ASSERT_EQ(coupling.parts(), (waves + lane_count - 1) / lane_count);
  const std::vector<double> source = random_list(waves * strains * depths);
  std::vector<double> stress(static_cast<std::size_t>(waves * stresses * depths));
  const auto of_wave = [&](int wave, int components, int c, int i)
  { return static_cast<std::size_t>((wave * components + c) * depths + i); };
  for (int wave = 0; wave < waves; ++wave)
    for (int c = 0; c < stresses; ++c)
      for (int e = 0; e < strains; ++e)
        for (int b = images::is_odd(images::odd_in_y, c, e) ? 1 : 0; b <= degree; b += 2)
        {
          const Matrix value = random_matrix();
          coupling.set(wave, c, e, b, 0.7, value);
          for (int i = 0; i < depths; ++i)
            for (int j = 0; j < depths; ++j)
              stress[of_wave(wave, stresses, c, i)] +=
                  0.7 * std::pow(y - y_source, b) * value(i, j) * source[of_wave(wave, strains, e, j)];
        }
  const auto place = [&](int component, int power, int depth)
  { return static_cast<std::size_t>((component * powers + power) * depths + depth); };
  for (int wave = 0; wave < waves; ++wave)
  {
    const std::size_t lane = static_cast<std::size_t>(wave % lane_count);
    AlignedVector<ComplexLanes> in(place(strains, 0, 0)), out(place(stresses, 0, 0));
    for (int e = 0; e < strains; ++e)
      for (int b = 0; b < powers; ++b)
        for (int j = 0; j < depths; ++j)
        {
          const double moment =
              WaveCoupling::of_strain(b) * std::pow(y_source, b) * source[of_wave(wave, strains, e, j)];
          in[place(e, b, j)].re[lane] = moment;
          in[place(e, b, j)].im[lane] = 2.0 * moment;
        }
    coupling.multiply(wave / lane_count, in.data(), false, stresses, out.data());
    for (int c = 0; c < stresses; ++c)
      for (int i = 0; i < depths; ++i)
      {
        double re = 0.0, im = 0.0;
        for (int b = 0; b < powers; ++b)
        {
          const ComplexLanes& moment = out[place(c, b, i)];
          re += WaveCoupling::of_stress(b) * std::pow(y, b) * moment.re[lane];
          im += WaveCoupling::of_stress(b) * std::pow(y, b) * moment.im[lane];
        }
        EXPECT_NEAR(re, stress[of_wave(wave, stresses, c, i)], 1e-12) << wave << ' ' << c << ' ' << i;
        EXPECT_NEAR(im, 2.0 * re, 1e-12);
      }
  }
}

// One, two lanes of depths; those for which the products are written out, and others.
INSTANTIATE_TEST_SUITE_P(Depths, Coupling, testing::Values(5, 6, 7, 8, 9, 16));

} // namespace
} // namespace brinell::halfspace::moment_coupling_test
