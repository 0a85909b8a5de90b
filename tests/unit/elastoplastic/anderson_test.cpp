// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/anderson.hpp"

#include "random_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace brinell::elastoplastic::anderson_test
{
namespace
{

/// g(x) = M x + b with a random contraction M, and its fixed point by plain iteration.
struct Affine
{
  explicit Affine(std::size_t n, unsigned seed = 1)
      : matrix(test::random_field(n * n, seed)), shift(test::random_field(n, seed + 1))
  {
    for (double& m : matrix)
      m *= 0.9 / static_cast<double>(n); // rows sum to less than one
    for (int i = 0; i < 2000; ++i)
      solution = i == 0 ? shift : (*this)(solution);
  }
  std::vector<double> operator()(const std::vector<double>& x) const
  {
    std::vector<double> g = shift;
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = 0; j < x.size(); ++j)
        g[i] += matrix[i * x.size() + j] * x[j];
    return g;
  }
  std::vector<double> matrix, shift, solution;
};

/// By least squares.
void advance(Anderson& anderson, std::vector<double>& x, const std::vector<double>& g)
{
  std::vector<double> residual = g;
  for (std::size_t i = 0; i < x.size(); ++i)
    residual[i] -= x[i];
  anderson.advance(x, g, residual);
}

double distance(const std::vector<double>& a, const std::vector<double>& b)
{
  double d = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    d = std::max(d, std::abs(a[i] - b[i]));
  return d;
}

// g(x) = x/2 + s, where s changes from 1 to 2 after the first evaluation, as by an unknown that is not in x: the difference of both evaluations says that g
// rises by just as much as x, and no step at all would follow. The history is given up instead.
TEST(AndersonTest, DoesNotStandStillWhereTheMapChangesUnseen)
{
  Anderson anderson(3);
  anderson.give_up_where_still();
  std::vector<double> x{0.0};
  advance(anderson, x, {1.0});
  EXPECT_EQ(x[0], 1.0);
  advance(anderson, x, {0.5 * x[0] + 1.5}); // g(1) - g(0) = 1
  for (int i = 0; i < 4; ++i)
    advance(anderson, x, {0.5 * x[0] + 1.5});
  EXPECT_NEAR(x[0], 3.0, 1e-12);
}

TEST(AndersonTest, KeepsWhatItHasLearntWhenTheMapChanges)
{
  // Another constant part has the same differences: with all of them known, one evaluation tells the new solution. The difference
  // between evaluations of both maps is none of them.
  constexpr std::size_t n = 4;
  const Affine g(n);
  Affine other = g;
  for (std::size_t i = 0; i < n; ++i)
    other.shift[i] += 1e-3 * static_cast<double>(i + 1);
  for (int i = 0; i < 2000; ++i)
    other.solution = i == 0 ? other.shift : other(other.solution);
  const auto distance_after = [&](bool is_told)
  {
    Anderson anderson(static_cast<int>(n));
    std::vector<double> x(n, 0.0);
    for (std::size_t step = 0; step < n + 1; ++step)
      advance(anderson, x, g(x));
    if (is_told)
      anderson.change_map();
    advance(anderson, x, other(x));
    return distance(x, other.solution);
  };
  EXPECT_LT(distance_after(true), 1e-8);
  EXPECT_GT(distance_after(false), 1e-5);
}

TEST(AndersonTest, SolvesALinearProblemOfNUnknownsInNPlusOneSteps)
{
  // With n differences the residual is zero in a combination of them, whatever the matrix; to the normal equations'
  // damping of 1e-12 times their condition.
  for (const std::size_t n : {1, 3, 6})
  {
    const Affine g(n);
    Anderson anderson(static_cast<int>(n));
    std::vector<double> x(n, 0.0);
    for (std::size_t step = 0; step < n + 1; ++step)
      advance(anderson, x, g(x));
    EXPECT_LT(distance(x, g.solution), 1e-8) << n;
  }
}

TEST(AndersonTest, DeepenedKeepsWhatItKnows)
{
  // The next iterate is that of the history before, whether its ring had been filled several times or not.
  constexpr std::size_t n = 8;
  constexpr double damping = 1e-12;
  const Affine g(n);
  for (const std::size_t steps : {1, 2, 3, 4, 5, 6})
  {
    Anderson shallow(3);
    std::vector<double> x(n, 0.0);
    for (std::size_t step = 0; step < steps; ++step)
      advance(shallow, x, g(x));
    Anderson deeper = shallow;
    deeper.deepen(static_cast<int>(n), damping);
    // A changed map adds no difference, so that both know the same ones.
    shallow.change_map();
    deeper.change_map();
    std::vector<double> y = x;
    advance(shallow, x, g(x));
    advance(deeper, y, g(y));
    EXPECT_LT(distance(x, y), 1e-12) << steps;
  }
}

TEST(AndersonTest, DeepenedSolvesWhatAShallowHistoryDoesNot)
{
  constexpr std::size_t n = 8;
  constexpr double damping = 1e-12;
  const Affine g(n);
  const auto distance_after = [&](bool deepens)
  {
    Anderson anderson(2);
    std::vector<double> x(n, 0.0);
    for (std::size_t step = 0; step < n + 3; ++step)
    {
      if (deepens && step == 3)
        anderson.deepen(static_cast<int>(n), damping);
      advance(anderson, x, g(x));
    }
    return distance(x, g.solution);
  };
  EXPECT_LT(distance_after(true), 0.1 * distance_after(false));
}

TEST(AndersonTest, WithoutDepthIsThePlainIteration)
{
  const Affine g(4);
  Anderson anderson(0);
  std::vector<double> x(4, 0.5);
  for (int step = 0; step < 3; ++step)
  {
    const std::vector<double> image = g(x);
    advance(anderson, x, image);
    EXPECT_EQ(x, image);
  }
}

TEST(AndersonTest, FirstStepAndFirstStepAfterAResetArePlain)
{
  const Affine g(4);
  Anderson anderson(3);
  std::vector<double> x(4, 0.5);
  for (int step = 0; step < 5; ++step)
  {
    const std::vector<double> image = g(x);
    advance(anderson, x, image);
    EXPECT_EQ(x == image, step == 0);
  }
  anderson.reset();
  const std::vector<double> image = g(x);
  advance(anderson, x, image);
  EXPECT_EQ(x, image);
}

TEST(AndersonTest, ShallowHistoryStillConvergesFasterThanNone)
{
  // A slow symmetric contraction, like the soft directions of plastic flow: eigenvalues 0.98 cos(...) on a chain.
  constexpr std::size_t n = 12;
  Affine g(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      g.matrix[i * n + j] = i == j + 1 || j == i + 1 ? 0.49 : 0.0;
  for (int i = 0; i < 2000; ++i)
    g.solution = g(g.solution);
  const auto error_after = [&](int depth, int steps)
  {
    Anderson anderson(depth);
    std::vector<double> x(n, 0.0);
    for (int step = 0; step < steps; ++step)
      advance(anderson, x, g(x));
    return distance(x, g.solution);
  };
  EXPECT_LT(error_after(4, 20), 0.1 * error_after(0, 20));
}

TEST(AndersonTest, ConvergesWhenUnknownsComeInLater)
{
  const std::size_t few = 3, all = 6;
  const Affine g(all);
  Anderson anderson(static_cast<int>(all));
  std::vector<double> x(few, 0.0);
  for (std::size_t step = 0; step < 2; ++step)
  {
    std::vector<double> padded = x;
    padded.resize(all, 0.0);
    std::vector<double> image = g(padded);
    image.resize(few);
    advance(anderson, x, image);
  }
  x.resize(all, 0.0);
  // The first of the old differences do not know the new unknowns; they leave the ring after `depth` more.
  for (std::size_t step = 0; step < 2 * all + 4; ++step)
    advance(anderson, x, g(x));
  EXPECT_LT(distance(x, g.solution), 1e-8);
}

TEST(AndersonTest, ParallelDifferencesDoNoHarm)
{
  // One direction only: after two steps every further difference repeats it, down to zero.
  Anderson anderson(5);
  std::vector<double> x{0.0, 0.0};
  for (int step = 0; step < 12; ++step)
  {
    const std::vector<double> image{0.5 * x[0] + 1.0, 0.5 * x[1] + 1.0};
    advance(anderson, x, image);
    ASSERT_TRUE(std::isfinite(x[0]) && std::isfinite(x[1])) << step;
  }
  EXPECT_NEAR(x[0], 2.0, 1e-10);
}

/// With f = b - A x, minus the gradient of an energy by y = x, each advance adds the residual to the next iterate of conjugate
/// gradients (Hestenes, Stiefel 1952), which is computed here by its own recurrence.
TEST(AndersonTest, OrthogonalToTheDifferencesOfYItIsConjugateGradients)
{
  constexpr std::size_t n = 9;
  const std::vector<double> b = test::random_field(n, 5);
  const auto times_a = [&](const std::vector<double>& v) // tridiagonal, eigenvalues between 0.02 and 1.98
  {
    std::vector<double> result(n);
    for (std::size_t i = 0; i < n; ++i)
      result[i] = v[i] - 0.49 * ((i > 0 ? v[i - 1] : 0.0) + (i + 1 < n ? v[i + 1] : 0.0));
    return result;
  };
  const auto dot = [](const std::vector<double>& a, const std::vector<double>& c)
  { return std::inner_product(a.begin(), a.end(), c.begin(), 0.0); };
  Anderson anderson(static_cast<int>(n));
  std::vector<double> x(n, 0.0), cg(n, 0.0), r = b, p = b;
  for (int step = 0; step < 6; ++step)
  {
    std::vector<double> g = x;
    const std::vector<double> ax = times_a(x);
    for (std::size_t i = 0; i < n; ++i)
      g[i] += b[i] - ax[i];
    const std::vector<double> y = x;
    anderson.advance(x, g, y);
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_NEAR(x[i], cg[i] + r[i], 1e-9) << step;
    const std::vector<double> ap = times_a(p);
    const double before = dot(r, r), length = before / dot(p, ap);
    for (std::size_t i = 0; i < n; ++i)
    {
      cg[i] += length * p[i];
      r[i] -= length * ap[i];
    }
    const double kept = dot(r, r) / before;
    for (std::size_t i = 0; i < n; ++i)
      p[i] = r[i] + kept * p[i];
  }
}

/// Likewise where x goes further in some unknowns: the residual is that of g, so it is preconditioned conjugate gradients.
TEST(AndersonTest, GoingFurtherPreconditionsConjugateGradients)
{
  constexpr std::size_t n = 9;
  const std::vector<double> b = test::random_field(n, 5);
  const auto times_a = [&](const std::vector<double>& v) // tridiagonal, and soft in the unknowns of odd number
  {
    const auto scale = [](std::size_t i) { return i % 2 == 1 ? 0.3 : 1.0; };
    std::vector<double> result(n);
    for (std::size_t i = 0; i < n; ++i)
    {
      const double beside = (i > 0 ? scale(i - 1) * v[i - 1] : 0.0) + (i + 1 < n ? scale(i + 1) * v[i + 1] : 0.0);
      result[i] = scale(i) * (scale(i) * v[i] - 0.49 * beside);
    }
    return result;
  };
  const auto further = [](std::size_t i) { return i % 2 == 1 ? 1.0 / 0.09 : 1.0; };
  const auto dot = [](const std::vector<double>& a, const std::vector<double>& c)
  { return std::inner_product(a.begin(), a.end(), c.begin(), 0.0); };
  Anderson anderson(static_cast<int>(n));
  std::vector<double> x(n, 0.0), cg(n, 0.0), r = b, z(n), p;
  for (std::size_t i = 0; i < n; ++i)
    z[i] = further(i) * r[i];
  p = z;
  for (int step = 0; step < 6; ++step)
  {
    std::vector<double> g = x;
    const std::vector<double> ax = times_a(x);
    for (std::size_t i = 0; i < n; ++i)
      g[i] += b[i] - ax[i];
    const std::vector<double> y = x;
    anderson.advance(x, g, y);
    const std::vector<double> residual = anderson.residual();
    for (std::size_t i = 0; i < n; ++i)
      x[i] += (further(i) - 1.0) * residual[i];
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_NEAR(x[i], cg[i] + z[i], 1e-8) << step;
    const std::vector<double> ap = times_a(p);
    const double before = dot(r, z), length = before / dot(p, ap);
    for (std::size_t i = 0; i < n; ++i)
    {
      cg[i] += length * p[i];
      r[i] -= length * ap[i];
      z[i] = further(i) * r[i];
    }
    const double ratio = dot(r, z) / before;
    for (std::size_t i = 0; i < n; ++i)
      p[i] = z[i] + ratio * p[i];
  }
}

/// An unknown of weight two does what two alike would.
TEST(AndersonTest, WeightsStandForCopies)
{
  const std::size_t few = 4, alike = 2; // the first ones have copies
  const Affine g(few);
  Anderson with_weights(3), with_copies(3);
  std::vector<double> x(few, 0.0), y(few + alike, 0.0);
  const std::vector<double> weights{2.0, 2.0, 1.0, 1.0};
  for (int step = 0; step < 6; ++step)
  {
    const std::vector<double> of_x = g(x);
    std::vector<double> weighted(few);
    for (std::size_t i = 0; i < few; ++i)
      weighted[i] = weights[i] * (of_x[i] - x[i]);
    with_weights.advance(x, of_x, weighted);
    std::vector<double> image = g(std::vector<double>(y.begin(), y.begin() + few));
    image.insert(image.end(), image.begin(), image.begin() + alike);
    advance(with_copies, y, image);
    for (std::size_t i = 0; i < y.size(); ++i)
      EXPECT_NEAR(y[i], x[i % few], 1e-9 * (1.0 + std::abs(x[i % few]))) << step;
  }
  Anderson without(3);
  std::vector<double> z(few, 0.0);
  for (int step = 0; step < 6; ++step)
    advance(without, z, g(z));
  EXPECT_GT(std::abs(z[0] - x[0]), 1e-6) << "the weights change nothing";
}

} // namespace
} // namespace brinell::elastoplastic::anderson_test
