// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"
#include "tugging_runs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

/// Error of the step by which the contact is shifted, apart from that of the mesh: one mesh, shifts of 4, 2, 1 and 1/2
/// cells along x.
namespace brinell::verification::shift_order_test
{
namespace
{

using elastoplastic::Integration;

constexpr std::array shifts{4.0, 2.0, 1.0, 0.5};

/// A quantity at the four shifts, coarse to fine.
struct Series
{
  std::array<double, 4> value{};

  /// Order between three shifts, each half the one before, from `first` on.
  [[nodiscard]] double order(std::size_t first) const
  {
    return std::log2(std::abs((value[first] - value[first + 1]) / (value[first + 1] - value[first + 2])));
  }
  /// The two finest, extrapolated with an order that is known.
  [[nodiscard]] double limit(double order) const { return value[3] + (value[3] - value[2]) / (std::exp2(order) - 1.0); }
  void print(const char* what) const
  {
    std::printf("  %-34s %10.5f %10.5f %10.5f %10.5f   orders %.2f %.2f\n", what, value[0], value[1], value[2],
                value[3], order(0), order(1));
  }
};

struct Results
{
  Series resistance, net_work, dissipation;
};

/// alpha* = 9 with the paper's cells along x, where the step matters, and cells across and in depth twice as large.
Results results(Integration integration)
{
  Results r;
  for (std::size_t i = 0; i < shifts.size(); ++i)
  {
    simulation::TuggingCase t = equal_spheres(9.0, perfect_material());
    t.spacing = slow_build ? std::array{7.7e-3, 15.4e-3, 7.7e-3} : std::array{3.85e-3, 7.7e-3, 3.85e-3};
    t.shift = shifts[i] * (*t.spacing)[0];
    t.solver.integration = integration;
    const simulation::TuggingSummary s = simulation::run(t);
    r.resistance.value[i] = s.F_X_aligned / critical().load;
    r.net_work.value[i] = s.work / critical().energy;
    r.dissipation.value[i] = (s.dissipation_lower + s.dissipation_upper) / critical().energy;
  }
  return r;
}

TEST(ShiftStep, PathIsSecondOrderAndBackwardEulerFirst)
{
  if (slow_build)
    GTEST_SKIP() << "eight passes are too expensive in this build";
  const Results path = results(Integration::path);
  const Results euler = results(Integration::backward_euler);
  std::printf("  shift / dx                                  4          2          1        1/2\n");
  path.resistance.print("path: F_X / P_c at X = 0");
  path.net_work.print("path: net work / U_c");
  path.dissipation.print("path: dissipation / U_c");
  euler.resistance.print("backward Euler: F_X / P_c at X = 0");
  euler.net_work.print("backward Euler: net work / U_c");
  euler.dissipation.print("backward Euler: dissipation / U_c");

  const auto check = [](const char* what, const Series& second, const Series& first)
  {
    const std::string name = what;
    // Orders from the three finest shifts, a fifth of the contact radius at most; a half-order either way, because the
    // first steps of a contact, a few cells wide, are never resolved.
    test::expect_within(name + ": order of the path in the shift", second.order(1), 1.5, 3.0, "theory: 2");
    test::expect_within(name + ": order of backward Euler in the shift", first.order(1), 0.5, 1.5, "theory: 1");
    const double limit = second.limit(2.0);
    test::expect_within(name + ": error of the path at the shift of one cell", std::abs(second.value[2] / limit - 1.0),
                        0.0, 0.5 * std::abs(first.value[2] / limit - 1.0), "theory: below that of backward Euler");
    // Both schemes have one limit. Backward Euler's is extrapolated over as much as its last step changes it.
    test::expect_close(name + ": limit of backward Euler / limit of the path", first.limit(1.0) / limit, 1.0,
                       std::abs(first.value[3] - first.value[2]) / std::abs(limit), "theory: one limit");
  };
  check("F_X at X = 0", path.resistance, euler.resistance);
  check("net work", path.net_work, euler.net_work);
  check("dissipation", path.dissipation, euler.dissipation);
}

} // namespace
} // namespace brinell::verification::shift_order_test
