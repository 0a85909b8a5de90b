// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"
#include "brinell/simulation/convergence.hpp"

#include <map>
#include <string>
#include <vector>

/// A case with finer and finer cells, and what its numbers tell of their error.
namespace brinell::io
{

/// The numbers of a summary by their names: "forces.peak_F_X_N", "indents[0].hardness_Pa".
using Numbers = std::map<std::string, double>;

/// One run of a series.
struct Level
{
  double cells = 1.0; ///< size, over that of the case as given
  Vector3 spacing{};  ///< [m]
  Numbers numbers;
};

/// What a series has come to.
struct Accuracy
{
  double asked = 0.0;
  bool reached = false;
  double error = 0.0; ///< largest relative one of the key numbers
  std::vector<std::string> key_numbers;
  std::vector<Level> levels; ///< coarsest first
  std::map<std::string, simulation::Convergence> numbers;
};

/// A finished run of a series, from its summary's text.
[[nodiscard]] Level level_of(const std::string& summary, double cells);

/// The results in a summary's text, without what is given, counted or is an error itself; those that are no number are left
/// out, and so are those over their values at first yield, which differ by a factor only.
[[nodiscard]] Numbers numbers_of(const std::string& summary);

/// The same case with cells of that size, over the size they have; a shift that is not given goes with them. Its values, and so
/// its resolved text, stay those of the case as given: they define the series.
[[nodiscard]] Case with_cells(const Case& c, double size);

/// Estimates from two levels or more.
[[nodiscard]] Accuracy accuracy_of(const Case& c, std::vector<Level> levels);

/// Which of the key numbers is known least, and what would help: a clause for people.
[[nodiscard]] std::string accuracy_advice(const Case& c, const Accuracy& accuracy);

} // namespace brinell::io
