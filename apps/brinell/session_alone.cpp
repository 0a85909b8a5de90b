// SPDX-License-Identifier: BSD-3-Clause
#include "session.hpp"

/// A program without MPI.
namespace brinell::app
{

Session::Session() : ranks_(std::make_shared<const Communicator>()) {}

Session::~Session() = default;

int Session::end(int code)
{
  return code;
}

} // namespace brinell::app
