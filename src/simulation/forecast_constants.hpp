// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/forecast.hpp"

#include <array>

/// Written by bench/forecast.py fit; do not edit.
namespace brinell::simulation::measured
{

/// Logarithm of the evaluations per step for one of each factor.
inline constexpr std::array<Factor, 35> of_factors{{
    {"indentation", 0.0},
    {"rolling", 0.0},
    {"tugging", 0.0},
    {"sliding", 0.0},
    {"fretting", 0.0},
    {"severity of indentation", 0.0},
    {"severity of rolling", 0.0},
    {"severity of tugging", 0.0},
    {"severity of sliding", 0.0},
    {"severity of fretting", 0.0},
    {"severity that is deep", 0.0},
    {"severity under a tip", 0.0},
    {"severity without hardening", 0.0},
    {"severity of a line", 0.0},
    {"severity of flats", 0.0},
    {"no hardening", 0.0},
    {"shear", 0.0},
    {"shear near its limit", 0.0},
    {"line", 0.0},
    {"tip", 0.0},
    {"flats", 0.0},
    {"contact of flats", 0.0},
    {"rough", 0.0},
    {"softness", 0.0},
    {"resolution", 0.0},
    {"kinematic hardening", 0.0},
    {"both bodies", 0.0},
    {"wear", 0.0},
    {"heat", 0.0},
    {"steps of loading", 0.0},
    {"unloading", 0.0},
    {"again", 0.0},
    {"pressing before a motion", 0.0},
    {"pressing before fretting", 0.0},
    {"turns", 0.0},
}};

/// Seconds for one of each amount.
inline constexpr std::array<Factor, 21> of_amounts{{
    {"start", 0.0},
    {"steps", 0.0},
    {"evaluations", 0.0},
    {"transforms", 0.0},
    {"cells", 0.0},
    {"cells of nonlinear laws", 0.0},
    {"cells of a line", 0.0},
    {"cells of a line, of nonlinear laws", 0.0},
    {"contact", 0.0},
    {"contact of rough surfaces", 0.0},
    {"contact under friction", 0.0},
    {"contact that sticks", 0.0},
    {"friction", 0.0},
    {"operators", 0.0},
    {"states", 0.0},
    {"fields of states", 0.0},
    {"bytes", 0.0},
    {"heat", 0.0},
    {"heated layers", 0.0},
    {"steady heat", 0.0},
    {"steps of steady heat", 0.0},
}};

/// Factor within which 95 of 100 times are, by `Certainty`.
inline constexpr std::array<double, 3> spread{2.0, 2.0, 2.0};

} // namespace brinell::simulation::measured
