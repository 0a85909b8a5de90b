// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"

#include <cstddef>
#include <string>

/// Access to a GPU. The header needs no CUDA.
namespace brinell::cuda
{

struct Device
{
  int number = 0;
  std::string name;
  int major = 0, minor = 0;                ///< compute capability
  std::size_t memory = 0, free_memory = 0; ///< [bytes]
};

/// Selects a device for this thread and has it compute something, because code that was compiled for other devices may end
/// without having done anything.
/// @throws DeviceError
Device open_device(int number = 0);

} // namespace brinell::cuda
