// SPDX-License-Identifier: BSD-3-Clause
// Wear by a law that a user gives as a function of pressure and shear.
#include "brinell/elastoplastic/increment.hpp"
#include "brinell/foundation/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <string>
#include <vector>

namespace brinell::elastoplastic::user_wear_test
{
namespace
{

constexpr double radius = 1e-3, load = 1.0, modulus = 100e9; // of a rigid ball, and E' of the flat
constexpr double rigid = std::numeric_limits<double>::infinity();

/// Radius of the contact by Hertz [m], and its largest pressure [Pa].
double hertz_radius(double contact_modulus = modulus)
{
  return std::cbrt(0.75 * load * radius / contact_modulus);
}
double peak_pressure()
{
  return 1.5 * load / (std::numbers::pi * hertz_radius() * hertz_radius());
}

/// A rigid ball on an elastic flat, both of which may wear; the contact rests on both.
class Pair
{
public:
  /// @param cells  on the radius `of_area`
  Pair(const Sliding& sliding, int cells, double of_area = hertz_radius(), double contact_modulus = modulus)
      : grid_{2 * cells + 5, 2 * cells + 5, of_area / cells, of_area / cells},
        contact_(grid_, {grid_, 1, grid_.dx}, {grid_, 1, grid_.dx}, {{contact_modulus, 0.0}, {}}, {{rigid, 0.0}, {}},
                 {1e-7, 1e-7}, Settings{.contact_tolerance = 1e-9}, Twin::none, {}, 0.0, sliding),
        ball_(grid_.size())
  {
    for (int j = 0; j < grid_.ny; ++j)
      for (int i = 0; i < grid_.nx; ++i)
        ball_[grid_.index(i, j)] = (grid_.x(i) * grid_.x(i) + grid_.y(j) * grid_.y(j)) / (2.0 * radius);
  }

  IncrementReport advance(double slid, double shift = 0.0)
  {
    const contact::TangentialDrive along{{contact::TangentialDrive::Kind::shift, shift}, {}, 0.0};
    return contact_.advance(ball_, {contact::Drive::Kind::load, load}, {}, {},
                            {.along = along, .slides = slid > 0.0, .slid = slid});
  }
  [[nodiscard]] const SurfaceGrid& grid() const { return grid_; }
  [[nodiscard]] const CoupledContact& contact() const { return contact_; }
  [[nodiscard]] const Wear& wear() const { return static_cast<const Wear&>(*contact_.effects().front()); }

private:
  SurfaceGrid grid_;
  CoupledContact contact_;
  std::vector<double> ball_;
};

WearLaw law(double lower, double upper, const UserWear::Intensity& intensity)
{
  return {.lower = lower, .upper = upper, .kind = WearLaw::Kind::user, .function = UserWear(intensity)};
}

/// Wear in proportion to the square of the pressure: intensity p^2/peak_pressure.
double square(double pressure, double /*shear*/)
{
  return pressure * pressure / peak_pressure();
}

TEST(UserWear, RefusesWhatIsNoIntensity)
{
  for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN(), rigid})
    try
    {
      const UserWear wear([bad](double p, double) { return p > 1e6 ? bad : p; });
      ADD_FAILURE() << bad;
    }
    catch (const InputError& error)
    {
      const std::string message = error.what();
      EXPECT_NE(message.find("Pa at the pressure 1e+07 Pa and the shear 0 Pa; allowed: >= 0, finite"),
                std::string::npos)
          << message;
    }
  EXPECT_THROW(UserWear(UserWear::Intensity{}), InputError);
}

// Between the sampled pressures: noticed where it is used, with the state before the increment.
TEST(UserWear, RefusesAnIntensityInARun)
{
  Pair pair({.effects = {.wear = law(1e-13, 0.0, [](double p, double) { return p > 1.1e8 && p < 0.9e9 ? -p : p; })}},
            6);
  ASSERT_TRUE(pair.advance(0.0).converged);
  const std::vector<double> before(pair.contact().pressure().begin(), pair.contact().pressure().end());
  EXPECT_THROW(static_cast<void>(pair.advance(1e-6)), InputError);
  EXPECT_TRUE(std::ranges::equal(pair.contact().pressure(), before));
  EXPECT_EQ(pair.wear().volume(0), 0.0);
}

TEST(UserWear, EqualsOnlyItsCopies)
{
  const UserWear one(square), other(square);
  const UserWear copy = one;
  EXPECT_EQ(one, copy);
  EXPECT_NE(one, other);
  EXPECT_EQ(UserWear{}, UserWear{});
}

