// SPDX-License-Identifier: BSD-3-Clause
#include "layered_conduction.hpp"

#include "foundation/lane_functions.hpp"
#include "foundation/matrix.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace brinell::halfspace
{

RowsOfFour::RowsOfFour(std::size_t rows, std::size_t columns)
    : rows_(rows), columns_(columns), values_((rows + together - 1) / together * together * columns)
{
}

double& RowsOfFour::at(std::size_t row, std::size_t column)
{
  return values_[(row / together * columns_ + column) * together + row % together];
}

void RowsOfFour::multiply(const ComplexLanes* in, std::size_t first, std::size_t last, ComplexLanes* out) const
{
  for (std::size_t row = 0; row < rows_; row += together)
  {
    std::array<ComplexLanes, together> sums{};
    const double* values = values_.data() + row * columns_ + first * together;
    for (std::size_t column = first; column < last; ++column, values += together)
    {
      const ComplexLanes given = in[column];
      for (std::size_t r = 0; r < together; ++r)
        sums[r] = sums[r] + values[r] * given;
    }
    std::copy_n(sums.begin(), std::min(together, rows_ - row), out + row);
  }
}

namespace
{

std::vector<double> ends_of_layers(int heated, double thickness, double deepest)
{
  std::vector<double> ends;
  for (int n = 0; n <= heated; ++n)
    ends.push_back(n * thickness);
  for (double next = std::numbers::sqrt2 * thickness; ends.back() < deepest; next *= std::numbers::sqrt2)
    ends.push_back(ends.back() + next);
  return ends;
}

} // namespace

std::size_t count_of_layers(int heated, double thickness, double deepest)
{
  return ends_of_layers(heated, thickness, deepest).size() - 1;
}

int layers_together(double thickness, double distance)
{
  constexpr double least_in_distance = 16.0;
  int together = 1;
  while (2 * together * thickness * least_in_distance <= distance)
    together *= 2;
  return together;
}

LayeredConduction::LayeredConduction(int heated, double thickness, double deepest)
    : heated_(static_cast<std::size_t>(heated)), thickness_(thickness),
      ends_(ends_of_layers(heated, thickness, deepest)), to_layers_(size(), size()), to_modes_(size(), size())
{
  find_modes();
}

std::size_t LayeredConduction::layer_at(double depth) const
{
  const auto above = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, depth);
  return static_cast<std::size_t>(above - ends_.begin()) - 1;
}

/// The temperature is linear between the middles of neighbouring layers. Scaling by the square roots of the thicknesses makes the
/// matrix symmetric.
void LayeredConduction::find_modes()
{
  const std::size_t n = size();
  // In units of the thickness of a heated layer.
  const auto height = [&](std::size_t i) { return (bottom(i) - top(i)) / thickness_; };
  std::vector<double> diagonal(n), beside(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i)
  {
    const double between = thickness_ / (middle(i + 1) - middle(i));
    diagonal[i] += between / height(i);
    diagonal[i + 1] += between / height(i + 1);
    beside[i] = -between / std::sqrt(height(i) * height(i + 1));
  }
  const Eigensystem modes = eigensystem_of_tridiagonal(diagonal, beside);
  const double whole = ends_.back() / thickness_;
  for (std::size_t l = 0; l < n; ++l)
  {
    // The slowest mode, the first one, is uniform and does not decay at all.
    const double* mode = modes.vectors.column(static_cast<int>(l));
    squared_numbers_.push_back(l == 0 ? 0.0 : modes.values[l] / (thickness_ * thickness_));
    for (std::size_t i = 0; i < n; ++i)
    {
      const double root = std::sqrt(height(i));
      const double value = l == 0 ? root / std::sqrt(whole) : mode[i];
      to_layers_.at(i, l) = value / root;
      to_modes_.at(l, i) = value * root;
    }
  }
}

std::shared_ptr<const LayeredConduction> layers_for_images(const std::shared_ptr<const LayeredConduction>& layers,
                                                           double distance)
{
  if (!layers)
    return nullptr;
  const int together = layers_together(layers->thickness(), distance);
  if (together == 1)
    return layers;
  const int heated = (static_cast<int>(layers->heated()) + together - 1) / together;
  const double thickness = together * layers->thickness();
  // As in the original layers, there must be at least one thicker layer beneath.
  const double deepest = std::max(layers->bottom(layers->size() - 1), (heated + 1) * thickness);
  return std::make_shared<const LayeredConduction>(heated, thickness, deepest);
}

std::vector<std::vector<double>> on_layers(const LayeredConduction& from, const std::vector<std::vector<double>>& rise,
                                           const LayeredConduction& to)
{
  std::vector<std::vector<double>> result(to.size());
  for (std::size_t k = 0; k < rise.size(); ++k)
  {
    if (rise[k].empty())
      continue;
    // Distribute over two layers in proportion to the distances of their middles, also above the first and below the last middle:
    // this conserves the heat and its mean depth.
    const double depth = from.middle(k), height = from.bottom(k) - from.top(k);
    std::size_t upper = to.layer_at(depth);
    if (depth < to.middle(upper) && upper > 0)
      --upper;
    upper = std::min(upper, to.size() - 2);
    const double lower_share = (depth - to.middle(upper)) / (to.middle(upper + 1) - to.middle(upper));
    for (const auto& [j, share] : {std::pair{upper, 1.0 - lower_share}, {upper + 1, lower_share}})
    {
      const double factor = share * height / (to.bottom(j) - to.top(j));
      result[j].resize(rise[k].size());
      for (std::size_t i = 0; i < rise[k].size(); ++i)
        result[j][i] += factor * rise[k][i];
    }
  }
  return result;
}

} // namespace brinell::halfspace
