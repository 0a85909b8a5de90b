// SPDX-License-Identifier: BSD-3-Clause
// Coated bodies that slide with friction, in the scenarios: layers of the substrate's material are the body without layers, and
// the work of all forces is dissipated or stored.
#include "brinell/io/case_file.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace brinell::verification::coated_sliding_test
{
namespace
{

struct Sample
{
  const char* text;                       ///< a case without the material of its lower body
  const char *thickness, *young, *coated; ///< of two layers: of the substrate's constants, and softer or harder
};

// With 3, 3 and 1 layers of cells in each layer.
constexpr Sample samples[] = {{R"(scenario = "rolling"
lower.shape = {type = "flat"}
upper = {shape = {type = "sphere", radius = "10 mm"}, material = {young_modulus = "300 GPa", poisson_ratio = 0.2}}
rolling = {load = "600 N", distance = "0.3 mm", slide_to_roll = 0.5}
grid = {spacing = ["50 um", "50 um", "30 um"]}
interface.friction = 0.3
)",
                               "90 um", "210 GPa", "300 GPa"},
                              {R"(scenario = "tugging"
lower.shape = {type = "sphere", radius = "10 um"}
upper = {shape = {type = "sphere", radius = "10 um"}, material = {young_modulus = "300 GPa", poisson_ratio = 0.2}}
tugging.interference = 4
grid.spacing = ["40 nm", "40 nm", "20 nm"]
interface.friction = 0.3
)",
                               "60 nm", "210 GPa", "120 GPa"},
                              {R"(scenario = "sliding"
lower.shape = {type = "flat"}
lower.texture = {type = "sinusoid", amplitude = "0.4 um", wavelength_x = "80 um", wavelength_y = "80 um"}
upper = {shape = {type = "flat"}, texture = {type = "sinusoid", amplitude = "0.4 um", wavelength_x = "80 um", wavelength_y = "80 um"}, material = {young_modulus = "300 GPa", poisson_ratio = 0.2}}
sliding = {mean_gap = "0.3 um", distance = "40 um"}
grid = {boundary = "periodic", size = ["80 um", "80 um"], spacing = ["5 um", "5 um", "3 um"]}
interface.friction = 0.3
)",
                               "3 um", "210 GPa", "400 GPa"}};

constexpr const char* law = R"(hardening = {law = "linear", yield_stress = "1 GPa", modulus = "5 GPa"})";

std::string material(const std::string& layers)
{
  return std::string("lower.material = {young_modulus = \"210 GPa\", poisson_ratio = 0.3, ") + law + layers + "}\n";
}

std::string two_layers(const std::string& thickness, const std::string& young)
{
  const std::string one =
      "{thickness = \"" + thickness + "\", young_modulus = \"" + young + "\", poisson_ratio = 0.3, " + law + "}";
  return ", layers = [" + one + ", " + one + "]";
}

/// Forces, energies and strain of each step.
struct Course
{
  std::vector<double> values;
  double balance = 0.0; ///< of energy, over what the bodies took up

  void add(double value) { values.push_back(value); }
};

Course course_of(const std::string& text)
{
  const io::Case c = io::parse_case(text, "case.toml", {});
  return std::visit(
      [](const auto& scenario)
      {
        Course course;
        const auto run = computed(scenario);
        for (const auto& r : run.history)
          for (const double value : {r.F_n, r.max_pressure, r.contact_area, r.energy_elastic, r.dissipation_lower,
                                     r.energy_residual, r.max_residual_lower, r.max_equivalent_plastic_strain})
            course.add(value);
        if constexpr (requires { run.history.back().F_friction; })
          for (const auto& r : run.history)
            course.add(r.F_friction);
        course.balance = run.summary.energy_balance_error;
        return course;
      },
      c.scenario);
}

TEST(CoatedScenarios, LayersOfTheSubstrateAreTheHomogeneousBody)
{
  for (const Sample& sample : samples)
  {
    const Course plain = course_of(sample.text + material("")),
                 layered = course_of(sample.text + material(two_layers(sample.thickness, sample.young)));
    ASSERT_EQ(layered.values.size(), plain.values.size());
    for (std::size_t i = 0; i < plain.values.size(); ++i)
      ASSERT_NEAR(layered.values[i], plain.values[i], 1e-9 * std::abs(plain.values[i])) << sample.text << i;
  }
}

TEST(CoatedScenarios, TheWorkIsDissipatedOrStored)
{
  for (const Sample& sample : samples)
  {
    const Course course = course_of(sample.text + material(two_layers(sample.thickness, sample.coated)));
    EXPECT_LT(std::abs(course.balance), 5e-3) << sample.text;
    EXPECT_NE(course.balance, 0.0);
  }
}

} // namespace
} // namespace brinell::verification::coated_sliding_test
