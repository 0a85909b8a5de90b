// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/anderson.hpp"
#include "brinell/elastoplastic/body.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// A part of the fixed point x = g(x): a body with its trial deviators.
template <typename Part>
concept Participant = requires(Part& part, const Part& fixed)
{
  {
    fixed.active()
    } -> std::same_as<const ActiveCells&>; ///< their number may grow within an increment, but not shrink
  {
    part.trial()
    } -> std::same_as<std::vector<double>&>;
  {
    part.go_further(std::vector<double>{})
    } -> std::same_as<void>; ///< see Body::go_further
};
static_assert(Participant<Body>);

/// The unknowns of all participants as one vector, to which new unknowns are appended.
class Unknowns
{
public:
  /// Appends the unknowns that the participants (the bodies of `sides`) have gained since the last call.
  template <typename Sides>
  void grow(const Sides& sides)
  {
    places_.resize(sides.size());
    for (std::size_t part = 0; part < sides.size(); ++part)
      while (places_[part].size() < sides[part].body.active().trials().size())
        places_[part].push_back(size_++);
  }
  [[nodiscard]] std::size_t size() const { return size_; }

  /// The participant that has all unknowns, so that its arrays can be used in place of common vectors; nullptr if there is none.
  template <typename Sides>
  [[nodiscard]] auto* only_one(Sides& sides) const
  {
    const auto has_all = [this](const auto& places) { return size_ > 0 && places.size() == size_; };
    const auto found = std::find_if(places_.begin(), places_.end(), has_all);
    return found == places_.end() ? nullptr : &sides[static_cast<std::size_t>(found - places_.begin())].body;
  }

  /// Copies the trials to x, their images g(q) to g, and their flow to y.
  template <typename Sides>
  void pack(Sides& sides, std::vector<double>& x, std::vector<double>& g, std::vector<double>& y) const
  {
    for (std::vector<double>* field : {&x, &g, &y})
      field->resize(size_);
    for (std::size_t part = 0; part < places_.size(); ++part)
    {
      const std::vector<double>& trial = sides[part].body.trial();
      const std::vector<double>& mapped = sides[part].body.active().mapped();
      const std::vector<double>& flow = sides[part].body.active().flow();
      for_pieces(trial.size(),
                 [&](std::size_t first, std::size_t last)
                 {
                   for (std::size_t i = first; i < last; ++i)
                   {
                     x[places_[part][i]] = trial[i];
                     g[places_[part][i]] = mapped[i];
                     y[places_[part][i]] = flow[i];
                   }
                 });
    }
  }
  /// Calls Body::go_further of all participants with their parts of the common residual f.
  template <typename Sides>
  void go_further(const std::vector<double>& f, Sides& sides) const
  {
    for (std::size_t part = 0; part < places_.size(); ++part)
    {
      std::vector<double> residual(places_[part].size());
      for (std::size_t i = 0; i < residual.size(); ++i)
        residual[i] = f[places_[part][i]];
      sides[part].body.go_further(residual);
    }
  }
  template <typename Sides>
  void unpack(const std::vector<double>& x, Sides& sides) const
  {
    for (std::size_t part = 0; part < places_.size(); ++part)
    {
      std::vector<double>& trial = sides[part].body.trial();
      for_pieces(trial.size(),
                 [&](std::size_t first, std::size_t last)
                 {
                   for (std::size_t i = first; i < last; ++i)
                     trial[i] = x[places_[part][i]];
                 });
    }
  }

private:
  std::vector<std::vector<std::size_t>> places_; ///< index in the common vector: [participant][its unknown]
  std::size_t size_ = 0;
};

/// Computes the next trials of all participants from the evaluations so far.
class Acceleration
{
public:
  /// @param depth  0: plain fixed point, q <- g(q)
  explicit Acceleration(int depth) : depth_(depth), anderson_(depth) {}

  /// Keeps `factor` times as many evaluations from now on, see Anderson::deepen.
  void deepen(int factor, double damping) { anderson_.deepen(factor * depth_, damping); }
  /// @param changes_map  whether the map differs from that of the previous evaluation, see Anderson::change_map
  /// @param is_near      whether trials may go further than their residual, see Body::go_further
  template <typename Sides>
  void advance(Sides& sides, bool changes_map, bool is_near)
  {
    if (changes_map)
      anderson_.change_map();
    unknowns_.grow(sides);
    if (auto* const body = unknowns_.only_one(sides))
      anderson_.advance(body->trial(), body->active().mapped(), body->active().flow());
    else
    {
      unknowns_.pack(sides, x_, g_, y_);
      anderson_.advance(x_, g_, y_);
      unknowns_.unpack(x_, sides);
    }
    if (is_near && depth_ > 0)
      unknowns_.go_further(anderson_.residual(), sides);
  }

private:
  int depth_; ///< at first
  Anderson anderson_;
  Unknowns unknowns_;
  std::vector<double> x_, g_, y_;
};

} // namespace brinell::elastoplastic
