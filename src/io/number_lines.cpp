// SPDX-License-Identifier: BSD-3-Clause
#include "number_lines.hpp"

#include "io/files.hpp"

#include <sstream>

namespace brinell::io
{

namespace
{

std::optional<std::vector<double>> numbers_of(std::string line)
{
  for (char& c : line)
    if (c == ',' || c == ';' || c == '\t' || c == '\r')
      c = ' ';
  std::istringstream stream(line);
  std::vector<double> values;
  for (double value = 0.0; stream >> value;)
    values.push_back(value);
  if (!stream.eof() || values.empty())
    return std::nullopt;
  return values;
}

} // namespace

std::vector<NumberLine> number_lines(const std::filesystem::path& file)
{
  std::istringstream stream(input_text(file));
  std::vector<NumberLine> lines;
  std::string text;
  for (int number = 1; std::getline(stream, text); ++number)
    if (const auto first = text.find_first_not_of(" \t\r"); first != std::string::npos && text[first] != '#')
      lines.push_back({number, text, numbers_of(text)});
  return lines;
}

} // namespace brinell::io
