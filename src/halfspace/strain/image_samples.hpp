// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/grid.hpp"
#include "brinell/green/stack.hpp"
#include "foundation/matrix.hpp"

#include <array>
#include <span>
#include <vector>

/// The stress of periodic images of plastic strain, sampled at a few distances and depths, and polynomials through the
/// samples. Shared by ImageCorrection and CrosswiseImages.
namespace brinell::halfspace::images
{

inline constexpr int strains = Deviator::size;      ///< number of components of the strain
inline constexpr int stresses = Deviator::size + 1; ///< number of components of the stress: deviator, then the trace
inline constexpr int offset_nodes = 6;              ///< number of distances along each axis

/// Cause of images: a plastic strain, or a dilatation, which stands in the place of the first component of the strain. The others
/// are then zero.
enum class Source
{
  plastic_strain,
  dilatation
};
[[nodiscard]] constexpr int components_of(Source source)
{
  return source == Source::dilatation ? 1 : strains;
}

/// 1 for components that change their sign if x (or y) is mirrored, otherwise 0; in the order of Deviator, then the trace.
inline constexpr std::array<int, stresses> odd_in_x{0, 0, 0, 1, 1, 0};
inline constexpr std::array<int, stresses> odd_in_y{0, 0, 1, 0, 1, 0};

/// Whether the stress component c by a strain component e is odd in a direction, given the parities of the components in it.
[[nodiscard]] constexpr bool is_odd(const std::array<int, stresses>& parity, int c, int e)
{
  return (parity[static_cast<std::size_t>(c)] + parity[static_cast<std::size_t>(e)]) % 2 != 0;
}

/// Distances divided by the largest one: positive zeros of a Chebyshev polynomial.
[[nodiscard]] const std::array<double, offset_nodes>& offsets();

/// Chebyshev polynomials of depth on a grid of layers. In a layered body each material has its own, since the stress along the surface
/// jumps at the interfaces.
struct DepthBasis
{
  int count; ///< of polynomials, and of nodes
  std::vector<double>
      nodes;         ///< zeros of the first polynomial that is omitted, scaled to the thickness of the material [m]
  Matrix means;      ///< of the polynomials over the layers: [layer][polynomial]
  Matrix from_nodes; ///< matrix from values at the nodes to coefficients: [polynomial][node]

  /// @param distance  of the nearest image [m]: it is the length over which fields vary in depth, so grids that are thick
  ///                  compared with it need more polynomials.
  DepthBasis(const VolumeGrid& grid, const ElasticStack& stack, double distance);
};

/// cos and sin of a wave's phase at the distances along one axis; a single 1 if the caller applies the phase itself.
using Phases = std::array<std::vector<double>, 2>;

/// Wavevectors (m, n) with the same n, each representing also its mirror images in x and y.
struct WaveRow
{
  struct Wave
  {
    double m, weight;
    Phases in_x;
  };
  double n;
  Phases in_y;
  std::vector<Wave> waves;
};

/// Factor on a wave of wavenumber k by a blur of length `width`, which leaves smooth fields unchanged to the sixth order in width
/// over their length. It decays with k and is negligible from k = `shortest / width` on.
[[nodiscard]] double blur(double k, double width);
inline constexpr double shortest = 7.0;

/// cos and sin of k times the distances `offsets() * largest`.
[[nodiscard]] Phases phases(double k, double largest);

/// Sum of the waves. @returns [depth of stress][depth of strain][strain][stress][distance in y][distance in x].
[[nodiscard]] std::vector<double> sampled(std::span<const WaveRow> rows, const std::vector<double>& depths,
                                          const ElasticStack& stack, Source source);

/// Powers of the two distances, each divided by the largest one.
using Powers = std::array<int, 2>;

/// Coefficients of polynomials in the distances and in the depths, for one pair of components.
/// @param samples   as `sampled` returns them
/// @param distances number of distances along x and y: `offset_nodes`, or 1
/// @returns one matrix [polynomial of z][polynomial of z'] for each of `powers`
[[nodiscard]] std::vector<Matrix> fitted(const std::vector<double>& samples, int c, int e,
                                         const std::array<int, 2>& distances, const DepthBasis& depth,
                                         const std::vector<Powers>& powers);

[[nodiscard]] double factorial(int n);

/// Powers up to `degree` of the coordinates of cells along one axis, scaled to [-1/2, 1/2]: [cell][power].
[[nodiscard]] Matrix coordinate_powers(int cells, int degree);

} // namespace brinell::halfspace::images
