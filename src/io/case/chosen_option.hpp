// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "body_options.hpp"
#include "brinell/foundation/error.hpp"
#include "case_reader.hpp"

#include <limits>

namespace brinell::io
{

/// The option that a key names.
template <typename Product>
const Option<Product>& chosen(const CaseReader& reader, const std::string& key,
                              const std::vector<Option<Product>>& options)
{
  const auto& name = reader.get<std::string>(key);
  for (const Option<Product>& option : options)
    if (option.name == name)
      return option;
  throw InternalError(fmt::format("{} = {} is in the schema, but is not built", key, name));
}

/// What it makes of its numbers in a table, which ends with a dot.
template <typename Product>
Product made(const CaseReader& reader, const std::string& table, const Option<Product>& option)
{
  std::vector<double> numbers;
  for (const std::string& key : option.keys) // a length that is not given has no end
    numbers.push_back(reader.has(table + key) ? reader.get<double>(table + key)
                                              : std::numeric_limits<double>::infinity());
  return option.make(numbers.data());
}

} // namespace brinell::io
