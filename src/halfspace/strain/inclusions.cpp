// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/inclusions.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "cell_means.hpp"
#include "foundation/minres.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <utility>

namespace brinell::halfspace
{

namespace
{

double bulk_modulus(const Elastic& elastic)
{
  return elastic.young_modulus / (3.0 * (1.0 - 2.0 * elastic.poisson_ratio));
}

/// (a - b)/(a + b) of two moduli, of which `b` may be zero or infinite.
double contrast(double body, double inclusion)
{
  return std::isinf(inclusion) ? -1.0 : (body - inclusion) / (body + inclusion);
}

void require_allowed(const Elastic& elastic, std::size_t number)
{
  if (!(elastic.young_modulus >= 0.0))
    throw InputError(fmt::format("inclusion {}: Young's modulus {:g} Pa; allowed: 0 (a void) or more", number + 1,
                                 elastic.young_modulus));
  if (!(elastic.poisson_ratio > -1.0 && elastic.poisson_ratio < 0.5))
    throw InputError(
        fmt::format("inclusion {}: Poisson's ratio {:g}; allowed: -1 < nu < 0.5", number + 1, elastic.poisson_ratio));
}

bool are_mirror_images(const Inclusion& a, const Inclusion& b)
{
  return a.elastic == b.elastic && a.own.dilatation == b.own.dilatation &&
         a.own.deviator == mirrored_in_y(b.own.deviator);
}

/// Number of the inclusion that each cell belongs to.
std::map<std::size_t, std::size_t> owners(const VolumeGrid& grid, const std::vector<Inclusion>& inclusions)
{
  std::map<std::size_t, std::size_t> owner;
  for (std::size_t number = 0; number < inclusions.size(); ++number)
  {
    require_allowed(inclusions[number].elastic, number);
    for (const std::size_t cell : inclusions[number].cells)
    {
      if (cell >= grid.size())
        throw InputError(fmt::format("inclusion {}: cell {}; allowed: below {}, the cells of the grid", number + 1,
                                     cell, grid.size()));
      const auto [found, is_new] = owner.emplace(cell, number);
      if (!is_new && found->second != number)
        throw InputError(fmt::format("inclusions {} and {} overlap in cell {}; allowed: inclusions that share no cell",
                                     found->second + 1, number + 1, cell));
    }
  }
  return owner;
}

} // namespace

struct Inclusions::Parts
{
  const HalfSpace& body;
  std::vector<std::size_t> cells;
  std::vector<double> copies;              ///< of each cell, itself included
  std::vector<double> in_shear, in_volume; ///< contrasts B
  InclusionField own;
  double root_shear, root_volume; ///< roots of 2 mu_0 and 9 K_0
  int layers = 0;
  HalfSpace::Work work;
  HalfSpace::DilatationWork dilatation_work;
  std::vector<double> strain, dilatation, deviator, trace; ///< fields of the body
  std::vector<double> plane;                               ///< of one layer

