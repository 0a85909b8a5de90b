// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/schema.hpp"

#include "brinell/simulation/tugging.hpp"
#include "schema_parts.hpp"

namespace brinell::io
{

namespace
{

std::vector<Entry> root_entries()
{
  return {
      {.key = "scenario",
       .type = Type::choice,
       .choices = {"tugging", "indentation", "rolling"},
       .required = true,
       .text = "What is computed. tugging: the upper sphere is carried along x past the lower one at constant height "
               "or under a load; indentation: the upper body is pressed into the lower one; rolling: it rolls over "
               "it along x under load."},
      {.key = "title", .type = Type::text, .unset = "no title", .text = "Free text, copied into the results."},
  };
}

std::vector<Entry> grid_entries()
{
  const simulation::Numerics defaults;
  return {
      {.key = "grid.spacing",
       .type = Type::vector3,
       .dimension = dimension::length,
       .range = above(0.0),
       .unset = "from resolution",
       .text = "Size of the cells [dx, dy, dz]: along the motion, across it, in depth.",
       .excludes = "grid.resolution"},
      {.key = "grid.resolution",
       .type = Type::number,
       .range = between(1.0, 1000.0),
       .fallback = defaults.resolution,
       .fallback_in = {{"tugging", simulation::TuggingCase().resolution}},
       .text = "Cells per contact radius along x, estimated at the largest load; the cell sizes follow from it. "
               "Tugging: the "
               "elastic contact radius at alignment, cells of dx, 2 dx and dx/2.",
       .excludes = "grid.spacing"},
      {.key = "grid.extent",
       .type = Type::number,
       .range = between(0.5, 10.0),
       .fallback = defaults.extent,
       .text = "Factor on the first extent of the grids around contact and plastic zone; they grow where that is not "
               "enough."},
  };
}

std::vector<Entry> solver_entries()
{
  const elastoplastic::Settings defaults;
  return {
      {.key = "solver.yield_tolerance",
       .type = Type::number,
       .range = inside(0.0, 0.1),
       .fallback = defaults.yield_tolerance,
       .text = "Largest violation of the yield condition, relative to the yield stress."},
      {.key = "solver.displacement_tolerance",
       .type = Type::number,
       .range = inside(0.0, 0.1),
       .fallback = defaults.displacement_tolerance,
       .text = "Largest change of the residual displacement in the last iteration, relative to the approach at first "
               "yield."},
      {.key = "solver.contact_tolerance",
       .type = Type::number,
       .range = inside(0.0, 0.1),
       .fallback = defaults.contact_tolerance,
       .text = "Complementarity of the contact: largest gap under pressure, relative to the largest approach."},
      {.key = "solver.max_iterations",
       .type = Type::integer,
       .range = between(1, 100000),
       .fallback = std::int64_t{defaults.max_iterations},
       .text = "Iterations of an increment before it is split."},
      {.key = "solver.anderson_depth",
       .type = Type::integer,
       .range = between(0, 50),
       .fallback = std::int64_t{defaults.anderson_depth},
       .text = "Earlier iterates used to accelerate the iteration; 0: plain fixed point."},
      {.key = "solver.integration",
       .type = Type::choice,
       .choices = {"path", "backward_euler"},
       .fallback = defaults.integration == elastoplastic::Integration::path ? "path" : "backward_euler",
       .text = "Plastic strain of one step. path: along the path of the trial stress, second order in the step; "
               "backward_euler: one radial return at its end, first order, as in the paper."},
      {.key = "solver.mirror",
       .type = Type::boolean,
       .fallback = defaults.mirror,
       .text =
           "Two asperities that are alike stay mirror images of each other under exact kinematics, and bodies of one "
           "material have the same strain in pure rolling and indentation: solve one of them. false: solve both (a "
           "check; the "
           "results agree to the tolerances)."},
      {.key = "solver.shortcuts",
       .type = Type::boolean,
       .fallback = defaults.shortcuts,
       .text = "Within an increment compute the stress only in the layers near yield; its last evaluation looks at all "
               "of them, so that no yield is missed. false: every layer and every cell in every evaluation (a check; "
               "the results agree to the tolerances)."},
  };
}

std::vector<Entry> accuracy_entries()
{
  return {
      {.key = "solver.accuracy",
       .type = Type::number,
       .range = {.min = 0.0, .max = 0.5, .min_allowed = false},
       .percent = true,
       .unset = "one run, with the cells as given",
       .text =
           "Largest relative error of the key numbers that is accepted, as \"1 %\" or 0.01. The case is then run with "
           "coarser cells first, up to those given and, if need be, with finer ones, until the estimate of the error "
           "by "
           "the differences between them stays below it; summary.json tells each number's interval."},
  };
}

std::vector<Entry> output_entries()
{
  return {
      {.key = "output.snapshots",
       .type = Type::snapshots,
       .fallback = SnapshotRule{},
       .text = "Steps whose fields are stored, beside the final state, which always is. \"aligned\": the step nearest "
               "to the middle of each pass; in an indentation the steps that reach an entry of the list."},
      {.key = "output.directory",
       .type = Type::text,
       .unset = "results/NAME",
       .text = "Folder of the results, from the current directory; -o on the command line wins. NAME is that of the "
               "case file, or of "
               "its folder if the file is called case.toml."},
      {.key = "output.checkpoint_interval",
       .type = Type::number,
       .dimension = {.time = 1},
       .range = at_least(0.0),
       .fallback = 30.0,
       .text =
           "Time after which the state is stored again while the run goes on, so that brinell run --resume can go on "
           "from there. It is stored also when the run is interrupted."},
  };
}

std::vector<Entry> build_schema()
{
  std::vector<Entry> schema;
  for (auto part : {root_entries(), body_entries("lower"), body_entries("upper"), scenario_entries(), grid_entries(),
                    solver_entries(), accuracy_entries(), output_entries()})
    schema.insert(schema.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
  return schema;
}

} // namespace

const std::vector<Entry>& case_schema()
{
  static const std::vector<Entry> schema = build_schema();
  return schema;
}

const Entry* find_entry(std::string_view key)
{
  for (const Entry& entry : case_schema())
    if (entry.key == key)
      return &entry;
  return nullptr;
}

std::optional<Value> fallback_of(const Entry& entry, std::string_view scenario)
{
  for (const auto& [name, value] : entry.fallback_in)
    if (name == scenario)
      return value;
  return entry.fallback;
}

bool is_table(std::string_view key)
{
  for (const Entry& entry : case_schema())
    if (entry.key.size() > key.size() && entry.key.starts_with(key) && entry.key[key.size()] == '.')
      return true;
  return false;
}

} // namespace brinell::io
