// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/drive_text.hpp"

#include "brinell/foundation/error.hpp"

namespace brinell::contact
{

DriveText text_of(Drive::Kind kind)
{
  switch (kind)
  {
  case Drive::Kind::load:
    return {"load", "N"};
  case Drive::Kind::approach:
    return {"approach", "m"};
  case Drive::Kind::mean_gap:
    return {"mean_gap", "m"};
  }
  throw InternalError("a drive of no kind");
}

} // namespace brinell::contact
