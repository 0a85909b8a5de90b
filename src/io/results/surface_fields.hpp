// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

/// The fields on surfaces in a result file. A new field is a new line here.
namespace brinell::io
{

/// Value of a field in /VTKHDF where it was not computed but is not zero.
inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct SurfaceField
{
  const char* name;
  const std::vector<double>& values; ///< empty: it has no dataset
  const char *unit, *text;
  double elsewhere = 0.0; ///< value in /VTKHDF outside its grid
};

/// Fields on the contact grid.
[[nodiscard]] inline std::array<SurfaceField, 13> surface_fields(const simulation::Snapshot& s)
{
  return {{
      {"pressure", s.pressure, "Pa", "contact pressure, compression positive"},
      {"gap", s.gap, "m", "gap between the deformed surfaces", unknown},
      {"shear_x", s.shear[0], "Pa", "shear on the lower body along x"},
      {"shear_y", s.shear[1], "Pa", "shear on the lower body along y"},
      {"slip_x", s.slip[0], "m", "slip of the upper surface over the lower one since the start, along x"},
      {"slip_y", s.slip[1], "m", "slip of the upper surface over the lower one since the start, along y"},
      {"slip_path", s.slip_path, "m", "length of the way slipped since the start"},
      {"friction_heat", s.friction_heat, "J/m^2", "heat of friction since the start"},
      {"temperature_lower", s.temperature[0], "degC", "temperature of the lower surface", unknown},
      {"temperature_upper", s.temperature[1], "degC", "temperature of the upper surface", unknown},
      {"heat_flux_lower", s.heat_flux[0], "W/m^2", "heat of friction into the lower body"},
      {"heat_flux_upper", s.heat_flux[1], "W/m^2", "heat of friction into the upper body"},
      {"current_density", s.current_density, "A/m^2", "density of the electric current, mean over each cell"},
  }};
}

/// Fields on the surface of a body.
[[nodiscard]] inline std::array<SurfaceField, 3> surface_fields(const simulation::BodySnapshot& body)
{
  return {{
      {"residual_displacement", body.residual_displacement, "m", "residual displacement of the surface, into the body",
       unknown},
      {"worn_depth", body.worn_depth, "m", "depth that the surface has lost by wear since the start"},
      {"height", body.height, "m", "height of the surface as it is now, with its texture, out of the body", unknown},
  }};
}

/// Which fields on a surface exist, in the order of `surface_fields`.
template <typename Owner>
struct FieldsThere : std::array<bool, std::tuple_size_v<decltype(surface_fields(Owner()))>>
{
  FieldsThere() : FieldsThere::array{} {}
  explicit FieldsThere(const Owner& owner)
  {
    std::ranges::transform(surface_fields(owner), this->begin(),
                           [](const SurfaceField& field) { return !field.values.empty(); });
  }
  [[nodiscard]] bool any() const { return std::ranges::count(*this, true) > 0; }

  [[nodiscard]] bool has(std::string_view name) const
  {
    bool is_there = false;
    for_each([&](const SurfaceField& field) { is_there = is_there || field.name == name; });
    return is_there;
  }

  /// Calls an action with the name and further properties of each field that exists, not with its values.
  template <typename Action>
  void for_each(const Action& action) const
  {
    const Owner none;
    const auto fields = surface_fields(none);
    for (std::size_t i = 0; i < fields.size(); ++i)
      if ((*this)[i])
        action(fields[i]);
  }

  void exchange(Archive& archive)
  {
    for (std::size_t i = 0; i < this->size(); ++i)
      archive(std::to_string(i), (*this)[i]);
  }
};

} // namespace brinell::io
