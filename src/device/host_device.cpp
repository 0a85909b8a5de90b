// SPDX-License-Identifier: BSD-3-Clause
#include "host_device.hpp"

#include "body_on_executor.hpp"
#include "elastic_contact.hpp"
#include "host_executor.hpp"

#include <limits>

namespace brinell::device
{

namespace
{

class HostDevice : public elastoplastic::Device
{
public:
  [[nodiscard]] std::string name() const override { return "host"; }
  /// The plan compares the memory of the processor with what it needs.
  [[nodiscard]] double free_memory() const override { return std::numeric_limits<double>::infinity(); }
  [[nodiscard]] std::unique_ptr<elastoplastic::BodyOnDevice>
  make_body(const VolumeGrid& grid, const constitutive::Material& material, bool with_shears) const override
  {
    return std::make_unique<BodyOnExecutor<HostExecutor>>(grid, material, with_shears, executor_);
  }

  [[nodiscard]] std::unique_ptr<contact::ContactOnDevice>
  make_contact(const SurfaceGrid& grid, const halfspace::SurfaceCompliance::NormalSpectra& spectra) const override
  {
    return std::make_unique<ContactOnExecutor<HostExecutor>>(grid, spectra, executor_);
  }

private:
  HostExecutor executor_;
};

} // namespace

std::shared_ptr<const elastoplastic::Device> host_device()
{
  return std::make_shared<const HostDevice>();
}

} // namespace brinell::device
