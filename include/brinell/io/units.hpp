// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

/// Reading of case files and writing of results. Units exist only in this layer: everything below computes in SI.
namespace brinell::io
{

/// Physical dimension as exponents of kg, m, s, K, A.
struct Dimension
{
  int mass = 0, length = 0, time = 0, temperature = 0, current = 0;
  bool operator==(const Dimension&) const = default;
};

namespace dimension
{
inline constexpr Dimension none{};
inline constexpr Dimension length{.length = 1};
inline constexpr Dimension force{.mass = 1, .length = 1, .time = -2};
inline constexpr Dimension pressure{.mass = 1, .length = -1, .time = -2};
inline constexpr Dimension velocity{.length = 1, .time = -1};
inline constexpr Dimension conductivity{.mass = 1, .length = 1, .time = -3, .temperature = -1};
inline constexpr Dimension power{.mass = 1, .length = 2, .time = -3};
inline constexpr Dimension heat_flux{.mass = 1, .time = -3};
inline constexpr Dimension conductance{.mass = 1, .time = -3, .temperature = -1};
inline constexpr Dimension density{.mass = 1, .length = -3};
inline constexpr Dimension specific_heat{.length = 2, .time = -2, .temperature = -1};
inline constexpr Dimension expansion{.temperature = -1};
inline constexpr Dimension wear{.mass = -1, .length = 1, .time = 2};
inline constexpr Dimension current{.current = 1};
inline constexpr Dimension voltage{.mass = 1, .length = 2, .time = -3, .current = -1};
inline constexpr Dimension resistivity{.mass = 1, .length = 3, .time = -3, .current = -2};
inline constexpr Dimension area_resistance{.mass = 1, .length = 4, .time = -3, .current = -2};
} // namespace dimension

/// "length", "pressure", ...; "quantity in kg m^2" if the dimension has no name here.
[[nodiscard]] std::string dimension_name(Dimension dimension);

/// SI unit, "m", "Pa", ...; empty for a pure number.
[[nodiscard]] std::string si_unit(Dimension dimension);

/// A value like "3.85 mm", for help texts.
[[nodiscard]] std::string_view example_quantity(Dimension dimension);

/// A number with its dimension, in SI.
struct Quantity
{
  double value = 0.0;
  Dimension dimension;
};

/// Reads "3.85 mm", "200GPa", "12 N/mm^2", "45 W/(m K)", "12e-6 1/K", "2 µm". Nearly every unit is a power of ten of the SI unit;
/// inch, kgf and HV have a factor besides. This power is added to the exponent of the number before the number is parsed, so that
/// "3.85 mm" is the same double as 0.00385.
/// @throws InputError; its text continues a sentence that begins with the value ("has the unknown unit ...").
[[nodiscard]] Quantity quantity(std::string_view given);

/// A text without the characters that look like a blank or a minus sign but are others: U+00A0, U+2007, U+2009, U+202F, U+2212.
/// Texts and web pages set numbers with them; all functions of this header read them.
[[nodiscard]] std::string with_plain_signs(std::string_view text);

/// Reads "20 degC", "20 °C" or "293.15 K" in degrees Celsius: a temperature, not a difference of two.
/// @throws InputError; its text continues a sentence that begins with the value.
[[nodiscard]] double degrees_celsius(std::string_view given);

/// Reads "70 deg", "70°", "1.2 rad" or "20 mrad" in degrees.
/// @throws InputError; its text continues a sentence that begins with the value.
[[nodiscard]] double degrees(std::string_view given);

} // namespace brinell::io
