// SPDX-License-Identifier: BSD-3-Clause
#include "value_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace brinell::io
{

namespace
{

template <class... Ts>
struct Overload : Ts...
{
  using Ts::operator()...;
};
template <class... Ts>
Overload(Ts...) -> Overload<Ts...>; // clang 14 cannot deduce it for aggregates

/// A TOML float needs a point or an exponent, otherwise it is an integer: fmt writes 1.0 as "1", which would change the type.
std::string number_text(double x)
{
  const std::string text = fmt::format("{}", x);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string rule_word(const SnapshotRule& rule)
{
  return rule.kind == SnapshotRule::Kind::every ? fmt::format("every {}", rule.every)
                                                : rule_words[static_cast<std::size_t>(rule.kind)];
}

} // namespace

std::string toml_string(std::string_view text)
{
  std::string result = "\"";
  for (const char c : text)
  {
    if (c == '"' || c == '\\')
      (result += '\\') += c;
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      result += fmt::format("\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    else
      result += c;
  }
  return result + '"';
}

std::string toml_text(const Value& value)
{
  return std::visit(
      Overload{[](bool b) { return std::string(b ? "true" : "false"); },
               [](std::int64_t i) { return fmt::format("{}", i); }, [](double x) { return number_text(x); },
               [](const std::string& s) { return toml_string(s); },
               [](const Vector3& v)
               { return fmt::format("[{}, {}, {}]", number_text(v[0]), number_text(v[1]), number_text(v[2])); },
               [](const std::vector<double>& v)
               {
                 std::string text;
                 for (const double x : v)
                   text += (text.empty() ? "" : ", ") + number_text(x);
                 return "[" + text + "]";
               },
               [](const std::vector<std::string>& words)
               {
                 std::string text;
                 for (const std::string& word : words)
                   text += (text.empty() ? "" : ", ") + toml_string(word);
                 return "[" + text + "]";
               },
               [](const SnapshotRule& rule)
               {
                 return rule.kind == SnapshotRule::Kind::listed ? fmt::format("[{}]", fmt::join(rule.steps, ", "))
                                                                : toml_string(rule_word(rule));
               }},
      value);
}

nlohmann::ordered_json json_value(const Value& value)
{
  using Json = nlohmann::ordered_json;
  return std::visit(Overload{[](const SnapshotRule& rule) {
                               return rule.kind == SnapshotRule::Kind::listed ? Json(rule.steps)
                                                                              : Json(rule_word(rule));
                             },
                             [](const auto& plain) { return Json(plain); }},
                    value);
}

} // namespace brinell::io
