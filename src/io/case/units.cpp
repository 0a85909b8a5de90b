// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/units.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/nan.hpp"
#include "io/pattern.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>
#include <utility>

namespace brinell::io
{

namespace
{

/// A unit is factor 10^power of the SI unit of its dimension.
struct Unit
{
  std::string_view symbol;
  Dimension dimension;
  int power = 0;
  bool prefixed = true; ///< may carry a prefix
  double factor = 1.0;  ///< other than 1 of units that are no power of ten of the SI unit
};

constexpr double kilogram_force = 9.80665; // [N], exact (CGPM 1901)

constexpr std::array units{
    Unit{"m", {.length = 1}},
    Unit{"g", {.mass = 1}, -3},
    Unit{"s", {.time = 1}},
    Unit{"K", {.temperature = 1}},
    Unit{"N", {.mass = 1, .length = 1, .time = -2}},
    Unit{"Pa", {.mass = 1, .length = -1, .time = -2}},
    Unit{"bar", {.mass = 1, .length = -1, .time = -2}, 5},
    Unit{"J", {.mass = 1, .length = 2, .time = -2}},
    Unit{"W", {.mass = 1, .length = 2, .time = -3}},
    Unit{"A", dimension::current},
    Unit{"V", dimension::voltage},
    Unit{"ohm", {.mass = 1, .length = 2, .time = -3, .current = -2}},
    Unit{"\u03a9", {.mass = 1, .length = 2, .time = -3, .current = -2}}, // Greek letter, and the sign
    Unit{"\u2126", {.mass = 1, .length = 2, .time = -3, .current = -2}},
    Unit{"rad", {}}, // only per length; plain angles are read by `degrees`
    Unit{"Hz", {.time = -1}},
    Unit{"%", {}, -2, false},
    Unit{"\u00c5", {.length = 1}, -10, false}, // angstrom, the letter and the sign
    Unit{"\u212b", {.length = 1}, -10, false},
    Unit{"angstrom", {.length = 1}, -10, false},
    Unit{"in", {.length = 1}, 0, false, 0.0254},
    Unit{"inch", {.length = 1}, 0, false, 0.0254},
    Unit{"kgf", {.mass = 1, .length = 1, .time = -2}, 0, false, kilogram_force},
    Unit{"HV", {.mass = 1, .length = -1, .time = -2}, 6, false, kilogram_force}, // kgf/mm^2 (ISO 6507)
};

struct Prefix
{
  std::string_view symbol;
  int power;
};

constexpr std::array prefixes{
    Prefix{"k", 3},  Prefix{"M", 6},       Prefix{"G", 9},       Prefix{"T", 12}, Prefix{"c", -2},  Prefix{"m", -3},
    Prefix{"u", -6}, Prefix{"\u00b5", -6}, Prefix{"\u03bc", -6}, Prefix{"n", -9}, Prefix{"p", -12},
};

struct NamedDimension
{
  Dimension dimension;
  std::string_view name, unit, example;
};

constexpr std::array named_dimensions{
    NamedDimension{{}, "pure number", "", "0.3"},
    NamedDimension{{.length = 1}, "length", "m", "3.85 mm"},
    NamedDimension{{.length = -1}, "angle per length", "rad/m", "0.5 rad/mm"},
    NamedDimension{{.length = 2}, "area", "m^2", "2 mm^2"},
    NamedDimension{{.mass = 1, .length = -1, .time = -2}, "pressure", "Pa", "200 GPa"},
    NamedDimension{{.mass = 1, .length = 1, .time = -2}, "force", "N", "10 kN"},
    NamedDimension{{.mass = 1, .length = 2, .time = -2}, "energy", "J", "3 J"},
    NamedDimension{{.mass = 1}, "mass", "kg", "1 kg"},
    NamedDimension{{.time = 1}, "time", "s", "2 ms"},
    NamedDimension{{.time = -1}, "frequency", "Hz", "10 Hz"},
    NamedDimension{{.length = 1, .time = -1}, "velocity", "m/s", "3 m/s"},
    NamedDimension{{.temperature = 1}, "difference of temperatures", "K", "300 K"},
    NamedDimension{dimension::conductivity, "thermal conductivity", "W/(m K)", "50 W/(m K)"},
    NamedDimension{dimension::power, "power", "W", "5 W"},
    NamedDimension{dimension::heat_flux, "heat flux", "W/m^2", "20 W/mm^2"},
    NamedDimension{dimension::conductance, "thermal conductance", "W/(m^2 K)", "3e4 W/(m^2 K)"},
    NamedDimension{dimension::density, "density", "kg/m^3", "7850 kg/m^3"},
    NamedDimension{dimension::specific_heat, "specific heat", "J/(kg K)", "460 J/(kg K)"},
    NamedDimension{dimension::wear, "wear coefficient", "1/Pa", "1e-6 mm^3/(N m)"},
    NamedDimension{dimension::expansion, "thermal expansion", "1/K", "12e-6 1/K"},
    NamedDimension{dimension::current, "electric current", "A", "5 A"},
    NamedDimension{dimension::voltage, "voltage", "V", "20 mV"},
    NamedDimension{{.mass = 1, .length = 2, .time = -3, .current = -2}, "resistance", "ohm", "2 mohm"},
    NamedDimension{dimension::resistivity, "resistivity", "ohm m", "1.7e-8 ohm m"},
    NamedDimension{dimension::area_resistance, "area resistance", "ohm m^2", "1e-12 ohm m^2"},
};

const NamedDimension* find(Dimension dimension)
{
  for (const auto& named : named_dimensions)
    if (named.dimension == dimension)
      return &named;
  return nullptr;
}

std::string base_units(Dimension d)
{
  std::string text;
  const auto add = [&](std::string_view symbol, int exponent)
  {
    if (exponent == 0)
      return;
    text += text.empty() ? "" : " ";
    text += exponent == 1 ? std::string(symbol) : fmt::format("{}^{}", symbol, exponent);
  };
  add("kg", d.mass);
  add("m", d.length);
  add("s", d.time);
  add("K", d.temperature);
  add("A", d.current);
  return text;
}

std::optional<Unit> find_unit(std::string_view symbol)
{
  for (const Unit& unit : units) // exact names first: "m" is a metre, "Pa" not a pico-something
    if (unit.symbol == symbol)
      return unit;
  for (const Prefix& prefix : prefixes)
    for (const Unit& unit : units)
      if (unit.prefixed && symbol.size() == prefix.symbol.size() + unit.symbol.size() &&
          symbol.starts_with(prefix.symbol) && symbol.ends_with(unit.symbol))
        return Unit{symbol, unit.dimension, unit.power + prefix.power};
  return std::nullopt;
}

/// Known units that differ from a symbol only in upper and lower case, as a hint: " (did you mean GPa?)".
std::string units_like(std::string_view symbol)
{
  const auto is_same = [](char a, char b)
  { return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b)); };
  std::string found;
  const auto add_if_same = [&](const std::string& known)
  {
    if (std::equal(known.begin(), known.end(), symbol.begin(), symbol.end(), is_same))
      found += (found.empty() ? "" : " or ") + known;
  };
  for (const Unit& unit : units)
  {
    add_if_same(std::string(unit.symbol));
    for (const Prefix& prefix : prefixes)
      if (unit.prefixed)
        add_if_same(fmt::format("{}{}", prefix.symbol, unit.symbol));
  }
  return found.empty() ? "" : fmt::format(" (did you mean {}?)", found);
}

