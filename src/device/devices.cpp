// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/device/devices.hpp"

#include "brinell/foundation/error.hpp"
#include "host_device.hpp"

#include <array>
#include <utility>

namespace brinell::device
{

namespace
{

/// The way to the GPU of this program; empty: none.
Opening& cuda()
{
  static Opening open;
  return open;
}

} // namespace

void offer_cuda(Opening open)
{
  cuda() = std::move(open);
}

bool has_cuda()
{
  return static_cast<bool>(cuda());
}

std::string_view name_of(elastoplastic::DeviceChoice choice)
{
  constexpr std::array<std::string_view, 4> names{"cpu", "cuda", "auto", "host"}; // in the order of DeviceChoice
  return names.at(static_cast<std::size_t>(choice));
}

std::shared_ptr<const elastoplastic::Device> opened(elastoplastic::DeviceChoice choice)
{
  using elastoplastic::DeviceChoice;
  switch (choice)
  {
  case DeviceChoice::cpu:
    return nullptr;
  case DeviceChoice::host:
    return host_device();
  case DeviceChoice::automatic:
    if (has_cuda())
      try
      {
        return cuda()();
      }
      catch (const DeviceError&) // none there
      {
      }
    return nullptr;
  case DeviceChoice::cuda:
    break;
  }
  if (!has_cuda())
    throw InputError(
        "`Settings::device` = cuda, and this brinell has been built without CUDA; allowed: cpu or auto, or a brinell "
        "that is built with -D BRINELL_CUDA=ON and the compiler of CUDA 13 (docs/howto/gpu.md)");
  return cuda()();
}

} // namespace brinell::device