  Parts(const HalfSpace& of, const std::vector<Inclusion>& inclusions);
  [[nodiscard]] std::size_t size() const { return cells.size(); }
  [[nodiscard]] bool is_mirrored() const { return body.grid().surface.is_mirrored_y; }
  void scatter(const InclusionField& equivalent);
  void spread(const InclusionField& equivalent);
  void to_cell_means(std::vector<double>& field);
  void find_means(const HalfSpace::Loaded& loaded, int computed);
  void complete(std::vector<double>& deviators, std::vector<double>& traces) const;
  [[nodiscard]] InclusionField sharp_stress(const InclusionField& equivalent);
  void add_sharp(const InclusionField& sharp);
  void gather(std::span<const double> all_deviators, std::span<const double> traces, InclusionField& out) const;
  void stress(const InclusionField& equivalent, InclusionField& out);
  /// Scalar product of vectors of the unknown, [component or volume][cell].
  [[nodiscard]] double dot(std::span<const double> a, std::span<const double> b) const;
  [[nodiscard]] double contrast_of(std::size_t component, std::size_t cell) const
  {
    return component < Deviator::size ? in_shear[cell] : in_volume[cell];
  }
  /// The strain sqrt|B| w in units of the root of the stiffness, as a strain.
  void to_strain(std::span<const double> w, InclusionField& out) const;
};

Inclusions::Parts::Parts(const HalfSpace& of, const std::vector<Inclusion>& inclusions)
    : body(of), root_shear(std::sqrt(2.0 * of.elastic().shear_modulus())),
      root_volume(std::sqrt(9.0 * bulk_modulus(of.elastic()))), work(of.make_work()),
      dilatation_work(of.make_dilatation_work()), strain(Deviator::size * of.grid().size()),
      dilatation(of.grid().size()), deviator(strain.size()), trace(dilatation.size())
{
  const SurfaceGrid& s = body.grid().surface;
  const auto owner = owners(body.grid(), inclusions);
  const double mu = body.elastic().shear_modulus(), k = bulk_modulus(body.elastic());
  for (auto* list : {&copies, &in_shear, &in_volume})
    list->reserve(owner.size());
  cells.reserve(owner.size());
  for (const auto& [cell, number] : owner)
  {
    const int row = static_cast<int>(cell / static_cast<std::size_t>(s.nx)) % s.ny;
    if (s.is_mirrored_y)
    {
      const auto other = owner.find(mirrored_cell(s, cell));
      if (other == owner.end() || !are_mirror_images(inclusions[other->second], inclusions[number]))
        throw InputError(fmt::format("inclusion {}: cell {} has no mirror image in y; allowed on a mirrored grid: "
                                     "inclusions that are symmetric",
                                     number + 1, cell));
      if (row >= s.independent_rows())
        continue;
    }
    const Elastic& elastic = inclusions[number].elastic;
    cells.push_back(cell);
    copies.push_back(s.copies_of_row(row));
    in_shear.push_back(contrast(mu, elastic.shear_modulus()));
    in_volume.push_back(contrast(k, bulk_modulus(elastic)));
    layers = std::max(layers, static_cast<int>(cell / s.size()) + 1);
  }
  own = {std::vector<double>(Deviator::size * size()), std::vector<double>(size())};
  for (std::size_t i = 0; i < size(); ++i)
  {
    const Inclusion& inclusion = inclusions[owner.at(cells[i])];
    store(inclusion.own.deviator, own.deviator, size(), i);
    own.volumetric[i] = inclusion.own.dilatation;
  }
}

void Inclusions::Parts::scatter(const InclusionField& equivalent)
{
  const std::size_t all = body.grid().size();
  std::fill(strain.begin(), strain.end(), 0.0); // means over cells have left something beside the inclusions
  std::fill(dilatation.begin(), dilatation.end(), 0.0);
  const auto put = [&](std::size_t at, std::size_t cell, const Deviator& d)
  {
    for (int c = 0; c < Deviator::size; ++c)
      strain[static_cast<std::size_t>(c) * all + cell] = d[c];
    dilatation[cell] = equivalent.volumetric[at];
  };
  for (std::size_t i = 0; i < size(); ++i)
  {
    const Deviator d = deviator_at(equivalent.deviator, size(), i);
    put(i, cells[i], d);
    if (copies[i] == 2.0)
      put(i, mirrored_cell(body.grid().surface, cells[i]), mirrored_in_y(d));
  }
}

void Inclusions::Parts::gather(std::span<const double> all_deviators, std::span<const double> traces,
                               InclusionField& out) const
{
  const std::size_t all = body.grid().size();
  for (std::size_t i = 0; i < size(); ++i)
  {
    store(deviator_at(all_deviators, all, cells[i]), out.deviator, size(), i);
    out.volumetric[i] = traces[cells[i]];
  }
}

/// The strain in each cell as a field of the body.
void Inclusions::Parts::spread(const InclusionField& equivalent)
{
  scatter(equivalent);
  to_cell_means(strain);
  to_cell_means(dilatation);
}

/// The means of a field over the cells, in the layers of the inclusions.
void Inclusions::Parts::to_cell_means(std::vector<double>& field)
{
  const SurfaceGrid& s = body.grid().surface;
  const std::size_t all = body.grid().size(), used = static_cast<std::size_t>(layers) * s.size();
  for (std::size_t first = 0; first < field.size(); first += all)
    for (std::size_t layer = first; layer < first + used; layer += s.size())
      mean_over_cells(s, field.data() + layer, plane);
}

/// Stress of the strain that has been spread, as means over the cells: to `deviator` and `trace`.
void Inclusions::Parts::find_means(const HalfSpace::Loaded& loaded, int computed)
{
  loaded.stress({}, deviator);
  loaded.traces({}, trace);
  body.add_dilatation(dilatation, computed, dilatation_work, {deviator, trace, {}});
  complete(deviator, trace);
  to_cell_means(deviator);
  to_cell_means(trace);
}

/// On a mirrored grid, writes the rows that are mirror images of others.
void Inclusions::Parts::complete(std::vector<double>& deviators, std::vector<double>& traces) const
{
  if (!is_mirrored())
    return;
  complete_in_y(body.grid(), deviators);
  complete_in_y(body.grid().surface, 1.0, traces.data(), traces.size());
}

/// Part of the means of the stress over the cells that waves shorter than the cells contribute: the means leave these out. It is minus the
/// stiffness, the mean of all directions, times the strain less what is left of it. Uses the strain that has been spread.
InclusionField Inclusions::Parts::sharp_stress(const InclusionField& equivalent)
{
  to_cell_means(strain);
  to_cell_means(dilatation);
  const std::size_t all = body.grid().size();
  const double nu = body.elastic().poisson_ratio;
  const double shear = root_shear * root_shear * (1.0 - 2.0 * (4.0 - 5.0 * nu) / (15.0 * (1.0 - nu)));
  const double volume = root_volume * root_volume * (1.0 - (1.0 + nu) / (3.0 * (1.0 - nu)));
  InclusionField sharp{std::vector<double>(Deviator::size * size()), std::vector<double>(size())};
  for (std::size_t i = 0; i < size(); ++i)
  {
    for (std::size_t c = 0; c < Deviator::size; ++c)
      sharp.deviator[c * size() + i] = -shear * (equivalent.deviator[c * size() + i] - strain[c * all + cells[i]]);
    sharp.volumetric[i] = -volume * (equivalent.volumetric[i] - dilatation[cells[i]]);
  }
  return sharp;
}

void Inclusions::Parts::stress(const InclusionField& equivalent, InclusionField& out)
{
  spread(equivalent);
  find_means(body.load(strain, layers, work, Displacements::normal, true), layers);
  gather(deviator, trace, out);
  InclusionField sharp = sharp_stress(equivalent);
  for (std::size_t i = 0; i < sharp.deviator.size(); ++i)
    out.deviator[i] += sharp.deviator[i];
  for (std::size_t i = 0; i < sharp.volumetric.size(); ++i)
    out.volumetric[i] += sharp.volumetric[i];
}

/// Adds it to the independent rows of the fields of the body.
void Inclusions::Parts::add_sharp(const InclusionField& sharp)
{
  for (std::size_t i = 0; i < size(); ++i)
  {
    for (std::size_t c = 0; c < Deviator::size; ++c)
      deviator[c * body.grid().size() + cells[i]] += sharp.deviator[c * size() + i];
    trace[cells[i]] += sharp.volumetric[i];
  }
}

double Inclusions::Parts::dot(std::span<const double> a, std::span<const double> b) const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < size(); ++i)
    sum += copies[i] * (contract(deviator_at(a, size(), i), deviator_at(b, size(), i)) +
                        a[Deviator::size * size() + i] * b[Deviator::size * size() + i]);
  return sum;
}

