// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body.hpp"

#include "brinell/constitutive/kinematic_return.hpp"
#include "brinell/foundation/error.hpp"
#include "foundation/require_size.hpp"

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

/// Cells with more than this share of the yield stress take part in the fixed point from the start. A guess only: every
/// evaluation adds the cells that yield without having been thought of.
constexpr double active_share = 0.8;
/// Beneath the deepest active cell: cells that become active there do so at the next evaluation, not in the closing one.
constexpr int spare_layers = 1;

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
           const constitutive::Material& material, bool shortcuts, std::vector<double> texture)
    : grid_(grid), material_(material), half_space_(std::move(half_space)), texture_(std::move(texture)),
      shortcuts_(shortcuts), layers_(grid_.nz), displacement_(grid_.surface.size(), 0.0)
{
  if (!texture_.empty())
    require_size("Body: the texture", texture_, grid_.surface.size());
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
  const auto alike = [](double a, double b)
  { return std::abs(a - b) <= 1e-9 * (std::abs(a) + std::abs(b)); }; // rounding
  if (!std::equal(texture.begin(), texture.end(), texture_.begin(), texture_.end(), alike))
    throw InputError("the texture of a surface is not that of the stored state");
  if (!is_plastic())
    return;
  archive("state", state_);
  archive("q_field", q_field_);
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
  layers_ = grid().nz;
  // Seen from the contact, q changes little from step to step: it is carried along.
  collect_active(q_field_, shift, shortcuts_ ? active_share : -1.0);
  keep_active_layers();
}

void Body::restore()
{
  displacement_ = state_.residual_displacement;
}

void Body::compute_all_layers()
{
  layers_ = grid().nz;
}

void Body::keep_active_layers()
{
  const int deepest =
      active_.empty() ? 0 : static_cast<int>(layer_of(*std::max_element(active_.begin(), active_.end())));
  layers_ = shortcuts_ ? std::min(grid().nz, deepest + 1 + spare_layers) : grid().nz;
}

namespace
{

/// Squares of the von Mises norms of `cells` cells of a deviator field, 3/2 s : s.
void von_mises_squares(const double* field, std::size_t stride, std::size_t cells, double* squares)
{
  using D = Deviator;
  const double* xx = field + D::xx * stride;
  const double* yy = field + D::yy * stride;
  const double* yz = field + D::yz * stride;
  const double* xz = field + D::xz * stride;
  const double* xy = field + D::xy * stride;
#pragma omp simd
  for (std::size_t i = 0; i < cells; ++i)
    squares[i] = 3.0 * (xx[i] * xx[i] + yy[i] * yy[i] + xx[i] * yy[i] + yz[i] * yz[i] + xz[i] * xz[i] + xy[i] * xy[i]);
}

} // namespace

/// Cells of one layer, not yet active, whose q lies outside the yield surface shrunk to `fraction`.
template <typename Law>
void Body::find_beyond(const Law& law, std::size_t layer, const std::vector<double>& q_field, int shift,
                       double fraction, std::vector<std::size_t>& found) const
{
  const SurfaceGrid& s = grid().surface;
  const std::size_t n = grid().size();
  const auto first = static_cast<std::size_t>(std::max(0, shift));
  const auto last = static_cast<std::size_t>(std::max(0, std::min(s.nx, s.nx + shift)));
  if (last <= first)
    return;
  const auto square = [](double value) { return value < 0.0 ? -1.0 : value * value; };
  // No law softens: what lies within the first yield surface needs no look at its own, unless that has moved.
  const double initial = square(fraction * law.yield_stress_at(0.0));
  std::vector<double> squares(last - first);
  for (std::size_t j = 0; j < static_cast<std::size_t>(s.ny); ++j)
  {
    const std::size_t row = layer * s.size() + j * static_cast<std::size_t>(s.nx);
    const std::ptrdiff_t carried = static_cast<std::ptrdiff_t>(row + first) - shift;
    von_mises_squares(q_field.data() + carried, n, last - first, squares.data());
    for (std::size_t i = first; i < last; ++i)
    {
      const std::size_t cell = row + i;
      const double e = state_.equivalent[cell];
      const bool has_moved = e > 0.0 && !material_.kinematic.empty();
      if (is_active_[cell] != 0 || (!has_moved && squares[i - first] <= initial))
        continue;
      double size = squares[i - first];
      if (has_moved)
      {
        const Deviator from_centre =
            load(q_field, n, static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) - shift)) - centre(cell);
        size = 1.5 * contract(from_centre, from_centre);
      }
      if (size > square(fraction * law.yield_stress_at(e)))
        found.push_back(cell);
    }
  }
}

/// @param q_field   on the whole grid, to be read `shift` columns to the left of a cell; cells without a value there stay out
/// @param fraction  of the yield stress from which on a cell is active; negative: every cell
void Body::collect_active(const std::vector<double>& q_field, int shift, double fraction)
{
  const std::size_t n = grid().size();
  std::vector<std::vector<std::size_t>> found(static_cast<std::size_t>(layers_));
  std::visit(
      [&](const auto& law)
      {
#pragma omp parallel for schedule(dynamic)
        for (std::size_t layer = 0; layer < found.size(); ++layer)
          find_beyond(law_of(law, layer), layer, q_field, shift, fraction, found[layer]);
      },
      *material_.hardening);
  for (const std::vector<std::size_t>& cells : found) // in an order that does not depend on the threads
    for (const std::size_t cell : cells)
    {
      const Deviator q = load(q_field, n, static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) - shift));
      is_active_[cell] = 1;
      active_.push_back(cell);
      q_.insert(q_.end(), q.v.begin(), q.v.end());
      g_.insert(g_.end(), q.v.begin(), q.v.end());
    }
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
  const bool along_path = integration == Integration::path;
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
  collect_active(stress_, 0, 1.0);
  if (active_.size() == before)
    return false;
  keep_active_layers();
  return true;
}

