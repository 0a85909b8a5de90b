// SPDX-License-Identifier: BSD-3-Clause
#include "fatigue_recorder.hpp"

#include "brinell/constitutive/hardening.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

/// Following a body from step to step; fatigue_judging.cpp judges what has been followed.
namespace brinell::simulation
{

namespace
{

using elastoplastic::CoupledContact;

/// Columns beyond the contact that are kept at either side, over the length of the contact.
constexpr double margin = 0.5;
constexpr int least_margin = 4;
/// Largest change of pressure and shear over the largest pressure for which an elastic body keeps its stress.
constexpr double steady = 1e-3;

std::span<const double> shear_of(const CoupledContact& pair, std::size_t axis)
{
  return pair.interface() == nullptr ? std::span<const double>() : pair.interface()->shears()[axis];
}

/// Largest difference of two fields; infinite if they differ in size.
double largest_change(std::span<const double> a, std::span<const double> b)
{
  if (a.size() != b.size())
    return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

std::vector<double> copy_of(std::span<const double> values)
{
  return {values.begin(), values.end()};
}

/// Floats as numbers of a checkpoint.
void exchange_floats(Archive& archive, const std::string& name, std::vector<float>& values)
{
  std::vector<double> doubles(values.begin(), values.end());
  archive.list(name, doubles);
  values.resize(doubles.size());
  std::ranges::transform(doubles, values.begin(), [](double value) { return static_cast<float>(value); });
}

/// Moves a field of the independent rows, `parts` numbers a cell, to a larger grid; new cells are zero.
std::vector<float> moved(const std::vector<float>& field, const VolumeGrid& from, const VolumeGrid& to, int columns,
                         int rows, std::size_t parts)
{
  const auto place = [](const VolumeGrid& grid, int i, int j, int k)
  { return static_cast<std::size_t>(k) * grid.surface.independent_cells() + grid.surface.index(i, j); };
  std::vector<float> result(parts * to.surface.independent_cells() * static_cast<std::size_t>(to.nz));
  for (int k = 0; k < from.nz; ++k)
    for (int j = 0; j < from.surface.independent_rows(); ++j)
      std::copy_n(field.begin() + static_cast<std::ptrdiff_t>(parts * place(from, 0, j, k)),
                  parts * static_cast<std::size_t>(from.surface.nx),
                  result.begin() + static_cast<std::ptrdiff_t>(parts * place(to, columns, j + rows, k)));
  return result;
}

} // namespace

int layers_of_coats(const constitutive::Material& material, const VolumeGrid& grid)
{
  const double bottom = material.stack().thickness();
  return std::clamp(static_cast<int>(std::ceil(bottom / grid.dz - 0.5)), 0, grid.nz);
}

bool follows_fatigue(const ShapedBody& body)
{
  return body.fatigue && !body.material.elastic.is_rigid();
}

FatigueOfBody::FatigueOfBody(const ShapedBody& body, std::size_t side)
    : body_(body), side_(side), fatigue_(*body.fatigue), shear_modulus_(body.material.elastic.shear_modulus()),
      yield_strain_(body.material.is_plastic()
                        ? constitutive::initial_yield_stress(body.material.law()) / body.material.elastic.young_modulus
                        : std::numeric_limits<double>::infinity()),
      numbers_(CoupledContact::numbers_of_stress + (fatigue_.criterion == constitutive::Fatigue::Criterion::fatemi_socie
                                                        ? CoupledContact::numbers_of_strain
                                                        : 0))
{
}

/// A body that has only its initial stress.
Sample FatigueOfBody::untouched(const VolumeGrid& grid) const
{
  StressSamples one(grid, numbers_);
  Sample sample = one.add(0, grid.surface.nx);
  const int rows = one.rows();
  for (int strip = 0; strip < one.strips(); ++strip)
  {
    const int layer = strip / rows;
    const double stress = body_.material.initial_stress.at((layer + 0.5) * grid.dz, 0.0); // xx and yy
    float* numbers = sample.values.data() + (one.strip(sample, strip) - sample.values.data());
    for (const auto& [n, value] : {std::pair{0, stress / 3.0}, {1, stress / 3.0}, {5, 2.0 * stress / 3.0}})
      std::fill_n(numbers + n * sample.count, sample.count, static_cast<float>(value));
  }
  return sample;
}

/// Follows the grid of the body, which may have grown. Cells that are new have been without load.
void FatigueOfBody::resize(const VolumeGrid& grid, double x0)
{
  if (grid == grid_)
    return;
  const VolumeGrid old = std::exchange(grid_, grid);
  const int columns = old.nz == 0 ? 0 : static_cast<int>(std::lround((x0_ - x0) / grid.surface.dx)),
            rows = old.nz == 0 ? 0 : (grid.surface.ny - old.surface.ny) / 2;
  x0_ = x0;
  computed_ = {};
  const Sample first = untouched(grid);
  if (old.nz == 0)
  {
    samples_ = StressSamples(grid, numbers_);
    samples_.add(first.first, first.count).values = first.values;
  }
  else
    samples_.move_to(grid, columns, rows, first);
  const int of_solved = turns_ ? grid.surface.nx - old.surface.nx - columns : columns;
  for (const auto& [field, parts] : {std::pair{&equivalent_, std::size_t{1}},
                                     {&first_equivalent_, std::size_t{1}},
                                     {&strain_, std::size_t{Deviator::size}},
                                     {&first_strain_, std::size_t{Deviator::size}}})
    if (body_.material.is_plastic())
      *field = moved(*field, old, grid, of_solved, rows, parts);
}

void FatigueOfBody::begin_cycle(int cycle)
{
  cycle_ = cycle;
  first_x_ = std::numeric_limits<double>::infinity();
  last_x_ = -first_x_;
  half_ = most_pressure_ = 0.0;
  shared_error_ = 0.0;
  samples_.restart();
  first_equivalent_ = equivalent_;
  first_strain_ = strain_;
}

/// The columns of the body under pressure; none if there is no pressure.
std::optional<FatigueOfBody::Columns> FatigueOfBody::pressed_columns(const Stepper::Present& present) const
{
  const SurfaceGrid& g = present.pair.grid();
  const std::span<const double> pressure = present.pair.pressure();
  Columns columns{g.nx, 0};
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
      if (pressure[g.index(i, j)] > 0.0)
        columns = {std::min(columns.first, i), std::max(columns.end, i + 1)};
  if (columns.end <= columns.first)
    return std::nullopt;
  const int shift = (side_ == 0 ? present.placement.lower : present.placement.upper).column;
  return Columns{columns.first + shift, columns.end + shift};
}

/// Takes the stress of an elastic body from an earlier step in which the contact bore the same load elsewhere.
bool FatigueOfBody::take_shared(const Stepper::Present& present, Columns columns)
{
  const elastoplastic::Place& place = side_ == 0 ? present.placement.lower : present.placement.upper;
  const int first = columns.first - (place.column - computed_.column), count = columns.end - columns.first;
  if (computed_.values.empty() || place.fraction != computed_.fraction || first != computed_.first ||
      count != computed_.count)
    return false;
  const std::span<const double> pressure = present.pair.pressure();
  const double most = *std::ranges::max_element(pressure);
  const double change = std::max({largest_change(pressure, computed_.pressure),
                                  largest_change(shear_of(present.pair, 0), computed_.shear_x),
                                  largest_change(shear_of(present.pair, 1), computed_.shear_y)});
  if (!(change <= steady * most))
    return false;
  shared_error_ = std::max(shared_error_, change);
  samples_.add(columns.first, count).values = computed_.values;
  return true;
}

void FatigueOfBody::take_sample(const Stepper::Present& present, Columns columns)
{
  const bool may_share = !body_.material.is_plastic() && present.pair.heating() == nullptr;
  if (may_share && take_shared(present, columns))
    return;
  const elastoplastic::Place& place = side_ == 0 ? present.placement.lower : present.placement.upper;
  Sample& sample = samples_.add(columns.first, columns.end - columns.first);
  present.pair.sample(side_, place, sample.first, sample.count, numbers_, sample.values);
  if (may_share)
    computed_ = {copy_of(present.pair.pressure()),
                 copy_of(shear_of(present.pair, 0)),
                 copy_of(shear_of(present.pair, 1)),
                 place.column,
                 place.fraction,
                 sample.first,
                 sample.count,
                 sample.values};
}

/// Takes over the plastic strain in the rows in which the body has flowed.
void FatigueOfBody::follow_strain(const elastoplastic::BodyView& view)
{
  const elastoplastic::BodyState& state = view.solved().state();
  const SurfaceGrid& surface = grid_.surface;
  const int rows = surface.independent_rows(), nx = surface.nx;
#pragma omp parallel for schedule(static)
  for (int strip = 0; strip < rows * grid_.nz; ++strip)
  {
    const std::size_t from = grid_.index(0, strip % rows, strip / rows),
                      to = static_cast<std::size_t>(strip) * static_cast<std::size_t>(nx);
    bool has_flowed = false; // a plain loop, which the compiler makes fast
#pragma omp simd reduction(|| : has_flowed)
    for (std::size_t i = 0; i < static_cast<std::size_t>(nx); ++i)
      has_flowed = has_flowed || static_cast<float>(state.equivalent[from + i]) != equivalent_[to + i];
    for (std::size_t i = 0; has_flowed && i < static_cast<std::size_t>(nx); ++i)
      equivalent_[to + i] = static_cast<float>(state.equivalent[from + i]);
    for (std::size_t i = 0; has_flowed && i < static_cast<std::size_t>(nx); ++i)
      for (std::size_t c = 0; c < Deviator::size; ++c)
        strain_[(to + i) * Deviator::size + c] = static_cast<float>(state.plastic_strain[c * grid_.size() + from + i]);
  }
}

void FatigueOfBody::add(int cycle, const Stepper::Present& present)
{
  result_.reset();
  const elastoplastic::BodyView view = side_ == 0 ? present.pair.lower() : present.pair.upper();
  turns_ = view.is_mirrored();
  resize(view.grid(), present.origins[side_]);
  const bool begins = cycle != cycle_;
  if (begins)
    begin_cycle(cycle);
  first_x_ = std::min(first_x_, present.centres[side_]);
  last_x_ = std::max(last_x_, present.centres[side_]);
  most_pressure_ = std::max(most_pressure_, std::ranges::max(present.pair.pressure()));
  const std::optional<Columns> pressed = pressed_columns(present);
  const int nx = grid_.surface.nx;
  Columns columns{0, nx};
  if (pressed)
  {
    const int length = pressed->end - pressed->first;
    half_ = std::max(half_, 0.5 * length * grid_.surface.dx);
    const int more = std::max(least_margin, static_cast<int>(std::ceil(margin * length)));
    if (!begins && !grid_.surface.is_periodic_x())
      columns = {std::clamp(pressed->first - more, 0, nx - 1), std::clamp(pressed->end + more, 1, nx)};
  }
  take_sample(present, columns);
  samples_.thin();
  if (body_.material.is_plastic())
    follow_strain(view);
}

void FatigueOfBody::exchange(Archive& archive)
{
  SurfaceGrid& surface = grid_.surface;
  constexpr int most = 1 << 20;
  archive("nx", surface.nx, 0, most);
  archive("ny", surface.ny, 0, most);
  archive("nz", grid_.nz, 0, most);
  archive("is_mirrored_y", surface.is_mirrored_y);
  for (const auto& [name, boundary] :
       {std::pair{"periodic_x", &surface.boundary_x}, {"periodic_y", &surface.boundary_y}})
  {
    bool is_periodic = *boundary == Boundary::periodic;
    archive(name, is_periodic);
    *boundary = is_periodic ? Boundary::periodic : Boundary::open;
  }
  for (const auto& [name, number] : {std::pair{"dx", &surface.dx},
                                     {"dy", &surface.dy},
                                     {"dz", &grid_.dz},
                                     {"x0", &x0_},
                                     {"first_x", &first_x_},
                                     {"last_x", &last_x_},
                                     {"half", &half_},
                                     {"most_pressure", &most_pressure_},
                                     {"shared_error", &shared_error_},
                                     {"computed_fraction", &computed_.fraction}})
    archive(name, *number);
  archive("cycle", cycle_, 0, std::numeric_limits<int>::max());
  archive("turns", turns_);
  archive("computed_column", computed_.column, -most, most);
  archive("computed_first", computed_.first, -most, most);
  archive("computed_count", computed_.count, 0, most);
  if (archive.gives())
  {
    result_.reset();
    samples_ = StressSamples(grid_, numbers_);
  }
  archive("samples", samples_);
  for (const auto& [name, list] : {std::pair{"computed_pressure", &computed_.pressure},
                                   {"computed_shear_x", &computed_.shear_x},
                                   {"computed_shear_y", &computed_.shear_y}})
    archive.list(name, *list);
  for (const auto& [name, list] : {std::pair{"computed_values", &computed_.values},
                                   {"equivalent", &equivalent_},
                                   {"strain", &strain_},
                                   {"first_equivalent", &first_equivalent_},
                                   {"first_strain", &first_strain_}})
    exchange_floats(archive, name, *list);
}

FatigueRecorder::FatigueRecorder(const ShapedBody& lower, const ShapedBody& upper)
{
  const std::array bodies{&lower, &upper};
  for (std::size_t side = 0; side < 2; ++side)
    if (follows_fatigue(*bodies[side]))
      bodies_[side].emplace(*bodies[side], side);
}

void FatigueRecorder::add(int cycle, const Stepper::Present& present)
{
  for (std::optional<FatigueOfBody>& body : bodies_)
    if (body)
      body->add(cycle, present);
}

void FatigueRecorder::attach(StepFields& fields) const
{
  const std::array within{&fields.lower, &fields.upper};
  for (std::size_t side = 0; side < 2; ++side)
    if (const std::optional<FatigueOfBody>& body = bodies_[side])
      for (std::size_t n = 0; n < fatigue_fields.size() - (body->has_criterion() ? 0 : 1); ++n)
        within[side]->fatigue.emplace_back(
            [&body, n, grid = side == 0 ? fields.surfaces.lower.grid : fields.surfaces.upper.grid]
            { return LayeredFields(grid, {body->fields()[n]}); });
}

std::array<std::optional<FatigueSummary>, 2> FatigueRecorder::summaries() const
{
  std::array<std::optional<FatigueSummary>, 2> result;
  for (std::size_t side = 0; side < 2; ++side)
    if (bodies_[side])
      result[side] = bodies_[side]->summary();
  return result;
}

void FatigueRecorder::exchange(Archive& archive)
{
  if (bodies_[0])
    archive("lower", *bodies_[0]);
  if (bodies_[1])
    archive("upper", *bodies_[1]);
}

} // namespace brinell::simulation
