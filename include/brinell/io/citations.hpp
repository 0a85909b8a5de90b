// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

/// The papers behind the models of a case, for `brinell cite` and for the results.
namespace brinell::io
{

/// A published source.
struct Reference
{
  std::string key;
  std::string kind;                                       ///< as BibTeX has it: "article", "book", ...
  std::map<std::string, std::string, std::less<>> fields; ///< author, title, year, ... without their braces
  std::string bibtex;                                     ///< entry in BibTeX
};

/// A source and its use in a case.
struct Citation
{
  Reference reference;
  std::string use;
};

/// Sources of the models that a case uses, each once.
[[nodiscard]] std::vector<Citation> citations(const Case& c);

/// All sources that a case may use, and brinell itself: src/io/cite/references.bib.
[[nodiscard]] const std::vector<Reference>& all_references();

/// brinell itself, as in CITATION.cff.
[[nodiscard]] const Reference& brinell_reference();

/// Reads BibTeX in the form of references.bib: one field per line, in braces.
[[nodiscard]] std::vector<Reference> read_bibtex(std::string_view text);

/// "Love, A. E. H. (1929). The stress ... Phil. Trans. R. Soc. A 228, 377-420. https://doi.org/..."
[[nodiscard]] std::string reference_text(const Reference& reference);

/// One plain line per source, brinell first: reference and, in brackets, what it is used for.
[[nodiscard]] std::vector<std::string> citation_lines(const Case& c);

} // namespace brinell::io
