// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/citations.hpp"

#include "brinell/io/versions.hpp"
#include "references.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

namespace brinell::io
{

namespace
{

using simulation::IndentationCase;
using simulation::RollingCase;
using simulation::TuggingCase;

/// Sources in the order of their first use; a second use is added to the first one.
class Sources
{
public:
  void add(Reference reference, std::string_view use)
  {
    const auto known = std::find_if(citations_.begin(), citations_.end(),
                                    [&](const Citation& c) { return c.reference.key == reference.key; });
    if (known == citations_.end())
      citations_.push_back({std::move(reference), std::string(use)});
    else if (known->use.find(use) == known->use.npos) // both bodies may have the same law
      known->use += fmt::format("; {}", use);
  }
  [[nodiscard]] std::vector<Citation> take() && { return std::move(citations_); }

private:
  std::vector<Citation> citations_;
};

void add_scenario(const TuggingCase& tugging, Sources& sources)
{
  sources.add(references::boucly_2006(), "tugging of two asperities, their motion and forces");
  if (tugging.kinematics == simulation::Kinematics::paper)
    sources.add(references::boucly_2006(), "kinematics of Eqs. 9 to 13");
}

void add_scenario(const IndentationCase& /*indentation*/, Sources& /*sources*/) {}

void add_scenario(const RollingCase& rolling, Sources& sources)
{
  sources.add(references::boucly_2006(), "rolling: both surfaces and their strain are carried past the contact");
  const bool yields = rolling.lower.material.is_plastic() || rolling.upper.material.is_plastic();
  if (yields && rolling.passes > 1)
    sources.add(references::johnson_1985(), "shakedown under repeated passes");
}

/// Whether a body is a cone or a pyramid.
bool has_tip(const Case& c)
{
  return std::visit([](const auto& scenario)
                    { return !relative_curvature(scenario.lower.shape, scenario.upper.shape).has_value(); },
                    c.scenario);
}

void add_contact(const Case& c, Sources& sources)
{
  sources.add(references::love_1929(), "surface displacement and stress under the pressure of a cell");
  sources.add(references::liu_2000(), "convolutions with zero padding (DC-FFT)");
  sources.add(references::polonsky_1999(), "contact by constrained conjugate gradients");
  const bool by_hertz_pressure = c.values.find("rolling.hertz_pressure") != nullptr;
  if (has_tip(c))
    sources.add(references::sneddon_1965(), "elastic contact of a tip, from which the grid is sized");
  else
    sources.add(references::hertz_1882(), by_hertz_pressure ? "load from the peak pressure of the elastic contact"
                                                            : "elastic contact, from which the grid is sized");
}

void add_law(const constitutive::SwiftHardening& /*law*/, std::string_view name, Sources& sources)
{
  if (name == "hollomon")
    sources.add(references::hollomon_1945(), "hardening law");
  else
    sources.add(references::swift_1952(), "hardening law");
  if (name == "swift_microstrain")
    sources.add(references::jacq_2002(), "hardening law in millionths of strain");
}
void add_law(const constitutive::LudwikHardening& /*law*/, std::string_view /*name*/, Sources& sources)
{
  sources.add(references::ludwik_1909(), "hardening law");
}
void add_law(const constitutive::VoceHardening& /*law*/, std::string_view /*name*/, Sources& sources)
{
  sources.add(references::voce_1948(), "hardening law");
}
/// A constant, a straight line or points need no source.
template <typename Law>
void add_law(const Law& /*law*/, std::string_view /*name*/, Sources& /*sources*/)
{
}

void add_back_stresses(const std::vector<constitutive::KinematicTerm>& terms, Sources& sources)
{
  const auto recalls = [](const constitutive::KinematicTerm& term) { return term.recall > 0.0; };
  if (!std::all_of(terms.begin(), terms.end(), recalls))
    sources.add(references::prager_1956(), "linear kinematic hardening");
  if (std::any_of(terms.begin(), terms.end(), recalls))
    sources.add(references::armstrong_1966(), "kinematic hardening with recall");
  if (terms.size() > 1)
    sources.add(references::chaboche_1986(), "several back stresses");
}

void add_material(const constitutive::Material& material, std::string_view law, Sources& sources)
{
  if (!material.is_plastic())
    return;
  std::visit([&](const auto& l) { add_law(l, law, sources); }, *material.hardening);
  add_back_stresses(material.kinematic, sources);
}

void add_solver(const elastoplastic::Settings& solver, Sources& sources)
{
  sources.add(references::jacq_2002(), "elastic-plastic contact by half-space solutions; residual displacement by "
                                       "reciprocity");
  sources.add(references::chiu_1978(), "residual stress of plastic strain in a half space, here by wavenumber");
  if (solver.integration == elastoplastic::Integration::path)
    sources.add(references::ortiz_1985(), "plastic strain of a step, of second order (generalised trapezoidal rule)");
  else
  {
    sources.add(references::wilkins_1964(), "plastic strain of a step by radial return");
    sources.add(references::simo_1998(), "return mapping by backward Euler");
  }
  if (solver.anderson_depth > 0)
  {
    sources.add(references::anderson_1965(), "acceleration of the iteration");
    sources.add(references::walker_2011(), "acceleration of the iteration (type II)");
  }
}

template <typename ScenarioCase>
void add_bodies(const ScenarioCase& scenario, const Case& c, Sources& sources)
{
  const auto law = [&](const char* body)
  {
    const Value* name = c.values.find(fmt::format("{}.material.hardening.law", body));
    return name ? std::get<std::string>(*name) : std::string();
  };
  for (const auto* body : {&scenario.lower, &scenario.upper})
    if (std::holds_alternative<simulation::Dent>(body->texture))
      sources.add(references::ville_1999(), "shape of dents and bumps");
  add_material(scenario.lower.material, law("lower"), sources);
  add_material(scenario.upper.material, law("upper"), sources);
  if (scenario.lower.material.is_plastic() || scenario.upper.material.is_plastic())
    add_solver(scenario.solver, sources);
}

} // namespace

std::vector<Citation> citations(const Case& c)
{
  Sources sources;
  std::visit([&](const auto& scenario) { add_scenario(scenario, sources); }, c.scenario);
  add_contact(c, sources);
  if (c.first_yield)
    sources.add(references::green_2005(), "values at first yield, alpha_c, P_c and U_c");
  std::visit([&](const auto& scenario) { add_bodies(scenario, c, sources); }, c.scenario);
  return std::move(sources).take();
}

std::vector<std::string> citation_lines(const Case& c)
{
  std::vector<std::string> lines{fmt::format("{} [the program]", reference_text(brinell_reference()))};
  for (const Citation& citation : citations(c))
    lines.push_back(fmt::format("{} [{}]", reference_text(citation.reference), citation.use));
  return lines;
}

} // namespace brinell::io
