// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace brinell::test
{

/// The call is refused at the door, with a message that holds both sizes.
template <typename Call>
void expect_refused(const std::string& what, std::size_t size, std::size_t expected, const Call& call)
{
  const std::string message =
      what + " has " + std::to_string(size) + " values, its grid asks for " + std::to_string(expected);
  try
  {
    call();
    ADD_FAILURE() << "not refused: " << message;
  }
  catch (const InternalError& error)
  {
    EXPECT_EQ(error.what(), message);
  }
}

} // namespace brinell::test
