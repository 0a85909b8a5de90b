// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "arrays.hpp"
#include "grids.hpp"
#include "python_calls.hpp"

#include "brinell/elastoplastic/increment.hpp"

#include <atomic>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

/// The coupled contact of the engine as Python holds it: with functions of Python, and for one thread at a time.
namespace brinell::python
{

using constitutive::Material;
using elastoplastic::CoupledContact;
using elastoplastic::IncrementReport;
using elastoplastic::Twin;
using elastoplastic::WearLaw;

/// A wear law, and the function of Python that it calls; nullptr: a law of the list.
struct PythonWear
{
  WearLaw law;
  std::shared_ptr<nb::object> function{};
};

/// Wear law by a function of Python. The function is called, and let go, with the interpreter's lock.
inline PythonWear user_wear(double lower, double upper, nb::callable function)
{
  const std::shared_ptr<nb::object> held(new nb::object(std::move(function)),
                                         [](nb::object* last)
                                         {
                                           const nb::gil_scoped_acquire lock;
                                           delete last;
                                         });
  const auto intensity = [held](double pressure, double shear)
  {
    const nb::gil_scoped_acquire lock;
    const nb::object answer = (*held)(pressure, shear);
    const double value = PyFloat_AsDouble(answer.ptr());
    if (PyErr_Occurred() != nullptr)
      nb::raise_python_error();
    return value;
  };
  return {{.lower = lower, .upper = upper, .kind = WearLaw::Kind::user, .function = elastoplastic::UserWear(intensity)},
          held};
}

/// The contact of two bodies, advanced by one thread at a time, and where its grid was last.
class Pair
{
public:
  Pair(const SurfaceGrid& contact, const VolumeGrid& lower, const VolumeGrid& upper, const Material& lower_material,
       const Material& upper_material, const elastoplastic::Scales& scales, const elastoplastic::Settings& settings,
       Twin twin, elastoplastic::Textures textures, double friction, const PythonWear& wear)
      : contact_(contact, lower, upper, lower_material, upper_material, scales, settings, twin, std::move(textures),
                 0.0, {.friction = {.coefficient = friction}, .effects = {.wear = wear.law}}),
        wear_function_(wear.function)
  {
  }

  /// Nothing may be read or changed while another thread advances the state.
  class Use
  {
  public:
    explicit Use(std::atomic<bool>& busy) : busy_(busy)
    {
      if (busy_.exchange(true))
        throw InputError("this contact is in use by another thread; give each thread a contact of its own");
    }
    ~Use() { busy_ = false; }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

  private:
    std::atomic<bool>& busy_;
  };

  /// @param slid  distance that the upper surface slides along x [m]; its sign is the direction
  IncrementReport advance(const Input& distance, const contact::Drive& drive, const elastoplastic::Placement& placement,
                          elastoplastic::Strategy strategy, double slid)
  {
    const Use use(busy_);
    const auto d = values(distance, shape(contact_.grid()), "distance");
    PythonCalls python;
    strategy.wants_stop = [&] { return python.wants_stop(); };
    const elastoplastic::Motion motion{
        .along = {{contact::TangentialDrive::Kind::shift, slid}, {}}, .slides = slid != 0.0, .slid = std::abs(slid)};
    IncrementReport report;
    try
    {
      report = without_lock([&] { return contact_.advance(d, drive, placement, strategy, motion); });
    }
    catch (const Interrupted&) // by what Python raised
    {
    }
    python.rethrow();
    if (report.converged)
      placement_ = placement;
    return report;
  }

  void set_softening(const std::optional<Input>& lower, const std::optional<Input>& upper)
  {
    const Use use(busy_);
    const auto factors = [](const std::optional<Input>& given, const VolumeGrid& grid, const char* name)
    { return given ? values(*given, shape(grid), name) : std::span<const double>(); };
    contact_.set_softening(factors(lower, contact_.lower().grid(), "lower"),
                           factors(upper, contact_.upper().grid(), "upper"));
  }

  /// A function of the contact as it is now.
  template <typename Function>
  auto read(const Function& function)
  {
    const Use use(busy_);
    return function(static_cast<const CoupledContact&>(contact_));
  }

  /// A function of one of its bodies as it is now.
  template <typename Function>
  auto read(bool upper, const Function& function)
  {
    return read([&](const CoupledContact& c) { return function(upper ? c.upper() : c.lower()); });
  }

  /// @throws InputError for a rigid body
  Output stress(bool upper)
  {
    const Use use(busy_);
    return array(without_lock(
                     [&]
                     {
                       const CoupledContact::Stress s =
                           contact_.stress(upper ? 1 : 0, upper ? placement_.upper : placement_.lower);
                       return six_fields(s.deviator, s.trace);
                     }),
                 tensor_shape((upper ? contact_.upper() : contact_.lower()).grid()));
  }

  /// The function of a wear law, for the collector of garbage, because the function may hold this contact; nullptr: none.
  [[nodiscard]] PyObject* wear_function() const { return wear_function_ ? wear_function_->ptr() : nullptr; }
  void forget_wear_function() { wear_function_->reset(); }

private:
  CoupledContact contact_;
  std::shared_ptr<nb::object> wear_function_;
  elastoplastic::Placement placement_;
  std::atomic<bool> busy_ = false;
};

} // namespace brinell::python
