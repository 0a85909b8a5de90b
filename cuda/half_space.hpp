// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/green/elastic.hpp"
#include "brinell/halfspace/surface_load.hpp"
#include "device/boundary_parts.hpp"

#include <memory>
#include <span>

/// The half space on a GPU. The header needs no CUDA.
namespace brinell::cuda
{

/// Plastic strain and load on the surface -> stress and displacement of a homogeneous half space, as halfspace::HalfSpace. Each call copies its fields to the device and back.
class HalfSpaceOnDevice
{
public:
  /// Uses the device that `open_device` has selected for this thread.
  /// @param boundary  device::boundary_of this body
  /// @throws DeviceError
  HalfSpaceOnDevice(const VolumeGrid& grid, const Elastic& elastic, const device::BoundaryParts& boundary);
  ~HalfSpaceOnDevice();
  HalfSpaceOnDevice(HalfSpaceOnDevice&&) noexcept;
  HalfSpaceOnDevice& operator=(HalfSpaceOnDevice&&) noexcept;

  /// Transforms the plastic strain [-], five components; empty: none.
  void load(std::span<const double> plastic_strain);
  /// Displacement of the surface [m] by the strain that was loaded; empty parts are not computed.
  void displacement(const halfspace::SurfaceDisplacement& out);
  /// Deviatoric stress [Pa] of the load and the strain that was loaded.
  void stress(const halfspace::SurfaceLoad& load, std::span<double> deviator);

private:
  struct Operators;
  std::unique_ptr<Operators> operators_;
};

} // namespace brinell::cuda
