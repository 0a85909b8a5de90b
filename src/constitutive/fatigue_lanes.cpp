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

/// Half of the square of the length of a deviator less `centre`, J2.
void find_j2(const std::vector<Stress>& cycle, const Stress& centre, std::vector<FatigueLanes>& j2)
{
  j2.resize(cycle.size());
  for (std::size_t n = 0; n < cycle.size(); ++n)
  {
    const Stress& s = cycle[n];
#pragma omp simd
    for (std::size_t l = 0; l < lanes; ++l)
    {
      const float a = s[xx][l] - centre[xx][l], b = s[yy][l] - centre[yy][l], c = s[yz][l] - centre[yz][l],
                  d = s[xz][l] - centre[xz][l], e = s[xy][l] - centre[xy][l];
      j2[n][l] = a * a + b * b + a * b + c * c + d * d + e * e;
    }
  }
}

/// Largest of principal shear + weight * mean over the cycle. The principal shear is sqrt(J2) times a number in [sqrt(3)/2, 1],
/// which is computed only where it may matter.
FatigueLanes largest_shear(const std::vector<Stress>& cycle, const Stress& centre, float weight,
                           std::vector<FatigueLanes>& j2)
{
  find_j2(cycle, centre, j2);
  constexpr float least_share = 0.866025F;
  FatigueLanes sure;
  sure.fill(-std::numeric_limits<float>::infinity());
  for (std::size_t n = 0; n < cycle.size(); ++n)
#pragma omp simd
    for (std::size_t l = 0; l < lanes; ++l)
      sure[l] = std::max(sure[l], least_share * std::sqrt(j2[n][l]) + weight * cycle[n][mean][l]);
  for (std::size_t n = 0; n < cycle.size(); ++n)
    for (std::size_t l = 0; l < lanes; ++l)
    {
      const float pressure = weight * cycle[n][mean][l];
      if (std::sqrt(j2[n][l]) + pressure <= sure[l])
        continue;
      Stress moved;
      for (std::size_t c = xx; c <= xy; ++c)
        moved[c][0] = cycle[n][c][l] - centre[c][l];
      moved[mean][0] = 0.0F;
      sure[l] = std::max(sure[l], static_cast<float>(principal_shear(LaneCycles::tensor(moved, 0))) + pressure);
    }
  return sure;
}

struct Balls
{
  Stress centre; ///< the last number is 0
  FatigueLanes radius;
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
Balls enclosing_balls(const std::vector<Stress>& cycle, LaneScratch& scratch)
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
  FatigueLanes farthest{};
  for (int step = 0; step < most; ++step)
  {
    FatigueLanes nearest, variance{};
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
    for (std::size_t l = 0; l < lanes; ++l)
    {
      if (farthest[l] - variance[l] <= tolerance * farthest[l])
        continue;
      is_done = false;
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
    if (is_done)
      break;
  }
  Balls balls{};
  for (std::size_t l = 0; l < lanes; ++l)
  {
    balls.radius[l] = std::sqrt(farthest[l]);
    balls.centre[xx][l] = centre[0][l] / root;
    balls.centre[yy][l] = 0.5F * (centre[1][l] / half - balls.centre[xx][l]);
    balls.centre[yz][l] = centre[2][l] / twice;
    balls.centre[xz][l] = centre[3][l] / twice;
    balls.centre[xy][l] = centre[4][l] / twice;
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
FatigueLanes bound_on_planes(const LaneCycles& cycles, const FatigueCriterion& criterion, LaneScratch& scratch)
{
  const FatigueLanes normal = most_normal_stress(cycles.stress, scratch.j2);
  const bool is_findley = criterion.kind() == Criterion::findley;
  const Balls balls = enclosing_balls(is_findley ? cycles.stress : cycles.strain, scratch);
  const auto k = static_cast<float>(criterion.sensitivity()), limit = static_cast<float>(criterion.limit());
  FatigueLanes bound;
  for (std::size_t l = 0; l < lanes; ++l)
  {
    const float shear = balls.radius[l] * std::sqrt(0.5F);
    bound[l] = (is_findley ? shear + k * normal[l] : shear * std::max(0.0F, 1.0F + k * normal[l])) / limit;
  }
  return bound;
}

FatigueLanes utilisation(const LaneCycles& cycles, const FatigueCriterion& criterion, const FatigueLanes& most_mean,
                         LaneScratch& scratch)
{
  if (criterion.kind() == Criterion::none)
    return {};
  if (criterion.kind() != Criterion::dang_van && criterion.kind() != Criterion::crossland)
    return bound_on_planes(cycles, criterion, scratch);
  const Balls balls = enclosing_balls(cycles.stress, scratch);
  const auto weight = static_cast<float>(criterion.sensitivity()), limit = static_cast<float>(criterion.limit());
  FatigueLanes result;
  if (criterion.kind() == Criterion::dang_van)
    result = largest_shear(cycles.stress, balls.centre, weight, scratch.j2);
  else
    for (std::size_t l = 0; l < lanes; ++l)
      result[l] = balls.radius[l] * std::sqrt(0.5F) + weight * most_mean[l];
  for (float& value : result)
    value /= limit;
  return result;
}

} // namespace

SymTensor LaneCycles::tensor(const Stress& numbers, int lane)
{
  const auto l = static_cast<std::size_t>(lane);
  const double a = numbers[xx][l], b = numbers[yy][l], third = numbers[mean][l];
  return {a + third, b + third, third - a - b, numbers[yz][l], numbers[xz][l], numbers[xy][l]};
}

LaneFatigue fatigue_of(const LaneCycles& cycles, const FatigueCriterion& criterion, LaneScratch& scratch)
{
  LaneFatigue result;
  const Range along = range_of(cycles.stress, xz), across = range_of(cycles.stress, yz),
              of_mean = range_of(cycles.stress, mean);
  for (std::size_t l = 0; l < lanes; ++l)
    result.orthogonal[l] = 0.5F * std::max(along.most[l] - along.least[l], across.most[l] - across.least[l]);
  result.least_mean = of_mean.least;
  result.most_mean = of_mean.most;
  result.principal = largest_shear(cycles.stress, Stress{}, 0.0F, scratch.j2);
  result.utilisation = utilisation(cycles, criterion, of_mean.most, scratch);
  return result;
}

} // namespace brinell::constitutive
