// SPDX-License-Identifier: BSD-3-Clause
#include "heat_coat.hpp"

#include "brinell/foundation/error.hpp"
#include "green/stack_heat.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <fmt/format.h>
#include <numbers>

namespace brinell::halfspace
{

namespace
{

using Complex = std::complex<double>;

/// Node of the inverse Laplace transform: f(t) is the sum of Re(weight F(rate/t))/t.
struct LaplaceNode
{
  Complex rate, weight;
};

/// Talbot's path with the constants of Trefethen, Weideman and Schmelzer (2006); an error of 1e-9 for functions whose singularities are
/// on the negative axis.
std::vector<LaplaceNode> laplace_nodes()
{
  constexpr int count = 18;
  std::vector<LaplaceNode> nodes;
  nodes.reserve(count / 2);
  for (int n = 0; n < count / 2; ++n)
  {
    const double angle = (2 * n + 1) * std::numbers::pi / count, bent = 0.6407 * angle;
    const Complex rate = static_cast<double>(count) * Complex{0.5017 * angle / std::tan(bent) - 0.6122, 0.2645 * angle};
    const Complex slope{0.5017 / std::tan(bent) - 0.5017 * bent / (std::sin(bent) * std::sin(bent)), 0.2645};
    nodes.push_back({rate, 2.0 * std::exp(rate) * slope / Complex{0.0, 1.0}});
  }
  return nodes;
}

constexpr double step_of_wavenumbers = 0.15; ///< of ln k

/// From values at the times to the weights of the sum of waves that fits them: least squares of sqrt(t) times the values, with weights
/// that are kept from growing without effect.
/// @param resolved  number of the time from which on the values count by sqrt(t); before, they count less or not at all
/// @param early     whether they count before
/// @returns a column for each time, and one for the integral of the values up to the time `resolved`, for what begins at once
Matrix fitted_sums(double diffusivity, const std::vector<DepthWave>& waves, const std::vector<double>& times,
                   std::size_t resolved, bool early)
{
  constexpr double kept_small = 1e-7, of_integral = 3.0;
  const auto count = static_cast<int>(times.size()), rows = count + 1, columns = static_cast<int>(waves.size());
  const auto scale = [&](int l) { return waves[static_cast<std::size_t>(std::min(l, columns - 2))].number; };
  Matrix sums(rows + columns, columns), unit(rows + columns, rows);
  for (int t = early ? 0 : static_cast<int>(resolved); t < count; ++t)
  {
    const double time = times[static_cast<std::size_t>(t)], spread = diffusivity * time;
    const double weight = std::sqrt(spread) * std::min(1.0, std::sqrt(time / times[resolved]));
    unit(t, t) = weight;
    for (int l = 0; l < columns; ++l)
    {
      const double number = waves[static_cast<std::size_t>(l)].number;
      sums(t, l) = scale(l) * weight * std::exp(-spread * number * number);
    }
  }
  for (int l = 0; l < columns; ++l)
  {
    const double number = waves[static_cast<std::size_t>(l)].number, decay = diffusivity * number * number;
    const double weight = of_integral * std::sqrt(diffusivity / times[resolved]);
    unit(count, count) = weight;
    sums(count, l) =
        scale(l) * weight * (decay > 0.0 ? -std::expm1(-decay * times[resolved]) / decay : times[resolved]);
    sums(rows + l, l) = kept_small;
  }
  Matrix result = least_squares(sums, unit);
  for (int l = 0; l < columns; ++l)
    for (int t = 0; t < rows; ++t)
      result(l, t) *= scale(l);
  return result;
}

} // namespace

/// Times are taken twice per wave, up to ten times the duration of the memory.
HeatCoat::HeatCoat(ThermalStack thermal, std::optional<ElasticStack> elastic, const DepthWaves& waves, Wanted wanted)
    : thermal_(std::move(thermal)), elastic_(std::move(elastic)), wanted_(std::move(wanted)),
      waves_(waves.waves.size()), nodes_(0), step_(step_of_wavenumbers)
{
  const double octaves = std::log(wanted_.longest / wanted_.shortest) / step_;
  nodes_ = std::max(Place::points, 1 + static_cast<std::size_t>(std::ceil(octaves)));
  const double diffusivity = of_memory(thermal_).diffusivity();
  const double fastest = waves.waves.front().number, slowest = waves.waves[waves_ - 2].number;
  // The fastest wave tells times from `resolved` on. What does not begin with a jump is also kept close to its values before.
  const double resolved = 8.0 / (diffusivity * fastest * fastest), last = 4e-3 / (diffusivity * slowest * slowest);
  for (double time = resolved; time > 3e-3 * resolved; time *= std::exp(-waves.step))
    times_.push_back(time);
  std::reverse(times_.begin(), times_.end());
  resolved_ = times_.size() - 1;
  for (double time = resolved * std::exp(waves.step); time < last; time *= std::exp(waves.step))
    times_.push_back(time);
  from_times_ = fitted_sums(diffusivity, waves.waves, times_, resolved_, true);
  from_late_times_ = fitted_sums(diffusivity, waves.waves, times_, resolved_, false);
  // Heat has not come so deep at the time from which on the waves tell times: e^{-14}.
  constexpr double late = 7.5;
  deep_ = late * std::sqrt(thermal_.fastest().diffusivity() * resolved);
  tables_.reserve(parts_of_surface + parts_of_depth * wanted_.depths.size()); // so that tables are never moved
  fit(0, 0);
}

std::size_t HeatCoat::number_of(double depth) const
{
  const auto found = std::find(wanted_.depths.begin(), wanted_.depths.end(), depth);
  if (found == wanted_.depths.end())
    throw InternalError(fmt::format("the heat of a coated body is not planned for a depth of {} m", depth));
  return static_cast<std::size_t>(found - wanted_.depths.begin());
}

std::size_t HeatCoat::layer_at(double depth) const
{
  return elastic_->layer_at(depth);
}

void HeatCoat::require_depths(std::size_t count) const
{
  const std::lock_guard lock(mutex_);
  if (count > depths_done_)
    fit(depths_done_, count - depths_done_);
}

/// Node 0 is the uniform part; then they follow from the longest wave on.
double HeatCoat::wavenumber(std::size_t node) const
{
  if (node == 0 && wanted_.is_periodic)
    return 0.0;
  return 2.0 * std::numbers::pi / wanted_.longest * std::exp(step_ * static_cast<double>(node == 0 ? 0 : node - 1));
}

/// One wavenumber: values of the parts at the times.
struct HeatCoat::Fit
{
  const HeatCoat& coat;
  double k;
  const std::vector<LaplaceNode>& nodes;
  std::size_t first_depth, count;

