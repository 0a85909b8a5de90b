// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/share.hpp"

#include "brinell/foundation/communicator.hpp"
#include "ranks_as_threads.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace brinell
{
namespace
{

TEST(Share, EveryLayerHasOneOwnerAndItsPlace)
{
  for (const int ranks : {1, 2, 3, 5})
    for (const int together : {1, 2, 3})
      for (int items = 0; items < 20; ++items)
      {
        const Dealt dealt(ranks, together);
        int all = 0;
        for (int rank = 0; rank < ranks; ++rank)
        {
          all += dealt.count(rank, items);
          for (int place = 0; place < dealt.count(rank, items); ++place)
          {
            const int item = dealt.item(rank, place);
            EXPECT_LT(item, items);
            EXPECT_EQ(dealt.owner(item), rank);
            EXPECT_EQ(dealt.place(item), place);
          }
        }
        EXPECT_EQ(all, items);
      }
}

/// So that what happens in the first layers only is shared as well.
TEST(Share, TheFirstLayersAreSharedEvenly)
{
  const Dealt pairs(4, 2);
  for (int layers = 0; layers < 64; ++layers)
    for (int rank = 0; rank < 4; ++rank)
      EXPECT_NEAR(pairs.count(rank, layers), layers / 4.0, 2.0);
}

TEST(Share, PortionsFollowEachOther)
{
  for (const int ranks : {1, 2, 3, 7})
    for (int items = 0; items < 20; ++items)
    {
      int next = 0;
      for (int rank = 0; rank < ranks; ++rank)
      {
        const Portion portion(rank, ranks, items);
        EXPECT_EQ(portion.first, next);
        EXPECT_NEAR(portion.count(), static_cast<double>(items) / ranks, 1.0);
        // Fewer items are never more for any rank: the buffers of a window are those of the body.
        EXPECT_LE(Portion(rank, ranks, items).count(), Portion(rank, ranks, items + 1).count());
        next = portion.end;
      }
      EXPECT_EQ(next, items);
    }
}

TEST(Communicator, AloneReturnsItsArgument)
{
  const Communicator alone;
  EXPECT_EQ(alone.rank(), 0);
  EXPECT_TRUE(alone.is_alone());
  EXPECT_EQ(alone.joined(std::vector<double>{3.0, 4.0}), (std::vector<double>{3.0, 4.0}));
  EXPECT_EQ(alone.largest(2.0), 2.0);
  std::vector<double> received(2);
  alone.all_to_all(std::vector<double>{5.0, 6.0}, std::vector<std::size_t>{2}, received, std::vector<std::size_t>{2});
  EXPECT_EQ(received, (std::vector<double>{5.0, 6.0}));
}

TEST(Communicator, RanksReceiveInTheirOrder)
{
  test::RanksAsThreads::run(3,
                            [](const std::shared_ptr<const Communicator>& ranks)
                            {
                              const auto me = static_cast<std::size_t>(ranks->rank());
                              const std::vector<double> own(me, 10.0 + ranks->rank());
                              EXPECT_EQ(ranks->joined(own), (std::vector<double>{11.0, 12.0, 12.0}));
                              EXPECT_EQ(ranks->largest(-ranks->rank()), 0.0);
                              EXPECT_TRUE(ranks->any(me == 2));
                              EXPECT_FALSE(ranks->any(false));
                            });
}

} // namespace
} // namespace brinell
