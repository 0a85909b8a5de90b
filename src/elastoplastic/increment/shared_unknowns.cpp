// SPDX-License-Identifier: BSD-3-Clause
#include "shared_unknowns.hpp"

#include "foundation/sharing.hpp"

#include <algorithm>
#include <numeric>

namespace brinell::elastoplastic
{

namespace
{

void gather(const std::vector<double>& values, const std::vector<std::size_t>& places, std::vector<double>& gathered)
{
  gathered.resize(places.size());
  for_pieces(places.size(),
             [&](std::size_t first, std::size_t last)
             {
               for (std::size_t i = first; i < last; ++i)
                 gathered[i] = values[places[i]];
             });
}

void scatter(const std::vector<double>& gathered, const std::vector<std::size_t>& places, std::vector<double>& values)
{
  for_pieces(places.size(),
             [&](std::size_t first, std::size_t last)
             {
               for (std::size_t i = first; i < last; ++i)
                 values[places[i]] = gathered[i];
             });
}

} // namespace

SharedUnknowns::SharedUnknowns(const Communicator& ranks) : ranks_(ranks) {}

void SharedUnknowns::follow(const std::vector<std::vector<std::size_t>>& places, std::size_t size)
{
  const auto ranks = static_cast<std::size_t>(ranks_.size()), me = static_cast<std::size_t>(ranks_.rank());
  std::vector<std::vector<double>> to(ranks);            // places in the pieces of each rank
  std::vector<std::vector<std::size_t>> unknowns(ranks); // that go there
  std::size_t own = 0;
  for (const std::vector<std::size_t>& of_body : places)
    for (const std::size_t place : of_body)
    {
      const std::size_t piece = place / piece_size;
      const std::size_t there = piece / ranks * piece_size + place % piece_size;
      to[piece % ranks].push_back(static_cast<double>(there));
      unknowns[piece % ranks].push_back(own++);
    }
  order_.clear();
  sent_.clear();
  std::vector<double> sent_places;
  for (std::size_t rank = 0; rank < ranks; ++rank)
  {
    order_.insert(order_.end(), unknowns[rank].begin(), unknowns[rank].end());
    sent_places.insert(sent_places.end(), to[rank].begin(), to[rank].end());
    sent_.push_back(to[rank].size());
  }
  // Numbers from each rank to each other one.
  const std::vector<double> table = ranks_.joined(std::vector<double>(sent_.begin(), sent_.end()));
  received_.clear();
  for (std::size_t rank = 0; rank < ranks; ++rank)
    received_.push_back(static_cast<std::size_t>(table[rank * ranks + me]));
  std::vector<double> received_places(std::accumulate(received_.begin(), received_.end(), std::size_t{0}));
  ranks_.all_to_all(sent_places, sent_, received_places, received_);
  arrives_.assign(received_places.begin(), received_places.end());
  const std::size_t turn = ranks * piece_size;
  in_pieces_ = size / turn * piece_size + std::min(piece_size, size % turn - std::min(size % turn, me * piece_size));
}

void SharedUnknowns::to_pieces(const std::vector<double>& of_cells, std::vector<double>& in_pieces)
{
  gather(of_cells, order_, cells_side_);
  pieces_side_.resize(arrives_.size());
  ranks_.all_to_all(cells_side_, sent_, pieces_side_, received_);
  in_pieces.resize(in_pieces_);
  scatter(pieces_side_, arrives_, in_pieces);
}

void SharedUnknowns::to_cells(const std::vector<double>& in_pieces, std::vector<double>& of_cells)
{
  gather(in_pieces, arrives_, pieces_side_);
  cells_side_.resize(order_.size());
  ranks_.all_to_all(pieces_side_, received_, cells_side_, sent_);
  scatter(cells_side_, order_, of_cells);
}

} // namespace brinell::elastoplastic
