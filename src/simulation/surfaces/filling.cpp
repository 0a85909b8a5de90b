// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/filling.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace brinell::simulation
{

namespace
{

using Values = std::vector<double>;
constexpr std::size_t none = static_cast<std::size_t>(-1);

/// Laplace's difference equation for the missing heights: weight h - (sum of missing neighbours) = (sum of known neighbours).
struct Equations
{
  std::vector<std::size_t> points;                      ///< places of the missing heights on the map
  std::vector<std::array<std::size_t, 4>> neighbours{}; ///< numbers of missing neighbours, or none
  Values weight{}, source{};

  [[nodiscard]] Values product(const Values& heights) const
  {
    Values result(heights.size());
    for (std::size_t i = 0; i < heights.size(); ++i)
    {
      result[i] = weight[i] * heights[i];
      for (const std::size_t neighbour : neighbours[i])
        if (neighbour != none)
          result[i] -= heights[neighbour];
    }
    return result;
  }
};

/// @param mean  subtracted from known heights, because differences of heights far from zero would lose digits
Equations equations_of(const Values& heights, std::size_t columns, double mean)
{
  Equations equations;
  std::vector<std::size_t> number(heights.size(), none);
  for (std::size_t k = 0; k < heights.size(); ++k)
    if (!std::isfinite(heights[k]))
    {
      number[k] = equations.points.size();
      equations.points.push_back(k);
    }
  const std::size_t rows = heights.size() / columns;
  for (const std::size_t k : equations.points)
  {
    const std::size_t row = k / columns, column = k % columns;
    std::array<std::size_t, 4> missing{none, none, none, none};
    double weight = 0.0, source = 0.0;
    const std::array<bool, 4> exists{column > 0, column + 1 < columns, row > 0, row + 1 < rows};
    const std::array<std::size_t, 4> places{k - 1, k + 1, k - columns, k + columns};
    for (std::size_t side = 0; side < places.size(); ++side)
      if (exists[side])
      {
        weight += 1.0;
        missing[side] = number[places[side]];
        source += missing[side] == none ? heights[places[side]] - mean : 0.0;
      }
    equations.neighbours.push_back(missing);
    equations.weight.push_back(weight);
    equations.source.push_back(source);
  }
  return equations;
}

double inner(const Values& a, const Values& b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

Values scaled(const Values& residual, const Values& weight)
{
  Values result(residual.size());
  std::transform(residual.begin(), residual.end(), weight.begin(), result.begin(), std::divides<>());
  return result;
}

/// Solves by conjugate gradients, preconditioned with the weights, from zero.
Values solution_of(const Equations& equations)
{
  constexpr double accuracy = 1e-9;
  Values heights(equations.points.size(), 0.0), residual = equations.source;
  Values direction = scaled(residual, equations.weight);
  double product = inner(residual, direction);
  const double goal = accuracy * accuracy * product;
  for (std::size_t turn = 0; turn < 10 * heights.size() && product > goal; ++turn)
  {
    const Values image = equations.product(direction);
    const double step = product / inner(direction, image);
    for (std::size_t i = 0; i < heights.size(); ++i)
    {
      heights[i] += step * direction[i];
      residual[i] -= step * image[i];
    }
    const Values next = scaled(residual, equations.weight);
    const double before = product;
    product = inner(residual, next);
    for (std::size_t i = 0; i < heights.size(); ++i)
      direction[i] = next[i] + (product / before) * direction[i];
  }
  return heights;
}

} // namespace

std::vector<double> filled(std::vector<double> heights, std::size_t columns)
{
  double sum = 0.0;
  std::size_t known = 0;
  for (const double height : heights)
    if (std::isfinite(height))
    {
      sum += height;
      ++known;
    }
  if (known == 0)
    throw InputError("none of the heights is finite: there is nothing to fill the map from");
  if (known == heights.size())
    return heights;
  const double mean = sum / static_cast<double>(known);
  const Equations equations = equations_of(heights, columns, mean);
  const Values solution = solution_of(equations);
  for (std::size_t i = 0; i < solution.size(); ++i)
    heights[equations.points[i]] = mean + solution[i];
  return heights;
}

} // namespace brinell::simulation
