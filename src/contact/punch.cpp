// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/punch.hpp"

#include "brinell/foundation/symmetry.hpp"
#include "foundation/require_size.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::contact
{

namespace
{

constexpr double accuracy = 1e-6; ///< of the displacement of the face; that of the load is its square
constexpr int most_iterations = 1000;

} // namespace

Punch::Punch(const halfspace::SurfaceCompliance& compliance)
    : compliance_(compliance), scratch_(compliance.make_scratch()), rest_(compliance.grid().size()),
      correction_(compliance.grid().size()), direction_(compliance.grid().size()), image_(compliance.grid().size())
{
}

void Punch::displace(std::span<const double> pressure, std::span<const double> layer, std::span<double> out)
{
  compliance_.apply({.pressure = pressure}, {.z = out}, scratch_);
  for (std::size_t i = 0; i < layer.size(); ++i)
    out[i] += layer[i] * pressure[i];
}

void Punch::precondition(std::span<const double> area, std::span<const double> layer, bool is_layer_stiffer)
{
  if (is_layer_stiffer)
    for (std::size_t i = 0; i < rest_.size(); ++i)
      correction_[i] = area[i] > 0.0 ? rest_[i] / layer[i] : 0.0;
  else
  {
    compliance_.apply_inverse(rest_, correction_, scratch_);
    for (std::size_t i = 0; i < rest_.size(); ++i)
      correction_[i] = area[i] > 0.0 ? correction_[i] : 0.0;
  }
}

Punch::Report Punch::press(std::span<const double> area, std::span<const double> face, std::span<double> pressure,
                           std::span<const double> layer)
{
  const SurfaceGrid& grid = compliance_.grid();
  require_size("Punch::press: the area", area, grid.size());
  require_size("Punch::press: the face", face, grid.size());
  require_size("Punch::press: the pressure", pressure, grid.size());
  if (!layer.empty())
    require_size("Punch::press: the layer", layer, grid.size());
  const std::size_t cells = grid.independent_cells();
  // The layer is the better preconditioner where it is more compliant than waves of a middle length.
  double thinnest = layer.empty() ? 0.0 : std::numeric_limits<double>::infinity(), largest = 0.0;
  for (std::size_t i = 0; i < cells; ++i)
    if (area[i] > 0.0)
    {
      thinnest = layer.empty() ? 0.0 : std::min(thinnest, layer[i]);
      largest = std::max(largest, std::abs(face[i]));
    }
    else
      pressure[i] = 0.0;
  const bool is_layer_stiffer = thinnest > compliance_.largest() / std::sqrt(std::max(grid.nx, grid.ny));
  Report report;
  double slope = 0.0;
  std::fill(direction_.begin(), direction_.end(), 0.0);
  displace(pressure, layer, image_);
  for (std::size_t i = 0; i < cells; ++i)
    rest_[i] = area[i] > 0.0 ? face[i] - image_[i] : 0.0;
  for (;; ++report.iterations)
  {
    double error = 0.0;
    for (std::size_t i = 0; i < cells; ++i)
      error = larger(error, std::abs(rest_[i]));
    report.converged = error <= accuracy * largest;
    if (report.converged || report.iterations == most_iterations || std::isnan(error))
      break;
    precondition(area, layer, is_layer_stiffer);
    const double next = dot(grid, rest_, correction_), beta = slope > 0.0 ? next / slope : 0.0;
    slope = next;
    for (std::size_t i = 0; i < cells; ++i)
      direction_[i] = correction_[i] + beta * direction_[i];
    displace(direction_, layer, image_);
    const double curvature = dot(grid, direction_, image_), step = curvature > 0.0 ? slope / curvature : 0.0;
    for (std::size_t i = 0; i < cells; ++i)
    {
      pressure[i] += step * direction_[i];
      rest_[i] -= area[i] > 0.0 ? step * image_[i] : 0.0;
    }
  }
  if (grid.is_mirrored_y)
    complete_in_y(grid, 1.0, pressure.data(), pressure.size());
  return report;
}

} // namespace brinell::contact