// The laws of the list, given as functions, with and without friction and where the surfaces may stick.
TEST(UserWear, GivesTheLawsOfTheListAgain)
{
  struct Case
  {
    WearLaw::Kind kind;
    double friction;
    bool sticks;
  };
  using Kind = WearLaw::Kind;
  for (const Case& c : {Case{Kind::archard, 0.0, false},
                        {Kind::archard, 0.3, false},
                        {Kind::archard, 0.3, true},
                        {Kind::energy, 0.3, false},
                        {Kind::energy, 0.3, true}})
  {
    const WearLaw listed{.lower = 2e-13, .upper = 1e-13, .kind = c.kind};
    const WearLaw given = law(2e-13, 1e-13, [&](double p, double q) { return c.kind == Kind::archard ? p : q; });
    Sliding sliding{.friction = {.coefficient = c.friction}, .sticks = c.sticks, .effects = {.wear = listed}};
    Pair expected(sliding, 6);
    sliding.effects.wear = given;
    Pair found(sliding, 6);
    for (int step = 0; step < 4; ++step)
    {
      const double way = step == 0 ? 0.0 : 2e-6; // pressed first; a shift of this length lets the rim slip
      const double shift = c.sticks ? 2e-2 * way : way;
      ASSERT_TRUE(expected.advance(way, shift).converged);
      ASSERT_TRUE(found.advance(way, shift).converged);
    }
    ASSERT_GT(expected.wear().largest_depth(0), 0.0);
    // The gap is solved to 1e-9 of 1e-7 m; the slip per displacement of the surface is of the order of one.
    for (const std::size_t side : {0U, 1U})
      EXPECT_NEAR(found.wear().volume(side) / expected.wear().volume(side), 1.0, 1e-6) << c.friction << c.sticks;
  }
}

// So little wear that the pressure stays Hertz': the integral of p^2 over the circle is p0^2 pi a^2/2.
TEST(UserWear, OfTheSquareOfHertzPressure)
{
  constexpr double coefficient = 1e-18, way = 1e-6;
  std::vector<double> errors;
  for (const int cells : {8, 16, 32})
  {
    Pair pair({.effects = {.wear = law(coefficient, 3.0 * coefficient, square)}}, cells);
    ASSERT_TRUE(pair.advance(0.0).converged);
    ASSERT_TRUE(pair.advance(way).converged);
    const std::span<const double> p = pair.contact().pressure();
    const double sum = std::inner_product(p.begin(), p.end(), p.begin(), 0.0) * pair.grid().cell_area();
    EXPECT_NEAR(pair.wear().volume(0) / (coefficient * way * sum / peak_pressure()), 1.0, 1e-6);
    EXPECT_NEAR(pair.wear().volume(1) / pair.wear().volume(0), 3.0, 1e-9);
    const double exact = 0.5 * coefficient * way * peak_pressure() * std::numbers::pi * hertz_radius() * hertz_radius();
    errors.push_back(std::abs(pair.wear().volume(0) / exact - 1.0));
    std::printf("  volume worn by the square of Hertz' pressure, %2d cells per radius: %+.5f\n", cells,
                pair.wear().volume(0) / exact - 1.0);
  }
  EXPECT_LT(errors.back(), 2e-3); // the edge of the contact falls on cells, where p^2 vanishes linearly
}

/// Depth of the scar over that of a cap that is cut off by a stiff flat. On its area 2 pi R h the pressure is even, so that
/// dh/ds = k F^2/(p0 (2 pi R h)^2) and h^3 = 3 k F^2 s/(p0 (2 pi R)^2).
double depth_of_scar(int steps)
{
  constexpr double scar = 0.1e-3, way = 1e-3, final_ratio = 5.0;
  const double depth = 0.5 * scar * scar / radius;
  const double per_area = load / (2.0 * std::numbers::pi * radius);
  const double coefficient = std::pow(depth, 3) * peak_pressure() / (3.0 * per_area * per_area * way);
  const double stiff = 0.75 * load * radius / std::pow(scar / final_ratio, 3);
  Pair pair({.effects = {.wear = law(0.0, coefficient, square)}}, 8, scar, stiff);
  EXPECT_TRUE(pair.advance(0.0).converged);
  for (int step = 1; step <= steps; ++step) // by equal parts of the depth
    EXPECT_TRUE(pair.advance(way * (std::pow(step, 3) - std::pow(step - 1, 3)) / std::pow(steps, 3)).converged) << step;
  return pair.wear().largest_depth(1) / depth;
}

// The flat gives way by about (8/3) (a_Hertz/a)^3 of the depth, 2 %; backward Euler errs by the share of a step.
TEST(UserWear, OfABallOnAStiffFlatIsACapCutOff)
{
  for (const int steps : {20, 40})
  {
    const double found = depth_of_scar(steps);
    std::printf("  depth of the scar over that of the cap, %d steps: %.4f\n", steps, found);
    EXPECT_NEAR(found, 1.0, 8.0 / 3.0 / 125.0 + 1.0 / steps);
  }
}

} // namespace
} // namespace brinell::elastoplastic::user_wear_test
