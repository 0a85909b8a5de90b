// SPDX-License-Identifier: BSD-3-Clause
#include "case_reader.hpp"

/// What a case says of wear.
namespace brinell::io
{

void warn_of_wear(const elastoplastic::WearLaw& wear, Case& c)
{
  constexpr double most = 1e-9; // [1/Pa], 1 mm^3/(N m): a thousand times what soft metals lose
  for (const auto& [key, value] :
       {std::pair{"interface.wear.lower", wear.lower}, std::pair{"interface.wear.upper", wear.upper}})
    if (value > most)
      warn(c, "unusual_wear",
           "{} is {:.4g} 1/Pa, more than any solid loses; is the unit right? "
           "Text carries it: \"{:.4g} mm^3/(N m)\"",
           key, value, value);
}

} // namespace brinell::io
