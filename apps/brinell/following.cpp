// SPDX-License-Identifier: BSD-3-Clause
#include "following.hpp"

namespace brinell::app
{

namespace
{

/// Numbers of the first rank, and how many there are, for all.
void share(const Communicator& ranks, std::vector<double>& numbers)
{
  auto size = static_cast<double>(numbers.size());
  ranks.broadcast({&size, 1}, 0);
  numbers.resize(static_cast<std::size_t>(size));
  ranks.broadcast(numbers, 0);
}

/// The fields that the first rank has left where they are stored: all ranks read them together.
void share_left(const Communicator& ranks, const std::optional<Archive::Fields>& checkpoint, Archive::Fields& shared)
{
  auto count = checkpoint ? static_cast<double>(checkpoint->left.size()) : 0.0;
  ranks.broadcast({&count, 1}, 0);
  auto next = checkpoint ? checkpoint->left.begin() : shared.left.begin();
  for (double i = 0.0; i < count; ++i)
  {
    std::vector<double> name;
    double size = 0.0;
    if (checkpoint)
    {
      name.assign(next->first.begin(), next->first.end());
      size = static_cast<double>(next++->second);
    }
    share(ranks, name);
    ranks.broadcast({&size, 1}, 0);
    shared.left[{name.begin(), name.end()}] = static_cast<std::size_t>(size);
  }
  shared.read = [&ranks, read = checkpoint ? checkpoint->read : decltype(shared.read){}](
                    const std::string& name, std::size_t first, std::span<double> values)
  {
    if (read)
      read(name, first, values);
    ranks.broadcast(values, 0);
  };
}

} // namespace

std::optional<Archive::Fields> for_all(const Communicator& ranks, std::optional<Archive::Fields> checkpoint)
{
  if (ranks.is_alone())
    return checkpoint;
  double count = checkpoint ? static_cast<double>(checkpoint->size()) : -1.0;
  ranks.broadcast({&count, 1}, 0);
  if (count < 0.0)
    return std::nullopt;
  Archive::Fields shared;
  auto next = checkpoint ? checkpoint->begin() : shared.begin();
  for (double i = 0.0; i < count; ++i)
  {
    std::vector<double> name, values;
    if (checkpoint)
    {
      name.assign(next->first.begin(), next->first.end());
      values = std::move(next++->second);
    }
    share(ranks, name);
    share(ranks, values);
    shared[{name.begin(), name.end()}] = std::move(values);
  }
  share_left(ranks, checkpoint, shared);
  return shared;
}

} // namespace brinell::app
