// SPDX-License-Identifier: BSD-3-Clause
#include "fatigue_parts.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace brinell::io
{

namespace
{

using simulation::FatiguePlace;
using simulation::FatigueSummary;

constexpr std::array body_names{"lower", "upper"};
constexpr std::array shakedown_names{"elastic", "elastic_shakedown", "plastic_shakedown", "ratchetting"};

Json place_json(const FatiguePlace& place, const char* value)
{
  return {{value, place.value}, {"x_m", place.x}, {"y_m", place.y}, {"depth_m", place.depth}};
}

Json number_or_null(double number)
{
  return std::isnan(number) ? Json(nullptr) : Json(number);
}

Json body_json(const FatigueSummary& s)
{
  Json json = {{"cycle", s.cycle},
               {"columns_m", Json::array({s.first_column, s.last_column})},
               {"orthogonal_shear", place_json(s.orthogonal_shear, "value_Pa")},
               {"principal_shear", place_json(s.principal_shear, "value_Pa")},
               {"utilisation", s.utilisation ? place_json(*s.utilisation, "value") : Json(nullptr)},
               {"plastic_strain", s.plastic_strain},
               {"ratchetting", s.ratchetting},
               {"shakedown", shakedown_names[static_cast<std::size_t>(s.worst())]},
               {"stress_volume", number_or_null(s.stress_volume)},
               {"life", number_or_null(s.life)},
               {"share_of_first_layer", s.share_of_first_layer},
               {"judged_share", s.judged_share},
               {"path_error", s.path_error}};
  for (std::size_t n = 0; n < shakedown_names.size(); ++n)
    json["shares"][shakedown_names[n]] = s.shares[n];
  return json;
}

std::string worst_text(const FatiguePlace& place)
{
  return fmt::format("at x = {:.4g} m, y = {:.4g} m, depth {:.4g} m", place.x, place.y, place.depth);
}

} // namespace

void put_fatigue(Json& json, const Case& c, const simulation::RunTotals& s)
{
  for (std::size_t side = 0; side < 2; ++side)
    if (const std::optional<FatigueSummary>& body = s.fatigue[side])
    {
      Json& part = json["fatigue"][body_names[side]] = body_json(*body);
      part["criterion"] = c.values.get<std::string>(fmt::format("{}.material.fatigue.criterion", body_names[side]));
    }
}

std::string fatigue_text(const simulation::RunTotals& s)
{
  std::string text;
  for (std::size_t side = 0; side < 2; ++side)
    if (const std::optional<FatigueSummary>& body = s.fatigue[side])
    {
      text += fmt::format("fatigue   {} body, cycle {}: orthogonal shear {:.4e} Pa {}\n", body_names[side], body->cycle,
                          body->orthogonal_shear.value, worst_text(body->orthogonal_shear));
      if (body->utilisation)
        text +=
            fmt::format("          utilisation {:.4f} {}\n", body->utilisation->value, worst_text(*body->utilisation));
      text +=
          fmt::format("          worst shakedown state: {}", shakedown_names[static_cast<std::size_t>(body->worst())]);
      text += std::isnan(body->life)
                  ? "\n"
                  : fmt::format("; relative life {:.4g}, stress-volume {:.6e}\n", body->life, body->stress_volume);
    }
  return text;
}

} // namespace brinell::io
