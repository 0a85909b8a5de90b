// SPDX-License-Identifier: BSD-3-Clause
// Coated bodies that friction heats, in the scenarios: layers of the substrate's constants are the body without layers, and the heat
// and the work of all forces are found in the bodies.
#include "brinell/io/case_file.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace brinell::verification::coated_heat_test
{
namespace
{

constexpr const char* steel_heat =
    R"(thermal = {conductivity = 50, density = "7800 kg/m^3", specific_heat = 470, expansion = "12e-6 1/K"})";
constexpr const char* carbon_heat =
    R"(thermal = {conductivity = 2, density = "2200 kg/m^3", specific_heat = 900, expansion = "2e-6 1/K"})";
constexpr const char* gold_heat =
    R"(thermal = {conductivity = 318, density = "19300 kg/m^3", specific_heat = 129, expansion = "14e-6 1/K"})";
constexpr const char* law = R"(hardening = {law = "linear", yield_stress = "1 GPa", modulus = "5 GPa"})";

struct Sample
{
  const char* text;      ///< a case without the material of its lower body
  const char* thickness; ///< of a layer
};

// With 3, 4 and 2 layers of cells in the layer.
constexpr Sample samples[] = {{R"(scenario = "rolling"
lower.shape = {type = "flat"}
rolling = {load = "600 N", distance = "0.3 mm", slide_to_roll = 0.5, speed = "2 m/s"}
grid = {spacing = ["50 um", "50 um", "30 um"]}
interface.friction = 0.2
thermal.heat_of_plastic_work = 0
[upper]
shape = {type = "sphere", radius = "10 mm"}
)",
                               "90 um"},
                              {R"(scenario = "tugging"
lower.shape = {type = "sphere", radius = "100 um"}
tugging = {interference = 4, speed = "1 m/s"}
grid.spacing = ["400 nm", "400 nm", "200 nm"]
interface.friction = 0.2
thermal.heat_of_plastic_work = 0
[upper]
shape = {type = "sphere", radius = "100 um"}
)",
                               "800 nm"},
                              {R"(scenario = "sliding"
lower.shape = {type = "flat"}
lower.texture = {type = "sinusoid", amplitude = "0.4 um", wavelength_x = "80 um", wavelength_y = "80 um"}
sliding = {mean_gap = "0.3 um", distance = "40 um", speed = "1 m/s"}
grid = {boundary = "periodic", size = ["80 um", "80 um"], spacing = ["5 um", "5 um", "3 um"]}
interface.friction = 0.2
thermal.heat_of_plastic_work = 0
[upper]
shape = {type = "flat"}
texture = {type = "sinusoid", amplitude = "0.4 um", wavelength_x = "80 um", wavelength_y = "80 um"}
)",
                               "6 um"}};

std::string case_of(const Sample& sample, const std::string& layer)
{
  std::string text = sample.text;
  text += std::string("material = {young_modulus = \"300 GPa\", poisson_ratio = 0.2, ") + steel_heat + "}\n";
  text += std::string("[lower.material]\nyoung_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n") + law + "\n" + steel_heat;
  if (!layer.empty())
    text += std::string("\nlayers = [{thickness = \"") + sample.thickness + "\", " + layer + ", " + law + "}]";
  return text + "\n";
}

struct Course
{
  std::vector<double> forces, temperatures, heats;
  double energy_balance = 0.0, heat_balance = 0.0;
};

Course course_of(const std::string& text)
{
  const io::Case c = io::parse_case(text, "case.toml", {});
  return std::visit(
      [](const auto& scenario)
      {
        Course course;
        const auto run = computed(scenario);
        double heated = 0.0;
        for (const auto& r : run.history)
        {
          for (const double value : {r.F_n, r.max_pressure, r.contact_area, r.dissipation_lower})
            course.forces.push_back(value);
          if constexpr (requires { r.max_temperature_lower; })
          {
            course.temperatures.push_back(r.max_temperature_lower);
            course.temperatures.push_back(r.max_temperature_upper);
            course.heats.push_back(r.heat_lower);
            course.heats.push_back(r.heat_upper);
            heated = r.dissipation_friction;
          }
        }
        course.energy_balance = run.summary.energy_balance_error;
        course.heat_balance =
            heated > 0.0 ? (course.heats[course.heats.size() - 2] + course.heats.back()) / heated - 1.0 : 1.0;
        return course;
      },
      c.scenario);
}

double largest(const std::vector<double>& values)
{
  double result = 0.0;
  for (const double value : values)
    result = std::max(result, std::abs(value));
  return result;
}

TEST(CoatedHeat, LayerOfTheSubstrateIsTheHomogeneousBody)
{
  for (const Sample& sample : samples)
  {
    const Course plain = course_of(case_of(sample, "")),
                 layered = course_of(
                     case_of(sample, std::string("young_modulus = \"210 GPa\", poisson_ratio = 0.3, ") + steel_heat));
    ASSERT_EQ(layered.forces.size(), plain.forces.size());
    ASSERT_GT(largest(plain.temperatures), 25.0); // the bulk has 20 degC
    // Thermal displacement and stress are sums over other waves, right to 1e-4; temperatures on the surface depend on them only.
    double of_forces = 0.0, of_temperatures = 0.0, of_heats = 0.0;
    for (std::size_t i = 0; i < plain.forces.size(); ++i)
      of_forces = std::max(of_forces, std::abs(layered.forces[i] / (plain.forces[i] != 0.0 ? plain.forces[i] : 1.0) -
                                               (plain.forces[i] != 0.0 ? 1.0 : 0.0)));
    for (std::size_t i = 0; i < plain.temperatures.size(); ++i)
    {
      of_temperatures = std::max(of_temperatures, std::abs(layered.temperatures[i] - plain.temperatures[i]));
      of_heats = std::max(of_heats, std::abs(layered.heats[i] - plain.heats[i]));
    }
    std::printf("layer of the substrate: forces %.1e, temperatures %.1e, heats %.1e\n", of_forces,
                of_temperatures / largest(plain.temperatures), of_heats / largest(plain.heats));
    EXPECT_LT(of_forces, 3e-4);
    EXPECT_LT(of_temperatures, 3e-4 * largest(plain.temperatures));
    EXPECT_LT(of_heats, 3e-4 * largest(plain.heats));
  }
}

TEST(CoatedHeat, HeatAndWorkAreFoundInTheBodies)
{
  for (const Sample& sample : samples)
  {
    const Course bare = course_of(case_of(sample, ""));
    for (const auto& [name, heat] : {std::pair{"insulating", carbon_heat}, {"conducting", gold_heat}})
    {
      const Course coated =
          course_of(case_of(sample, std::string("young_modulus = \"150 GPa\", poisson_ratio = 0.25, ") + heat));
      std::printf("%s layer: %.0f degC instead of %.0f degC, balance of heat %.1e, of energy %.1e\n", name,
                  largest(coated.temperatures), largest(bare.temperatures), coated.heat_balance, coated.energy_balance);
      EXPECT_LT(std::abs(coated.heat_balance), 1e-3);
      EXPECT_LT(std::abs(coated.energy_balance), 5e-3);
      if (heat == carbon_heat)
        EXPECT_GT(largest(coated.temperatures), largest(bare.temperatures));
      else
        EXPECT_LT(largest(coated.temperatures), largest(bare.temperatures));
    }
  }
}

} // namespace
} // namespace brinell::verification::coated_heat_test
