// SPDX-License-Identifier: BSD-3-Clause
#include "arrays.hpp"
#include "module.hpp"

#include "brinell/constitutive/flow.hpp"
#include "brinell/constitutive/material.hpp"
#include "brinell/io/case_file.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <limits>
#include <tuple>

using namespace nanobind::literals;

namespace brinell::python
{

namespace
{

using constitutive::Material;

const constitutive::HardeningLaw& law_of(const Material& material)
{
  if (!material.is_plastic())
    throw InputError("the material has no hardening law: it does not yield");
  return material.law();
}

std::span<const double> strains(const Input& array, std::size_t n)
{
  const auto e = values(array, {n}, "equivalent_plastic_strain");
  for (const double value : e)
    if (!(value >= 0.0))
      throw InputError(fmt::format("equivalent_plastic_strain has the value {:g}; allowed: not below 0", value));
  return e;
}

std::span<const double> factors(const Input& array, std::size_t n)
{
  const auto f = values(array, {n}, "yield_factor");
  for (const double value : f)
    if (!(value > 0.0))
      throw InputError(fmt::format("yield_factor has the value {:g}; allowed: above 0", value));
  return f;
}

Output softening_factor(const Material& material, const Input& temperature)
{
  if (!material.softening)
    throw InputError("the material has no softening law");
  const auto t = values(temperature, {temperature.size()}, "temperature");
  std::vector<double> result(t.size());
  std::transform(t.begin(), t.end(), result.begin(),
                 [&](double at) { return constitutive::softening_factor(*material.softening, at); });
  return array(std::move(result), {t.size()});
}

/// A member function of the law at each strain.
template <typename Member>
Output law_values(const Material& material, const Input& equivalent_plastic_strain, const Member& member)
{
  const auto e = strains(equivalent_plastic_strain, equivalent_plastic_strain.size());
  std::vector<double> result(e.size());
  std::visit([&](const auto& law)
             { std::transform(e.begin(), e.end(), result.begin(), [&](double at) { return member(law, at); }); },
             law_of(material));
  return array(std::move(result), {e.size()});
}

/// n points before and after an increment.
struct Points
{
  std::span<const double> stress, trial, equivalent, backstress, yield_factor;
  std::size_t n = 0;

  [[nodiscard]] Deviator back(std::size_t term, std::size_t i) const
  {
    return to_deviator(tensor_at(backstress.subspan(6 * n * term, 6 * n), n, i));
  }
};

struct Increments
{
  std::vector<double> strain, equivalent, dissipation, stress, backstress;

