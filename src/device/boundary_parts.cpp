// SPDX-License-Identifier: BSD-3-Clause
#include "boundary_parts.hpp"

#include "halfspace/strain/image_correction.hpp"
#include "halfspace/traction/traction_stress.hpp"

#include <algorithm>
#include <memory>

namespace brinell::device
{

namespace
{

std::vector<double> kernels_of(const VolumeGrid& grid, const Elastic& elastic, const BlockedFft& fft, Traction traction)
{
  const halfspace::TractionStress stress(grid, {{}, elastic}, fft, traction);
  std::vector<double> numbers;
  const int rows = fft.py() / 2 + 1;
  numbers.reserve(static_cast<std::size_t>(grid.nz * Deviator::size) * static_cast<std::size_t>(rows * fft.kx()));
  for (int layer = 0; layer < grid.nz; ++layer)
    for (int c = 0; c < Deviator::size; ++c)
      for (int row = 0; row < rows; ++row)
        for (int i = 0; i < fft.kx(); ++i)
          numbers.push_back(stress.number(row, i, layer, c));
  return numbers;
}

/// Images with what they refer to. The functions are powers of x and y and, along a long grid, waves.
struct Images
{
  BlockedFft fft;
  int layers;
  halfspace::ImageCorrection correction;
  int of_x, of_y; ///< numbers of functions

  static constexpr int powers = halfspace::ImageCorrection::degree + 1;

  Images(const VolumeGrid& grid, const Elastic& elastic, int px, int py)
      : fft(grid.surface, px, py, 1), layers(grid.nz), correction(grid, {{}, elastic}, fft),
        of_x(powers + (has_waves(true) ? crosswise().waves() : 0)),
        of_y(powers + (has_waves(false) ? crosswise().waves() : 0))
  {
  }
  [[nodiscard]] const halfspace::CrosswiseImages& crosswise() const { return *correction.crosswise(); }
  [[nodiscard]] bool has_waves(bool along_x) const
  {
    return correction.crosswise() != nullptr && crosswise().is_along_x() == along_x;
  }
  /// Values of the functions along an axis.
  [[nodiscard]] std::vector<double> functions(bool along_x) const
  {
    std::vector<double> values = values_of(along_x ? correction.powers_of_x() : correction.powers_of_y());
    if (has_waves(along_x))
    {
      const std::vector<double> waves = values_of(crosswise().along());
      values.insert(values.end(), waves.begin(), waves.end());
    }
    return values;
  }
  /// Calls use(place, monomial) for all monomials and the places of their moments in one plane.
  template <typename Use>
  void for_monomials(const Use& use) const
  {
    for (int b = 0; b < powers; ++b)
      for (int a = 0; a + b < powers; ++a)
        use(b * of_x + a, halfspace::ImageCorrection::monomial(a, b));
  }
  /// Calls use(place, product) for all products of a wave along the grid and a power across it.
  template <typename Use>
  void for_waves(const Use& use) const
  {
    if (correction.crosswise() == nullptr)
      return;
    const int waves = crosswise().waves();
    for (int power = 0; power < halfspace::CrosswiseImages::powers; ++power)
      for (int wave = 0; wave < waves; ++wave)
        use(crosswise().is_along_x() ? power * of_x + powers + wave : (powers + wave) * of_x + power,
            power * waves + wave);
  }
  void respond(std::span<const double> moments, std::span<double> coefficients) const
  {
    halfspace::ImageCorrection::Response response = correction.make_response();
    const int plane = of_x * of_y, planes = Deviator::size * layers;
    const int waves = correction.crosswise() == nullptr ? 0 : crosswise().waves() * halfspace::CrosswiseImages::powers;
    for (int n = 0; n < planes; ++n)
    {
      const double* from = moments.data() + static_cast<std::ptrdiff_t>(n) * plane;
      double* to_powers =
          response.of_layers.data() + static_cast<std::ptrdiff_t>(n) * halfspace::ImageCorrection::powers;
      double* to_waves = response.crosswise.of_layers.data() + static_cast<std::ptrdiff_t>(n) * waves;
      for_monomials([&](int place, int monomial) { to_powers[monomial] = from[place]; });
      for_waves([&](int place, int product) { to_waves[product] = from[place]; });
    }
    correction.respond(layers, response, false);
    std::fill(coefficients.begin(), coefficients.end(), 0.0);
    for (int n = 0; n < planes; ++n)
    {
      double* to = coefficients.data() + static_cast<std::ptrdiff_t>(n) * plane;
      const auto polynomial = correction.polynomial(response, n / layers, n % layers);
      for_monomials([&](int place, int monomial) { to[place] = polynomial[static_cast<std::size_t>(monomial)]; });
      if (waves == 0)
        continue;
      const AlignedVector<double> amplitudes = crosswise().amplitudes(response.crosswise, n / layers, n % layers);
      for_waves([&](int place, int product) { to[place] = amplitudes[static_cast<std::size_t>(product)]; });
    }
  }

private:
  static std::vector<double> values_of(const Matrix& matrix)
  {
    return {matrix.column(0), matrix.column(0) + static_cast<std::ptrdiff_t>(matrix.rows()) * matrix.columns()};
  }
};

} // namespace

BoundaryParts boundary_of(const VolumeGrid& grid, const Elastic& elastic, bool with_shears)
{
  VolumeGrid whole = grid;
  whole.surface = grid.surface.whole();
  const PaddedLengths lengths = padded_lengths(whole.surface);
  BoundaryParts boundary;
  boundary.px = lengths.x;
  boundary.py = lengths.y;
  if (whole.surface.is_periodic())
    return boundary;
  const BlockedFft fft(whole.surface, lengths.x, lengths.y, 1);
  for (const Traction traction : {Traction::pressure, Traction::shear_x, Traction::shear_y})
    if (traction == Traction::pressure || with_shears)
      boundary.kernels[static_cast<std::size_t>(traction)] = kernels_of(whole, elastic, fft, traction);
  const auto images = std::make_shared<const Images>(whole, elastic, lengths.x, lengths.y);
  boundary.x_functions = images->functions(true);
  boundary.y_functions = images->functions(false);
  boundary.images = [images](std::span<const double> moments, std::span<double> coefficients)
  { images->respond(moments, coefficients); };
  return boundary;
}

} // namespace brinell::device
