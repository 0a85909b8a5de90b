// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace brinell
{

/// Call this before a fork. Only the thread that calls fork exists in the child process: there an OpenMP team would wait forever
/// for its missing threads, and a lock held by a thread that was planning a transform would never be released. The function
/// therefore ends the team of this thread (both processes create a new one when they next compute) and waits until no thread is
/// planning a transform.
void before_fork();
/// Call this after the fork, in both processes.
void after_fork();

} // namespace brinell
