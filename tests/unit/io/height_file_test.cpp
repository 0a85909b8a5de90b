// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/height_file.hpp"
#include "brinell/io/printable.hpp"
#include "io/files.hpp"
#include "sample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

/// Text of measured heights as instruments, spreadsheets and people write it.
namespace brinell::io::height_file_test
{

namespace
{

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

class HeightText : public testing::Test
{
protected:
  HeightFile read(const std::string& content, const HeightFileOptions& options = {})
  {
    const auto file = folder_.path() / "map.csv";
    std::ofstream(file, std::ios::binary) << content;
    return read_height_text(file, options);
  }
  std::string refused(const std::string& content, const HeightFileOptions& options = {})
  {
    try
    {
      (void)read(content, options);
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    ADD_FAILURE() << content << " is accepted";
    return "";
  }
  void expect(const std::string& content, const std::vector<double>& heights, std::size_t columns,
              const HeightFileOptions& options = {})
  {
    const HeightFile file = read(content, options);
    ASSERT_EQ(file.table.columns, columns) << content;
    ASSERT_EQ(file.table.heights.size(), heights.size()) << content;
    for (std::size_t i = 0; i < heights.size(); ++i)
      EXPECT_TRUE(std::isnan(heights[i]) ? std::isnan(file.table.heights[i])
                                         : std::abs(file.table.heights[i] - heights[i]) <= 1e-15 * std::abs(heights[i]))
          << content << "\n " << i << ": " << file.table.heights[i];
  }
  void expect_refused(const std::string& content, const std::string& part, const HeightFileOptions& options = {})
  {
    const std::string text = refused(content, options);
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n  in: " << text;
  }

  sample::TemporaryFolder folder_;
};

// A cell that is dropped would move all others to the left.
TEST_F(HeightText, EmptyCellsAreGaps)
{
  const std::vector<double> heights{1, gap, 3, 4, gap, 2, 3, 4, 1, 2, gap, 4, 1, 2, 3, gap};
  for (const char* text :
       {"1,,3,4\n,2,3,4\n1,2,,4\n1,2,3,\n", "1;;3;4\n;2;3;4\n1;2;;4\n1;2;3;\n",
        "1\t\t3\t4\n\t2\t3\t4\n1\t2\t\t4\n1\t2\t3\t", "1, , 3, 4\r\n , 2, 3, 4\r\n1, 2, , 4\r\n1, 2, 3, \r\n",
        "1,\"\",3,4\n\"\",2,3,4\n1,2,\"\",4\n1,2,3,\"\"\n", "1 nan 3 4\nBad 2 3 4\n1 2 No Data 4\n1 2 3 N/A\n",
        "1;;3,0;4\n;2;3;4\n1;2;;4\n1;2;3;\n", "1;--;3;4\n***;2;3;4\n1;2;NULL;4\n1;2;3;-inf\n"})
    expect(text, heights, 4);
  const HeightFile file = read("# measured\n\n1,2\n3,\n,6\n");
  EXPECT_EQ(file.gaps, 2u);
  EXPECT_EQ(gap_text(file).substr(0, 64), "has in line 4, column 2 a height that is not finite, the first o");
  expect("1,2\n,\n5,6\n", {1, 2, gap, gap, 5, 6}, 2);
}

TEST_F(HeightText, SeparatorsAtTheEndOfAllLinesAreNoColumn)
{
  expect("1,2,\n3,4,\n", {1, 2, 3, 4}, 2);
  expect("\t1\t2\n\t3\t4\n", {1, 2, 3, 4}, 2);
  expect("0,5;\n1,5;\n", {0.5, 1.5}, 1);
  expect_refused("1,2,\n3,4\n",
                 "has in line 2 \"3,4\"; allowed: 3 heights in m or the given unit, as in line 1, not 2");
}

TEST_F(HeightText, RowsOfOtherLengthsAndWordsAreRefusedWithTheirLine)
{
  expect_refused("1 2 3\n\n4 5\n",
                 "has in line 3 \"4 5\"; allowed: 3 heights in m or the given unit, as in line 1, not 2");
  expect_refused("1 2 3\n4 5 6x\n", "\"6x\" is no number");
  expect_refused("1;2 300;3\n4;5 600;6\n", "\"2 300\" is no number"); // thousands, no four columns
  expect_refused("\"1,5\",\"2,5\"\n", "no number");                   // no four columns either
  expect_refused("", "has no heights");
}

TEST_F(HeightText, LinesEndAsInAnySystem)
{
  for (const char* text : {"1 2\n3 4\n", "1 2\r\n3 4\r\n", "1 2\r3 4\r", "1 2\n3 4",
                           "\xef\xbb\xbf"
                           "1 2\n3 4\n\x1a"})
    expect(text, {1, 2, 3, 4}, 2);
}

TEST_F(HeightText, OfAnyEncodingIsRead)
{
  std::string little = "\xff\xfe", big = "\xfe\xff";
  for (const char c : std::string("1;2\n3;-4\n"))
  {
    (little += c) += '\0';
    (big += '\0') += c;
  }
  expect(little, {1, 2, 3, -4}, 2);
  expect(big, {1, 2, 3, -4}, 2);
  const std::string header = "# Breite: 4,0 \xb5m\n# H\xf6he: 2,0 \xb5m\n# Werteinheiten: nm\n"; // Latin-1
  const HeightFile file = read(header + "1;2\n3;4\n");
  EXPECT_DOUBLE_EQ(file.spacing->at(0), 2e-6);
  EXPECT_DOUBLE_EQ(file.spacing->at(1), 1e-6);
  EXPECT_DOUBLE_EQ(file.table.heights[3], 4e-9);
  EXPECT_EQ(from_utf16(std::string("\xac\x20\x3d\xd8\x00\xde\x00\xd8", 8), false), "\u20ac\U0001F600\ufffd");
}

TEST_F(HeightText, BytesThatAreNoTextAreEscapedAndNamed)
{
  expect_refused("1;2 \xb5;3\n4;5;6\n", "has in line 1 \"1;2 \\xb5;3\"");
  expect_refused("1;2 \xb5;3\n4;5;6\n", "brinell surface convert");
  expect_refused("1;2 \u00b5;3\n4;5;6\n", "\"1;2 \u00b5;3\"");
  EXPECT_THROW((void)read(std::string("\x88\x1b\x03o\0\x01\0\0"
                                      "1 2 3\n",
                                      14)),
               NoHeightText);
  expect_refused(std::string("1 2\n\0 3\n", 8), "is no text: its byte 5 is 0x00");
  // A message never breaks off within a character, and can always be shown.
  const std::string text =
      refused("1 2 " + std::string(17, 'x') + "\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4");
  EXPECT_EQ(valid_utf8(text), text.size()) << text;
  EXPECT_EQ(printable("a\xff\u00e4\xc3"), "a\\xff\u00e4\\xc3");
}

TEST_F(HeightText, OtherBlanksAndMinusSignsAreRead)
{
  expect("1\u00a02\n\u22123\u202f4e\u22122\n", {1, 2, -3, 0.04}, 2);
  expect("1,5\u2009\u22122\n0 0\n", {1.5, -2, 0, 0}, 2);
}

std::string points(const char* separator, const char* title = "")
{
  std::string text = title;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 5; ++i)
      text += fmt::format("{1}{0}{2}{0}{3}\n", separator, 2 * i, 3 * j, 10 * j + i);
  return text;
}

TEST_F(HeightText, PointsOfAGridAreAMap)
{
  std::vector<double> heights;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 5; ++i)
      heights.push_back((10 * j + i) * 1e-6);
  const HeightFileOptions um{.unit = "um"};
  for (const char* separator : {" ", ",", ";", "\t", ", "})
  {
    expect(points(separator), heights, 5, um);
    const auto spacing = read(points(separator), um).spacing.value();
    EXPECT_DOUBLE_EQ(spacing[0], 2e-6);
    EXPECT_DOUBLE_EQ(spacing[1], 3e-6);
  }
  expect_refused(points(" "), "is a list of points x, y, z that tells no unit; give the argument unit");
  const std::string titled = points(",", "X [mm],Y [mm],Z [um]\n");
  expect(titled, heights, 5);
  EXPECT_DOUBLE_EQ(read(titled).spacing->at(1), 3e-3);
  expect_refused(titled, "tells its unit, um; leave out unit = 'nm'", {.unit = "nm"});
  expect(points(" ", "# x y z\n"), heights, 5, um);
  const std::string gwyddion = points(" ", "# Channel: Z\n# Lateral units: \u00b5m\n# Value units: nm\n");
  EXPECT_DOUBLE_EQ(read(gwyddion).spacing->at(0), 2e-6);
  EXPECT_DOUBLE_EQ(read(gwyddion).table.heights[19], 34e-9);
  // Any order: here from right to left, column by column.
  std::string turned;
  for (int i = 4; i >= 0; --i)
    for (int j = 0; j < 4; ++j)
      turned += fmt::format("{} {} {}\n", 2 * i, 3 * j, 10 * j + i);
  expect(turned, heights, 5, um);
}

TEST_F(HeightText, PointsThatAreNotThereAreNamed)
{
  std::string text, without_row;
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 4; ++i)
    {
      text += i == 2 && j == 1 ? "" : fmt::format("{} {} {}\n", i, j, i == 3 && j == 4 ? "No Data" : "1");
      without_row += j == 2 ? "" : fmt::format("{} {} 1\n", i, j);
    }
  const HeightFile file = read(text, {.unit = "um"});
  EXPECT_EQ(file.table.heights.size(), 20u);
  EXPECT_EQ(file.gaps, 2u);
  EXPECT_EQ(file.first_gap, "at x = 2, y = 1 no point");
  EXPECT_EQ(read(without_row, {.unit = "um"}).first_gap, "at x = 0, y = 2 no point");
  EXPECT_EQ(read(without_row, {.unit = "um"}).gaps, 4u);
  std::string astray = text; // one coordinate is wrong: no grid of twice as many columns
  astray.replace(astray.find("3 3 1"), 5, "2.5 3 1");
  expect_refused(astray, "points x, y, z that are not on a grid of equal steps", {.unit = "um"});
  const HeightFileOptions as_points{.unit = "um", .layout = HeightLayout::points};
  expect_refused("0 0 1\n1 0 1\n0 1 1\n1 1 1\n0 1 2\n", "has the point x = 0, y = 1 twice, in line 3 and line 5",
                 as_points);
}

