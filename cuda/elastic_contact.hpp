// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"
#include "brinell/halfspace/surface_compliance.hpp"

#include <memory>
#include <span>

/// Frictionless contact on a GPU. The header needs no CUDA.
namespace brinell::cuda
{

/// Contact of two surfaces: device::ElasticContact on the device that `open_device` has selected for this thread.
class ElasticContactOnDevice
{
public:
  /// @throws DeviceError
  ElasticContactOnDevice(const SurfaceGrid& grid, const halfspace::SurfaceCompliance::NormalSpectra& spectra);
  ~ElasticContactOnDevice();
  ElasticContactOnDevice(ElasticContactOnDevice&&) noexcept;
  ElasticContactOnDevice& operator=(ElasticContactOnDevice&&) noexcept;

  /// Solves as contact::ElasticContact::solve for an approach or a load. The fields lie in the memory of the processor.
  [[nodiscard]] contact::Report solve(std::span<const double> distance, const contact::Drive& drive, double tolerance,
                                      int max_iterations, std::span<double> pressure, std::span<double> gap);

private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

} // namespace brinell::cuda
