// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Hardening curves from measured stress-strain curves. The case file, the Python package and `brinell material show` all use
/// these functions.
namespace brinell::io
{

/// Strains [-] and stresses [Pa] in the order in which they were measured, with magnitudes as of a tensile test.
struct Curve
{
  std::vector<double> strain, stress;
};

/// How a measured curve becomes a hardening curve. The names of the choices are those of the case file.
struct CurveRules
{
  enum class Strain
  {
    plastic, ///< without the elastic strain
    total
  };
  enum class Measure
  {
    true_values,
    engineering ///< force over initial area, elongation over initial length
  };
  enum class Test
  {
    automatic, ///< compression if strains and stresses are below 0
    tension,
    compression
  };
  enum class YieldFrom
  {
    first_point,
    offset, ///< stress at the plastic strain `offset`
    fit     ///< at plastic strain 0 of the law that fits best beyond `offset`
  };
  enum class Slope
  {
    young_modulus,
    curve ///< fitted to the elastic part of the curve
  };
  Strain strain = Strain::plastic;
  Measure measure = Measure::true_values;
  Test test = Test::automatic;
  std::optional<YieldFrom> yield_from{}; ///< by default offset for total strain, first_point for plastic strain
  double offset = 0.002;
  Slope slope = Slope::young_modulus;
  std::optional<double> young_modulus{}; ///< [Pa]
  bool monotone = false;                 ///< whether a stress below an earlier one may be raised to it

  /// Whether the points of a file are used as they are.
  [[nodiscard]] bool keeps_points() const
  {
    return strain == Strain::plastic && measure == Measure::true_values &&
           yield_from.value_or(YieldFrom::first_point) == YieldFrom::first_point;
  }
};

namespace curve_words
{
inline constexpr std::array<std::string_view, 2> strain{"plastic", "total"};
inline constexpr std::array<std::string_view, 2> measure{"true", "engineering"};
inline constexpr std::array<std::string_view, 3> test{"automatic", "tension", "compression"};
inline constexpr std::array<std::string_view, 3> yield_from{"first_point", "offset", "fit"};
inline constexpr std::array<std::string_view, 2> slope{"young_modulus", "curve"};
} // namespace curve_words

/// A hardening curve, and what was done to obtain it.
struct HardeningCurve
{
  std::vector<double> plastic_strain, stress; ///< begins at plastic strain 0 with the yield stress
  Curve loading; ///< the points used: true stress over true total strain (plastic strain without a modulus)
  std::optional<double> slope; ///< of the elastic part of the loading [Pa], if it has enough points
  double zero = 0.0;           ///< strain at which the elastic line begins; other than 0 only with Slope::curve
  std::vector<std::string> notes;
  std::vector<Warning> warnings; ///< their texts begin with what they are about, without a key
};

/// Converts a measured curve: engineering to true values, total to plastic strain, without unloading loops and repeated strains,
/// with the yield stress at plastic strain 0 (docs/howto/curves.md).
/// @throws InputError; its text continues a sentence that begins with the curve ("has no ...").
[[nodiscard]] HardeningCurve hardening_curve(const Curve& measured, const CurveRules& rules);

/// Reads a text file with one point per line, strain and stress. Title lines may precede the points. Lines that begin with # are
/// comments; columns are separated by blanks, tabs, semicolons or commas; a comma is a decimal comma if the columns are
/// separated by something else.
/// @param strain_unit  "1" or "%"
/// @param stress_unit  such as "MPa"
/// @param kind  what the strains are, for the message that says what is allowed
/// @throws InputError; its text continues a sentence that begins with the file ("has in line 3 ..."); IoError
[[nodiscard]] Curve read_curve(const std::filesystem::path& file, std::string_view strain_unit,
                               std::string_view stress_unit, CurveRules::Strain kind);

} // namespace brinell::io
