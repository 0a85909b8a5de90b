// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body.hpp"

#include "body_parts.hpp"
#include "brinell/foundation/embedding.hpp"
#include "brinell/foundation/error.hpp"
#include "foundation/require_size.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

/// An increment of a body, from its beginning to its end.
namespace brinell::elastoplastic
{

namespace
{

/// Cells above this share of the yield stress are active from the start. This is only a guess: every evaluation adds further
/// cells that yield.
constexpr double active_share = 0.8;

/// Assigns laws and factors to the layers of cells.
void assign_laws(BodyParts& b)
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  const constitutive::Material& material = b.yield.material;
  for (const std::optional<constitutive::HardeningLaw>& law : material.laws())
    b.yield.laws.push_back(law.value_or(constitutive::PerfectPlasticity{inf}));
  const ElasticStack stack = material.stack();
  for (int layer = 0; layer < b.grid.nz; ++layer)
  {
    const double depth = (b.share.layer(layer) + 0.5) * b.grid.dz;
    b.yield.factor.push_back(material.yield_factor.at(depth, 1.0));
    b.yield.law_of.push_back(stack.layer_at(depth));
  }
}

/// Allocates the trial on first use: a body that is rigid or stays elastic never needs one.
void prepare_trial(BodyParts& b)
{
  if (!b.trial.stress.empty())
    return;
  b.trial.stress = b.state.stress;
  b.trial.active = ActiveCells(b.grid.size(), b.yield.material.kinematic.size());
}

/// Factor on the yield stress far from all heat, at the bulk temperature.
double softening_far_away(const constitutive::Material& material)
{
  return material.softening ? constitutive::softening_factor(*material.softening, material.temperature) : 1.0;
}

bool have_own_strength(const std::vector<Inclusion>& inclusions)
{
  return std::ranges::any_of(inclusions, [](const Inclusion& one) { return one.yield_factor != 1.0; });
}

/// Factors on the yield stress of the cells by the inclusions; empty if all are 1.
std::vector<double> strength_of(const std::vector<Inclusion>& inclusions, std::size_t cells)
{
  if (!have_own_strength(inclusions))
    return {};
  std::vector<double> factor(cells, 1.0);
  for (const Inclusion& inclusion : inclusions)
  {
    if (!(inclusion.yield_factor > 0.0 && std::isfinite(inclusion.yield_factor)))
      throw InputError(fmt::format("the factor on the yield stress of an inclusion is {:g}; allowed: above 0",
                                   inclusion.yield_factor));
    for (const std::size_t cell : inclusion.cells)
      factor[cell] = inclusion.yield_factor;
  }
  return factor;
}

/// Numbers per cell of a field; some ranks may have no layers.
std::size_t numbers_of_cell(const BodyParts& b, const std::vector<double>& own_field)
{
  const std::size_t own = b.grid.size() > 0 ? own_field.size() / b.grid.size() : 0;
  return static_cast<std::size_t>(b.ranks->largest(static_cast<double>(own)));
}

/// Numbers that each rank has of a layer.
std::vector<std::size_t> counts_of_layer(const BodyParts& b, int layer)
{
  std::vector<std::size_t> counts(static_cast<std::size_t>(b.ranks->size()));
  counts[static_cast<std::size_t>(b.share.layers().owner(layer))] = b.grid.surface.size();
  return counts;
}

/// Passes the fields of all layers one by one, so that as many or as few ranks as there are can continue the history, and none needs
/// memory for all of them.
void exchange_field(Archive& archive, const BodyParts& b, const std::string& name, std::vector<double>& own_field,
                    std::size_t numbers)
{
  const std::size_t plane = b.grid.surface.size();
  const auto pass = [&](std::size_t first, std::span<double> values)
  {
    const auto layer = static_cast<int>(first % b.whole.size() / plane);
    const auto own = [&]
    {
      const std::size_t component = first / b.whole.size();
      return std::span(own_field).subspan(component * b.grid.size() + b.grid.index(0, 0, b.share.place(layer)), plane);
    };
    if (!archive.gives())
      b.ranks->gather(b.share.has(layer) ? own() : std::span<double>{}, counts_of_layer(b, layer), values);
    else if (b.share.has(layer))
      std::ranges::copy(values, own().begin());
  };
  archive.parts(name, numbers * b.whole.size(), plane, pass);
}

/// Counterpart of exchange_field for a field that may be empty, as `Archive::list` passes it.
void exchange_list(Archive& archive, const BodyParts& b, const std::string& name, std::vector<double>& own_field)
{
  std::size_t size = archive.gives() ? 0 : numbers_of_cell(b, own_field) * b.whole.size();
  archive(name + ".size", size, 0, std::numeric_limits<std::size_t>::max());
  const std::size_t numbers = size / b.whole.size();
  if (archive.gives())
    own_field.resize(numbers * b.grid.size());
  if (numbers > 0)
    exchange_field(archive, b, name, own_field, numbers);
}

/// State of a body that ranks share, as `exchange_members` passes that of a body alone.
void exchange_shared(Archive& archive, BodyParts& b)
{
  struct State
  {
    BodyParts& b;
    void exchange(Archive& archive)
    {
      for_parts(
          [&]<typename Part>(std::string_view part, const Traits& traits, Part& value)
          {
            const std::string name(part);
            if constexpr (std::is_same_v<Part, std::vector<double>>)
            {
              if (traits.is_sized)
                exchange_list(archive, b, name, value);
              else if (!value.empty() && name.starts_with("residual_displacement"))
                archive(name, value);
              else if (const std::size_t numbers = numbers_of_cell(b, value); numbers > 0)
                exchange_field(archive, b, name, value, numbers);
            }
            else
              archive(name, value);
          },
          b.state);
    }
  };
  State state{b};
  archive("state", state);
  exchange_field(archive, b, "q_field", b.trial.stress, numbers_of_cell(b, b.trial.stress));
}

/// Drops what belongs to the trial alone.
void return_to_state(BodyParts& b)
{
  b.evaluation->restore(b.state);
  b.trial.has_thermal_stress = false;
  b.yield.softening = b.state.softening;
  b.device.is_softening_known = b.device.is_thermal_stress_known = false;
}

} // namespace

