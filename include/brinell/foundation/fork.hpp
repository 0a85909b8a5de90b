// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace brinell
{

/// Of a process that forks only the thread that does so lives on in the child: a team of OpenMP would wait for ever for the
/// others, and who was planning a transform would hold its lock for ever. To be called before a fork: ends the team of this
/// thread, which both processes make anew when they compute, and waits until nobody plans.
void before_fork();
/// After it, in both processes.
void after_fork();

} // namespace brinell
