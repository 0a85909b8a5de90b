// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/communicator.hpp"

#include <nanobind/nanobind.h>

#include <memory>

namespace brinell::python
{

/// Ranks of a communicator of mpi4py, which passes numbers where they lie. So this extension needs MPI neither when it is compiled
/// nor without mpi4py when it runs. An error of MPI ends all ranks, as in the program.
/// @param comm  used by nothing else meanwhile; None: this process alone, and the result is nullptr
[[nodiscard]] std::shared_ptr<const Communicator> ranks_of(const nanobind::object& comm);

} // namespace brinell::python