/// A decimal number, split so that the power of a unit can be added to its exponent.
struct Decimal
{
  std::string mantissa;
  int exponent = 0;
};

/// Removes the longest number from the beginning of a text, and returns it.
std::optional<Decimal> take_number(std::string_view& text)
{
  const bool has_plus = text.starts_with('+');
  const char *first = text.data() + (has_plus ? 1 : 0), *last = text.data() + text.size();
  double ignored = 0.0;
  const char* end = std::from_chars(first, last, ignored).ptr;
  const std::string_view digits(first, static_cast<std::size_t>(end - first));
  if (digits.empty() || digits.find_first_not_of("-+.0123456789eE") != digits.npos || (has_plus && *first == '-'))
    return std::nullopt; // also inf and nan
  const auto e = digits.find_first_of("eE");
  Decimal number{std::string(digits.substr(0, e))};
  if (e != digits.npos)
    if (const char* power = first + e + (first[e + 1] == '+' ? 2 : 1);
        std::from_chars(power, end, number.exponent).ec != std::errc{} || std::abs(number.exponent) > 9999)
      return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

void multiply(Unit& product, const Unit& factor, int exponent)
{
  product.power += factor.power * exponent;
  product.factor *= std::pow(factor.factor, exponent);
  product.dimension.mass += factor.dimension.mass * exponent;
  product.dimension.length += factor.dimension.length * exponent;
  product.dimension.time += factor.dimension.time * exponent;
  product.dimension.temperature += factor.dimension.temperature * exponent;
  product.dimension.current += factor.dimension.current * exponent;
}

/// Rewrites "W/(m K)" as "W/m/K", and "1/K" as "/K". Other parentheses remain, and are rejected later.
std::string without_parentheses(std::string text)
{
  static const Pattern divisor(R"(/[ \t]*\([ \t]*([^()/]*[^()/ \t])[ \t]*\))"), between(R"([ \t]*\*[ \t]*|[ \t]+)"),
      one(R"(^1[ \t]*/)");
  while (const auto match = divisor.find(text))
    text.replace(match->begin, match->end - match->begin, "/" + between.replaced(match->group(0), "/"));
  return one.replaced(text, "/");
}

/// Reads products and quotients of units; each "/" applies only to the unit after it.
Unit unit_expression(std::string_view whole)
{
  const auto bad = [&](std::string_view what, const std::string& hint = "")
  {
    return InputError(fmt::format("has the {} \"{}\"{}; known are m, g, s, K, N, Pa, bar, J, W, A, V, ohm, rad with "
                                  "the prefixes p n u c m k M G T, "
                                  "and in, angstrom, kgf, HV, as in \"mm\", \"GPa\", \"N/mm^2\"",
                                  what, whole, hint));
  };
  static const Pattern factor(R"([ \t]*([*/]?)[ \t]*([^*/^ \t+.0-9-]+)(?:\^?(-?[0-9]{1,9}))?)");
  std::string text = replaced(std::string(whole), "\u00b7", "*"); // middle dot
  text = without_parentheses(replaced(replaced(std::move(text), "\u00b2", "^2"), "\u00b3", "^3"));
  Unit product;
  for (std::string_view rest = text; !rest.empty();)
  {
    const auto match = factor.match_begin(rest);
    const std::string symbol = match ? match->group(1) : "", sign = match ? match->group(0) : "";
    const auto unit = match && (sign != "*" || rest.size() != text.size()) ? find_unit(symbol) : std::nullopt;
    if (!unit)
      throw bad("unknown unit", units_like(symbol));
    const int exponent = match->groups[2] ? std::stoi(*match->groups[2]) : 1;
    if (std::abs(exponent) > 9)
      throw bad("impossible unit");
    multiply(product, *unit, sign == "/" ? -exponent : exponent);
    rest.remove_prefix(match->end);
  }
  if (product.dimension == Dimension{} && text.find("rad") != text.npos)
    throw bad("unknown unit");
  return product;
}

/// A number and the rest of its text, which may be a unit that `quantity` does not know. Without a number: NaN and no unit.
std::pair<double, std::string_view> number_and_unit(std::string_view text)
{
  text = trimmed(text);
  std::string_view unit = text;
  if (!take_number(unit))
    return {nan, ""};
  return {quantity(text.substr(0, text.size() - unit.size())).value, trimmed(unit)};
}

} // namespace

