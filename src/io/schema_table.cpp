// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/schema.hpp"

#include "brinell/simulation/tugging.hpp"

namespace brinell::io
{

namespace
{

Range above(double min)
{
  return {.min = min, .min_allowed = false};
}
Range at_least(double min)
{
  return {.min = min};
}
Range between(double min, double max)
{
  return {.min = min, .max = max};
}
Range inside(double min, double max)
{
  return {.min = min, .max = max, .min_allowed = false, .max_allowed = false};
}

std::vector<Entry> root_entries()
{
  return {
      {.key = "scenario",
       .type = Type::choice,
       .choices = {"tugging"},
       .required = true,
       .text =
           "What is computed. tugging: the upper sphere is carried along x past the lower one at constant height, so "
           "that they interfere."},
      {.key = "title", .type = Type::text, .unset = "no title", .text = "Free text, copied into the results."},
  };
}

/// Names of the hardening laws; the first one is none.
std::vector<std::string> law_names()
{
  return {"none", "perfect", "linear", "swift", "swift_microstrain", "hollomon", "ludwik", "voce", "table"};
}

/// The entry applies to a body that can yield.
Condition any_law(const std::string& key)
{
  const std::vector<std::string> names = law_names();
  return {key, {names.begin() + 1, names.end()}};
}

/// Parameters of the hardening laws of one body.
std::vector<Entry> hardening_entries(const std::string& body)
{
  const std::string law = body + ".material.hardening.law";
  const Condition yields = any_law(law);
  return {
      {.key = body + ".material.hardening.yield_stress",
       .type = Type::number,
       .dimension = dimension::pressure,
       .range = above(0.0),
       .required = true,
       .text = "Yield stress S_y in uniaxial tension, before any plastic strain.",
       .hint = "law = \"none\" keeps the body elastic",
       .when = {law, {"perfect", "linear", "hollomon", "ludwik", "voce"}}},
      {.key = body + ".material.hardening.modulus",
       .type = Type::number,
       .dimension = dimension::pressure,
       .range = at_least(0.0),
       .required = true,
       .text = "Growth of the yield stress per unit of equivalent plastic strain.",
       .when = {law, {"linear"}}},
      {.key = body + ".material.hardening.coefficient",
       .type = Type::number,
       .dimension = dimension::pressure,
       .range = above(0.0),
       .required = true,
       .text = "Factor of the power law.",
       .when = {law, {"swift", "swift_microstrain", "hollomon", "ludwik"}}},
      {.key = body + ".material.hardening.offset",
       .type = Type::number,
       .range = above(0.0),
       .required = true,
       .text = "Strain at which the power law begins; in millionths with swift_microstrain.",
       .when = {law, {"swift", "swift_microstrain"}}},
      {.key = body + ".material.hardening.exponent",
       .type = Type::number,
       .range = {.min = 0.0, .max = 1.0, .min_allowed = false},
       .required = true,
       .text = "Exponent of the power law.",
       .when = {law, {"swift", "swift_microstrain", "hollomon", "ludwik"}}},
      {.key = body + ".material.hardening.saturation",
       .type = Type::number,
       .dimension = dimension::pressure,
       .range = at_least(0.0),
       .required = true,
       .text = "Largest rise of the yield stress.",
       .when = {law, {"voce"}}},
      {.key = body + ".material.hardening.rate",
       .type = Type::number,
       .range = above(0.0),
       .required = true,
       .text = "How fast the yield stress saturates with plastic strain.",
       .when = {law, {"voce"}}},
      {.key = body + ".material.hardening.file",
       .type = Type::text,
       .unset = "plastic_strain and stress",
       .text = "Text file with a point per line, plastic strain and stress in Pa; from the folder of the case.",
       .when = {law, {"table"}},
       .excludes = body + ".material.hardening.plastic_strain"},
      {.key = body + ".material.hardening.plastic_strain",
       .type = Type::numbers,
       .range = at_least(0.0),
       .unset = "from file",
       .text = "Equivalent plastic strains of the points, ascending from 0.",
       .when = {law, {"table"}},
       .excludes = body + ".material.hardening.file"},
      {.key = body + ".material.hardening.stress",
       .type = Type::numbers,
       .dimension = dimension::pressure,
       .range = above(0.0),
       .unset = "from file",
       .text = "Yield stresses of the points, as many; they must not fall.",
       .when = {law, {"table"}}},
      {.key = body + ".material.hardening.kinematic_moduli",
       .type = Type::numbers,
       .dimension = dimension::pressure,
       .range = at_least(0.0),
       .unset = "no back stress",
       .text =
           "Kinematic hardening beside any law: moduli C of the back stresses, d alpha = 2/3 C d eps - recall alpha "
           "d e (Armstrong and Frederick; several: Chaboche).",
       .when = yields},
      {.key = body + ".material.hardening.kinematic_recall",
       .type = Type::numbers,
       .range = at_least(0.0),
       .unset = "zeros: linear (Prager)",
       .text = "Recall of each back stress; it saturates at C / recall in uniaxial tension.",
       .when = yields},
  };
}

/// What changes with depth in one body.
std::vector<Entry> depth_entries(const std::string& body)
{
  const Condition yields = any_law(body + ".material.hardening.law");
  return {
      {.key = body + ".material.yield_profile.depth",
       .type = Type::numbers,
       .dimension = dimension::length,
       .range = at_least(0.0),
       .unset = "the same at every depth",
       .text =
           "Depths at which yield_profile.factor is given, ascending; linear between, constant beyond. For nitrided or "
           "case-hardened layers. alpha_c, P_c and U_c stay those of S_y.",
       .when = yields},
      {.key = body + ".material.yield_profile.factor",
       .type = Type::numbers,
       .range = above(0.0),
       .unset = "1",
       .text = "Factors on the yield stress at these depths.",
       .when = yields},
      {.key = body + ".material.initial_stress.depth",
       .type = Type::numbers,
       .dimension = dimension::length,
       .range = at_least(0.0),
       .unset = "none",
       .text = "Depths at which initial_stress.value is given, ascending; linear between, constant beyond.",
       .when = yields},
      {.key = body + ".material.initial_stress.value",
       .type = Type::numbers,
       .dimension = dimension::pressure,
       .unset = "none",
       .text = "Residual stress xx = yy before the first load, tension positive, below the yield stress.",
       .when = yields},
  };
}

/// Keys of one body.
std::vector<Entry> body_entries(const std::string& body)
{
  const std::string law = body + ".material.hardening.law";
  return {
      {.key = body + ".shape.type",
       .type = Type::choice,
       .choices = {"sphere"},
       .required = true,
       .text = "Shape of the surface."},
      {.key = body + ".shape.radius",
       .type = Type::number,
       .dimension = dimension::length,
       .range = above(0.0),
       .required = true,
       .text = "Radius of the sphere.",
       .when = {body + ".shape.type", {"sphere"}}},
      {.key = body + ".material.young_modulus",
       .type = Type::number,
       .dimension = dimension::pressure,
       .range = above(0.0),
       .required = true,
       .text = "Young's modulus E.",
       .hint = "a steel has about 200 GPa"},
      {.key = body + ".material.poisson_ratio",
       .type = Type::number,
       .range = inside(-1.0, 0.5),
       .required = true,
       .text = "Poisson's ratio nu.",
       .hint = "a steel has about 0.3"},
      {.key = law,
       .type = Type::choice,
       .choices = law_names(),
       .fallback = "none",
       .text = "Yield stress sigma_y as a function of the equivalent plastic strain e. none: the body stays elastic; "
               "perfect: S_y; linear: S_y + modulus e; swift: coefficient (offset + e)^exponent; swift_microstrain: "
               "coefficient (offset + 1e6 e)^exponent; hollomon: coefficient (e_0 + e)^exponent with e_0 such that it "
               "begins at S_y; ludwik: S_y + coefficient e^exponent; voce: S_y + saturation (1 - exp(-rate e)); table: "
               "linear between points, constant after the last one."},
  };
}

std::vector<Entry> tugging_entries()
{
  const simulation::TuggingCase defaults;
  const Condition tugging{"scenario", {"tugging"}};
  return {
      {.key = "tugging.normalised",
       .type = Type::boolean,
       .fallback = true,
       .text =
           "Whether interference is given in critical interferences alpha_c, at which the first point yields; needs a "
           "body that can yield.",
       .when = tugging},
      {.key = "tugging.interference",
       .type = Type::number,
       .dimension = dimension::length,
       .range = above(0.0),
       .required = true,
       .text = "Largest overlap of the undeformed spheres, reached when their centres are aligned.",
       .when = tugging,
       .pure_if = "tugging.normalised"},
      {.key = "tugging.shift",
       .type = Type::number,
       .dimension = dimension::length,
       .range = above(0.0),
       .unset = "one cell, dx",
       .text =
           "Arc by which the contact moves on each body per step (mean of both bodies): a whole multiple of dx / 2.",
       .when = tugging},
      {.key = "tugging.kinematics",
       .type = Type::choice,
       .choices = {"exact", "paper"},
       .fallback = "exact",
       .text = "Relation of arc and sliding distance. exact: X = omega tan(theta); paper: Eqs. 9-13 of Boucly, Nelias, "
               "Green (2006).",
       .when = tugging},
      {.key = "tugging.passes",
       .type = Type::integer,
       .range = between(1, 10000),
       .fallback = std::int64_t{defaults.passes},
       .text = "How often the upper sphere passes; after each pass it returns to the start, and both meet deformed.",
       .when = tugging},
  };
}

std::vector<Entry> grid_entries()
{
  const simulation::TuggingCase defaults;
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
       .text = "Cells per elastic contact radius along x at alignment; the cell sizes follow from it.",
       .excludes = "grid.spacing"},
      {.key = "grid.extent",
       .type = Type::number,
       .range = between(0.5, 10.0),
       .fallback = defaults.extent,
       .text = "Factor on the automatic extent of the grids around contact and plastic zone."},
  };
}