  [[nodiscard]] Matrix values() const
  {
    const bool has_surface = count == 0;
    const Thermal& slow = of_memory(coat.thermal_);
    const double diffusivity = slow.diffusivity(), unit = slow.conductivity / diffusivity;
    std::optional<green::StackExpansion> expansion;
    if (coat.elastic_)
      expansion.emplace(*coat.elastic_, coat.thermal_, k);
    for (std::size_t d = first_depth; d < first_depth + count; ++d)
      expansion->add_depth(coat.layer_at(coat.wanted_.depths[d]), coat.wanted_.depths[d]);
    const std::size_t parts = has_surface ? parts_of_surface : count * parts_of_depth;
    Matrix result(static_cast<int>(coat.times_.size()) + 1, static_cast<int>(parts));
    const auto integral = static_cast<int>(coat.times_.size());
    std::vector<green::StackExpansion::Stress> stresses;
    green::StackExpansion::Displacement moved{};
    for (std::size_t t = 0; t < coat.times_.size(); ++t)
      for (const LaplaceNode& node : nodes)
      {
        const Complex rate = node.rate / coat.times_[t], weight = unit / coat.times_[t] * node.weight;
        const green::StackHeat heat(coat.thermal_, k, rate, diffusivity);
        if (expansion)
          expansion->find(heat, stresses, moved);
        const auto add = [&](std::size_t part, const Complex& value)
        {
          result(static_cast<int>(t), static_cast<int>(part)) += (weight * value).real();
          if (t == coat.resolved_)
            result(integral, static_cast<int>(part)) += (weight * value / rate).real();
        };
        if (has_surface)
        {
          add(0, coat.is_excess() ? heat.excess_at_surface()
                                  : heat.at_surface() - 1.0 / (slow.conductivity * std::sqrt(rate / diffusivity)));
          add(1, moved.z);
          add(2, moved.l);
        }
        for (std::size_t d = 0; d < count; ++d)
        {
          add(parts_of_depth * d, stresses[d].temperature);
          add(parts_of_depth * d + 1, stresses[d].ll);
          add(parts_of_depth * d + 2, stresses[d].zz);
          add(parts_of_depth * d + 3, stresses[d].lz);
        }
      }
    return result;
  }
};

/// @param count  number of depths; 0: the parts at the surface
void HeatCoat::fit(std::size_t first_depth, std::size_t count) const
{
  const std::vector<LaplaceNode> path = laplace_nodes();
  const std::size_t parts = count == 0 ? parts_of_surface : count * parts_of_depth, nodes = nodes_ + 1;
  const std::size_t first = tables_.size();
  tables_.resize(first + parts, std::vector<double>(nodes * waves_));
#pragma omp parallel for schedule(dynamic)
  for (std::size_t node = 0; node < nodes; ++node)
  {
    const Matrix values = Fit{*this, wavenumber(node), path, first_depth, count}.values();
    std::vector<double> weights(waves_ * parts);
    assign_product(from_times_, values, weights.data());
    // The temperature of the surface begins with infinity, and near the surface soon.
    if (count == 0 && !is_excess())
      assign_product(from_late_times_, MatrixView(values, values.rows(), 1), weights.data());
    for (std::size_t d = 0; d < count; ++d)
      if (wanted_.depths[first_depth + d] < deep_)
        assign_product(from_late_times_,
                       MatrixView(values.column(static_cast<int>(d * parts_of_depth)), values.rows(), parts_of_depth),
                       weights.data() + d * parts_of_depth * waves_);
    for (std::size_t part = 0; part < parts; ++part)
      std::copy_n(weights.begin() + static_cast<std::ptrdiff_t>(part * waves_), waves_,
                  tables_[first + part].begin() + static_cast<std::ptrdiff_t>(node * waves_));
  }
  depths_done_ = first_depth + count;
}

HeatCoat::Place HeatCoat::place_of(const Lanes& k) const
{
  Place place;
  const double longest = wavenumber(1);
  for (std::size_t lane = 0; lane < lane_count; ++lane)
  {
    auto& factors = place.factors[lane];
    if (k[lane] <= longest)
    {
      place.first[lane] = k[lane] == 0.0 ? 0 : 1;
      factors = {1.0};
      continue;
    }
    const double at = std::min(std::log(k[lane] / longest) / step_, static_cast<double>(nodes_ - 1));
    const double begin = std::clamp(std::floor(at) - 2.0, 0.0, static_cast<double>(nodes_ - Place::points));
    place.first[lane] = 1 + static_cast<std::size_t>(begin);
    for (std::size_t p = 0; p < Place::points; ++p)
    {
      factors[p] = 1.0;
      for (std::size_t other = 0; other < Place::points; ++other)
        if (other != p)
          factors[p] *=
              (at - begin - static_cast<double>(other)) / (static_cast<double>(p) - static_cast<double>(other));
    }
  }
  return place;
}

void HeatCoat::weights(Part part, std::size_t depth, const Place& place, std::span<Lanes> out) const
{
  const auto number = static_cast<std::size_t>(part);
  const std::vector<double>& table = tables_[number < parts_of_surface ? number : number + parts_of_depth * depth];
  const std::size_t skipped = waves_ - out.size();
  // Contiguous, so that the compiler uses vectors.
  constexpr std::size_t together = 64;
  std::array<double, together> some{};
  for (std::size_t lane = 0; lane < lane_count; ++lane)
  {
    const auto& f = place.factors[lane];
    for (std::size_t first = 0; first < out.size(); first += together)
    {
      const std::size_t count = std::min(together, out.size() - first);
      const double* row = table.data() + place.first[lane] * waves_ + skipped + first;
      std::fill_n(some.begin(), count, 0.0);
      for (std::size_t p = 0; p < Place::points; ++p, row += waves_)
        for (std::size_t w = 0; w < count; ++w)
          some[w] += f[p] * row[w];
      for (std::size_t w = 0; w < count; ++w)
        out[first + w][lane] = some[w];
    }
  }
}

} // namespace brinell::halfspace
