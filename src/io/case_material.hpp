// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/io/case_file.hpp"
#include "problems.hpp"
#include "raw_case.hpp"

#include <string>

namespace brinell::io
{

/// Puts the points of a table of plastic strain and stress that lies in a file of its own into `values`, so that the
/// resolved case stands for itself. Nothing if the material of `body` has no such file.
/// @param body  "lower" or "upper"
void load_hardening_file(CaseValues& values, const RawCase& raw, const std::string& body, Problems& problems);

/// Material of one body; a law that cannot be made is a problem, at the place of the key.
[[nodiscard]] constitutive::Material material(const CaseValues& values, const RawCase& raw, const std::string& body,
                                              Problems& problems);

} // namespace brinell::io
