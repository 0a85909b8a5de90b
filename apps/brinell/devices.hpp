// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace brinell::app
{

/// Offers the GPU to cases, if this program is linked with CUDA; to be called before any case is read.
void offer_devices();

} // namespace brinell::app
