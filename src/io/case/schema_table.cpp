// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/schema.hpp"

#include "io/scenarios/scenario_io.hpp"
#include "schema_parts.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace brinell::io
{

namespace
{

std::vector<Entry> root_entries()
{
  std::vector<std::string> meanings;
  for_each_scenario([&](const auto& io) { meanings.push_back(fmt::format("{}: {}", io.name, io.text)); });
  return {
      {.key = "scenario",
       .choices = scenarios_with([](const auto&) { return true; }),
       .required = true,
       .text = fmt::format("Scenario to compute. {}.", fmt::join(meanings, "; "))},
      bound({.key = "title", .unset = "no title", .text = "Free text, copied into the results."}, &Case::title),
  };
}

/// Default resolutions of the scenarios that differ from the common default.
std::vector<std::pair<std::string, Value>> other_resolutions()
{
  std::vector<std::pair<std::string, Value>> others;
  for_each_scenario(
      [&]<typename ScenarioCase>(const ScenarioIo<ScenarioCase>& io)
      {
        if (const double resolution = ScenarioCase().resolution; resolution != simulation::Numerics().resolution)
          others.emplace_back(io.name, resolution);
      });
  return others;
}

std::vector<Entry> grid_entries()
{
  using simulation::Domain;
  using simulation::Numerics;
  const Condition periodic{"grid.boundary", {"periodic", "periodic_x", "periodic_y"}};
  return {
      {.key = "grid.boundary",
       .choices = {"open", "periodic", "periodic_x", "periodic_y"},
       .per_axis = true,
       .fallback = "open",
       .text = "Boundary conditions: open (unloaded half spaces beyond the grids) or periodic. May be a list for x and "
               "y: [\"open\", \"periodic\"]. Periodic along y alone, with one row of cells, is plane strain."},
      {.key = "grid.size",
       .of = kind::length.list().above(0.0),
       .unset = "1 m along y",
       .text = "Period along x and along y; a single number is for both, or for the one periodic axis.",
       .when = periodic},
      {.key = "grid.cells",
       .of = kind::number.list().between(1, 65536),
       .unset = "from spacing; one along y if it alone is periodic",
       .text =
           "Number of cells in a period along x and along y; a single number is for both, or for the one periodic "
           "axis. Products of small primes are fast. One cell along an axis is for problems that are uniform along it.",
       .when = periodic},
      bound({.key = "grid.layer",
             .of = kind::length.above(0.0),
             .unset = "half of the smaller of dx and dy",
             .text = "Thickness of the layers of cells.",
             .when = periodic},
            &Numerics::domain, &Domain::layer),
      bound(
          {.key = "grid.reference",
           .of = kind::length.above(0.0),
           .unset = "2 R/e for two cylinders, as for the approach of Green (2005); otherwise the period",
           .text =
               "Distance from a line load at which its displacement is taken as zero; in plane strain the displacement "
               "has no limit but varies with the logarithm of the distance. At least the half-width of the contact.",
           .when = {"grid.boundary", {"periodic_x", "periodic_y"}}},
          &Numerics::domain, &Domain::reference),
      bound({.key = "grid.spacing",
             .of = kind::length.above(0.0),
             .unset = "from resolution",
             .text = "Size of the cells [dx, dy, dz]: along the motion, across it, in depth.",
             .excludes = "grid.resolution"},
            &Numerics::spacing),
      bound({.key = "grid.resolution",
             .of = kind::number.between(1.0, 1000.0),
             .fallback_in = other_resolutions(),
             .text = "Cells per contact radius along x, estimated at the largest load; the cell sizes follow from it. "
                     "Tugging: the elastic contact radius at alignment, cells of dx, 2 dx and dx/2.",
             .when = {"grid.boundary", {"open", "periodic_x", "periodic_y"}, "grid.cells or grid.spacing"},
             .excludes = "grid.spacing"},
            &Numerics::resolution),
      bound({.key = "grid.extent",
             .of = kind::number.between(0.5, 10.0),
             .text = "Factor on the initial extent of the grids around contact and plastic zone; the grids grow if it "
                     "is not enough."},
            &Numerics::extent),
  };
}

std::vector<Entry> solver_entries()
{
  using elastoplastic::Settings;
  const auto entry = [](const char* key, auto member, const ValueKind& of, const char* text,
                        const std::vector<std::string>& choices = {})
  {
    return bound({.key = std::string("solver.") + key, .of = of, .choices = choices, .text = text},
                 &simulation::Numerics::solver, member);
  };
  return {
      entry("yield_tolerance", &Settings::yield_tolerance, kind::number.inside(0.0, 0.1),
            "Largest violation of the yield condition, relative to the yield stress."),
      entry("displacement_tolerance", &Settings::displacement_tolerance, kind::number.inside(0.0, 0.1),
            "Largest change of the residual displacement in the last evaluation, relative to the approach at first "
            "yield, or to its change in the increment if that is larger."),
      entry(
          "contact_tolerance", &Settings::contact_tolerance, kind::number.inside(0.0, 0.1),
          "Complementarity of the contact: largest gap under pressure, relative to the largest approach. At most a "
          "thousandth of yield_tolerance and a hundredth of displacement_tolerance is used, or 1e-12 if that is more."),
      entry("max_evaluations", &Settings::max_evaluations, kind::number.between(1, 100000),
            "Largest number of evaluations of an increment before it is split; with friction, and in deep indents of "
            "soft bodies, "
            "it is multiplied by four."),
      entry("anderson_depth", &Settings::anderson_depth, kind::number.between(0, 50),
            "Earlier iterates used to accelerate the iteration, in deep indents of soft bodies four times as many; 0: "
            "plain "
            "fixed point."),
      entry("integration", &Settings::integration, {},
            "Integration of the plastic strain over a step. path: along the path of the trial stress, of second order "
            "in the step; backward_euler: one radial return at the end of the step, of first order, as in the paper.",
            {"path", "backward_euler"}),
      entry("mirror", &Settings::mirror, {},
            "Solve only one body where both always have the same fields: two equal asperities, which stay mirror "
            "images of each other under exact kinematics, or bodies of the same material in pure rolling and "
            "indentation. false: solve both (a check; the results agree within the tolerances)."),
      entry("symmetry", &Settings::symmetry, {},
            "Solve only one half if both bodies, their textures and the motion are symmetric about the plane y = 0, "
            "and the surfaces do not stick: half of the work, with the same result except for rounding. `brinell "
            "check` shows whether symmetry is used. false: solve both halves (a check)."),
      entry("shortcuts", &Settings::shortcuts, {},
            "Within an increment compute the stress only in the layers near yield; the last evaluation computes all "
            "layers, so that no yield is missed. false: all layers and all cells in every evaluation, and heat without "
            "approximations (a check; the results agree within the tolerances)."),
      entry(
          "windows", &Settings::windows, {},
          "If `shortcuts` is true and a body is longer than what an increment changes, compute the stress within an "
          "increment only in a window of columns around yielding cells and pressure; the last evaluation computes the "
          "whole body. false: no window (a check; the results agree within the tolerances)."),
      entry(
          "onset_increments", &Settings::onset_increments, kind::number.between(0, 1000),
          "Where surfaces that slide everywhere begin to slide, or reverse, friction is raised before they move: in "
          "one "
          "increment for this part of the shear yield stress of the weaker body, 1/16 by default. 0: in one increment "
          "together with the first motion, which makes the plastic work of the onset too small."),
      entry("device", &Settings::device, {},
            "Where the bodies are computed. cpu: on the processor; cuda: on a GPU, by a program that is built with "
            "CUDA; auto: on a "
            "GPU if there is one that can, otherwise on the processor; host: on the processor as a GPU would, which is "
            "slow and "
            "proves such a run without one. Results agree to about 1e-10, and a run may change its device when it is "
            "resumed. What a "
            "device does not compute (bodies with layers or inclusions, more than four back stresses) is refused.",
            {"cpu", "cuda", "auto", "host"}),
      bound({.key = "solver.accuracy",
             .of = kind::share.up_to(0.0, 0.5),
             .unset = "one run, with the cells as given",
             .text = "Largest accepted relative error of the key numbers, for example \"1 %\" or 0.01. The case is "
                     "then run with coarser cells first, then with the given cells and, if necessary, with finer ones, "
                     "until the error estimated from the differences between these runs is below it; summary.json "
                     "gives the interval of each number."},
            &Case::accuracy),
  };
}

/// A key of a point whose history is recorded.
Entry point(Entry entry)
{
  entry.list = "output.points";
  return entry;
}

std::vector<Entry> output_entries()
{
  std::string aligned;
  for_each_scenario([&](const auto& io) { aligned += io.aligned.empty() ? "" : fmt::format("; {}", io.aligned); });
  return {
      bound({.key = "output.snapshots",
             .text = fmt::format("Steps whose fields are stored, in addition to the final state, which is always "
                                 "stored. \"aligned\": the step nearest to the middle of each pass{}.",
                                 aligned)},
            &Case::snapshots),
      bound({.key = "output.fields",
             .choices = field_words(),
             .unset = "all, as far as the result stays below 200 MB; if neither body can yield, \"surface\" unless "
                      "output.depth, a plane or output.points asks for more",
             .text = "Fields of the stored states. \"surface\": all fields on surfaces, and none within the bodies. If "
                     "neither body can yield, those within are computed only if they are stored: contact and surfaces "
                     "do not need them, and they cost far more time and memory than everything else. "
                     "\"shear\", \"slip\", \"surface_temperature\" and \"heat_flux\" are the fields of the "
                     "contact of these names with all their components. Pressure and gap are always stored."},
            &Case::output, &OutputChoice::fields),
      bound({.key = "output.bodies",
             .choices = {"both", "lower", "upper"},
             .text = "Bodies whose fields are stored, on their surfaces and within them."},
            &Case::output, &OutputChoice::bodies),
      bound({.key = "output.depth",
             .of = kind::length.above(0.0),
             .unset = "the whole grid",
             .text = "Depth down to which layers are stored.",
             .excludes = "output.region_z"},
            &Case::output, &OutputChoice::cells, &StoredCells::depth),
      bound({.key = "output.region_x",
             .of = kind::length,
             .unset = "the whole grid",
             .text = "First and last x of the stored columns, on the surface of each body; equal numbers store the "
                     "nearest column, which is a plane. The fields of the contact are stored as a whole."},
            &Case::output, &OutputChoice::cells, &StoredCells::region_x),
      bound({.key = "output.region_y",
             .of = kind::length,
             .unset = "the whole grid",
             .text = "First and last y of the stored rows; equal numbers store the nearest row: [0, 0] is the plane "
                     "y = 0."},
            &Case::output, &OutputChoice::cells, &StoredCells::region_y),
      bound({.key = "output.region_z",
             .of = kind::length.at_least(0.0),
             .unset = "the whole grid",
             .text = "First and last depth of the stored layers of both bodies; equal numbers store the nearest layer: "
                     "[\"20 um\", \"20 um\"] is a plane.",
             .excludes = "output.depth"},
            &Case::output, &OutputChoice::cells, &StoredCells::region_z),
      bound({.key = "output.stride",
             .of = kind::integer.between(1, 1000),
             .text = "Distance between two stored columns, and between two rows, in cells: 2 stores a quarter of all "
                     "cells, unchanged, not means over them."},
            &Case::output, &OutputChoice::cells, &StoredCells::stride),
      bound({.key = "output.stride_z",
             .of = kind::integer.between(1, 1000),
             .text = "Distance between two stored layers, in layers: 2 stores the first, third, fifth, unchanged."},
            &Case::output, &OutputChoice::cells, &StoredCells::stride_z),
      bound({.key = "output.precision",
             .choices = {"double", "single"},
             .unset = "double, or single if the result would exceed 200 MB",
             .text = "How the numbers of the fields are stored; single precision has 7 digits and half of the size. "
                     "All computing is in double precision."},
            &Case::output, &OutputChoice::precision),
      bound({.key = "output.directory",
             .unset = "results/NAME",
             .text = "Folder of the results, relative to the current directory; -o on the command line has priority. "
                     "NAME is the name of the case file, or of its folder if the file is called case.toml."},
            &Case::directory),
      bound({.key = "output.checkpoint_interval",
             .of = kind::duration.at_least(0.0),
             .text = "Time between checkpoints, from which brinell run --resume can continue the run. A checkpoint is "
                     "also written when the run is interrupted."},
            &Case::checkpoint_interval),
      point({.key = "output.points.body",
             .choices = {"lower", "upper"},
             .unset = "the lower one",
             .text = "Body of a point at which each step records stress, plastic strain and temperature in the file "
                     "points.csv; a table, or a list of tables."}),
      point({.key = "output.points.x",
             .of = kind::length,
             .unset = "0",
             .text = "x of the point on the surface of its body. The values are those of the cell around the point."}),
      point({.key = "output.points.y", .of = kind::length, .unset = "0", .text = "y of the point."}),
      point({.key = "output.points.depth",
             .of = kind::length.at_least(0.0),
             .unset = "there is no point",
             .text = "Depth of the point below the surface."}),
  };
}

/// Keys of the tables of the scenarios.
std::vector<Entry> scenario_entries()
{
  std::vector<Entry> entries;
  for_each_scenario(
      [&](const auto& io)
      {
        for (Entry& entry : io.keys())
        {
          entry.when = {"scenario", {std::string(io.name)}};
          entries.push_back(std::move(entry));
        }
      });
  return entries;
}

} // namespace

const std::vector<Entry>& case_schema()
{
  static const std::vector<Entry> schema = []
  {
    auto all = joined({root_entries(), body_entries("lower"), body_entries("upper"), scenario_entries(),
                       interface_entries(), heat_entries(), grid_entries(), solver_entries(), output_entries()});
    for (Entry& entry : all)
      if (!entry.choices.empty() && entry.of.type != Type::words)
        entry.of.type = Type::choice;
    return all;
  }();
  return schema;
}

std::string plain_key(std::string_view key)
{
  const auto open = key.find('[');
  if (open == key.npos || !is_list_of_tables(key.substr(0, open)))
    return std::string(key);
  const auto close = key.find_first_not_of("0123456789", open + 1);
  if (close == key.npos || close == open + 1 || key[close] != ']')
    return std::string(key);
  return std::string(key.substr(0, open)) + std::string(key.substr(close + 1));
}

const Entry* find_entry(std::string_view key)
{
  if (key.find('[') != key.npos)
    if (const std::string plain = plain_key(key); plain != key)
      return find_entry(plain);
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

bool belongs_to(const Entry& entry, std::string_view scenario)
{
  const Condition& when = entry.when;
  if (when.key == "scenario")
    return std::find(when.values.begin(), when.values.end(), scenario) != when.values.end();
  const Entry* parent = when.key.empty() ? nullptr : find_entry(when.key);
  return parent == nullptr || belongs_to(*parent, scenario);
}

std::vector<std::string> keys_of_group(std::string_view group)
{
  std::vector<std::string> keys;
  for (const Entry& entry : case_schema())
    if (entry.one_of == group)
      keys.push_back(entry.key);
  return keys;
}

std::string in_words(const std::vector<std::string>& keys)
{
  return fmt::format("{} and {}", fmt::join(keys.begin(), keys.end() - 1, ", "), keys.back());
}

bool is_list_of_tables(std::string_view key)
{
  for (const Entry& entry : case_schema())
    if (!entry.list.empty() && entry.list == key)
      return true;
  return false;
}

bool is_table(std::string_view key)
{
  if (key.find('[') != key.npos)
    if (const std::string plain = plain_key(key); plain != key)
      return is_table(plain);
  for (const Entry& entry : case_schema())
    if (entry.key.size() > key.size() && entry.key.starts_with(key) && entry.key[key.size()] == '.')
      return true;
  return false;
}

} // namespace brinell::io
