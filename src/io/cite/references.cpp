// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/citations.hpp"
#include "io/embedded.hpp"
#include "io/text.hpp"

#include <fmt/format.h>
#include <sstream>

namespace brinell::io
{

namespace
{

/// The field of a line such as `  title = {{Contact Mechanics}},`.
std::pair<std::string, std::string> field_of(const std::string& line, std::size_t equals)
{
  const auto name = line.find_first_not_of(' ');
  const auto first = line.find_first_not_of("= {", equals), last = line.find_last_not_of("},");
  return {line.substr(name, line.find(' ', name) - name), line.substr(first, last + 1 - first)};
}

} // namespace

std::vector<Reference> read_bibtex(std::string_view text)
{
  std::vector<Reference> references;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);)
  {
    if (line.empty() || line.front() == '%')
      continue;
    if (const auto brace = line.find('{'); line.front() == '@')
      references.push_back({line.substr(brace + 1, line.find(',') - brace - 1), line.substr(1, brace - 1), {}, {}});
    else if (const auto equals = line.find('='); equals != line.npos)
      references.back().fields.insert(field_of(line, equals));
    references.back().bibtex += line + '\n';
  }
  return references;
}

const std::vector<Reference>& all_references()
{
  static const std::vector<Reference> references = read_bibtex(embedded_text("src/io/cite/references.bib"));
  return references;
}

const Reference& brinell_reference()
{
  return all_references().front();
}

std::string reference_text(const Reference& reference)
{
  const auto field = [&](std::string_view name)
  {
    const auto found = reference.fields.find(name);
    return found == reference.fields.end() ? std::string() : found->second;
  };
  /// The field between two texts; nothing without it.
  const auto part = [&](std::string_view before, std::string_view name, std::string_view after = "")
  {
    const std::string value = field(name);
    return value.empty() ? value : fmt::format("{}{}{}", before, value, after);
  };
  std::string text = replaced(field("author"), " and ", ", ") + part(" (", "year", ")");
  text += (text.ends_with('.') ? " " : ". ") + field("title") + ".";
  const std::string container = part(" ", "journal") + part(" ", "booktitle") + part(" ", "institution");
  text += container;
  text +=
      reference.kind == "techreport" ? part(", Report ", "number") : part(" ", "volume") + part(" (", "number", ")");
  text += replaced(part(", ", "pages"), "--", "-") + part(container.empty() ? " " : ", ", "publisher");
  return text + (text.ends_with('.') ? "" : ".") + part(" ", "note", ".") + part(" https://doi.org/", "doi");
}

} // namespace brinell::io
