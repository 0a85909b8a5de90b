// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"
#include "brinell/simulation/surface_fields.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

namespace brinell::io
{

using simulation::surface_fields;
using simulation::SurfaceField;
using simulation::unknown;

/// Which fields on a surface exist, in the order of `surface_fields`.
template <typename Owner>
struct FieldsThere : std::array<bool, std::tuple_size_v<decltype(surface_fields(std::declval<const Owner&>()))>>
{
  FieldsThere() : FieldsThere::array{} {}
  explicit FieldsThere(const Owner& owner)
  {
    std::ranges::transform(surface_fields(owner), this->begin(),
                           [](const auto& field) { return !field.values->empty(); });
  }
  [[nodiscard]] bool any() const { return std::ranges::count(*this, true) > 0; }

  [[nodiscard]] bool has(std::string_view name) const
  {
    bool is_there = false;
    for_each([&](const SurfaceField& field) { is_there = is_there || field.name == name; });
    return is_there;
  }

  /// Calls an action with the name and further properties of each field that exists, not with its values.
  template <typename Action>
  void for_each(const Action& action) const
  {
    const Owner none;
    const auto fields = surface_fields(none);
    for (std::size_t i = 0; i < fields.size(); ++i)
      if ((*this)[i])
        action(fields[i]);
  }

  void exchange(Archive& archive)
  {
    for (std::size_t i = 0; i < this->size(); ++i)
      archive(std::to_string(i), (*this)[i]);
  }
};

} // namespace brinell::io
