// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"

namespace brinell::contact
{

/// Name of a drive in cases, files and messages, and its unit: "load" in "N".
struct DriveText
{
  const char *name, *unit;
};

[[nodiscard]] DriveText text_of(Drive::Kind kind);

} // namespace brinell::contact
