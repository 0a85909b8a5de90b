// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/device.hpp"

#include <memory>

/// Bodies of a run on a GPU. The header needs no CUDA.
namespace brinell::cuda
{

/// @param number  of the GPU
/// @throws DeviceError
[[nodiscard]] std::shared_ptr<const elastoplastic::Device> cuda_device(int number = 0);

} // namespace brinell::cuda
