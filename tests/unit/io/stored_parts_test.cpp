// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/feasibility.hpp"
#include "io/results/stored_parts.hpp"

#include <gtest/gtest.h>
#include <numeric>

/// The part of a state that is stored, on a made-up body whose field counts its cells.
namespace brinell::io::stored_parts_test
{

simulation::StepFields counted()
{
  simulation::StepFields fields;
  simulation::Snapshot& s = fields.surfaces;
  s.contact = {5, 4, 1.0, 2.0};
  s.x0 = -2.0;
  s.y0 = -3.0;
  const auto numbers = [](std::size_t size)
  {
    std::vector<double> values(size);
    std::iota(values.begin(), values.end(), 0.0);
    return values;
  };
  s.pressure = s.gap = s.shear[0] = s.slip_path = numbers(s.contact.size());
  for (simulation::BodySnapshot* body : {&s.lower, &s.upper})
  {
    body->grid = {{7, 4, 1.0, 2.0}, 3, 0.5};
    body->x0 = -3.0;
    body->y0 = -3.0;
    body->residual_displacement = numbers(body->grid.surface.size());
  }
  const auto within = [numbers, grid = s.lower.grid] { return LayeredFields(grid, {numbers(84)}); };
  fields.lower.equivalent_plastic_strain = fields.upper.equivalent_plastic_strain = within;
  fields.lower.stress =
      fields.upper.stress = [numbers, grid = s.lower.grid] { return LayeredFields(grid, std::vector(6, numbers(84))); };
  fields.are_alike = true;
  return fields;
}

TEST(StoredParts, AllIsEverything)
{
  const simulation::StepFields chosen = chosen_fields(counted(), {"all"}, {});
  EXPECT_EQ(chosen.surfaces.lower.residual_displacement.size(), 28u);
  EXPECT_EQ(chosen.lower.equivalent_plastic_strain().whole().size(), 84u);
  EXPECT_TRUE(chosen.lower.keeps_stress && chosen.lower.keeps_von_mises && chosen.are_alike);
}

TEST(StoredParts, FieldsAreChosenByTheirNames)
{
  const simulation::StepFields surface = chosen_fields(counted(), {"surface"}, {});
  EXPECT_FALSE(surface.lower.stress || surface.lower.equivalent_plastic_strain);
  EXPECT_EQ(surface.surfaces.shear[0].size(), 20u);
  StoredParts upper;
  upper.bodies = StoredBodies::upper;
  const simulation::StepFields one = chosen_fields(counted(), {"von_mises_stress"}, upper);
  EXPECT_TRUE(one.upper.stress && one.upper.keeps_von_mises && !one.upper.keeps_stress);
  EXPECT_FALSE(one.lower.stress || one.are_alike);
  EXPECT_TRUE(one.surfaces.shear[0].empty() && one.surfaces.slip_path.empty());
  EXPECT_EQ(one.surfaces.pressure.size(), 20u) << "always";
  EXPECT_TRUE(chooses({"shear"}, "shear_y") && chooses({"surface_temperature"}, "temperature_upper"));
  EXPECT_FALSE(chooses({"temperature"}, "temperature_upper") || chooses({"surface"}, "temperature"));
}

TEST(StoredParts, CellsAreCutOut)
{
  StoredParts parts;
  parts.cells = {.depth = 0.6, .region_x = {{-1.2, 2.0}}, .region_y = {{-1.0, -1.0}}};
  const simulation::StepFields chosen = chosen_fields(counted(), {"all"}, parts);
  const simulation::BodySnapshot& body = chosen.surfaces.lower;
  EXPECT_EQ(body.grid, (VolumeGrid{{4, 1, 1.0, 2.0}, 2, 0.5})) << "x = -1, 0, 1, 2; y = -1; layers 0 and 1";
  EXPECT_EQ(body.x0, -1.0);
  EXPECT_EQ(body.y0, -1.0);
  EXPECT_EQ(body.residual_displacement, (std::vector<double>{9, 10, 11, 12}));
  EXPECT_EQ(chosen.lower.equivalent_plastic_strain().whole(), (std::vector<double>{9, 10, 11, 12, 37, 38, 39, 40}));
  EXPECT_EQ(chosen.upper.stress().whole(5), chosen.lower.equivalent_plastic_strain().whole());
  EXPECT_EQ(chosen.surfaces.pressure.size(), 20u) << "the contact stays whole";
}

TEST(StoredParts, LayersAreCutOutAndLeftOut)
{
  StoredParts plane;
  plane.cells = {.region_x = {{0.0, 0.0}}, .region_y = {{-3.0, -3.0}}, .region_z = {{0.7, 0.7}}};
  const simulation::StepFields one = chosen_fields(counted(), {"all"}, plane);
  EXPECT_EQ(one.surfaces.lower.grid, (VolumeGrid{{1, 1, 1.0, 2.0}, 1, 0.5}));
  EXPECT_EQ(one.surfaces.lower.top, 0.5) << "the second layer, whose centre is at 0.75";
  EXPECT_EQ(one.lower.equivalent_plastic_strain().whole(), (std::vector<double>{28 + 3}));
  EXPECT_EQ(one.surfaces.lower.residual_displacement, (std::vector<double>{3})) << "the surface has no depth";
  StoredParts every_second;
  every_second.cells = {.region_x = {{0.0, 0.0}}, .region_y = {{-3.0, -3.0}}, .stride_z = 2};
  const simulation::StepFields two = chosen_fields(counted(), {"all"}, every_second);
  EXPECT_EQ(two.surfaces.upper.grid, (VolumeGrid{{1, 1, 1.0, 2.0}, 2, 1.0}));
  EXPECT_EQ(two.surfaces.upper.top + 0.5 * two.surfaces.upper.grid.dz, 0.25) << "centre of the first layer";
  EXPECT_EQ(two.upper.stress().whole(3), (std::vector<double>{3, 56 + 3}));
}

TEST(StoredParts, AStrideTakesTheSamePlacesOfContactAndBody)
{
  StoredParts parts;
  parts.cells.stride = 2;
  const simulation::StepFields chosen = chosen_fields(counted(), {"all"}, parts);
  const simulation::Snapshot& s = chosen.surfaces;
  EXPECT_EQ(s.lower.grid, (VolumeGrid{{3, 2, 2.0, 4.0}, 3, 0.5})) << "x = -2, 0, 2";
  EXPECT_EQ(s.lower.x0, -2.0);
  EXPECT_EQ(s.contact.nx, 3);
  EXPECT_EQ(s.x0, -2.0);
  EXPECT_EQ(s.y0, s.lower.y0);
  EXPECT_EQ(s.pressure, (std::vector<double>{0, 2, 4, 10, 12, 14}));
}

TEST(StoredParts, ARegionBesideTheBodyTakesItsNearestCells)
{
  StoredParts parts;
  parts.cells.region_x = {{50.0, 60.0}};
  const simulation::StepFields chosen = chosen_fields(counted(), {"all"}, parts);
  EXPECT_EQ(chosen.surfaces.lower.grid.surface.nx, 1);
  EXPECT_EQ(chosen.surfaces.lower.x0, 3.0);
}

} // namespace brinell::io::stored_parts_test
