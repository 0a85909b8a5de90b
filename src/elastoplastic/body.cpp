// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body.hpp"

#include "brinell/constitutive/kinematic_return.hpp"
#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::elastoplastic
{

namespace
{

Deviator load(const std::vector<double>& field, std::size_t cells, std::size_t cell)
{
  Deviator d;
  for (int c = 0; c < Deviator::size; ++c)
    d[c] = field[static_cast<std::size_t>(c) * cells + cell];
  return d;
}

void store(const Deviator& d, std::vector<double>& field, std::size_t cells, std::size_t cell)
{
  for (int c = 0; c < Deviator::size; ++c)
    field[static_cast<std::size_t>(c) * cells + cell] = d[c];
}

Deviator load_packed(const std::vector<double>& packed, std::size_t n)
{
  Deviator d;
  std::copy_n(packed.begin() + static_cast<std::ptrdiff_t>(n * Deviator::size), Deviator::size, d.v.begin());
  return d;
}

void store_packed(const Deviator& d, std::vector<double>& packed, std::size_t n)
{
  std::copy(d.v.begin(), d.v.end(), packed.begin() + static_cast<std::ptrdiff_t>(n * Deviator::size));
}

/// Cells with more than this share of the yield stress take part in the fixed point from the start.
constexpr double active_share = 0.8;
/// Layers are computed down to the last one that carries plastic strain or this share of the yield stress, and a few on.
constexpr double layer_share = 0.6;
constexpr int spare_layers = 3;

} // namespace

void BodyState::exchange(Archive& archive)
{
  archive("plastic_strain", plastic_strain);
  archive("equivalent", equivalent);
  if (!backstress.empty())
    archive("backstress", backstress);
  archive("stress", stress);
  archive("residual_displacement", residual_displacement);
  archive("dissipation", dissipation);
  archive("locked_in_energy", locked_in_energy);
}

Body::Body(const VolumeGrid& grid, std::shared_ptr<const halfspace::HalfSpace> half_space,
           const constitutive::Material& material, std::vector<double> texture)
    : grid_(grid), material_(material), half_space_(std::move(half_space)), texture_(std::move(texture)),
      layers_(grid_.nz), known_layers_(grid_.nz), displacement_(grid_.surface.size(), 0.0)
{
  if (!texture_.empty() && texture_.size() != grid_.surface.size())
    throw InternalError("Body: a texture needs one value per cell of the surface");
  const std::size_t n = grid_.size();
  state_.plastic_strain.assign(Deviator::size * n, 0.0);
  state_.equivalent.assign(n, 0.0);
  state_.backstress.assign(material.kinematic.size() * Deviator::size * n, 0.0);
  state_.stress.assign(Deviator::size * n, 0.0);
  state_.residual_displacement = displacement_;
  is_active_.assign(n, 0);
  strain_ = state_.plastic_strain;
  for (int layer = 0; layer < grid_.nz; ++layer)
  {
    const double depth = (layer + 0.5) * grid_.dz;
    yield_factor_.push_back(material.yield_factor.at(depth, 1.0));
    initial_stress_.push_back(material.initial_stress.at(depth, 0.0));
  }
  add_initial_stress(grid_.nz, state_.stress);
  stress_ = state_.stress;
  q_field_ = state_.stress;
}

void Body::exchange(Archive& archive)
{
  std::vector<double> texture = texture_;
  archive.list("texture", texture);
  if (texture != texture_)
    throw InputError("the texture of a surface is not that of the stored state");
  if (!is_plastic())
    return;
  archive("state", state_);
  archive("q_field", q_field_);
  archive("layers", layers_);
  archive("known_layers", known_layers_);
  displacement_ = state_.residual_displacement;
  stress_ = state_.stress;
}

void Body::begin(int shift, double stiffness_share)
{
  stiffness_ = 2.0 * stiffness_share * material_.elastic.shear_modulus();
  strain_ = state_.plastic_strain;
  displacement_ = state_.residual_displacement;
  active_.clear();
  q_.clear();
  g_.clear();
  equivalent_.clear();
  dissipation_.clear();
  std::fill(is_active_.begin(), is_active_.end(), static_cast<char>(0));
  if (!is_plastic())
    return;
  const SurfaceGrid& s = grid().surface;
  // Seen from the contact, q changes little from step to step: carry it along.
  std::vector<double> guess(q_field_.size(), 0.0);
  for (std::size_t row = 0; row < q_field_.size() / static_cast<std::size_t>(s.nx); ++row)
    for (int i = std::max(0, shift); i < std::min(s.nx, s.nx + shift); ++i)
    {
      const std::size_t to = row * static_cast<std::size_t>(s.nx) + static_cast<std::size_t>(i);
      const std::size_t from = to - static_cast<std::size_t>(shift);
      guess[to] = q_field_[from];
    }
  collect_active(guess, active_share);
}

void Body::collect_active(const std::vector<double>& q_field, double fraction)
{
  const std::size_t n = grid().size();
  const std::size_t per_layer = grid().surface.size();
  const auto add_if_near_yield = [&](const auto& law, std::size_t cell)
  {
    const Deviator q = load(q_field, n, cell);
    const Deviator from_centre = q - centre(cell);
    const double yield = fraction * law.yield_stress_at(state_.equivalent[cell]);
    if (1.5 * contract(from_centre, from_centre) <= yield * yield)
      return;
    is_active_[cell] = 1;
    active_.push_back(cell);
    q_.insert(q_.end(), q.v.begin(), q.v.end());
    g_.insert(g_.end(), q.v.begin(), q.v.end());
  };
  std::visit(
      [&](const auto& law)
      {
        for (std::size_t layer = 0; layer < static_cast<std::size_t>(layers_); ++layer)
          for (std::size_t cell = layer * per_layer; cell < (layer + 1) * per_layer; ++cell)
            if (is_active_[cell] == 0)
              add_if_near_yield(law_of(law, layer), cell);
      },
      *material_.hardening);
  equivalent_.resize(active_.size());
  dissipation_.resize(active_.size());
  backstress_.resize(active_.size() * material_.kinematic.size());
}

template <typename Law>
constitutive::ScaledLaw<Law> Body::law_of(const Law& law, std::size_t layer) const
{
  return {law, yield_factor_[layer]};
}

/// The deviator of xx = yy = sigma, zz = 0, in the layers [0, layers).
void Body::add_initial_stress(int layers, std::vector<double>& stress) const
{
  if (material_.initial_stress.empty())
    return;
  const std::size_t n = grid().size();
  const std::size_t per_layer = grid().surface.size();
  for (std::size_t cell = 0; cell < static_cast<std::size_t>(layers) * per_layer; ++cell)
    for (const std::size_t component : {Deviator::xx, Deviator::yy})
      stress[component * n + cell] += initial_stress_[cell / per_layer] / 3.0;
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

/// Plastic strain of one active cell; its new back stresses go to `backstress_`.
template <typename Law>
constitutive::PlasticIncrement Body::increment(const Law& law, std::size_t a, Integration integration)
{
  const std::size_t cell = active_[a];
  const std::size_t known = static_cast<std::size_t>(known_layers_) * grid().surface.size();
  const bool along_path = integration == Integration::path && cell < known;
  const double e = state_.equivalent[cell];
  const double mu = 0.5 * stiffness_;
  const Deviator q = load_packed(q_, a);
  const Deviator s0 = load(state_.stress, grid().size(), cell);
  if (material_.kinematic.empty())
    return along_path ? constitutive::path_return(s0, q, e, mu, law) : constitutive::radial_return(q, e, mu, law);
  const std::size_t terms = material_.kinematic.size();
  const std::span<Deviator> back(backstress_.data() + a * terms, terms);
  for (std::size_t term = 0; term < terms; ++term)
    back[term] = backstress(cell, term);
  return constitutive::kinematic_return(s0, q, e, mu, law, along_path ? 0.5 : 1.0, material_.kinematic, back);
}

void Body::integrate(Integration integration)
{
  if (!is_plastic())
    return;
  if (work_.empty())
    work_ = half_space_->make_work();
  const std::size_t n = grid().size();
  std::visit(
      [&](const auto& law)
      {
#pragma omp parallel for schedule(static)
        for (std::size_t a = 0; a < active_.size(); ++a)
        {
          const std::size_t cell = active_[a];
          const constitutive::PlasticIncrement result = increment(law_of(law, layer_of(cell)), a, integration);
          store(load(state_.plastic_strain, n, cell) + result.strain, strain_, n, cell);
          equivalent_[a] = result.equivalent;
          dissipation_[a] = result.dissipation;
        }
      },
      *material_.hardening);
  half_space_->load_strain(strain_, layers_, work_, displacement_);
}

bool Body::update(std::span<const double> pressure)
{
  if (!is_plastic())
    return false;
  const std::size_t n = grid().size();
  half_space_->deviatoric_stress(pressure, strain_, work_, stress_);
  add_initial_stress(layers_, stress_);
  std::visit(
      [&](const auto& law)
      {
#pragma omp parallel for schedule(static)
        for (std::size_t a = 0; a < active_.size(); ++a)
        {
          const std::size_t cell = active_[a];
          const Deviator increment = load(strain_, n, cell) - load(state_.plastic_strain, n, cell);
          const Deviator g = load(stress_, n, cell) + stiffness_ * increment;
          store_packed(g, g_, a);
          // A cell that stays elastic has no say in the others: it must not weigh in the acceleration either.
          if (equivalent_[a] == 0.0 &&
              von_mises(g - centre(cell)) <= law_of(law, layer_of(cell)).yield_stress_at(state_.equivalent[cell]))
            store_packed(g, q_, a);
        }
      },
      *material_.hardening);
  const std::size_t before = active_.size();
  collect_active(stress_, 1.0);
  const bool deeper = layers_ < grid().nz && needed_layers() > layers_ - 1;
  if (deeper)
    layers_ = std::min(grid().nz, layers_ + spare_layers);
  return deeper || active_.size() != before;
}

int Body::needed_layers() const
{
  const std::size_t n = grid().size();
  const std::size_t per_layer = grid().surface.size();
  return std::visit(
      [&](const auto& law)
      {
        for (int layer = layers_ - 1; layer >= 0; --layer)
          for (std::size_t cell = static_cast<std::size_t>(layer) * per_layer;
               cell < static_cast<std::size_t>(layer + 1) * per_layer; ++cell)
          {
            const Deviator s = load(stress_, n, cell) - centre(cell);
            const double limit =
                layer_share * law_of(law, static_cast<std::size_t>(layer)).yield_stress_at(state_.equivalent[cell]);
            if (is_active_[cell] != 0 || state_.equivalent[cell] > 0.0 || 1.5 * contract(s, s) > limit * limit)
              return layer + 1;
          }
        return 0;
      },
      *material_.hardening);
}

Body::EdgeStrain Body::edge_strain() const
{
  const SurfaceGrid& s = grid().surface;
  EdgeStrain edge;
  double largest = 0.0;
  for (int k = 0; k < grid().nz; ++k)
    for (int j = 0; j < s.ny; ++j)
      for (int i = 0; i < s.nx; ++i)
      {
        const double e = state_.equivalent[static_cast<std::size_t>(i + s.nx * (j + s.ny * k))];
        largest = std::max(largest, e);
        if (i == 0 || i == s.nx - 1)
          edge.ends = std::max(edge.ends, e);
        if (j == 0 || j == s.ny - 1)
          edge.sides = std::max(edge.sides, e);
        if (k == grid().nz - 1)
          edge.bottom = std::max(edge.bottom, e);
      }
  if (largest > 0.0)
    for (double* share : {&edge.ends, &edge.sides, &edge.bottom})
      *share /= largest;
  return edge;
}

double Body::yield_error() const
{
  double error = 0.0;
  if (!is_plastic())
    return error;
  std::visit(
      [&](const auto& law)
      {
        for (std::size_t a = 0; a < active_.size(); ++a)
        {
          const double yield =
              law_of(law, layer_of(active_[a])).yield_stress_at(state_.equivalent[active_[a]] + equivalent_[a]);
          const Deviator g = load_packed(g_, a);
          const double size = von_mises(g - centre(active_[a]));
          if (!std::isfinite(size))
            error = size;
          else if (equivalent_[a] > 0.0 || size > yield)
            error = std::max(error, von_mises(g - load_packed(q_, a)) / yield); // keeps a NaN found before
        }
      },
      *material_.hardening);
  return error;
}

double Body::locked_in_energy(std::span<const double> pressure) const
{
  // 1/2 eps H eps - s0 eps, with H eps = (stress of the pressure + initial stress s0 - stress); the first part by Betti
  // on the surface. The energy of s0 itself is left out: it is there from the start.
  const std::size_t n = grid().size();
  double volume_work = 0.0;
  for (std::size_t cell = 0; cell < n; ++cell)
  {
    const Deviator strain = load(strain_, n, cell);
    const double relieved =
        initial_stress_[cell / grid().surface.size()] * (strain[Deviator::xx] + strain[Deviator::yy]);
    volume_work += contract(load(stress_, n, cell), strain) + relieved;
  }
  double surface_work = 0.0;
  for (std::size_t i = 0; i < pressure.size(); ++i)
    surface_work += pressure[i] * displacement_[i];
  return 0.5 * (surface_work * grid().surface.cell_area() - volume_work * grid().cell_volume());
}

double Body::energy(std::span<const double> pressure) const
{
  if (!is_plastic())
    return 0.0;
  double dissipation = 0.0;
  for (const double d : dissipation_)
    dissipation += d;
  return dissipation * grid().cell_volume() + locked_in_energy(pressure);
}

void Body::commit(std::span<const double> pressure)
{
  if (!is_plastic())
    return;
  const std::size_t n = grid().size();
  for (std::size_t a = 0; a < active_.size(); ++a)
  {
    state_.equivalent[active_[a]] += equivalent_[a];
    state_.dissipation += dissipation_[a] * grid().cell_volume();
    if (equivalent_[a] > 0.0)
      for (std::size_t term = 0; term < material_.kinematic.size(); ++term)
        for (int c = 0; c < Deviator::size; ++c)
          state_.backstress[(term * Deviator::size + static_cast<std::size_t>(c)) * n + active_[a]] =
              backstress_[a * material_.kinematic.size() + term][c];
  }
  state_.plastic_strain = strain_;
  state_.stress = stress_;
  state_.residual_displacement = displacement_;
  state_.locked_in_energy = locked_in_energy(pressure);
  q_field_ = stress_;
  known_layers_ = layers_;
  layers_ = std::min(grid().nz, needed_layers() + spare_layers);
  for (std::size_t a = 0; a < active_.size(); ++a)
    store(load_packed(g_, a), q_field_, n, active_[a]);
}

} // namespace brinell::elastoplastic
