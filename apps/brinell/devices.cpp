// SPDX-License-Identifier: BSD-3-Clause
#include "devices.hpp"

#ifdef BRINELL_HAS_CUDA
#include "brinell/device/devices.hpp"
#include "cuda/body.hpp"
#endif

namespace brinell::app
{

void offer_devices()
{
#ifdef BRINELL_HAS_CUDA
  device::offer_cuda([] { return cuda::cuda_device(); });
#endif
}

} // namespace brinell::app
