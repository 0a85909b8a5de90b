// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/anderson.hpp"
#include "contact_parts.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace brinell::elastoplastic
{

/// Computes the next trials of all bodies from the evaluations so far.
class Acceleration
{
public:
  /// @param depth  0: plain fixed point, q <- g(q)
  explicit Acceleration(int depth) : depth_(depth), anderson_(depth) {}

  /// Keeps `factor` times as many evaluations from now on, see Anderson::deepen.
  void deepen(int factor, double damping) { anderson_.deepen(factor * depth_, damping); }
  /// @param changes_map  whether the map differs from that of the previous evaluation, see Anderson::change_map
  /// @param is_near      whether trials may go further than their residual, see Body::go_further
  void advance(std::vector<Side>& sides, bool changes_map, bool is_near)
  {
    if (changes_map)
      anderson_.change_map();
    grow(sides);
    const auto has_all = [this](const auto& places) { return size_ > 0 && places.size() == size_; };
    if (const auto only = std::find_if(places_.begin(), places_.end(), has_all); only != places_.end())
    {
      Body& body = sides[static_cast<std::size_t>(only - places_.begin())].body;
      anderson_.advance(body.trial(), body.active().mapped(), body.active().flow());
    }
    else
      advance_together(sides);
    if (is_near && depth_ > 0)
      go_further(sides);
  }

private:
  /// Appends the unknowns that the bodies have gained; their number does not shrink within an increment.
  void grow(const std::vector<Side>& sides)
  {
    places_.resize(sides.size());
    for (std::size_t part = 0; part < sides.size(); ++part)
    {
      const std::size_t count = sides[part].body.active().trials().size();
      while (places_[part].size() < count)
        places_[part].push_back(size_++);
    }
  }
  void go_further(std::vector<Side>& sides) const
  {
    const std::vector<double> of_all = anderson_.residual();
    std::vector<double> residual;
    for (std::size_t part = 0; part < places_.size(); ++part)
    {
      residual.clear();
      for (const std::size_t place : places_[part])
        residual.push_back(of_all[place]);
      sides[part].body.go_further(residual);
    }
  }
  /// Calls use(i, place in the common vector) for all unknowns of a body.
  template <typename Use>
  void for_places(std::size_t part, const Use& use) const
  {
    for_pieces(places_[part].size(),
               [&](std::size_t first, std::size_t last)
               {
                 for (std::size_t i = first; i < last; ++i)
                   use(i, places_[part][i]);
               });
  }
  void advance_together(std::vector<Side>& sides)
  {
    for (std::vector<double>* field : {&x_, &g_, &y_})
      field->resize(size_);
    for (std::size_t part = 0; part < sides.size(); ++part)
    {
      const ActiveCells& active = sides[part].body.active();
      const double *x = active.trials().data(), *g = active.mapped().data(), *y = active.flow().data();
      for_places(part,
                 [&](std::size_t i, std::size_t place)
                 {
                   x_[place] = x[i];
                   g_[place] = g[i];
                   y_[place] = y[i];
                 });
    }
    anderson_.advance(x_, g_, y_);
    for (std::size_t part = 0; part < sides.size(); ++part)
    {
      double* const x = sides[part].body.trial().data();
      for_places(part, [&](std::size_t i, std::size_t place) { x[i] = x_[place]; });
    }
  }

  int depth_; ///< at first
  Anderson anderson_;
  std::vector<std::vector<std::size_t>> places_; ///< index in the common vectors: [body][its unknown]
  std::size_t size_ = 0;                         ///< of these vectors
  std::vector<double> x_, g_, y_;                ///< trials, their images and flow
};

} // namespace brinell::elastoplastic
