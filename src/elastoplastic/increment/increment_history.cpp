// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/increment.hpp"
#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <string>
#include <utility>

/// History of a coupled contact: in checkpoints, and moved to larger grids.
namespace brinell::elastoplastic
{

namespace
{

/// A texture belongs to the case, not to the history: a stored texture only serves to check that it is the same.
void exchange_texture(Archive& archive, const std::string& name, const std::vector<double>& texture)
{
  std::vector<double> stored = texture;
  archive.list(name, stored);
  const auto alike = [](double a, double b)
  { return std::abs(a - b) <= 1e-9 * (std::abs(a) + std::abs(b)); }; // rounding
  if (!std::equal(stored.begin(), stored.end(), texture.begin(), texture.end(), alike))
    throw InputError("the texture of a surface is not that of the stored state");
}

} // namespace

void CoupledContact::exchange(Archive& archive)
{
  for (Side& side : sides_)
    archive(&side == &sides_.front() ? "lower" : "upper", side.body);
  exchange_texture(archive, "lower.texture", textures_.lower);
  exchange_texture(archive, "upper.texture", textures_.upper);
  for (const auto& [name, place] : {std::pair{"lower", &placement_.lower}, {"upper", &placement_.upper}})
  {
    constexpr int max_columns = 1 << 28; // differences stay whole numbers
    archive(std::string(name) + ".column", place->column, -max_columns, max_columns);
    archive(std::string(name) + ".fraction", place->fraction, 0.0, 1.0);
  }
  archive("window_error", window_error_);
  archive("approach", approach_);
  archive("pressure", pressure_);
  archive("gap", gap_);
  if (interface_)
    archive("sliding", *interface_);
  if (heating_)
    archive("heating", *heating_);
  for (const std::unique_ptr<Effect>& effect : effects_)
    archive(std::string(effect->name()), *effect);
}

History CoupledContact::take_history() &&
{
  History history{grid(),
                  lower().grid(),
                  upper().grid(),
                  {},
                  placement_,
                  approach_,
                  std::move(pressure_),
                  std::move(interface_),
                  std::move(heating_),
                  std::move(effects_)};
  for (Side& side : sides_)
    history.solved.push_back(std::move(side.body).take_state());
  return history;
}

void CoupledContact::continue_from(History history)
{
  const auto columns_added = [](int now, int before)
  {
    if (now < before || (now - before) % 2 != 0)
      throw InternalError("CoupledContact: a history continues on larger grids with the same middle");
    return (now - before) / 2;
  };
  const int columns = columns_added(grid().nx, history.contact.nx);
  static_cast<void>(columns_added(grid().ny, history.contact.ny));
  embed_field(history.contact, history.pressure, grid(), pressure_);
  approach_ = history.approach;
  placement_ = history.placement;
  placement_.lower.column += columns_added(lower().grid().surface.nx, history.lower_grid.surface.nx) - columns;
  placement_.upper.column += columns_added(upper().grid().surface.nx, history.upper_grid.surface.nx) - columns;
  if (interface_)
    interface_->embed(*history.interface);
  if (history.heating)
  {
    heating_ = std::move(history.heating); // the thermal grids do not grow
    heating_->move_to(grid());
  }
  for (std::size_t i = 0; i < effects_.size(); ++i)
    effects_[i]->embed(*history.effects[i]);
  spread(placement_);
  for (std::size_t i = 0; i < sides_.size(); ++i)
    sides_[i].body.continue_from(history.solved[i], i == 0 ? history.lower_grid : history.upper_grid, sides_[i].load());
  if (interface_)
    recall_friction();
}

} // namespace brinell::elastoplastic