Edges Body::reached_edges() const
{
  // Less than this plastic strain at an edge, over the largest one, goes on beyond it for a cell or two at most; and strains
  // far below that of yield change nothing.
  constexpr double tolerated = 0.01;
  constexpr double negligible = 1e-3;
  Edges edges;
  if (!is_plastic())
    return edges;
  double largest = *std::max_element(state_.equivalent.begin(), state_.equivalent.end());
  for (std::size_t a = 0; a < active_.size(); ++a)
    largest = std::max(largest, state_.equivalent[active_[a]] + equivalent_[a]);
  const double limit =
      std::max(tolerated * largest,
               negligible * constitutive::initial_yield_stress(*material_.hardening) / material_.elastic.young_modulus);
  const SurfaceGrid& s = grid().surface;
  for (std::size_t a = 0; a < active_.size(); ++a)
  {
    const std::size_t cell = active_[a];
    if (equivalent_[a] <= 0.0 || state_.equivalent[cell] + equivalent_[a] <= limit)
      continue;
    const std::size_t in_layer = cell % s.size();
    const int i = static_cast<int>(in_layer % static_cast<std::size_t>(s.nx));
    const int j = static_cast<int>(in_layer / static_cast<std::size_t>(s.nx));
    edges.ends = edges.ends || i == 0 || i == s.nx - 1;
    edges.sides = edges.sides || j == 0 || j == s.ny - 1;
    edges.bottom = edges.bottom || static_cast<int>(layer_of(cell)) == grid().nz - 1;
  }
  edges.bottom = edges.bottom || may_yield_beneath();
  return edges;
}

/// Whether a layer beneath the grid is so weak that it would yield under the stress of the last one. Beneath the grid, which
/// is deeper than the place of the largest shear, the stress of the contact falls with depth.
bool Body::may_yield_beneath() const
{
  const std::size_t n = grid().size();
  const auto last = static_cast<std::size_t>(grid().nz - 1);
  double weakest = yield_factor_[last];
  double added = 0.0; // initial stress beneath, beyond that in the last layer [Pa]
  const double bottom = grid().nz * grid().dz;
  for (const double z : material_.yield_factor.depth())
    if (z > bottom)
      weakest = std::min(weakest, material_.yield_factor.at(z, 1.0));
  for (const double z : material_.initial_stress.depth())
    if (z > bottom)
      added = std::max(added, std::abs(material_.initial_stress.at(z, 0.0) - initial_stress_[last]));
  if (weakest >= yield_factor_[last] && added == 0.0)
    return false; // the last layer is the first to yield
  const double limit = weakest * constitutive::initial_yield_stress(*material_.hardening) - added;
  for (std::size_t cell = last * grid().surface.size(); cell < n; ++cell)
    if (von_mises(load(stress_, n, cell) - centre(cell)) > limit)
      return true;
  return false;
}

namespace
{

/// Copies fields of a grid into the middle of larger ones, from the surface down.
void embed(const std::vector<double>& from, const VolumeGrid& small, std::vector<double>& to, const VolumeGrid& large)
{
  const SurfaceGrid& s = small.surface;
  const SurfaceGrid& l = large.surface;
  const int columns = (l.nx - s.nx) / 2;
  const int rows = (l.ny - s.ny) / 2;
  const std::size_t fields = from.size() / small.size();
  for (std::size_t field = 0; field < fields; ++field)
    for (int k = 0; k < small.nz; ++k)
      for (int j = 0; j < s.ny; ++j)
      {
        const double* row = from.data() + field * small.size() +
                            static_cast<std::size_t>(s.nx) * static_cast<std::size_t>(j + s.ny * k);
        const std::size_t at = field * large.size() +
                               static_cast<std::size_t>(l.nx) * static_cast<std::size_t>(j + rows + l.ny * k) +
                               static_cast<std::size_t>(columns);
        std::copy_n(row, s.nx, to.begin() + static_cast<std::ptrdiff_t>(at));
      }
}

} // namespace

void Body::continue_from(const BodyState& history, const VolumeGrid& from, std::span<const double> pressure)
{
  if (!is_plastic())
    return;
  embed(history.plastic_strain, from, state_.plastic_strain, grid());
  embed(history.equivalent, from, state_.equivalent, grid());
  embed(history.backstress, from, state_.backstress, grid());
  state_.dissipation = history.dissipation;
  strain_ = state_.plastic_strain;
  work_ = half_space_->make_work();
  half_space_->load_strain(strain_, grid().nz, work_, displacement_);
  half_space_->deviatoric_stress(pressure, strain_, work_, stress_);
  add_initial_stress(grid().nz, stress_);
  state_.stress = stress_;
  state_.residual_displacement = displacement_;
  state_.locked_in_energy = locked_in_energy(pressure);
  q_field_ = stress_;
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
  for (std::size_t a = 0; a < active_.size(); ++a)
    store(load_packed(g_, a), q_field_, n, active_[a]);
}

} // namespace brinell::elastoplastic
