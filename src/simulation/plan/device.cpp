// SPDX-License-Identifier: BSD-3-Clause
#include "device.hpp"

#include "brinell/device/devices.hpp"
#include "brinell/simulation/forecast.hpp"
#include "brinell/simulation/plan_error.hpp"
#include "device/memory.hpp"
#include "heat.hpp"
#include "memory.hpp"

#include <fmt/format.h>
#include <utility>

namespace brinell::simulation
{

using elastoplastic::DeviceChoice;

std::string reason_against_device(const constitutive::Material& lower, const constitutive::Material& upper,
                                  bool have_inclusions)
{
  if (have_inclusions)
    return "a body with inclusions is not computed on a device";
  for (const auto& [name, material] : {std::pair{"lower", &lower}, {"upper", &upper}})
    if (const std::string reason = elastoplastic::reason_against_device(*material); !reason.empty())
      return fmt::format("the {} body: {}", name, reason);
  return {};
}

void check_device(const PairCase& c)
{
  const DeviceChoice choice = c.solver.device;
  if (choice == DeviceChoice::cpu || choice == DeviceChoice::automatic)
    return;
  const bool have_inclusions = !c.lower.inclusions.empty() || !c.upper.inclusions.empty();
  if (const std::string reason = reason_against_device(c.lower.material, c.upper.material, have_inclusions);
      !reason.empty())
    throw PlanError("`Settings::device` = {}, and {}; allowed: cpu or auto", device::name_of(choice), reason);
}

std::shared_ptr<const elastoplastic::Device> device_of(DeviceChoice choice, const constitutive::Material& lower,
                                                       const constitutive::Material& upper, bool have_inclusions,
                                                       bool is_shared)
{
  const bool can_yield = lower.is_plastic() || upper.is_plastic();
  const bool is_suited = !is_shared && reason_against_device(lower, upper, have_inclusions).empty();
  if (!can_yield || (choice == DeviceChoice::automatic && !is_suited))
    return nullptr;
  return device::opened(choice);
}

bool has_device_room(const Plan& plan, const PairCase& c, bool is_shared)
{
  const auto device = device_of(c.solver.device, c.lower.material, c.upper.material,
                                !c.lower.inclusions.empty() || !c.upper.inclusions.empty(), is_shared);
  const auto needed = device ? memory_on_device(plan, c) : std::nullopt;
  if (!needed || needed->arrays + needed->buffers <= device->free_memory())
    return true;
  if (c.solver.device == DeviceChoice::automatic)
    return false;
  throw DeviceError(
      fmt::format("the case needs {:.3g} GB of its memory, and {} has {:.3g} GB left; allowed: larger cells, "
                  "or a smaller interference, load or track",
                  1e-9 * (needed->arrays + needed->buffers), device->name(), 1e-9 * device->free_memory()));
}

std::optional<DeviceMemory> memory_on_device(const Plan& plan, const PairCase& c)
{
  const bool have_inclusions = !c.lower.inclusions.empty() || !c.upper.inclusions.empty();
  if (c.solver.device == DeviceChoice::cpu ||
      !reason_against_device(c.lower.material, c.upper.material, have_inclusions).empty())
    return std::nullopt;
  if (!c.lower.material.is_plastic() && !c.upper.material.is_plastic())
    return std::nullopt;
  const device::MemoryOfBody of_contact = device::memory_of_contact(plan.contact);
  DeviceMemory memory{of_contact.arrays, of_contact.buffers};
  for (const auto& [grid, material] : {std::pair{&plan.lower, &c.lower.material}, {&plan.upper, &c.upper.material}})
  {
    if (!material->is_plastic() || (grid == &plan.upper && plan.twin != elastoplastic::Twin::none))
      continue;
    const bool is_hot = is_heated(c) && material->thermal;
    const device::MemoryOfBody of_body =
        device::memory_of_body(*grid, {.backstresses = static_cast<int>(material->kinematic.size()),
                                       .with_shears = plan.shears > 0,
                                       .has_initial_stress = !material->initial_stress.empty(),
                                       .is_heated = is_hot,
                                       .is_softened = is_hot && material->softening.has_value(),
                                       .active_cells = active_cells(*grid, c.solver, plan),
                                       .history = c.solver.anderson_depth * (has_deep_indents(plan) ? 4 : 1)});
    memory.arrays += of_body.arrays;
    memory.buffers += of_body.buffers;
  }
  return memory;
}

} // namespace brinell::simulation
