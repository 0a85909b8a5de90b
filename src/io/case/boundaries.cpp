// SPDX-License-Identifier: BSD-3-Clause
#include "case_reader.hpp"
#include "io/scenarios/scenario_io.hpp"

#include <cmath>
#include <fmt/ranges.h>
#include <functional>

namespace brinell::io
{

namespace
{

/// Reads one number for each periodic axis, or a single one for all of them.
void set_axes(const CaseReader& reader, const std::string& key, std::vector<simulation::Domain::Axis*> axes,
              const std::function<void(simulation::Domain::Axis&, double)>& set)
{
  const auto& given = reader.get<std::vector<double>>(key);
  if (given.size() != axes.size() && given.size() != 1)
    return reader.add(key, "has {} elements; allowed: {}, for each axis that is periodic, or one for all of them",
                      given.size(), axes.size());
  for (std::size_t i = 0; i < axes.size(); ++i)
    set(*axes[i], given.size() == 1 ? given.front() : given[i]);
}

} // namespace

void read_domain(const CaseReader& reader, simulation::Domain& domain, bool both)
{
  using Axis = simulation::Domain::Axis;
  const auto& boundary = reader.get<std::string>("grid.boundary");
  if (boundary == "open")
    return;
  if (!both && boundary != "periodic_y")
  {
    const auto resting = scenarios_with([](const auto& io) { return !io.moves; });
    return reader.add("grid.boundary",
                      "goes with scenario = \"{}\"; allowed where the contact moves along x: \"open\" or "
                      "[\"open\", \"periodic\"]",
                      fmt::join(resting, "\" or \""));
  }
  std::vector<Axis*> axes;
  if (boundary != "periodic_y")
    axes.push_back(&domain.x);
  if (boundary != "periodic_x")
    axes.push_back(&domain.y);
  for (Axis* axis : axes)
    axis->boundary = Boundary::periodic;
  const bool has_spacing = reader.has("grid.spacing");
  for (const char* key : {"grid.cells", "grid.layer"})
    if (has_spacing && reader.has(key))
      reader.add(key, "cannot stand together with grid.spacing; keep one of them");
  if (boundary == "periodic_y" && !has_spacing)
    domain.y.cells = 1;
  if (reader.has("grid.size"))
    set_axes(reader, "grid.size", axes, [](Axis& axis, double size) { axis.size = size; });
  else if (boundary != "periodic_y")
    reader.missing("grid.size", boundary == "periodic" ? "two lengths > 0, the period along x and y"
                                                       : "a list of one length > 0, the period along x");
  if (reader.has("grid.cells"))
    set_axes(reader, "grid.cells", axes,
             [&](Axis& axis, double cells)
             {
               if (cells != std::round(cells))
                 reader.add("grid.cells", "is not a list of whole numbers");
               axis.cells = static_cast<int>(cells);
             });
  else if (!has_spacing && boundary != "periodic_y")
    reader.missing("grid.cells", "whole numbers > 0, one for each periodic axis, or grid.spacing");
}

} // namespace brinell::io
