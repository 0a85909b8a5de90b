// SPDX-License-Identifier: BSD-3-Clause
#include "body_options.hpp"

#include <numbers>

namespace brinell::io
{

namespace
{

using constitutive::HardeningLaw;
using simulation::Shape;
using simulation::Texture;
using Number = const double*;

constexpr double degree = std::numbers::pi / 180.0;

/// Makes a product from the parameters at the given places.
template <typename Product, typename Struct, std::size_t... Place>
Product product_of(Number x)
{
  return Struct{x[Place]...};
}

} // namespace

const std::vector<Option<Shape>>& shape_options()
{
  using namespace simulation;
  static const std::vector<Option<Shape>> options{
      {"sphere", {"radius"}, product_of<Shape, Paraboloid, 0, 0>},
      {"ellipsoid", {"radius_x", "radius_y"}, product_of<Shape, Paraboloid, 0, 1>},
      {"cylinder", {"radius", "length"}, product_of<Shape, Roller, 0, 1>},
      {"cone",
       {"half_angle", "tip_radius"},
       [](Number x) -> Shape {
         return Cone{x[0] * degree, x[1]};
       }},
      {"vickers",
       {"tip_radius"},
       [](Number x) -> Shape {
         return Pyramid{4, 68.0 * degree, x[0]};
       }},
      {"berkovich",
       {"tip_radius"},
       [](Number x) -> Shape {
         return Pyramid{3, 65.27 * degree, x[0]};
       }},
      {"flat", {}, product_of<Shape, Plane>},
  };
  return options;
}

const std::vector<Option<Texture>>& texture_options()
{
  using namespace simulation;
  static const std::vector<Option<Texture>> options{
      {"smooth", {}, [](Number) { return Texture{}; }},
      {"dent", {"x", "y", "depth", "edge_radius"}, product_of<Texture, Dent, 0, 1, 2, 3>, "ville1999"},
      {"bump",
       {"x", "y", "height", "edge_radius"},
       [](Number x) -> Texture {
         return Dent{x[0], x[1], -x[2], x[3]};
       },
       "ville1999"},
      {"height_map", {"x", "y"}},
      {"sinusoid",
       {"amplitude", "wavelength_x", "wavelength_y", "x", "y"},
       product_of<Texture, Sinusoid, 0, 1, 2, 3, 4>},
      {"random", {"hurst", "rms_height", "rms_slope", "rolloff", "cutoff", "size", "seed"}, nullptr, "jacobs2017"},
  };
  return options;
}

const std::vector<Option<HardeningLaw>>& law_options()
{
  using namespace constitutive;
  const std::vector<std::string> power{"coefficient", "offset", "exponent"};
  const std::vector<std::string> power_from_yield{"yield_stress", "coefficient", "exponent"};
  static const std::vector<Option<HardeningLaw>> options{
      {"perfect", {"yield_stress"}, product_of<HardeningLaw, PerfectPlasticity, 0>},
      {"linear", {"yield_stress", "modulus"}, product_of<HardeningLaw, LinearHardening, 0, 1>},
      {"swift", power, product_of<HardeningLaw, SwiftHardening, 0, 1, 2>, "swift1952"},
      {"swift_microstrain", power, [](Number x) -> HardeningLaw { return swift_of_microstrain(x[0], x[1], x[2]); },
       "swift1952"},
      {"hollomon", power_from_yield, [](Number x) -> HardeningLaw { return hollomon(x[0], x[1], x[2]); },
       "hollomon1945"},
      {"ludwik", power_from_yield, product_of<HardeningLaw, LudwikHardening, 0, 1, 2>, "ludwik1909"},
      {"voce", {"yield_stress", "saturation", "rate"}, product_of<HardeningLaw, VoceHardening, 0, 1, 2>, "voce1948"},
      {"table", {}},
  };
  return options;
}

} // namespace brinell::io
