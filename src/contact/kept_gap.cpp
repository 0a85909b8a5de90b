// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/elastic_contact.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>

/// A mean gap that is kept while a layer between the surfaces gives way.
namespace brinell::contact
{

/// With a layer the mean gap is that of `imposed` and what the layer gives way in the mean, which grows more slowly than the
/// approach: docs/theory/contact.md (kept gap).
Report ElasticContact::keep_gap(const Problem& problem, std::span<double> pressure, std::span<double> gap)
{
  constexpr int most = 50;
  constexpr double steepest = 0.95; // a slope of one is that of full contact, where the gap is none
  const auto given_way = [&] { return dot(layer_, pressure) / static_cast<double>(layer_.size()); };
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
