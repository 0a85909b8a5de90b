// SPDX-License-Identifier: BSD-3-Clause
#include "body_parts.hpp"
#include "brinell/elastoplastic/device.hpp"
#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>
#include <variant>

/// A body whose increments are evaluated on a device. The processor has its state, too: output, energies and checkpoints are those of any
/// body.
namespace brinell::elastoplastic
{

namespace
{

/// Brings the device to the state before an increment.
void update_state_on(BodyParts& b)
{
  DevicePart& device = b.device;
  if (std::exchange(device.must_commit, false) && device.knows_state)
  {
    device.knows_state = false; // if this fails
    device.body->commit();
    device.knows_state = true;
  }
  if (device.knows_state)
    return;
  device.body->write({b.state.plastic_strain, b.state.equivalent, b.state.backstress, b.state.stress, b.trial.stress});
  device.knows_state = true;
}

void update_softening_on(BodyParts& b)
{
  if (!std::exchange(b.device.is_softening_known, true))
    b.device.body->set_softening(b.yield.softening);
}

} // namespace

std::string reason_against_device(const constitutive::Material& material)
{
  constexpr std::size_t most_terms = 4; // device::KinematicTerms
  if (!material.is_plastic())
    return {};
  if (!material.layers.empty())
    return "a body with layers is not computed on a device";
  if (std::holds_alternative<constitutive::UserHardening>(*material.hardening))
    return "a hardening law of your own is a program of the processor; a device computes with those of brinell, of "
           "which a tabulated "
           "one has any shape";
  if (material.kinematic.size() > most_terms)
    return fmt::format("kinematic hardening of {} terms; allowed on a device: at most {}", material.kinematic.size(),
                       most_terms);
  return {};
}

void put_on_device(BodyParts& b)
{
  if (const std::string reason = reason_against_device(b.yield.material); !reason.empty())
    throw InputError(reason);
  if (!b.settings.inclusions.empty())
    throw InputError("a body with inclusions is on a device; allowed: on the processor");
  if (!b.share.is_all())
    throw InputError("a body on a device is shared by ranks; allowed: one process");
  b.device.body = b.settings.device->make_body(b.whole, b.yield.material,
                                               b.settings.displacements != halfspace::Displacements::normal);
  b.device.is_softening_known = b.yield.softening.empty();
}

void begin_on_device(BodyParts& b, int shift, double fraction, bool from_stress)
{
  update_state_on(b);
  update_softening_on(b);
  b.device.is_read = b.device.is_stress_read = false;
  const BodyOnDevice::Found found = b.device.body->begin(
      {.shift = shift, .stiffness = b.trial.stiffness.front(), .fraction = fraction, .from_stress = from_stress});
  b.trial.count_of_all = found.cells;
  b.device.deepest = found.deepest;
  b.evaluation->follow(found.deepest);
}

double integrate_on_device(BodyParts& b, Integration integration)
{
  update_softening_on(b);
  b.device.is_read = b.device.is_stress_read = false;
  const double change = b.evaluation->load_on(*b.device.body, integration);
  if (b.settings.displacements !=
      halfspace::Displacements::normal) // the shear that the surface bears depends on its hardening
    read_active(b);
  return change;
}

bool update_on_device(BodyParts& b, const halfspace::SurfaceLoad& load)
{
  if (!std::exchange(b.device.is_thermal_stress_known, true))
    b.device.body->set_thermal_stress(b.thermal_stress());
  b.device.is_read = b.device.is_stress_read = false;
  const BodyOnDevice::Found found = b.device.body->update(load, b.evaluation->layers());
  b.trial.yield_error = found.yield_error;
  if (found.cells == 0)
    return false;
  b.trial.count_of_all += found.cells;
  b.device.deepest = std::max(b.device.deepest, found.deepest);
  b.evaluation->follow(b.device.deepest);
  return true;
}

void read_active(BodyParts& b)
{
  if (!std::exchange(b.device.is_read, true))
    b.device.body->read_active(b.trial.active, b.state.plastic_strain);
}

void Body::fetch()
{
  BodyParts& b = parts_;
  if (!is_on_device() || !b.trial.is_open)
    return;
  read_active(b);
  if (!std::exchange(b.device.is_stress_read, true))
    b.device.body->read_stress(b.trial.stress);
}

void Body::combine(std::span<const double> weights, bool goes_further)
{
  BodyParts& b = parts_;
  b.device.body->combine(weights);
  b.device.is_read = false;
  if (!goes_further || !b.trial.bears_shear)
    return;
  read_active(b);
  go_further(b.device.body->residual(weights));
  b.device.body->write_trials(b.trial.active.trials());
}

} // namespace brinell::elastoplastic
