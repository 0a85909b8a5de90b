// SPDX-License-Identifier: BSD-3-Clause
#include "mpi_communicator.hpp"

#include "brinell/foundation/error.hpp"

#include <limits>
#include <vector>

namespace brinell::app
{

namespace
{

/// MPI counts in `int`.
int as_int(std::size_t count)
{
  if (count > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw InputError(
        "more numbers would pass between two ranks at once than MPI can count, 2^31; allowed: more ranks, or a "
        "smaller grid");
  return static_cast<int>(count);
}

/// Numbers of values by rank, and where they begin.
struct Parts
{
  std::vector<int> counts, first;

  explicit Parts(std::span<const std::size_t> values)
  {
    std::size_t next = 0;
    for (const std::size_t count : values)
    {
      counts.push_back(as_int(count));
      first.push_back(as_int(next));
      next += count;
    }
  }
};

} // namespace

MpiCommunicator::MpiCommunicator(MPI_Comm group)
{
  MPI_Comm_dup(group, &group_);
  MPI_Comm_rank(group_, &rank_);
  MPI_Comm_size(group_, &size_);
}

MpiCommunicator::~MpiCommunicator()
{
  int is_finalized = 0;
  MPI_Finalized(&is_finalized);
  if (is_finalized == 0)
    MPI_Comm_free(&group_);
}

void MpiCommunicator::all_to_all(std::span<const double> send, std::span<const std::size_t> sent,
                                 std::span<double> receive, std::span<const std::size_t> received) const
{
  const Parts to(sent), from(received);
  MPI_Alltoallv(send.data(), to.counts.data(), to.first.data(), MPI_DOUBLE, receive.data(), from.counts.data(),
                from.first.data(), MPI_DOUBLE, group_);
}

void MpiCommunicator::all_gather(std::span<const double> own, std::span<const std::size_t> counts,
                                 std::span<double> all) const
{
  const Parts from(counts);
  MPI_Allgatherv(own.data(), as_int(own.size()), MPI_DOUBLE, all.data(), from.counts.data(), from.first.data(),
                 MPI_DOUBLE, group_);
}

void MpiCommunicator::broadcast(std::span<double> values, int from) const
{
  MPI_Bcast(values.data(), as_int(values.size()), MPI_DOUBLE, from, group_);
}

void MpiCommunicator::gather(std::span<const double> own, std::span<const std::size_t> counts,
                             std::span<double> all) const
{
  const Parts from(counts);
  MPI_Gatherv(own.data(), as_int(own.size()), MPI_DOUBLE, all.data(), from.counts.data(), from.first.data(), MPI_DOUBLE,
              0, group_);
}

} // namespace brinell::app
