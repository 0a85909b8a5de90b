// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/symmetry.hpp"
#include "brinell/halfspace/thermal_field.hpp"
#include "grid_fields.hpp"
#include "heated_body.hpp"
#include "mirrored_grid.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

/// Heat that was stored, or gone back to, goes on to the last digit as if nothing had happened.
namespace brinell::halfspace::stored_heat_test
{
namespace
{

using test::Field;

struct Kept
{
  SurfaceGrid grid;
  HeatedLayers heated;
};

class StoredHeat : public testing::TestWithParam<Kept>
{
protected:
  static constexpr double duration = 0.3;

  [[nodiscard]] static ThermalField make()
  {
    return {GetParam().grid,         test::heated_body,  test::heated_elastic, {0.1, 8.0},
            {0.05, 0.15, 0.25, 0.6}, HeatImages::coarse, GetParam().heated};
  }

  [[nodiscard]] static Field flux(unsigned seed)
  {
    Field result = test::random_field(GetParam().grid.size(), seed);
    if (GetParam().grid.is_mirrored_y)
      complete_in_y(GetParam().grid, 1.0, result.data(), result.size());
    return result;
  }

  /// A step as a body takes it: heat in its layers, the flux that is expected, and what it really was.
  /// @param before  receives the heat before the step
  static void step(ThermalField& field, unsigned n, const HeatMotion& motion, Hidden<ThermalField::Heat>& before)
  {
    if (const HeatedLayers& heated = GetParam().heated; heated.count > 0)
    {
      Field heat;
      for (int k = 0; k < heated.count; ++k)
        for (const double value : flux(100 + 10 * n + static_cast<unsigned>(k)))
          heat.push_back(value);
      field.add_heat_in_body(heat, motion.duration);
    }
    field.add_step(flux(n), motion, before);
    field.add_to_last_step(flux(n + 50), motion);
  }

  [[nodiscard]] static ThermalField stored(ThermalField& field)
  {
    Archive archive;
    field.exchange(archive);
    ThermalField result = make();
    Archive taken(std::move(archive).fields());
    result.exchange(taken);
    return result;
  }

  /// Everything that can be asked, one number after the other.
  [[nodiscard]] static Field all_of(const ThermalField& field)
  {
    Field all;
    const std::size_t cells = field.grid().size();
    const auto add = [&](const Field& values) { all.insert(all.end(), values.begin(), values.end()); };
    for (const double later : {duration, 0.0, 1.5 * duration})
    {
      Field x(cells), y(cells), z(cells);
      field.displacement({z, x, y}, later);
      for (const Field* part : {&x, &y, &z})
        add(*part);
      if (later > 0.0)
        field.remaining_temperature(later, x);
      add(x);
    }
    Field temperature(cells), deviator(Deviator::size * cells), trace(cells);
    for (std::size_t layer = 0; layer < field.depths().size(); ++layer)
    {
      field.layer(layer, {temperature, deviator, trace});
      for (const Field* part : {&temperature, &deviator, &trace})
        add(*part);
    }
    return all;
  }
};

TEST_P(StoredHeat, GoesOnAsIfItHadNotBeenStored)
{
  const HeatMotion usual{duration, 0.2}, faster{duration, 0.5}, shorter{0.5 * duration, 0.2};
  auto before = make().heat();
  ThermalField field = make();
  unsigned n = 1;
  for (const HeatMotion& motion : {usual, usual, faster, shorter, usual, usual})
  {
    step(field, n++, motion, before);
    ThermalField other = stored(field);
    EXPECT_TRUE(all_of(other) == all_of(field)) << "after step " << n;
    for (const HeatMotion& next : {motion, usual})
    {
      step(field, n, next, before);
      step(other, n, next, before);
      EXPECT_TRUE(all_of(other) == all_of(field)) << "after step " << n << " and one more";
      field = stored(other);
    }
  }
}

TEST_P(StoredHeat, IsTheSameAfterAStepThatFailed)
{
  const HeatMotion usual{duration, 0.2}, other{0.5 * duration, 0.7};
  ThermalField field = make(), failing = make();
  auto before = field.heat(), kept = field.heat();
  for (unsigned n = 1; n < 4; ++n)
  {
    for (const HeatMotion& motion : {other, usual})
    {
      if (GetParam().heated.count > 0)
        failing.add_heat_in_body(Field(static_cast<std::size_t>(GetParam().heated.count) * GetParam().grid.size(), 1.0),
                                 motion.duration);
      failing.add_step(flux(80 + n), motion, kept);
      failing.restore(kept);
      if (GetParam().heated.count > 0)
        failing.restore_heat_in_body();
      if (n > 1)
      {
        EXPECT_TRUE(all_of(failing) == all_of(field)) << "before step " << n;
      }
    }
    step(field, n, usual, before);
    step(failing, n, usual, kept);
    EXPECT_TRUE(all_of(failing) == all_of(field)) << "after step " << n;
  }
}

constexpr auto open = Boundary::open;
constexpr auto periodic = Boundary::periodic;
INSTANTIATE_TEST_SUITE_P(All, StoredHeat,
                         testing::Values(Kept{{40, 9, 0.1, 0.1, open, open}, {}},
                                         Kept{test::mirrored(SurfaceGrid{40, 9, 0.1, 0.1, open, open}), {2, 0.1}},
                                         Kept{test::mirrored(SurfaceGrid{13, 7, 0.1, 0.1, open, open}), {}},
                                         Kept{{13, 7, 0.1, 0.1, open, open}, {3, 0.1}},
                                         Kept{test::mirrored(SurfaceGrid{12, 9, 0.1, 0.1, open, periodic}), {2, 0.1}},
                                         Kept{{8, 6, 0.1, 0.1, periodic, periodic}, {2, 0.1}}));

} // namespace
} // namespace brinell::halfspace::stored_heat_test
