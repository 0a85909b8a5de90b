// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

/// One list of the members of a state, from which follows everything that must not forget a member: checkpoints, growth of grids,
/// motion with the surfaces, mirror images. A state is an aggregate with a static function `table`, a tuple of `listed` members; a
/// list that lacks a member, or has one twice, does not compile.
namespace brinell
{

/// Value of a field in the mirror image of a body in x: the value itself, its negative, or that of a deviator field.
enum class InMirror
{
  even,
  odd,
  deviator
};

/// Properties of a member of a state, apart from its name.
struct Traits
{
  bool is_sized = false;   ///< the length of the field is part of the state
  bool is_derived = false; ///< found anew from the other members after the grids have grown
  bool is_carried = false; ///< belongs to points of the surfaces and moves with them through the contact grid
  InMirror in_mirror = InMirror::even;
  std::optional<std::pair<double, double>> range{}; ///< of a number
};

/// Number of parts of a member: several for an array of fields or numbers.
template <typename Member>
inline constexpr std::size_t parts_of = 1;
template <typename Part, std::size_t count>
inline constexpr std::size_t parts_of<std::array<Part, count>> = count;

template <typename State, typename Member>
struct Listed
{
  Member State::*member;
  std::array<std::string_view, parts_of<Member>> names; ///< of the parts, in checkpoints
  Traits traits;
};

template <typename State, typename Member>
constexpr Listed<State, Member> listed(Member State::*member, std::array<std::string_view, parts_of<Member>> names,
                                       const Traits& traits = {})
{
  return {member, names, traits};
}

namespace detail
{

struct Anything
{
  template <typename T>
  operator T() const; // NOLINT(google-explicit-constructor)
};

/// Number of members of an aggregate.
template <typename State, typename... Before>
consteval std::size_t members_of()
{
  if constexpr (requires { State{Before{}..., Anything{}}; })
    return members_of<State, Before..., Anything>();
  else
    return sizeof...(Before);
}

template <typename A, typename B>
constexpr std::size_t is_equal(const A& a, const B& b)
{
  if constexpr (std::is_same_v<A, B>)
    return a.member == b.member ? 1 : 0;
  return 0;
}

/// Whether a table has a line for each member: as many lines, no two of them for one member.
template <typename State>
consteval bool lists_each_once()
{
  constexpr auto lines = State::table();
  constexpr auto pairs = [](const auto&... a)
  {
    const auto equal_to = [&](const auto& b) { return (is_equal(a, b) + ...); };
    return (equal_to(a) + ...);
  };
  constexpr std::size_t count = std::tuple_size_v<decltype(lines)>;
  return count == members_of<State>() && count == std::apply(pairs, lines);
}

} // namespace detail

/// Calls use(name, traits, part of each state) for all fields and numbers of states of a kind, in the order of their table.
template <typename Use, typename State, typename... States>
void for_parts(const Use& use, State& state, States&... others)
{
  using Kind = std::remove_const_t<State>;
  static_assert(detail::lists_each_once<Kind>());
  const auto line = [&](const auto& item)
  {
    if constexpr (requires { std::tuple_size<std::remove_cvref_t<decltype(state.*item.member)>>::value; })
      for (std::size_t part = 0; part < item.names.size(); ++part)
        use(item.names[part], item.traits, (state.*item.member)[part], (others.*item.member)[part]...);
    else
      use(item.names.front(), item.traits, state.*item.member, others.*item.member...);
  };
  std::apply([&](const auto&... item) { (line(item), ...); }, Kind::table());
}

/// Calls use(traits, field of each state) for all fields, leaving out numbers.
template <typename Use, typename State, typename... States>
void for_fields(const Use& use, State& state, States&... others)
{
  for_parts(
      [&](std::string_view /*name*/, const Traits& traits, auto& part, auto&... rest)
      {
        if constexpr (requires { part.size(); })
          use(traits, part, rest...);
      },
      state, others...);
}

/// Properties of a member of a state.
template <typename State, typename Member>
[[nodiscard]] Traits traits_of(Member State::*member)
{
  Traits found;
  const auto look_at = [&](const auto& line)
  {
    if (detail::is_equal(line, listed(member, {})) > 0)
      found = line.traits;
  };
  std::apply([&](const auto&... line) { (look_at(line), ...); }, State::table());
  return found;
}

/// Gives all fields of a state, but those whose length is part of it, so many zeros.
template <typename State>
void assign_fields(State& state, std::size_t size)
{
  for_fields(
      [&](const Traits& traits, std::vector<double>& field)
      {
        if (!traits.is_sized)
          field.assign(size, 0.0);
      },
      state);
}

/// Passes all members of a state to an archive, or takes them from it. A field that is empty in this run is left out, unless its
/// length is part of the state.
template <typename State>
void exchange_members(Archive& archive, State& state)
{
  for_parts(
      [&]<typename Part>(std::string_view part, const Traits& traits, Part& value)
      {
        const std::string name(part);
        if constexpr (std::is_same_v<Part, std::vector<double>>)
        {
          if (traits.is_sized)
            archive.list(name, value);
          else if (!value.empty())
            archive(name, value);
        }
        else if (traits.range)
          archive(name, value, static_cast<Part>(traits.range->first), static_cast<Part>(traits.range->second));
        else
          archive(name, value);
      },
      state);
}

} // namespace brinell
