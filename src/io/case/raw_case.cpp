// SPDX-License-Identifier: BSD-3-Clause
#include "raw_case.hpp"

#include "brinell/io/schema.hpp"
#include "brinell/io/units.hpp"
#include "io/files.hpp"
#include "io/text.hpp"
#include "suggestion.hpp"
#include "toml_text.hpp"
#include "value_text.hpp"

#include <algorithm>
#include <toml++/toml.h>

namespace brinell::io
{

namespace
{

constexpr std::size_t longest_shown = 60;

std::string article(std::string_view noun)
{
  return fmt::format("{} {}", noun.front() == 'i' ? "an" : "a", noun);
}

/// For a word where a table is expected: suggests the key of that table that allows the word, such as hardening.law = "none".
std::string key_of_word(const std::string& table, const Raw& raw)
{
  const auto* word = std::get_if<std::string>(&raw.value);
  for (const Entry& entry : case_schema())
    if (word && entry.key.starts_with(plain_key(table) + ".") &&
        std::find(entry.choices.begin(), entry.choices.end(), *word) != entry.choices.end())
      return fmt::format("; did you mean {}{} = {}?", table, entry.key.substr(plain_key(table).size()),
                         toml_text(*word));
  return "";
}

/// Destination of a flattened TOML tree, and how its places are named.
struct Target
{
  RawCase& raw_case;
  Problems& problems;
  std::string override_place; ///< empty for the file itself
  std::string scenario{};     ///< as written in the file, even if it is invalid

  [[nodiscard]] std::string suggestion_for(const std::string& unknown_key) const
  {
    return suggestion(unknown_key, scenario);
  }

