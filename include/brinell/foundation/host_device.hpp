// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Mark of functions that a CUDA thread may call, too: their text is the mathematics of both processors
/// (docs/developer/device.md). Empty unless CUDA's compiler reads it.
#if defined(__CUDACC__)
#define BRINELL_HOST_DEVICE __host__ __device__
#else
#define BRINELL_HOST_DEVICE
#endif
