// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// What the user should be told about a result before its numbers are used. `expected_quality` and `quality` of each scenario
/// decide it; the program, the summary, Python and the report only show it. The reasons of the limits: docs/howto/accuracy.md.
namespace brinell::simulation
{

/// Something that can be computed, but should be looked at.
struct Warning
{
  std::string key;  ///< stable, for programs: "coarse_contact"
  std::string text; ///< a clause for people, without a full stop
  bool operator==(const Warning&) const = default;
};

/// How far a number of such a run usually is from the limit of fine cells.
struct ExpectedError
{
  std::string quantity;  ///< "net energy"
  std::string name;      ///< of such numbers in the summary, with * for what is any: "residual.max_*_m"; may be empty
  double relative = 0.0; ///< share of the value, at most 1
};

/// What the cells resolve, and what error has been found with as many in the convergence tables of docs/verification.md.
struct Resolution
{
  double cells_x =
      std::numeric_limits<double>::quiet_NaN(); ///< per half-width of the contact along x; NaN without contact
  double cells_y = std::numeric_limits<double>::quiet_NaN(); ///< along y
  double cells = std::numeric_limits<double>::quiet_NaN();   ///< per contact radius: the smaller of both
  std::optional<int>
      plastic_layers{}; ///< through the depth of the plastic zone, 0 if nothing yields; none: not known yet
  /// Cells per shortest wave, two points of a height map, of rough flats over a period: their contact is in many patches, which
  /// have no radius (NaN above), and the tables, of one indent, do not hold.
  std::optional<double> cells_per_wave{};
  std::vector<ExpectedError> expected_errors{}; ///< none without plastic strain
};

struct Quality
{
  std::vector<Warning> warnings;
  Resolution resolution;
};

/// One line: "resolution: 9.5 x 9.5 cells per contact radius, 14 layers ...".
[[nodiscard]] std::string resolution_text(const Resolution& resolution);

/// Cells of which less than one fits into a half-width of the contact compute nothing of it: a reason to refuse them.
/// Nothing if they are small enough.
[[nodiscard]] std::optional<std::string> reason_against_cells(const std::array<double, 3>& spacing, double half_x,
                                                              double half_y);
/// The same for a step that is longer than the contact: it would jump over material that is never touched.
[[nodiscard]] std::optional<std::string> reason_against_shift(double shift, double half_x);

} // namespace brinell::simulation
