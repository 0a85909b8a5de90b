// SPDX-License-Identifier: BSD-3-Clause
#include "exchange.hpp"

#include <numeric>

namespace brinell::halfspace
{

namespace
{

constexpr std::size_t numbers_of_value = sizeof(ComplexLanes) / sizeof(double);

std::size_t sum(const std::vector<std::size_t>& counts)
{
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

std::span<const double> as_numbers(const ComplexLanes* values, std::size_t count)
{
  return {reinterpret_cast<const double*>(values), count};
}

std::span<double> as_numbers(ComplexLanes* values, std::size_t count)
{
  return {reinterpret_cast<double*>(values), count};
}

} // namespace

Exchange::Exchange(const Communicator& ranks, const Share& share, const Dealt& units, int of_units, int blocks,
                   int rows)
    : ranks_(ranks), units_(units), of_units_(of_units), rows_(rows), own_units_(units.count(share.rank(), of_units)),
      own_blocks_(share.blocks(blocks))
{
  std::ptrdiff_t first = 0;
  for (int rank = 0; rank < share.ranks(); ++rank)
  {
    const int count = units.count(rank, of_units);
    units_of_.push_back(count);
    first_of_.push_back(first);
    first += static_cast<std::ptrdiff_t>(own_blocks_.count()) * count * rows;
    const auto values = [&](int of_blocks, int of_planes)
    {
      return numbers_of_value * static_cast<std::size_t>(of_blocks) * static_cast<std::size_t>(of_planes) *
             static_cast<std::size_t>(rows);
    };
    of_planes_.push_back(values(share.blocks(rank, blocks).count(), own_units_));
    of_blocks_.push_back(values(own_blocks_.count(), count));
  }
}

std::size_t Exchange::size_of_planes() const
{
  return sum(of_planes_) / numbers_of_value;
}

std::size_t Exchange::size_of_blocks() const
{
  return sum(of_blocks_) / numbers_of_value;
}

std::ptrdiff_t Exchange::place(int unit, int block) const
{
  const auto owner = static_cast<std::size_t>(units_.owner(unit));
  return first_of_[owner] +
         (static_cast<std::ptrdiff_t>(block - own_blocks_.first) * units_of_[owner] + units_.place(unit)) * rows_;
}

void Exchange::to_blocks(const ComplexLanes* planes, ComplexLanes* blocks) const
{
  ranks_.all_to_all(as_numbers(planes, sum(of_planes_)), of_planes_, as_numbers(blocks, sum(of_blocks_)), of_blocks_);
}

void Exchange::to_planes(const ComplexLanes* blocks, ComplexLanes* planes) const
{
  ranks_.all_to_all(as_numbers(blocks, sum(of_blocks_)), of_blocks_, as_numbers(planes, sum(of_planes_)), of_planes_);
}

} // namespace brinell::halfspace
