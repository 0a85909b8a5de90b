// SPDX-License-Identifier: BSD-3-Clause
#include "constitutive/fatigue_lanes.hpp"
#include "fatigue_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

/// Judging what has been followed.
namespace brinell::simulation
{

namespace
{

using constitutive::FatigueCriterion;
using Criterion = constitutive::Fatigue::Criterion;

constexpr int lane_count = constitutive::fatigue_lanes;

/// Indices of `fatigue_fields`.
enum Field : std::size_t
{
  orthogonal,
  principal,
  mean_stress,
  hydrostatic,
  plastic_strain,
  ratchetting,
  shakedown,
  utilisation
};

bool is_on_planes(Criterion criterion)
{
  return criterion == Criterion::findley || criterion == Criterion::fatemi_socie;
}

/// Equivalent of the difference of two plastic strains.
double equivalent_of_change(const float* now, const float* before)
{
  std::array<double, Deviator::size> d{};
  for (std::size_t c = 0; c < d.size(); ++c)
    d[c] = static_cast<double>(now[c]) - static_cast<double>(before[c]);
  const auto [xx, yy, yz, xz, xy] = d;
  return std::sqrt(4.0 / 3.0 * (xx * xx + yy * yy + xx * yy + yz * yz + xz * xz + xy * xy));
}

} // namespace

struct FatigueOfBody::Lanes
{
  constitutive::LaneCycles cycles;
  constitutive::LaneScratch scratch;
};

/// The cycles of so many cells of a strip, from a column on; lanes beyond the last column repeat it. Where a sample does not
/// have a column, the one before stands for it.
void FatigueOfBody::gather(int strip, int first_column, Lanes& lanes) const
{
  std::vector<constitutive::LaneCycles::Stress>& stress = lanes.cycles.stress;
  std::vector<constitutive::LaneCycles::Stress>& strain = lanes.cycles.strain;
  stress.clear();
  strain.clear();
  const bool has_strain = numbers_ > elastoplastic::CoupledContact::numbers_of_stress;
  const int last = std::min(first_column + lane_count, grid_.surface.nx) - 1;
  const auto twice_shear_modulus = static_cast<float>(2.0 * shear_modulus_);
  std::array<bool, lane_count> is_known{};
  for (const Sample& sample : samples_.samples())
  {
    if (sample.first > last || sample.first + sample.count <= first_column)
      continue;
    const float* from = samples_.strip(sample, strip);
    const auto count = static_cast<std::size_t>(sample.count);
    constitutive::LaneCycles::Stress point = stress.empty() ? constitutive::LaneCycles::Stress{} : stress.back(),
                                     of_strain = strain.empty() ? constitutive::LaneCycles::Stress{} : strain.back();
    std::array<bool, lane_count> is_new{};
    const bool has_all = first_column >= sample.first && first_column + lane_count <= sample.first + sample.count;
    if (has_all) // most of them, and contiguous
    {
      from += first_column - sample.first;
      for (std::size_t n = 0; n < point.size(); ++n)
        std::copy_n(from + n * count, lane_count, point[n].begin());
      for (std::size_t n = 0; has_strain && n < Deviator::size; ++n)
        for (std::size_t l = 0; l < lane_count; ++l)
          of_strain[n][l] = point[n][l] + twice_shear_modulus * from[(point.size() + n) * count + l];
      for (std::size_t l = 0; l < lane_count; ++l)
        is_new[l] = !std::exchange(is_known[l], true);
    }
    for (int l = 0; l < lane_count && !has_all; ++l)
    {
      const int column = std::min(first_column + l, last) - sample.first;
      if (column < 0 || column >= sample.count)
        continue;
      const auto lane = static_cast<std::size_t>(l), i = static_cast<std::size_t>(column);
      for (std::size_t n = 0; n < point.size(); ++n)
        point[n][lane] = from[n * count + i];
      for (std::size_t n = 0; has_strain && n < Deviator::size; ++n)
        of_strain[n][lane] = point[n][lane] + twice_shear_modulus * from[(point.size() + n) * count + i];
      is_new[lane] = !std::exchange(is_known[lane], true);
    }
    // Before a lane is known, its first point stands for it.
    for (std::size_t l = 0; l < lane_count && !stress.empty(); ++l)
      if (is_new[l])
        for (std::size_t n = 0; n < point.size(); ++n)
        {
          for (auto& earlier : stress)
            earlier[n][l] = point[n][l];
          for (auto& earlier : strain)
            earlier[n][l] = of_strain[n][l];
        }
    stress.push_back(point);
    if (has_strain)
      strain.push_back(of_strain);
  }
}

/// @param slack  [strip][column]: becomes a bound for the error of the utilisation
void FatigueOfBody::judge_strip(int strip, const FatigueCriterion& criterion, Lanes& lanes, FatigueFields& fields,
                                std::span<float> slack) const
{
  constexpr double accepted = 0.006; // shear over the largest pressure, which is about three times the largest shear
  const int nx = grid_.surface.nx;
  const std::size_t row = grid_.index(0, strip % samples_.rows(), strip / samples_.rows());
  for (int first = 0; first < nx; first += lane_count)
  {
    gather(strip, first, lanes);
    const constitutive::LaneFatigue found =
        fatigue_of(lanes.cycles, criterion, lanes.scratch, accepted * most_pressure_);
    for (int l = 0; l < std::min(lane_count, nx - first); ++l)
    {
      const auto lane = static_cast<std::size_t>(l);
      const std::size_t cell = row + static_cast<std::size_t>(first + l);
      fields[orthogonal][cell] = found.orthogonal[lane];
      fields[principal][cell] = found.principal[lane];
      fields[mean_stress][cell] = 0.5 * (static_cast<double>(found.least_mean[lane]) + found.most_mean[lane]);
      fields[hydrostatic][cell] = found.most_mean[lane];
      fields[utilisation][cell] = found.utilisation[lane];
      slack[static_cast<std::size_t>(strip * nx + first + l)] = found.slack[lane];
    }
  }
}

/// Fills the fields that follow from the plastic strain, which are zero in bodies that do not yield.
void FatigueOfBody::judge_strain(int strip, FatigueFields& fields) const
{
  constexpr double flows = 0.01, closed = 0.1; // of the yield strain; of the plastic strain of the cycle
  if (!body_.material.is_plastic())
    return;
  const int nx = grid_.surface.nx;
  const std::size_t row = grid_.index(0, strip % samples_.rows(), strip / samples_.rows());
  for (int i = 0; i < nx; ++i)
  {
    const auto at = static_cast<std::size_t>(strip) * static_cast<std::size_t>(nx) +
                    static_cast<std::size_t>(turns_ ? nx - 1 - i : i);
    if (equivalent_[at] == 0.0F)
      continue;
    const double accumulated = static_cast<double>(equivalent_[at]) - static_cast<double>(first_equivalent_[at]),
                 open = equivalent_of_change(&strain_[at * Deviator::size], &first_strain_[at * Deviator::size]);
    const std::size_t cell = row + static_cast<std::size_t>(i);
    fields[plastic_strain][cell] = accumulated;
    fields[ratchetting][cell] = open;
    fields[shakedown][cell] = static_cast<double>(accumulated < flows * yield_strain_ ? Shakedown::elastic_shakedown
                                                  : open < closed * accumulated       ? Shakedown::plastic_shakedown
                                                                                      : Shakedown::ratchetting);
  }
}

/// The cells that are judged and, in all others, no value, if the criterion is one of critical planes.
std::vector<FatigueOfBody::Candidate> FatigueOfBody::candidates(bool on_planes, const std::vector<float>& slack,
                                                                FatigueFields& fields) const
{
  const int nx = grid_.surface.nx, rows = samples_.rows();
  const Columns judged = judged_columns();
  std::vector<Candidate> result;
  for (int strip = strips_of_coats(); strip < samples_.strips(); ++strip)
    for (int i = 0; i < nx; ++i)
    {
      const auto at = static_cast<std::size_t>(strip) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(i);
      double& value = fields[utilisation][grid_.index(i, strip % rows, strip / rows)];
      if ((on_planes && fatigue_.whole_map) || (i >= judged.first && i < judged.end))
        result.push_back({value + static_cast<double>(slack[at]), strip, i});
      if (on_planes)
        value = std::numeric_limits<double>::quiet_NaN();
    }
  return result;
}

/// Evaluates the criterion in double precision in the cells with the highest bounds, down to those whose bound is below a share of
/// the largest utilisation.
/// @returns the share of the candidates that were evaluated
double FatigueOfBody::settle(std::vector<Candidate> cells, double share, const FatigueCriterion& criterion,
                             FatigueFields& fields) const
{
  const int rows = samples_.rows();
  std::ranges::stable_sort(cells, [](const Candidate& a, const Candidate& b) { return a.bound > b.bound; });
  constexpr std::ptrdiff_t at_once = 64;
  double worst = -std::numeric_limits<double>::infinity();
  const auto count = static_cast<std::ptrdiff_t>(cells.size());
  std::ptrdiff_t first = 0;
  // Where pressure prevails, the largest utilisation may be negative, and no share of it bounds anything but itself.
  const auto matters = [&](double bound)
  { return share < 1.0 ? worst <= 0.0 || bound >= share * worst : bound >= worst; };
  for (; first < count && matters(cells[static_cast<std::size_t>(first)].bound); first += at_once)
  {
    const std::ptrdiff_t end = std::min(count, first + at_once);
    double found = worst;
#pragma omp parallel for schedule(dynamic) reduction(max : found)
    for (std::ptrdiff_t n = first; n < end; ++n)
    {
      const Candidate& c = cells[static_cast<std::size_t>(n)];
      const double value = exact_utilisation(c.strip, c.column, criterion);
      fields[utilisation][grid_.index(c.column, c.strip % rows, c.strip / rows)] = value;
      found = std::max(found, value);
    }
    worst = found;
  }
  return count == 0 ? 0.0 : static_cast<double>(std::min(first, count)) / static_cast<double>(count);
}

/// In double precision, for one cell.
double FatigueOfBody::exact_utilisation(int strip, int column, const FatigueCriterion& criterion) const
{
  const bool has_strain = numbers_ > elastoplastic::CoupledContact::numbers_of_stress;
  std::vector<SymTensor> stress, strain;
  for (const Sample& sample : samples_.samples())
  {
    if (column < sample.first || column >= sample.first + sample.count)
      continue;
    const float* from = samples_.strip(sample, strip) + (column - sample.first);
    const auto number = [&](std::size_t n) { return from[n * static_cast<std::size_t>(sample.count)]; };
    std::array<float, 6> s{}, e{};
    for (std::size_t n = 0; n < s.size(); ++n)
      s[n] = number(n);
    stress.push_back(constitutive::tensor_of(s));
    for (std::size_t n = 0; has_strain && n < Deviator::size; ++n)
      e[n] = s[n] + static_cast<float>(2.0 * shear_modulus_) * number(s.size() + n);
    if (has_strain)
      strain.push_back(constitutive::tensor_of(e));
  }
  return criterion.utilisation({stress, strain});
}

void FatigueOfBody::copy_to_mirror_images(FatigueFields& fields) const
{
  const SurfaceGrid& s = grid_.surface;
  for (std::vector<double>& field : fields)
    for (int k = 0; k < grid_.nz; ++k)
      for (int j = s.independent_rows(); j < s.ny; ++j)
        std::copy_n(field.begin() + static_cast<std::ptrdiff_t>(grid_.index(0, s.ny - 1 - j, k)), s.nx,
                    field.begin() + static_cast<std::ptrdiff_t>(grid_.index(0, j, k)));
}

int FatigueOfBody::strips_of_coats() const
{
  return samples_.rows() * layers_of_coats(body_.material, grid_);
}

/// The columns over which the contact has passed as a whole in the cycle; all of a periodic surface, whose contact has no ends.
std::optional<FatigueOfBody::Columns> FatigueOfBody::passed_columns() const
{
  if (grid_.surface.is_periodic_x())
    return Columns{0, grid_.surface.nx};
  const double dx = grid_.surface.dx;
  const int first = static_cast<int>(std::ceil((first_x_ + half_ - x0_) / dx - 1e-6)),
            last = static_cast<int>(std::floor((last_x_ - half_ - x0_) / dx + 1e-6));
  if (last < first || first < 0 || last >= grid_.surface.nx)
    return std::nullopt;
  return Columns{first, last + 1};
}

FatigueOfBody::Columns FatigueOfBody::judged_columns() const
{
  return passed_columns().value_or(Columns{0, grid_.surface.nx});
}

/// Stress-volume of Lundberg and Palmgren, and the life that follows from it.
void FatigueOfBody::find_life(Result& result) const
{
  constexpr double giga = 1e9, milli = 1e-3;
  const auto [begin, end] = judged_columns();
  FatigueSummary& s = result.summary;
  std::vector<double> columns(static_cast<std::size_t>(end - begin));
  double of_first_layer = 0.0;
  const double area = grid_.surface.dy * grid_.dz / (milli * milli);
  const int rows = samples_.rows();
  for (int strip = strips_of_coats(); strip < samples_.strips(); ++strip)
  {
    const int j = strip % rows, k = strip / rows;
    const double weight =
        area * grid_.surface.copies_of_row(j) * std::pow((k + 0.5) * grid_.dz / milli, -fatigue_.depth_exponent);
    for (int i = begin; i < end; ++i)
    {
      const double shear = result.fields[orthogonal][grid_.index(i, j, k)] - fatigue_.threshold;
      if (!(shear > 0.0))
        continue;
      const double part = weight * std::pow(shear / giga, fatigue_.stress_exponent);
      columns[static_cast<std::size_t>(i - begin)] += part;
      of_first_layer += k == 0 ? part : 0.0; // none under a coat
    }
  }
  const double whole = std::accumulate(columns.begin(), columns.end(), 0.0);
  s.stress_volume = whole / static_cast<double>(columns.size());
  s.share_of_first_layer = whole > 0.0 ? of_first_layer / whole : 0.0;
  const auto middle = columns.begin() + static_cast<std::ptrdiff_t>(columns.size() / 2);
  std::nth_element(columns.begin(), middle, columns.end());
  const double reference = fatigue_.reference.value_or(*middle);
  s.is_own_reference = !fatigue_.reference;
  if (s.stress_volume > 0.0 && reference > 0.0)
    s.life = std::pow(reference / s.stress_volume, 1.0 / fatigue_.weibull_slope);
}

void FatigueOfBody::summarise(Result& result) const
{
  FatigueSummary& s = result.summary;
  s.cycle = cycle_;
  const auto [first, end] = judged_columns();
  const SurfaceGrid& surface = grid_.surface;
  s.first_column = x0_ + first * surface.dx;
  s.last_column = x0_ + (end - 1) * surface.dx;
  std::array<FatiguePlace, fatigue_fields.size()> places;
  for (FatiguePlace& place : places)
    place.value = -std::numeric_limits<double>::infinity();
  const int rows = samples_.rows();
  for (int strip = strips_of_coats(); strip < samples_.strips(); ++strip)
    for (int i = first; i < end; ++i)
    {
      const int j = strip % rows, k = strip / rows;
      const std::size_t cell = grid_.index(i, j, k);
      for (std::size_t n = 0; n < places.size(); ++n)
        if (const double value = result.fields[n][cell]; value > places[n].value)
          places[n] = {value, x0_ + i * surface.dx, surface.y(j), (k + 0.5) * grid_.dz,
                       k == grid_.nz - 1 || (j == 0 && !surface.is_periodic_y()) ||
                           (j == surface.ny - 1 && !surface.is_periodic_y()) || i == 0 || i == surface.nx - 1};
      s.shares[static_cast<std::size_t>(result.fields[shakedown][cell])] += surface.copies_of_row(j);
    }
  const int judged_layers = grid_.nz - layers_of_coats(body_.material, grid_);
  for (double& share : s.shares)
    share /= static_cast<double>(end - first) * surface.ny * judged_layers;
  s.orthogonal_shear = places[orthogonal];
  s.principal_shear = places[principal];
  s.plastic_strain = places[plastic_strain].value;
  s.ratchetting = places[ratchetting].value;
  if (has_criterion())
    s.utilisation = places[utilisation];
  if (s.orthogonal_shear.value > 0.0) // no shear changes by more than the distance in the six numbers
    s.path_error = (samples_.error() + shared_error_) / s.orthogonal_shear.value;
  const bool travels = last_x_ - first_x_ > 0.5 * surface.dx;
  s.is_short = travels && half_ > 0.0 && !passed_columns();
  if (travels && half_ > 0.0 && passed_columns())
    find_life(result);
}

const FatigueOfBody::Result& FatigueOfBody::result() const
{
  if (result_)
    return *result_;
  Result found;
  for (std::vector<double>& field : found.fields)
  {
    field.resize(grid_.size());
    std::fill_n(field.begin(), grid_.index(0, 0, layers_of_coats(body_.material, grid_)),
                std::numeric_limits<double>::quiet_NaN());
  }
  if (grid_.size() > 0)
  {
    const FatigueCriterion criterion(fatigue_);
    std::vector<float> slack(static_cast<std::size_t>(samples_.strips()) * static_cast<std::size_t>(grid_.surface.nx));
#pragma omp parallel
    {
      Lanes lanes;
#pragma omp for schedule(dynamic)
      for (int strip = strips_of_coats(); strip < samples_.strips(); ++strip)
      {
        judge_strip(strip, criterion, lanes, found.fields, slack);
        judge_strain(strip, found.fields);
      }
    }
    if (is_on_planes(criterion.kind()))
    {
      const double share = fatigue_.whole_map ? -std::numeric_limits<double>::infinity() : fatigue_map_share;
      found.summary.judged_share = settle(candidates(true, slack, found.fields), share, criterion, found.fields);
    }
    else if (has_criterion())
      settle(candidates(false, slack, found.fields), 1.0, criterion, found.fields);
    summarise(found);
    copy_to_mirror_images(found.fields);
  }
  return result_.emplace(std::move(found));
}

} // namespace brinell::simulation
