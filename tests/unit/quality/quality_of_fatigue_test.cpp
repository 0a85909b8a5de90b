// SPDX-License-Identifier: BSD-3-Clause
#include "quality_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

/// Warnings about fatigue.
namespace brinell::quality::quality_of_fatigue_test
{
namespace
{

/// A second pass that has settled, with its worst point within the body.
FatigueSummary good_fatigue()
{
  FatigueSummary f;
  f.cycle = 2;
  f.plastic_strain = 1e-3;
  f.orthogonal_shear = {.value = 3e8, .x = 1e-5, .y = 0.0, .depth = 5e-5};
  f.utilisation = FatiguePlace{.value = 0.8, .x = 1e-5, .y = 0.0, .depth = 6e-5};
  f.share_of_first_layer = 0.05;
  f.path_error = 0.01;
  return f;
}

std::vector<Warning> warnings_of(std::size_t side, const std::function<void(FatigueSummary&)>& change)
{
  const RollingCase c = ball_on_flat();
  RunTotals t = good_totals(c);
  t.fatigue[side] = good_fatigue();
  change(*t.fatigue[side]);
  return quality::judged(c, plan(c), t).warnings;
}

/// Expects one warning, of which it returns the text.
std::string only_text(const std::vector<Warning>& warnings, const std::string& key)
{
  EXPECT_EQ(warnings.size(), 1u) << key;
  if (warnings.size() != 1)
    return {};
  EXPECT_EQ(warnings.front().key, key);
  return warnings.front().text;
}

TEST(Quality, AGoodFatigueHasNoWarnings)
{
  EXPECT_TRUE(warnings_of(0, [](FatigueSummary&) {}).empty());
  // An elastic body does not adapt.
  EXPECT_TRUE(warnings_of(0, [](FatigueSummary& f) { f.cycle = 1, f.plastic_strain = 0.0; }).empty());
}

TEST(Quality, FatigueOfTheFirstCycle)
{
  const auto warnings = warnings_of(1, [](FatigueSummary& f) { f.cycle = 1; });
  EXPECT_NE(only_text(warnings, "fatigue_first_cycle").find("the upper body"), std::string::npos);
}

TEST(Quality, TheWorstPointOfFatigueAtTheEdge)
{
  const auto of_criterion = warnings_of(0, [](FatigueSummary& f) { f.utilisation->is_at_edge = true; });
  EXPECT_NE(only_text(of_criterion, "fatigue_edge").find("x = 1e-05 m, y = 0 m, depth 6e-05 m"), std::string::npos)
      << of_criterion.front().text;
  const auto of_shear = warnings_of(0,
                                    [](FatigueSummary& f)
                                    {
                                      f.utilisation.reset();
                                      f.orthogonal_shear.is_at_edge = true;
                                    });
  EXPECT_NE(only_text(of_shear, "fatigue_edge").find("depth 5e-05 m"), std::string::npos);
  EXPECT_TRUE(warnings_of(0, [](FatigueSummary& f) { f.orthogonal_shear.is_at_edge = true; }).empty())
      << "the criterion counts, if there is one";
}

TEST(Quality, FatigueOfAShortPass)
{
  const auto warnings = warnings_of(0, [](FatigueSummary& f) { f.is_short = true; });
  EXPECT_NE(only_text(warnings, "fatigue_short_pass").find("no point of the lower body as a whole"), std::string::npos);
}

TEST(Quality, FatigueOfAPathWithGapsAndOfTheSurface)
{
  EXPECT_NE(only_text(warnings_of(0, [](FatigueSummary& f) { f.path_error = 0.08; }), "fatigue_path").find("0.08"),
            std::string::npos);
  EXPECT_EQ(
      only_text(warnings_of(0, [](FatigueSummary& f) { f.share_of_first_layer = 0.4; }), "fatigue_life_of_surface")
          .find("40 % of the stress-volume of the lower body"),
      0u);
}

TEST(Quality, FatigueOfATrackThatIsNoReferenceForItself)
{
  const auto long_life = [](bool is_own)
  {
    return [is_own](FatigueSummary& f)
    {
      f.life = 1.33;
      f.is_own_reference = is_own;
    };
  };
  EXPECT_NE(only_text(warnings_of(0, long_life(true)), "fatigue_reference").find("the life is 1.33"),
            std::string::npos);
  EXPECT_TRUE(warnings_of(0, long_life(false)).empty());
}

TEST(Quality, TheErrorOfTheOrthogonalShearIsOfSecondOrder)
{
  const auto error_of = [](double resolution)
  {
    RollingCase c = ball_on_flat();
    c.resolution = resolution;
    RunTotals t = good_totals(c);
    t.fatigue[0] = good_fatigue();
    const Quality q = quality::judged(c, plan(c), t);
    const auto found = std::ranges::find(q.resolution.expected_errors, "orthogonal shear", &ExpectedError::quantity);
    return found == q.resolution.expected_errors.end() ? 0.0
                                                       : found->relative * q.resolution.cells * q.resolution.cells;
  };
  EXPECT_GT(error_of(8.0), 0.0);
  EXPECT_NEAR(error_of(16.0), error_of(8.0), 1e-12);
}

} // namespace
} // namespace brinell::quality::quality_of_fatigue_test
