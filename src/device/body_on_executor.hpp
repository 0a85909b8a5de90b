// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "active_kernels.hpp"
#include "boundary_parts.hpp"
#include "brinell/elastoplastic/device.hpp"
#include "growing.hpp"
#include "half_space.hpp"
#include "held_law.hpp"
#include "history.hpp"
#include "sums.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <type_traits>
#include <vector>

namespace brinell::device
{

/// The active cells of a body on an executor.
template <typename Executor>
struct ActiveOnExecutor
{
  std::size_t size = 0;
  Growing<Executor, std::size_t> cells;
  Growing<Executor, double> trials, mapped, flow, start, equivalent, dissipation, backstress;

  ActiveOnExecutor(const Executor& executor, std::size_t terms)
      : cells(executor), trials(executor, Deviator::size), mapped(executor, Deviator::size),
        flow(executor, Deviator::size), start(executor, Deviator::size), equivalent(executor), dissipation(executor),
        backstress(executor, terms * Deviator::size)
  {
  }
  void grow(std::size_t count)
  {
    cells.grow(count);
    for (Growing<Executor, double>* field : {&trials, &mapped, &flow, &start, &equivalent, &dissipation, &backstress})
      field->grow(count);
    size = count;
  }
  [[nodiscard]] ActiveArrays arrays()
  {
    return {cells.data(), trials.data(),     mapped.data(),      flow.data(),
            start.data(), equivalent.data(), dissipation.data(), backstress.data()};
  }
};

/// The increments of a homogeneous body on an executor, in whose memory its state stays.
template <typename Executor>
class BodyOnExecutor : public elastoplastic::BodyOnDevice
{
public:
  /// @param executor  is kept by its maker
  BodyOnExecutor(const VolumeGrid& grid, const constitutive::Material& material, bool with_shears,
                 const Executor& executor)
      : grid_(grid), executor_(&executor), law_(material.hardening.value(), material.kinematic, executor),
        half_space_(grid, material.elastic, boundary_of(grid, material.elastic, with_shears), executor),
        work_(half_space_.make_work()), layer_factor_(layers()), initial_(0), strain_(deviators()),
        before_(deviators()), stress_(deviators()), equivalent_(field(grid.size())),
        backstress_(field(material.kinematic.size() * Deviator::size * grid.size())), surface_(field(of_layer())),
        is_active_(executor.template allocate<unsigned char>(grid.size())),
        is_found_(executor.template allocate<unsigned char>(independent())),
        active_(executor, material.kinematic.size()), packed_(executor, Deviator::size), places_(executor),
        history_(executor), of_errors_(grid.size(), executor), of_found_(grid.size(), executor)
  {
    std::vector<double> factors, initial;
    for (int layer = 0; layer < grid.nz; ++layer)
    {
      const double depth = (layer + 0.5) * grid.dz;
      factors.push_back(material.yield_factor.at(depth, 1.0));
      initial.push_back(material.initial_stress.at(depth, 0.0) / 3.0);
    }
    executor.write(std::span<const double>(factors), layer_factor_);
    if (!material.initial_stress.empty())
    {
      initial_ = layers();
      executor.write(std::span<const double>(initial), initial_);
    }
    for (std::size_t t = 0; t < (with_shears ? tractions_.size() : 1); ++t)
      tractions_[t] = field(of_layer());
  }

  void write(const State& state) override
  {
    executor_->write(state.plastic_strain, strain_);
    executor_->write(state.stress, before_);
    executor_->write(state.guess, stress_);
    executor_->write(state.equivalent, equivalent_);
    if (!state.backstress.empty())
      executor_->write(state.backstress, backstress_);
  }
  void set_softening(std::span<const double> factor) override { set(factor, softening_); }
  void set_thermal_stress(std::span<const double> deviator) override { set(deviator, thermal_); }