Body::Body(const VolumeGrid& grid, std::shared_ptr<const halfspace::HalfSpace> half_space,
           const constitutive::Material& material, const BodySettings& settings)
    : parts_{.grid = half_space ? half_space->own_grid() : grid,
             .whole = grid,
             .ranks = half_space ? half_space->shared_ranks() : std::make_shared<const Communicator>(),
             .share = half_space ? half_space->share() : Share(),
             .settings = settings,
             .yield = {material, grid.surface.size()},
             .evaluation = make_hidden<Evaluation>(grid, std::move(half_space), material, settings)}
{
  BodyParts& b = parts_;
  const std::size_t n = b.grid.size();
  if (has_inclusions() && !material.is_plastic())
    throw InputError("a body with inclusions cannot yield; allowed: a body with a hardening law");
  if (!material.elastic.is_rigid())
  {
    b.state.plastic_strain.assign(Deviator::size * n, 0.0);
    b.state.equivalent.assign(n, 0.0);
  }
  b.state.backstress.assign(material.kinematic.size() * Deviator::size * n, 0.0);
  b.evaluation->store(b.state);
  if (!b.is_plastic())
    return;
  assign_laws(b);
  b.state.softening = b.yield.softening = strength_of(settings.inclusions, n);
  b.trial.stiffness.assign(static_cast<std::size_t>(b.grid.nz), 0.0);
  b.zone = PlasticZone(b.grid, b.state.equivalent);
  b.state.stress.assign(Deviator::size * n, 0.0);
  std::ranges::copy(b.evaluation->own_stress(), b.state.stress.begin());
  b.evaluation->initial_stress().add_to(b.state.stress, b.grid.nz, grid.surface.ny);
  if (settings.device)
    put_on_device(b);
}

