// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <string_view>
#include <variant>

namespace brinell
{

/// One number of a record, with its name and unit in files.
template <typename Record>
struct Column
{
  using Member = std::variant<int Record::*, double Record::*>;

  std::string_view name; ///< name of the member
  std::string_view unit; ///< "1" for a pure number
  Member member;
  std::string_view text{}; ///< description, for files that have descriptions

  [[nodiscard]] constexpr std::variant<int, double> value(const Record& record) const
  {
    return std::visit([&](auto m) { return std::variant<int, double>(record.*m); }, member);
  }
  /// A column of a record is also a column of every derived record.
  template <std::derived_from<Record> Derived>
  constexpr operator Column<Derived>() const // NOLINT(google-explicit-constructor)
  {
    return {name, unit, std::visit([](auto m) { return typename Column<Derived>::Member(m); }, member), text};
  }
};

} // namespace brinell
