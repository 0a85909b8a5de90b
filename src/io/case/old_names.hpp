// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "raw_case.hpp"

/// Keys that had another name before: docs/user-guide.md, "Names that have changed". The table is `old_names()` of the schema.
namespace brinell::io
{

/// What stands under an old name in one layer of a case: its file, or one override.
struct GivenByOldName
{
  const OldName* name;
  Given given;
};

/// Puts what was given by old names under the new ones, as if it had been written so.
/// @param given  of one layer, of which `raw_case` has the rest already: both names in one layer are a problem
void take_old_names(const std::vector<GivenByOldName>& given, RawCase& raw_case, Problems& problems);

/// Lists by old names, of which each holds one member of a list of tables, must be of one length.
void check_old_lists(const RawCase& raw_case, Problems& problems);

} // namespace brinell::io