void Inclusions::Parts::to_strain(std::span<const double> w, InclusionField& out) const
{
  for (std::size_t c = 0; c <= Deviator::size; ++c)
    for (std::size_t i = 0; i < size(); ++i)
    {
      const double strain_of_cell = std::sqrt(std::abs(contrast_of(c, i))) * w[c * size() + i];
      if (c < Deviator::size)
        out.deviator[c * size() + i] = strain_of_cell / root_shear;
      else
        out.volumetric[i] = strain_of_cell / root_volume;
    }
}

Inclusions::Inclusions(const HalfSpace& body, const std::vector<Inclusion>& inclusions)
    : parts_(std::make_unique<Parts>(body, inclusions))
{
}
Inclusions::~Inclusions() = default;
Inclusions::Inclusions(Inclusions&&) noexcept = default;
Inclusions& Inclusions::operator=(Inclusions&&) noexcept = default;

const std::vector<std::size_t>& Inclusions::cells() const
{
  return parts_->cells;
}

int Inclusions::layers() const
{
  return parts_->layers;
}

InclusionField Inclusions::make_field() const
{
  return {std::vector<double>(Deviator::size * parts_->size()), std::vector<double>(parts_->size())};
}

const InclusionField& Inclusions::own_strain() const
{
  return parts_->own;
}

bool Inclusions::has_own_strain() const
{
  const auto acts = [](double strain) { return strain != 0.0; };
  return std::any_of(parts_->own.deviator.begin(), parts_->own.deviator.end(), acts) ||
         std::any_of(parts_->own.volumetric.begin(), parts_->own.volumetric.end(), acts);
}

void Inclusions::stress(const InclusionField& equivalent, InclusionField& out)
{
  parts_->stress(equivalent, out);
}

