// SPDX-License-Identifier: BSD-3-Clause
#include "fatigue_lanes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace brinell::constitutive
{

namespace
{

using Criterion = Fatigue::Criterion;
using Stress = LaneCycles::Stress;
constexpr int lanes = fatigue_lanes;
enum Number : std::size_t
{
  xx,
  yy,
  yz,
  xz,
  xy,
  mean
};

struct Range
{
  FatigueLanes least, most;
};

Range range_of(const std::vector<Stress>& cycle, std::size_t number)
{
  Range range{cycle.front()[number], cycle.front()[number]};
  for (const Stress& s : cycle)
#pragma omp simd
    for (std::size_t l = 0; l < lanes; ++l)
    {
      range.least[l] = std::min(range.least[l], s[number][l]);
      range.most[l] = std::max(range.most[l], s[number][l]);
    }
  return range;
}

/// Largest of principal shear + weight * mean over the cycle, of the deviator less a centre. The principal shear is sqrt(J2) cos t,
/// where cos 3t = c follows from J3 and cos t is a polynomial of c, to 1e-6; it is computed anew where the sum is largest.
/// @param j2  becomes J2 of all points
FatigueLanes largest_shear(const std::vector<Stress>& cycle, const Stress& centre, float weight,
                           std::vector<FatigueLanes>& j2)
{
  constexpr float tiny = 1e-30F;
  FatigueLanes most;
  std::array<int, lanes> where{};
  most.fill(-std::numeric_limits<float>::infinity());
  j2.resize(cycle.size());
  for (std::size_t n = 0; n < cycle.size(); ++n)
  {
    const Stress& s = cycle[n];
    FatigueLanes& second = j2[n];
    const int number = static_cast<int>(n);
#pragma omp simd
    for (std::size_t l = 0; l < lanes; ++l)
    {
      const float a = s[xx][l] - centre[xx][l], b = s[yy][l] - centre[yy][l], c = s[yz][l] - centre[yz][l],
                  d = s[xz][l] - centre[xz][l], e = s[xy][l] - centre[xy][l], f = -a - b;
      const float square = a * a + b * b + a * b + c * c + d * d + e * e, root = std::sqrt(square);
      const float inverse = 1.0F / std::max(root, tiny);
      const float third =
          (a * (b * f - c * c) - e * (e * f - c * d) + d * (e * c - b * d)) * inverse * inverse * inverse;
      const float cosine = std::sqrt(std::max(0.0F, 1.0F - 6.75F * third * third));
      const float share =
          0.86602598F +
          cosine *
              (0.16662258F +
               cosine * (-0.047553684F + cosine * (0.02197789F + cosine * (-0.0090542486F + cosine * 0.0019819242F))));
      const float sum = root * share + weight * s[mean][l];
      const bool is_larger = sum > most[l];
      second[l] = square;
      most[l] = is_larger ? sum : most[l];
      where[l] = is_larger ? number : where[l];
    }
  }
  for (std::size_t l = 0; l < lanes; ++l)
  {
    const Stress& s = cycle[static_cast<std::size_t>(where[l])];
    Stress moved{};
    for (std::size_t c = xx; c <= xy; ++c)
      moved[c][0] = s[c][l] - centre[c][l];
    most[l] = static_cast<float>(principal_shear(LaneCycles::tensor(moved, 0))) + weight * s[mean][l];
  }
  return most;
}

struct Balls
{
  Stress centre; ///< the last number is 0
  FatigueLanes radius;
  FatigueLanes
      gap; ///< bound for the square of the distance from the true centre, and for the error of the radius' square
};

/// Indices of the points farthest from a centre.
std::array<std::size_t, lanes> farthest_from(const std::vector<std::array<FatigueLanes, 5>>& points,
                                             const std::array<FatigueLanes, 5>& centre)
{
  std::array<std::size_t, lanes> far{};
  FatigueLanes farthest{};
  for (std::size_t n = 0; n < points.size(); ++n)
    for (std::size_t l = 0; l < lanes; ++l)
    {
      float d = 0.0F;
      for (std::size_t c = 0; c < 5; ++c)
        d += (points[n][c][l] - centre[c][l]) * (points[n][c][l] - centre[c][l]);
      if (d > farthest[l])
        farthest[l] = d, far[l] = n;
    }
  return far;
}

/// The smallest balls around the deviators, as `smallest_ball`, in all lanes at once, begun halfway between two points far apart.
/// The radius is that of a ball around all points, whatever the number of steps.
/// @param accepted, over_radius  gap at which to stop, and a further one over the radius
Balls enclosing_balls(const std::vector<Stress>& cycle, float accepted, float over_radius, LaneScratch& scratch)
{
  constexpr float tolerance = 1e-3F; // of the square of the radius
  constexpr int most = 25;           // a few cells need far more, and are among the worst ones seldom
  const float root = std::sqrt(1.5F), half = std::sqrt(0.5F), twice = std::sqrt(2.0F);
  auto& points = scratch.points;
  auto& weights = scratch.weights;
  points.resize(cycle.size());
  weights.assign(cycle.size(), FatigueLanes{});
  for (std::size_t n = 0; n < cycle.size(); ++n)
#pragma omp simd
    for (std::size_t l = 0; l < lanes; ++l)
    {
      const Stress& s = cycle[n];
      points[n][0][l] = root * s[xx][l];
      points[n][1][l] = half * (s[xx][l] + 2.0F * s[yy][l]); // yy - zz
      points[n][2][l] = twice * s[yz][l];
      points[n][3][l] = twice * s[xz][l];
      points[n][4][l] = twice * s[xy][l];
    }
  std::array<FatigueLanes, 5> centre = points.front();
  const auto at = [&](const std::array<std::size_t, lanes>& numbers)
  {
    std::array<FatigueLanes, 5> found;
    for (std::size_t c = 0; c < 5; ++c)
      for (std::size_t l = 0; l < lanes; ++l)
        found[c][l] = points[numbers[l]][c][l];
    return found;
  };
  const auto one = farthest_from(points, centre), other = farthest_from(points, at(one));
  for (std::size_t l = 0; l < lanes; ++l)
  {
    weights[one[l]][l] += 0.5F;
    weights[other[l]][l] += 0.5F;
    for (std::size_t c = 0; c < 5; ++c)
      centre[c][l] = 0.5F * (points[one[l]][c][l] + points[other[l]][c][l]);
  }
  std::array<FatigueLanes, 5> best = centre; // of all steps, as they do not become better each time
  FatigueLanes square, least;                // bounds of the square of the radius
  square.fill(std::numeric_limits<float>::infinity());
  least.fill(0.0F);
  for (int step = 0;; ++step)
  {
    FatigueLanes farthest, nearest, variance{};
    std::array<int, lanes> far{}, near{};
    farthest.fill(-1.0F);
    nearest.fill(std::numeric_limits<float>::infinity());
    for (std::size_t n = 0; n < points.size(); ++n)
    {
      const auto& p = points[n];
      const FatigueLanes& w = weights[n];
      const int number = static_cast<int>(n);
#pragma omp simd
      for (std::size_t l = 0; l < lanes; ++l)
      {
        float d = 0.0F;
        for (std::size_t c = 0; c < 5; ++c)
          d += (p[c][l] - centre[c][l]) * (p[c][l] - centre[c][l]);
        const bool is_farther = d > farthest[l], is_nearer = w[l] > 0.0F && d < nearest[l];
        farthest[l] = is_farther ? d : farthest[l];
        far[l] = is_farther ? number : far[l];
        nearest[l] = is_nearer ? d : nearest[l];
        near[l] = is_nearer ? number : near[l];
        variance[l] += w[l] * d;
      }
    }
    bool is_done = true;
    std::array<bool, lanes> moves{};
    for (std::size_t l = 0; l < lanes; ++l)
    {
      for (std::size_t c = 0; c < 5; ++c)
        best[c][l] = farthest[l] < square[l] ? centre[c][l] : best[c][l];
      square[l] = std::min(square[l], farthest[l]);
      least[l] = std::max(least[l], variance[l]);
      moves[l] = square[l] - least[l] > std::max({tolerance * square[l], accepted, over_radius * std::sqrt(square[l])});
      is_done = is_done && !moves[l];
    }
    if (is_done || step == most)
      break;
    for (std::size_t l = 0; l < lanes; ++l)
    {
      if (!moves[l])
        continue;
      const auto f = static_cast<std::size_t>(far[l]), m = static_cast<std::size_t>(near[l]);
      float apart = 0.0F;
      for (std::size_t c = 0; c < 5; ++c)
        apart += (points[f][c][l] - points[m][c][l]) * (points[f][c][l] - points[m][c][l]);
      if (!(apart > 0.0F))
        continue;
      const float moved = std::min(weights[m][l], 0.5F * (farthest[l] - nearest[l]) / apart);
      weights[f][l] += moved;
      weights[m][l] -= moved;
      for (std::size_t c = 0; c < 5; ++c)
        centre[c][l] += moved * (points[f][c][l] - points[m][c][l]);
    }
  }
  Balls balls{};
  for (std::size_t l = 0; l < lanes; ++l)
  {
    balls.radius[l] = std::sqrt(square[l]);
    balls.gap[l] = std::max(0.0F, square[l] - least[l]);
    balls.centre[xx][l] = best[0][l] / root;
    balls.centre[yy][l] = 0.5F * (best[1][l] / half - balls.centre[xx][l]);
    balls.centre[yz][l] = best[2][l] / twice;
    balls.centre[xz][l] = best[3][l] / twice;
    balls.centre[xy][l] = best[4][l] / twice;
  }
  return balls;
}

/// Upper bound of the largest normal stress on any plane over the cycle: mean + 2 sqrt(J2 / 3).
FatigueLanes most_normal_stress(const std::vector<Stress>& cycle, const std::vector<FatigueLanes>& j2)
{
  FatigueLanes most;
  most.fill(-std::numeric_limits<float>::infinity());
  for (std::size_t n = 0; n < cycle.size(); ++n)
#pragma omp simd
    for (std::size_t l = 0; l < lanes; ++l)
      most[l] = std::max(most[l], cycle[n][mean][l] + 1.154701F * std::sqrt(j2[n][l]));
  return most;
}

/// Bound of the criteria of critical planes: no shear amplitude exceeds the radius of the ball over sqrt(2).
FatigueLanes bound_on_planes(const LaneCycles& cycles, const FatigueCriterion& criterion, float accepted_shear,
                             LaneScratch& scratch)
{
  const FatigueLanes normal = most_normal_stress(cycles.stress, scratch.j2);
  const bool is_findley = criterion.kind() == Criterion::findley;
  const Balls balls = enclosing_balls(is_findley ? cycles.stress : cycles.strain, 0.0F,
                                      std::numbers::sqrt2_v<float> * accepted_shear, scratch);
  const auto k = static_cast<float>(criterion.sensitivity()), limit = static_cast<float>(criterion.limit());
  FatigueLanes bound;
  for (std::size_t l = 0; l < lanes; ++l)
  {
    const float shear = balls.radius[l] * std::sqrt(0.5F);
    bound[l] = (is_findley ? shear + k * normal[l] : shear * std::max(0.0F, 1.0F + k * normal[l])) / limit;
  }
  return bound;
}

/// Fills utilisation and slack. A centre that is off by d changes a principal shear by less than d / sqrt(2), a radius R whose square
/// is known to g an amplitude by less than g / (sqrt(2) R).
void find_utilisation(const LaneCycles& cycles, const FatigueCriterion& criterion, float accepted_shear,
                      LaneFatigue& result, LaneScratch& scratch)
{
  constexpr float root = std::numbers::sqrt2_v<float>;
  const auto weight = static_cast<float>(criterion.sensitivity()), limit = static_cast<float>(criterion.limit());
  result.utilisation = result.slack = FatigueLanes{};
  if (criterion.kind() == Criterion::none)
    return;
  if (criterion.kind() == Criterion::dang_van)
  {
    const Balls balls = enclosing_balls(cycles.stress, 2.0F * accepted_shear * accepted_shear, 0.0F, scratch);
    result.utilisation = largest_shear(cycles.stress, balls.centre, weight, scratch.j2);
    for (std::size_t l = 0; l < lanes; ++l)
    {
      result.utilisation[l] /= limit;
      result.slack[l] = std::sqrt(0.5F * balls.gap[l]) / limit;
    }
  }
  else if (criterion.kind() == Criterion::crossland)
  {
    const Balls balls = enclosing_balls(cycles.stress, 0.0F, root * accepted_shear, scratch);
    for (std::size_t l = 0; l < lanes; ++l)
    {
      result.utilisation[l] = (balls.radius[l] / root + weight * result.most_mean[l]) / limit;
      result.slack[l] = balls.radius[l] > 0.0F ? balls.gap[l] / (root * balls.radius[l] * limit) : 0.0F;
    }
  }
  else
    result.utilisation = bound_on_planes(cycles, criterion, accepted_shear, scratch);
}

} // namespace

LaneFatigue fatigue_of(const LaneCycles& cycles, const FatigueCriterion& criterion, LaneScratch& scratch,
                       double accepted_shear)
{
  LaneFatigue result;
  const Range along = range_of(cycles.stress, xz), across = range_of(cycles.stress, yz),
              of_mean = range_of(cycles.stress, mean);
  for (std::size_t l = 0; l < lanes; ++l)
    result.orthogonal[l] = 0.5F * std::max(along.most[l] - along.least[l], across.most[l] - across.least[l]);
  result.least_mean = of_mean.least;
  result.most_mean = of_mean.most;
  result.principal = largest_shear(cycles.stress, Stress{}, 0.0F, scratch.j2);
  find_utilisation(cycles, criterion, static_cast<float>(accepted_shear), result, scratch);
  return result;
}

} // namespace brinell::constitutive
