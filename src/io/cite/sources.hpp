// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"
#include "brinell/io/citations.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace brinell::io
{

/// Collects sources in the order of their first use; further uses of a source are added to its text.
class Sources
{
public:
  explicit Sources(const Case& c) : case_(c) {}

  /// @param key  of references.bib
  void add(std::string_view key, std::string_view use)
  {
    const auto has_key = [&](const Reference& reference) { return reference.key == key; };
    const auto known = std::find_if(citations_.begin(), citations_.end(),
                                    [&](const Citation& citation) { return has_key(citation.reference); });
    if (known == citations_.end())
    {
      const auto& all = all_references();
      const auto reference = std::find_if(all.begin(), all.end(), has_key);
      if (reference == all.end())
        throw InternalError(fmt::format("references.bib has no entry {}", key));
      citations_.push_back({*reference, std::string(use)});
    }
    else if (known->use.find(use) == known->use.npos) // both bodies may have the same law
      known->use += fmt::format("; {}", use);
  }

  /// Whether a key of the case has the value `word`.
  [[nodiscard]] bool is(std::string_view key, std::string_view word) const
  {
    const Value* value = case_.values.find(key);
    return value && std::get<std::string>(*value) == word;
  }
  [[nodiscard]] bool has(std::string_view key) const { return case_.values.find(key) != nullptr; }
  [[nodiscard]] std::vector<Citation> take() && { return std::move(citations_); }

private:
  const Case& case_;
  std::vector<Citation> citations_;
};

} // namespace brinell::io
