// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/citations.hpp"

#include "io/case/body_options.hpp"
#include "io/scenarios/scenario_io.hpp"
#include "sources.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <optional>

namespace brinell::io
{

namespace
{

/// Whether a body is a cone or a pyramid.
bool has_tip(const Case& c)
{
  return std::visit([](const auto& scenario)
                    { return !relative_curvature(scenario.lower.shape, scenario.upper.shape).has_value(); },
                    c.scenario);
}

void cite_contact(Sources& sources, const Case& c)
{
  sources.add("love1929", "surface displacement and stress under the pressure of a cell");
  sources.add("liu2000", "convolutions with zero padding (DC-FFT)");
  sources.add("polonsky1999", "contact by constrained conjugate gradients");
  if (has_tip(c))
    sources.add("sneddon1965", "elastic contact of a tip, from which the grid is sized");
  else
    sources.add("hertz1882", sources.has(c.values.get<std::string>("scenario") + ".hertz_pressure")
                                 ? "load from the peak pressure of the elastic contact"
                                 : "elastic contact, from which the grid is sized");
  if (c.first_yield)
    sources.add("green2005", "values at first yield, alpha_c, P_c and U_c");
}

/// Cites the source of the chosen option, if it has one; a constant, a straight line or a table has none.
template <typename Product>
void cite_option(Sources& sources, const std::string& key, const std::vector<Option<Product>>& options,
                 std::string_view use)
{
  for (const Option<Product>& option : options)
    if (!option.source.empty() && sources.is(key, option.name))
      sources.add(option.source, use);
}

void cite_hardening(Sources& sources, const std::string& body, const constitutive::Material& material)
{
  const std::string law = body + ".material.hardening.law";
  cite_option(sources, law, law_options(), "hardening law");
  if (sources.is(law, "swift_microstrain"))
    sources.add("jacq2002", "hardening law in millionths of strain");
  const auto& terms = material.kinematic;
  const auto recalls = [](const constitutive::KinematicTerm& term) { return term.recall > 0.0; };
  if (!std::all_of(terms.begin(), terms.end(), recalls))
    sources.add("prager1956", "linear kinematic hardening");
  if (std::any_of(terms.begin(), terms.end(), recalls))
    sources.add("armstrong1966", "kinematic hardening with recall");
  if (terms.size() > 1)
    sources.add("chaboche1986", "several back stresses");
  if (material.softening && std::holds_alternative<constitutive::JohnsonCookSoftening>(*material.softening))
    sources.add("johnson1983", "yield stress by temperature");
}

void cite_fatigue(Sources& sources, const std::optional<constitutive::Fatigue>& fatigue)
{
  if (!fatigue)
    return;
  constexpr std::array criteria{"", "dangvan1989", "crossland1956", "findley1959", "fatemi1988"};
  if (const char* source = criteria[static_cast<std::size_t>(fatigue->criterion)]; *source != '\0')
    sources.add(source, "criterion of fatigue");
  sources.add("lundberg1947", "relative life by the stress-volume");
}

void cite_solver(Sources& sources, const elastoplastic::Settings& solver)
{
  sources.add("jacq2002", "elastic-plastic contact by half-space solutions; residual displacement by reciprocity");
  sources.add("chiu1978", "residual stress of plastic strain in a half space, here by wavenumber");
  if (solver.integration == elastoplastic::Integration::path)
    sources.add("ortiz1985", "plastic strain of a step, of second order (generalised trapezoidal rule)");
  else
  {
    sources.add("wilkins1964", "plastic strain of a step by radial return");
    sources.add("simo1998", "return mapping by backward Euler");
  }
  if (solver.anderson_depth > 0)
  {
    sources.add("anderson1965", "acceleration of the iteration");
    sources.add("walker2011", "acceleration of the iteration (type II)");
  }
}

} // namespace

std::vector<Citation> citations(const Case& c)
{
  Sources sources(c);
  std::visit(
      [&](const auto& scenario)
      {
        const bool yields = scenario.lower.material.is_plastic() || scenario.upper.material.is_plastic();
        io_of(scenario).cite(sources, scenario);
        cite_contact(sources, c);
        for (const auto& [key, value] : c.values.all())
          if (const std::string plain = plain_key(key); plain == "lower.texture.type" || plain == "upper.texture.type")
            cite_option(sources, key, texture_options(),
                        std::get<std::string>(value) == "random" ? "spectra of rough surfaces"
                                                                 : "shape of dents and bumps");
        if (scenario.wear.wears())
          sources.add("archard1953", "worn depth by pressure and slip");
        if (scenario.lower.material.electrical && scenario.upper.material.electrical)
        {
          sources.add("barber2003", "resistance of a contact by its stiffness");
          sources.add("kohlrausch1900", "temperature of a contact by its voltage");
        }
        cite_hardening(sources, "lower", scenario.lower.material);
        cite_hardening(sources, "upper", scenario.upper.material);
        cite_fatigue(sources, scenario.lower.fatigue);
        cite_fatigue(sources, scenario.upper.fatigue);
        if (yields)
          cite_solver(sources, scenario.solver);
      },
      c.scenario);
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
