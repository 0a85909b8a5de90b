// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"
#include "brinell/io/member_keys.hpp"
#include "brinell/simulation/tugging.hpp"

#include <string>

/// Two equal spheres, and what the plan of a case says against it.
namespace brinell::simulation
{

inline constexpr double critical_interference = 2.214290e-4; // Boucly, Nelias & Green (2006)

inline TuggingCase spheres(double interference_ratio)
{
  const constitutive::Material material{{200e9, 0.32}, constitutive::PerfectPlasticity{0.9115e9}};
  TuggingCase t;
  t.lower = {Paraboloid{1.0, 1.0}, material};
  t.upper = {Paraboloid{1.0, 1.0}, material};
  t.interference = interference_ratio * critical_interference;
  return t;
}

inline std::string refusal(const TuggingCase& tugging)
{
  try
  {
    (void)plan(tugging);
  }
  catch (const InputError& error)
  {
    return io::with_keys(error.what());
  }
  return "";
}

} // namespace brinell::simulation
