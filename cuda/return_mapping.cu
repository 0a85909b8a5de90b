// SPDX-License-Identifier: BSD-3-Clause
#include "cuda/return_mapping.hpp"

#include "brinell/foundation/error.hpp"
#include "cuda/cuda_executor.cuh"
#include "device/return_mapping.hpp"

#include <string>

namespace brinell::cuda
{

struct ReturnMappingOnDevice::Fields
{
  CudaExecutor executor;
  device::ReturnMapping<CudaExecutor> mapping;
  std::size_t cells;
  DeviceMemory<double> start, trial, equivalent, strain, increment, dissipation, backstress;

  Fields(const constitutive::HardeningLaw& law, constitutive::Integration integration, std::size_t count,
         std::span<const constitutive::KinematicTerm> terms)
      : mapping(law, integration, executor, terms), cells(count), start(Deviator::size * count),
        trial(Deviator::size * count), equivalent(count), strain(Deviator::size * count), increment(count),
        dissipation(count), backstress(terms.size() * Deviator::size * count)
  {
  }
};

ReturnMappingOnDevice::ReturnMappingOnDevice(const constitutive::HardeningLaw& law,
                                             constitutive::Integration integration, std::size_t cells,
                                             std::span<const constitutive::KinematicTerm> terms)
    : fields_(std::make_unique<Fields>(law, integration, cells, terms))
{
}
ReturnMappingOnDevice::~ReturnMappingOnDevice() = default;
ReturnMappingOnDevice::ReturnMappingOnDevice(ReturnMappingOnDevice&&) noexcept = default;
ReturnMappingOnDevice& ReturnMappingOnDevice::operator=(ReturnMappingOnDevice&&) noexcept = default;

void ReturnMappingOnDevice::flow(const Before& before, double stiffness, const Flow& out)
{
  Fields& on = *fields_;
  const auto require_size = [](std::size_t size, std::size_t wanted)
  {
    if (size != wanted)
      throw InternalError("ReturnMappingOnDevice: a field has " + std::to_string(size) + " values instead of " +
                          std::to_string(wanted));
  };
  const auto write = [&](std::span<const double> from, DeviceMemory<double>& to)
  {
    require_size(from.size(), to.size());
    on.executor.write(from, to);
  };
  const auto read = [&](const DeviceMemory<double>& from, std::span<double> to)
  {
    require_size(to.size(), from.size());
    on.executor.read(from, to);
  };
  write(before.start, on.start);
  write(before.trial, on.trial);
  write(before.equivalent, on.equivalent);
  write(out.backstress, on.backstress);
  on.mapping.flow({.cells = on.cells,
                   .cells_of_layer = on.cells,
                   .stiffness = stiffness,
                   .start = on.start.data(),
                   .trial = on.trial.data(),
                   .equivalent = on.equivalent.data(),
                   .backstress = on.backstress.data(),
                   .strain = on.strain.data(),
                   .increment = on.increment.data(),
                   .dissipation = on.dissipation.data()});
  read(on.strain, out.strain);
  read(on.increment, out.increment);
  read(on.dissipation, out.dissipation);
  read(on.backstress, out.backstress);
}

} // namespace brinell::cuda
