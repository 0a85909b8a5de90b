// SPDX-License-Identifier: BSD-3-Clause
#include "case_values.hpp"

#include "value_convert.hpp"
#include "value_text.hpp"

#include <algorithm>
#include <set>

namespace brinell::io
{

namespace
{

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
    for (const Entry& entry : case_schema())
      resolve(entry);
    return std::move(values_);
  }

private:
  void resolve(const Entry& entry)
  {
    const Given* given = raw_.find(entry.key);
    if (broken_.contains(entry.when.key))
      return; // whether the key applies is not known: its parent has been reported
    if (!applies(entry.when))
    {
      if (given && !overridden(*given, entry.when.key))
        not_applicable(entry, *given);
      return;
    }
    const Given* rival = entry.excludes.empty() ? nullptr : raw_.find(entry.excludes);
    if (given && rival && overridden(*given, entry.excludes))
      given = nullptr;
    else if (given && rival && !overridden(*rival, entry.key) && reported_rivals_.insert(entry.excludes).second &&
             reported_rivals_.insert(entry.key).second)
      add(entry, *given,
          fmt::format("cannot stand together with {} ({}); keep one of them", entry.excludes, rival->place));
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

  /// Whether `given` of the file loses its meaning because the command line sets `other`.
  [[nodiscard]] bool overridden(const Given& given, std::string_view other) const
  {
    const Given* rival = raw_.find(other);
    return !given.from_command_line && rival && rival->from_command_line;
  }

  void convert(const Entry& entry, const Given& given)
  {
    bool pure = false;
    if (!entry.pure_if.empty())
    {
      if (broken_.contains(entry.pure_if))
        return;
      const Value* flag = values_.find(entry.pure_if);
      pure = flag && std::get<bool>(*flag);
    }
    try
    {
      values_.set(entry.key, converted(given.raw, entry, pure));
    }
    catch (const InputError& error)
    {
      add(entry, given, error.what());
    }
  }

  void missing(const Entry& entry)
  {
    const bool pure =
        !entry.pure_if.empty() && values_.find(entry.pure_if) && std::get<bool>(*values_.find(entry.pure_if));
    Entry plain = entry;
    plain.pure_if.clear();
    if (pure)
      plain.dimension = dimension::none;
    problems_.add(raw_.place_for(entry.key),
                  fmt::format("{} is missing; allowed: {}{}{}", entry.key, allowed_values(plain),
                              entry.hint.empty() ? "" : "; ", entry.hint));
    broken_.insert(entry.key);
  }

  void not_applicable(const Entry& entry, const Given& given)
  {
    const Value* parent = values_.find(entry.when.key);
    add(entry, given,
        fmt::format("applies only with {} = {}; it is {}{}", entry.when.key, alternatives(entry.when.values),
                    parent ? toml_text(*parent) : "not set", raw_.find(entry.when.key) ? "" : " by default"));
  }

  void add(const Entry& entry, const Given& given, std::string_view what)
  {
    problems_.add(given.place, fmt::format("{} = {} {}", entry.key, shown(given.raw), what));
    broken_.insert(entry.key);
  }

  const RawCase& raw_;
  Problems& problems_;
  CaseValues values_;
  std::set<std::string, std::less<>> broken_; ///< keys that have been reported
  std::set<std::string, std::less<>> reported_rivals_;
};

} // namespace

CaseValues resolved_values(const RawCase& raw_case, Problems& problems)
{
  return Resolver(raw_case, problems).resolve();
}

} // namespace brinell::io
