// SPDX-License-Identifier: BSD-3-Clause
// Films between bodies that conduct, and softening by the heat of a current.
#include "conducting_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace brinell::simulation::film_test
{
namespace
{

using conducting_cases::ball, conducting_cases::bronze, conducting_cases::conducting, conducting_cases::hot_fretting,
    conducting_cases::rows_of;

TEST(Film, OnOneBodyMakesNoTwins)
{
  IndentationCase c = ball();
  c.lower.material.hardening = constitutive::LinearHardening{300e6, 2e9};
  c.lower.material.electrical = bronze;
  c.upper.material = c.lower.material;
  EXPECT_NE(plan(c).twin, elastoplastic::Twin::none);
  c.current.film.resistivity = 1.0;
  c.lower.film = HeightMap{.nx = 1, .ny = 1, .dx = 1e-4, .dy = 1e-4, .heights = {1e-9}};
  EXPECT_EQ(plan(c).twin, elastoplastic::Twin::none);
}

TEST(Film, GrowsWithTheSlipPath)
{
  // Where all of the contact slips, each cell gains the growth times the path of its points.
  FrettingCase c = hot_fretting();
  for (constitutive::Material* material : {&c.lower.material, &c.upper.material})
    material->thermal.reset();
  c.current = {.voltage = {0.05}, .film = {.growth = 1e-6, .limit = 1.0}};
  const auto rows = rows_of(c);
  const FrettingRecord& end = rows.back();
  EXPECT_GT(end.film_resistance, 0.1 * 1e-6 * end.slip_path);
  EXPECT_LT(end.film_resistance, 1e-6 * end.slip_path * (1.0 + 1e-12));
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (rows[i].cycle > 1)
    {
      EXPECT_GE(rows[i].contact_resistance, rows[i - 1].contact_resistance) << i;
    }
  c.current.film.limit = 0.5 * end.film_resistance;
  EXPECT_LE(rows_of(c).back().film_resistance, *c.current.film.limit * (1.0 + 1e-12));
  // Wear takes away what grew.
  c.current.film = {.resistance = 1e-11, .wear = 1e-3};
  c.wear = {.lower = 1e-12, .upper = 1e-12};
  const auto worn = rows_of(c);
  EXPECT_LT(worn.back().film_resistance, 1e-11);
  EXPECT_GE(worn.back().film_resistance, 0.0);
}

TEST(Film, IsAUniformCover)
{
  IndentationCase c = ball();
  c.current = {.voltage = {0.05}, .film = {.resistance = 2e-12}};
  const auto film = rows_of(c);
  c.current = {.voltage = {0.05}, .film = {.resistivity = 1e-3}};
  c.lower.film =
      HeightMap{.nx = 2, .ny = 2, .dx = 1.0, .dy = 1.0, .heights = {1.5e-9, 1.5e-9, 1.5e-9, 1.5e-9}, .periodic = true};
  c.upper.film =
      HeightMap{.nx = 2, .ny = 2, .dx = 1.0, .dy = 1.0, .heights = {0.5e-9, 0.5e-9, 0.5e-9, 0.5e-9}, .periodic = true};
  const auto cover = rows_of(c);
  ASSERT_EQ(film.size(), cover.size());
  for (std::size_t i = 0; i < film.size(); ++i)
  {
    if (std::isfinite(film[i].contact_resistance))
    {
      EXPECT_NEAR(cover[i].contact_resistance, film[i].contact_resistance, 1e-9 * film[i].contact_resistance) << i;
    }
    EXPECT_NEAR(cover[i].film_resistance, film[i].film_resistance, 1e-9 * film[i].film_resistance) << i;
  }
}

TEST(Film, MovesWithItsSurface)
{
  // A body that rolls over a patch of a film: the resistance is that of the clean contact before and after, and rises between.
  RollingCase c = conducting<RollingCase>();
  for (constitutive::Material* material : {&c.lower.material, &c.upper.material})
    material->hardening.reset();
  c.current = {.voltage = {0.01}};
  const auto clean = rows_of(c);
  const double a = plan(c).contact.dx * 8.0;
  c.current.film.resistivity = 1e-2;
  c.lower.film = HeightMap{.nx = 9, .ny = 9, .dx = a / 8.0, .dy = a / 8.0, .heights = std::vector<double>(81, 1e-8)};
  const auto patched = rows_of(c);
  double most = 0.0;
  ASSERT_EQ(clean.size(), patched.size());
  const auto rows_under_load = [](const auto& rows)
  {
    return static_cast<std::size_t>(
        std::count_if(rows.begin(), rows.end(), [](const auto& row) { return std::isfinite(row.contact_resistance); }));
  };
  for (std::size_t i = 1; i < rows_under_load(clean); ++i)
  {
    EXPECT_GE(patched[i].contact_resistance, clean[i].contact_resistance * (1.0 - 1e-6)) << i;
    most = std::max(most, patched[i].contact_resistance / clean[i].contact_resistance);
  }
  const std::size_t last = rows_under_load(clean) - 1; // the patch has left the contact
  EXPECT_NEAR(patched[last].contact_resistance, clean[last].contact_resistance, 1e-6 * clean[last].contact_resistance);
  EXPECT_GT(most, 1.05);
}

TEST(SpotHeat, SoftensTheBodiesUnderAFilm)
{
  IndentationCase c = ball();
  c.lower.material.hardening = constitutive::LinearHardening{300e6, 2e9};
  c.lower.material.softening = constitutive::LinearSoftening{.reference = 20.0, .melting_point = 1000.0};
  c.sequence = {{contact::Drive::Kind::load, 20.0}};
  const auto strain = [&](double voltage, double film)
  {
    c.current = {.voltage = {voltage}, .film = {.resistance = film}};
    return rows_of(c).back().max_equivalent_plastic_strain;
  };
  const double cold = strain(0.0, 1e-12), clean = strain(0.2, 0.0), filmed = strain(0.2, 1e-14);
  EXPECT_GT(clean, 1.2 * cold);
  EXPECT_NEAR(filmed, clean, 0.05 * (clean - cold)); // a thin film changes little
}

TEST(SpotHeat, SoftensTheBodies)
{
  IndentationCase c = ball();
  c.lower.material.hardening = constitutive::LinearHardening{300e6, 2e9};
  c.lower.material.softening = constitutive::LinearSoftening{.reference = 20.0, .melting_point = 1000.0};
  c.sequence = {{contact::Drive::Kind::load, 20.0}};
  c.current = {.voltage = {0.0}};
  const auto cold = rows_of(c);
  c.current = {.voltage = {0.2}};
  const auto hot = rows_of(c);
  c.current = {};
  c.lower.material.electrical.reset();
  const auto plain = rows_of(c);
  ASSERT_EQ(cold.size(), hot.size());
  for (std::size_t i = 0; i < cold.size(); ++i)
  {
    EXPECT_EQ(cold[i].max_equivalent_plastic_strain, plain[i].max_equivalent_plastic_strain) << i;
    EXPECT_EQ(cold[i].work, plain[i].work) << i;
  }
  EXPECT_GT(hot.back().max_equivalent_plastic_strain, 1.2 * cold.back().max_equivalent_plastic_strain);
  EXPECT_GT(hot.back().dissipation_lower, cold.back().dissipation_lower);
}

} // namespace
} // namespace brinell::simulation::film_test
