// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "body_options.hpp"
#include "brinell/io/case_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

namespace brinell::io
{

/// The part of a case that is an object of a class: the case itself, the numerics common to all scenarios, or the scenario.
template <typename Class>
Class& part(Case& c)
{
  if constexpr (std::is_same_v<Class, Case>)
    return c;
  else if constexpr (std::is_same_v<Class, simulation::Numerics>)
    return std::visit([](simulation::Numerics& numerics) -> simulation::Numerics& { return numerics; }, c.scenario);
  else
    return std::get<Class>(c.scenario);
}

template <typename T, typename Class>
Class holder(T Class::*member); // declared only to deduce the class of a member

/// Converts a member to a value; `fill` converts back. An enumerator becomes the choice with the same index.
template <typename Member>
Value value_of(const Member& member, const std::vector<std::string>& choices)
{
  if constexpr (std::is_enum_v<Member>)
    return choices.at(static_cast<std::size_t>(member));
  else if constexpr (std::is_same_v<Member, int>)
    return std::int64_t{member};
  else if constexpr (std::is_same_v<Member, std::filesystem::path>)
    return member.string();
  else
    return member;
}
template <typename Member>
Value value_of(const std::optional<Member>& /*member*/, const std::vector<std::string>& choices)
{
  return value_of(Member{}, choices);
}

template <typename Member>
void fill(Member& member, const Value& value, const std::vector<std::string>& choices)
{
  if constexpr (std::is_enum_v<Member>)
    member =
        static_cast<Member>(std::find(choices.begin(), choices.end(), std::get<std::string>(value)) - choices.begin());
  else if constexpr (std::is_same_v<Member, int>)
    member = static_cast<int>(std::get<std::int64_t>(value));
  else if constexpr (std::is_same_v<Member, std::filesystem::path>)
    member = std::get<std::string>(value);
  else
    member = std::get<Member>(value);
}
template <typename Member>
void fill(std::optional<Member>& member, const Value& value, const std::vector<std::string>& choices)
{
  fill(member.emplace(), value, choices);
}

/// An entry that fills a member of the case, and has the type and default of this member.
/// @param first, rest  pointers to the member, outermost first: &Case::title, or &Numerics::domain, &Domain::layer
template <typename First, typename... Rest>
Entry bound(Entry entry, First first, Rest... rest)
{
  using Class = decltype(holder(first));
  constexpr std::array types{Type::boolean, Type::integer,   Type::number, Type::text, Type::vector3,
                             Type::numbers, Type::snapshots, Type::words}; // in the order of the alternatives of Value
  const Class none{};
  const Value value = value_of(((none.*first).*....*rest), entry.choices);
  entry.of.type = types.at(value.index());
  if (!entry.required && entry.unset.empty())
    entry.fallback = value;
  entry.fill = [choices = entry.choices, first, rest...](Case& target, const Value& given)
  { fill(((part<Class>(target).*first).*....*rest), given, choices); };
  return entry;
}

/// The keys of a table; the condition applies to keys that have none of their own.
[[nodiscard]] std::vector<Entry> in_table(const std::string& table, const Condition& when, std::vector<Entry> entries);

/// Choices from a table of words.
template <std::size_t N>
std::vector<std::string> choices_of(const std::array<std::string_view, N>& words)
{
  return {words.begin(), words.end()};
}

/// The keys of a group (Entry::one_of), in the order of the schema.
[[nodiscard]] std::vector<std::string> keys_of_group(std::string_view group);
/// "a, b and c"
[[nodiscard]] std::string in_words(const std::vector<std::string>& keys);

/// The entries of several tables.
[[nodiscard]] std::vector<Entry> joined(std::vector<std::vector<Entry>> parts);

/// A parameter of those options that list its key; required unless it has a default or may stay unset.
template <typename Product>
Entry parameter(const std::string& choice, const std::vector<Option<Product>>& options, Entry entry)
{
  entry.required = !entry.fallback && entry.unset.empty();
  entry.when = {choice, names_of(options, entry.key)};
  return entry;
}

/// Keys of one body, "lower" or "upper": shape, texture, material.
[[nodiscard]] std::vector<Entry> body_entries(const std::string& body);

/// Keys of the inclusions of a body. @param table  ends with a dot
[[nodiscard]] std::vector<Entry> inclusion_entries(const std::string& table);

/// Keys of a material. @param material  its table, ends with a dot
[[nodiscard]] std::vector<Entry> material_entries(const std::string& material);

/// Keys of the interface: friction, its heat, wear.
[[nodiscard]] std::vector<Entry> interface_entries();
/// Keys of the table `thermal`: what heat changes, and a source of heat from outside.
[[nodiscard]] std::vector<Entry> heat_entries();

/// Kinds of values.
namespace kind
{
inline constexpr ValueKind text{Type::text}, boolean{Type::boolean}, integer{Type::integer}, number{};
inline constexpr ValueKind share{.notation = Notation::share}, angle{.notation = Notation::angle},
    temperature{.notation = Notation::temperature};
inline constexpr ValueKind length{.dimension = dimension::length}, force{.dimension = dimension::force},
    pressure{.dimension = dimension::pressure}, velocity{.dimension = dimension::velocity},
    conductivity{.dimension = dimension::conductivity}, conductance{.dimension = dimension::conductance},
    power{.dimension = dimension::power}, heat_flux{.dimension = dimension::heat_flux},
    density{.dimension = dimension::density}, specific_heat{.dimension = dimension::specific_heat},
    expansion{.dimension = dimension::expansion}, wear{.dimension = dimension::wear},
    current{.dimension = dimension::current}, voltage{.dimension = dimension::voltage},
    resistivity{.dimension = dimension::resistivity}, area_resistance{.dimension = dimension::area_resistance},
    duration{.dimension = {.time = 1}}, frequency{.dimension = {.time = -1}}, per_length{.dimension = {.length = -1}};
} // namespace kind

} // namespace brinell::io
