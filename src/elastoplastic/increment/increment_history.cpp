// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/embedding.hpp"
#include "brinell/foundation/error.hpp"
#include "contact_parts.hpp"

#include <algorithm>
#include <string>
#include <utility>

/// History of a coupled contact: in checkpoints, and moved to larger grids.
namespace brinell::elastoplastic
{

namespace
{

/// A texture belongs to the case, not to the history: a stored texture only serves to check that it is the same.
void exchange_texture(Archive& archive, const char* body, const std::vector<double>& texture)
{
  std::vector<double> stored = texture;
  archive.list(std::string(body) + ".texture", stored);
  const auto alike = [](double a, double b)
  { return std::abs(a - b) <= 1e-9 * (std::abs(a) + std::abs(b)); }; // rounding
  if (!std::equal(stored.begin(), stored.end(), texture.begin(), texture.end(), alike))
    throw InputError("the texture of a surface is not that of the stored state");
}

} // namespace

void CoupledContact::exchange(Archive& archive)
{
  ContactParts& c = *parts_;
  for (Side& side : c.sides)
    archive(&side == &c.sides.front() ? "lower" : "upper", side.body);
  exchange_texture(archive, "lower", c.textures.lower);
  exchange_texture(archive, "upper", c.textures.upper);
  for (const auto& [name, place] : {std::pair{"lower", &c.placement.lower}, {"upper", &c.placement.upper}})
  {
    constexpr int max_columns = 1 << 28; // differences stay whole numbers
    archive(std::string(name) + ".column", place->column, -max_columns, max_columns);
    archive(std::string(name) + ".fraction", place->fraction, 0.0, 1.0);
  }
  archive("window_error", c.window_error);
  exchange_members(archive, c.state);
  if (c.interface)
    archive("sliding", *c.interface);
  if (c.heating)
    archive("heating", *c.heating);
  for (const std::unique_ptr<Effect>& effect : c.effects)
    archive(std::string(effect->name()), *effect);
}

History CoupledContact::take_history() &&
{
  ContactParts& c = *parts_;
  History history{.contact = c.grid(), .grids = c.grids(), .between = std::move(static_cast<Between&>(c))};
  for (Side& side : c.sides)
    history.solved.push_back(std::move(side.body).take_state());
  return history;
}

void CoupledContact::continue_from(History history)
{
  ContactParts& c = *parts_;
  const auto columns_added = [](int now, int before)
  {
    if (now < before || (now - before) % 2 != 0)
      throw InternalError("CoupledContact: a history continues on larger grids with the same middle");
    return (now - before) / 2;
  };
  const int columns = columns_added(c.grid().nx, history.contact.nx);
  static_cast<void>(columns_added(c.grid().ny, history.contact.ny));
  embed_state(history.contact, history.between.state, c.grid(), c.state);
  c.placement = history.between.placement;
  for (std::size_t side = 0; side < 2; ++side)
    (side == 0 ? c.placement.lower : c.placement.upper).column +=
        columns_added(c.view(side).grid().surface.nx, history.grids[side].surface.nx) - columns;
  if (c.interface)
    c.interface->embed(*history.between.interface);
  if (history.between.heating)
  {
    c.heating = std::move(history.between.heating); // the thermal grids do not grow
    c.heating->move_to(c.grid());
  }
  for (std::size_t i = 0; i < c.effects.size(); ++i)
    c.effects[i]->embed(*history.between.effects[i]);
  spread(c, c.placement);
  for (std::size_t i = 0; i < c.sides.size(); ++i)
    c.sides[i].body.continue_from(history.solved[i], history.grids[i], c.sides[i].load());
  if (c.interface)
    recall_friction(c);
}

} // namespace brinell::elastoplastic
