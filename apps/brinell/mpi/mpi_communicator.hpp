// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/communicator.hpp"

#include <mpi.h>

namespace brinell::app
{

/// The processes of a communicator of MPI. Errors of MPI end all of them, as MPI does by itself.
class MpiCommunicator : public Communicator
{
public:
  /// @param group  is duplicated, so that messages do not mix with those of others
  explicit MpiCommunicator(MPI_Comm group);
  ~MpiCommunicator() override;

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return size_; }
  void all_to_all(std::span<const double> send, std::span<const std::size_t> sent, std::span<double> receive,
                  std::span<const std::size_t> received) const override;
  void all_gather(std::span<const double> own, std::span<const std::size_t> counts,
                  std::span<double> all) const override;
  void broadcast(std::span<double> values, int from) const override;
  void gather(std::span<const double> own, std::span<const std::size_t> counts, std::span<double> all) const override;

private:
  MPI_Comm group_ = MPI_COMM_NULL;
  int rank_ = 0, size_ = 1;
};

} // namespace brinell::app