  Found begin(const Start& start) override
  {
    stiffness_ = start.stiffness;
    executor_->run("end of activity", active_.size, Deactivate{fields(), active_.cells.data()});
    active_.size = 0;
    history_.reset();
    return collect(start.from_stress ? before_.data() : stress_.data(), start.shift, start.fraction, grid_.nz);
  }
  void integrate(constitutive::Integration integration, const std::array<std::span<double>, 3>& displacement) override
  {
    law_.visit(
        [&](const auto& law)
        {
          if (law_.kinematic().count == 0)
            flow<false>(law, integration);
          else
            flow<true>(law, integration);
        });
    half_space_.load(strain_.data(), work_);
    constexpr std::array along{Traction::pressure, Traction::shear_x, Traction::shear_y};
    for (std::size_t axis = 0; axis < along.size(); ++axis)
      if (!displacement[axis].empty())
        find_displacement(along[axis], displacement[axis]);
  }
  void find_displacement_x(std::span<double> displacement) override
  {
    find_displacement(Traction::shear_x, displacement);
  }
  Found update(const halfspace::SurfaceLoad& load, int layers) override
  {
    find_stress(load);
    const std::size_t known = active_.size;
    Found found = law_.visit(
        [&](const auto& law)
        {
          using Law = std::decay_t<decltype(law)>;
          const LargestError error =
              of_errors_("images of trials", known, ImageOfActive<Law>{law, fields(), active_.arrays()});
          Found of_law = collect(stress_.data(), 0, 1.0, layers);
          executor_->run("trials on the yield surface", active_.size - known,
                         PutOnYieldSurface<Law>{law, fields(), active_.arrays(), known});
          of_law.yield_error = error.value;
          return of_law;
        });
    return found;
  }

  void read_active(elastoplastic::ActiveCells& active, std::span<double> plastic_strain) override
  {
    const std::size_t count = active_.size;
    std::vector<std::size_t> cells(count);
    active_.cells.read(count, cells.data());
    active.assign(cells, grid_.surface);
    const elastoplastic::ActiveCells::Packed to = active.packed();
    active_.trials.read(count, to.trials);
    active_.mapped.read(count, to.mapped);
    active_.flow.read(count, to.flow);
    active_.start.read(count, to.start);
    active_.equivalent.read(count, to.equivalent);
    active_.dissipation.read(count, to.dissipation);
    std::vector<double> packed(count * Deviator::size * law_.kinematic().count);
    active_.backstress.read(count, packed.data());
    active.assign_backstresses(packed);
    packed_.grow(count);
    executor_->run("strain of active cells", count, StrainOfActive{fields(), active_.cells.data(), packed_.data()});
    packed.resize(count * Deviator::size);
    packed_.read(count, packed.data());
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t c = 0; c < Deviator::size; ++c)
        plastic_strain[c * grid_.size() + cells[a]] = packed[a * Deviator::size + c];
  }
  void read_stress(std::span<double> stress) override { executor_->read(stress_, stress); }
  void write_trials(std::span<const double> trials) override { active_.trials.write(trials); }
  void commit() override
  {
    executor_->run("stress before the next increment", Deviator::size * grid_.size(),
                   CopyValues<double>{stress_.data(), before_.data()});
    executor_->run("commit", active_.size, CommitActive{fields(), active_.arrays()});
  }

  std::vector<AndersonProducts> record(const elastoplastic::AndersonWeights::Entry& entry) override
  {
    return history_.record(entry, unknowns(), active_.trials.data(), active_.mapped.data(), active_.flow.data());
  }
  void combine(std::span<const double> weights) override
  {
    history_.combine(weights, unknowns(), active_.mapped.data(), active_.trials.data());
  }
  std::vector<double> residual(std::span<const double> weights) override { return history_.residual(weights); }
  void deepen(const elastoplastic::AndersonWeights::Moved& moved) override
  {
    history_.set_depth(moved.depth, moved.first);
  }

private:
  using Array = typename Executor::template Memory<double>;
  using Flags = typename Executor::template Memory<unsigned char>;