TEST_F(HeightText, ThreeColumnsThatCouldBeEitherAreAskedAbout)
{
  expect("1 2 3\n4 5 6\n", {1, 2, 3, 4, 5, 6}, 3); // no grid
  std::string scattered;
  for (int i = 0; i < 12; ++i)
    scattered += fmt::format("{} {} {}\n", i * i, 7 * i % 5 * 0.3 + 0.01 * i, i);
  expect_refused(scattered, "Say which, as layout = 'rows' or layout = 'points'", {.unit = "um"});
  EXPECT_EQ(read(scattered, {.layout = HeightLayout::rows}).table.columns, 3u);
  expect_refused(scattered, "not on a grid of equal steps", {.unit = "um", .layout = HeightLayout::points});
  EXPECT_EQ(read(points(" "), {.layout = HeightLayout::rows}).table.columns, 3u);
  std::string profile, with_intensity;
  for (int i = 0; i < 12; ++i)
  {
    profile += fmt::format("{} {}\n", 0.5 * i, i % 3);
    with_intensity += fmt::format("{} {} {} 7\n", i % 4, i / 4, i);
  }
  expect_refused(profile, "a profile x, z is no map");
  expect_refused(with_intensity, "has four columns, the first two of which are the places of a grid");
  EXPECT_EQ(height_layout("points"), HeightLayout::points);
  EXPECT_THROW((void)height_layout("columns"), InputError);
}

