// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <optional>
#include <string_view>
#include <vector>

/// Time of a run, foretold from its plan: docs/performance.md. The constants are measured by bench/forecast.py.
namespace brinell::simulation
{

/// Kinds of motion of the bodies.
enum class RunKind
{
  indentation,
  rolling,
  tugging,
  sliding,
  fretting
};

/// Steps of a run by what they do, as each kind takes a different number of evaluations.
struct Course
{
  RunKind kind = RunKind::indentation;
  double loading = 0.0;   ///< steps in which the drive rises at a place for the first time
  double unloading = 0.0; ///< in which it falls for the first time
  double moving = 0.0;    ///< in which the contact moves, or the surfaces slide, for the first time
  double again = 0.0;     ///< of further cycles, passes and strokes, most of which is elastic
  double turns = 0.0;     ///< times that sliding begins or reverses, where friction is raised in increments of its own
  double mobilised = 1.0; ///< share of the friction that acts: less where the surfaces stick
  bool sticks = false;    ///< whether the surfaces may stick in places

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

/// An amount of work that takes time in proportion: some of it for the run, some for each evaluation of the bodies.
struct Amount
{
  std::string_view name;
  double of_run = 0.0, of_evaluation = 0.0;
};

/// How well the time can be foretold.
enum class Certainty
{
  elastic, ///< nothing is expected to yield
  yields,
  deep ///< far beyond yield, where increments may have to be split
};

/// Features of a run that decide about its time and are known before it.
struct Workload
{
  double steps = 0.0;
  std::vector<Factor> factors; ///< of the logarithm of the evaluations per step
  std::vector<Amount> amounts; ///< of the time
  Certainty certainty = Certainty::elastic;
  double fewest_evaluations = 1.0; ///< per step
};

/// @param half_width  of the contact along x, estimate [m]
[[nodiscard]] Workload workload(const PairCase& c, const Plan& plan, double half_width, const Course& course,
                                const Storage& storage);

/// Time and memory of a run, before it.
struct Forecast
{
  double evaluations = 0.0;             ///< of all steps
  double seconds = 0.0;                 ///< processor time on one core
  double shortest = 0.0, longest = 0.0; ///< range in which 95 of 100 runs like this one were [s]
};
[[nodiscard]] Forecast forecast(const Workload& work);

/// Memory of a case on a device [bytes].
struct DeviceMemory
{
  double arrays = 0.0;  ///< allocated by brinell
  double buffers = 0.0; ///< of transforms beside them, at most
};
/// none: nothing of the case is on a device
[[nodiscard]] std::optional<DeviceMemory> memory_on_device(const Plan& plan, const PairCase& c);
/// Opens the device of a case once, so that what it lacks is told before a run begins.
/// @returns whether the case fits into its memory; false only of a device that may be passed over (`automatic`)
/// @throws InputError, DeviceError
[[nodiscard]] bool has_device_room(const Plan& plan, const PairCase& c, bool is_shared);

/// Peak memory of the first of ranks that share the bodies of a case, which needs most [bytes]; with one rank that of a run.
[[nodiscard]] double memory_of_rank(const Plan& plan, const PairCase& c, int ranks);
/// Part of it that does not become less with more ranks: contact and heat [bytes].
[[nodiscard]] double unshared_memory(const Plan& plan, const PairCase& c);

/// Most numbers that a rank sends to others in an evaluation of all layers of both bodies, in bytes (docs/theory/ranks.md).
[[nodiscard]] double bytes_sent_by_rank(const Plan& plan, int ranks);

} // namespace brinell::simulation
