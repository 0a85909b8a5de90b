// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cuda_runtime.h>
#include <string>

/// Checks of what the CUDA runtime answers; for sources that are compiled with CUDA.
namespace brinell::cuda
{

/// Cause of an error in words, with what to do about it.
std::string cause_of(cudaError_t error);

/// @param action  what was tried, as in "copy to the device"
/// @throws DeviceError
void check(cudaError_t error, const char* action);

/// Checks whether the kernel that was called last could begin. Errors in its course are found by the next call that waits for it.
/// @throws DeviceError
void check_launch(const char* kernel);

} // namespace brinell::cuda
