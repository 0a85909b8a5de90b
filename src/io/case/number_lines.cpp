// SPDX-License-Identifier: BSD-3-Clause
#include "number_lines.hpp"

#include "brinell/foundation/error.hpp"
#include "curve_file.hpp"
#include "io/npy.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fmt/format.h>
#include <sstream>
#include <string_view>
#include <system_error>

namespace brinell::io
{

namespace
{

/// Between any of the separators.
std::vector<std::string> words_of(std::string line, std::string_view separators)
{
  std::replace_if(
      line.begin(), line.end(), [&](char c) { return separators.find(c) != separators.npos; }, ' ');
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back(word);
  return words;
}

/// Whether a word stands for what was not measured.
bool is_missing(std::string word)
{
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
  word.erase(0, word.find_first_not_of("+-"));
  return word == "nan" || word == "inf" || word == "infinity";
}

/// "12", "-0,5" or "1,5e-6"; what stands for no measurement counts, too.
bool is_number_with_decimal_comma(const std::string& word)
{
  if (is_missing(word))
    return true;
  std::string_view rest = word;
  const auto skip_sign = [&] { rest.remove_prefix(!rest.empty() && (rest[0] == '+' || rest[0] == '-') ? 1 : 0); };
  const auto skip_digits = [&]
  {
    const auto count = std::min(rest.find_first_not_of("0123456789"), rest.size());
    rest.remove_prefix(count);
    return count > 0;
  };
  skip_sign();
  if (!skip_digits())
    return false;
  if (!rest.empty() && rest[0] == ',')
  {
    rest.remove_prefix(1);
    if (!skip_digits())
      return false;
  }
  if (rest.empty())
    return true;
  if (rest[0] != 'e' && rest[0] != 'E')
    return false;
  rest.remove_prefix(1);
  skip_sign();
  return skip_digits() && rest.empty();
}

bool has_decimal_commas(const std::vector<TextLine>& lines)
{
  const auto has_comma = [](const TextLine& line) { return line.text.find(',') != line.text.npos; };
  const auto fits = [](const TextLine& line)
  {
    const std::vector<std::string> words = words_of(line.text, ";\t\r");
    return (words.size() > 1 || line.text.find(';') != line.text.npos) &&
           std::all_of(words.begin(), words.end(), is_number_with_decimal_comma);
  };
  return std::any_of(lines.begin(), lines.end(), has_comma) && std::all_of(lines.begin(), lines.end(), fits);
}

std::vector<double> numbers_of(const std::vector<std::string>& words)
{
  std::vector<double> values;
  for (const std::string& word : words)
  {
    const char* const begin = word.data() + (word.front() == '+' ? 1 : 0);
    const char* const end = word.data() + word.size();
    double value = 0.0;
    if (const auto [stop, error] = std::from_chars(begin, end, value); error != std::errc() || stop != end)
      return {};
    values.push_back(value);
  }
  return values;
}

} // namespace

std::vector<NumberLine> number_lines(const std::filesystem::path& file)
{
  const std::vector<TextLine> texts = text_lines(file);
  const bool decimal = has_decimal_commas(texts);
  std::vector<NumberLine> lines;
  std::string first; // of what was not measured
  std::size_t missing = 0;
  for (const TextLine& line : texts)
  {
    std::vector<std::string> words = words_of(line.text, decimal ? ";\t\r" : ",;\t\r");
    for (std::size_t i = 0; i < words.size(); ++i)
    {
      if (decimal)
        std::replace(words[i].begin(), words[i].end(), ',', '.');
      if (!is_missing(words[i]))
        continue;
      if (first.empty())
        first = fmt::format("line {}, column {}", line.number, i + 1);
      ++missing;
    }
    lines.push_back({line.number, line.text, numbers_of(words)});
  }
  if (missing > 0)
    throw InputError(not_measured(first, missing));
  return lines;
}

} // namespace brinell::io
