// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/device.hpp"

#include <memory>

namespace brinell::device
{

/// The processor in the part of a device: what a GPU computes, by the same kernels, one after the other. It proves runs without a GPU.
[[nodiscard]] std::shared_ptr<const elastoplastic::Device> host_device();

} // namespace brinell::device