void Body::exchange(Archive& archive)
{
  BodyParts& b = parts_;
  if (!b.is_plastic())
    return;
  prepare_trial(b);
  if (b.share.is_all())
  {
    archive("state", b.state);
    archive("q_field", b.trial.stress);
  }
  else
    exchange_shared(archive, b);
  b.evaluation->exchange(archive);
  if (!archive.gives())
    return;
  return_to_state(b);
  b.device.knows_state = b.device.must_commit = false;
  b.zone = PlasticZone(b.grid, b.state.equivalent);
  recover_guess(b);
}

void Body::continue_from(const BodyState& history, const VolumeGrid& from, const halfspace::SurfaceLoad& load)
{
  BodyParts& b = parts_;
  if (!b.is_plastic())
    return;
  std::vector<double> of_inclusions = strength_of(b.settings.inclusions, b.grid.size());
  b.state.softening.assign(history.softening.empty() ? 0 : b.grid.size(), softening_far_away(b.yield.material));
  embed_state(VolumeGrid{from.surface, b.share.count(from.nz), from.dz}, history, b.grid, b.state);
  if (!of_inclusions.empty())
    b.state.softening = std::move(of_inclusions);
  b.zone = PlasticZone(b.grid, b.state.equivalent);
  b.yield.softening = b.state.softening;
  b.device.knows_state = b.device.must_commit = b.device.is_softening_known = b.device.is_thermal_stress_known = false;
  prepare_trial(b);
  b.evaluation->compute_anew(b.state, load, b.trial.stress);
  complete_stress(b);
  b.state.stress = b.trial.stress;
  b.evaluation->store(b.state);
  b.state.locked_in_energy = locked_in_energy(b, load, b.zone);
  recover_guess(b);
}

std::vector<double> Body::inclusion_numbers() const
{
  std::vector<double> numbers(parts_.grid.size(), 0.0);
  for (const Inclusion& inclusion : parts_.settings.inclusions)
    for (const std::size_t cell : inclusion.cells)
      numbers[cell] = inclusion.number;
  return numbers;
}

halfspace::Inclusions::Report Body::inclusion_report() const
{
  return parts_.evaluation->inclusion_report();
}

void Body::set_softening(std::span<const double> factor)
{
  BodyParts& b = parts_;
  if (have_own_strength(b.settings.inclusions))
    throw InputError("a body with inclusions of another yield stress is softened; allowed: one of both");
  if (!factor.empty())
    require_size("Body::set_softening: the factor", factor, b.whole.size());
  for (const double value : factor)
    if (!(value > 0.0 && std::isfinite(value)))
      throw InputError(fmt::format("the factor on the yield stress of a cell is {:g}; allowed: above 0", value));
  b.yield.softening = own_layers(factor);
  b.device.is_softening_known = false;
  if (!b.trial.is_open)
    b.state.softening = b.yield.softening;
}

void Body::begin(int shift, double stiffness_share, Guess guess)
{
  BodyParts& b = parts_;
  for (std::size_t layer = 0; layer < b.trial.stiffness.size(); ++layer) // none of a body that stays elastic
    b.trial.stiffness[layer] = 2.0 * stiffness_share * b.evaluation->elastic_of(layer).shear_modulus();
  b.evaluation->restore(b.state);
  if (!b.is_plastic())
    return;
  prepare_trial(b);
  b.device.is_thermal_stress_known = b.device.is_thermal_stress_known && !b.trial.has_thermal_stress;
  b.trial.has_thermal_stress = false;
  b.trial.is_open = true;
  b.trial.active.clear();
  b.trial.places.clear();
  b.trial.count_of_all = 0;
  b.evaluation->begin(shift);
  const double fraction = b.settings.shortcuts ? active_share : -1.0;
  if (is_on_device())
    return begin_on_device(b, shift, fraction, guess == Guess::stress);
  if (guess == Guess::stress)
    for (const std::size_t cell : b.trial.guessed_cells)
      store(deviator_at(b.state.stress, b.grid.size(), cell), b.trial.stress, b.grid.size(), cell);
  // In the frame of the contact q changes little from step to step: the guess moves along with the contact.
  collect_active(b, b.trial.stress, shift, fraction);
  b.evaluation->follow(b.trial.active, 0);
}

