// SPDX-License-Identifier: BSD-3-Clause
#include "case_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace brinell::io
{

namespace
{

/// Text of the allowed values of a key, followed by the hint about usual values.
std::string allowed(const Entry& entry, bool pure)
{
  Entry plain = entry;
  plain.pure_if.clear();
  if (pure)
    plain.of.dimension = dimension::none;
  if (!entry.one_of.empty())
    plain.hint = "one of " + in_words(keys_of_group(entry.one_of));
  return fmt::format("allowed: {}{}{}", allowed_values(plain), plain.hint.empty() ? "" : "; ", plain.hint);
}

InputError wrong_type(const Raw& raw, const Entry& entry, bool pure)
{
  const bool is_list = std::holds_alternative<std::vector<Raw>>(raw.value);
  const bool takes_one = entry.of.type == Type::number || entry.of.type == Type::integer;
  return InputError(fmt::format(
      "is {}; {}{}", type_name(raw), allowed(entry, pure),
      is_list && takes_one ? "; this key takes one value; brinell sweep runs the case for several values" : ""));
}

double from_quantity(const std::string& text, const Entry& entry, bool pure)
{
  const Quantity given = quantity(text);
  if (pure && given.dimension == entry.of.dimension)
    throw InputError(fmt::format("is a {}, but {} = true; allowed: a number without unit, or {} = false",
                                 dimension_name(given.dimension), entry.pure_if, entry.pure_if));
  if (given.dimension == dimension::none)
    throw InputError(fmt::format("has no unit; allowed: a number in {} without quotes, or with a unit as in \"{}\"",
                                 si_unit(entry.of.dimension), example_quantity(entry.of.dimension)));
  if (given.dimension != entry.of.dimension)
    throw InputError(fmt::format("is a {}; {}", dimension_name(given.dimension), allowed(entry, pure)));
  return given.value;
}

/// The number of "1 %" or "0.01".
std::optional<double> share_of(const std::string& text)
try
{
  const Quantity given = quantity(text);
  return given.dimension == dimension::none ? std::optional(given.value) : std::nullopt;
}
catch (const InputError&)
{
  return std::nullopt;
}

double from_text(const std::string& text, const Raw& raw, const Entry& entry, bool pure)
{
  switch (entry.of.notation)
  {
  case Notation::share:
    if (const auto share = share_of(text))
      return *share;
    break;
  case Notation::angle:
    return degrees(text);
  case Notation::temperature:
    return degrees_celsius(text);
  case Notation::plain:
    break;
  }
  if (entry.of.dimension == dimension::none)
    throw wrong_type(raw, entry, pure);
  return from_quantity(text, entry, pure);
}

double number(const Raw& raw, const Entry& entry, bool pure)
{
  double x = 0.0;
  if (const auto* i = std::get_if<std::int64_t>(&raw.value))
    x = static_cast<double>(*i);
  else if (const auto* d = std::get_if<double>(&raw.value))
    x = *d;
  else if (const auto* text = std::get_if<std::string>(&raw.value))
    x = from_text(*text, raw, entry, pure);
  else
    throw wrong_type(raw, entry, pure);
  if (!std::isfinite(x))
    throw InputError(fmt::format("is not a finite number; {}", allowed(entry, pure)));
  if (!entry.of.range.contains(x))
    throw InputError(fmt::format("is out of range; {}{}", allowed(entry, pure),
                                 entry.of.notation == Notation::share &&
                                         !std::holds_alternative<std::string>(raw.value) &&
                                         entry.of.range.contains(x / 100.0)
                                     ? fmt::format("; did you mean \"{:g} %\"?", x)
                                     : ""));
  return x;
}

std::int64_t integer(const Raw& raw, const Entry& entry)
{
  const auto* i = std::get_if<std::int64_t>(&raw.value);
  if (!i && std::holds_alternative<std::vector<Raw>>(raw.value))
    throw wrong_type(raw, entry, false);
  if (!i)
    throw InputError(fmt::format("is {}, not an integer; {}", type_name(raw), allowed(entry, false)));
  if (!entry.of.range.contains(static_cast<double>(*i)))
    throw InputError(fmt::format("is out of range; {}", allowed(entry, false)));
  return *i;
}

std::vector<double> numbers(const Raw& raw, const Entry& entry, bool pure)
{
  const auto* items = std::get_if<std::vector<Raw>>(&raw.value);
  if (const auto* text = std::get_if<std::string>(&raw.value); text && text->starts_with('[')) // from --set
    throw InputError("is text and not a list; in a list, text stands between quotes, as in '[\"10 N\", 0]'");
  if (!items && entry.of.type == Type::numbers)
    return {number(raw, entry, pure)};
  if (!items)
    throw wrong_type(raw, entry, pure);
  std::vector<double> result;
  for (const Raw& item : *items)
    try
    {
      result.push_back(number(item, entry, pure));
    }
    catch (const InputError& error)
    {
      throw InputError(fmt::format("has the element {}, which {}", shown(item), error.what()));
    }
  if (result.empty() || (entry.of.type == Type::vector3 && result.size() != 3))
    throw InputError(fmt::format("has {} elements; {}", result.size(), allowed(entry, pure)));
  return result;
}

Vector3 vector3(const Raw& raw, const Entry& entry)
{
  const std::vector<double> items = numbers(raw, entry, false);
  return {items[0], items[1], items[2]};
}

/// Combines a choice per axis, ["open", "periodic"], into the word for both axes, "periodic_y".
std::string choice_per_axis(const std::vector<Raw>& axes, const Raw& raw, const Entry& entry)
{
  const auto* x = axes.size() == 2 ? std::get_if<std::string>(&axes[0].value) : nullptr;
  const auto* y = axes.size() == 2 ? std::get_if<std::string>(&axes[1].value) : nullptr;
  if (!x || !y)
    throw wrong_type(raw, entry, false);
  for (const std::string* word : {x, y})
    if (*word != "open" && *word != "periodic")
      throw InputError(fmt::format(
          "has the element {}, which is not known; allowed along an axis: \"open\", \"periodic\"", toml_string(*word)));
  return *x == *y ? *x : *x == "periodic" ? "periodic_x" : "periodic_y";
}

std::string choice(const Raw& raw, const Entry& entry)
{
  if (const auto* axes = std::get_if<std::vector<Raw>>(&raw.value); axes && entry.per_axis)
    return choice_per_axis(*axes, raw, entry);
  const auto* word = std::get_if<std::string>(&raw.value);
  if (!word)
    throw wrong_type(raw, entry, false);
  if (std::find(entry.choices.begin(), entry.choices.end(), *word) == entry.choices.end())
    throw InputError(fmt::format("is not known; {}", allowed(entry, false)));
  return *word;
}

/// A list of choices, or one of them.
std::vector<std::string> words(const Raw& raw, const Entry& entry)
{
  const auto* items = std::get_if<std::vector<Raw>>(&raw.value);
  if (!items)
    return {choice(raw, entry)};
  std::vector<std::string> result;
  for (const Raw& item : *items)
  {
    const auto* word = std::get_if<std::string>(&item.value);
    if (!word || std::find(entry.choices.begin(), entry.choices.end(), *word) == entry.choices.end())
      throw InputError(fmt::format("has the element {}, which is not known; {}", shown(item), allowed(entry, false)));
    result.push_back(*word);
  }
  if (result.empty())
    throw InputError(fmt::format("has no elements; {}", allowed(entry, false)));
  return result;
}

SnapshotRule rule_from_word(const std::string& word, const Entry& entry)
{
  using Kind = SnapshotRule::Kind;
  if (const auto known = std::find(rule_words.begin(), rule_words.end(), word); known != rule_words.end())
    return {.kind = static_cast<Kind>(known - rule_words.begin())};
  constexpr std::string_view every = "every ";
  int n = 0;
  if (word.starts_with(every))
  {
    const auto [end, error] = std::from_chars(word.data() + every.size(), word.data() + word.size(), n);
    if (error == std::errc{} && end == word.data() + word.size() && n >= 1)
      return {.kind = Kind::every, .every = n};
  }
  throw InputError(fmt::format("is not known; {}", allowed(entry, false)));
}

SnapshotRule snapshot_rule(const Raw& raw, const Entry& entry)
{
  if (const auto* word = std::get_if<std::string>(&raw.value))
    return rule_from_word(*word, entry);
  const auto* items = std::get_if<std::vector<Raw>>(&raw.value);
  if (!items)
    throw wrong_type(raw, entry, false);
  SnapshotRule rule{.kind = SnapshotRule::Kind::listed};
  for (const Raw& item : *items)
  {
    const auto* step = std::get_if<std::int64_t>(&item.value);
    if (!step || *step < 0 || *step > std::numeric_limits<int>::max())
      throw InputError(
          fmt::format("has the element {}, which is not a step number; {}", shown(item), allowed(entry, false)));
    rule.steps.push_back(static_cast<int>(*step));
  }
  std::sort(rule.steps.begin(), rule.steps.end());
  rule.steps.erase(std::unique(rule.steps.begin(), rule.steps.end()), rule.steps.end());
  return rule;
}

/// Converts a written value to the type of the entry, in SI.
/// @param pure  whether the number is dimensionless here (Entry::pure_if holds)
/// @throws InputError; its text continues a sentence that begins with "key = value"
Value converted(const Raw& raw, const Entry& entry, bool pure)
{
  switch (entry.of.type)
  {
  case Type::text:
    if (const auto* text = std::get_if<std::string>(&raw.value))
      return *text;
    throw wrong_type(raw, entry, pure);
  case Type::choice:
    return choice(raw, entry);
  case Type::boolean:
    if (const auto* flag = std::get_if<bool>(&raw.value))
      return *flag;
    throw wrong_type(raw, entry, pure);
  case Type::integer:
    return integer(raw, entry);
  case Type::number:
    return number(raw, entry, pure);
  case Type::vector3:
    return vector3(raw, entry);
  case Type::numbers:
    return numbers(raw, entry, pure);
  case Type::snapshots:
    return snapshot_rule(raw, entry);
  case Type::words:
    return words(raw, entry);
  }
  throw InternalError("a type of the case schema has no conversion");
}

std::string alternatives(const std::vector<std::string>& words)
{
  std::string text;
  for (const auto& word : words)
    text += (text.empty() ? "" : " or ") + (word == "true" || word == "false" ? word : toml_string(word));
  return text;
}

class Resolver
{
public:
  Resolver(const RawCase& raw_case, Problems& problems) : raw_(raw_case), problems_(problems) {}

  CaseValues resolve() &&
  {
    std::string last_list;
    for (const Entry& entry : case_schema())
      if (entry.list.empty() || !raw_.lists.contains(entry.list))
        resolve(entry);
      else if (entry.list != last_list)
        resolve_list(last_list = entry.list);
    return std::move(values_);
  }

private:
  /// Resolves the tables of a list one after the other; conditions and exclusions refer to keys of the same table.
  void resolve_list(const std::string& list)
  {
    for (const std::string& table : raw_.tables_of(list))
      for (Entry entry : case_schema())
        if (entry.list == list)
        {
          for (std::string* key : {&entry.key, &entry.when.key, &entry.excludes})
            if (key->starts_with(list + "."))
              *key = table + key->substr(list.size());
          resolve(entry);
        }
  }

  void resolve(const Entry& entry)
  {
    const Given* given = raw_.find(entry.key);
    if (broken_.contains(entry.when.key))
      return; // it is unknown whether the key applies, since the key that decides this has a problem already
    if (!applies(entry.when))
    {
      if (given && !overridden(*given, entry.when.key))
        not_applicable(entry, *given);
      return;
    }
    const Given* rival = entry.excludes.empty() ? nullptr : raw_.find(entry.excludes);
    if (given && (overridden_by_group(entry, *given) || (rival && overridden(*given, entry.excludes))))
      given = nullptr;
    else if (given && rival && !overridden(*rival, entry.key) && reported_rivals_.insert(entry.excludes).second &&
             reported_rivals_.insert(entry.key).second)
      add(entry, *given,
          fmt::format("cannot stand together with {}{}; keep one of them", entry.excludes,
                      rival->place.empty() ? "" : fmt::format(" ({})", rival->place)));
    if (given)
      convert(entry, *given);
    else if (entry.required)
      missing(entry);
    else if (entry.fallback && !rival)
      values_.set(entry.key, *fallback_of(entry, scenario()));
  }

  [[nodiscard]] std::string scenario() const
  {
    const Value* value = values_.find("scenario");
    return value ? std::get<std::string>(*value) : "";
  }

  [[nodiscard]] bool applies(const Condition& when) const
  {
    if (when.key.empty())
      return true;
    const Value* value = values_.find(when.key);
    if (!value)
      return false;
    const auto* flag = std::get_if<bool>(value);
    const auto* word = std::get_if<std::string>(value);
    const std::string given = flag ? (*flag ? "true" : "false") : (word ? *word : "");
    return std::find(when.values.begin(), when.values.end(), given) != when.values.end();
  }

  /// Whether the key `given` of the file is to be ignored because the command line sets `other`.
  [[nodiscard]] bool overridden(const Given& given, std::string_view other) const
  {
    const Given* rival = raw_.find(other);
    return !given.from_command_line && rival && rival->from_command_line;
  }

  /// Whether a key of the file is to be ignored because the command line sets another key of its group (Entry::one_of).
  [[nodiscard]] bool overridden_by_group(const Entry& entry, const Given& given) const
  {
    if (entry.one_of.empty())
      return false;
    const auto rivals = keys_of_group(entry.one_of);
    return std::any_of(rivals.begin(), rivals.end(), [&](const std::string& key) { return overridden(given, key); });
  }

  /// Whether the number is dimensionless here.
  [[nodiscard]] bool is_pure(const Entry& entry) const
  {
    const Value* flag = entry.pure_if.empty() ? nullptr : values_.find(entry.pure_if);
    return flag && std::get<bool>(*flag);
  }

  void convert(const Entry& entry, const Given& given)
  {
    if (broken_.contains(entry.pure_if))
      return;
    try
    {
      values_.set(entry.key, converted(given.raw, entry, is_pure(entry)));
    }
    catch (const InputError& error)
    {
      add(entry, given, error.what());
    }
  }

  void missing(const Entry& entry)
  {
    if (!broken_.contains("scenario")) // otherwise it is unknown which keys are needed
      problems_.add(raw_.place_for(entry.key),
                    fmt::format("{} is missing; {}", entry.key, allowed(entry, is_pure(entry))));
    broken_.insert(entry.key);
  }

  void not_applicable(const Entry& entry, const Given& given)
  {
    const Value* parent = values_.find(entry.when.key);
    add(entry, given,
        fmt::format("applies only with {} = {}; it is {}{}{}", entry.when.key, alternatives(entry.when.values),
                    parent ? toml_text(*parent) : "not set", raw_.find(entry.when.key) ? "" : " by default",
                    entry.when.instead.empty() ? "" : "; allowed: " + entry.when.instead));
  }

  void add(const Entry& entry, const Given& given, std::string_view text)
  {
    problems_.add(given.place, fmt::format("{} = {} {}", entry.key, shown(given.raw), text));
    broken_.insert(entry.key);
  }

  const RawCase& raw_;
  Problems& problems_;
  CaseValues values_;
  std::set<std::string, std::less<>> broken_; ///< keys with a reported problem
  std::set<std::string, std::less<>> reported_rivals_;
};

} // namespace

CaseValues resolved_values(const RawCase& raw_case, Problems& problems)
{
  return Resolver(raw_case, problems).resolve();
}

} // namespace brinell::io
