// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"

#include <fmt/format.h>
#include <string>
#include <string_view>
#include <utility>

namespace brinell::simulation
{

/// A member of a case has a value that is not allowed, or that other members do not go with. The text gives the value and what is
/// allowed, and names members between backticks, as in "`RollingCase::spin` = 3 rad/m; allowed: 0". Those who know other names for
/// the members, such as the keys of a case file, put them in their place. A drive or an amplitude is named by its kind,
/// `SlidingCase::load`, a member of a body by `member_of`.
class PlanError : public InputError
{
public:
  /// An error of the member that the text names first.
  template <typename... Values>
  explicit PlanError(fmt::format_string<Values...> text, Values&&... values)
      : PlanError(Text{fmt::format(text, std::forward<Values>(values)...)})
  {
  }

  /// An error of a member that the text need not name. @param member  with its backticks
  template <typename... Values>
  [[nodiscard]] static PlanError at(std::string_view member, fmt::format_string<Values...> text, Values&&... values)
  {
    PlanError error(Text{fmt::format(text, std::forward<Values>(values)...)});
    error.member_ = first_member(member);
    return error;
  }

  /// "RollingCase::spin"; empty if none is named.
  [[nodiscard]] const std::string& member() const { return member_; }

private:
  struct Text
  {
    std::string value;
  };
  explicit PlanError(const Text& text) : InputError(text.value), member_(first_member(text.value)) {}

  static std::string first_member(std::string_view text)
  {
    const auto begin = text.find('`');
    if (begin == text.npos)
      return {};
    return std::string(text.substr(begin + 1, text.find('`', begin + 1) - begin - 1));
  }

  std::string member_;
};

/// A member of a body, "lower" or "upper", as messages name it: "`lower.shape`".
[[nodiscard]] inline std::string member_of(std::string_view body, std::string_view member)
{
  return fmt::format("`{}.{}`", body, member);
}

} // namespace brinell::simulation