void Inclusions::gather(std::span<const double> deviator, std::span<const double> trace, InclusionField& out)
{
  Parts& p = *parts_;
  p.deviator.assign(deviator.begin(), deviator.end());
  p.trace.assign(trace.begin(), trace.end());
  p.complete(p.deviator, p.trace);
  p.to_cell_means(p.deviator);
  p.to_cell_means(p.trace);
  p.gather(p.deviator, p.trace, out);
}

double Inclusions::work(const InclusionField& stress, const InclusionField& strain) const
{
  const Parts& p = *parts_;
  double sum = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i)
    sum +=
        p.copies[i] * (contract(deviator_at(stress.deviator, p.size(), i), deviator_at(strain.deviator, p.size(), i)) +
                       stress.volumetric[i] * strain.volumetric[i]);
  return sum * p.body.grid().cell_volume();
}

Inclusions::Report Inclusions::solve(const InclusionField& stress, InclusionField& equivalent, double tolerance,
                                     int most_iterations)
{
  Parts& p = *parts_;
  const std::size_t n = p.size(), all = (Deviator::size + 1) * n;
  InclusionField strain = make_field(), caused = make_field();
  const auto root_of = [&](std::size_t c, std::size_t i) { return std::sqrt(std::abs(p.contrast_of(c, i))); };
  const auto scaled_stress = [&](const InclusionField& of, std::size_t c, std::size_t i)
  { return c < Deviator::size ? of.deviator[c * n + i] / p.root_shear : of.volumetric[i] / p.root_volume; };
  const auto apply = [&](std::span<const double> w, std::span<double> out)
  {
    p.to_strain(w, strain);
    p.stress(strain, caused);
    for (std::size_t c = 0; c <= Deviator::size; ++c)
      for (std::size_t i = 0; i < n; ++i)
      {
        const double b = p.contrast_of(c, i), root = root_of(c, i);
        const double reflected = root * w[c * n + i] + 2.0 * scaled_stress(caused, c, i); // R sqrt|B| w
        out[c * n + i] = (b < 0.0 ? -1.0 : 1.0) * w[c * n + i] - root * reflected;
      }
  };
  std::vector<double> right(all), w(all);
  for (std::size_t c = 0; c <= Deviator::size; ++c)
    for (std::size_t i = 0; i < n; ++i)
    {
      const double root = root_of(c, i);
      right[c * n + i] = 2.0 * root * scaled_stress(stress, c, i);
      const double guess =
          c < Deviator::size ? equivalent.deviator[c * n + i] * p.root_shear : equivalent.volumetric[i] * p.root_volume;
      w[c * n + i] = root > 0.0 ? guess / root : 0.0;
    }
  const auto dot = [&](std::span<const double> a, std::span<const double> b) { return p.dot(a, b); };
  const MinresReport report = minres(apply, dot, right, w, tolerance, most_iterations);
  p.to_strain(w, equivalent);
  return {report.iterations, report.residual};
}

void Inclusions::add(const InclusionField& equivalent, int layers, const HalfSpace::Dilated& to)
{
  Parts& p = *parts_;
  const HalfSpace& body = p.body;
  p.spread(equivalent);
  const bool has_shear = !to.displacement.x.empty() || !to.displacement.y.empty();
  const bool wants_stress = !to.deviator.empty() || !to.trace.empty();
  const int computed = wants_stress ? layers : 0;
  const HalfSpace::Loaded loaded =
      body.load(p.strain, computed, p.work, has_shear ? Displacements::all : Displacements::normal, !to.trace.empty());
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
  const std::size_t of_layers = static_cast<std::size_t>(computed) * body.grid().surface.size();
  if (wants_stress)
    loaded.stress({}, p.deviator); // also before the trace, which is that of the last load
  if (!to.trace.empty())
    loaded.traces({}, p.trace);
  const bool wants_trace = !to.trace.empty();
  body.add_dilatation(p.dilatation, computed, p.dilatation_work,
                      {wants_stress ? std::span<double>(p.deviator) : std::span<double>(),
                       wants_trace ? std::span<double>(p.trace) : std::span<double>(), to.displacement});
  if (!wants_stress)
    return;
  p.add_sharp(p.sharp_stress(equivalent));
  p.complete(p.deviator, p.trace);
  for (std::size_t c = 0; c < Deviator::size && !to.deviator.empty(); ++c)
    for (std::size_t i = c * body.grid().size(); i < c * body.grid().size() + of_layers; ++i)
      to.deviator[i] += p.deviator[i];
  for (std::size_t i = 0; i < of_layers && wants_trace; ++i)
    to.trace[i] += p.trace[i];
}

} // namespace brinell::halfspace