  [[nodiscard]] Array field(std::size_t count) const { return executor_->template allocate<double>(count); }
  [[nodiscard]] Array deviators() const { return field(Deviator::size * grid_.size()); }
  [[nodiscard]] Array layers() const { return field(static_cast<std::size_t>(grid_.nz)); }
  [[nodiscard]] std::size_t of_layer() const { return grid_.surface.size(); }
  [[nodiscard]] std::size_t independent() const
  {
    return grid_.surface.independent_cells() * static_cast<std::size_t>(grid_.nz);
  }
  [[nodiscard]] std::size_t unknowns() const { return Deviator::size * active_.size; }
  [[nodiscard]] BodyFields fields()
  {
    return {.cells = grid_.size(),
            .nx = static_cast<std::size_t>(grid_.surface.nx),
            .ny = static_cast<std::size_t>(grid_.surface.ny),
            .is_mirrored = grid_.surface.is_mirrored_y,
            .independent = grid_.surface.independent_cells(),
            .stiffness = stiffness_,
            .terms = law_.kinematic().count,
            .layer_factor = layer_factor_.data(),
            .softening = softening_.size() > 0 ? softening_.data() : nullptr,
            .strain = strain_.data(),
            .before = before_.data(),
            .stress = stress_.data(),
            .equivalent = equivalent_.data(),
            .backstress = backstress_.data(),
            .is_active = is_active_.data()};
  }
  void set(std::span<const double> values, Array& to)
  {
    if (to.size() != values.size())
      to = field(values.size());
    if (!values.empty())
      executor_->write(values, to);
  }
  template <bool has_backstress, typename Law>
  void flow(const Law& law, constitutive::Integration integration)
  {
    const FlowRule<Law, has_backstress> rule{law, integration, law_.kinematic(), stiffness_};
    executor_->run("flow of active cells", active_.size,
                   FlowOfActive<Law, has_backstress>{rule, fields(), active_.arrays()});
  }
  void find_displacement(Traction along, std::span<double> displacement)
  {
    half_space_.displacement(along, work_, surface_.data());
    executor_->read(surface_, displacement);
  }
  void find_stress(const halfspace::SurfaceLoad& load)
  {
    const std::array<std::span<const double>, 3> parts{load.pressure, load.shear_x, load.shear_y};
    std::array<const double*, 3> on_executor{};
    for (std::size_t t = 0; t < parts.size(); ++t)
      if (!parts[t].empty())
      {
        executor_->write(parts[t], tractions_[t]);
        on_executor[t] = tractions_[t].data();
      }
    half_space_.stress({on_executor[0], on_executor[1], on_executor[2]}, strain_.data(), work_, stress_.data());
    if (initial_.size() > 0)
      executor_->run("initial stress", grid_.size(),
                     AddInLayers{grid_.size(), of_layer(), initial_.data(), stress_.data()});
    if (thermal_.size() > 0)
      executor_->run("thermal stress", Deviator::size * grid_.size(), AddField{thermal_.data(), stress_.data()});
  }
  /// Adds the cells of the layers [0, layers) that are outside the yield surface to the active ones.
  Found collect(const double* q, int shift, double fraction, int layers)
  {
    const std::size_t count = grid_.surface.independent_cells() * static_cast<std::size_t>(layers);
    const FoundCells found = law_.visit(
        [&](const auto& law)
        {
          using Law = std::decay_t<decltype(law)>;
          return of_found_("cells that yield", count,
                           FindBeyond<Law>{law, fields(), q, shift, fraction, is_found_.data()});
        });
    if (found.count > 0.0)
      add_found(q, shift, count);
    return {static_cast<std::size_t>(found.count), std::max(0, static_cast<int>(found.deepest)), 0.0};
  }
  void add_found(const double* q, int shift, std::size_t count)
  {
    const std::size_t pieces = (count + cells_of_piece - 1) / cells_of_piece;
    places_.grow(pieces);
    executor_->run("cells of a piece", pieces, CountOfPiece{count, is_found_.data(), places_.data()});
    std::vector<std::size_t> places(pieces);
    places_.read(pieces, places.data());
    std::size_t end = active_.size;
    for (std::size_t& place : places)
      end = std::exchange(place, end) + end;
    places_.write(places);
    active_.grow(end);
    executor_->run("new active cells", pieces,
                   AddOfPiece{fields(), active_.arrays(), count, is_found_.data(), places_.data(), q, shift});
  }

  VolumeGrid grid_;
  const Executor* executor_;
  HeldLaw<Executor> law_;
  HalfSpace<Executor> half_space_;
  typename HalfSpace<Executor>::Work work_;
  double stiffness_ = 0.0;
  Array layer_factor_, initial_;            ///< of the layers; no initial stress: empty
  Array strain_, before_, stress_;          ///< BodyFields
  Array equivalent_, backstress_, surface_; ///< the last one for displacements
  Array softening_{}, thermal_{};           ///< empty: none
  std::array<Array, 3> tractions_;
  Flags is_active_, is_found_;
  ActiveOnExecutor<Executor> active_;
  Growing<Executor, double> packed_;
  Growing<Executor, std::size_t> places_;
  History<Executor> history_;
  Sums<Executor, LargestError> of_errors_;
  Sums<Executor, FoundCells> of_found_;
};

} // namespace brinell::device
