// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/fatigue.hpp"
#include "case_reader.hpp"

#include <optional>
#include <string>
#include <vector>

namespace brinell::io
{

/// Keys of the fatigue of a material. @param material  its table, ends with a dot
[[nodiscard]] std::vector<Entry> fatigue_entries(const std::string& material);

/// Reads the fatigue constants; none without a criterion. Limits that do not fit become a problem.
/// @param table  ends with a dot
[[nodiscard]] std::optional<constitutive::Fatigue> read_fatigue(const CaseReader& reader, const std::string& table);

} // namespace brinell::io
