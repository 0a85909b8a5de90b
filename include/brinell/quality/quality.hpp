// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// Warnings and expected errors that a user should know before using the numbers of a result; the program, the summary, Python and
/// the report only show them. The limits are explained in docs/howto/accuracy.md.
namespace brinell::quality
{

/// A warning about a case that can be computed, but whose result should be checked.
struct Warning
{
  std::string key;  ///< stable, for programs: "coarse_contact"
  std::string text; ///< a clause for people, without a full stop
  bool operator==(const Warning&) const = default;
};

/// Usual discretization error of a number of such a run.
struct ExpectedError
{
  std::string quantity; ///< "net energy"
  std::string
      name; ///< pattern for the numbers' names in the summary, * matches anything: "residual.max_*_m"; may be empty
  double relative = 0.0;            ///< error relative to the value, at most 1
  double order = 2.0;               ///< of the error in the size of the cells
  std::optional<double> measured{}; ///< relative error by a series of runs of this case, not from the tables

  [[nodiscard]] double best() const { return measured.value_or(relative); }
};

/// Resolution of the cells, and errors found with the same resolution in the convergence tables of docs/verification/accuracy.md.
struct Resolution
{
  double cells_x =
      std::numeric_limits<double>::quiet_NaN(); ///< per half-width of the contact along x; NaN without contact
  double cells_y = std::numeric_limits<double>::quiet_NaN(); ///< along y
  double cells = std::numeric_limits<double>::quiet_NaN();   ///< per contact radius: the smaller of both
  std::optional<int>
      plastic_layers{}; ///< layers of cells through the depth of the plastic zone, 0 if nothing yields; none: not known yet
  /// For rough flats over a period: cells per shortest wave (for a height map, two of its points). Their contact consists of many
  /// patches without a common radius (NaN above), and the tables, which are for single indents, do not apply.
  std::optional<double> cells_per_wave{};
  std::optional<double> patch_cells{};          ///< see Coverage; none before a run
  std::optional<double> peak_cells{};           ///< see Coverage; none before a run
  std::vector<ExpectedError> expected_errors{}; ///< without plastic strain only those of elastic contacts
};

struct Quality
{
  std::vector<Warning> warnings;
  Resolution resolution;
};

/// Quality of the result of a case before it is run.
template <typename Case>
[[nodiscard]] Quality expected(const Case& c, const typename Case::Plan& plan);

/// Quality of a result by the totals of its run, or by the summary, which knows more.
template <typename Case>
[[nodiscard]] Quality judged(const Case& c, const typename Case::Plan& plan, const simulation::RunTotals& totals);
template <typename Case>
[[nodiscard]] Quality judged(const Case& c, const typename Case::Plan& plan, const typename Case::Summary& summary);

/// A share with two digits: "2.5 %"; above 99 % with all of its digits: "357 %".
[[nodiscard]] std::string percent_text(double share);

/// One line: "resolution: 9.5 x 9.5 cells per contact radius, 14 layers ...".
[[nodiscard]] std::string resolution_text(const Resolution& resolution);

/// Reason to refuse cells larger than a half-width of the contact, which cannot resolve it; empty if the cells are small enough.
[[nodiscard]] std::optional<std::string> reason_against_cells(const std::array<double, 3>& spacing, double half_x,
                                                              double half_y);
/// Reason to refuse a step longer than the contact, which would skip material between two steps; empty if the step is short
/// enough.
[[nodiscard]] std::optional<std::string> reason_against_shift(double shift, double half_x);

} // namespace brinell::quality
