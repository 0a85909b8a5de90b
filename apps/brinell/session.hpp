// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/communicator.hpp"

#include <memory>

namespace brinell::app
{

/// The processes that mpirun has started together, from the start of main to its end. There is one of it. In a program without MPI,
/// or that is started by itself, it is this process alone.
///
/// Only the first rank speaks: what others print is kept back, and shown only if a rank fails alone.
class Session
{
public:
  Session();
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  [[nodiscard]] const std::shared_ptr<const Communicator>& ranks() const { return ranks_; }
  /// Ends the session with the exit code of this process. If others do not end soon as well, because they wait for a process that
  /// has failed, all of them are ended with this code.
  int end(int code);

private:
  std::shared_ptr<const Communicator> ranks_;
  int shown_ = -1; ///< descriptor of stderr, if what is printed is kept back
};

} // namespace brinell::app
