// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/schema.hpp"
#include "value_text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>

namespace brinell::io
{

namespace
{

using Json = nlohmann::ordered_json;

/// A number in a range; a quantity may be text with a unit instead.
Json number_schema(const Entry& entry, const char* type)
{
  Json number{{"type", type}};
  if (!entry.of.range.zero_allowed)
    number["not"] = {{"const", 0}};
  if (std::isfinite(entry.of.range.min))
    number[entry.of.range.min_allowed ? "minimum" : "exclusiveMinimum"] = entry.of.range.min;
  if (std::isfinite(entry.of.range.max))
    number[entry.of.range.max_allowed ? "maximum" : "exclusiveMaximum"] = entry.of.range.max;
  if (entry.of.dimension == dimension::none && entry.of.notation == Notation::plain)
    return number;
  return {{"anyOf", Json::array({number, {{"type", "string"}}})}};
}

Json value_schema(const Entry& entry)
{
  switch (entry.of.type)
  {
  case Type::text:
    return {{"type", "string"}};
  case Type::choice:
    return {{"enum", entry.choices}};
  case Type::boolean:
    return {{"type", "boolean"}};
  case Type::integer:
    return number_schema(entry, "integer");
  case Type::number:
    return number_schema(entry, "number");
  case Type::vector3:
    return {{"type", "array"}, {"items", number_schema(entry, "number")}, {"minItems", 3}, {"maxItems", 3}};
  case Type::numbers:
  {
    const Json one = number_schema(entry, "number");
    return {{"anyOf", Json::array({one, {{"type", "array"}, {"items", one}, {"minItems", 1}}})}};
  }
  case Type::snapshots:
    return {{"anyOf", Json::array({{{"type", "string"}, {"pattern", "^(none|aligned|all|every [1-9][0-9]*)$"}},
                                   {{"type", "array"}, {"items", {{"type", "integer"}, {"minimum", 0}}}}})}};
  case Type::words:
  {
    const Json one{{"enum", entry.choices}};
    return {{"anyOf", Json::array({one, {{"type", "array"}, {"items", one}, {"minItems", 1}}})}};
  }
  }
  return Json::object();
}

Json entry_schema(const Entry& entry)
{
  Json schema = value_schema(entry);
  schema["description"] = fmt::format("{} Allowed: {}.", entry.text, allowed_values(entry));
  if (entry.fallback && entry.fallback_in.empty())
    schema["default"] = json_value(*entry.fallback);
  return schema;
}

Json table()
{
  return {{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}};
}

/// The schema of a key or table; missing tables around it are created.
Json& place_of(Json& root, std::string_view key)
{
  Json* place = &root;
  while (!key.empty())
  {
    if (place->is_null())
      *place = table();
    const std::string_view name = key.substr(0, key.find('.'));
    place = &(*place)["properties"][std::string(name)];
    key.remove_prefix(std::min(key.size(), name.size() + 1));
  }
  return *place;
}

} // namespace

std::string schema_json()
{
  Json root = table();
  std::set<std::string> lists; // repeatable tables, allowed as one table or as a list
  for (const Entry& entry : case_schema())
  {
    place_of(root, entry.key) = entry_schema(entry);
    if (!entry.list.empty())
      lists.insert(entry.list);
  }
  for (const std::string& list : lists)
  {
    Json& place = place_of(root, list);
    const Json one = place;
    place = {{"anyOf", Json::array({one, {{"type", "array"}, {"items", one}}})}};
  }
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "A case of brinell"}};
  schema.update(root);
  schema["required"] = {"scenario", "lower", "upper"};
  return schema.dump(2) + "\n";
}

} // namespace brinell::io
