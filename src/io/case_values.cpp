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
  Resolver(const RawCase& raw_case, Problems& problems) : m_raw(raw_case), m_problems(problems) {}

  CaseValues resolve() &&
  {
    for (const Entry& entry : case_schema())
      resolve(entry);
    return std::move(m_values);
  }

private:
  void resolve(const Entry& entry)
  {
    const Given* given = m_raw.find(entry.key);
    if (m_broken.contains(entry.when.key))
      return; // whether the key applies is not known: its parent has been reported
    if (!applies(entry.when))
    {
      if (given && !overridden(*given, entry.when.key))
        not_applicable(entry, *given);
      return;
    }
    const Given* rival = entry.excludes.empty() ? nullptr : m_raw.find(entry.excludes);
    if (given && rival && overridden(*given, entry.excludes))
      given = nullptr;
    else if (given && rival && !overridden(*rival, entry.key) && m_reported_rivals.insert(entry.excludes).second &&
             m_reported_rivals.insert(entry.key).second)
      add(entry, *given,
          fmt::format("cannot stand together with {} ({}); keep one of them", entry.excludes, rival->place));
    if (given)
      convert(entry, *given);
    else if (entry.required)
      missing(entry);
    else if (entry.fallback && !rival)
      m_values.set(entry.key, entry.other_fallback && applies(entry.other_fallback->when) ? entry.other_fallback->value
                                                                                          : *entry.fallback);
  }

  [[nodiscard]] bool applies(const Condition& when) const
  {
    if (when.key.empty())
      return true;
    const Value* value = m_values.find(when.key);
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
    const Given* rival = m_raw.find(other);
    return !given.from_command_line && rival && rival->from_command_line;
  }

  void convert(const Entry& entry, const Given& given)
  {
    bool pure = false;
    if (!entry.pure_if.empty())
    {
      if (m_broken.contains(entry.pure_if))
        return;
      const Value* flag = m_values.find(entry.pure_if);
      pure = flag && std::get<bool>(*flag);
    }
    try
    {
      m_values.set(entry.key, converted(given.raw, entry, pure));
    }
    catch (const InputError& error)
    {
      add(entry, given, error.what());
    }
  }

  void missing(const Entry& entry)
  {
    const bool pure =
        !entry.pure_if.empty() && m_values.find(entry.pure_if) && std::get<bool>(*m_values.find(entry.pure_if));
    Entry plain = entry;
    plain.pure_if.clear();
    if (pure)
      plain.dimension = dimension::none;
    m_problems.add(m_raw.place_for(entry.key),
                   fmt::format("{} is missing; allowed: {}{}{}", entry.key, allowed_values(plain),
                               entry.hint.empty() ? "" : "; ", entry.hint));
    m_broken.insert(entry.key);
  }

  void not_applicable(const Entry& entry, const Given& given)
  {
    const Value* parent = m_values.find(entry.when.key);
    add(entry, given,
        fmt::format("applies only with {} = {}; it is {}{}", entry.when.key, alternatives(entry.when.values),
                    parent ? toml_text(*parent) : "not set", m_raw.find(entry.when.key) ? "" : " by default"));
  }

  void add(const Entry& entry, const Given& given, std::string_view what)
  {
    m_problems.add(given.place, fmt::format("{} = {} {}", entry.key, shown(given.raw), what));
    m_broken.insert(entry.key);
  }

  const RawCase& m_raw;
  Problems& m_problems;
  CaseValues m_values;
  std::set<std::string, std::less<>> m_broken; ///< keys that have been reported
  std::set<std::string, std::less<>> m_reported_rivals;
};

} // namespace

CaseValues resolved_values(const RawCase& raw_case, Problems& problems)
{
  return Resolver(raw_case, problems).resolve();
}

} // namespace brinell::io
