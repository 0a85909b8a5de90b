// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/deviator.hpp"

#include "order.hpp"
#include "record.hpp"
#include "tugging_runs.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

/// The stress that a pass leaves behind is in equilibrium with nothing: no force over any plane, none on the surface.
namespace brinell::verification::residual_stress_test
{
namespace
{

enum Component
{
  xx,
  yy,
  zz,
  yz,
  xz,
  xy
};

/// The lower body after one pass.
const simulation::BodySnapshot& body_after_a_pass()
{
  static const TuggingRun run = []
  {
    simulation::TuggingCase t = equal_spheres(6.0, perfect_material());
    const double a = simulation::plan(t).elastic_contact_radius;
    const double cells = slow_build ? 3.0 : 5.0;
    t.spacing = {{a / cells, a / cells, 0.5 * a / cells}};
    return computed(t);
  }();
  return run.summary.final_state.lower;
}

/// The residual stress on a block that is wider by `margin` cells on each side, and deeper as well, with each layer cut
/// into `parts`.
test::StressField stress_on_block(const simulation::BodySnapshot& body, int margin, int parts, VolumeGrid& grid)
{
  const VolumeGrid& from = body.grid;
  grid = from;
  grid.surface.nx += 2 * margin;
  grid.surface.ny += 2 * margin;
  grid.nz = parts * (from.nz + 2 * margin); // layers are half as thick as cells are wide
  grid.dz = from.dz / parts;
  std::vector<double> strain(Deviator::size * grid.size(), 0.0);
  constexpr std::array kept{xx, yy, yz, xz, xy}; // the order of Deviator
  for (int k = 0; k < parts * from.nz; ++k)
    for (int j = 0; j < from.surface.ny; ++j)
      for (int i = 0; i < from.surface.nx; ++i)
        for (std::size_t c = 0; c < kept.size(); ++c)
          strain[c * grid.size() + grid.index(i + margin, j + margin, k)] =
              body.plastic_strain[kept[c]][from.index(i, j, k / parts)];
  const halfspace::HalfSpace half_space(grid, elastic);
  return {half_space, {}, strain};
}

/// Sum of a stress over the plane i (0), or k (2) of a grid, over the sum of its absolute values.
double net_share(const VolumeGrid& g, const test::StressField& stress, int axis, int plane, Component component)
{
  double net = 0.0, absolute = 0.0;
  for (int k = axis == 2 ? plane : 0; k < (axis == 2 ? plane + 1 : g.nz); ++k)
    for (int j = 0; j < g.surface.ny; ++j)
      for (int i = axis == 0 ? plane : 0; i < (axis == 0 ? plane + 1 : g.surface.nx); ++i)
      {
        const double s = stress.at(g.index(i, j, k))[component];
        net += s;
        absolute += std::abs(s);
      }
  return net / absolute;
}

TEST(ResidualStress, LeavesNoForceOverAnyPlane)
{
  const simulation::BodySnapshot& body = body_after_a_pass();
  // A plane is cut off at the edge of the block. The stress falls with the third power of the distance, so the force
  // that is missed falls with the first: what counts is that it goes to zero with the size of the block.
  std::vector<double> vertical, horizontal;
  const int nz = body.grid.nz, nx = body.grid.surface.nx;
  const std::vector<int> margins = slow_build ? std::vector{0, 6} : std::vector{0, 10, 30};
  std::vector<double> reach; // half-width of the block over that of the first
  for (const int margin : margins)
  {
    VolumeGrid grid;
    const test::StressField stress = stress_on_block(body, margin, 1, grid);
    vertical.push_back(net_share(grid, stress, 0, margin + nx / 2, xx));
    horizontal.push_back(net_share(grid, stress, 2, nz / 3, zz));
    reach.push_back(static_cast<double>(grid.surface.ny) / body.grid.surface.ny);
  }
  for (std::size_t i = 0; i < reach.size(); ++i)
    std::printf("  block %.2f times as wide: sigma_xx %9.2e, sigma_zz %9.2e\n", reach[i], vertical[i], horizontal[i]);
  // The sum over a block that just holds the plastic zone is of the size of its parts.
  test::expect_close("net sigma_xx over the plane x = 0 / sum of its absolute values", vertical.back(), 0.0,
                     0.5 / reach.back(), "exact: equilibrium; block of finite size");
  test::expect_close("net sigma_zz over a horizontal plane / sum of its absolute values", horizontal.back(), 0.0,
                     0.5 / reach.back(), "exact: equilibrium; block of finite size");
  test::expect_within("order of the net sigma_xx in the size of the block",
                      std::log(std::abs(vertical.front() / vertical.back())) / std::log(reach.back() / reach.front()),
                      1.0, 1e9, "theory: >= 1");
}

TEST(ResidualStress, IsThatOfThePlasticStrainAlone)
{
  // The snapshot's stress has no contact in it any more, and does not depend on the size of the grid it is computed on.
  const simulation::BodySnapshot& body = body_after_a_pass();
  const int margin = 7;
  VolumeGrid grid;
  const test::StressField wide = stress_on_block(body, margin, 1, grid);
  double difference = 0.0, largest = 0.0;
  for (int k = 0; k < body.grid.nz; ++k)
    for (int j = 0; j < body.grid.surface.ny; ++j)
      for (int i = 0; i < body.grid.surface.nx; ++i)
      {
        const SymTensor s = wide.at(grid.index(i + margin, j + margin, k));
        for (std::size_t c = 0; c < 6; ++c)
        {
          const double here = body.stress[c][body.grid.index(i, j, k)];
          difference = std::max(difference, std::abs(here - s[c]));
          largest = std::max(largest, std::abs(here));
        }
      }
  // Smooth strain: 1e-4, to which the operator removes its periodic images. Where the strain jumps from cell to cell, the
  // shortest wavelength of the grid has no odd derivatives: of such a jump, half a part in the number of padded columns.
  test::expect_close("residual stress, own grid and wider grid / largest", difference / largest, 0.0,
                     1e-4 + 0.25 / body.grid.surface.nx, "exact: the same half space");
}

TEST(ResidualStress, VanishesTowardsTheSurface)
{
  // sigma_zz, sigma_yz and sigma_xz are zero on the surface; the first layer holds their mean over its thickness. Layers
  // cut into three and nine parts carry the same plastic strain and get closer to the surface. By equilibrium
  // d sigma_xz/dz = -(d sigma_xx/dx + d sigma_xy/dy): no more than two of the largest stress per cell; and
  // d sigma_zz/dz = 0 on the surface. So shear is first order in the thickness of the layer, sigma_zz second.
  const simulation::BodySnapshot& body = body_after_a_pass();
  constexpr std::array watched{zz, xz, yz};
  constexpr std::array names{"sigma_zz", "sigma_xz", "sigma_yz"};
  std::array<std::vector<double>, 3> shares;
  const std::vector<int> cuts{1, 3, 9};
  double depth = 0.0; // of the first layer's middle, in cells
  for (const int parts : cuts)
  {
    VolumeGrid grid;
    const test::StressField stress = stress_on_block(body, 0, parts, grid);
    std::array<double, 3> value{};
    double size = 0.0;
    for (std::size_t n = 0; n < grid.size(); ++n)
    {
      const SymTensor s = stress.at(n);
      size = std::max(size, std::abs(s[xx]));
      if (n < grid.surface.size())
        for (std::size_t c = 0; c < watched.size(); ++c)
          value[c] = std::max(value[c], std::abs(s[watched[c]]));
    }
    for (std::size_t c = 0; c < watched.size(); ++c)
      shares[c].push_back(value[c] / size);
    depth = 0.5 * grid.dz / grid.surface.dx;
  }
  for (std::size_t c = 0; c < watched.size(); ++c)
  {
    const std::string name = names[c];
    const bool normal = watched[c] == zz;
    test::expect_close(name + " in the thinnest first layer / largest sigma_xx", shares[c].back(), 0.0,
                       2.0 * (normal ? depth * depth : depth), "exact: free surface");
    test::expect_within(name + ": order in the thickness of the first layer",
                        test::Orders(names[c], shares[c], 3.0).last, normal ? 1.5 : 0.75, normal ? 2.5 : 1.25,
                        normal ? "theory: 2" : "theory: 1");
  }
}

TEST(ResidualStress, ObeysTheYieldConditionAndIsMirrorSymmetric)
{
  const simulation::BodySnapshot& body = body_after_a_pass();
  const VolumeGrid& g = body.grid;
  double worst = 0.0, asymmetry = 0.0, trace_of_strain = 0.0;
  for (int k = 0; k < g.nz; ++k)
    for (int j = 0; j < g.surface.ny; ++j)
      for (int i = 0; i < g.surface.nx; ++i)
      {
        const std::size_t n = g.index(i, j, k);
        const std::size_t mirror = g.index(i, g.surface.ny - 1 - j, k);
        SymTensor s{};
        for (std::size_t c = 0; c < 6; ++c)
          s[c] = body.stress[c][n];
        worst = std::max(worst, von_mises(s) / yield_stress);
        // Under y -> -y the components with one y change sign.
        for (const Component c : {xx, yy, zz, xz})
          asymmetry = std::max(asymmetry, std::abs(s[c] - body.stress[c][mirror]));
        for (const Component c : {yz, xy})
          asymmetry = std::max(asymmetry, std::abs(s[c] + body.stress[c][mirror]));
        trace_of_strain = std::max(trace_of_strain, std::abs(body.plastic_strain[xx][n] + body.plastic_strain[yy][n] +
                                                             body.plastic_strain[zz][n]));
      }
  test::expect_within("largest von Mises stress / yield stress", worst, 0.0, 1.0 + 2e-4,
                      "exact: yield condition, to the tolerance 1e-4 of the iteration and of the last one");
  test::expect_close("asymmetry in y / yield stress", asymmetry / yield_stress, 0.0, 1e-4,
                     "exact: symmetry, to the tolerance of the iteration");
  test::expect_close("trace of the plastic strain", trace_of_strain, 0.0, 1e-15, "exact: incompressible");
}

TEST(ResidualStress, AWidePatchOfUniformStrainIsAHeldLayer)
{
  // A layer of uniform plastic strain, much wider than thick: its stress in the middle is that of a plate which is kept from
  // straining in its plane, sigma_xx = -E/(1 - nu^2) (eps_xx + nu eps_yy), nothing acts on its faces, and beneath it nothing. The
  // edges act as line forces sigma t at half the width on both sides; a pair of long ones gives 8/pi t/W (Flamant).
  const double thickness = 1.0;
  std::vector<double> errors;
  const std::vector<int> widths{41, 81};
  for (const int n : widths)
  {
    const VolumeGrid grid{{n, n, 1.0, 1.0}, 6, 0.5 * thickness};
    std::vector<double> strain(Deviator::size * grid.size(), 0.0);
    constexpr std::array<double, Deviator::size> applied{1e-3, -0.4e-3, 0.0, 0.0, 0.5e-3};
    for (std::size_t c = 0; c < Deviator::size; ++c)
      for (std::size_t i = 0; i < 2 * grid.surface.size(); ++i) // two of the layers
        strain[c * grid.size() + i] = applied[c];
    const halfspace::HalfSpace half_space(grid, elastic);
    const test::StressField stress(half_space, {}, strain);
    const double E = elastic.young_modulus;
    const double nu = elastic.poisson_ratio;
    const double plate = -E / (1.0 - nu * nu);
    const SymTensor held{plate * (applied[0] + nu * applied[1]),
                         plate * (applied[1] + nu * applied[0]),
                         0.0,
                         0.0,
                         0.0,
                         -E / (1.0 + nu) * applied[4]};
    double error = 0.0;
    for (int k = 0; k < grid.nz; ++k)
      for (std::size_t c = 0; c < 6; ++c)
      {
        const double expected = k < 2 ? held[c] : 0.0;
        error = std::max(error, std::abs(stress.at(grid.index(n / 2, n / 2, k))[c] - expected));
      }
    errors.push_back(error / std::abs(held[0]));
    test::expect_close("held layer, width / thickness = " + std::to_string(n), errors.back(), 0.0,
                       8.0 / (std::numbers::pi * n), "analytic: plate held in its plane; edges");
  }
  test::expect_close("error, twice as wide / as wide", errors[1] / errors[0], 0.5, 0.1, "theory: thickness over width");
}

} // namespace
} // namespace brinell::verification::residual_stress_test
