// SPDX-License-Identifier: BSD-3-Clause
// A rigid ball pressed into coated flats that yield, and taken off: against finite elements (tools/oracles/coated_indentation.py).
#include "brinell/simulation/indentation.hpp"
#include "brinell/simulation/run.hpp"
#include "oracle_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>

namespace brinell::verification::coated_indentation_test
{
namespace
{

using constitutive::Material, constitutive::LinearHardening;
using simulation::IndentationCase;

constexpr double radius = 50e-6, thickness = 1e-6;

struct Pressed
{
  Material flat;
  double approach; ///< [m]
};

/// The cases of the oracle.
std::map<std::string, Pressed> pressed()
{
  const Elastic steel{210e9, 0.3}, hard{400e9, 0.2}, soft{80e9, 0.35};
  const auto on = [](const Elastic& elastic, double yield, double modulus, const constitutive::Coat& coat) -> Material
  {
    Material material{elastic, LinearHardening{yield, modulus}};
    material.layers = {coat};
    return material;
  };
  const LinearHardening of_steel{2e9, 20e9}, of_hard{8e9, 20e9}, of_soft{0.8e9, 4e9};
  return {{"plain", {on(steel, 2e9, 20e9, {thickness, steel, of_steel}), 0.3e-6}},
          {"hard", {on(steel, 2e9, 20e9, {thickness, hard, of_hard}), 0.3e-6}},
          {"soft", {on(steel, 4e9, 20e9, {thickness, soft, of_soft}), 0.15e-6}},
          {"elastic", {on(steel, 1.5e9, 10e9, {thickness, hard, {}}), 0.3e-6}}};
}

/// The columns of the oracle.
using Numbers = std::map<std::string, double>;

Numbers computed(const Pressed& body, int cells_per_radius)
{
  IndentationCase c;
  c.lower = {simulation::Plane{}, body.flat};
  c.upper = {simulation::Paraboloid{radius, radius}, Material{{std::numeric_limits<double>::infinity(), 0.0}, {}}};
  const double a = std::sqrt(radius * body.approach), cell = a / cells_per_radius;
  c.spacing = {cell, cell, thickness / std::round(2.0 * thickness / cell)};
  c.sequence = {{contact::Drive::Kind::approach, body.approach}, {contact::Drive::Kind::load, 0.0}};
  c.steps = 16;
  simulation::Run<IndentationCase> run(c);
  simulation::finish(run);
  const simulation::Indent indent = run.summary().indents.front();
  Numbers found{{"load_N", indent.max_load},
                {"contact_radius_m", std::sqrt(indent.contact_area / std::numbers::pi)},
                {"depth_m", indent.residual_depth},
                {"pile_up_m", indent.pile_up}};
  const simulation::StepFields fields = run.fields();
  const VolumeGrid& grid = fields.surfaces.lower.grid;
  const std::vector<double> strain = fields.lower.equivalent_plastic_strain().whole();
  for (std::size_t n = 0; n < strain.size(); ++n)
  {
    const double depth = (static_cast<double>(n / grid.surface.size()) + 0.5) * grid.dz;
    const std::string part = depth < thickness ? "coat" : "substrate";
    found["amount_" + part + "_m3"] += strain[n] * grid.cell_volume();
  }
  return found;
}

TEST(CoatedIndentation, IsThatOfFiniteElements)
{
  const test::OracleTable oracle("coated_indentation_oracle.csv");
  const std::map<std::string, Pressed> bodies = pressed();
  for (std::size_t row = 0; row < oracle.size(); ++row)
  {
    const std::string& name = oracle.text(row, "case");
    const Numbers found = computed(bodies.at(name), 10);
    for (const auto& [column, within] : std::map<std::string, double>{{"load_N", 0.01},
                                                                      {"contact_radius_m", 0.03},
                                                                      {"depth_m", 0.01},
                                                                      {"pile_up_m", 0.08},
                                                                      {"amount_coat_m3", 0.02},
                                                                      {"amount_substrate_m3", 0.02}})
    {
      const double expected = oracle.number(row, column), value = found.at(column);
      std::printf("%-8s %-20s %12.5e, finite elements %12.5e, %5.2f %%\n", name.c_str(), column.c_str(), value,
                  expected, expected == 0.0 ? 0.0 : 100.0 * (value / expected - 1.0));
      EXPECT_NEAR(value, expected, within * expected) << name << ", " << column;
    }
  }
}

} // namespace
} // namespace brinell::verification::coated_indentation_test
