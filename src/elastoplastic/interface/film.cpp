// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/film.hpp"

#include "brinell/foundation/embedding.hpp"
#include "brinell/foundation/error.hpp"
#include "foundation/require_size.hpp"

#include <algorithm>
#include <limits>

namespace brinell::elastoplastic
{

Film::Film(const SurfaceGrid& contact, const SurfaceGrid& lower, const SurfaceGrid& upper, const FilmLaw& law)
    : contact_(contact), grids_{lower, upper}, law_(law)
{
  for (std::size_t side = 0; side < 2; ++side)
    if (!law.cover[side].empty())
      require_size("Film: the cover", law.cover[side], grids_[side].size());
}

Film::State Film::start() const
{
  State state;
  for (std::size_t side = 0; side < 2 && law_.varies(); ++side)
  {
    std::vector<double>& film = state.resistance[side];
    film.assign(grids_[side].size(), 0.5 * law_.resistance);
    for (std::size_t i = 0; i < law_.cover[side].size(); ++i)
      film[i] += law_.resistivity * law_.cover[side][i];
    if (law_.wear > 0.0)
      state.worn[side].assign(grids_[side].size(), 0.0);
  }
  return state;
}

void Film::advance(State& state, const Interaction& found, const Placement& placement,
                   const std::array<std::span<const double>, 2>& worn) const
{
  if (!law_.varies())
    return;
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t i = 0; i < worn[side].size() && law_.wear > 0.0; ++i)
    {
      double& film = state.resistance[side][i];
      film = std::max(0.0, film - law_.wear * (worn[side][i] - state.worn[side][i]));
      state.worn[side][i] = worn[side][i];
    }
  const std::vector<double> path = found.slip_length(), present = resistance(state, placement);
  const double limit = law_.limit.value_or(std::numeric_limits<double>::infinity());
  std::vector<double> grown(path.size());
  for (std::size_t i = 0; i < grown.size(); ++i)
    if (found.pressure()[i] > 0.0)
      grown[i] = std::min(law_.growth * path[i], std::max(0.0, limit - present[i]));
  for (std::size_t side = 0; side < 2; ++side)
    if (!spread_volume(contact_, grown, 0.5, side == 0 ? placement.lower : placement.upper, grids_[side],
                       state.resistance[side]))
      throw InternalError("Film: cells under pressure lie beyond the grid of the body");
}

std::vector<double> Film::resistance(const State& state, const Placement& placement) const
{
  if (!law_.exists())
    return {};
  std::vector<double> sum(contact_.size(), law_.varies() ? 0.0 : law_.resistance);
  if (!law_.varies())
    return sum;
  add_depth(grids_[0], state.resistance[0], {}, placement.lower, contact_, sum);
  add_depth(grids_[1], state.resistance[1], {}, placement.upper, contact_, sum);
  for (double& value : sum) // the interpolation may overshoot
    value = std::max(0.0, value);
  return sum;
}

Film::State Film::embedded(const Film& smaller, const State& state) const
{
  State larger = start();
  for (std::size_t side = 0; side < 2; ++side)
    for (const auto& [from, to] :
         {std::pair{&state.resistance[side], &larger.resistance[side]}, {&state.worn[side], &larger.worn[side]}})
      if (!from->empty())
        embed_field(smaller.grids_[side], *from, grids_[side], *to);
  return larger;
}

} // namespace brinell::elastoplastic
