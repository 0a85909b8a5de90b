// SPDX-License-Identifier: BSD-3-Clause
#include "body_parts.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <numeric>

/// Numbers that the ranks that share a body pass to each other, besides what the half space passes: docs/theory/ranks.md.
namespace brinell::elastoplastic
{

namespace
{

/// The numbers of layers that have been found one after the other, from the surface downwards.
std::vector<double> by_layers(const BodyParts& b, std::span<const double> of_own_layers)
{
  const std::vector<double> joined = b.ranks->joined(of_own_layers);
  const std::vector<std::size_t> counts = b.ranks->all_counts(of_own_layers.size());
  std::vector<double> values(joined.size());
  auto from = joined.begin();
  for (std::size_t rank = 0; rank < counts.size(); ++rank)
    for (std::size_t own = 0; own < counts[rank]; ++own)
      values[static_cast<std::size_t>(b.share.layers().item(static_cast<int>(rank), static_cast<int>(own)))] = *from++;
  return values;
}

/// Sum of copies times dissipation, cell by cell.
double sum_with_dissipation(std::span<const double> copies, std::span<const double> dissipation, double sum,
                            double volume)
{
  for (std::size_t a = 0; a < copies.size(); ++a)
    sum += copies[a] * dissipation[a] * volume;
  return sum;
}

/// Terms of a piece of which a rank has a part.
struct Fragment
{
  std::size_t piece, first;
  std::span<const double> terms;
};

} // namespace

void number_active_cells(BodyParts& b, const std::vector<double>& added)
{
  const std::vector<double> of_all = by_layers(b, added);
  std::vector<std::size_t> first(of_all.size());
  std::size_t next = b.trial.count_of_all;
  for (std::size_t layer = 0; layer < of_all.size(); ++layer)
  {
    first[layer] = next;
    next += static_cast<std::size_t>(of_all[layer]);
  }
  for (std::size_t own = 0; own < added.size(); ++own)
    for (std::size_t i = 0; i < static_cast<std::size_t>(added[own]); ++i)
      b.trial.places.push_back(first[static_cast<std::size_t>(b.share.layer(static_cast<int>(own)))] + i);
  b.trial.count_of_all = next;
}

std::vector<double> in_order(const BodyParts& b, std::span<const double> of_own_cells)
{
  const std::vector<double> own_places(b.trial.places.begin(), b.trial.places.end());
  const std::vector<double> places = b.ranks->joined(own_places), values = b.ranks->joined(of_own_cells);
  std::vector<double> ordered(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    ordered[static_cast<std::size_t>(places[i])] = values[i];
  return ordered;
}

double with_dissipation(const BodyParts& b, double sum, double volume)
{
  const ActiveCells& active = b.trial.active;
  if (b.share.is_all())
    return sum_with_dissipation(active.all_copies(), active.dissipations(), sum, volume);
  return sum_with_dissipation(in_order(b, active.all_copies()), in_order(b, active.dissipations()), sum, volume);
}

/// A pair of layers lies in several pieces. Of those that lie in it whole the sum is passed, of the others all terms.
double sum_over_zone(const BodyParts& b, const PlasticZone& zone, std::size_t piece_size,
                     const std::function<double(std::size_t)>& term)
{
  const std::size_t plane = b.grid.surface.size(), n = b.whole.size();
  std::vector<double> passed; // [piece, first cell, number of terms or -1 for the sum, terms]
  for (int own = 0; own < b.grid.nz; own += Share::layers_together)
  {
    const int layers = std::min(Share::layers_together, b.grid.nz - own);
    const std::size_t begin = static_cast<std::size_t>(b.share.layer(own)) * plane,
                      end = begin + static_cast<std::size_t>(layers) * plane;
    const std::size_t own_begin = static_cast<std::size_t>(own) * plane;
    for (std::size_t piece = begin / piece_size; piece * piece_size < end; ++piece)
    {
      const std::size_t first = std::max(begin, piece * piece_size),
                        last = std::min(end, std::min(n, (piece + 1) * piece_size));
      const bool is_whole = first == piece * piece_size && last == std::min(n, (piece + 1) * piece_size);
      double sum = 0.0;
      std::vector<double> terms;
      zone.for_cells(own_begin + first - begin, own_begin + last - begin,
                     [&](std::size_t from, std::size_t to)
                     {
                       for (std::size_t cell = from; cell < to; ++cell)
                         if (is_whole)
                           sum += term(cell);
                         else
                           terms.push_back(term(cell));
                     });
      passed.insert(passed.end(), {static_cast<double>(piece), static_cast<double>(first),
                                   is_whole ? -1.0 : static_cast<double>(terms.size())});
      if (is_whole)
        passed.push_back(sum);
      passed.insert(passed.end(), terms.begin(), terms.end());
    }
  }
  const std::vector<double> all = b.ranks->joined(passed);
  std::vector<double> sums((n + piece_size - 1) / piece_size);
  std::vector<Fragment> fragments;
  for (std::size_t at = 0; at < all.size();)
  {
    const auto piece = static_cast<std::size_t>(all[at]), first = static_cast<std::size_t>(all[at + 1]);
    const bool is_whole = all[at + 2] < 0.0;
    const std::size_t count = is_whole ? 1 : static_cast<std::size_t>(all[at + 2]);
    if (is_whole)
      sums[piece] = all[at + 3];
    else
      fragments.push_back({piece, first, std::span(all).subspan(at + 3, count)});
    at += 3 + count;
  }
  std::ranges::sort(fragments, {}, &Fragment::first);
  for (const Fragment& fragment : fragments)
    for (const double value : fragment.terms)
      sums[fragment.piece] += value;
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

std::vector<double> gathered(const BodyParts& b, std::span<const double> own_field)
{
  const int ranks = b.ranks->size();
  const std::size_t own = b.grid.size(), plane = b.grid.surface.size();
  const bool receives = b.ranks->rank() == 0;
  const auto fields = static_cast<std::size_t>(
      b.ranks->largest(own > 0 ? static_cast<double>(own_field.size()) / static_cast<double>(own) : 0.0));
  std::vector<std::size_t> counts;
  counts.reserve(static_cast<std::size_t>(ranks));
  for (int rank = 0; rank < ranks; ++rank)
    counts.push_back(static_cast<std::size_t>(b.share.layers().count(rank, b.whole.nz)) * plane);
  std::vector<double> whole(receives ? fields * b.whole.size() : 0), one(receives ? b.whole.size() : 0);
  for (std::size_t field = 0; field < fields; ++field)
  {
    b.ranks->gather(own_field.subspan(field * own, own), counts, one);
    auto from = one.begin();
    for (int rank = 0; receives && rank < ranks; ++rank)
      for (int place = 0; place < b.share.layers().count(rank, b.whole.nz);
           ++place, from += static_cast<std::ptrdiff_t>(plane))
        std::copy_n(from, plane,
                    whole.begin() +
                        static_cast<std::ptrdiff_t>(field * b.whole.size() +
                                                    b.whole.index(0, 0, b.share.layers().item(rank, place))));
  }
  return whole;
}

std::vector<double> Body::own_layers(std::span<const double> whole_field) const
{
  const BodyParts& b = parts_;
  std::vector<double> own_field;
  const std::size_t plane = b.grid.surface.size();
  for (std::size_t first = 0; first < whole_field.size(); first += b.whole.size())
    for (int layer = 0; layer < b.grid.nz; ++layer)
    {
      const auto values = whole_field.subspan(first + b.whole.index(0, 0, b.share.layer(layer)), plane);
      own_field.insert(own_field.end(), values.begin(), values.end());
    }
  return own_field;
}

LayeredFields Body::layered(std::vector<std::vector<double>> own) const
{
  return {parts_.whole, parts_.ranks, parts_.share, std::move(own)};
}

double Body::equivalent_at(std::size_t cell) const
{
  const BodyParts& b = parts_;
  if (b.yield.material.elastic.is_rigid())
    return 0.0;
  const auto layer = static_cast<int>(cell / b.grid.surface.size());
  double value = 0.0;
  if (b.share.has(layer))
    value = b.state.equivalent[b.grid.index(0, 0, b.share.place(layer)) + cell % b.grid.surface.size()];
  b.ranks->broadcast({&value, 1}, b.share.layers().owner(layer));
  return value;
}

std::vector<double> Body::largest_of_layers() const
{
  const std::span<const double> own = parts_.zone.largest_of_layers();
  if (!parts_.is_plastic() || parts_.share.is_all())
    return {own.begin(), own.end()};
  return by_layers(parts_, own);
}

double Body::largest_strain() const
{
  return parts_.ranks->largest(parts_.zone.largest());
}

} // namespace brinell::elastoplastic
