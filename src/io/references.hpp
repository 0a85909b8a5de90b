// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/citations.hpp"

/// Each source that a case may use, once. The functions that use them name author, year and equation.
namespace brinell::io::references
{

[[nodiscard]] Reference anderson_1965();
[[nodiscard]] Reference armstrong_1966();
[[nodiscard]] Reference boucly_2006();
[[nodiscard]] Reference chaboche_1986();
[[nodiscard]] Reference chiu_1978();
[[nodiscard]] Reference green_2005();
[[nodiscard]] Reference hertz_1882();
[[nodiscard]] Reference hollomon_1945();
[[nodiscard]] Reference jacq_2002();
[[nodiscard]] Reference johnson_1985();
[[nodiscard]] Reference liu_2000();
[[nodiscard]] Reference love_1929();
[[nodiscard]] Reference ludwik_1909();
[[nodiscard]] Reference ortiz_1985();
[[nodiscard]] Reference polonsky_1999();
[[nodiscard]] Reference prager_1956();
[[nodiscard]] Reference simo_1998();
[[nodiscard]] Reference sneddon_1965();
[[nodiscard]] Reference swift_1952();
[[nodiscard]] Reference ville_1999();
[[nodiscard]] Reference voce_1948();
[[nodiscard]] Reference walker_2011();
[[nodiscard]] Reference wilkins_1964();

} // namespace brinell::io::references
