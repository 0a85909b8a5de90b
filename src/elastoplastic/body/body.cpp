// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/require_size.hpp"
#include "foundation/sharing.hpp"
#include "window.hpp"
#include "with_copies.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::elastoplastic
{

namespace
{

/// Cells above this share of the yield stress are active from the start. This is only a guess: every evaluation adds further
/// cells that yield.
constexpr double active_share = 0.8;

} // namespace

Body::Body(const VolumeGrid& grid, std::shared_ptr<const halfspace::HalfSpace> half_space,
           const constitutive::Material& material, bool shortcuts, halfspace::Displacements displacements,
           Symmetry symmetry, bool windows)
    : grid_(grid), material_(material), half_space_(std::move(half_space)), shortcuts_(shortcuts), symmetry_(symmetry),
      layers_(grid_.nz), displacement_(grid_.surface.size(), 0.0)
{
  const std::size_t n = grid_.size();
  if (!material.elastic.is_rigid())
  {
    state_.plastic_strain.assign(Deviator::size * n, 0.0);
    state_.equivalent.assign(n, 0.0);
  }
  state_.backstress.assign(material.kinematic.size() * Deviator::size * n, 0.0);
  if (is_plastic())
    state_.stress.assign(Deviator::size * n, 0.0);
  if (is_plastic())
    zone_ = PlasticZone(grid_, state_.equivalent);
  state_.residual_displacement = displacement_;
  if (displacements != halfspace::Displacements::normal && is_plastic())
    displacement_x_.assign(grid_.surface.size(), 0.0);
  if (displacements == halfspace::Displacements::all && is_plastic())
    displacement_y_.assign(grid_.surface.size(), 0.0);
  state_.residual_displacement_x = displacement_x_;
  state_.residual_displacement_y = displacement_y_;
  for (int layer = 0; layer < grid_.nz; ++layer)
  {
    const double depth = (layer + 0.5) * grid_.dz;
    yield_factor_.push_back(material.yield_factor.at(depth, 1.0));
    initial_stress_.push_back(material.initial_stress.at(depth, 0.0));
  }
  if (is_plastic())
    add_initial_stress(grid_.nz, grid_.surface.ny, state_.stress);
  if (is_plastic() && shortcuts && windows)
    window_ = std::make_unique<Window>(grid_, material_.elastic, symmetry_);
}

Body::~Body() = default;
Body::Body(Body&&) noexcept = default;
Body& Body::operator=(Body&&) noexcept = default;

/// Allocates the trial on first use: a body that is rigid or stays elastic never needs one.
void Body::prepare_trial()
{
  if (!stress_.empty())
    return;
  stress_ = state_.stress;
  active_ = ActiveCells(grid_.size(), material_.kinematic.size());
}

void Body::exchange(Archive& archive)
{
  if (!is_plastic())
    return;
  prepare_trial();
  archive("state", state_);
  archive("q_field", stress_);
  if (window_)
    for (std::size_t part = 0; part < committed_load_.size(); ++part)
      archive.list(fmt::format("load_{}", part), committed_load_[part]);
  if (window_)
    archive("window_wishes", window_->requests());
  displacement_ = state_.residual_displacement;
  displacement_x_ = state_.residual_displacement_x;
  displacement_y_ = state_.residual_displacement_y;
  has_own_thermal_stress_ = false;
  softening_ = state_.softening;
  if (!archive.gives())
    return;
  zone_ = PlasticZone(grid_, state_.equivalent);
  recover_guess();
}

void Body::set_softening(std::span<const double> factor)
{
  if (!factor.empty())
    require_size("Body::set_softening: the factor", factor, grid().size());
  for (const double value : factor)
    if (!(value > 0.0 && std::isfinite(value)))
      throw InputError(fmt::format("the factor on the yield stress of a cell is {:g}; allowed: above 0", value));
  softening_.assign(factor.begin(), factor.end());
  if (!in_increment_)
    state_.softening = softening_;
}

void Body::begin(int shift, double stiffness_share)
{
  stiffness_ = 2.0 * stiffness_share * material_.elastic.shear_modulus();
  displacement_ = state_.residual_displacement;
  if (!is_plastic())
    return;
  prepare_trial();
  has_own_thermal_stress_ = knows_watched_traces_ = false;
  in_increment_ = true;
  active_.clear();
  layers_ = grid().nz;
  windowed_ = was_windowed_ = wants_all_cells_ = false;
  may_use_window_ = true;
  if (window_)
    window_->begin_increment();
  shift_ = shift;
  // In the frame of the contact q changes little from step to step: the guess moves along with the contact.
  collect_active(stress_, shift, shortcuts_ ? active_share : -1.0);
  restrict_to_active_layers();
}

void Body::restore()
{
  displacement_ = state_.residual_displacement;
  displacement_x_ = state_.residual_displacement_x;
  displacement_y_ = state_.residual_displacement_y;
  has_own_thermal_stress_ = false;
  softening_ = state_.softening;
  if (!in_increment_)
    return;
  in_increment_ = knows_watched_traces_ = false;
  const std::size_t n = grid().size();
  for (std::size_t a = 0; a < active_.size(); ++a)
    with_copies(a, [&](std::size_t cell, const auto& seen)
                { store(seen(active_.start(a)), state_.plastic_strain, n, cell); });
  stress_ = state_.stress;
  for (std::size_t a = 0; a < guessed_cells_.size(); ++a)
    for (std::size_t c = 0; c < Deviator::size; ++c)
      stress_[c * n + guessed_cells_[a]] = guessed_q_[a * Deviator::size + c];
}

void Body::compute_all_layers()
{
  layers_ = grid().nz;
  leave_window();
}

void Body::leave_window()
{
  windowed_ = false;
  wants_all_cells_ = true;
}

/// Adds the deviator of the initial stress xx = yy = sigma, zz = 0.
void Body::add_initial_stress(int layers, int rows, std::span<double> stress) const
{
  if (material_.initial_stress.empty())
    return;
  const std::size_t n = grid().size();
  for (int layer = 0; layer < layers; ++layer)
    for (const std::size_t component : {Deviator::xx, Deviator::yy})
    {
      const std::size_t first = component * n + grid().index(0, 0, layer);
      for (std::size_t cell = first; cell < first + grid().surface.index(0, rows); ++cell)
        stress[cell] += initial_stress_[static_cast<std::size_t>(layer)] / 3.0;
    }
}

void Body::set_thermal_stress(std::span<const double> deviator)
{
  if (!is_plastic())
    return;
  thermal_stress_.assign(deviator.begin(), deviator.end());
  has_own_thermal_stress_ = true;
}

void Body::add_thermal_stress(int layers, int rows, std::span<double> stress) const
{
  const std::vector<double>& thermal = thermal_stress();
  if (thermal.empty())
    return;
  const std::size_t n = grid().size();
  for (std::size_t component = 0; component < Deviator::size; ++component)
    for (int layer = 0; layer < layers; ++layer)
    {
      const std::size_t first = component * n + grid().index(0, 0, layer);
      for (std::size_t cell = first; cell < first + grid().surface.index(0, rows); ++cell)
        stress[cell] += thermal[cell];
    }
}

Deviator Body::backstress(std::size_t cell, std::size_t term) const
{
  const std::size_t n = grid().size();
  Deviator b;
  for (int c = 0; c < Deviator::size; ++c)
    b[c] = state_.backstress[(term * Deviator::size + static_cast<std::size_t>(c)) * n + cell];
  return b;
}

/// Centre of the yield surface before the increment.
Deviator Body::centre(std::size_t cell) const
{
  Deviator sum;
  for (std::size_t term = 0; term < material_.kinematic.size(); ++term)
    sum = sum + backstress(cell, term);
  return sum;
}

void Body::commit(const halfspace::SurfaceLoad& load)
{
  if (!is_plastic())
    return;
  const std::size_t n = grid().size();
#pragma omp parallel for schedule(static)
  for (std::size_t a = 0; a < active_.size(); ++a)
    with_copies(a,
                [&](std::size_t cell, const auto& seen)
                {
                  state_.equivalent[cell] += active_.equivalent(a);
                  for (std::size_t term = 0; active_.equivalent(a) > 0.0 && term < material_.kinematic.size(); ++term)
                    store(seen(active_.backstress(a)[term]),
                          std::span(state_.backstress).subspan(term * Deviator::size * n, Deviator::size * n), n, cell);
                });
  for (std::size_t a = 0; a < active_.size(); ++a)
    if (active_.equivalent(a) > 0.0)
      with_copies(a, [&](std::size_t cell, const auto& /*seen*/) { zone_.add(cell, state_.equivalent[cell]); });
  for (std::size_t a = 0; a < active_.size(); ++a)
    state_.dissipation += copies(a) * active_.dissipation(a) * grid().cell_volume();
  state_.thermal_work += thermal_work_of_trial();
  if (has_own_thermal_stress_)
    state_.thermal_stress.swap(thermal_stress_);
  has_own_thermal_stress_ = false;
  state_.softening = softening_;
  for_pieces(stress_.size(), [&](std::size_t first, std::size_t last)
             { std::copy(stress_.begin() + first, stress_.begin() + last, state_.stress.begin() + first); });
  state_.residual_displacement = displacement_;
  state_.residual_displacement_x = displacement_x_;
  state_.residual_displacement_y = displacement_y_;
  state_.locked_in_energy = locked_in_energy(load, zone_);
  if (window_)
    copy_load(load, committed_load_);
  store_guess();
  in_increment_ = false;
}

void Body::full_stress(const halfspace::SurfaceLoad& load, std::span<double> deviator, std::span<double> trace,
                       int layers)
{
  if (!is_plastic() || work_.empty())
    work_ = half_space_->make_work();
  half_space_->full_stress(load, state_.plastic_strain, work_, deviator, trace, layers);
  add_initial_stress(grid().nz, grid().surface.ny, deviator);
  for (std::size_t i = 0; i < trace.size(); ++i)
    trace[i] += 2.0 * initial_stress_[i / grid().surface.size()];
  if (!is_plastic())
    work_ = {}; // an elastic body needs it for output only
}

} // namespace brinell::elastoplastic
