// SPDX-License-Identifier: BSD-3-Clause
#include "shear_waves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell::halfspace
{

ShearWave ShearWave::of_terms(double xx, double yy, double xy, const green::PairConstants& constants)
{
  const double inverse_distance = constants.normal * (xx + yy);
  return {inverse_distance + constants.along * xx, inverse_distance + constants.along * yy, constants.along * xy};
}

double ShearWave::smallest() const
{
  return 0.5 * (xx + yy) - std::hypot(0.5 * (xx - yy), xy);
}

double ShearWave::largest() const
{
  return 0.5 * (xx + yy) + std::hypot(0.5 * (xx - yy), xy);
}

ShearWave ShearWave::inverse() const
{
  const double determinant = xx * yy - xy * xy;
  return {yy / determinant, xx / determinant, -xy / determinant};
}

double largest(const std::vector<ShearWave>& waves)
{
  double value = 0.0;
  for (const ShearWave& wave : waves)
    value = std::max(value, wave.largest());
  return value;
}

std::vector<ShearWave> periodic_shear_waves(const SurfaceGrid& grid, const green::PairConstants& constants)
{
  std::vector<ShearWave> waves;
  for (int row = 0; row <= grid.ny / 2; ++row)
    for (int i = 0; i <= grid.nx / 2; ++i)
    {
      if (i == 0 && row == 0) // uniform shears cause no displacement
      {
        waves.emplace_back();
        continue;
      }
      const double m = 2.0 * std::numbers::pi * i / (grid.nx * grid.dx);
      const double n = 2.0 * std::numbers::pi * row / (grid.ny * grid.dy);
      const green::SurfaceTerms term = green::surface_wave_terms(m, n);
      // At the Nyquist wave an odd function cannot be represented on the grid.
      const bool is_resolved = 2 * i != grid.nx && 2 * row != grid.ny;
      waves.push_back(ShearWave::of_terms(term[0], term[1], is_resolved ? term[2] : 0.0, constants));
    }
  return waves;
}

std::vector<ShearWave> shear_waves(const SurfaceGrid& grid, const KernelPlaces& places,
                                   const Quadrant<green::SurfaceTerms>& response, const green::PairConstants& constants)
{
  const Offsets along_x(grid.nx, grid.boundary_x), along_y(grid.ny, grid.boundary_y);
  const auto even = [&](std::size_t term)
  { return spectrum_of(grid, places, [&](int i, int j) { return response.at(i, j)[term]; }); };
  const std::vector<double> xx = even(0), yy = even(1);
  const std::vector<double> xy =
      spectrum_of(grid, places, [&](int i, int j) { return along_x.sign(i) * along_y.sign(j) * response.at(i, j)[2]; });
  std::vector<ShearWave> waves;
  for (std::size_t w = 0; w < xx.size(); ++w)
    waves.push_back(ShearWave::of_terms(xx[w], yy[w], xy[w], constants));
  return waves;
}

void add_excess(const SurfaceGrid& grid, const std::vector<LayeredBody>& layered, double reference,
                std::vector<ShearWave>& waves)
{
  if (!grid.is_periodic())
  {
    const Quadrant<SurfaceExcess> response = excess_surface(grid, layered, reference);
    const Offsets along_x(grid.nx, grid.boundary_x), along_y(grid.ny, grid.boundary_y);
    const auto spectrum = [&](std::size_t term, const auto& sign)
    {
      return spectrum_of(grid, KernelPlaces::periodic(grid),
                         [&](int i, int j) { return sign(i, j) * response.at(i, j)[term]; });
    };
    const auto even = [](int, int) { return 1.0; };
    const std::vector<double> xx = spectrum(excess::xx, even), yy = spectrum(excess::yy, even);
    const std::vector<double> xy =
        spectrum(excess::xy, [&](int i, int j) { return along_x.sign(i) * along_y.sign(j); });
    for (std::size_t w = 0; w < waves.size(); ++w)
      waves[w] = {waves[w].xx + xx[w], waves[w].yy + yy[w], waves[w].xy + xy[w]};
    return;
  }
  auto wave = waves.begin();
  for (int row = 0; row <= grid.ny / 2; ++row)
    for (int i = 0; i <= grid.nx / 2; ++i, ++wave)
    {
      if (i == 0 && row == 0)
        continue;
      const SurfaceExcess more = excess_wave(layered, 2.0 * std::numbers::pi * i / (grid.nx * grid.dx),
                                             2.0 * std::numbers::pi * row / (grid.ny * grid.dy));
      const bool is_resolved = 2 * i != grid.nx && 2 * row != grid.ny;
      *wave = {wave->xx + more[excess::xx], wave->yy + more[excess::yy],
               wave->xy + (is_resolved ? more[excess::xy] : 0.0)};
    }
}

} // namespace brinell::halfspace
