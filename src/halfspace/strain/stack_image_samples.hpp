// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "image_samples.hpp"

namespace brinell::halfspace::images
{

/// The counterpart of `sampled` for a layered body.
[[nodiscard]] std::vector<double> sampled_in_layers(std::span<const WaveRow> rows, const std::vector<double>& depths,
                                                    const ElasticStack& stack);

} // namespace brinell::halfspace::images
