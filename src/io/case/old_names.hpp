// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "raw_case.hpp"

/// Keys that had another name before: docs/user-guide.md, "Names that have changed". The table is `old_names()` of the schema.
namespace brinell::io
{

/// Stores a value that was given by an old name under the new name, and adds a warning. Both names in one layer, the file or one
/// override, are a problem. This is detected only here, because keys are read in alphabetical order, in which the new name of
/// each pair comes first.
void take_old_name(const OldName& name, Given given, RawCase& raw_case, Problems& problems);

/// Checks that a list given by an old name, which holds one member of the tables of a list, has one entry per table.
void check_old_lists(const RawCase& raw_case, Problems& problems);

} // namespace brinell::io
