// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/increment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

/// Surfaces between the columns of a material grid.
namespace brinell::elastoplastic::interpolation_test
{
namespace
{

constexpr SurfaceGrid contact_grid{9, 5, 1.0, 1.0};
constexpr VolumeGrid body_grid{{31, 5, 1.0, 1.0}, 2, 1.0};
constexpr int column = 8;

const constitutive::Material soft{{1e3, 0.3}, {}};
const constitutive::Material rigid{{std::numeric_limits<double>::infinity(), 0.0}, {}};

/// Depth of the lower body's surface: a polynomial of the third degree in x.
double cubic(double x, int j)
{
  return 0.3 - 0.02 * x + 0.005 * x * x - 0.0007 * x * x * x + 0.1 * j;
}

CoupledContact pair()
{
  Textures textures;
  for (int j = 0; j < body_grid.surface.ny; ++j)
    for (int i = 0; i < body_grid.surface.nx; ++i)
      textures.lower.push_back(cubic(i, j));
  return {contact_grid, body_grid, body_grid, soft, rigid, Scales{1.0, 1.0}, Settings{}, Twin::none, textures};
}

TEST(InterpolationTest, CubicsAreExact)
{
  const CoupledContact contact = pair();
  std::vector<double> depth(contact_grid.size());
  for (const double fraction : {0.0, 0.25, 0.9})
  {
    std::fill(depth.begin(), depth.end(), 0.0);
    contact.add_depth(0, {column, fraction}, depth);
    for (int j = 0; j < contact_grid.ny; ++j)
      for (int i = 0; i < contact_grid.nx; ++i)
        EXPECT_NEAR(depth[contact_grid.index(i, j)], cubic(i + column + fraction, j), 1e-12);
  }
}

TEST(InterpolationTest, PressureIsCarriedBackByTheTranspose)
{
  CoupledContact contact = pair();
  // Press a ball on it, so that there is a pressure.
  std::vector<double> distance;
  for (int j = 0; j < contact_grid.ny; ++j)
    for (int i = 0; i < contact_grid.nx; ++i)
      distance.push_back(0.05 * ((i - 4) * (i - 4) + (j - 2) * (j - 2)));
  for (const double fraction : {0.0, 0.3})
  {
    const Place place{column, fraction};
    ASSERT_TRUE(
        contact.advance(distance, {contact::Drive::Kind::approach, 1.5}, {place, {column}}, Strategy{}).converged);
    std::vector<double> on_body;
    ASSERT_TRUE(spread_traction(contact.grid(), contact.pressure(), place, contact.lower().grid().surface, on_body));
    std::vector<double> depth(contact_grid.size());
    contact.add_depth(0, place, depth);
    const double on_contact = std::inner_product(depth.begin(), depth.end(), contact.pressure().begin(), 0.0);
    const double below = std::inner_product(on_body.begin(), on_body.end(), contact.lower().texture().begin(), 0.0);
    EXPECT_NEAR(below, on_contact, 1e-12 * std::abs(on_contact));
    const double load = std::accumulate(on_body.begin(), on_body.end(), 0.0);
    EXPECT_NEAR(load, contact.load(), 1e-12 * load) << "cells of unit area";
  }
}

TEST(InterpolationTest, PressureBeyondTheEndIsNoticed)
{
  CoupledContact contact = pair();
  const std::vector<double> distance(contact_grid.size(), 0.0);
  EXPECT_THROW(
      (void)contact.advance(distance, {contact::Drive::Kind::approach, 1.0}, {{25, 0.5}, {column}}, Strategy{}),
      InputError);
}

TEST(InterpolationTest, PressureAtTheEdgeIsNoticed)
{
  CoupledContact contact = pair();
  std::vector<double> distance(contact_grid.size(), 10.0);
  EXPECT_FALSE(contact.reaches_edge());
  distance[static_cast<std::size_t>(contact_grid.nx * 2 + contact_grid.nx - 1)] = 0.0;
  ASSERT_TRUE(
      contact.advance(distance, {contact::Drive::Kind::approach, 1.0}, {{column}, {column}}, Strategy{}).converged);
  EXPECT_TRUE(contact.reaches_edge());
}

} // namespace
} // namespace brinell::elastoplastic::interpolation_test
