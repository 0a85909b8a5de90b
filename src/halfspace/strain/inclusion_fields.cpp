// SPDX-License-Identifier: BSD-3-Clause
#include "inclusion_fields.hpp"

#include "brinell/foundation/symmetry.hpp"

namespace brinell::halfspace
{

namespace
{

double parity_of(int component)
{
  return is_odd_in_y(component) ? -1.0 : 1.0;
}

void add_to(const std::vector<double>& values, std::vector<double>& sum)
{
  for (std::size_t i = 0; i < values.size(); ++i)
    sum[i] += values[i];
}

} // namespace

InclusionFields::InclusionFields(const HalfSpace& body)
    : body_(body), work_(body.make_work()), dilatation_work_(body.make_dilatation_work()),
      strain_(Deviator::size * body.grid().size()), dilatation_(body.grid().size()), deviator_(strain_.size()),
      trace_(dilatation_.size())
{
}

/// The strain in each cell as a field of the body, of which means over cells are taken.
void InclusionFields::spread(const InclusionCells& cells, const InclusionField& equivalent)
{
  const std::size_t all = body_.grid().size(), n = cells.size();
  for (int c = 0; c < Deviator::size; ++c)
    for (std::size_t i = 0; i < n; ++i)
      cells.means.spread(equivalent.deviator[static_cast<std::size_t>(c) * n + i], parity_of(c), i,
                         strain_.data() + static_cast<std::size_t>(c) * all);
  for (std::size_t i = 0; i < n; ++i)
    cells.means.spread(equivalent.volumetric[i], 1.0, i, dilatation_.data());
}

/// Makes the strain zero again.
void InclusionFields::clear(const InclusionCells& cells)
{
  const std::size_t all = body_.grid().size();
  for (std::size_t c = 0; c < Deviator::size; ++c)
    cells.means.clear(strain_.data() + c * all);
  cells.means.clear(dilatation_.data());
}

/// Part of the means of the stress over the cells that waves shorter than the cells contribute: the means leave these out. It is minus the
/// stiffness, the mean of all directions, times the strain less what is left of it. Uses the strain that has been spread.
InclusionField InclusionFields::sharp_stress(const InclusionCells& cells, const InclusionField& equivalent) const
{
  const std::size_t all = body_.grid().size(), n = cells.size();
  const double nu = cells.poisson_ratio;
  const double shear = cells.root_shear * cells.root_shear * (1.0 - 2.0 * (4.0 - 5.0 * nu) / (15.0 * (1.0 - nu)));
  const double volume = cells.root_volume * cells.root_volume * (1.0 - (1.0 + nu) / (3.0 * (1.0 - nu)));
  InclusionField sharp = cells.make_field();
  for (int c = 0; c < Deviator::size; ++c)
    for (std::size_t i = 0; i < n; ++i)
    {
      const double* const field = strain_.data() + static_cast<std::size_t>(c) * all;
      const std::size_t at = static_cast<std::size_t>(c) * n + i;
      sharp.deviator[at] = -shear * (equivalent.deviator[at] - cells.means.mean(field, parity_of(c), i));
    }
  for (std::size_t i = 0; i < n; ++i)
    sharp.volumetric[i] = -volume * (equivalent.volumetric[i] - cells.means.mean(dilatation_.data(), 1.0, i));
  return sharp;
}

void InclusionFields::gather(const InclusionCells& cells, std::span<const double> deviators,
                             std::span<const double> traces, InclusionField& out) const
{
  const std::size_t all = body_.grid().size(), n = cells.size();
  for (int c = 0; c < Deviator::size; ++c)
    for (std::size_t i = 0; i < n; ++i)
      out.deviator[static_cast<std::size_t>(c) * n + i] =
          cells.means.mean(deviators.data() + static_cast<std::size_t>(c) * all, parity_of(c), i);
  for (std::size_t i = 0; i < n; ++i)
    out.volumetric[i] = cells.means.mean(traces.data(), 1.0, i);
}

void InclusionFields::stress(const InclusionCells& cells, const InclusionField& equivalent, InclusionField& caused)
{
  add(cells, equivalent, cells.layers, {}, &caused);
}

void InclusionFields::add(const InclusionCells& cells, const InclusionField& equivalent, int layers,
                          const HalfSpace::Dilated& to, InclusionField* caused)
{
  spread(cells, equivalent);
  const bool has_shear = !to.displacement.x.empty() || !to.displacement.y.empty();
  const bool wants_trace = !to.trace.empty() || caused != nullptr;
  const bool wants_stress = !to.deviator.empty() || wants_trace;
  const int computed = wants_stress ? layers : 0;
  const HalfSpace::Loaded loaded =
      body_.load(strain_, computed, work_, has_shear ? Displacements::all : Displacements::normal, wants_trace);
  const auto add_displacement = [&](std::span<double> out, auto part)
  {
    if (out.empty())
      return;
    std::vector<double> u(out.size());
    SurfaceDisplacement only;
    only.*part = u;
    loaded.displacement(only);
    for (std::size_t i = 0; i < u.size(); ++i)
      out[i] += u[i];
  };
  add_displacement(to.displacement.z, &SurfaceDisplacement::z);
  add_displacement(to.displacement.x, &SurfaceDisplacement::x);
  add_displacement(to.displacement.y, &SurfaceDisplacement::y);
  if (wants_stress)
    loaded.stress({}, deviator_); // also before the trace, which is that of the last load
  if (wants_trace)
    loaded.traces({}, trace_);
  body_.add_dilatation(dilatation_, computed, dilatation_work_,
                       {wants_stress ? std::span<double>(deviator_) : std::span<double>(),
                        wants_trace ? std::span<double>(trace_) : std::span<double>(), to.displacement});
  const InclusionField sharp = wants_stress ? sharp_stress(cells, equivalent) : InclusionField();
  clear(cells);
  if (caused != nullptr)
  {
    gather(cells, deviator_, trace_, *caused);
    add_to(sharp.deviator, caused->deviator);
    add_to(sharp.volumetric, caused->volumetric);
  }
  if (!to.deviator.empty() || !to.trace.empty())
    add_stress(cells, sharp, computed, to);
}

/// Adds the stress that has been computed, and that in the cells by waves shorter than the cells.
void InclusionFields::add_stress(const InclusionCells& cells, const InclusionField& sharp, int layers,
                                 const HalfSpace::Dilated& to)
{
  const VolumeGrid& grid = body_.grid();
  const std::size_t all = grid.size(), n = cells.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t c = 0; c < Deviator::size; ++c)
      deviator_[c * all + cells.cells[i]] += sharp.deviator[c * n + i];
    trace_[cells.cells[i]] += sharp.volumetric[i];
  }
  if (grid.surface.is_mirrored_y)
  {
    complete_in_y(grid, deviator_);
    complete_in_y(grid.surface, 1.0, trace_.data(), trace_.size());
  }
  const std::size_t of_layers = static_cast<std::size_t>(layers) * grid.surface.size();
  for (std::size_t c = 0; c < Deviator::size && !to.deviator.empty(); ++c)
    for (std::size_t i = c * all; i < c * all + of_layers; ++i)
      to.deviator[i] += deviator_[i];
  for (std::size_t i = 0; i < of_layers && !to.trace.empty(); ++i)
    to.trace[i] += trace_[i];
}

} // namespace brinell::halfspace
