// SPDX-License-Identifier: BSD-3-Clause
#include "dilatation_stress.hpp"

#include "foundation/lane_functions.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <omp.h>

namespace brinell::halfspace
{

using layer_waves::Factors;
using layer_waves::Field;
using layer_waves::Wave;

DilatationStress::DilatationStress(const VolumeGrid& grid, const Elastic& elastic, const BlockedFft& fft,
                                   const layer_waves::Shortest& shortest)
    : grid_(grid), nu_(elastic.poisson_ratio), mu_(elastic.shear_modulus()), fft_(fft),
      strain_fft_(grid.surface, fft.px(), fft.py(), grid.nz),
      stress_fft_(grid.surface, fft.px(), fft.py(), stresses * grid.nz),
      image_correction_(grid, ElasticStack{{}, elastic}, fft, images::Source::dilatation)
{
  const int rows = fft.py() / 2 + 1;
  factors_.resize(static_cast<std::size_t>(fft.blocks() * rows));
  for (int i = 0; i < fft.kx(); ++i)
    for (int row = 0; row < rows; ++row)
    {
      const double m = 2.0 * std::numbers::pi * i / (fft.px() * grid.surface.dx);
      const double n = 2.0 * std::numbers::pi * row / (fft.py() * grid.surface.dy);
      factors_[static_cast<std::size_t>(i / lane_count * rows + row)].set(
          static_cast<std::size_t>(i % lane_count), m, n, 2 * i == fft.px() ? std::sqrt(shortest.x) : 1.0,
          2 * row == fft.py() ? std::sqrt(shortest.y) : 1.0, grid.dz, nu_, mu_);
    }
}

DilatationStress::Work DilatationStress::make_work() const
{
  Work work;
  const auto pitch = static_cast<std::size_t>(fft_.pitch());
  const auto layers = static_cast<std::size_t>(grid_.nz);
  work.threads.reserve(static_cast<std::size_t>(omp_get_max_threads()));
  for (int thread = 0; thread < omp_get_max_threads(); ++thread)
    work.threads.push_back({stress_fft_.make_scratch(), AlignedVector<ComplexLanes>(layers * pitch),
                            AlignedVector<ComplexLanes>(layers), AlignedVector<ComplexLanes>(layers * stresses * pitch),
                            AlignedVector<ComplexLanes>(pitch)});
  work.strain.resize(strain_fft_.rows_size());
  work.stress.resize(stress_fft_.rows_size());
  work.images = image_correction_.make_response();
  return work;
}

int DilatationStress::strained_layers(std::span<const double> dilatation) const
{
  const std::size_t cells = grid_.surface.size();
  int strained = grid_.nz;
  const auto is_zero = [&](int layer)
  {
    const auto of_layer =
        dilatation.subspan(static_cast<std::size_t>(layer) * cells, grid_.surface.independent_cells());
    return std::all_of(of_layer.begin(), of_layer.end(), [](double e) { return e == 0.0; });
  };
  while (strained > 0 && is_zero(strained - 1))
    --strained;
  return strained;
}

/// Transforms the layers along x, and finds their moments for the images.
void DilatationStress::transform(std::span<const double> dilatation, int strained, Work& work) const
{
  const SurfaceGrid& s = grid_.surface;
#pragma omp parallel for schedule(static)
  for (int layer = 0; layer < strained; ++layer)
  {
    const double* field = dilatation.data() + static_cast<std::size_t>(layer) * s.size();
    image_correction_.find_moments_of_layer(field, used_cells(field, s.nx, s.independent_rows()), 0, layer,
                                            work.images);
    strain_fft_.rows_forward(field, layer, work.strain.data(),
                             work.threads[static_cast<std::size_t>(omp_get_thread_num())].fft);
  }
}

/// All layers at one wavenumber along y: the waves from below on the way up, those of the surface and from above on the way down.
void DilatationStress::go_through(const Factors& f, int row, int strained, int layers, Work::Thread& thread) const
{
  const std::ptrdiff_t pitch = fft_.pitch();
  const double emitted = 2.0 * (1.0 + nu_);
  const auto strain = [&](int layer) { return emitted * thread.strain[static_cast<std::size_t>(layer * pitch + row)]; };
  ComplexLanes up;
  for (int layer = strained - 1; layer >= 0; --layer)
  {
    thread.below[static_cast<std::size_t>(layer)] = f.e0 * up;
    up = f.q * up + strain(layer);
  }
  Wave down = from_boundary(f, green::SheetWave<ComplexLanes>{-1.0 * up, 2.0 * up, {}});
  for (int layer = 0; layer < layers; ++layer)
  {
    Field s = emit(f, down);
    pass(f, down);
    if (layer < strained)
    {
      const ComplexLanes own = strain(layer), below = thread.below[static_cast<std::size_t>(layer)];
      const ComplexLanes held = f.m0 * own;
      s.ll = s.ll + below + held;
      s.zz = s.zz - below - held;
      s.lz = s.lz - below;
      down.a = down.a + own;
    }
    const auto axes = green::in_axes<Lanes>(f, nu_, s.ll, s.zz, times_i(s.lz), ComplexLanes{}, ComplexLanes{});
    ComplexLanes* to = thread.stress.data() + layer * stresses * pitch + row;
    for (const ComplexLanes& component : {axes.xx, axes.yy, axes.yz, axes.xz, axes.xy, axes.trace})
    {
      *to = component;
      to += pitch;
    }
  }
}

void DilatationStress::process(int block, int strained, int layers, const Kernels& kernels, Work& work,
                               Work::Thread& thread) const
{
  const std::ptrdiff_t pitch = fft_.pitch();
  const int rows = fft_.waves_along_y(), stored = fft_.py() / 2 + 1;
  for (int layer = 0; layer < strained; ++layer)
    strain_fft_.columns_forward(work.strain.data(), block, layer, thread.strain.data() + layer * pitch, thread.fft);
  for (std::size_t t = 0; t < kernels.size(); ++t)
    if (kernels[t] != nullptr)
    {
      std::fill(thread.column.begin(), thread.column.end(), ComplexLanes{});
      for (int layer = 0; layer < strained; ++layer)
        kernels[t]->add_displacement_by_dilatation(block, layer, rows, thread.strain.data() + layer * pitch,
                                                   thread.column.data());
      fft_.columns_inverse(thread.column.data(), block, 0, work.displacement[t].data(), thread.fft,
                           t == static_cast<std::size_t>(Traction::shear_y));
    }
  if (layers == 0)
    return;
  for (int row = 0; row < rows; ++row)
  {
    const Factors& stored_factors = factors_[static_cast<std::size_t>(block * stored + fft_.folded(row))];
    if (row < stored)
    {
      go_through(stored_factors, row, strained, layers, thread);
      continue;
    }
    Factors opposite = stored_factors;
    opposite.ly = -opposite.ly;
    opposite.lxly = -opposite.lxly;
    go_through(opposite, row, strained, layers, thread);
  }
  for (int plane = 0; plane < stresses * layers; ++plane)
  {
    const int component = plane % stresses;
    stress_fft_.columns_inverse(thread.stress.data() + plane * pitch, block, plane, work.stress.data(), thread.fft,
                                component < Deviator::size && is_odd_in_y(component));
  }
}

/// Transforms the stress along x, and adds it with that of the cells held in their plane and without that of the images.
void DilatationStress::invert(std::span<const double> dilatation, int layers, std::span<double> deviator,
                              std::span<double> trace, Work& work) const
{
  const SurfaceGrid& s = grid_.surface;
  const double held = -2.0 * mu_ * (1.0 + nu_) / (1.0 - nu_);
#pragma omp parallel
  {
    std::vector<double> field(s.size());
#pragma omp for schedule(static)
    for (int plane = 0; plane < stresses * layers; ++plane)
    {
      const int component = plane % stresses, layer = plane / stresses;
      const bool is_trace = component == Deviator::size;
      const std::span<double> out = is_trace ? trace : deviator;
      if (out.empty())
        continue;
      stress_fft_.rows_inverse(work.stress.data(), plane, field.data(),
                               work.threads[static_cast<std::size_t>(omp_get_thread_num())].fft);
      image_correction_.subtract(work.images, component, layer, field.data());
      const double local = is_trace                                                 ? 2.0 * held
                           : component == Deviator::xx || component == Deviator::yy ? held / 3.0
                                                                                    : 0.0;
      const double* e = dilatation.data() + static_cast<std::size_t>(layer) * s.size();
      double* to = out.data() + (is_trace ? 0 : static_cast<std::size_t>(component) * grid_.size()) +
                   static_cast<std::size_t>(layer) * s.size();
      for (std::size_t i = 0; i < s.independent_cells(); ++i)
        to[i] += field[i] + local * e[i];
    }
  }
}

void DilatationStress::add(std::span<const double> dilatation, int layers, const Kernels& kernels,
                           std::span<double> deviator, std::span<double> trace,
                           const OfTraction<std::span<double>>& displacement, Work& work) const
{
  const int strained = strained_layers(dilatation);
  if (strained == 0)
    return;
  const int wanted = deviator.empty() && trace.empty() ? 0 : layers;
  for (std::size_t t = 0; t < kernels.size(); ++t)
    if (kernels[t] != nullptr)
      work.displacement[t].resize(fft_.rows_size());
  transform(dilatation, strained, work);
  if (wanted > 0)
    image_correction_.respond(strained, work.images, true);
#pragma omp parallel for schedule(static)
  for (int block = 0; block < fft_.blocks(); ++block)
    process(block, strained, wanted, kernels, work, work.threads[static_cast<std::size_t>(omp_get_thread_num())]);
  if (wanted > 0)
    invert(dilatation, wanted, deviator, trace, work);
  std::vector<double> field(grid_.surface.size());
  for (std::size_t t = 0; t < kernels.size(); ++t)
    if (kernels[t] != nullptr)
    {
      fft_.rows_inverse(work.displacement[t].data(), 0, field.data(), work.threads.front().fft);
      for (std::size_t i = 0; i < grid_.surface.independent_cells(); ++i)
        displacement[t][i] += field[i];
    }
}

} // namespace brinell::halfspace