void Body::set_thermal_stress(std::span<const double> deviator)
{
  BodyParts& b = parts_;
  if (!b.is_plastic())
    return;
  if (has_inclusions())
    throw InputError("a body with inclusions is heated; allowed: inclusions without heat");
  b.trial.thermal_stress = own_layers(deviator);
  b.trial.has_thermal_stress = true;
  b.device.is_thermal_stress_known = false;
}

double Body::integrate(Integration integration)
{
  BodyParts& b = parts_;
  if (!b.is_plastic())
    return 0.0;
  if (is_on_device())
    return integrate_on_device(b, integration);
  flow(b, integration);
  return b.evaluation->load(b.state, b.trial.active);
}

bool Body::update(const halfspace::SurfaceLoad& load)
{
  BodyParts& b = parts_;
  if (!b.is_plastic())
    return false;
  const auto acts = [](double shear) { return shear != 0.0; };
  b.trial.bears_shear = std::any_of(load.shear_x.begin(), load.shear_x.end(), acts) ||
                        std::any_of(load.shear_y.begin(), load.shear_y.end(), acts);
  if (is_on_device())
    return update_on_device(b, load);
  b.evaluation->stress(load, b.thermal_stress(), b.trial.stress);
  b.trial.yield_error = b.ranks->largest(map_trials(b));
  const std::size_t before = b.trial.active.size();
  collect_active(b, b.trial.stress, 0, 1.0);
  if (!b.ranks->any(b.trial.active.size() != before))
    return false;
  b.evaluation->follow(b.trial.active, before);
  put_on_yield_surface(b, before);
  return true;
}

void Body::restore()
{
  BodyParts& b = parts_;
  return_to_state(b);
  if (!b.trial.is_open)
    return;
  b.trial.is_open = false;
  b.device.knows_state = b.device.must_commit = false;
  const std::size_t n = b.grid.size();
  for (std::size_t a = 0; a < b.trial.active.size(); ++a)
    b.with_copies(a, [&](std::size_t cell, const auto& seen)
                  { store(seen(b.trial.active.start(a)), b.state.plastic_strain, n, cell); });
  b.trial.stress = b.state.stress;
  for (std::size_t a = 0; a < b.trial.guessed_cells.size(); ++a)
    for (std::size_t c = 0; c < Deviator::size; ++c)
      b.trial.stress[c * n + b.trial.guessed_cells[a]] = b.trial.guessed_q[a * Deviator::size + c];
}

/// Copies the stress of the independent rows to their mirror images.
void complete_stress(BodyParts& b)
{
  if (!b.grid.surface.is_mirrored_y)
    return;
  const std::size_t layer = b.grid.surface.size();
#pragma omp parallel for schedule(static)
  for (std::size_t plane = 0; plane < b.trial.stress.size() / layer; ++plane)
    complete_in_y(b.grid.surface, is_odd_in_y(static_cast<int>(plane) / b.grid.nz) ? -1.0 : 1.0,
                  b.trial.stress.data() + plane * layer, layer);
}

void Body::complete_trial()
{
  BodyParts& b = parts_;
  fetch();
  b.evaluation->find_displacement_x(b.state.plastic_strain, b.device.body.get());
  if (!b.is_plastic() || !b.grid.surface.is_mirrored_y)
    return;
  for (std::size_t a = 0; a < b.trial.active.size(); ++a)
  {
    const Deviator strain = deviator_at(b.state.plastic_strain, b.grid.size(), b.trial.active.cell(a));
    b.with_copies(a, [&](std::size_t cell, const auto& seen)
                  { store(seen(strain), b.state.plastic_strain, b.grid.size(), cell); });
  }
  complete_stress(b);
}

