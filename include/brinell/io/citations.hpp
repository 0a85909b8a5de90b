// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"

#include <string>
#include <vector>

/// The papers behind the models of a case, for `brinell cite` and for the results.
namespace brinell::io
{

/// A published source. Fields that a kind of source does not have stay empty.
struct Reference
{
  enum class Kind
  {
    article,
    proceedings, ///< a paper in them
    chapter,     ///< of a book or a series
    book,
    report,
    software
  };
  std::string key; ///< of its BibTeX entry
  Kind kind = Kind::article;
  std::vector<std::string> authors; ///< "Polonsky, I. A."
  int year = 0;
  std::string title;
  std::string container{}; ///< journal, proceedings, book series or institution
  std::string volume{}, number{}, pages{};
  std::string publisher{};
  std::string doi{}; ///< only where it has been looked up
  std::string note{};
};

/// A source and what a case uses it for.
struct Citation
{
  Reference reference;
  std::string use;
};

/// What a case is computed with; each source once.
[[nodiscard]] std::vector<Citation> citations(const Case& c);

/// brinell itself, as in CITATION.cff.
[[nodiscard]] Reference brinell_reference();

/// "Love, A. E. H. (1929). The stress ... Phil. Trans. R. Soc. A 228, 377-420. https://doi.org/..."
[[nodiscard]] std::string reference_text(const Reference& reference);

/// An entry of a .bib file.
[[nodiscard]] std::string bibtex(const Reference& reference);

/// One plain line per source, brinell first: reference and, in brackets, what it is used for.
[[nodiscard]] std::vector<std::string> citation_lines(const Case& c);

} // namespace brinell::io
