// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

/// Which instructions of the processor the engine uses. A build for many machines holds everything that computes several times,
/// compiled for several kinds of processor, and chooses when the program is loaded: the fastest kind that the processor has,
/// or what the environment variable BRINELL_PROCESSOR says. A build for one kind (BRINELL_ARCH of CMake) has no choice.
namespace brinell
{

/// Kinds of processor that the engine is compiled for, from the slowest to the fastest, by the compiler's names: x86-64,
/// x86-64-v3 (AVX2), x86-64-v4 (AVX-512); or the single one, such as native.
[[nodiscard]] std::vector<std::string> compiled_processors();

/// The kind that is used.
[[nodiscard]] std::string chosen_processor();

/// Must be called before the first computation.
/// @throws InputError BRINELL_PROCESSOR names a kind that was not compiled or that this processor is not
void require_processor_choice();

} // namespace brinell
