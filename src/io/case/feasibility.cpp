// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/feasibility.hpp"
#include "brinell/device/devices.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/share.hpp"
#include "brinell/io/forecast.hpp"
#include "brinell/io/member_keys.hpp"
#include "brinell/quality/quality.hpp"
#include "brinell/simulation/forecast.hpp"
#include "io/scenarios/scenario_io.hpp"
#include "result_size.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <fstream>
#include <unistd.h>

namespace brinell::io
{

namespace
{

std::string volume_text(const VolumeGrid& grid, bool surface_only)
{
  if (surface_only)
    return fmt::format("{} x {} cells of its surface", grid.surface.nx, grid.surface.ny);
  return fmt::format("{} x {} x {} cells", grid.surface.nx, grid.surface.ny, grid.nz);
}

/// First yield of bodies with layers.
std::string coated_report(const reference::CoatedYield& yield, const simulation::PairCase& s)
{
  const constitutive::Material& material = yield.in_upper ? s.upper.material : s.lower.material;
  const std::string part =
      yield.place.layer < material.layers.size()
          ? fmt::format("layer {} of the {} body", yield.place.layer + 1, yield.in_upper ? "upper" : "lower")
          : fmt::format("the {} body{}", yield.in_upper ? "upper" : "lower",
                        material.layers.empty() ? "" : " beneath its layers");
  return fmt::format("# First yield with layers{}, in {}: approach {:.4e} m, load {:.4e} N, contact radius {:.4e} m, "
                     "pressure on the axis {:.4e} Pa;\n#   at a depth of {:.4e} m, {:.4e} m from the axis\n",
                     s.friction.coefficient > 0.0 ? " and without friction" : "", part, yield.approach, yield.load,
                     yield.contact_radius, yield.peak_pressure, yield.place.depth, yield.place.r);
}

std::string critical_report(const Case& c)
{
  std::string text = fmt::format("# Contact: E' = {:.6e} Pa", c.contact_modulus);
  if (c.equivalent_radius)
    text += fmt::format(", equivalent radius = {:.6e} m", *c.equivalent_radius);
  text += std::visit([](const auto& scenario) { return io_of(scenario).drive(scenario); }, c.scenario) + "\n";
  if (!c.first_yield)
  {
    const auto reason = std::visit(
        [](const auto& s) { return simulation::reason_against_first_yield(s.lower, s.upper, s.domain); }, c.scenario);
    return text + fmt::format("# There are no critical values: {}.\n", reason.value());
  }
  const auto& critical = c.first_yield->critical;
  constexpr std::array bodies{"the lower body yields first", "the upper body yields first", "both bodies alike"};
  text += fmt::format("# First yield{} ({}): C = {:.6f}, alpha_c = {:.6e} m, P_c = {:.6e} N, U_c = {:.6e} J,\n"
                      "#   contact {} = {:.6e} m, peak pressure = {:.6e} Pa\n",
                      c.coated_yield ? " without layers" : "", bodies[static_cast<std::size_t>(c.first_yield->body)],
                      critical.C, critical.interference, critical.load, critical.energy,
                      c.first_yield->line ? "half-width" : "radius", critical.contact_radius, critical.peak_pressure);
  if (const auto& line = c.first_yield->line)
    text += fmt::format("#   P_c and U_c of a line of {:g} m, alpha_c with grid.reference = {:.6e} m\n", line->length,
                        line->reference);
  text +=
      std::visit([&](const auto& scenario) { return io_of(scenario).drive_at_yield(scenario, critical); }, c.scenario);
  if (c.coated_yield)
    text += std::visit([&](const auto& scenario) { return coated_report(*c.coated_yield, scenario); }, c.scenario);
  return text;
}

/// How far the pressure is above that at first yield, with the friction of surfaces that slide.
template <typename ScenarioCase>
std::string yield_report(const ScenarioCase& s, const simulation::Plan& plan)
{
  if (!(plan.peak_pressure > 0.0 && plan.peak_over_yield > 0.0 && std::isfinite(plan.peak_over_yield)))
    return "";
  const double friction = s.friction.coefficient;
  const bool has_layers = !s.lower.material.layers.empty() || !s.upper.material.layers.empty();
  std::string text = fmt::format("# Elastic peak pressure: {:.6e} Pa, {:.4g} times that at first yield",
                                 plan.peak_pressure, plan.peak_over_yield);
  if (friction > 0.0)
    text += fmt::format(" of surfaces that slide with friction {:g}", friction);
  if (has_layers)
    return text + " without layers (estimate, with the most compliant of the materials of a body)\n";
  const bool is_exact = !simulation::reason_against_first_yield(s.lower, s.upper, s.domain);
  return text + (is_exact ? "\n" : " (estimate for a round contact)\n");
}

std::string grid_report(const simulation::Plan& plan)
{
  std::string text = fmt::format("# Cells: dx = {:.4e} m, dy = {:.4e} m, dz = {:.4e} m\n", plan.contact.dx,
                                 plan.contact.dy, plan.lower.dz);
  if (plan.twin == elastoplastic::Twin::mirror_image)
    text += "# Symmetry: the bodies are mirror images of each other; one of them is solved\n";
  if (plan.twin == elastoplastic::Twin::alike)
    text += "# Symmetry: both bodies have the same plastic strain; one of them is solved\n";
  if (plan.contact.is_mirrored_y)
    text += "# Symmetry: both sides of y = 0 are mirror images of each other; one of them is solved\n";
  return text + fmt::format("# Grids: contact {} x {}, lower body {}, upper body {}\n", plan.contact.nx,
                            plan.contact.ny, volume_text(plan.lower, plan.surfaces_only),
                            volume_text(plan.upper, plan.surfaces_only));
}

/// Number of cells of the bodies that are solved: of twins one is.
double solved_cells(const simulation::Plan& plan)
{
  const auto upper = static_cast<double>(plan.upper.size());
  return static_cast<double>(plan.lower.size()) + (plan.twin == elastoplastic::Twin::none ? upper : 0.0);
}

/// A sentence as a comment of the resolved case; empty without one.
std::string remark(std::string text)
{
  if (text.empty())
    return text;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return fmt::format("# {}\n", text);
}

/// Memory on the device of a case.
std::string device_report(const simulation::PairCase& c, const simulation::Plan& plan)
{
  using elastoplastic::DeviceChoice;
  const DeviceChoice choice = c.solver.device;
  if (choice == DeviceChoice::cpu)
    return "";
  const std::string head = fmt::format("# Device: {}", device::name_of(choice));
  const auto memory = simulation::memory_on_device(plan, c);
  if (!memory)
    return fmt::format("{}; {}\n", head,
                       c.lower.material.is_plastic() || c.upper.material.is_plastic()
                           ? "what a device does not compute is in this case, so the processor computes it"
                           : "neither body can yield, so that nothing is computed there");
  const std::string without = choice == DeviceChoice::automatic
                                  ? "; this program has been built without CUDA, so the processor computes it"
                                  : "; this program has been built without CUDA and cannot run the case";
  return fmt::format("{}, {} of its memory, and up to {} for transforms{}\n", head, size_text(memory->arrays),
                     size_text(memory->buffers), choice == DeviceChoice::host || device::has_cuda() ? "" : without);
}

template <typename ScenarioCase, typename ScenarioPlanOf>
std::string quality_report(const ScenarioCase& c, const ScenarioPlanOf& plan)
{
  return remark(quality::resolution_text(quality::expected(c, plan).resolution));
}

/// The plan; an error about the grid gets the key and place of the grid.
template <typename ScenarioCase>
auto planned(const ScenarioCase& scenario, const std::string& grid_source)
{
  try
  {
    return simulation::plan(scenario);
  }
  catch (const GridError& error)
  {
    throw InputError(fmt::format("{}: {}", grid_source, with_keys(error.what())));
  }
}

} // namespace

double machine_memory()
{
  double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  std::ifstream limit("/sys/fs/cgroup/memory.max"); // control groups v2; "max" if there is no limit
  if (double group = 0.0; limit >> group)
    bytes = std::min(bytes, group);
  return bytes;
}

ScenarioPlan plan_case(const Case& c, double available_memory)
{
  constexpr std::string_view advice = "allowed: larger cells, or a smaller interference, load or track";
  return std::visit(
      [&](const auto& scenario) -> ScenarioPlan
      {
        auto plan = planned(scenario, c.grid_source);
        plan.memory_bytes += simulation::memory_of_fatigue(plan, scenario.lower, scenario.upper);
        if (plan.memory_bytes > available_memory)
          throw InputError(fmt::format("{} needs {} of memory, this machine has {}; {}", c.grid_source,
                                       size_text(plan.memory_bytes), size_text(available_memory), advice));
        return plan;
      },
      c.scenario);
}

std::vector<Warning> expected_warnings(const Case& c, const ScenarioPlan& plan)
{
  std::vector<Warning> warnings = c.warnings;
  std::visit(
      [&](const auto& scenario)
      {
        using Plan = decltype(simulation::plan(scenario));
        for (Warning& warning : quality::expected(scenario, std::get<Plan>(plan)).warnings)
          warnings.push_back(std::move(warning));
      },
      c.scenario);
  for (Warning& warning : result_warnings(c, plan))
    warnings.push_back(std::move(warning));
  return warnings;
}

std::string check_report(const Case& c, const ScenarioPlan& plan)
{
  std::string head = fmt::format("# Resolved case of {}\n{}\n", c.file.string(), resolved_files(c.values).text);
  for (const std::string& note : c.notes)
    head += fmt::format("# {}\n", note);
  head += critical_report(c);
  const Forecast cost = forecast(c, plan);
  return head + std::visit(
                    [&](const auto& scenario)
                    {
                      using Plan = decltype(simulation::plan(scenario));
                      const Plan& p = std::get<Plan>(plan);
                      return yield_report(scenario, p) + io_of(scenario).motion(scenario, p) + grid_report(p) +
                             fmt::format("# Cost: {}, {:.0f} bytes per cell of the bodies that are solved\n",
                                         forecast_text(cost), cost.memory / solved_cells(p)) +
                             device_report(scenario, p) + result_report(c, plan) + remark(left_out_text(c, plan)) +
                             quality_report(scenario, p);
                    },
                    c.scenario);
}

std::string ranks_report(const Case& c, const ScenarioPlan& plan, int ranks, int machines, double available_memory)
{
  const auto& p = std::visit([](const auto& any) -> const simulation::Plan& { return any; }, plan);
  const double each =
      std::visit([&](const auto& scenario) { return simulation::memory_of_rank(p, scenario, ranks); }, c.scenario);
  const double unshared =
      std::visit([&](const auto& scenario) { return simulation::unshared_memory(p, scenario); }, c.scenario);
  const int together = (ranks + machines - 1) / machines; // ranks of a machine
  if (together * each > available_memory)
    throw InputError(
        fmt::format("{}: {} ranks on a machine need {} of memory each, {} in all, and it has {}; allowed: more "
                    "machines with fewer ranks each, larger cells, or a smaller interference, load or track",
                    c.grid_source, together, size_text(each), size_text(together * each), size_text(available_memory)));
  const int layers = std::max(p.lower.nz, p.upper.nz), own = Share(0, ranks).count(layers);
  std::string text = fmt::format(
      "# Ranks: {} with at most {} of {} layers each, {} of memory each, {} of it for contact and heat, which are "
      "not shared; {} pass from a rank to others per evaluation; "
      "not less than {} of the time of one core\n",
      ranks, own, layers, size_text(each), size_text(unshared), size_text(simulation::bytes_sent_by_rank(p, ranks)),
      fmt::format("{:.2g} %", 100.0 * own / layers));
  if (const int pairs = (layers + 1) / 2; ranks > pairs)
    text += fmt::format("# Ranks: {} of them have no layers, which are dealt out in pairs\n", ranks - pairs);
  return text;
}

} // namespace brinell::io
