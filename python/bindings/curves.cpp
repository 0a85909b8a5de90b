// SPDX-License-Identifier: BSD-3-Clause
#include "arrays.hpp"
#include "module.hpp"

#include "brinell/io/measured_curve.hpp"
#include "brinell/io/units.hpp"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <map>

using namespace nanobind::literals;

namespace brinell::python
{

namespace
{

using Words = std::map<std::string, std::string>;

/// The choice with the same index as the word of a key.
template <typename Choice, std::size_t N>
void read_choice(const Words& words, const std::string& key, const std::array<std::string_view, N>& allowed,
                 Choice& choice)
{
  const auto given = words.find(key);
  if (given == words.end())
    return;
  const auto found = std::find(allowed.begin(), allowed.end(), given->second);
  if (found == allowed.end())
    throw InputError(
        fmt::format("{} = \"{}\" is not known; allowed: \"{}\"", key, given->second, fmt::join(allowed, "\", \"")));
  choice = static_cast<Choice>(found - allowed.begin());
}

std::vector<double> copied(const Input& array)
{
  return {array.data(), array.data() + array.size()};
}

io::HardeningCurve hardening_curve(const Input& strain, const Input& stress, const Words& words, double yield_offset,
                                   std::optional<double> young_modulus, bool monotone)
{
  io::CurveRules rules{.offset = yield_offset, .young_modulus = young_modulus, .monotone = monotone};
  read_choice(words, "strain_type", io::curve_words::strain, rules.strain);
  read_choice(words, "measure", io::curve_words::measure, rules.measure);
  read_choice(words, "test", io::curve_words::test, rules.test);
  if (words.contains("yield_from"))
    read_choice(words, "yield_from", io::curve_words::yield_from, rules.yield_from.emplace());
  read_choice(words, "elastic_slope", io::curve_words::slope, rules.slope);
  if (!(yield_offset > 0.0 && yield_offset < 1.0))
    throw InputError(fmt::format("yield_offset = {:g} is out of range; allowed: in (0, 1)", yield_offset));
  return io::hardening_curve({copied(strain), copied(stress)}, rules);
}

/// A number with a unit in SI, if it has the dimension of `unit`; an empty unit allows pure numbers and percent.
double quantity_like(const std::string& text, const std::string& unit)
{
  const io::Dimension wanted = io::quantity("1 " + unit).dimension;
  io::Quantity given;
  try
  {
    given = io::quantity(text);
  }
  catch (const InputError& error)
  {
    throw InputError(fmt::format("\"{}\" {}", text, error.what()));
  }
  if (given.dimension != wanted)
    throw InputError(fmt::format("\"{}\" is a {}; allowed: a {}, as \"{}\"", text, io::dimension_name(given.dimension),
                                 io::dimension_name(wanted), io::example_quantity(wanted)));
  return given.value;
}

} // namespace

void bind_curves(nb::module_& m)
{
  using io::HardeningCurve;
  nb::class_<HardeningCurve>(m, "HardeningCurve")
      .def_ro("plastic_strain", &HardeningCurve::plastic_strain)
      .def_ro("stress", &HardeningCurve::stress)
      .def_prop_ro("loading", [](const HardeningCurve& c) { return std::pair(c.loading.strain, c.loading.stress); })
      .def_ro("slope", &HardeningCurve::slope)
      .def_ro("zero", &HardeningCurve::zero)
      .def_ro("notes", &HardeningCurve::notes)
      .def_prop_ro("warnings",
                   [](const HardeningCurve& c)
                   {
                     std::vector<std::string> texts;
                     for (const io::Warning& warning : c.warnings)
                       texts.push_back(warning.text);
                     return texts;
                   });
  m.def("hardening_curve", &hardening_curve, "strain"_a, "stress"_a, "words"_a, "yield_offset"_a,
        "young_modulus"_a.none(), "monotone"_a);
  m.def("quantity_like", &quantity_like, "text"_a, "unit"_a);
  m.def(
      "read_curve",
      [](const std::filesystem::path& file, const std::string& strain_unit, const std::string& stress_unit,
         const std::string& strain_type)
      {
        io::CurveRules rules;
        read_choice({{"strain_type", strain_type}}, "strain_type", io::curve_words::strain, rules.strain);
        const io::Curve curve = io::read_curve(file, strain_unit, stress_unit, rules.strain);
        return std::pair(curve.strain, curve.stress);
      },
      "file"_a, "strain_unit"_a, "stress_unit"_a, "strain_type"_a);
}

} // namespace brinell::python
