// SPDX-License-Identifier: BSD-3-Clause
// A wear law of one's own: only pressure beyond a threshold wears. A ball slides to and fro on steel, once by Archard's law and
// once by this one. docs/developer/wear-laws.md shows this program and its output.
#include <brinell/simulation/run.hpp>

#include <algorithm>
#include <cstdio>

using namespace brinell;
using elastoplastic::UserWear;
using elastoplastic::WearLaw;

int main()
{
  simulation::SlidingCase ball_on_flat;
  ball_on_flat.lower = {simulation::Plane{}, {{210e9, 0.3}, {}}};
  ball_on_flat.upper = {simulation::Paraboloid{5e-3, 5e-3}, {{600e9, 0.2}, {}}};
  ball_on_flat.press = {contact::Drive::Kind::load, 10.0};
  ball_on_flat.friction.coefficient = 0.2;
  ball_on_flat.distance = 100e-6;
  ball_on_flat.strokes = 2;
  ball_on_flat.to_and_fro = true;
  ball_on_flat.resolution = 5.0;

  const WearLaw archard{.lower = 1e-14, .upper = 1e-14};
  WearLaw own = archard;
  own.kind = WearLaw::Kind::user;
  own.function = UserWear([](double pressure, double /*shear*/) { return std::max(0.0, pressure - 500e6); });

  for (const WearLaw& law : {archard, own})
  {
    ball_on_flat.wear = law;
    const simulation::SlidingSummary s = run(ball_on_flat);
    std::printf("%-9s  the ball loses %6.1f um^3, up to %5.1f nm; the track %6.1f um^3\n",
                law.kind == WearLaw::Kind::archard ? "Archard" : "threshold", 1e18 * s.worn_volume_upper,
                1e9 * s.max_worn_depth_upper, 1e18 * s.worn_volume_lower);
  }
}
