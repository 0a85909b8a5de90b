// SPDX-License-Identifier: BSD-3-Clause
#include "cuda/half_space.hpp"

#include "brinell/foundation/error.hpp"
#include "cuda/cuda_executor.cuh"
#include "device/half_space.hpp"

#include <array>
#include <string>

namespace brinell::cuda
{

struct HalfSpaceOnDevice::Operators
{
  CudaExecutor executor;
  device::HalfSpace<CudaExecutor> half_space;
  device::HalfSpace<CudaExecutor>::Work work;
  DeviceMemory<double> strain, stress, surface;
  std::array<DeviceMemory<double>, 3> tractions;
  bool has_strain = false;

  Operators(const VolumeGrid& grid, const Elastic& elastic, const device::BoundaryParts& boundary)
      : half_space(grid, elastic, boundary, executor), work(half_space.make_work()),
        strain(Deviator::size * grid.size()), stress(Deviator::size * grid.size()), surface(grid.surface.size())
  {
    for (DeviceMemory<double>& traction : tractions)
      traction = DeviceMemory<double>(grid.surface.size());
  }
};

HalfSpaceOnDevice::HalfSpaceOnDevice(const VolumeGrid& grid, const Elastic& elastic,
                                     const device::BoundaryParts& boundary)
    : operators_(std::make_unique<Operators>(grid, elastic, boundary))
{
}
HalfSpaceOnDevice::~HalfSpaceOnDevice() = default;
HalfSpaceOnDevice::HalfSpaceOnDevice(HalfSpaceOnDevice&&) noexcept = default;
HalfSpaceOnDevice& HalfSpaceOnDevice::operator=(HalfSpaceOnDevice&&) noexcept = default;

namespace
{

void require_size(const char* field, std::size_t size, std::size_t wanted)
{
  if (size != wanted)
    throw InternalError("HalfSpaceOnDevice: " + std::string(field) + " has " + std::to_string(size) +
                        " values instead of " + std::to_string(wanted));
}

} // namespace

void HalfSpaceOnDevice::load(std::span<const double> plastic_strain)
{
  Operators& on = *operators_;
  on.has_strain = !plastic_strain.empty();
  if (on.has_strain)
  {
    require_size("the plastic strain", plastic_strain.size(), on.strain.size());
    on.executor.write(plastic_strain, on.strain);
  }
  on.half_space.load(on.has_strain ? on.strain.data() : nullptr, on.work);
}

void HalfSpaceOnDevice::displacement(const halfspace::SurfaceDisplacement& out)
{
  Operators& on = *operators_;
  const std::array<std::pair<Traction, std::span<double>>, 3> parts{
      {{Traction::pressure, out.z}, {Traction::shear_x, out.x}, {Traction::shear_y, out.y}}};
  for (const auto& [along, to] : parts)
    if (!to.empty())
    {
      require_size("a displacement", to.size(), on.surface.size());
      on.half_space.displacement(along, on.work, on.surface.data());
      on.executor.read(on.surface, to);
    }
}

void HalfSpaceOnDevice::stress(const halfspace::SurfaceLoad& load, std::span<double> deviator)
{
  Operators& on = *operators_;
  require_size("the stress", deviator.size(), on.stress.size());
  if (!load.heat.empty())
    throw InternalError("HalfSpaceOnDevice: heat is no load of this operator");
  const std::array<std::span<const double>, 3> parts{load.pressure, load.shear_x, load.shear_y};
  std::array<const double*, 3> fields{};
  for (std::size_t t = 0; t < parts.size(); ++t)
    if (!parts[t].empty())
    {
      require_size("a load", parts[t].size(), on.surface.size());
      on.executor.write(parts[t], on.tractions[t]);
      fields[t] = on.tractions[t].data();
    }
  on.half_space.stress({fields[0], fields[1], fields[2]}, on.has_strain ? on.strain.data() : nullptr, on.work,
                       on.stress.data());
  on.executor.read(on.stress, deviator);
}

} // namespace brinell::cuda
