// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"

#include <fmt/format.h>

namespace brinell::simulation
{

/// The result of a function. An error of grids that became too small, whose floor knows no case, gets the member that makes them
/// larger.
template <typename Function>
auto naming_extent(const Function& function)
try
{
  return function();
}
catch (const GridError& error)
{
  throw GridError(fmt::format("{}; allowed: a larger `Numerics::extent`", error.what()));
}

} // namespace brinell::simulation
