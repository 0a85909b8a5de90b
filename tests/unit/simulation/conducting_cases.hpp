// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/run.hpp"
#include "brinell/simulation/scenarios.hpp"
#include "template_cases.hpp"

#include <vector>

/// Cases of bodies that conduct current.
namespace brinell::simulation::conducting_cases
{

inline constexpr constitutive::Electrical copper{1.7e-8, 4e-3}, bronze{1.2e-7, 0.0};

template <typename Case>
Case conducting()
{
  Case c = test::template_case<Case>();
  c.lower.material.electrical = bronze;
  c.upper.material.electrical = copper;
  c.current.voltage = {0.05};
  return c;
}

template <typename Case>
std::vector<typename Case::Record> rows_of(const Case& c)
{
  simulation::Run<Case> run(c);
  std::vector<typename Case::Record> rows;
  while (!run.is_done())
    rows.push_back(run.step());
  return rows;
}

/// A ball that is pressed into a flat; nothing yields.
inline IndentationCase ball()
{
  IndentationCase c = conducting<IndentationCase>();
  c.lower.material.hardening.reset();
  c.upper.material.hardening.reset();
  c.sequence = {{contact::Drive::Kind::load, 1.0}};
  c.steps = 3;
  return c;
}

/// A ball that is rubbed on a flat and heated by friction and current.
inline FrettingCase hot_fretting()
{
  FrettingCase c = conducting<FrettingCase>();
  for (constitutive::Material* material : {&c.lower.material, &c.upper.material})
  {
    material->thermal = Thermal{.conductivity = 50.0, .density = 7850.0, .specific_heat = 460.0, .expansion = 12e-6};
    material->electrical = bronze;
    material->hardening.reset();
  }
  c.frequency = 100.0;
  return c;
}

} // namespace brinell::simulation::conducting_cases