TEST_F(HeightText, HeadersTellUnitsAndSizes)
{
  const HeightFile spip =
      read("# File Format = ASCII\n# x-pixels = 2\n# y-pixels = 3\n# x-length = 10\n# y-length = 30\n"
           "# x-unit = um\n# y-unit = um\n# z-unit = nm\n1 2\n3 4\n5 6\n");
  EXPECT_DOUBLE_EQ(spip.spacing->at(0), 5e-6);
  EXPECT_DOUBLE_EQ(spip.spacing->at(1), 10e-6);
  EXPECT_DOUBLE_EQ(spip.table.heights[5], 6e-9);
  expect_refused("# x-pixels = 2\n# y-pixels = 4\n1 2\n3 4\n", "has 2 rows of heights, but announces 4 in line 2");
  const HeightFile own = read("# spacing = [1e-6, \"2 um\"]\n# x = 1e-5\n# y = -2\n# periodic = true\n1,2\n3,4\n");
  EXPECT_DOUBLE_EQ(own.spacing->at(1), 2e-6);
  EXPECT_EQ(own.x, 1e-5);
  EXPECT_EQ(own.y, -2.0);
  EXPECT_EQ(own.periodic, true);
  const std::string gwyddion = "# Channel: Z\n# Width: 4\u202f\u00b5m\n# Height: 2 \u00b5m\n";
  expect_refused(gwyddion + "1 2\n3 4\n", "has no line '# Value units: m'");
  expect_refused(gwyddion + "# Value units: V\n1 2\n3 4\n",
                 "has in line 4 \"# Value units: V\": V is no unit of length");
  expect_refused(gwyddion + "# Value units: V\n1 2\n3 4\n", "has in line 4", {.unit = "nm"});
  expect_refused(gwyddion + "# Value units: nm\n1 2\n3 4\n", "tells its unit, nm; leave out unit = 'um' (line 4",
                 {.unit = "um"});
  expect(gwyddion + "# Value units: nm\n1 2\n3 4\n", {1e-9, 2e-9, 3e-9, 4e-9}, 2, {.unit = "nm"});
  EXPECT_THROW((void)read(gwyddion + "# Value units: m\n1 2\n# Channel: Phase\n3 4\n"), NoHeightText);
}

