// SPDX-License-Identifier: BSD-3-Clause
#include "history_columns.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <utility>

namespace brinell::io
{

namespace
{

using NamedMeaning = std::pair<std::string_view, ColumnMeaning>;

constexpr std::array meanings{
    NamedMeaning{"step", {"1", "step, counts from 0 over all passes"}},
    NamedMeaning{"pass", {"1", "pass, counts from 0"}},
    NamedMeaning{"place", {"1", "index into the places of the indentation"}},
    NamedMeaning{"X", {"m", "sliding coordinate, 0 at alignment"}},
    NamedMeaning{"x", {"m", "where the contact is on the lower body"}},
    NamedMeaning{"theta", {"rad", "angle of the line of centres with the vertical"}},
    NamedMeaning{"interference", {"m", "interference of the undeformed bodies along the line of centres"}},
    NamedMeaning{"height", {"m", "height of the upper centre above the lower one"}},
    NamedMeaning{"approach", {"m", "approach of the bodies from first touch of the undeformed ones"}},
    NamedMeaning{"contact_area", {"m^2", "contact area"}},
    NamedMeaning{"contact_radius", {"m", "radius of the circle of the same area as the contact"}},
    NamedMeaning{"max_pressure", {"Pa", "largest contact pressure"}},
    NamedMeaning{"mean_pressure", {"Pa", "load over contact area"}},
    NamedMeaning{"F_n", {"N", "force normal to the plane of contact"}},
    NamedMeaning{"F_X", {"N", "resistance to the motion"}},
    NamedMeaning{"F_Y", {"N", "lateral force"}},
    NamedMeaning{"F_Z", {"N", "force that separates the bodies"}},
    NamedMeaning{"F_X_macro", {"N", "F_X without the slope of the residual surfaces"}},
    NamedMeaning{"F_Z_macro", {"N", "F_Z without the slope of the residual surfaces"}},
    NamedMeaning{"residual_depth", {"m", "largest residual displacement of the lower body at this place"}},
    NamedMeaning{"pile_up", {"m", "largest height of the residual surface of the lower body at this place"}},
    NamedMeaning{"work", {"J", "work of the drive since the start"}},
    NamedMeaning{"dissipation_lower", {"J", "plastic work in the lower body since the start"}},
    NamedMeaning{"dissipation_upper", {"J", "plastic work in the upper body since the start"}},
    NamedMeaning{"energy_residual", {"J", "elastic energy locked in by the plastic strain"}},
    NamedMeaning{"energy_elastic", {"J", "elastic energy of the contact pressure"}},
    NamedMeaning{"max_residual_lower", {"m", "largest residual displacement of the lower surface"}},
    NamedMeaning{"max_residual_upper", {"m", "largest residual displacement of the upper surface"}},
    NamedMeaning{"max_equivalent_plastic_strain", {"1", "largest equivalent plastic strain of both bodies"}},
    NamedMeaning{"iterations", {"1", "evaluations of the elastic-plastic operator in this step"}},
};

} // namespace

ColumnMeaning column_meaning(std::string_view name)
{
  const auto* found = std::find_if(meanings.begin(), meanings.end(), [&](const auto& m) { return m.first == name; });
  if (found == meanings.end())
    throw InternalError(fmt::format("the history has a column {} without unit and meaning", name));
  return found->second;
}

} // namespace brinell::io
