// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/green/stack.hpp"
#include "crosswise_images.hpp"
#include "foundation/blocked_fft.hpp"
#include "halfspace/transform/used_cells.hpp"
#include "image_samples.hpp"
#include "moment_coupling.hpp"

#include <array>
#include <optional>
#include <vector>

namespace brinell::halfspace
{

/// Removes from the residual stress the contribution of the periodic images of the plastic strain: it turns
/// EigenstrainStress, which is periodic over the padded lengths, into the operator of a body without neighbours.
///
/// The nearest image is at least half a padded length away, so its stress is smooth over the grid: a polynomial of low
/// degree in (x - x'), (y - y') and Chebyshev polynomials of z and z'. Its coefficients are fitted once to the
/// difference of two lattice sums over wavenumbers, one with the padded lengths and one with four times those, both
/// with a Gaussian that cuts off the part that two lattices share. The remainder, of order 1/4^3 of the images, is
/// extrapolated. The correction is applied through moments of the strain: O(N) with a small factor, symmetric like the operator
/// itself. On a long grid CrosswiseImages first removes the images beside the grid, so that those of a square lattice remain.
/// Along a periodic axis the neighbours belong to the body: with one periodic axis only the rows of images beside the body are
/// removed, and with two periodic axes nothing.
class ImageCorrection
{
public:
  ImageCorrection(const VolumeGrid& grid, const ElasticStack& stack, const BlockedFft& fft,
                  images::Source source = images::Source::plastic_strain);

  /// Polynomial coefficients of the stress of the images, and the moments from which they are computed.
  struct Response
  {
    std::vector<double> of_layers; ///< moments of the strain, [component][layer][power]
    std::vector<double> moments;   ///< of strain, [component][depth][power]
    std::vector<double> stress;    ///< of the stress, [component or trace][depth][power]
    MomentCoupling::Work work;
    CrosswiseImages::Response crosswise; ///< empty unless the grid is long
  };
  [[nodiscard]] Response make_response() const;

  /// Computes the moments of one component of the strain in one layer, given on the grid. To be called layer by layer, while the
  /// layer is in the cache for other work.
  /// @param used      the cells that are read; the strain is zero in the others
  void find_moments_of_layer(const double* strain, const CellRectangle& used, int component, int layer,
                             Response& response) const;
  /// Response to the traceless strain whose moments in the layers [0, layers) have been computed; beneath, the strain is zero.
  /// @param with_trace  whether the trace of the stress is needed, too, which adds a sixth of the products
  void respond(int layers, Response& response, bool with_trace) const;
  static constexpr int trace = Deviator::size; ///< component index of the trace of the stress, after those of Deviator
  /// Subtracts the stress [Pa] of the images from that of one component in one layer, given on the grid.
  void subtract(const Response& response, int component, int layer, double* stress) const;

  static constexpr int degree = 10;                              ///< largest power of x - x' and y - y' together
  static constexpr int powers = (degree + 1) * (degree + 2) / 2; ///< monomials x^a y^b
  [[nodiscard]] bool has_images() const { return has_images_; }
  /// Of a long grid; otherwise nullptr.
  [[nodiscard]] const CrosswiseImages* crosswise() const { return crosswise_ ? &*crosswise_ : nullptr; }
  /// Powers of the cells' coordinates, [cell][power].
  [[nodiscard]] const Matrix& powers_of_x() const { return x_; }
  [[nodiscard]] const Matrix& powers_of_y() const { return y_; }
  [[nodiscard]] static constexpr int monomial(int a, int b) { return MomentCoupling::monomial(a, b); }
  /// The polynomial that `subtract` subtracts in one layer: factors of the monomials.
  [[nodiscard]] std::array<double, powers> polynomial(const Response& response, int component, int layer) const;

private:
  void sum_depths(const Response& response, int component, int layer, std::array<double, powers>& of_depth) const;
  void fit(const ElasticStack& stack, images::Source source, double period_x, double period_y);
  void find_moments(int layers, Response& response) const;
  /// Powers of y in the moments of a field.
  enum class PowersOfY
  {
    all,
    even,
    odd
  };
  [[nodiscard]] PowersOfY powers_of_y(int component) const;
  template <PowersOfY has>
  void sum_powers(const double* strain, const CellRectangle& cells, int component, int layer, Response& response) const;
  template <PowersOfY has>
  void subtract_powers(const Response& response, int component, int layer, double* stress) const;
  [[nodiscard]] CrosswiseImages::Columns along_y(const double* field, PowersOfY has) const;

  VolumeGrid grid_;
  bool has_images_;                          ///< false if the body is periodic along both axes
  std::optional<CrosswiseImages> crosswise_; ///< only for a long grid
  Matrix x_, y_;                             ///< powers of the cells' coordinates: [cell][power]
  images::DepthBasis depth_;
  MomentCoupling coupling_;
};

} // namespace brinell::halfspace
