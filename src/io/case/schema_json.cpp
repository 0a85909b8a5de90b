// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/schema.hpp"
#include "value_text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace brinell::io
{

namespace
{

using Json = nlohmann::ordered_json;

/// A number in a range; a quantity may be text with a unit instead.
Json number_schema(const Entry& entry, const char* type)
{
  Json number{{"type", type}};
  if (!entry.range.zero_allowed)
    number["not"] = {{"const", 0}};
  if (std::isfinite(entry.range.min))
    number[entry.range.min_allowed ? "minimum" : "exclusiveMinimum"] = entry.range.min;
  if (std::isfinite(entry.range.max))
    number[entry.range.max_allowed ? "maximum" : "exclusiveMaximum"] = entry.range.max;
  if (entry.dimension == dimension::none && !entry.percent && !entry.degrees && !entry.celsius)
    return number;
  return {{"anyOf", Json::array({number, {{"type", "string"}}})}};
}

Json value_schema(const Entry& entry)
{
  switch (entry.type)
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

/// Tables of which there may be several, as one table or as a list.
std::vector<std::string> lists_of_tables()
{
  std::vector<std::string> lists;
  for (const Entry& entry : case_schema())
    if (!entry.list.empty() && (lists.empty() || lists.back() != entry.list))
      lists.push_back(entry.list);
  return lists;
}

} // namespace

std::string schema_json()
{
  Json root = table();
  for (const Entry& entry : case_schema())
  {
    Json* parent = &root;
    std::string_view key = entry.key;
    for (auto dot = key.find('.'); dot != key.npos; dot = key.find('.'))
    {
      Json& properties = (*parent)["properties"];
      const std::string name(key.substr(0, dot));
      if (!properties.contains(name))
        properties[name] = table();
      parent = &properties[name];
      key.remove_prefix(dot + 1);
    }
    (*parent)["properties"][std::string(key)] = entry_schema(entry);
  }
  for (const std::string& list : lists_of_tables())
  {
    Json* place = &root;
    std::string_view rest = list;
    for (std::string_view name; !rest.empty(); rest.remove_prefix(std::min(rest.size(), name.size() + 1)))
    {
      name = rest.substr(0, rest.find('.'));
      place = &(*place)["properties"][std::string(name)];
    }
    const Json one = *place;
    *place = {{"anyOf", Json::array({one, {{"type", "array"}, {"items", one}}})}};
  }
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "A case of brinell"}};
  schema.update(root);
  schema["required"] = {"scenario", "lower", "upper"};
  return schema.dump(2) + "\n";
}

} // namespace brinell::io