class HeightCase : public testing::Test
{
protected:
  Case read(const std::string& content, const std::string& keys)
  {
    std::ofstream(folder_.path() / "map.csv", std::ios::binary) << content;
    return parse_case(fmt::format(R"(scenario = "indentation"
[lower]
shape = {{ type = "flat" }}
material = {{ young_modulus = "210 GPa", poisson_ratio = 0.3 }}
texture = {{ type = "height_map", file = "map.csv"{} }}
[upper]
shape = {{ type = "sphere", radius = "1 mm" }}
material = {{ rigid = true }}
[indentation]
load = ["1 N"]
)",
                                  keys),
                      folder_.path() / "case.toml");
  }
  std::string refused(const std::string& content, const std::string& keys)
  {
    try
    {
      (void)read(content, keys);
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return "";
  }
  static const simulation::HeightMap& map_of(const Case& c)
  {
    return std::get<simulation::HeightMap>(std::get<simulation::IndentationCase>(c.scenario).lower.texture.parts.at(0));
  }

  sample::TemporaryFolder folder_;
};

TEST_F(HeightCase, TakesFromTheFileWhatItDoesNotGive)
{
  const std::string content = "# spacing = [1e-6, 2e-6]\n# x = 1e-5\n# y = 0.0\n# periodic = true\n1e-9,0\n0,1e-9\n";
  const Case c = read(content, "");
  EXPECT_EQ(map_of(c).dx, 1e-6);
  EXPECT_EQ(map_of(c).dy, 2e-6);
  EXPECT_EQ(map_of(c).x, 1e-5);
  EXPECT_TRUE(map_of(c).periodic);
  EXPECT_TRUE(c.warnings.empty());
  const Case other = read(content, ", spacing = [\"3 um\", \"2 um\"], periodic = false, x = 0");
  EXPECT_EQ(map_of(other).dx, 3e-6);
  EXPECT_EQ(map_of(other).x, 0.0);
  EXPECT_FALSE(map_of(other).periodic);
  ASSERT_FALSE(other.warnings.empty());
  EXPECT_NE(other.warnings.front().text.find("the file has points every 1e-06 x 2e-06 m"), std::string::npos)
      << other.warnings.front().text;
  EXPECT_NE(refused("1e-9,0\n0,1e-9\n", "").find("case.toml:5: lower.texture.spacing is missing; allowed: "),
            std::string::npos);
}

TEST_F(HeightCase, PointsAndGapsAreThoseOfOtherReaders)
{
  const Case points = read("0,0,1\n2,0,2\n0,3,3\n2,3,4\n", ", unit = \"um\"");
  EXPECT_EQ(map_of(points).nx, 2);
  EXPECT_DOUBLE_EQ(map_of(points).dy, 3e-6);
  EXPECT_EQ(map_of(read("0,0,1\n2,0,2\n0,3,3\n2,3,4\n", ", unit = \"nm\", layout = \"rows\", spacing = [1, 1]")).nx, 3);
  const std::string gaps = refused("1,,3\n1,2,\n", ", unit = \"nm\", spacing = [1e-6, 1e-6]");
  EXPECT_NE(gaps.find("has in line 1, column 2 a height that is not finite, the first of 2; fill"), std::string::npos)
      << gaps;
  // A plane is harmonic.
  const Case filled = read("1,2,3\n2,,4\n3,4,5\n", ", unit = \"nm\", spacing = [1e-6, 1e-6], fill = true");
  EXPECT_NEAR(map_of(filled).heights[4], 3e-9, 1e-17);
  EXPECT_EQ(resolved_text(filled.values).find("fill"), std::string::npos);
  EXPECT_NE(refused(std::string("\0\1", 2), "").find("makes one of formats of instruments"), std::string::npos);
}

TEST_F(HeightCase, IsReadInUtf16AndNamesBytesThatAreNotUtf8)
{
  std::string text = "\xff\xfe";
  for (const char c : std::string(sample::case_text))
    (text += c) += '\0';
  const auto file = folder_.path() / "case.toml";
  std::ofstream(file, std::ios::binary) << text;
  EXPECT_EQ(read_case(file).title, "sample");
  std::ofstream(file, std::ios::binary) << "# 1\nradius = \"1 \xb5m\"\n";
  try
  {
    (void)read_case(file);
    ADD_FAILURE();
  }
  catch (const InputError& error)
  {
    const std::string message = error.what();
    EXPECT_NE(message.find("case.toml: has in line 2, after \"radius = \"1 \", the byte 0xb5, which is not UTF-8"),
              std::string::npos)
        << message;
  }
}

} // namespace

} // namespace brinell::io::height_file_test
