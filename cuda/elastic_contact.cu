// SPDX-License-Identifier: BSD-3-Clause
#include "cuda/elastic_contact.hpp"

#include "cuda/cuda_executor.cuh"
#include "device/elastic_contact.hpp"

namespace brinell::cuda
{

struct ElasticContactOnDevice::Solver
{
  CudaExecutor executor;
  device::ElasticContact<CudaExecutor> contact;

  Solver(const SurfaceGrid& grid, const halfspace::SurfaceCompliance::NormalSpectra& spectra)
      : contact(grid, spectra, executor)
  {
  }
};

ElasticContactOnDevice::ElasticContactOnDevice(const SurfaceGrid& grid,
                                               const halfspace::SurfaceCompliance::NormalSpectra& spectra)
    : solver_(std::make_unique<Solver>(grid, spectra))
{
}
ElasticContactOnDevice::~ElasticContactOnDevice() = default;
ElasticContactOnDevice::ElasticContactOnDevice(ElasticContactOnDevice&&) noexcept = default;
ElasticContactOnDevice& ElasticContactOnDevice::operator=(ElasticContactOnDevice&&) noexcept = default;

contact::Report ElasticContactOnDevice::solve(std::span<const double> distance, const contact::Drive& drive,
                                              double tolerance, int max_iterations, std::span<double> pressure,
                                              std::span<double> gap)
{
  return solver_->contact.solve(distance, drive, tolerance, max_iterations, pressure, gap);
}

} // namespace brinell::cuda
