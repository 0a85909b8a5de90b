// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/case_template.hpp"
#include "sample.hpp"

/// Keys that fill a member by themselves: each the right one, of the scenario that is computed.
namespace brinell::io::bound_keys_test
{

namespace
{

/// A case with other values than the defaults.
template <typename ScenarioCase>
ScenarioCase scenario(const char* name, const std::vector<std::string>& overrides)
{
  return std::get<ScenarioCase>(parse_case(case_template(name), "case.toml", overrides).scenario);
}

TEST(BoundKeys, FillTheSolver)
{
  const auto solver =
      scenario<simulation::RollingCase>("rolling", {"solver.yield_tolerance=0.01", "solver.displacement_tolerance=0.02",
                                                    "solver.contact_tolerance=0.03", "solver.max_evaluations=4",
                                                    "solver.anderson_depth=5", "solver.integration=backward_euler",
                                                    "solver.mirror=false", "solver.shortcuts=false"})
          .solver;
  EXPECT_EQ(solver.yield_tolerance, 0.01);
  EXPECT_EQ(solver.displacement_tolerance, 0.02);
  EXPECT_EQ(solver.contact_tolerance, 0.03);
  EXPECT_EQ(solver.max_evaluations, 4);
  EXPECT_EQ(solver.anderson_depth, 5);
  EXPECT_EQ(solver.integration, elastoplastic::Integration::backward_euler);
  EXPECT_FALSE(solver.mirror || solver.shortcuts);
}

TEST(BoundKeys, FillTheCase)
{
  const Case c = parse_case(case_template("indentation"), "case.toml",
                            {"title=T", "solver.accuracy=5 %", "output.snapshots=every 3", "output.directory=out",
                             "output.checkpoint_interval=7 ms"});
  EXPECT_EQ(c.title, "T");
  EXPECT_EQ(c.accuracy, 0.05);
  EXPECT_EQ(c.snapshots, (SnapshotRule{.kind = SnapshotRule::Kind::every, .every = 3}));
  EXPECT_EQ(c.directory, "out");
  EXPECT_EQ(c.checkpoint_interval, 0.007);
}

TEST(BoundKeys, FillTugging)
{
  const auto t = scenario<simulation::TuggingCase>(
      "tugging", {"tugging.passes=3", "tugging.shift=20 nm", "tugging.kinematics=paper", "grid.extent=2"});
  EXPECT_EQ(t.passes, 3);
  EXPECT_EQ(t.shift, 20e-9);
  EXPECT_EQ(t.kinematics, simulation::Kinematics::paper);
  EXPECT_EQ(t.extent, 2.0);
  EXPECT_EQ(t.resolution, simulation::TuggingCase().resolution) << "its own default";
  EXPECT_NE(t.resolution, simulation::Numerics().resolution);
}

TEST(BoundKeys, FillIndentation)
{
  const auto i =
      scenario<simulation::IndentationCase>("indentation", {"indentation.steps=7", "indentation.cycles=2",
                                                            "indentation.places=[0, \"1 mm\"]", "grid.resolution=5"});
  EXPECT_EQ(i.steps, 7);
  EXPECT_EQ(i.cycles, 2);
  EXPECT_EQ(i.places, (std::vector{0.0, 0.001}));
  EXPECT_EQ(i.resolution, 5.0);
}

TEST(BoundKeys, FillRolling)
{
  const auto r = scenario<simulation::RollingCase>(
      "rolling", {"rolling.distance=0.4 mm", "rolling.shift=2 um", "rolling.slide_to_roll=0.1", "rolling.passes=4",
                  "rolling.load_steps=5", "grid.spacing=[\"4 um\", \"5 um\", \"2 um\"]"});
  EXPECT_EQ(r.distance, 4e-4);
  EXPECT_EQ(r.shift, 2e-6);
  EXPECT_EQ(r.slide_to_roll, 0.1);
  EXPECT_EQ(r.passes, 4);
  EXPECT_EQ(r.load_steps, 5);
  EXPECT_EQ(r.spacing, (Vector3{4e-6, 5e-6, 2e-6}));
}

} // namespace

} // namespace brinell::io::bound_keys_test
