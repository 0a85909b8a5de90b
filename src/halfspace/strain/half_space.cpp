// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/half_space.hpp"

#include "brinell/halfspace/surface_compliance.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/fft.hpp"
#include "foundation/sharing.hpp"
#include "half_space_operators.hpp"
#include "halfspace/traction/stack_cells.hpp"
#include "halfspace/transform/require_surface.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <omp.h>
#include <utility>

namespace brinell::halfspace
{

HalfSpace::HalfSpace(const VolumeGrid& grid, const Elastic& elastic, Ranks ranks)
    : operators_(
          std::make_unique<Operators>(grid, ElasticStack{{}, elastic}, layer_waves::Shortest{}, std::move(ranks)))
{
}

HalfSpace::HalfSpace(const VolumeGrid& grid, const ElasticStack& stack, Ranks ranks)
    : operators_(std::make_unique<Operators>(grid, stack, layer_waves::Shortest{}, std::move(ranks)))
{
  require_resolved(grid.surface, stack);
}

namespace
{

/// Fractions of the couplings that are retained for the shortest waves, such that a strain within a
/// part causes the same amplitude of these waves as on the whole grid: a transform of p columns omits 1/p of the response between
/// each pair of cells, with alternating signs.
layer_waves::Shortest shortest_of_part(const SurfaceGrid& part, const SurfaceGrid& whole)
{
  const PaddedLengths own = padded_lengths(part), all = padded_lengths(whole);
  const auto retained = [](int of_part, int of_whole)
  { return of_whole % 2 == 0 ? std::max(0.0, 1.0 - static_cast<double>(of_part) / of_whole) : 1.0; };
  return {retained(own.x, all.x), part.is_mirrored_y ? 0.0 : retained(own.y, all.y)};
}

} // namespace

HalfSpace::HalfSpace(const VolumeGrid& grid, const Elastic& elastic, const SurfaceGrid& whole, Ranks ranks)
    : operators_(std::make_unique<Operators>(grid, ElasticStack{{}, elastic}, shortest_of_part(grid.surface, whole),
                                             std::move(ranks)))
{
}

HalfSpace::HalfSpace(const VolumeGrid& grid, const ElasticStack& stack, const SurfaceGrid& whole, Ranks ranks)
    : operators_(std::make_unique<Operators>(grid, stack, shortest_of_part(grid.surface, whole), std::move(ranks)))
{
  require_resolved(grid.surface, stack);
}

HalfSpace::~HalfSpace() = default;
HalfSpace::HalfSpace(HalfSpace&&) noexcept = default;
HalfSpace& HalfSpace::operator=(HalfSpace&&) noexcept = default;

const VolumeGrid& HalfSpace::grid() const
{
  return operators_->grid;
}

const Elastic& HalfSpace::elastic() const
{
  return operators_->stack.substrate;
}

const Elastic& HalfSpace::elastic_of(int layer) const
{
  return operators_->stack.at((layer + 0.5) * grid().dz);
}

const ElasticStack& HalfSpace::stack() const
{
  return operators_->stack;
}

const HalfSpace::Ranks& HalfSpace::shared_ranks() const
{
  return operators_->ranks;
}

const Share& HalfSpace::share() const
{
  return operators_->share;
}

VolumeGrid HalfSpace::own_grid() const
{
  return operators_->own;
}

HalfSpace::Work::Work() = default;
HalfSpace::Work::~Work() = default;
HalfSpace::Work::Work(Work&&) noexcept = default;
HalfSpace::Work& HalfSpace::Work::operator=(Work&&) noexcept = default;

HalfSpace::Work HalfSpace::make_work() const
{
  Work work;
  work.buffers_ = operators_->make_buffers(false);
  return work;
}

void HalfSpace::exchange_buffers(Work& guest, Work& host)
{
  for (const auto spectra : Work::Buffers::lent())
    ((*guest.buffers_).*spectra).swap((*host.buffers_).*spectra);
  // The buffers of the host hold as many blocks as it works on at a time, which may be fewer than the guest would choose.
  std::swap(guest.buffers_->blocks_at_a_time, host.buffers_->blocks_at_a_time);
  ++host.buffers_->number; // the strain that it held is lost
}

HalfSpace::Work HalfSpace::make_guest() const
{
  Work work;
  work.buffers_ = operators_->make_buffers(true);
  return work;
}

HalfSpace::Loaded HalfSpace::load(std::span<const double> plastic_strain, int layers, Work& work,
                                  Displacements displacements, bool with_trace) const
{
  require_size("HalfSpace::load: the plastic strain", plastic_strain, Deviator::size * own_grid().size());
  if (layers < 0 || layers > grid().nz)
    throw InternalError(fmt::format("HalfSpace::load: {} layers are wanted, the grid has {}", layers, grid().nz));
  if (work.empty())
    throw InternalError("HalfSpace::load: the work is empty; make_work makes one");
  Work::Buffers& buffers = *work.buffers_;
  operators_->load_strain(plastic_strain, layers, displacements, buffers, with_trace ? &buffers.trace : nullptr);
  buffers.has_trace = with_trace;
  return {*operators_, plastic_strain, *work.buffers_};
}

HalfSpace::Loaded::Loaded(const Operators& operators, std::span<const double> plastic_strain, Work::Buffers& buffers)
    : operators_(&operators), plastic_strain_(plastic_strain), buffers_(&buffers), number_(buffers.number)
{
}

void HalfSpace::Loaded::require_current(const char* function_name) const
{
  if (number_ != buffers_->number)
    throw InternalError(fmt::format("{}: the buffers hold another strain by now", function_name));
}

void HalfSpace::Loaded::displacement(const SurfaceDisplacement& out) const
{
  const Operators& op = *operators_;
  require_displacement("HalfSpace::Loaded::displacement", out, op.grid.surface.size());
  require_current("HalfSpace::Loaded::displacement");
  const Displacements prepared = buffers_->displacements;
  if ((prepared == Displacements::normal && !out.x.empty()) || (prepared != Displacements::all && !out.y.empty()))
    throw InternalError("HalfSpace::Loaded::displacement: the load was not asked for this displacement");
  const OfTraction<std::span<double>> parts{out.z, out.x, out.y};
  for (std::size_t t = 0; t < parts.size(); ++t)
    if (!parts[t].empty())
    {
      op.surface_fft.rows_inverse(buffers_->displacement_rows[t].data(), 0, parts[t].data(),
                                  buffers_->threads.front().fft);
      op.complete(tractions[t] == Traction::shear_y, parts[t]);
    }
}

void HalfSpace::Loaded::stress(const SurfaceLoad& load, std::span<double> deviator) const
{
  const Operators& op = *operators_;
  require_load("HalfSpace::Loaded::stress", load, op.grid.surface.size());
  require_size("HalfSpace::Loaded::stress: the stress", deviator, Deviator::size * op.own.size());
  require_current("HalfSpace::Loaded::stress");
  op.load_surface(load, *buffers_);
  if (!op.share.is_all())
    op.add_load_and_invert_shared(load, plastic_strain_, *buffers_, deviator);
  else if (op.is_mirrored())
    op.add_load_and_invert_mirrored(load, plastic_strain_, *buffers_, deviator);
  else
    op.add_load_and_invert(load, plastic_strain_, *buffers_, deviator);
}

void HalfSpace::Loaded::trace(const SurfaceLoad& load, int layer, std::span<double> out) const
{
  const Operators& op = *operators_;
  require_load("HalfSpace::Loaded::trace", load, op.grid.surface.size());
  require_size("HalfSpace::Loaded::trace: the trace", out, op.grid.surface.size());
  require_current("HalfSpace::Loaded::trace");
  op.require_alone("HalfSpace::Loaded::trace");
  if (!buffers_->has_trace || layer >= buffers_->layers)
    throw InternalError("HalfSpace::Loaded::trace: the load was not asked for the trace in this layer");
  op.invert_plane(TractionStress::trace, layer, op.kernels_of(parts_of(load)), op.trace_fft, buffers_->trace.data(),
                  layer, *buffers_, buffers_->threads.front(), out.data());
  op.finish(ImageCorrection::trace, layer, plastic_strain_, *buffers_, out.data());
}

bool HalfSpace::Loaded::has_trace() const
{
  return number_ == buffers_->number && buffers_->has_trace;
}

void HalfSpace::Loaded::traces(const SurfaceLoad& load, std::span<double> out) const
{
  const Operators& op = *operators_;
  require_load("HalfSpace::Loaded::traces", load, op.grid.surface.size());
  require_size("HalfSpace::Loaded::traces: the trace", out, op.grid.size());
  op.require_alone("HalfSpace::Loaded::traces");
  if (!has_trace())
    throw InternalError("HalfSpace::Loaded::traces: the trace is not known");
  const auto kernels = op.kernels_of(parts_of(load));
  const auto threads = static_cast<int>(buffers_->threads.size());
#pragma omp parallel for num_threads(threads) schedule(static)
  for (int layer = 0; layer < buffers_->layers; ++layer)
  {
    double* field = out.data() + op.field_at(0, layer);
    op.invert_plane(TractionStress::trace, layer, kernels, op.trace_fft, buffers_->trace.data(), layer, *buffers_,
                    buffers_->threads[static_cast<std::size_t>(omp_get_thread_num())], field);
    op.finish(ImageCorrection::trace, layer, plastic_strain_, *buffers_, field);
  }
}

void HalfSpace::stress_of_load(const SurfaceLoad& load, Work& work,
                               const std::function<void(int layer, std::span<const double> stress)>& use) const
{
  const Operators& op = *operators_;
  const std::size_t cells = op.grid.surface.size();
  require_load("HalfSpace::stress_of_load", load, cells);
  op.require_alone("HalfSpace::stress_of_load");
  if (work.empty())
    throw InternalError("HalfSpace::stress_of_load: the work is empty; make_guest makes one");
  Work::Buffers& buffers = *work.buffers_;
  ++buffers.number;
  op.load_surface(load, buffers);
  const AlignedVector<ComplexLanes> nothing(op.surface_fft.block_size() *
                                            static_cast<std::size_t>(op.surface_fft.blocks()));
  const auto kernels = op.kernels_of(parts_of(load));
  in_threads(static_cast<int>(buffers.threads.size()),
             [&](int thread)
             {
               std::vector<double> stress((Deviator::size + 1) * cells);
#pragma omp for schedule(static)
               for (int layer = 0; layer < op.grid.nz; ++layer)
               {
                 for (int component = 0; component <= TractionStress::trace; ++component)
                   op.invert_plane(component, layer, kernels, op.surface_fft, nothing.data(), 0, buffers,
                                   buffers.threads[static_cast<std::size_t>(thread)],
                                   stress.data() + static_cast<std::size_t>(component) * cells);
                 use(layer, stress);
               }
             });
}

void HalfSpace::stress_of_load(const SurfaceLoad& load, int layer, Work& work, std::span<double> stress) const
{
  const Operators& op = *operators_;
  const std::size_t cells = op.grid.surface.size();
  require_load("HalfSpace::stress_of_load", load, cells);
  require_size("HalfSpace::stress_of_load: the stress", stress, (Deviator::size + 1) * cells);
  op.require_alone("HalfSpace::stress_of_load");
  if (work.empty())
    throw InternalError("HalfSpace::stress_of_load: the work is empty; make_guest makes one");
  Work::Buffers& buffers = *work.buffers_;
  ++buffers.number;
  op.load_surface(load, buffers);
  const AlignedVector<ComplexLanes> nothing(op.surface_fft.block_size() *
                                            static_cast<std::size_t>(op.surface_fft.blocks()));
  for (int component = 0; component <= TractionStress::trace; ++component)
  {
    const std::span<double> field = stress.subspan(static_cast<std::size_t>(component) * cells, cells);
    op.invert_plane(component, layer, op.kernels_of(parts_of(load)), op.surface_fft, nothing.data(), 0, buffers,
                    buffers.threads.front(), field.data());
    op.complete(component < Deviator::size && is_odd_in_y(component), field);
  }
}

void HalfSpace::full_stress(const SurfaceLoad& load, std::span<const double> plastic_strain, Work& work,
                            std::span<double> deviator, std::span<double> trace, int layers) const
{
  const Operators& op = *operators_;
  const VolumeGrid& grid = op.grid;
  const int computed = std::min(layers, grid.nz);
  require_load("HalfSpace::full_stress", load, grid.surface.size());
  require_size("HalfSpace::full_stress: the plastic strain", plastic_strain, Deviator::size * op.own.size());
  require_size("HalfSpace::full_stress: the deviator", deviator, Deviator::size * op.own.size());
  require_size("HalfSpace::full_stress: the trace", trace, op.own.size());
  if (work.empty())
    throw InternalError("HalfSpace::full_stress: the work is empty; make_work makes one");
  Work::Buffers& buffers = *work.buffers_;
  const BlockedFft& fft = op.trace_fft;
  AlignedVector<ComplexLanes> spectra;
  op.load_strain(plastic_strain, computed, Displacements::normal, buffers, &spectra);
  Loaded(op, plastic_strain, buffers).stress(load, deviator);
  const auto kernels = op.kernels_of(parts_of(load));
  const auto threads = static_cast<int>(buffers.threads.size());
  if (!op.share.is_all())
    op.invert_traces_shared(kernels, computed, spectra.data(), buffers, trace.data());
#pragma omp parallel for num_threads(threads) schedule(static)
  for (int layer = 0; layer < computed; ++layer)
  {
    if (!op.share.has(layer))
      continue;
    double* field = trace.data() + op.field_at(0, layer);
    if (op.share.is_all())
      op.invert_plane(TractionStress::trace, layer, kernels, fft, spectra.data(), layer, buffers,
                      buffers.threads[static_cast<std::size_t>(omp_get_thread_num())], field);
    op.finish(ImageCorrection::trace, layer, plastic_strain, buffers, field);
    op.complete(false, trace.subspan(op.field_at(0, layer), grid.surface.size()));
    for (int c = 0; c < Deviator::size; ++c)
      op.complete(is_odd_in_y(c), deviator.subspan(op.field_at(c, layer), grid.surface.size()));
  }
}

} // namespace brinell::halfspace
