// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace brinell
{

/// Call this before a fork. Only the thread that calls fork exists in the child process, where an OpenMP team would wait forever
/// for its missing threads. The function therefore ends the team of this thread; both processes create a new one when they next
/// compute.
void before_fork();

} // namespace brinell