  [[nodiscard]] std::string place(const toml::source_region& region) const
  {
    if (!override_place.empty())
      return override_place;
    return region.begin && !raw_case.file.empty() ? fmt::format("{}:{}", raw_case.file, region.begin.line)
                                                  : raw_case.file;
  }
};

void flatten(const toml::table& table, const std::string& prefix, Target& target);

/// Flattens the tables of a list; an empty list counts as missing.
void flatten_list(const toml::array& list, const std::string& path, Target& target)
{
  if (!list.empty())
    target.raw_case.lists.insert_or_assign(path, static_cast<int>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    const std::string table = fmt::format("{}[{}]", path, i);
    const std::string place = target.place(list[i].source());
    if (list[i].is_table())
    {
      target.raw_case.tables.try_emplace(table, place);
      flatten(*list[i].as_table(), table + ".", target);
    }
    else
      target.problems.add(place,
                          fmt::format("{} = {} is {}, but must be a table with the keys {}", table,
                                      shown(raw_value(list[i])), type_name(raw_value(list[i])), known_keys(path)));
  }
}

/// Flattens a table; `prefix` is empty or ends with a dot.
void flatten(const toml::table& table, const std::string& prefix, Target& target)
{
  for (const auto& [key, node] : table)
  {
    const std::string path = prefix + std::string(key.str());
    const std::string place = target.place(key.source());
    if (key.str().find('[') != key.str().npos) // a quoted key; only --set may number a table
      target.problems.add(place, fmt::format("unknown key {}; {}", path, target.suggestion_for(path)));
    else if (find_entry(path))
      target.raw_case.values.insert_or_assign(path, Given{raw_value(node), place, !target.override_place.empty()});
    else if (is_table(path) && node.is_table())
    {
      target.raw_case.tables.try_emplace(path, place);
      flatten(*node.as_table(), path + ".", target);
    }
    else if (is_list_of_tables(path) && node.is_array())
      flatten_list(*node.as_array(), path, target);
    else if (is_table(path))
      target.problems.add(place, fmt::format("{} = {} is {}, but must be a table with the keys {}{}", path,
                                             shown(raw_value(node)), type_name(raw_value(node)), known_keys(path),
                                             key_of_word(path, raw_value(node))));
    else if (node.is_table())
      target.problems.add(place, fmt::format("unknown table {}; {}", path, target.suggestion_for(path)));
    else
      target.problems.add(
          place, fmt::format("unknown key {} = {}; {}", path, shown(raw_value(node)), target.suggestion_for(path)));
  }
}

/// The value of an override as TOML; a bare word, or a bare quantity such as 3.85 mm, is a string.
/// @throws InputError if the value contains a key with too many parts
toml::table override_table(const std::string& value)
{
  if (line_of_deep_key(value))
    throw InputError(too_deep());
  try
  {
    toml::table parsed = toml::parse("value = " + value);
    if (parsed.size() == 1)
      return parsed;
  }
  catch (const toml::parse_error&)
  {
    if (const std::string plain = with_plain_signs(value); plain != value)
      return override_table(plain);
  }
  toml::table text;
  text.insert("value", value);
  return text;
}

/// Removes all keys of a table, because a table or list of tables given to --set replaces it as a whole.
void remove_table(RawCase& raw_case, const std::string& key)
{
  std::erase_if(raw_case.values, [&](const auto& item)
                { return item.first.starts_with(key + ".") || item.first.starts_with(key + "["); });
  std::erase_if(raw_case.lists, [&](const auto& item) { return (item.first + ".").starts_with(key + "."); });
}

/// The repeatable table that contains the key; empty if there is none.
std::string list_of(std::string_view key)
{
  const Entry* entry = find_entry(key);
  return entry ? entry->list : "";
}

/// Checks that keys given by --set refer to existing tables of a list.
void check_lists(const RawCase& raw_case, Problems& problems)
{
  for (const auto& [key, given] : raw_case.values)
  {
    const std::string table = list_of(key);
    if (table.empty())
      continue;
    const auto list = raw_case.lists.find(table);
    const int count = list == raw_case.lists.end() ? 0 : list->second;
    const bool is_numbered = key[table.size()] == '[';
    if (is_numbered && count == 0)
      problems.add(given.place, fmt::format("{} is one table, not a list: leave out the number of {}", table, key));
    else if (!is_numbered && count > 0)
      problems.add(given.place, fmt::format("{0} is a list of {1}: name one of them, as {0}[0]{2}", table, count,
                                            key.substr(table.size())));
    else if (is_numbered && std::stol(key.substr(table.size() + 1, 9)) >= count)
      problems.add(given.place, fmt::format("{} does not exist: the list has {}, counted from 0",
                                            key.substr(0, key.find(']') + 1), count));
  }
}

/// Adds a problem if an override is not UTF-8: results contain their case, and TOML readers accept only UTF-8.
bool has_invalid_utf8(const std::string& text, Problems& problems)
{
  const std::size_t good = valid_utf8(text);
  if (good < text.size())
    problems.add("--set " + text.substr(0, good),
                 fmt::format("the next byte, 0x{:02x}, is not UTF-8", static_cast<unsigned char>(text[good])));
  return good < text.size();
}

void apply_override(const std::string& text, const std::string& scenario, RawCase& raw_case, Problems& problems)
{
  if (has_invalid_utf8(text, problems))
    return;
  Target target{raw_case, problems, "--set " + text, scenario};
  const auto equals = text.find('=');
  const std::string key(trimmed(std::string_view(text).substr(0, equals)));
  if (equals == text.npos || key.empty())
  {
    problems.add(target.override_place, "must have the form section.key=value, as in --set tugging.interference=4");
    return;
  }
  toml::table parsed;
  try
  {
    if (std::count(key.begin(), key.end(), '.') >= deepest_key)
      throw InputError(too_deep());
    parsed = override_table(std::string(trimmed(std::string_view(text).substr(equals + 1))));
  }
  catch (const InputError& error)
  {
    problems.add("--set " + text.substr(0, longest_shown) + "...", error.what());
    return;
  }
  const toml::node& node = *parsed.get("value");
  if (node.is_array() && is_list_of_tables(key))
    remove_table(raw_case, key);
  if (node.is_table() && is_table(key))
  {
    remove_table(raw_case, key);
    return flatten(*node.as_table(), key + ".", target);
  }
  toml::table wrapped; // contains the last part of the key, so that the checks are those of a key in the file
  const auto dot = key.rfind('.');
  wrapped.insert(dot == key.npos ? key : key.substr(dot + 1), node);
  flatten(wrapped, dot == key.npos ? "" : key.substr(0, dot + 1), target);
}

} // namespace

Raw raw_value(const toml::node& node)
{
  if (const auto* b = node.as_boolean())
    return {b->get()};
  if (const auto* i = node.as_integer())
    return {i->get()};
  if (const auto* x = node.as_floating_point())
    return {x->get()};
  if (const auto* s = node.as_string())
    return {s->get()};
  if (const auto* array = node.as_array())
  {
    std::vector<Raw> items;
    for (const toml::node& item : *array)
      items.push_back(raw_value(item));
    return {std::move(items)};
  }
  return {Raw::Other{node.is_table() ? "table" : "date or time"}};
}

std::string type_name(const Raw& raw)
{
  constexpr std::array names{"boolean", "integer", "number", "string", "list"};
  if (const auto* other = std::get_if<Raw::Other>(&raw.value))
    return article(other->type);
  return article(names[raw.value.index()]);
}

std::string shown(const Raw& raw)
{
  std::string text;
  if (const auto* items = std::get_if<std::vector<Raw>>(&raw.value))
  {
    for (const Raw& item : *items)
      text += (text.empty() ? "" : ", ") + shown(item);
    text = "[" + text + "]";
  }
  else
    std::visit(
        [&](const auto& value)
        {
          using T = std::decay_t<decltype(value)>;
          if constexpr (std::is_same_v<T, Raw::Other>)
            text = "(" + value.type + ")";
          else if constexpr (!std::is_same_v<T, std::vector<Raw>>)
            text = toml_text(value);
        },
        raw.value);
  return text.size() <= longest_shown ? text : text.substr(0, longest_shown - 3) + "...";
}

const Given* RawCase::find(std::string_view key) const
{
  const auto found = values.find(key);
  return found == values.end() ? nullptr : &found->second;
}

std::vector<std::string> RawCase::tables_of(const std::string& table) const
{
  const auto list = lists.find(table);
  if (list == lists.end())
    return {table};
  std::vector<std::string> names(static_cast<std::size_t>(list->second));
  for (std::size_t i = 0; i < names.size(); ++i)
    names[i] = fmt::format("{}[{}]", table, i);
  return names;
}

std::string RawCase::place_for(std::string_view missing_key) const
{
  for (auto dot = missing_key.rfind('.'); dot != missing_key.npos; dot = missing_key.rfind('.', dot - 1))
  {
    if (const auto table = tables.find(missing_key.substr(0, dot)); table != tables.end())
      return table->second;
    if (dot == 0)
      break;
  }
  return file;
}

RawCase read_raw_case(std::string_view text, const std::filesystem::path& file,
                      const std::vector<std::string>& overrides, Places places, Problems& problems)
{
  RawCase raw_case;
  raw_case.file = places == Places::lines ? file.string() : "";
  raw_case.folder = file.parent_path();
  const toml::table tree = parse_toml(text, file.string());
  Target target{raw_case, problems, "", tree["scenario"].value_or(std::string())};
  flatten(tree, "", target);
  for (const std::string& item : overrides)
    apply_override(item, target.scenario, raw_case, problems);
  check_lists(raw_case, problems);
  return raw_case;
}

} // namespace brinell::io
