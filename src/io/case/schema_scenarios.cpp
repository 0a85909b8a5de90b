// SPDX-License-Identifier: BSD-3-Clause
#include "schema_parts.hpp"

namespace brinell::io
{

namespace
{

using simulation::IndentationCase;
using simulation::RollingCase;
using simulation::TuggingCase;

std::vector<Entry> tugging_entries()
{
  return {
      {.key = "tugging.normalised",
       .type = Type::boolean,
       .fallback = true,
       .text = "Whether the interference is given in critical interferences alpha_c, at which the first point yields, "
               "and the load in critical loads P_c; needs a body that can yield, and bodies whose relative curvature "
               "is the same along x and y, or cylinders in plane strain."},
      {.key = "tugging.interference",
       .type = Type::number,
       .dimension = dimension::length,
       .range = above(0.0),
       .unset = "tugging.load",
       .text = "Largest overlap of the undeformed bodies without their textures, reached when their centres are "
               "aligned; the height of the centres is constant.",
       .excludes = "tugging.load",
       .pure_if = "tugging.normalised"},
      {.key = "tugging.load",
       .type = Type::number,
       .dimension = dimension::force,
       .range = above(0.0),
       .unset = "tugging.interference",
       .text = "Instead of the interference: a normal force that is kept while the upper body rides over the lower "
               "one; in critical loads P_c if normalised. It comes up in the first eighth of a pass and goes down in "
               "the last. Exact kinematics only.",
       .excludes = "tugging.interference",
       .pure_if = "tugging.normalised"},
      bound({.key = "tugging.shift",
             .dimension = dimension::length,
             .range = above(0.0),
             .unset = "one cell, dx",
             .text =
                 "Arc by which the contact moves on each body per step (mean of both bodies). Best a whole multiple of "
                 "dx / 2: else "
                 "the surfaces are interpolated between cells."},
            &Draft::tugging, &TuggingCase::shift),
      bound(
          {.key = "tugging.kinematics",
           .choices = {"exact", "paper"},
           .text =
               "Relation of arc and sliding distance. exact: X = omega tan(theta); paper: Eqs. 9-13 of Boucly, Nelias, "
               "Green (2006)."},
          &Draft::tugging, &TuggingCase::kinematics),
      bound(
          {.key = "tugging.passes",
           .range = between(1, 10000),
           .text = "How often the upper body passes; after each pass it returns to the start, and both meet deformed."},
          &Draft::tugging, &TuggingCase::passes),
  };
}

std::vector<Entry> indentation_entries()
{
  return {
      {.key = "indentation.normalised",
       .type = Type::boolean,
       .fallback = false,
       .text = "Whether load and approach are given in their values at first yield, P_c and alpha_c; needs round "
               "bodies, or cylinders in plane strain, of which one can yield."},
      {.key = "indentation.load",
       .type = Type::numbers,
       .dimension = dimension::force,
       .range = at_least(0.0),
       .unset = "indentation.approach",
       .text = "Loads to be reached one after the other, from none: [\"10 N\", 0] presses and lifts off.",
       .excludes = "indentation.approach",
       .pure_if = "indentation.normalised"},
      {.key = "indentation.approach",
       .type = Type::numbers,
       .dimension = dimension::length,
       .range = at_least(0.0),
       .unset = "indentation.load",
       .text = "The same, imposed as approach of the bodies from the touch of the undeformed ones.",
       .excludes = "indentation.load",
       .pure_if = "indentation.normalised"},
      {.key = "indentation.pressure",
       .type = Type::numbers,
       .dimension = dimension::pressure,
       .range = at_least(0.0),
       .unset = "indentation.load or indentation.approach",
       .text = "The same, imposed as mean pressure over the period; with grid.boundary = \"periodic\"."},
      {.key = "indentation.mean_gap",
       .type = Type::numbers,
       .dimension = dimension::length,
       .range = above(0.0),
       .unset = "indentation.load or indentation.approach",
       .text = "The same, imposed as mean gap of the deformed surfaces over the period, which is the smaller, the more "
               "they are pressed; with grid.boundary = \"periodic\". A gap larger than that of the first touch parts "
               "them: [\"0.1 um\", \"5 um\"] presses and lifts off."},
      bound({.key = "indentation.steps",
             .range = between(1, 100000),
             .text =
                 "Steps from one entry of the list to the next, of equal approach or mean gap; of equal load^(2/3) if "
                 "the load is imposed."},
            &Draft::indentation, &IndentationCase::steps),
      bound({.key = "indentation.cycles",
             .range = between(1, 10000),
             .text = "How often the list is gone through at each place."},
            &Draft::indentation, &IndentationCase::cycles),
      bound({.key = "indentation.places",
             .dimension = dimension::length,
             .text = "Places along x that are indented one after the other."},
            &Draft::indentation, &IndentationCase::places),
  };
}

std::vector<Entry> rolling_entries()
{
  const auto drive = [](const char* key, Dimension dimension, const char* text)
  {
    return Entry{.key = std::string("rolling.") + key,
                 .type = Type::number,
                 .dimension = dimension,
                 .range = above(0.0),
                 .unset = "not imposed",
                 .text = text,
                 .hint = "one of rolling.load, rolling.hertz_pressure and rolling.approach"};
  };
  return {
      drive("load", dimension::force, "Load kept while rolling."),
      drive("hertz_pressure", dimension::pressure,
            "The load instead by the peak pressure that it would have in elastic contact (Hertz)."),
      drive("approach", dimension::length, "Approach kept while rolling, instead of a load."),
      bound({.key = "rolling.distance",
             .dimension = dimension::length,
             .range = above(0.0),
             .required = true,
             .text =
                 "Length of the track on the lower body, from -distance/2 to distance/2; in an even number of steps."},
            &Draft::rolling, &RollingCase::distance),
      bound({.key = "rolling.shift",
             .dimension = dimension::length,
             .range = above(0.0),
             .unset = "one cell, dx",
             .text = "By which the contact moves on the lower body per step."},
            &Draft::rolling, &RollingCase::shift),
      bound({.key = "rolling.slide_to_roll",
             .range = up_to(-2.0, 2.0),
             .text = "Difference over mean of the speeds at which the surfaces of lower and upper body pass the "
                     "contact. 0: pure "
                     "rolling; 2: the upper body slides without turning. Without friction unless interface.friction "
                     "says otherwise."},
            &Draft::rolling, &RollingCase::slide_to_roll),
      bound({.key = "rolling.passes",
             .range = between(1, 100000),
             .text = "How often the track is rolled over. Each pass begins on the same spots of both bodies."},
            &Draft::rolling, &RollingCase::passes),
      bound({.key = "rolling.load_steps",
             .range = between(1, 100000),
             .text = "Steps in which the upper body is pressed on before a pass and lifted off after it."},
            &Draft::rolling, &RollingCase::load_steps),
  };
}

} // namespace

std::vector<Entry> scenario_entries()
{
  std::vector<Entry> entries;
  for (auto part : {tugging_entries(), indentation_entries(), rolling_entries()})
    for (Entry& entry : part)
    {
      entry.when = {"scenario", {entry.key.substr(0, entry.key.find('.'))}};
      entries.push_back(std::move(entry));
    }
  return entries;
}

} // namespace brinell::io
