// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/elastic_contact.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>

/// Solution for an imposed mean gap with a compressible layer between the surfaces.
namespace brinell::contact
{

/// With a layer, the mean gap is that without a layer plus the mean compression of the layer. The compression grows more slowly
/// than the approach, so the approach is found by a secant iteration: docs/theory/contact.md (kept gap).
Report ElasticContact::solve_mean_gap(const Problem& problem, std::span<double> pressure, std::span<double> gap)
{
  constexpr int most = 50;
  constexpr double steepest = 0.95; // a slope of one is that of full contact, where the gap is zero
  const auto given_way = [&]
  { return brinell::dot(compliance_.grid(), layer_, pressure) / static_cast<double>(layer_.size()); };
  Problem turn = problem;
  double before = 0.0, depth_before = 0.0, slope = 0.0;
  turn.drive.value += given_way(); // by the guess
  for (int i = 0, iterations = 0, products = 0;; ++i)
  {
    Report report = iterate(turn, pressure, gap);
    report.iterations = iterations += report.iterations;
    report.products = products += report.products;
    const double depth = given_way();
    const double error = problem.drive.value + depth - turn.drive.value; // of the mean gap
    if (std::abs(error) <= problem.tolerance || !report.converged)
      return report;
    if (i == most)
    {
      report.converged = false;
      return report;
    }
    if (i > 0 && turn.drive.value != before)
      slope = std::clamp((depth - depth_before) / (turn.drive.value - before), 0.0, steepest);
    before = turn.drive.value;
    depth_before = depth;
    turn.drive.value += error / (1.0 - slope);
  }
}

} // namespace brinell::contact
