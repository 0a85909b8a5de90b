// SPDX-License-Identifier: BSD-3-Clause
#include "image_correction.hpp"

#include "foundation/lane_functions.hpp"

#include <algorithm>

/// Moments of fields on the grid, and evaluation of polynomials on the grid.
namespace brinell::halfspace
{

namespace
{

void subtract_lanes(const Lanes& value, std::size_t used, double* from)
{
  store_lanes(load_lanes(from, used) - value, used, from);
}

} // namespace

ImageCorrection::PowersOfY ImageCorrection::powers_of_y(int component) const
{
  if (!grid_.surface.is_mirrored_y)
    return PowersOfY::all;
  return is_odd_in_y(component) ? PowersOfY::odd : PowersOfY::even;
}

void ImageCorrection::find_moments_of_layer(const double* strain, const CellRectangle& used, int component, int layer,
                                            Response& response) const
{
  if (!has_images_)
    return;
  switch (powers_of_y(component))
  {
  case PowersOfY::all:
    return sum_powers<PowersOfY::all>(strain, used, component, layer, response);
  case PowersOfY::even:
    return sum_powers<PowersOfY::even>(strain, used, component, layer, response);
  case PowersOfY::odd:
    return sum_powers<PowersOfY::odd>(strain, used, component, layer, response);
  }
}

/// Rows at the same distance from the middle are combined: their sum contributes to even powers of y, their difference to odd
/// ones.
template <ImageCorrection::PowersOfY has>
void ImageCorrection::sum_powers(const double* strain, const CellRectangle& cells, int component, int layer,
                                 Response& response) const
{
  constexpr int first_power = has == PowersOfY::odd ? 1 : 0;
  constexpr int next = has == PowersOfY::all ? 1 : 2;
  const SurfaceGrid& s = grid_.surface;
  CrosswiseImages::Columns columns =
      crosswise_ ? CrosswiseImages::Columns(s.nx, CrosswiseImages::powers) : CrosswiseImages::Columns();
  std::array<Lanes, powers> sum{};
  // With the lanes of the whole row, and so with its sums.
  const int begin = cells.first_x / lane_count * lane_count;
  const int first_row = has == PowersOfY::all ? std::min(cells.first_y, s.ny - cells.end_y) : cells.first_y;
  for (int first = begin; first < cells.end_x; first += lane_count)
  {
    const auto used = static_cast<std::size_t>(std::min(lane_count, s.nx - first));
    std::array<Lanes, degree + 1> of_columns{};
    for (int j = first_row; 2 * j < s.ny; ++j)
    {
      const int mirrored = s.ny - 1 - j;
      const Lanes here = load_lanes(strain + s.nx * j + first, used);
      std::array<Lanes, 2> value{mirrored == j ? here : 2.0 * here, mirrored == j ? Lanes{} : 2.0 * here};
      if (has == PowersOfY::all)
      {
        const Lanes there = mirrored == j ? Lanes{} : load_lanes(strain + s.nx * mirrored + first, used);
        value = {here + there, here - there};
      }
      for (int b = first_power; b <= degree; b += next)
        of_columns[static_cast<std::size_t>(b)] += y_(j, b) * value[static_cast<std::size_t>(b % 2)];
    }
    for (int a = 0; a <= degree; ++a)
    {
      const Lanes x = load_lanes(x_.column(a) + first, used);
      for (int b = first_power; a + b <= degree; b += next)
        sum[static_cast<std::size_t>(monomial(a, b))] += x * of_columns[static_cast<std::size_t>(b)];
    }
    for (int b = first_power; crosswise_ && b < CrosswiseImages::powers; b += next)
      store_lanes(of_columns[static_cast<std::size_t>(b)], used, columns.column(b) + first);
  }
  double* moment = response.of_layers.data() + static_cast<std::ptrdiff_t>((component * grid_.nz + layer) * powers);
  std::fill_n(moment, powers, 0.0);
  for (int a = 0; a <= degree; ++a)
    for (int b = first_power; a + b <= degree; b += next)
      for (std::size_t lane = 0; lane < lane_count; ++lane)
        moment[monomial(a, b)] += sum[static_cast<std::size_t>(monomial(a, b))][lane];
  if (crosswise_ && crosswise_->is_along_x())
    crosswise_->find_moments_of_layer(columns, cells.first_x, cells.end_x, component, layer, response.crosswise);
  else if (crosswise_)
    crosswise_->find_moments_of_layer(along_y(strain, has), 0, s.ny, component, layer, response.crosswise);
}

/// For a grid that is long in y: sums over x of the field times powers of x.
CrosswiseImages::Columns ImageCorrection::along_y(const double* field, PowersOfY has) const
{
  const SurfaceGrid& s = grid_.surface;
  const int rows = s.independent_rows();
  CrosswiseImages::Columns sums(s.ny, CrosswiseImages::powers);
  assign_transposed_product({field, s.nx, rows}, {x_, s.nx, CrosswiseImages::powers}, sums);
  for (int power = 0; power < CrosswiseImages::powers; ++power)
    for (int j = rows; j < s.ny; ++j)
      sums(j, power) = (has == PowersOfY::odd ? -1.0 : 1.0) * sums(s.ny - 1 - j, power);
  return sums;
}

void ImageCorrection::subtract(const Response& response, int component, int layer, double* stress) const
{
  if (!has_images_)
    return;
  switch (powers_of_y(component))
  {
  case PowersOfY::all:
    return subtract_powers<PowersOfY::all>(response, component, layer, stress);
  case PowersOfY::even:
    return subtract_powers<PowersOfY::even>(response, component, layer, stress);
  case PowersOfY::odd:
    return subtract_powers<PowersOfY::odd>(response, component, layer, stress);
  }
}

/// Adds the polynomials of all functions of depth. Inlined, so that the compiler knows the sum to be nobody else's.
[[gnu::always_inline]] inline void ImageCorrection::sum_depths(const Response& response, int component, int layer,
                                                               std::array<double, powers>& of_depth) const
{
  for (int q = 0; q < depth_.count; ++q)
    for (int p = 0; p < powers; ++p)
      of_depth[static_cast<std::size_t>(p)] +=
          depth_.means(layer, q) *
          response.stress[static_cast<std::size_t>((component * depth_.count + q) * powers + p)];
}

std::array<double, ImageCorrection::powers> ImageCorrection::polynomial(const Response& response, int component,
                                                                        int layer) const
{
  std::array<double, powers> of_depth{};
  sum_depths(response, component, layer, of_depth);
  return of_depth;
}

template <ImageCorrection::PowersOfY has>
void ImageCorrection::subtract_powers(const Response& response, int component, int layer, double* stress) const
{
  constexpr int first_power = has == PowersOfY::odd ? 1 : 0;
  constexpr int next = has == PowersOfY::all ? 1 : 2;
  const SurfaceGrid& s = grid_.surface;
  AlignedVector<double> along_x;
  if (crosswise_ && crosswise_->is_along_x())
    along_x = crosswise_->amplitudes(response.crosswise, component, layer);
  else if (crosswise_)
  {
    const int rows = s.independent_rows();
    subtract_product({x_, s.nx, CrosswiseImages::powers},
                     {crosswise_->stress(response.crosswise, component, layer), rows, CrosswiseImages::powers}, stress);
  }
  std::array<double, powers> of_depth{};
  sum_depths(response, component, layer, of_depth);
  for (int first = 0; first < s.nx; first += lane_count)
  {
    const auto used = static_cast<std::size_t>(std::min(lane_count, s.nx - first));
    std::array<Lanes, degree + 1> of_columns{}; // coefficients of the powers of y
    if (!along_x.empty())
    {
      const auto sums = crosswise_->sums_of_waves<first_power, next>(along_x, first, used);
      std::copy(sums.begin(), sums.end(), of_columns.begin());
    }
    for (int a = 0; a <= degree; ++a)
    {
      const Lanes x = load_lanes(x_.column(a) + first, used);
      for (int b = first_power; a + b <= degree; b += next)
        of_columns[static_cast<std::size_t>(b)] += of_depth[static_cast<std::size_t>(monomial(a, b))] * x;
    }
    for (int j = 0; 2 * j < s.ny; ++j)
    {
      std::array<Lanes, 2> sum{}; // of even and of odd powers
      for (int b = first_power; b <= degree; b += next)
        sum[static_cast<std::size_t>(b % 2)] += y_(j, b) * of_columns[static_cast<std::size_t>(b)];
      const int mirrored = s.ny - 1 - j;
      subtract_lanes(sum[0] + sum[1], used, stress + s.nx * j + first);
      if (has == PowersOfY::all && mirrored != j)
        subtract_lanes(sum[0] - sum[1], used, stress + s.nx * mirrored + first);
    }
  }
}

} // namespace brinell::halfspace
