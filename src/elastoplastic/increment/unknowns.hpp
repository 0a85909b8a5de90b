// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/anderson.hpp"
#include "contact_parts.hpp"
#include "device_unknowns.hpp"
#include "foundation/sharing.hpp"
#include "shared_unknowns.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace brinell::elastoplastic
{

/// Computes the next trials of all bodies from the evaluations so far.
class Acceleration
{
public:
  /// @param depth           0: plain fixed point, q <- g(q)
  /// @param has_inclusions  whether the equivalent strain of inclusions changes the map beside the trials
  Acceleration(int depth, const Communicator& ranks, bool has_inclusions)
      : depth_(depth), shared_(ranks), anderson_(depth, ranks.is_alone() ? nullptr : &ranks), on_devices_(depth)
  {
    if (has_inclusions)
      anderson_.give_up_where_still();
  }

  /// Keeps `factor` times as many evaluations from now on, see Anderson::deepen.
  void deepen(int factor, double damping)
  {
    anderson_.deepen(factor * depth_, damping);
    on_devices_.deepen(factor * depth_, damping);
  }
  /// @param changes_map  whether the map differs from that of the previous evaluation, see Anderson::change_map
  /// @param is_near      whether trials may go further than their residual, see Body::go_further
  void advance(std::vector<Side>& sides, bool changes_map, bool is_near)
  {
    if (std::any_of(sides.begin(), sides.end(), [](const Side& side) { return side.body.is_on_device(); }))
      return on_devices_.advance(sides, changes_map, is_near);
    if (changes_map)
      anderson_.change_map();
    grow(sides);
    if (!shared_.is_alone())
    {
      advance_shared(sides);
      if (is_near && depth_ > 0)
        go_further_shared(sides);
      return;
    }
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
    const std::size_t known = size_;
    places_.resize(sides.size());
    cells_.resize(sides.size());
    for (std::size_t part = 0; part < sides.size(); ++part)
    {
      const Body& body = sides[part].body;
      const std::size_t before = std::exchange(cells_[part], body.active_of_all());
      for (std::size_t a = places_[part].size() / Deviator::size; a < body.active().size(); ++a)
        for (std::size_t c = 0; c < Deviator::size; ++c)
          places_[part].push_back(size_ + (body.place_of_active(a) - before) * Deviator::size + c);
      size_ += (cells_[part] - before) * Deviator::size;
    }
    if (!shared_.is_alone() && (size_ > known || known == 0)) // alike on all ranks
      shared_.follow(places_, size_);
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

  /// Calls use(own unknown, its place among all own ones) for the own unknowns of all bodies.
  template <typename Use>
  void for_own(const Use& use) const
  {
    std::size_t before = 0;
    for (std::size_t part = 0; part < places_.size(); ++part)
    {
      for_pieces(places_[part].size(),
                 [&](std::size_t first, std::size_t last)
                 {
                   for (std::size_t i = first; i < last; ++i)
                     use(part, i, before + i);
                 });
      before += places_[part].size();
    }
  }
  void advance_shared(std::vector<Side>& sides)
  {
    std::vector<double>& of_cells = of_cells_;
    of_cells.resize(shared_.own_unknowns());
    const auto pass = [&](const auto& values_of, std::vector<double>& in_pieces)
    {
      for_own([&](std::size_t part, std::size_t i, std::size_t own)
              { of_cells[own] = values_of(sides[part].body)[i]; });
      shared_.to_pieces(of_cells, in_pieces);
    };
    pass([](const Body& body) -> const std::vector<double>& { return body.active().trials(); }, x_);
    pass([](const Body& body) -> const std::vector<double>& { return body.active().mapped(); }, g_);
    pass([](const Body& body) -> const std::vector<double>& { return body.active().flow(); }, y_);
    anderson_.advance(x_, g_, y_);
    shared_.to_cells(x_, of_cells);
    for_own([&](std::size_t part, std::size_t i, std::size_t own) { sides[part].body.trial()[i] = of_cells[own]; });
  }
  void go_further_shared(std::vector<Side>& sides)
  {
    std::vector<double>& of_cells = of_cells_;
    of_cells.resize(shared_.own_unknowns());
    shared_.to_cells(anderson_.residual(), of_cells);
    std::vector<std::vector<double>> residuals;
    residuals.reserve(sides.size());
    for (const std::vector<std::size_t>& of_body : places_)
      residuals.emplace_back(of_body.size());
    for_own([&](std::size_t part, std::size_t i, std::size_t own) { residuals[part][i] = of_cells[own]; });
    for (std::size_t part = 0; part < sides.size(); ++part)
      sides[part].body.go_further(residuals[part]);
  }

  int depth_; ///< at first
  SharedUnknowns shared_;
  Anderson anderson_;
  AccelerationOnDevices on_devices_;
  std::vector<std::vector<std::size_t>> places_; ///< index in the common vectors: [body][its unknown]
  std::vector<std::size_t> cells_;               ///< active cells of each body, of all ranks
  std::size_t size_ = 0;                         ///< of these vectors
  std::vector<double> x_, g_, y_;                ///< trials, their images and flow
  std::vector<double> of_cells_;                 ///< one of these, of the own unknowns
};

} // namespace brinell::elastoplastic
