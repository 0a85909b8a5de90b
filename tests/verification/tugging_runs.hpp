// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/reference/critical.hpp"
#include "brinell/simulation/run.hpp"
#include "brinell/simulation/tugging.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

/// Tugging runs that several tests look at, each computed once per process.
namespace brinell::verification
{

/// Debug builds and sanitizers are ten to fifty times slower: the expensive checks then run on smaller cases.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)
inline constexpr bool slow_build = true;
#else
inline constexpr bool slow_build = false;
#endif

/// Materials of Boucly, Nelias & Green (2006).
inline constexpr double yield_stress = 0.9115e9;
inline constexpr Elastic elastic{200e9, 0.32};

inline constitutive::Material elastic_material()
{
  return {elastic, {}};
}

inline constitutive::Material perfect_material()
{
  return {elastic, constitutive::PerfectPlasticity{yield_stress}};
}

/// First yield of the paper's two spheres, by the fit that the paper uses.
inline reference::CriticalValues critical()
{
  return reference::critical_values(0.5, contact_modulus(elastic, elastic), reference::critical_pressure_ratio(0.32),
                                    yield_stress);
}

inline simulation::Paraboloid ball(double radius)
{
  return {radius, radius};
}

/// Two spheres of 1 m of one material; interference in units of first yield. The mesh is left to the resolution.
inline simulation::TuggingCase equal_spheres(double interference_ratio, const constitutive::Material& material)
{
  simulation::TuggingCase t;
  t.lower = {ball(1.0), material};
  t.upper = {ball(1.0), material};
  t.interference = interference_ratio * critical().interference;
  t.resolution = 8.0; // these tests do not need the accuracy of the default
  return t;
}

/// The paper's case on its mesh, coarser by a factor if that is above 1.
inline simulation::TuggingCase paper_case(double interference_ratio, double coarsening = 1.0)
{
  simulation::TuggingCase t = equal_spheres(interference_ratio, perfect_material());
  t.spacing = {{3.85e-3 * coarsening, 7.7e-3 * coarsening, 1.925e-3 * coarsening}};
  return t;
}

/// A case that runs in about a second: about four cells per contact radius along x.
inline simulation::TuggingCase small_case(double interference_ratio)
{
  simulation::TuggingCase t = equal_spheres(interference_ratio, perfect_material());
  const double a = simulation::plan(t).elastic_contact_radius;
  const double cells = slow_build ? 3.0 : 5.0;
  t.spacing = {{a / cells, 1.5 * a / cells, a / cells}};
  return t;
}

/// A run with its whole history.
struct TuggingRun
{
  simulation::TuggingPlan plan;
  std::vector<simulation::TuggingRecord> history;
  simulation::TuggingSummary summary;

  /// The record at alignment, if a step falls there.
  [[nodiscard]] const simulation::TuggingRecord& aligned() const
  {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < history.size(); ++i)
      if (std::abs(history[i].X) < std::abs(history[nearest].X))
        nearest = i;
    return history[nearest];
  }
};

inline TuggingRun computed(const simulation::TuggingCase& tugging)
{
  TuggingRun run;
  run.plan = simulation::plan(tugging);
  simulation::Observer<simulation::TuggingRecord> observer;
  observer.on_step = [&](const simulation::TuggingRecord& r, int) { run.history.push_back(r); };
  run.summary = simulation::run(tugging, observer);
  return run;
}

/// The paper's case at its mesh.
inline const TuggingRun& paper_run(double interference_ratio)
{
  static std::map<double, TuggingRun> runs;
  const auto found = runs.find(interference_ratio);
  if (found != runs.end())
    return found->second;
  return runs.emplace(interference_ratio, computed(paper_case(interference_ratio))).first->second;
}

/// Largest difference of a quantity between two histories, over the largest value.
inline double difference(const TuggingRun& a, double simulation::TuggingRecord::*of_a, const TuggingRun& b,
                         double simulation::TuggingRecord::*of_b)
{
  double change = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.history.size(), b.history.size()); ++i)
  {
    change = std::max(change, std::abs(a.history[i].*of_a - b.history[i].*of_b));
    largest = std::max(largest, std::abs(a.history[i].*of_a));
  }
  return largest > 0.0 ? change / largest : change;
}

/// "alpha* = 9: what"
inline std::string labelled(double interference_ratio, const std::string& what)
{
  std::string number = std::to_string(interference_ratio);
  number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.')
    number.pop_back();
  return "alpha* = " + number + ": " + what;
}

} // namespace brinell::verification