  Increments(std::size_t n, std::size_t terms)
      : strain(6 * n), equivalent(n), dissipation(n), stress(6 * n), backstress(6 * n * terms)
  {
  }
};

/// The return mapping that the engine uses for this material.
template <typename Law>
Increments increments(const Material& material, const Law& law, const Points& points, bool path)
{
  const double mu = material.elastic.shear_modulus();
  const std::size_t n = points.n;
  const std::size_t terms = material.kinematic.size();
  Increments result(n, terms);
  std::vector<Deviator> back(terms);
  for (std::size_t i = 0; i < n; ++i)
  {
    const SymTensor trial = tensor_at(points.trial, n, i);
    const Deviator q = to_deviator(trial);
    const Deviator s0 = to_deviator(tensor_at(points.stress, n, i));
    const double e = points.equivalent[i];
    for (std::size_t term = 0; term < terms; ++term)
      back[term] = points.back(term, i);
    const constitutive::PlasticIncrement increment = constitutive::flow(
        constitutive::ScaledLaw<Law>{law, points.yield_factor[i]}, material.kinematic,
        path ? constitutive::Integration::path : constitutive::Integration::backward_euler, s0, q, e, 2.0 * mu, back);
    store(to_tensor(increment.strain), result.strain, n, i);
    result.equivalent[i] = increment.equivalent;
    result.dissipation[i] = increment.dissipation;
    store(to_tensor(q - (2.0 * mu) * increment.strain, trace(trial)), result.stress, n, i);
    for (std::size_t term = 0; term < terms; ++term)
      for (std::size_t c = 0; c < 6; ++c)
        result.backstress[(6 * term + c) * n + i] = to_tensor(back[term])[c];
  }
  return result;
}

auto return_mapping(const Material& material, const Input& stress, const Input& trial,
                    const Input& equivalent_plastic_strain, const Input& backstress, const Input& yield_factor,
                    bool path)
{
  const std::size_t n = equivalent_plastic_strain.size();
  const std::size_t terms = material.kinematic.size();
  const Points points{values(stress, {6, n}, "stress"),
                      values(trial, {6, n}, "trial"),
                      strains(equivalent_plastic_strain, n),
                      values(backstress, {terms, 6, n}, "backstress"),
                      factors(yield_factor, n),
                      n};
  const constitutive::HardeningLaw& law = law_of(material);
  Increments result = without_lock(
      [&] { return std::visit([&](const auto& l) { return increments(material, l, points, path); }, law); });
  return std::tuple{array(std::move(result.strain), {6, n}), array(std::move(result.equivalent), {n}),
                    array(std::move(result.dissipation), {n}), array(std::move(result.stress), {6, n}),
                    array(std::move(result.backstress), {terms, 6, n})};
}

/// A case is the only place where a material is read: units, ranges and messages are there.
Material lower_material(const io::Case& c)
{
  return std::visit([](const auto& scenario) { return scenario.lower.material; }, c.scenario);
}

} // namespace

void bind_constitutive(nb::module_& m)
{
  nb::class_<Material>(m, "Material")
      .def_prop_ro("young_modulus", [](const Material& material) { return material.elastic.young_modulus; })
      .def_prop_ro("poisson_ratio", [](const Material& material) { return material.elastic.poisson_ratio; })
      .def_prop_ro("shear_modulus", [](const Material& material) { return material.elastic.shear_modulus(); })
      .def_prop_ro("is_plastic", &Material::is_plastic)
      .def_prop_ro("thermal", [](const Material& material) { return material.thermal; })
      .def_prop_ro("back_stresses", [](const Material& material) { return material.kinematic.size(); });
  m.def("lower_material", &lower_material, "case"_a);
  m.def("rigid_material", [] { return Material{{std::numeric_limits<double>::infinity(), 0.0}, {}}; });
  m.def(
      "contact_modulus",
      [](const Material& lower, const Material& upper)
      {
        if (lower.elastic.is_rigid() && upper.elastic.is_rigid())
          throw InputError("both bodies are rigid; at least one must deform");
        return contact_modulus(lower.elastic, upper.elastic);
      },
      "lower"_a, "upper"_a);
  m.def(
      "yield_stress",
      [](const Material& material, const Input& equivalent_plastic_strain)
      {
        return law_values(material, equivalent_plastic_strain,
                          [](const auto& l, double e) { return l.yield_stress_at(e); });
      },
      "material"_a, "equivalent_plastic_strain"_a);
  m.def(
      "hardening_modulus",
      [](const Material& material, const Input& equivalent_plastic_strain) {
        return law_values(material, equivalent_plastic_strain, [](const auto& l, double e) { return l.modulus_at(e); });
      },
      "material"_a, "equivalent_plastic_strain"_a);
  m.def(
      "plastic_work",
      [](const Material& material, const Input& equivalent_plastic_strain)
      { return law_values(material, equivalent_plastic_strain, [](const auto& l, double e) { return l.work(e); }); },
      "material"_a, "equivalent_plastic_strain"_a);
  m.def("return_mapping", &return_mapping, "material"_a, "stress"_a, "trial"_a, "equivalent_plastic_strain"_a,
        "backstress"_a, "yield_factor"_a, "path"_a);
  m.def("softening_factor", &softening_factor, "material"_a, "temperature"_a);
}

} // namespace brinell::python
