// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"
#include "brinell/quality/convergence.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

/// Discretization errors of the numbers of a case, estimated from a series of runs with successively finer cells.
namespace brinell::io
{

struct RunInfo;

/// The numbers of a summary by their names: "forces.peak_F_X_N", "indents[0].hardness_Pa".
using Numbers = std::map<std::string, double>;

/// One run of a series.
struct Level
{
  double cells = 1.0; ///< cell size relative to that of the case as given
  Vector3 spacing{};  ///< [m]
  Numbers numbers;
  std::map<std::string, double> stated_errors; ///< errors that the run itself has stated, by quantity
};

/// Result of a series.
struct Accuracy
{
  double asked = 0.0;
  bool reached = false;
  double error = 0.0; ///< largest relative error of the key numbers
  std::vector<std::string> key_numbers;
  std::vector<Level> levels; ///< coarsest first
  std::map<std::string, quality::Convergence> numbers;
};

/// A finished run of a series. Its numbers are the results in its summary: without input values, counts, errors, values that are
/// not numbers, and values normalised by those at first yield, which only differ by a factor.
[[nodiscard]] Level level_of(const Case& c, const simulation::AnyPlan& plan, const simulation::AnySummary& summary,
                             const RunInfo& info, double cells);

/// A run of a series that is read again from the text of its summary; none if another build of the program has computed it.
[[nodiscard]] std::optional<Level> level_of_this_build(const std::string& summary, double cells);

/// Case with its cell sizes multiplied by a factor; a shift that is not given scales with the cells. The values of the
/// case, and so its resolved text, stay those of the case as given, because they identify the series.
/// @throws InputError if a period has too few cells for a series
[[nodiscard]] Case with_cells(const Case& c, double size);

/// Estimates from two levels or more.
[[nodiscard]] Accuracy accuracy_of(const Case& c, std::vector<Level> levels);

/// Replaces the errors that are expected of a run by those that the series has measured, relative to the largest value of each
/// quantity, as the expected ones are.
void take_measured_errors(const Accuracy& accuracy, quality::Resolution& resolution);

/// A clause for the warning: the key number with the largest error, and how to reduce it.
[[nodiscard]] std::string accuracy_advice(const Case& c, const Accuracy& accuracy);

} // namespace brinell::io
