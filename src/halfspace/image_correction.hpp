// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "brinell/green/elastic.hpp"
#include "foundation/blocked_fft.hpp"
#include "halfspace/crosswise_images.hpp"
#include "halfspace/image_samples.hpp"
#include "halfspace/moment_coupling.hpp"
#include "halfspace/used_cells.hpp"

#include <array>
#include <optional>
#include <vector>

namespace brinell::halfspace
{

/// What the periodic images of the plastic strain add to the residual stress, to be taken off: it turns
/// EigenstrainStress, periodic over the padded lengths, into the operator of a body without neighbours.
///
/// The nearest image is at least half a padded length away, so its stress is smooth over the grid: a polynomial of low
/// degree in (x - x'), (y - y') and Chebyshev polynomials of z and z'. Its coefficients are fitted once to the
/// difference of two lattice sums over wavenumbers, one with the padded lengths and one with four times those, both
/// with a Gaussian that cuts off what two lattices share. What is left of the images is of order 1/4^3 of them, and is
/// extrapolated. Applied through moments of the strain: O(N) with a small factor, symmetric like the operator itself.
/// On a long grid CrosswiseImages takes off those beside it first, so that the rest is that of a square lattice.
/// Along a periodic axis the neighbours belong to the body: there only the rows of images beside it are taken off, and with
/// two periodic axes nothing.
class ImageCorrection
{
public:
  ImageCorrection(const VolumeGrid& grid, const Elastic& elastic, const BlockedFft& fft);

  /// Polynomial coefficients of the stress of the images, and what is needed to find them.
  struct Response
  {
    std::vector<double> of_layers; ///< moments of the strain, [component][layer][power]
    std::vector<double> moments;   ///< of strain, [component][depth][power]
    std::vector<double> stress;    ///< of the stress, [component or trace][depth][power]
    MomentCoupling::Work work;
    CrosswiseImages::Response crosswise; ///< empty unless the grid is long
  };
  [[nodiscard]] Response make_response() const;

  /// Takes the moments of one component of the strain in one layer, given on the grid: while other work has it in the cache.
  /// @param used      the cells that are read; the strain is zero in the others
  /// @param symmetry  here and below: with one, the independent rows are read and written
  void take(const double* strain, const CellRectangle& used, int component, int layer, Symmetry symmetry,
            Response& response) const;
  /// Response to the strain, traceless, whose components in the layers [0, layers) have been taken; beneath there is none.
  /// @param with_trace  whether `subtract` shall know the trace, too: a sixth of the products
  void respond(int layers, Response& response, Symmetry symmetry, bool with_trace) const;
  static constexpr int trace = Deviator::size; ///< component index of the trace of the stress, after those of Deviator
  /// Subtracts the stress [Pa] of the images from that of one component in one layer, given on the grid.
  void subtract(const Response& response, int component, int layer, Symmetry symmetry, double* stress) const;

private:
  static constexpr int degree = 10;                              ///< largest power of x - x' and y - y' together
  static constexpr int powers = (degree + 1) * (degree + 2) / 2; ///< monomials x^a y^b
  [[nodiscard]] static constexpr int monomial(int a, int b) { return MomentCoupling::monomial(a, b); }

  void fit(const Elastic& elastic, double period_x, double period_y);
  void find_moments(int layers, Response& response) const;
  /// Powers of y that a field has.
  enum class PowersOfY
  {
    all,
    even,
    odd
  };
  [[nodiscard]] static PowersOfY powers_of_y(int component, Symmetry symmetry);
  template <PowersOfY has>
  void take_powers(const double* strain, const CellRectangle& cells, int component, int layer,
                   Response& response) const;
  template <PowersOfY has>
  void subtract_powers(const Response& response, int component, int layer, double* stress) const;
  [[nodiscard]] CrosswiseImages::Columns along_y(const double* field, PowersOfY has) const;

  VolumeGrid grid_;
  bool has_images_;                          ///< not where the body is periodic itself along both axes
  std::optional<CrosswiseImages> crosswise_; ///< of a long grid
  Eigen::MatrixXd x_, y_;                    ///< powers of the cells' coordinates: [cell][power]
  images::DepthBasis depth_;
  MomentCoupling coupling_;
};

} // namespace brinell::halfspace
