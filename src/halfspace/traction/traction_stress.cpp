// SPDX-License-Identifier: BSD-3-Clause
#include "traction_stress.hpp"

#include "brinell/foundation/sym_tensor.hpp"
#include "foundation/lane_functions.hpp"
#include "stack_scales.hpp"
#include "traction_waves.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

namespace brinell::halfspace
{

namespace
{

/// Three-point Gauss-Legendre rule on [-1/2, 1/2]: the mean over a layer.
constexpr std::array<double, 3> point_of_layer{-0.38729833462074168852, 0.0, 0.38729833462074168852};
constexpr std::array<double, 3> weight_of_layer{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};

} // namespace

TractionStress::TractionStress(const VolumeGrid& grid, const ElasticStack& stack, const BlockedFft& fft,
                               Traction traction, const Portion& blocks)
    : grid_(grid), fft_(fft), traction_(traction), rows_(fft.py() / 2 + 1), blocks_(blocks),
      kernels_(static_cast<std::size_t>(blocks.count()) * static_cast<std::size_t>(grid.nz) * kernel_count *
               static_cast<std::size_t>(rows_))
{
  const PaddedFft padded(grid.surface, fft.px(), fft.py());
  std::optional<ExcessStress> excess;
  if (!stack.is_homogeneous() && !grid.surface.is_periodic())
    excess.emplace(grid, stack, traction);
#pragma omp parallel for schedule(dynamic)
  for (int layer = 0; layer < grid_.nz; ++layer)
    if (grid.surface.is_periodic())
      tabulate_waves(layer, stack, padded);
    else
      tabulate_cells(layer, stack, excess ? &*excess : nullptr, padded);
}

const Lanes* TractionStress::kernel(int block, int layer, int which) const
{
  const std::ptrdiff_t own = block - blocks_.first;
  return kernels_.data() + ((own * grid_.nz + layer) * kernel_count + which) * rows_;
}

void TractionStress::set(int row, int column, int layer, int which, double value)
{
  if (!blocks_.contains(column / lane_count))
    return;
  const std::ptrdiff_t at = kernel(column / lane_count, layer, which) + row - kernels_.data();
  reinterpret_cast<double*>(kernels_.data() + at)[column % lane_count] = value;
}

Parity TractionStress::parity(int which) const
{
  const Oddness odd = oddness(traction_, which);
  return {odd.x, odd.y};
}

namespace
{

double poisson_ratio_of(const ElasticStack& stack, const VolumeGrid& grid, int layer)
{
  return stack.at((layer + 0.5) * grid.dz).poisson_ratio;
}

void add_to(const Quadrant<SymTensor>& more, Quadrant<SymTensor>& sum)
{
  for (std::size_t n = 0; n < sum.values.size(); ++n)
    for (std::size_t c = 0; c < 6; ++c)
      sum.values[n][c] += more.values[n][c];
}

/// Adds to the mean over a layer of cells the stress of a unit traction on one cell in a part of it.
/// @param from, to  where the part begins and ends, in layers from the surface
void add_part(const VolumeGrid& grid, double from, double to, double poisson_ratio, Traction traction,
              Quadrant<SymTensor>& mean)
{
  for (std::size_t g = 0; g < point_of_layer.size(); ++g)
  {
    const Quadrant<SymTensor> part = cell_stress(
        grid.surface, (0.5 * (from + to) + point_of_layer[g] * (to - from)) * grid.dz, poisson_ratio, traction);
    for (std::size_t n = 0; n < mean.values.size(); ++n)
      for (std::size_t c = 0; c < 6; ++c)
        mean.values[n][c] += weight_of_layer[g] * (to - from) * part.values[n][c];
  }
}

/// Mean over a layer of cells, which may contain interfaces, of the stress of a unit traction on one cell of homogeneous bodies.
Quadrant<SymTensor> mean_over_layer(const VolumeGrid& grid, int layer, const ElasticStack& stack, Traction traction)
{
  Quadrant<SymTensor> mean(grid.surface);
  const std::vector<MaterialRange> ranges = materials_in(stack, layer * grid.dz, (layer + 1) * grid.dz);
  if (ranges.size() == 1)
    add_part(grid, layer, layer + 1, stack.of_layer(ranges.front().material).poisson_ratio, traction, mean);
  else
    for (const MaterialRange& range : ranges)
      add_part(grid, range.from / grid.dz, range.to / grid.dz, stack.of_layer(range.material).poisson_ratio, traction,
               mean);
  return mean;
}

} // namespace

void TractionStress::tabulate_cells(int layer, const ElasticStack& stack, const ExcessStress* excess,
                                    const PaddedFft& fft)
{
  Quadrant<SymTensor> response = mean_over_layer(grid_, layer, stack, traction_);
  if (excess != nullptr)
    add_to(excess->of_layer(layer), response);
  for (int which = 0; which < kernel_count; ++which)
    parity_spectrum(
        fft, parity(which),
        [&](int i, int j) { return kernel_values(response.at(i, j))[static_cast<std::size_t>(which)]; },
        [&](int row, int column, double value) { set(row, column, layer, which, value); });
}

void TractionStress::tabulate_waves(int layer, const ElasticStack& stack, const PaddedFft& fft)
{
  const double poisson_ratio = poisson_ratio_of(stack, grid_, layer);
  const auto wave_of = [&](double k, double m, double n)
  {
    if (k == 0.0)
      return uniform_stress(traction_, poisson_ratio);
    if (stack.is_homogeneous())
      return wave_stress(traction_, m / k, n / k, mean_decay(k * grid_.dz, layer), poisson_ratio);
    return stack_wave_stress(stack, traction_, k, m / k, n / k, layer * grid_.dz, (layer + 1) * grid_.dz);
  };
  for (int row = 0; row < rows_; ++row)
    for (int i = 0; i < fft.kx(); ++i)
    {
      const double m = fft.wavenumber_x(i);
      const double n = fft.wavenumber_y(row);
      const double k = std::hypot(m, n);
      const std::array<double, kernel_count> value = kernel_values(wave_of(k, m, n));
      // At the Nyquist wave an odd function cannot be represented on the grid.
      const bool shortest_x = 2 * i == fft.px(), shortest_y = 2 * row == fft.py();
      for (int which = 0; which < kernel_count; ++which)
      {
        const auto [odd_x, odd_y] = parity(which);
        const bool is_resolved = !(odd_x && shortest_x) && !(odd_y && shortest_y);
        set(row, i, layer, which, is_resolved ? value[static_cast<std::size_t>(which)] : 0.0);
      }
    }
}

namespace
{

/// Calls work(row, row of the stored numbers, whether the wavenumber along y is below 0).
template <typename Work>
void for_rows(int rows, const BlockedFft& fft, const Work& work)
{
  const int stored = fft.py() / 2 + 1;
  for (int row = 0; row < std::min(rows, stored); ++row)
    work(row, row, std::false_type{});
  for (int row = stored; row < rows; ++row)
    work(row, fft.folded(row), std::true_type{});
}

/// A kernel, the spectrum by which it is multiplied, and whether the kernel is odd in the wavenumber along y.
struct Source
{
  const Lanes* kernel = nullptr;
  const Lanes* next_kernel = nullptr; ///< to be fetched
  const ComplexLanes* values = nullptr;
  bool odd_y = false;

