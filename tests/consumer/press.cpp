// SPDX-License-Identifier: BSD-3-Clause
// A program of somebody else: a hard ball is pressed into steel and lifted off. It sees installed headers only.
#include <brinell/simulation/run.hpp>
#include <brinell/version.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

int main()
{
  using namespace brinell;
  using contact::Drive;
  const double load = 20.0; // N

  simulation::IndentationCase ball_on_flat;
  ball_on_flat.lower = {simulation::Plane{}, {{210e9, 0.3}, constitutive::LinearHardening{600e6, 2e9}}};
  ball_on_flat.upper = {simulation::Paraboloid{1e-3, 1e-3}, {{600e9, 0.2}, {}}};
  ball_on_flat.sequence = {{Drive::Kind::load, load}, {Drive::Kind::load, 0.0}};
  ball_on_flat.steps = 8;
  ball_on_flat.resolution = 5.0;

  double force = 0.0;
  simulation::Observer<simulation::IndentationRecord> observer;
  observer.on_step = [&](const simulation::IndentationRecord& record, int) { force = std::max(force, record.F_n); };
  const simulation::IndentationSummary summary = run(ball_on_flat, observer);
  std::printf("brinell %s: force %.6f N, dent %.4f um, energy balance error %.1e\n", version.data(), force,
              1e6 * summary.indents.front().residual_depth, summary.energy_balance_error);

  // The load is the imposed one, to rounding; the trapezoidal rule for the work errs by the square of 1/steps, 1.6 %.
  const bool is_right = std::abs(force - load) < 1e-9 * load && summary.indents.front().residual_depth > 0.0 &&
                        std::abs(summary.energy_balance_error) < 0.02;
  return is_right ? 0 : 1;
}
