// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/half_space.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>

namespace brinell::halfspace
{

HalfSpace::HalfSpace(const VolumeGrid& grid, const Elastic& elastic)
    : grid_(grid), elastic_(elastic), fft_(std::make_unique<PaddedFft>(grid.surface)),
      pressure_stress_(grid, elastic.poisson_ratio, *fft_), eigenstrain_stress_(grid, elastic, *fft_),
      image_correction_(grid, elastic, *fft_)
{
}

HalfSpace::Work HalfSpace::make_work() const
{
  const std::size_t planes = static_cast<std::size_t>(grid_.nz) * fft_->plane();
  Work work;
  work.strain_hat.resize(Deviator::size * planes);
  work.stress_hat.resize(Deviator::size * planes);
  work.pressure_hat.resize(fft_->plane());
  work.scratch.resize(fft_->scratch_size());
  return work;
}

void HalfSpace::load_strain(std::span<const double> plastic_strain, int layers, Work& work) const
{
  if (plastic_strain.size() != Deviator::size * grid_.size())
    throw InternalError("HalfSpace::load_strain: the strain does not have 5 values per cell");
  const std::size_t cells = grid_.surface.size();
#pragma omp parallel
  {
    AlignedVector<double> scratch(fft_->scratch_size());
#pragma omp for collapse(2) schedule(static)
    for (int component = 0; component < Deviator::size; ++component)
      for (int layer = 0; layer < layers; ++layer)
      {
        const auto plane = static_cast<std::size_t>(component * grid_.nz + layer);
        fft_->forward(plastic_strain.data() + plane * cells, work.strain_hat.data() + plane * fft_->plane(), scratch);
      }
  }
}

void HalfSpace::residual_displacement(int layers, Work& work, std::span<double> displacement) const
{
  pressure_stress_.displacement(work.strain_hat.data(), work.pressure_hat.data(), layers);
  fft_->inverse(work.pressure_hat.data(), displacement.data(), work.scratch);
}

void HalfSpace::deviatoric_stress(std::span<const double> pressure, std::span<const double> plastic_strain, int layers,
                                  Work& work, std::span<double> stress) const
{
  eigenstrain_stress_.apply(work.strain_hat.data(), work.stress_hat.data(), layers);
  fft_->forward(pressure.data(), work.pressure_hat.data(), work.scratch);
  pressure_stress_.add_deviator(work.pressure_hat.data(), work.stress_hat.data(), layers);
  finish(plastic_strain, layers, work, stress);
}

void HalfSpace::full_stress(std::span<const double> pressure, std::span<const double> plastic_strain, Work& work,
                            std::span<double> deviator, std::span<double> trace) const
{
  const std::size_t cells = grid_.surface.size();
  AlignedVector<Complex> residual_trace(static_cast<std::size_t>(grid_.nz) * fft_->plane());
  AlignedVector<Complex> contact_trace(residual_trace.size());
  load_strain(plastic_strain, grid_.nz, work);
  eigenstrain_stress_.apply(work.strain_hat.data(), work.stress_hat.data(), grid_.nz, residual_trace.data());
  fft_->forward(pressure.data(), work.pressure_hat.data(), work.scratch);
  pressure_stress_.trace(work.pressure_hat.data(), contact_trace.data());
  for (int layer = 0; layer < grid_.nz; ++layer)
  {
    const auto at = static_cast<std::size_t>(layer) * fft_->plane();
    for (std::size_t i = 0; i < fft_->plane(); ++i)
      residual_trace[at + i] += contact_trace[at + i];
    fft_->inverse(residual_trace.data() + at, trace.data() + static_cast<std::size_t>(layer) * cells, work.scratch);
  }
  pressure_stress_.add_deviator(work.pressure_hat.data(), work.stress_hat.data(), grid_.nz);
  finish(plastic_strain, grid_.nz, work, deviator, trace);
  const std::size_t n = grid_.size();
  for (std::size_t i = 0; i < n; ++i)
    trace[i] += eigenstrain_stress_.local_trace({{plastic_strain[i], plastic_strain[n + i], 0.0, 0.0, 0.0}});
}

/// Back to real space, plus the local part of the residual stress, less the stress of the periodic images.
void HalfSpace::finish(std::span<const double> plastic_strain, int layers, Work& work, std::span<double> stress,
                       std::span<double> trace) const
{
  const std::size_t cells = grid_.surface.size();
#pragma omp parallel
  {
    AlignedVector<double> scratch(fft_->scratch_size());
#pragma omp for collapse(2) schedule(static)
    for (int component = 0; component < Deviator::size; ++component)
      for (int layer = 0; layer < layers; ++layer)
      {
        const auto plane = static_cast<std::size_t>(component * grid_.nz + layer);
        fft_->inverse(work.stress_hat.data() + plane * fft_->plane(), stress.data() + plane * cells, scratch);
      }
  }
  const std::size_t n = grid_.size();
  const auto used = static_cast<std::size_t>(layers) * cells;
#pragma omp parallel for simd schedule(static)
  for (std::size_t i = 0; i < used; ++i)
  {
    Deviator e;
    for (int c = 0; c < Deviator::size; ++c)
      e[c] = plastic_strain[static_cast<std::size_t>(c) * n + i];
    const Deviator s = eigenstrain_stress_.local_stress(e);
    for (int c = 0; c < Deviator::size; ++c)
      stress[static_cast<std::size_t>(c) * n + i] += s[c];
  }
  image_correction_.subtract(plastic_strain, layers, stress, trace);
}

} // namespace brinell::halfspace
