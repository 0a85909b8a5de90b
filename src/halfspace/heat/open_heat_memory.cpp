// SPDX-License-Identifier: BSD-3-Clause
#include "open_heat_memory.hpp"

#include "foundation/require_size.hpp"
#include "require_thermal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace brinell::halfspace
{

namespace
{

/// Lagrange polynomial of node number `of`, at a depth.
double lagrange(std::span<const DepthFactors> nodes, std::size_t of, double depth)
{
  double weight = 1.0;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (n != of)
      weight *= (depth - nodes[n].depth) / (nodes[of].depth - nodes[n].depth);
  return weight;
}

constexpr std::size_t fields_per_pass = 5;

/// Adds weighted fields of a grid in one pass.
/// @param first, apart  the fields are fields[first], fields[first + apart], ...
/// @param window        cells of the grid that `to` contains
void add_weighted(std::span<const double> weights, std::span<const std::vector<double>> fields, std::size_t first,
                  std::size_t apart, const SurfaceGrid& grid, const HeatMemory::Window& window, std::span<double> to)
{
  std::array<double, fields_per_pass> weight{};
  for (std::size_t n = 0; n < weights.size(); ++n)
    weight[n] = weights[n];
  double* sum = to.data();
  for (int j = 0; j < window.rows; ++j, sum += window.columns)
  {
    std::array<const double*, fields_per_pass> field{};
    for (std::size_t n = 0; n < fields_per_pass; ++n)
      field[n] = fields[first + (n < weights.size() ? n : 0) * apart].data() +
                 grid.index(window.first_column, window.first_row + j);
    if (weights.size() == 1)
      for (int i = 0; i < window.columns; ++i)
        sum[i] += weight[0] * field[0][i];
    else
      for (int i = 0; i < window.columns; ++i)
        sum[i] += weight[0] * field[0][i] + weight[1] * field[1][i] + weight[2] * field[2][i] +
                  weight[3] * field[3][i] + weight[4] * field[4][i];
  }
}

/// Layers from the surface to a depth that no heat reaches.
std::shared_ptr<const LayeredConduction> planned_layers(const HeatedLayers& heated, const Thermal& thermal,
                                                        const HeatTimes& times)
{
  if (heated.count == 0)
    return nullptr;
  if (!(heated.count > 0 && heated.thickness > 0.0 && std::isfinite(heated.thickness)))
    throw InputError(
        fmt::format("ThermalField: {} layers with heat sources, each {} m thick; allowed: a finite thickness above 0",
                    heated.count, heated.thickness));
  const double spread = reach_of_heat * std::sqrt(4.0 * thermal.diffusivity() * times.duration);
  return std::make_shared<const LayeredConduction>(heated.count, heated.thickness,
                                                   (heated.count + 1) * heated.thickness + spread);
}

} // namespace

OpenHeatMemory::OpenHeatMemory(const char* owner, const SurfaceGrid& grid, const Thermal& thermal,
                               const HeatTimes& times, const Wanted& wanted)
    : OpenHeatMemory(grid, thermal, times, wanted, waves_of_heat(owner, grid, thermal, times, wanted))
{
}

OpenHeatMemory::OpenHeatMemory(const SurfaceGrid& grid, const Thermal& thermal, const HeatTimes& times,
                               const Wanted& wanted, const DepthWaves& waves)
    : OpenHeatMemory(grid, thermal, times, wanted, waves,
                     ImagesOfHeat(grid, wanted.coat ? wanted.coat->thermal.fastest() : thermal, thermal, times.duration,
                                  wanted.images, waves.has_fields))
{
}

OpenHeatMemory::OpenHeatMemory(const SurfaceGrid& grid, const Thermal& thermal, const HeatTimes& times,
                               const Wanted& wanted, DepthWaves waves, const ImagesOfHeat& images)
    : times_(times), heated_(wanted.heated), layers_(planned_layers(wanted.heated, thermal, times)),
      waves_(std::move(waves)), coat_(planned_coat(grid, wanted, waves_, images)),
      near_(grid, images.period_x, images.period_y, thermal, waves_, surface_factors(waves_), layers_, coat_)
{
  plan_images(thermal, wanted, images);
  if (farther_.empty() || !(wanted.deepest > 0.0))
    return;
  const std::vector<double> nodes = nodes_of_images(wanted);
  if (coat_) // which has the weights
    for (const double node : nodes)
      image_depths_.push_back({node, {0.0}, {}, {}, {}});
  else
    image_depths_ = depth_factors(waves_, nodes);
}

void OpenHeatMemory::plan_images(const Thermal& thermal, const Wanted& wanted, const ImagesOfHeat& images)
{
  const SurfaceGrid& grid = near_.grid();
  if (images.nearest < images.end && (images.x_is_coarser || images.y_is_coarser))
    farther_.push_back({CoarserSurface(grid, {0, 0}, {images.x_is_coarser, images.y_is_coarser})});
  const DepthFactors surface = surface_factors(waves_);
  for (double distance = images.nearest; distance < images.end; distance *= 2.0)
  {
    const CoarserSurface cells =
        farther_.empty() ? CoarserSurface(grid, 0)
                         : CoarserSurface(farther_.back().cells.grid(), farther_.back().cells.margins(), {true, true});
    const DepthWaves slow = waves_.slower_than(images.decayed / distance);
    const auto layers = wanted.images == HeatImages::coarse ? layers_for_images(layers_, distance) : layers_;
    const auto memory = [&](int px, int py)
    { return HeatMemory(cells.grid(), px, py, thermal, slow, surface, layers, coat_); };
    farther_.push_back(
        {cells, Lattices{memory(images.twice_x, images.twice_y), memory(images.once_x, images.once_y), layers}});
  }
}

void OpenHeatMemory::require_step(const char* function_name, double duration) const
{
  constexpr double rounding = 1e-9;
  if (!(duration >= (1.0 - rounding) * times_.shortest_step) ||
      !(time_ + duration <= (1.0 + rounding) * times_.duration))
    throw InputError(fmt::format("{}: a step of {} s after {} s; allowed: steps of at least {} s, and {} s in total",
                                 function_name, duration, time_, times_.shortest_step, times_.duration));
}

/// Sum of the corrections of all lattices that removes the images, on the cells of the grid.
OpenHeatMemory::Fields OpenHeatMemory::sum_of_images(std::size_t count, double factor_of_farthest, const Add& add) const
{
  // From the coarsest to the finest cells.
  Fields sums(count);
  std::vector<double> buffer, finer;
  for (std::vector<double>& field : sums)
    field.reserve(grid().size()); // for the finest grid
  for (std::size_t n = farther_.size(); n-- > 0;)
  {
    const FartherImages& images = farther_[n];
    const double factor = n + 1 == farther_.size() ? factor_of_farthest : 1.0;
    for (std::vector<double>& field : sums)
      field.resize(images.cells.grid().size());
    if (images.lattices)
    {
      add(images.lattices->twice, factor, sums);
      add(images.lattices->once, -factor, sums);
    }
    for (std::vector<double>& field : sums)
    {
      images.cells.to_finer(field, buffer, finer);
      field.swap(finer);
    }
  }
  for (std::vector<double>& field : sums)
    field.resize(grid().size());
  return sums;
}

void OpenHeatMemory::remaining(const char* function_name, double duration, std::span<double> temperature) const
{
  require_size(fmt::format("{}: the temperature", function_name).c_str(), temperature, grid().size());
  require_step(function_name, duration);
  add_surface(duration, temperature);
}

void OpenHeatMemory::present_excess(std::span<double> temperature) const
{
  if (!coat_ || !coat_->is_excess())
    throw InternalError("OpenHeatMemory: the flux of a step heats its surface in another way");
  add_surface(0.0, temperature);
}

void OpenHeatMemory::add_surface(double duration, std::span<double> temperature) const
{
  const auto add = [&](const HeatMemory& memory, double factor, Fields& sums)
  { memory.add_remaining(duration, factor, grid(), sums.front()); };
  Fields result = sum_of_images(1, 1.0, add);
  add(near_, 1.0, result);
  std::copy(result.front().begin(), result.front().end(), temperature.begin());
}

void OpenHeatMemory::fields(const char* function_name, double duration, std::span<const DepthFactors> depths,
                            const HeatMemory::FieldsOfHeat& fields_of_heat, const std::vector<std::span<double>>& out,
                            const HeatMemory::Window& window) const
{
  if (duration != 0.0)
    require_step(function_name, duration);
  const std::size_t count = fields_of_heat.is_odd.size();
  // Depths per pass: few enough that their spectra stay in the cache until they are transformed, but not too few, because every
  // pass reads the whole memory again.
  constexpr std::size_t most_bytes = 5 * 1024 * 1024, least_at_once = 8;
  const std::size_t most_at_once = std::max(least_at_once, most_bytes / (count * near_.spectrum_bytes()));
  for (std::size_t done = 0; done < depths.size(); done += most_at_once)
  {
    const auto group = depths.subspan(done, std::min(most_at_once, depths.size() - done));
    const std::vector<std::span<double>> to(out.begin() + static_cast<std::ptrdiff_t>(done * count),
                                            out.begin() + static_cast<std::ptrdiff_t>((done + group.size()) * count));
    near_.fields(duration, 1.0, group, fields_of_heat, to, false, window);
  }
  if (!farther_.empty())
    add_images(duration, depths, fields_of_heat, out, window);
}

/// Of the depths of images, the first and the one after the last that lie in the layer of a depth.
std::pair<std::size_t, std::size_t> OpenHeatMemory::nodes_around(double depth) const
{
  if (!coat_)
    return {0, image_depths_.size()};
  const std::size_t layer = coat_->layer_at(depth);
  std::size_t first = 0;
  while (coat_->layer_at(image_depths_[first].depth) < layer)
    ++first;
  std::size_t last = first;
  while (last < image_depths_.size() && coat_->layer_at(image_depths_[last].depth) == layer)
    ++last;
  return {first, last};
}

/// Fields of the images vary slowly with depth, as the images are far away: for many layers they are interpolated by the
/// polynomial through Chebyshev points.
void OpenHeatMemory::add_images(double duration, std::span<const DepthFactors> depths,
                                const HeatMemory::FieldsOfHeat& fields_of_heat,
                                const std::vector<std::span<double>>& out, const HeatMemory::Window& window) const
{
  const bool each = image_depths_.empty() || depths.size() <= image_depths_.size();
  const std::span<const DepthFactors> nodes = each ? depths : std::span(image_depths_);
  const std::size_t count = fields_of_heat.is_odd.size();
  // Displacements and stresses decrease with the third power of the distance, and in plane strain with the second: from lattice
  // to lattice by factors of 8 and 4, so the sum of all further lattices is 1/7 and 1/3 of the last one.
  const double farthest = is_strip(grid()) ? 4.0 / 3.0 : 8.0 / 7.0;
  const Fields images =
      sum_of_images(nodes.size() * count, farthest,
                    [&](const HeatMemory& memory, double factor, Fields& sums)
                    {
                      memory.fields(duration, factor, nodes, fields_of_heat,
                                    std::vector<std::span<double>>(sums.begin(), sums.end()), true, memory.whole());
                    });
  for (std::size_t d = 0; d < depths.size(); ++d)
  {
    const auto [first, last] = each ? std::pair{d, d + 1} : nodes_around(depths[d].depth);
    std::vector<double> weights;
    for (std::size_t n = first; n < last; ++n)
      weights.push_back(each ? 1.0 : lagrange(nodes.subspan(first, last - first), n - first, depths[d].depth));
    for (std::size_t f = 0; f < count; ++f)
      for (std::size_t n = first; n < last; n += fields_per_pass)
        add_weighted(std::span(weights).subspan(n - first, std::min(fields_per_pass, last - n)), images, n * count + f,
                     count, grid(), window, out[d * count + f]);
  }
}

/// Calls `use` for each lattice, with the flux on the cells of this lattice.
template <typename Use>
void OpenHeatMemory::for_each_lattice(std::span<const double> flux, const Use& use)
{
  use(near_, flux);
  std::vector<double> coarse(flux.begin(), flux.end());
  for (FartherImages& images : farther_)
  {
    coarse = images.cells.from_finer(coarse);
    if (!images.lattices)
      continue;
    use(images.lattices->twice, coarse);
    use(images.lattices->once, coarse);
  }
}

void OpenHeatMemory::add_step(const char* function_name, std::span<const double> flux, const HeatMotion& motion,
                              Heat* before)
{
  require_size(fmt::format("{}: the flux", function_name).c_str(), flux, grid().size());
  require_step(function_name, motion.duration);
  require_along_x(function_name, grid(), motion);
  std::size_t lattice = 0;
  if (before != nullptr)
  {
    before->lattices.resize(lattices().size());
    before->time = time_;
  }
  for_each_lattice(flux, [&](HeatMemory& memory, std::span<const double> given)
                   { memory.add_step(given, motion, before != nullptr ? &before->lattices[lattice++] : nullptr); });
  time_ += motion.duration;
}

void OpenHeatMemory::add_to_last_step(const char* function_name, std::span<const double> flux, const HeatMotion& motion)
{
  require_size(fmt::format("{}: the flux", function_name).c_str(), flux, grid().size());
  for_each_lattice(flux,
                   [&](HeatMemory& memory, std::span<const double> given) { memory.add_to_last_step(given, motion); });
}

/// Converts the temperature rise to all conducting layers: beneath the layers of uniform thickness, heat is distributed in
/// proportion to the overlap. Fields of layers without new heat are empty.
std::vector<std::vector<double>> OpenHeatMemory::on_conducting_layers(std::span<const double> rise) const
{
  const std::size_t cells = grid().size(), given = rise.size() / cells;
  std::vector<std::vector<double>> of_layers(layers_->size());
  for (std::size_t k = 0; k < given; ++k)
  {
    const std::span<const double> field = rise.subspan(k * cells, cells);
    if (std::all_of(field.begin(), field.end(), [](double value) { return value == 0.0; }))
      continue;
    const double top = static_cast<double>(k) * heated_.thickness, bottom = top + heated_.thickness;
    const bool is_heated = k < layers_->heated();
    for (std::size_t j = is_heated ? k : layers_->layer_at(top);
         j < layers_->size() && (is_heated ? j == k : layers_->top(j) < bottom); ++j)
    {
      const double overlap = std::min(bottom, layers_->bottom(j)) - std::max(top, layers_->top(j));
      const double share = is_heated ? 1.0 : overlap / (layers_->bottom(j) - layers_->top(j));
      of_layers[j].resize(cells);
      for (std::size_t i = 0; i < cells; ++i)
        of_layers[j][i] += share * field[i];
    }
  }
  return of_layers;
}

void OpenHeatMemory::add_heat_in_body(const char* function_name, std::span<const double> rise, double duration)
{
  if (!layers_)
    throw InternalError(fmt::format("{}: no layers with heat sources are planned", function_name));
  require_step(function_name, duration);
  if (rise.size() % grid().size() != 0)
    throw InternalError(fmt::format("{}: {} values on {} cells", function_name, rise.size(), grid().size()));
  std::vector<std::vector<double>> of_layers = on_conducting_layers(rise);
  near_.add_heat_in_body(of_layers, duration);
  const LayeredConduction* layers = layers_.get();
  for (FartherImages& images : farther_)
  {
    if (images.lattices && images.lattices->layers.get() != layers)
    {
      of_layers = on_layers(*layers, of_layers, *images.lattices->layers);
      layers = images.lattices->layers.get();
    }
    for (std::vector<double>& layer : of_layers)
      if (!layer.empty())
        layer = images.cells.from_finer(layer);
    if (!images.lattices)
      continue;
    images.lattices->twice.add_heat_in_body(of_layers, duration);
    images.lattices->once.add_heat_in_body(of_layers, duration);
  }
}

void OpenHeatMemory::restore_heat_in_body()
{
  for (HeatMemory* memory : lattices())
    memory->restore_heat_in_body();
}

void OpenHeatMemory::add_temperature_of_body(std::span<double> temperature) const
{
  if (!layers_)
    return;
  Fields result = sum_of_images(
      1, 1.0, [](const HeatMemory& memory, double factor, Fields& sums) { memory.add_buried(factor, sums.front()); });
  near_.add_buried(1.0, result.front());
  for (std::size_t i = 0; i < temperature.size(); ++i)
    temperature[i] += result.front()[i];
}

std::vector<HeatMemory*> OpenHeatMemory::lattices()
{
  std::vector<HeatMemory*> all{&near_};
  for (FartherImages& images : farther_)
    if (images.lattices)
      for (HeatMemory* memory : {&images.lattices->twice, &images.lattices->once})
        all.push_back(memory);
  return all;
}

} // namespace brinell::halfspace
