// SPDX-License-Identifier: BSD-3-Clause
#include "judgement_parts.hpp"

#include "brinell/green/stack.hpp"
#include "green/stack_heat.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

/// Warnings about layers on the bodies.
namespace brinell::quality
{

namespace
{

/// A stack without what lies above a depth, which is in its first layer.
template <typename Stack>
Stack without_top(Stack stack, double depth)
{
  stack.layers.front().thickness -= depth;
  return stack;
}

/// Temperature of the surface by a wave of flux that has acted for long, or for about a time.
double warming(const ThermalStack& stack, double k, double time)
{
  const double kappa = stack.slowest().diffusivity();
  return green::StackHeat(stack, k, {kappa * k * k + 1.0 / time, 0.0}, kappa).at_surface().real();
}

/// By how much the surface of a body whose first layer has become thinner gives way, warms and resists a current more or less, in
/// words; empty if all of it is less than is noticed.
std::string changes_by_wear(const Facts& facts, const constitutive::Material& material, double worn)
{
  constexpr double noticed = 0.01, long_waves = 0.1; // the pressure changes by less
  const double half = std::max(facts.half_x, facts.is_plane ? 0.0 : facts.half_y),
               cell = facts.is_plane ? facts.cell[0] : std::min(facts.cell[0], facts.cell[1]);
  const double k_least = long_waves / half, k_largest = std::numbers::pi / cell;
  std::vector<std::string> words;
  const auto tell = [&](double change, const char* text)
  {
    if (std::abs(change) > noticed)
      words.push_back(
          fmt::format("{} by up to {} {}", text, percent_text(std::abs(change)), change > 0.0 ? "more" : "less"));
  };
  const ElasticStack elastic = material.stack();
  tell(green::change_of_compliance(elastic, without_top(elastic, worn), k_least, k_largest), "gives way");
  if (material.thermal && facts.is_heated)
  {
    const ThermalStack thermal = material.thermal_stack(), thinner = without_top(thermal, worn);
    double change = 0.0;
    for (const double time : {std::numeric_limits<double>::infinity(),
                              facts.heating_time.value_or(std::numeric_limits<double>::infinity())})
    {
      const auto of = [time](const ThermalStack& stack)
      { return [&stack, time](double k) { return warming(stack, k, time); }; };
      const double now = green::largest_change(of(thermal), of(thinner), k_least, k_largest);
      change = std::abs(now) > std::abs(change) ? now : change;
    }
    tell(change, "warms");
  }
  if (material.electrical)
  {
    const ConductiveStack conductors = material.conductors();
    const ElasticStack before = in_shear(conductors), after = in_shear(without_top(conductors, worn));
    const auto of = [](const ElasticStack& stack)
    { return [&stack](double k) { return green::StackWave(stack, k).compliance().across; }; };
    tell(green::largest_change(of(before), of(after), k_least, k_largest), "resists a current");
  }
  return fmt::format("{}", fmt::join(words, ", and "));
}

} // namespace

bool warn_of_coats(const Facts& facts, std::vector<Warning>& warnings)
{
  constexpr double least_cells = 4.0;
  bool found = false;
  for (std::size_t side = 0; side < 2; ++side)
  {
    const constitutive::Material& material = *facts.materials[side];
    for (std::size_t coat = 0; coat < material.layers.size() && material.is_plastic(); ++coat)
      if (const double cells = material.layers[coat].thickness / facts.cell[2]; cells < 0.999 * least_cells)
      {
        found = true;
        warnings.push_back(
            {"coarse_coat",
             fmt::format("layer {} of the {} body is {} thick, {:.2g} layers of cells; its {} is coarse with less than "
                         "{:g}, and no expected errors are stated: use thinner cells (grid.resolution)",
                         coat + 1, side == 0 ? "lower" : "upper", length_text(material.layers[coat].thickness), cells,
                         material.layers[coat].hardening ? "plastic strain" : "stress", least_cells)});
      }
  }
  return found;
}

void warn_of_worn_coats(const Facts& facts, const simulation::RunTotals& totals, std::vector<Warning>& warnings)
{
  const std::array worn{totals.max_worn_depth_lower, totals.max_worn_depth_upper};
  for (std::size_t side = 0; side < 2; ++side)
  {
    const constitutive::Material& material = *facts.materials[side];
    if (material.layers.empty() || worn[side] == 0.0)
      continue;
    const std::string name = side == 0 ? "lower" : "upper", depth = length_text(worn[side]);
    if (worn[side] >= material.layers.front().thickness)
    {
      warnings.push_back(
          {"worn_through", fmt::format("the {} surface has lost up to {}, and its first layer is {} thick: it is worn "
                                       "through, and nothing that is computed since then holds",
                                       name, depth, length_text(material.layers.front().thickness))});
      continue;
    }
    const std::string changes = changes_by_wear(facts, material, worn[side]);
    if (!changes.empty())
      warnings.push_back(
          {"worn_coat",
           fmt::format("the {} surface has lost up to {}, {} of its first layer, but the layers keep "
                       "their thickness: the worn body {} than it is computed",
                       name, depth, percent_text(worn[side] / material.layers.front().thickness), changes)});
  }
}

} // namespace brinell::quality
