// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <string_view>
#include <vector>

/// Time of a run, foretold from its plan: docs/performance.md, bench/forecast.py.
namespace brinell::simulation
{

/// Steps of a run by what they do, as each kind takes a different number of evaluations.
struct Course
{
  double loading = 0.0;   ///< the drive rises at a place for the first time
  double unloading = 0.0; ///< the drive falls for the first time
  double moving = 0.0;    ///< the contact moves, or the surfaces slide, for the first time
  double again = 0.0;     ///< repetitions: further cycles, passes and strokes, most of which is elastic
  double turns = 0.0;     ///< times that sliding begins or reverses, where friction is raised in increments of its own
  double mobilised = 1.0; ///< share of the friction that acts: less where the surfaces stick
  bool sticks = false;    ///< whether the surfaces may stick in places
  bool by_load = true;    ///< whether a load is imposed, not an approach or a mean gap

  [[nodiscard]] double steps() const { return loading + unloading + moving + again; }
};

/// Results that a run stores.
struct Storage
{
  double states = 1.0; ///< with fields, the final one included
  double bytes = 0.0;  ///< of all fields
};

/// A number with a name, for the fit in bench/forecast.py.
struct Factor
{
  std::string_view name;
  double value;
};

/// Features of a run that decide about its time and are known before it.
struct Workload
{
  Course course;
  bool can_yield = false;
  std::vector<Factor> factors; ///< of the logarithm of the evaluations per step
  std::vector<Factor> amounts; ///< of work: sizes per run, per step and per evaluation, see `workload`
};

/// @param half_width  of the contact along x, estimate [m]
[[nodiscard]] Workload workload(const Numerics& numerics, const ShapedBody& lower, const ShapedBody& upper,
                                const Plan& plan, double half_width, const Course& course, const Storage& storage);

} // namespace brinell::simulation
