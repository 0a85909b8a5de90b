// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/fork.hpp"

#include <omp.h>

namespace brinell
{

void before_fork()
{
  omp_pause_resource_all(omp_pause_soft);
}

} // namespace brinell