std::string dimension_name(Dimension dimension)
{
  const auto* named = find(dimension);
  return named ? std::string(named->name) : "quantity in " + base_units(dimension);
}

std::string si_unit(Dimension dimension)
{
  const auto* named = find(dimension);
  return named ? std::string(named->unit) : base_units(dimension);
}

std::string_view example_quantity(Dimension dimension)
{
  const auto* named = find(dimension);
  return named ? named->example : std::string_view{};
}

std::string with_plain_signs(std::string_view text)
{
  struct Sign
  {
    std::string_view bytes;
    char plain;
  };
  constexpr std::array<Sign, 5> signs{
      {{"\u00a0", ' '}, {"\u2007", ' '}, {"\u2009", ' '}, {"\u202f", ' '}, {"\u2212", '-'}}};
  std::string plain;
  plain.reserve(text.size());
  for (std::size_t i = 0; i < text.size();)
  {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto begins = [&](const Sign& sign) { return text.substr(i).starts_with(sign.bytes); };
    const auto found = byte == 0xc2 || byte == 0xe2 ? std::find_if(signs.begin(), signs.end(), begins) : signs.end();
    plain += found == signs.end() ? text[i] : found->plain;
    i += found == signs.end() ? 1 : found->bytes.size();
  }
  return plain;
}

Quantity quantity(std::string_view given)
{
  const std::string plain = with_plain_signs(given); // texts and web pages have other blanks and minus signs
  std::string_view text = trimmed(plain);
  const auto number = take_number(text);
  if (!number)
    throw InputError("is not a number with a unit, such as \"3.85 mm\"");
  if (text.size() > 1 && text[0] == ',' && text[1] >= '0' && text[1] <= '9')
    throw InputError("has a comma in its number; allowed: a decimal point, as in \"3.85 mm\"");
  text = trimmed(text);
  const Unit unit = text.empty() ? Unit{} : unit_expression(text);
  const std::string decimal = fmt::format("{}e{}", number->mantissa, number->exponent + unit.power);
  Quantity result{0.0, unit.dimension};
  const auto [end, error] = std::from_chars(decimal.data(), decimal.data() + decimal.size(), result.value);
  if (error != std::errc{} || end != decimal.data() + decimal.size())
    throw InputError("is too large or too small for a number");
  result.value *= unit.factor; // 1 of nearly all units: their value is that of the decimal number
  return result;
}

double degrees_celsius(std::string_view given)
{
  const std::string text = with_plain_signs(given);
  constexpr double ice_point = 273.15; // [K]
  const auto [value, unit] = number_and_unit(text);
  if (unit == "degC" || unit == "\u00b0C")
    return value;
  if (unit != "K")
    throw InputError("is not a temperature; allowed: a number in degC, or text as in \"20 degC\" or \"293.15 K\"");
  return value - ice_point;
}

double degrees(std::string_view given)
{
  const std::string text = with_plain_signs(given);
  constexpr double degrees_of_radian = 180.0 / std::numbers::pi;
  const auto [value, unit] = number_and_unit(text);
  if (unit == "deg" || unit == "\u00b0")
    return value;
  if (unit != "rad" && unit != "mrad")
    throw InputError("is not an angle; allowed: a number in degrees, or text as in \"70 deg\", \"1.2 rad\" or "
                     "\"20 mrad\"");
  return value * (unit == "rad" ? 1.0 : 1e-3) * degrees_of_radian;
}

} // namespace brinell::io
