// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/communicator.hpp"

#include <atomic>
#include <barrier>
#include <functional>
#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace brinell::test
{

/// Ranks that are threads of one process, to test without MPI what ranks compute together.
class RanksAsThreads
{
public:
  explicit RanksAsThreads(int size) : meeting_(size), shown_(static_cast<std::size_t>(size)) {}

  /// What a rank shows to the others.
  struct Shown
  {
    std::span<const double> values;
    std::span<const std::size_t> counts;
  };
  /// One rank. Each call shows its values to the others, and ends when all have read them.
  class Rank : public Communicator
  {
  public:
    Rank(RanksAsThreads& all, int rank) : all_(all), rank_(rank) {}
    [[nodiscard]] int rank() const override { return rank_; }
    [[nodiscard]] int size() const override { return static_cast<int>(all_.shown_.size()); }
    void all_to_all(std::span<const double> send, std::span<const std::size_t> sent, std::span<double> receive,
                    std::span<const std::size_t> received) const override
    {
      const auto me = static_cast<std::size_t>(rank_);
      all_.passed_ += static_cast<long>(send.size() - sent[me]);
      together({send, sent},
               [&](std::size_t from, const Shown& other)
               {
                 std::size_t first = 0;
                 for (std::size_t rank = 0; rank < me; ++rank)
                   first += other.counts[rank];
                 std::size_t to = 0;
                 for (std::size_t rank = 0; rank < from; ++rank)
                   to += received[rank];
                 if (other.counts[me] != received[from])
                   throw std::logic_error("a rank expects another number of values than is sent");
                 std::copy_n(other.values.begin() + static_cast<std::ptrdiff_t>(first), received[from],
                             receive.begin() + static_cast<std::ptrdiff_t>(to));
               });
    }
    void all_gather(std::span<const double> own, std::span<const std::size_t> counts,
                    std::span<double> all) const override
    {
      auto to = all.begin();
      together({own, counts},
               [&](std::size_t from, const Shown& other)
               {
                 if (other.values.size() != counts[from])
                   throw std::logic_error("a rank expects another number of values than is sent");
                 to = std::copy(other.values.begin(), other.values.end(), to);
               });
    }
    void broadcast(std::span<double> values, int from) const override
    {
      std::vector<double> received(values.begin(), values.end());
      together({values, {}},
               [&](std::size_t rank, const Shown& other)
               {
                 if (static_cast<int>(rank) == from)
                   received.assign(other.values.begin(), other.values.end());
               });
      std::copy(received.begin(), received.end(), values.begin());
    }
    void gather(std::span<const double> own, std::span<const std::size_t> counts, std::span<double> all) const override
    {
      std::vector<double> received(rank_ == 0 ? all.size() : 0);
      auto to = received.begin();
      together({own, counts},
               [&](std::size_t, const Shown& other)
               {
                 if (rank_ == 0)
                   to = std::copy(other.values.begin(), other.values.end(), to);
               });
      std::copy(received.begin(), received.end(), all.begin());
    }

  private:
    template <typename Use>
    void together(const Shown& own, const Use& use) const
    {
      all_.shown_[static_cast<std::size_t>(rank_)] = own;
      all_.meeting_.arrive_and_wait();
      for (std::size_t from = 0; from < all_.shown_.size(); ++from)
        use(from, all_.shown_[from]);
      all_.meeting_.arrive_and_wait();
    }

    friend class RanksAsThreads;
    RanksAsThreads& all_;
    int rank_;
  };

  /// Calls work(rank) by one thread per rank. A failure of any of them ends the test program: the others would wait for ever.
  static long run(int size, const std::function<void(const std::shared_ptr<const Communicator>&)>& work)
  {
    RanksAsThreads all(size);
    std::vector<std::jthread> threads;
    for (int rank = 0; rank < size; ++rank)
      threads.emplace_back([&, rank] { work(std::make_shared<const Rank>(all, rank)); });
    threads.clear();
    return all.passed_;
  }

private:
  std::barrier<> meeting_;
  std::vector<Shown> shown_;
  std::atomic<long> passed_ = 0; ///< numbers passed to other ranks by all_to_all
};

} // namespace brinell::test
