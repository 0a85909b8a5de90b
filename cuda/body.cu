// SPDX-License-Identifier: BSD-3-Clause
#include "cuda/body.hpp"

#include "cuda/cuda_executor.cuh"
#include "cuda/device.hpp"
#include "device/body_on_executor.hpp"
#include "device/elastic_contact.hpp"

namespace brinell::cuda
{

namespace
{

class CudaDevice : public elastoplastic::Device
{
public:
  explicit CudaDevice(const cuda::Device& device)
      : name_(device.name), free_memory_(static_cast<double>(device.free_memory))
  {
  }

  [[nodiscard]] std::string name() const override { return name_; }
  [[nodiscard]] double free_memory() const override { return free_memory_; }
  [[nodiscard]] std::unique_ptr<elastoplastic::BodyOnDevice>
  make_body(const VolumeGrid& grid, const constitutive::Material& material, bool with_shears) const override
  {
    return std::make_unique<device::BodyOnExecutor<CudaExecutor>>(grid, material, with_shears, executor_);
  }

  [[nodiscard]] std::unique_ptr<contact::ContactOnDevice>
  make_contact(const SurfaceGrid& grid, const halfspace::SurfaceCompliance::NormalSpectra& spectra) const override
  {
    return std::make_unique<device::ContactOnExecutor<CudaExecutor>>(grid, spectra, executor_);
  }

private:
  std::string name_;
  double free_memory_;
  CudaExecutor executor_;
};

} // namespace

std::shared_ptr<const elastoplastic::Device> cuda_device(int number)
{
  return std::make_shared<const CudaDevice>(open_device(number));
}

} // namespace brinell::cuda
