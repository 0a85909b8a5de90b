// SPDX-License-Identifier: BSD-3-Clause
#include "arrays.hpp"
#include "coupled_pair.hpp"
#include "grids.hpp"
#include "module.hpp"

#include "brinell/elastoplastic/increment.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>

using namespace nanobind::literals;

namespace brinell::python
{

namespace
{

using elastoplastic::BodyState;
using elastoplastic::BodyView;
using elastoplastic::Place;

constexpr const elastoplastic::EffectField& worn_depth =
    elastoplastic::effect_fields[elastoplastic::EffectFieldIndex("worn_depth").value];

std::vector<double> texture(const std::optional<Input>& given, const VolumeGrid& grid, const char* name)
{
  if (!given)
    return {};
  const auto heights = values(*given, shape(grid.surface), name);
  return {heights.begin(), heights.end()};
}

void require_same_cells(const SurfaceGrid& contact, const SurfaceGrid& body, const char* name)
{
  if (body.ny != contact.ny || body.dx != contact.dx || body.dy != contact.dy)
    throw InputError(
        fmt::format("{} has {} rows of cells of {:g} x {:g} m; it must have those of the contact grid, {} rows "
                    "of {:g} x {:g} m",
                    name, body.ny, body.dx, body.dy, contact.ny, contact.dx, contact.dy));
}

Output copy_of(std::span<const double> field, const Shape& shape)
{
  return array({field.begin(), field.end()}, shape);
}

/// A field of a body; zeros for a rigid one, which stores none.
/// @param values  per cell
std::vector<double> or_zeros(std::vector<double> field, const BodyView& body, std::size_t values)
{
  field.resize(values * body.grid().size(), 0.0);
  return field;
}

/// Back stresses, [term, component, z, y, x].
Output backstress(const BodyView& body)
{
  const std::size_t terms = body.material().kinematic.size();
  const std::size_t n = body.grid().size();
  const elastoplastic::BodyState state = body.state();
  std::vector<double> fields;
  for (std::size_t term = 0; term < terms; ++term)
  {
    const auto field = std::span(state.backstress).subspan(term * Deviator::size * n, Deviator::size * n);
    const std::vector<double> of_term = six_fields(field);
    fields.insert(fields.end(), of_term.begin(), of_term.end());
  }
  Shape s = tensor_shape(body.grid());
  s.insert(s.begin(), terms);
  return array(std::move(fields), s);
}

void construct(Pair* self, const SurfaceGrid& contact, const VolumeGrid& lower, const VolumeGrid& upper,
               const Material& lower_material, const Material& upper_material, const elastoplastic::Scales& scales,
               const elastoplastic::Settings& settings, Twin twin, const std::optional<Input>& lower_texture,
               const std::optional<Input>& upper_texture, double friction, const PythonWear& wear)
{
  require_same_cells(contact, lower.surface, "lower");
  require_same_cells(contact, upper.surface, "upper");
  if (lower_material.elastic.is_rigid() && upper_material.elastic.is_rigid())
    throw InputError("both bodies are rigid; at least one must deform");
  if (twin != Twin::none && !(lower == upper && lower_material == upper_material))
    throw InputError("twin: the bodies differ in grid or material; only bodies that are alike can be twins");
  if (twin == Twin::alike && friction > 0.0)
    throw InputError(
        "friction: the shear acts on the bodies in opposite directions, so they are not alike; allowed: 0, or "
        "another twin");
  if (twin != Twin::none && !wear.law.is_alike())
    throw InputError("wear: twins wear alike; allowed: equal coefficients");
  elastoplastic::Textures textures{texture(lower_texture, lower, "lower_texture"),
                                   texture(upper_texture, upper, "upper_texture")};
  without_lock(
      [&]
      {
        return new (self) Pair(contact, lower, upper, lower_material, upper_material, scales, settings, twin,
                               std::move(textures), friction, wear);
      });
}

void bind_values(nb::module_& m)
{
  nb::class_<Place>(m, "Place")
      .def(
          "__init__",
          [](Place* self, int column, double fraction) {
            new (self) Place{column, fraction};
          },
          "column"_a, "fraction"_a);
  nb::enum_<elastoplastic::Integration>(m, "Integration")
      .value("path", elastoplastic::Integration::path)
      .value("backward_euler", elastoplastic::Integration::backward_euler);
  nb::enum_<Twin>(m, "Twin")
      .value("none", Twin::none)
      .value("mirror_image", Twin::mirror_image)
      .value("alike", Twin::alike);
  nb::class_<elastoplastic::Scales>(m, "Scales")
      .def(
          "__init__",
          [](elastoplastic::Scales* self, double displacement, double gap) {
            new (self) elastoplastic::Scales{displacement, gap};
          },
          "displacement"_a, "gap"_a);
  nb::class_<elastoplastic::Settings>(m, "Settings")
      .def(
          "__init__",
          [](elastoplastic::Settings* self, double yield_tolerance, double displacement_tolerance,
             double contact_tolerance)
          {
            new (self) elastoplastic::Settings{.yield_tolerance = yield_tolerance,
                                               .displacement_tolerance = displacement_tolerance,
                                               .contact_tolerance = contact_tolerance};
          },
          "yield_tolerance"_a, "displacement_tolerance"_a, "contact_tolerance"_a);
  nb::class_<PythonWear>(m, "WearLaw")
      .def(
          "__init__",
          [](PythonWear* self, double lower, double upper, const std::string& law)
          {
            new (self) PythonWear{{.lower = lower,
                                   .upper = upper,
                                   .kind = law == "energy" ? WearLaw::Kind::energy : WearLaw::Kind::archard}};
          },
          "lower"_a, "upper"_a, "law"_a)
      .def(
          "__init__",
          [](PythonWear* self, double lower, double upper, nb::callable law)
          { new (self) PythonWear(user_wear(lower, upper, std::move(law))); },
          "lower"_a, "upper"_a, "law"_a);
  nb::class_<IncrementReport>(m, "IncrementReport")
      .def_ro("converged", &IncrementReport::converged)
      .def_ro("contact_converged", &IncrementReport::contact_converged)
      .def_ro("approach", &IncrementReport::approach)
      .def_ro("evaluations", &IncrementReport::evaluations)
      .def_ro("contact_iterations", &IncrementReport::contact_iterations)
      .def_ro("yield_error", &IncrementReport::yield_error)
      .def_ro("displacement_error", &IncrementReport::displacement_error)
      .def_ro("gap_error", &IncrementReport::gap_error)
      .def_ro("energy", &IncrementReport::energy);
}

void bind_contact_state(nb::class_<Pair>& pair)
{
  constexpr auto owned = nb::rv_policy::automatic; // the array owns its values
  pair.def_prop_ro(
          "pressure",
          [](Pair& p) { return p.read([](const auto& c) { return copy_of(c.pressure(), shape(c.grid())); }); }, owned)
      .def_prop_ro(
          "gap", [](Pair& p) { return p.read([](const auto& c) { return copy_of(c.gap(), shape(c.grid())); }); }, owned)
      .def_prop_ro(
          "shear",
          [](Pair& p)
          {
            return p.read(
                [](const auto& c)
                {
                  const auto* sliding = c.sliding();
                  return sliding != nullptr ? copy_of(sliding->shears()[0], shape(c.grid()))
                                            : array(std::vector<double>(c.grid().size()), shape(c.grid()));
                });
          },
          owned)
      .def_prop_ro("approach", [](Pair& p) { return p.read([](const auto& c) { return c.approach(); }); })
      .def_prop_ro("load", [](Pair& p) { return p.read([](const auto& c) { return c.load(); }); })
      .def_prop_ro("elastic_energy", [](Pair& p) { return p.read([](const auto& c) { return c.elastic_energy(); }); })
      .def_prop_ro("reaches_edge", [](Pair& p) { return p.read([](const auto& c) { return c.reaches_edge(); }); });
}

void bind_body_state(nb::class_<Pair>& pair)
{
  pair.def(
          "plastic_strain",
          [](Pair& p, bool upper)
          {
            return p.read(upper,
                          [](const BodyView& b)
                          {
                            const std::vector<double> strain =
                                or_zeros(b.field(&BodyState::plastic_strain), b, Deviator::size);
                            return array(six_fields(strain), tensor_shape(b.grid()));
                          });
          },
          "upper"_a)
      .def(
          "equivalent_plastic_strain",
          [](Pair& p, bool upper)
          {
            return p.read(upper, [](const BodyView& b)
                          { return array(or_zeros(b.field(&BodyState::equivalent), b, 1), shape(b.grid())); });
          },
          "upper"_a)
      .def(
          "residual_displacement",
          [](Pair& p, bool upper)
          {
            return p.read(upper, [](const BodyView& b)
                          { return copy_of(b.state().residual_displacement, shape(b.grid().surface)); });
          },
          "upper"_a)
      .def(
          "worn_depth",
          [](Pair& p, bool upper)
          {
            return p.read(
                [upper](const CoupledContact& c)
                {
                  const SurfaceGrid& surface = (upper ? c.upper() : c.lower()).grid().surface;
                  const auto depth = elastoplastic::values_of(worn_depth, c.effects(), upper ? 1 : 0);
                  return depth.empty() ? array(std::vector<double>(surface.size()), shape(surface))
                                       : copy_of(depth, shape(surface));
                });
          },
          "upper"_a)
      .def(
          "worn_volume",
          [](Pair& p, bool upper)
          {
            return p.read(
                [upper](const CoupledContact& c)
                {
                  elastoplastic::EffectTotals totals;
                  for (const std::unique_ptr<elastoplastic::Effect>& effect : c.effects())
                    effect->report(totals);
                  return upper ? totals.worn_volume_upper : totals.worn_volume_lower;
                });
          },
          "upper"_a)
      .def(
          "backstress", [](Pair& p, bool upper) { return p.read(upper, backstress); }, "upper"_a)
      .def("stress", &Pair::stress, "upper"_a)
      .def(
          "dissipation",
          [](Pair& p, bool upper)
          { return p.read(upper, [](const BodyView& b) { return b.solved().state().dissipation; }); },
          "upper"_a)
      .def(
          "locked_in_energy",
          [](Pair& p, bool upper)
          { return p.read(upper, [](const BodyView& b) { return b.solved().state().locked_in_energy; }); },
          "upper"_a);
}

int traverse(PyObject* self, visitproc visit, void* arg)
{
  Py_VISIT(Py_TYPE(self));
  if (nb::inst_ready(self))
    Py_VISIT(nb::inst_ptr<Pair>(self)->wear_function());
  return 0;
}

int clear(PyObject* self)
{
  if (nb::inst_ptr<Pair>(self)->wear_function() != nullptr)
    nb::inst_ptr<Pair>(self)->forget_wear_function();
  return 0;
}

} // namespace

void bind_elastoplastic(nb::module_& m)
{
  bind_values(m);
  PyType_Slot collected[] = {
      {Py_tp_traverse, reinterpret_cast<void*>(traverse)}, {Py_tp_clear, reinterpret_cast<void*>(clear)}, {0, nullptr}};
  nb::class_<Pair> pair(m, "CoupledContact", nb::type_slots(collected));
  pair.def("__init__", &construct, "contact"_a, "lower"_a, "upper"_a, "lower_material"_a, "upper_material"_a,
           "scales"_a, "settings"_a, "twin"_a, "lower_texture"_a.none(), "upper_texture"_a.none(), "friction"_a,
           "wear"_a)
      .def(
          "advance",
          [](Pair& p, const Input& distance, const contact::Drive& drive, const Place& lower, const Place& upper,
             elastoplastic::Integration integration, int max_evaluations, int anderson_depth, double stiffness_share,
             double slid)
          {
            return p.advance(distance, drive, {lower, upper},
                             {.integration = integration,
                              .max_evaluations = max_evaluations,
                              .anderson_depth = anderson_depth,
                              .stiffness_share = stiffness_share},
                             slid);
          },
          "distance"_a, "drive"_a, "lower"_a, "upper"_a, "integration"_a, "max_evaluations"_a, "anderson_depth"_a,
          "stiffness_share"_a, "slid"_a);
  pair.def("set_softening", &Pair::set_softening, "lower"_a.none(), "upper"_a.none());
  bind_contact_state(pair);
  bind_body_state(pair);
}

} // namespace brinell::python
