// SPDX-License-Identifier: BSD-3-Clause
#include "plan_end.hpp"

#include "device.hpp"
#include "domain.hpp"
#include "embedding.hpp"
#include "footprint.hpp"
#include "grid_layout.hpp"
#include "heat.hpp"
#include "memory.hpp"

#include "brinell/halfspace/half_space.hpp"
#include "brinell/halfspace/heat_response.hpp"
#include "brinell/halfspace/surface_compliance.hpp"

#include <tuple>

namespace brinell::simulation
{

namespace
{

/// Checks that all layers of a body have thermal constants, or neither they nor the body.
void require_thermal_layers(const constitutive::Material& material, const char* name)
{
  for (std::size_t n = 0; n < material.layers.size(); ++n)
  {
    const std::string table = fmt::format("material.layers[{}].thermal", n);
    const bool has = material.layers[n].thermal.has_value();
    if (has && !material.thermal)
      throw PlanError("{}, but {} is missing; allowed: thermal constants of all layers and of the material beneath, or "
                      "of none",
                      member_of(name, table), member_of(name, "material.thermal"));
    if (!has && material.thermal)
      throw PlanError("{} is missing: the {} body has thermal constants; allowed: those of each of its layers",
                      member_of(name, table), name);
  }
}

/// Layers need cells that end at the interfaces where plastic strain may be, and are not computed with everything.
void check_layers(const PairCase& c, const Plan& plan)
{
  for (const auto& [name, body, grid] :
       {std::tuple{"lower", &c.lower, &plan.lower}, std::tuple{"upper", &c.upper, &plan.upper}})
  {
    if (body->material.layers.empty())
      continue;
    const std::string layers = member_of(name, "material.layers");
    require_thermal_layers(body->material, name);
    try
    {
      halfspace::require_resolved(plan.contact, body->material.stack());
      if (body->material.electrical)
        halfspace::require_resolved(plan.contact, in_shear(body->material.conductors()));
      if (body->material.thermal)
      {
        halfspace::require_resolved(plan.contact, body->material.thermal_stack());
        halfspace::require_resolved(plan.contact, in_shear(resisting_heat(body->material.thermal_stack())));
      }
      if (needs_aligned_cells(*body))
        halfspace::require_aligned(*grid, body->material.stack());
    }
    catch (const InputError& error)
    {
      throw PlanError("{}: {}", layers, error.what());
    }
    const double bottom = body->material.stack().thickness();
    if (body->fatigue && grid->nz * grid->dz < bottom + 0.5 * grid->dz)
      throw PlanError("{} with cells down to {:g} m only and {} of {:g} m: that of the body beneath its layers is "
                      "computed; allowed: a larger `Numerics::extent`",
                      member_of(name, "fatigue"), grid->nz * grid->dz, layers, bottom);
  }
}

} // namespace

void check_grids(const PairCase& c, Plan& plan)
{
  require_cells_in_periods(c, plan.contact);
  require_source_fits(c, plan.contact);
  plan.reference = reference_distance(c.lower.shape, c.upper.shape, c.domain);
}

void end_plan(const PairCase& c, bool sticks, Plan& plan, const std::function<halfspace::HeatTimes()>& heat_times,
              const std::array<double, 2>& beside)
{
  check_layers(c, plan);
  check_device(c);
  plan.inclusions = embedded_cells(c, plan, beside);
  const bool heats = is_heated(c);
  if (heats)
    plan.heat_times = heat_times();
  plan.is_textured = !are_smooth(c.lower, c.upper);
  plan.shears = c.friction.coefficient > 0.0 ? (sticks ? 2 : 1) : (heats ? 1 : 0);
  plan.memory_bytes =
      memory_bytes(plan, c.lower.material, c.upper.material, c.solver, plan.shears, heats ? &c.heat : nullptr);
}

void require_interfaces_at_cells(const Plan& larger, const constitutive::Material& lower,
                                 const constitutive::Material& upper, const std::string& where)
{
  for (const auto& [name, grid, material] :
       {std::tuple{"lower", &larger.lower, &lower}, {"upper", &larger.upper, &upper}})
    if (material->is_plastic() && !material->layers.empty())
      try
      {
        halfspace::require_aligned(*grid, material->stack());
      }
      catch (const InputError& error)
      {
        throw GridError(fmt::format("{}: the plastic zone has reached the bottom of its grid, and a deeper one would "
                                    "contain another interface. All steps so far are kept. {}: {}",
                                    where, member_of(name, "material.layers"), error.what()));
      }
}

} // namespace brinell::simulation
