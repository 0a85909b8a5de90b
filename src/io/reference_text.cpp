// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/citations.hpp"
#include "brinell/io/versions.hpp"

#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

namespace brinell::io
{

namespace
{

using Kind = Reference::Kind;

/// Ranges have an en dash in BibTeX's way.
std::string with_dash(std::string pages)
{
  if (const auto dash = pages.find('-'); dash != pages.npos)
    pages.replace(dash, 1, "--");
  return pages;
}

std::string entry_type(Kind kind)
{
  switch (kind)
  {
  case Kind::article:
    return "article";
  case Kind::proceedings:
    return "inproceedings";
  case Kind::chapter:
    return "incollection";
  case Kind::book:
    return "book";
  case Kind::report:
    return "techreport";
  case Kind::software:
    return "misc"; // styles without biblatex know no other
  }
  return "misc";
}

std::string container_field(Kind kind)
{
  switch (kind)
  {
  case Kind::article:
    return "journal";
  case Kind::report:
    return "institution";
  default:
    return "booktitle";
  }
}

} // namespace

Reference brinell_reference()
{
  return {.key = "brinell",
          .kind = Kind::software,
          .authors = {"The brinell authors"},
          .year = 0,
          .title = "brinell: elastic-plastic rolling and sliding contact by the semi-analytical method",
          .note = fmt::format("Version {}", library_versions().brinell)};
}

std::string reference_text(const Reference& r)
{
  std::string text = fmt::format("{}", fmt::join(r.authors, ", "));
  if (r.year != 0)
    text += fmt::format(" ({})", r.year);
  text += fmt::format("{} {}.", text.ends_with('.') ? "" : ".", r.title);
  if (!r.container.empty())
    text += ' ' + r.container;
  if (r.kind == Kind::report)
    text += fmt::format(", Report {}", r.number);
  else if (!r.volume.empty())
    text += fmt::format(" {}", r.volume) + (r.number.empty() ? "" : fmt::format(" ({})", r.number));
  if (!r.pages.empty())
    text += fmt::format(", {}", r.pages);
  if (!r.publisher.empty())
    text += fmt::format("{} {}", r.container.empty() ? "" : ",", r.publisher);
  if (!text.ends_with('.'))
    text += '.';
  if (!r.note.empty())
    text += fmt::format(" {}.", r.note);
  return r.doi.empty() ? text : text + fmt::format(" https://doi.org/{}", r.doi);
}

std::string bibtex(const Reference& r)
{
  std::string text = fmt::format("@{}{{{},\n", entry_type(r.kind), r.key);
  const std::string author = fmt::format("{}", fmt::join(r.authors, " and "));
  const std::array<std::pair<std::string, std::string>, 10> fields{{
      {"author", r.kind == Kind::software ? fmt::format("{{{}}}", author) : author}, // a group's name has no parts
      {"title", fmt::format("{{{}}}", r.title)},                                     // keeps its capitals
      {container_field(r.kind), r.container},
      {"volume", r.volume},
      {"number", r.number},
      {"pages", with_dash(r.pages)},
      {"publisher", r.publisher},
      {"year", r.year == 0 ? "" : fmt::format("{}", r.year)},
      {"doi", r.doi},
      {"note", r.note},
  }};
  for (const auto& [name, value] : fields)
    if (!value.empty())
      text += fmt::format("  {} = {{{}}},\n", name, value);
  return text + "}\n";
}

} // namespace brinell::io
