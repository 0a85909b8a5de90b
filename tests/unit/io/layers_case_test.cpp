// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/case_file.hpp"
#include "sample.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

/// Layers of coated bodies as they stand in a case file.
namespace brinell::io::layers_case_test
{
namespace
{

using constitutive::Coat;

constexpr const char* hard = R"({thickness="1.925 mm", young_modulus="400 GPa", poisson_ratio=0.2})";

std::string layers(const std::string& tables)
{
  return "lower.material.layers=" + tables;
}

TEST(LayersCase, AListFromTheSurfaceDownIsRead)
{
  const Case c = sample::parsed(
      {layers(std::string("[") + hard + R"(, {thickness="3.85 mm", young_modulus="80 GPa", poisson_ratio=0.35, )" +
              R"(hardening={law="table", plastic_strain=[0, 0.1], stress=["1 GPa", "2 GPa"]}}])")});
  const std::vector<Coat> expected{
      {1.925e-3, {400e9, 0.2}, {}},
      {3.85e-3, {80e9, 0.35}, constitutive::HardeningLaw(constitutive::TabulatedHardening({0.0, 0.1}, {1e9, 2e9}))}};
  EXPECT_EQ(sample::tugging(c).lower.material.layers, expected);
}

TEST(LayersCase, TheResolvedCaseGivesThemBack)
{
  const Case c = sample::parsed({layers(
      std::string("[") + hard +
      R"(, {thickness="3.85 mm", young_modulus="80 GPa", poisson_ratio=0.35, hardening={law="perfect", yield_stress=1e9}}])")});
  const Case again = parse_case(resolved_text(c.values), "resolved.toml", {});
  EXPECT_EQ(sample::tugging(again).lower.material, sample::tugging(c).lower.material);
}

TEST(LayersCase, CoatedBodiesMaySlideWithFriction)
{
  const Case c = sample::parsed({layers(std::string("[") + hard + "]"), "interface.friction=0.1"});
  EXPECT_EQ(sample::tugging(c).friction.coefficient, 0.1);
}

TEST(LayersCase, LayersConduct)
{
  const std::string conducts = R"(lower.material.electrical={resistivity="4e-8 ohm m", temperature_coefficient=4e-3})";
  const std::string plated = layers(
      R"([{thickness="1.925 mm", young_modulus="80 GPa", poisson_ratio=0.4, hardening={law="perfect", yield_stress=1e9}, )"
      R"(electrical={resistivity="3e-8 ohm m", temperature_coefficient="3e-3 1/K"}}])");
  const Case c = sample::parsed({conducts, plated});
  const constitutive::Material& material = sample::tugging(c).lower.material;
  EXPECT_EQ(material.layers.front().electrical, (constitutive::Electrical{3e-8, 3e-3}));
  EXPECT_EQ(material.conductors(), (ConductiveStack{{{1.925e-3, 3e-8}}, 4e-8})); // at 20 degC
  const Case again = parse_case(resolved_text(c.values), "resolved.toml", {});
  EXPECT_EQ(sample::tugging(again).lower.material, material);

  sample::expect_message({conducts, layers(std::string("[") + hard + "]")},
                         "lower.material.layers[0].electrical.resistivity is missing: the lower body conducts");
  sample::expect_message({plated},
                         "lower.material.layers[0].electrical.resistivity = 3e-08 ohm m, but the lower body insulates");
  sample::expect_message({conducts, plated, "upper.material.electrical={resistivity=4e-8}",
                          "interface.film_resistance=1e-12", "interface.current=1"},
                         "the heat of a film on layers is not computed");
}

TEST(LayersCase, LayersHaveThermalConstants)
{
  const std::string thermal =
      R"(lower.material.thermal={conductivity=50, density=7800, specific_heat=470, expansion=12e-6})";
  const std::string hot = R"(thermal={conductivity=2, density=2200, specific_heat=900, expansion=2e-6})";
  const auto coated = [&](const std::string& more)
  { return layers(R"([{thickness="1.925 mm", young_modulus="80 GPa", poisson_ratio=0.4, )" + more + "}]"); };
  const std::string upper =
      R"(upper.material.thermal={conductivity=50, density=7800, specific_heat=470, expansion=12e-6})";
  const std::vector<std::string> rubs{"interface.friction=0.1", "tugging.speed=1", upper};
  const auto with = [&](std::vector<std::string> lines)
  {
    lines.insert(lines.end(), rubs.begin(), rubs.end());
    return lines;
  };
  const std::string no_work = "thermal.heat_of_plastic_work=0";
  const Case c = sample::parsed(with({thermal, coated(hot), no_work}));
  const constitutive::Material& material = sample::tugging(c).lower.material;
  EXPECT_EQ(material.layers.front().thermal, (Thermal{2.0, 2200.0, 900.0, 2e-6}));
  EXPECT_EQ(material.thermal_stack(),
            (ThermalStack{{{1.925e-3, {2.0, 2200.0, 900.0, 2e-6}}}, {50.0, 7800.0, 470.0, 12e-6}}));
  const Case again = parse_case(resolved_text(c.values), "resolved.toml", {});
  EXPECT_EQ(sample::tugging(again).lower.material, material);

  sample::expect_message(with({thermal, coated("thermal={conductivity=2}"), no_work}),
                         "lower.material.layers[0].thermal.density is missing");
  sample::expect_message(with({thermal, coated("thermal={conductivity=-2}"), no_work}),
                         "lower.material.layers[0].thermal.conductivity = -2");
  sample::expect_message(with({thermal, coated("hardening={law=\"none\"}"), no_work}),
                         "lower.material.layers[0].thermal is missing: the lower body has thermal constants");
  sample::expect_message({coated(hot)}, "lower.material.layers[0].thermal, but lower.material.thermal is missing");
  sample::expect_message(with({thermal, coated(hot)}), "thermal.heat_of_plastic_work = 0.9 and lower.material.layers");
  sample::expect_message(with({thermal, coated(hot), no_work, "thermal.regime=\"steady\"", "thermal.reference=1"}),
                         "the steady heat of coated bodies is not computed");
}

TEST(LayersCase, ErrorsNameTheLayer)
{
  sample::expect_message({layers(R"([{thickness="1.925 mm", poisson_ratio=0.2}])")},
                         "layers[0].young_modulus is missing; allowed: pressure > 0");
  sample::expect_message({layers(R"([{thickness="1.925 mm", young_modulus=4e11, poisson_ratio=0.5}])")},
                         "layers[0].poisson_ratio");
  sample::expect_message({layers(R"([{thickness="2 GPa", young_modulus=4e11, poisson_ratio=0.2}])")},
                         "layers[0].thickness = \"2 GPa\" is a pressure");
  sample::expect_message({R"(grid.spacing=["3.85 mm", "7.7 mm", "1 mm"])",
                          layers(R"([{thickness="1 mm", young_modulus=4e11, poisson_ratio=0.2}])")},
                         "lower.material.layers: the first layer is 0.001 m thick on cells of 0.0077 m");
}

} // namespace
} // namespace brinell::io::layers_case_test