  template <bool is_below>
  [[nodiscard]] ComplexLanes at(int row, int stored, std::bool_constant<is_below> /*below*/) const
  {
    if (!is_below)
      fetch_soon(next_kernel + stored);
    const Lanes number = is_below && odd_y ? -kernel[stored] : kernel[stored];
    return number * values[row];
  }
};

/// @tparam parts  bit mask of the components of the traction that are not zero
template <unsigned parts>
void add_parts(const OfTraction<Source> sources, bool pressure_is_imaginary, int rows, const BlockedFft& fft,
               const ComplexLanes* stress, const ComplexLanes* next, ComplexLanes* total)
{
  const auto add_as = [&](auto is_imaginary)
  {
    for_rows(rows, fft,
             [&](int row, int stored, auto below)
             {
               fetch_soon(next + row);
               ComplexLanes sum = stress[row];
               const auto add_source = [&](std::size_t t, bool is_turned)
               {
                 const ComplexLanes part = sources[t].at(row, stored, below);
                 sum = sum + (is_turned ? times_i(part) : part);
               };
               if constexpr ((parts & 1U) != 0)
                 add_source(0, is_imaginary);
               if constexpr ((parts & 2U) != 0)
                 add_source(1, !is_imaginary);
               if constexpr ((parts & 4U) != 0)
                 add_source(2, !is_imaginary);
               total[row] = sum;
             });
  };
  pressure_is_imaginary ? add_as(std::true_type{}) : add_as(std::false_type{});
}

} // namespace

/// For each component of the stress, the kernels of both shears are imaginary if that of the pressure is real, and vice versa.
void TractionStress::add(const OfTraction<const TractionStress*>& kernels, int block, int component, int layer,
                         int rows, const OfTraction<const ComplexLanes*>& traction, const ComplexLanes* stress,
                         const ComplexLanes* next, ComplexLanes* total)
{
  const int next_block = next == stress ? block : block + 1;
  OfTraction<Source> sources;
  unsigned parts = 0;
  bool pressure_is_imaginary = false;
  const BlockedFft* fft = nullptr;
  for (std::size_t t = 0; t < kernels.size(); ++t)
    if (kernels[t] != nullptr)
    {
      const Parity parity = kernels[t]->parity(component);
      sources[t] = {kernels[t]->kernel(block, layer, component), kernels[t]->kernel(next_block, layer, component),
                    traction[t], parity.odd_y};
      parts |= 1U << t;
      pressure_is_imaginary = parity.is_imaginary() == (t == 0);
      fft = &kernels[t]->fft_;
    }
  const auto add_if = [&](auto which)
  {
    if (parts == which)
      add_parts<which>(sources, pressure_is_imaginary, rows, *fft, stress, next, total);
  };
  [&]<unsigned... which>(std::integer_sequence<unsigned, 0, which...> /*all*/)
  {
    (add_if(std::integral_constant<unsigned, which>{}), ...);
  }
  (std::make_integer_sequence<unsigned, 8>{});
}

void TractionStress::add_displacement(int block, int layer, int rows, const ComplexLanes* strain,
                                      ComplexLanes* displacement) const
{
  const double thickness = grid_.dz;
  const std::ptrdiff_t pitch = fft_.pitch();
  const Lanes* const k = kernel(block, layer, 0);
  const Lanes* const next = kernel(block, std::min(layer + 1, grid_.nz - 1), 0);
  std::array<double, Deviator::size> sign_below{};
  for (int c = 0; c < Deviator::size; ++c)
    sign_below[static_cast<std::size_t>(c)] = parity(c).odd_y ? -1.0 : 1.0;
  const auto add_as = [=, this](auto is_pressure)
  {
    for_rows(rows, fft_,
             [=, this](int row, int stored, auto below)
             {
               for (int c = 0; !below && c < Deviator::size; ++c)
                 fetch_soon(next + c * rows_ + stored);
               const auto times = [&](int c, const ComplexLanes& strain_of)
               {
                 const Lanes number = k[c * rows_ + stored];
                 return (below ? sign_below[static_cast<std::size_t>(c)] * number : number) * strain_of;
               };
               displacement[row] =
                   displacement[row] + thickness * betti_product(is_pressure, times, strain[xx * pitch + row],
                                                                 strain[yy * pitch + row], strain[yz * pitch + row],
                                                                 strain[xz * pitch + row], strain[xy * pitch + row]);
             });
  };
  traction_ == Traction::pressure ? add_as(std::true_type{}) : add_as(std::false_type{});
}

void TractionStress::add_displacement_by_dilatation(int block, int layer, int rows, const ComplexLanes* dilatation,
                                                    ComplexLanes* displacement) const
{
  const Lanes* const k = kernel(block, layer, trace);
  const Parity of_trace = parity(trace);
  const bool is_imaginary = of_trace.is_imaginary();
  for_rows(rows, fft_,
           [&](int row, int stored, auto below)
           {
             const Lanes number = below && of_trace.odd_y ? -k[stored] : k[stored];
             const ComplexLanes part = (grid_.dz * number) * dilatation[row];
             displacement[row] = displacement[row] + (is_imaginary ? -1.0 * times_i(part) : part);
           });
}

} // namespace brinell::halfspace
