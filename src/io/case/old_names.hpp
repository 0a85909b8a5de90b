// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "raw_case.hpp"

/// Keys that had another name before: docs/user-guide.md, "Names that have changed". The table is `old_names()` of the schema.
namespace brinell::io
{

/// Puts what was given by an old name under the new one, as if it had been written so. Both names in one layer, the file or one
/// override, are a problem: keys are taken in the order of the alphabet, in which the new name comes first.
void take_old_name(const OldName& name, Given given, RawCase& raw_case, Problems& problems);

/// Lists by old names, of which each holds one member of a list of tables, must be of one length.
void check_old_lists(const RawCase& raw_case, Problems& problems);

} // namespace brinell::io