std::vector<Entry> solver_entries()
{
  const elastoplastic::Settings defaults;
  return {
      {.key = "solver.yield_tolerance",
       .type = Type::number,
       .range = inside(0.0, 1.0),
       .fallback = defaults.yield_tolerance,
       .text = "Largest violation of the yield condition, relative to the yield stress."},
      {.key = "solver.displacement_tolerance",
       .type = Type::number,
       .range = inside(0.0, 1.0),
       .fallback = defaults.displacement_tolerance,
       .text = "Largest change of the residual displacement in the last iteration, relative to alpha_c."},
      {.key = "solver.contact_tolerance",
       .type = Type::number,
       .range = inside(0.0, 1.0),
       .fallback = defaults.contact_tolerance,
       .text = "Complementarity of the contact: largest gap under pressure, relative to the interference."},
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
       .text = "Two asperities that are alike stay mirror images of each other under exact kinematics: solve one and "
               "mirror it. false: solve both (a check; the results agree to the tolerances)."},
  };
}

std::vector<Entry> output_entries()
{
  return {
      {.key = "output.snapshots",
       .type = Type::snapshots,
       .fallback = SnapshotRule{},
       .text = "Steps whose fields are stored, beside the final state, which always is. \"aligned\": the step nearest "
               "to X = 0 of each pass."},
      {.key = "output.directory",
       .type = Type::text,
       .unset = "results/NAME",
       .text = "Folder of the results, from the current directory; -o on the command line wins. NAME is that of the "
               "case file, or of "
               "its folder if the file is called case.toml."},
  };
}

std::vector<Entry> build_schema()
{
  std::vector<Entry> schema;
  for (auto part : {root_entries(), body_entries("lower"), hardening_entries("lower"), depth_entries("lower"),
                    body_entries("upper"), hardening_entries("upper"), depth_entries("upper"), tugging_entries(),
                    grid_entries(), solver_entries(), output_entries()})
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

bool is_table(std::string_view key)
{
  for (const Entry& entry : case_schema())
    if (entry.key.size() > key.size() && entry.key.starts_with(key) && entry.key[key.size()] == '.')
      return true;
  return false;
}

} // namespace brinell::io
