// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/member_keys.hpp"
#include "brinell/simulation/run.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

/// What the tests of all scenarios do with a case.
namespace brinell::simulation
{

/// All rows of a run.
template <typename ScenarioCase>
std::vector<typename ScenarioCase::Record> history(const ScenarioCase& c)
{
  std::vector<typename ScenarioCase::Record> rows;
  Run run(c);
  while (!run.is_done())
    rows.push_back(run.step());
  return rows;
}

/// The key that a plan is refused for, and a part of the message as users of a case file read it.
template <typename ScenarioCase>
void expect_refused(const ScenarioCase& c, const std::string& key, const std::string& part)
{
  try
  {
    static_cast<void>(plan(c));
    ADD_FAILURE() << "not refused: " << key << ", " << part;
  }
  catch (const PlanError& error)
  {
    EXPECT_EQ(io::key_of_member(error.member()), key) << error.what();
    const std::string text = io::with_keys(error.what());
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n  in: " << text;
  }
}

/// The same of a case that is changed.
template <typename ScenarioCase, typename Change>
void expect_refused(const std::string& key, const std::string& part, ScenarioCase c, const Change& change)
{
  change(c);
  expect_refused(c, key, part);
}

} // namespace brinell::simulation