void Body::commit(const halfspace::SurfaceLoad& load)
{
  BodyParts& b = parts_;
  if (!b.is_plastic())
    return;
  const std::size_t n = b.grid.size();
  const ActiveCells& active = b.trial.active;
#pragma omp parallel for schedule(static)
  for (std::size_t a = 0; a < active.size(); ++a)
    b.with_copies(a,
                  [&](std::size_t cell, const auto& seen)
                  {
                    b.state.equivalent[cell] += active.equivalent(a);
                    const std::span<const Deviator> back = active.backstress(a);
                    for (std::size_t term = 0; active.equivalent(a) > 0.0 && term < back.size(); ++term)
                      store(seen(back[term]),
                            std::span(b.state.backstress).subspan(term * Deviator::size * n, Deviator::size * n), n,
                            cell);
                  });
  for (std::size_t a = 0; a < active.size(); ++a)
    if (active.equivalent(a) > 0.0)
      b.with_copies(a, [&](std::size_t cell, const auto& /*seen*/) { b.zone.add(cell, b.state.equivalent[cell]); });
  b.state.dissipation = with_dissipation(b, b.state.dissipation, b.grid.cell_volume());
  b.state.thermal_work += thermal_work_of_trial(b);
  if (b.trial.has_thermal_stress)
    b.state.thermal_stress.swap(b.trial.thermal_stress);
  b.trial.has_thermal_stress = false;
  b.state.softening = b.yield.softening;
  for_pieces(b.trial.stress.size(),
             [&](std::size_t first, std::size_t last)
             {
               const auto from = b.trial.stress.begin();
               std::copy(from + first, from + last, b.state.stress.begin() + first);
             });
  b.evaluation->store(b.state);
  b.state.locked_in_energy = locked_in_energy(b, load, b.zone);
  b.evaluation->commit(load);
  store_guess(b);
  b.trial.is_open = false;
  b.device.must_commit = true; // where nothing may fail any more, the device is not called
}

Deviator BodyParts::backstress(std::size_t cell, std::size_t term) const
{
  const std::size_t n = grid.size();
  Deviator b;
  for (int c = 0; c < Deviator::size; ++c)
    b[c] = state.backstress[(term * Deviator::size + static_cast<std::size_t>(c)) * n + cell];
  return b;
}

Deviator BodyParts::centre(std::size_t cell) const
{
  Deviator sum;
  for (std::size_t term = 0; term < yield.material.kinematic.size(); ++term)
    sum = sum + backstress(cell, term);
  return sum;
}

void Body::require(Scope scope)
{
  parts_.evaluation->require(scope);
}

Scope Body::scope() const
{
  return parts_.evaluation->scope();
}

double Body::cost() const
{
  return parts_.is_plastic() && !is_on_device() ? parts_.evaluation->cost() : 0.0;
}

std::span<const double> Body::residual_displacement(std::size_t axis) const
{
  return parts_.evaluation->displacement(axis);
}

void Body::full_stress(const halfspace::SurfaceLoad& load, std::span<double> deviator, std::span<double> trace,
                       int layers)
{
  parts_.evaluation->full_stress(load, parts_.state.plastic_strain, deviator, trace, layers);
}

std::vector<Body::CellStress> Body::stress_at(std::span<const std::size_t> cells, const halfspace::SurfaceLoad& load)
{
  return parts_.evaluation->stress_at(cells, load, parts_.state);
}

void Body::keep_trace()
{
  parts_.evaluation->keep_trace();
}

void Body::for_layers(const halfspace::SurfaceLoad& load, const UseLayer& use)
{
  parts_.evaluation->for_layers(load, parts_.state, use);
}

} // namespace brinell::elastoplastic
