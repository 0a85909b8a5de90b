// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/forecast.hpp"

#include <array>

/// Written by bench/forecast.py fit; do not edit.
namespace brinell::simulation::measured
{

/// Logarithm of the evaluations per step for one of each factor.
inline constexpr std::array<Factor, 35> of_factors{{
    {"indentation", 1.01},
    {"rolling", 1.157},
    {"tugging", 0.9392},
    {"sliding", 1.093},
    {"fretting", 0.8261},
    {"severity of indentation", 0.7543},
    {"severity of rolling", 0.6697},
    {"severity of tugging", 0.9149},
    {"severity of sliding", 0.8008},
    {"severity of fretting", 0.405},
    {"severity that is deep", -0.1951},
    {"severity under a tip", -0.2034},
    {"severity without hardening", 0.3031},
    {"severity of a line", 0.5908},
    {"severity of flats", -0.2181},
    {"no hardening", 0.2837},
    {"shear", 0.05081},
    {"shear near its limit", 0.2735},
    {"line", 0.08029},
    {"tip", 0.09108},
    {"flats", 0.3505},
    {"contact of flats", 0.1216},
    {"rough", 0.2238},
    {"softness", 0.0792},
    {"resolution", 0.1059},
    {"kinematic hardening", -0.04565},
    {"both bodies", 0.04284},
    {"wear", 0.08627},
    {"heat", 0.09425},
    {"steps of loading", -0.4175},
    {"unloading", -0.6651},
    {"again", -0.3708},
    {"pressing before a motion", -0.172},
    {"pressing before fretting", 0.644},
    {"turns", 0.09733},
}};

/// Seconds for one of each amount.
inline constexpr std::array<Factor, 21> of_amounts{{
    {"start", 0.02366},
    {"steps", 0},
    {"evaluations", 0.0001135},
    {"transforms", 1.556},
    {"cells", 0.1209},
    {"cells of nonlinear laws", 9.359},
    {"cells of a line", 77.71},
    {"cells of a line, of nonlinear laws", 35.39},
    {"contact", 1.302},
    {"contact of elastic bodies", 4.2},
    {"contact under friction", 13.3},
    {"contact that sticks", 19.24},
    {"friction", 4.096e-05},
    {"operators", 6.515},
    {"states", 0.011},
    {"fields of states", 4.441},
    {"bytes", 1.476},
    {"heat", 0.1858},
    {"heated layers", 1.383},
    {"steady heat", 14.25},
    {"steps of steady heat", 0},
}};

/// Factor within which 95 of 100 times are, by `Certainty`.
inline constexpr std::array<double, 3> spread{1.5, 2.1, 9.4};

} // namespace brinell::simulation::measured
