// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <type_traits>

/// The fields on surfaces of a snapshot, in one table, from which follow the result file, its choices and size, ParaView and
/// Python. A new field is a new line here; those of effects come from `elastoplastic::effect_fields`.
namespace brinell::simulation
{

/// Value of a field in a picture where it was not computed but is not zero.
inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A field on a surface.
struct SurfaceField
{
  const char *name, *unit, *text;
  double elsewhere = 0.0; ///< value outside its grid
  /// Word for that which must act for the field to exist: "friction", "heat", "texture", "strain", or the name of an effect;
  /// empty: it always exists.
  std::string_view needs{};
  const char* word = name;     ///< by which an output chooses it, alone or with others
  bool lowers_surface = false; ///< a depth by which the surface lies deeper than before
};

/// A field on a surface, and its values in a snapshot; an empty one does not exist there.
template <typename Values>
struct FieldOf : SurfaceField
{
  Values* values;
};

namespace detail
{

template <typename Owner>
using ValuesIn = std::conditional_t<std::is_const_v<Owner>, const std::vector<double>, std::vector<double>>;

constexpr std::size_t effects_on(elastoplastic::EffectField::On on)
{
  const auto& all = elastoplastic::effect_fields;
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [=](const elastoplastic::EffectField& field) { return field.on == on; }));
}

/// Appends the fields of effects that lie on a kind of grid.
template <elastoplastic::EffectField::On on, typename Owner, std::size_t own>
auto joined(const std::array<FieldOf<ValuesIn<Owner>>, own>& fields, Owner& owner)
{
  std::array<FieldOf<ValuesIn<Owner>>, own + effects_on(on)> all{};
  auto next = std::copy(fields.begin(), fields.end(), all.begin());
  for (std::size_t i = 0; i < owner.of_effects.size(); ++i)
    if (const elastoplastic::EffectField& field = elastoplastic::effect_fields[i]; field.on == on)
      *next++ = {{field.name, field.unit, field.text, 0.0, field.effect, field.name, field.lowers_surface},
                 &owner.of_effects[i]};
  return all;
}

} // namespace detail

/// Fields on the contact grid.
template <typename S>
requires std::is_same_v<std::remove_const_t<S>, Snapshot>
[[nodiscard]] auto surface_fields(S& s)
{
  using Field = FieldOf<detail::ValuesIn<S>>;
  const std::array own{
      Field{{"pressure", "Pa", "contact pressure, compression positive"}, &s.pressure},
      Field{{"gap", "m", "gap between the deformed surfaces", unknown}, &s.gap},
      Field{{"shear_x", "Pa", "shear on the lower body along x", 0.0, "friction", "shear"}, &s.shear[0]},
      Field{{"shear_y", "Pa", "shear on the lower body along y", 0.0, "friction", "shear"}, &s.shear[1]},
      Field{{"slip_x", "m", "slip of the upper surface over the lower one since the start, along x", 0.0, "friction",
             "slip"},
            &s.slip[0]},
      Field{{"slip_y", "m", "slip of the upper surface over the lower one since the start, along y", 0.0, "friction",
             "slip"},
            &s.slip[1]},
      Field{{"slip_path", "m", "length of the way slipped since the start", 0.0, "friction", "slip"}, &s.slip_path},
      Field{{"friction_heat", "J/m^2", "heat of friction since the start", 0.0, "friction"}, &s.friction_heat},
      Field{{"temperature_lower", "degC", "temperature of the lower surface", unknown, "heat", "surface_temperature"},
            &s.temperature[0]},
      Field{{"temperature_upper", "degC", "temperature of the upper surface", unknown, "heat", "surface_temperature"},
            &s.temperature[1]},
      Field{{"heat_flux_lower", "W/m^2", "heat of friction into the lower body", 0.0, "heat", "heat_flux"},
            &s.heat_flux[0]},
      Field{{"heat_flux_upper", "W/m^2", "heat of friction into the upper body", 0.0, "heat", "heat_flux"},
            &s.heat_flux[1]},
  };
  return detail::joined<elastoplastic::EffectField::On::contact>(own, s);
}

/// Fields on the surface of a body.
template <typename B>
requires std::is_same_v<std::remove_const_t<B>, BodySnapshot>
[[nodiscard]] auto surface_fields(B& body)
{
  using Field = FieldOf<detail::ValuesIn<B>>;
  const std::array own{
      Field{{"residual_displacement", "m", "residual displacement of the surface, into the body", unknown, "strain"},
            &body.residual_displacement},
      Field{
          {"height", "m", "height of the surface as it is now, with its texture, out of the body", unknown, "texture"},
          &body.height},
  };
  return detail::joined<elastoplastic::EffectField::On::bodies>(own, body);
}

} // namespace brinell::simulation
