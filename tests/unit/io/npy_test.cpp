// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"
#include "brinell/io/height_file.hpp"
#include "io/npy.hpp"
#include "sample.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

/// Height maps in binary files. The bytes of the first test are those of numpy.save, so that writer and reader cannot be wrong
/// together; the Python tests read and write with NumPy itself.
namespace brinell::io::npy_test
{

namespace
{

/// A file of version 1.0 with some numbers of type Number behind its header.
template <typename Number>
std::string file_of(const std::string& header, const std::vector<Number>& numbers)
{
  std::string content = "\x93NUMPY";
  content += {'\x01', '\x00', static_cast<char>(header.size()), '\x00'};
  content += header;
  content.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
  return content;
}

class Npy : public testing::Test
{
protected:
  HeightTable read(const std::string& content)
  {
    const auto file = folder.path() / "map.npy";
    std::ofstream(file, std::ios::binary) << content;
    return read_npy(file);
  }
  std::string refusal(const std::string& content)
  {
    try
    {
      (void)read(content);
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return "";
  }

  sample::TemporaryFolder folder;
};

TEST_F(Npy, TypesAndOrders)
{
  const std::vector<double> rows{1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  const auto doubles = read(file_of("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }  \n", rows));
  EXPECT_EQ(doubles.heights, rows);
  EXPECT_EQ(doubles.columns, 3U);
  const auto floats = read(
      file_of("{'descr': '<f4', 'fortran_order': False, 'shape': (3, 2), }\n", std::vector<float>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(floats.heights, rows);
  EXPECT_EQ(floats.columns, 2U);
  const auto by_columns = read(
      file_of("{'descr': '<f8', 'fortran_order': True, 'shape': (2, 3), }\n", std::vector<double>{1, 4, 2, 5, 3, 6}));
  EXPECT_EQ(by_columns.heights, rows);
}

TEST_F(Npy, WrittenIsRead)
{
  const std::vector<double> rows{1e-9, -2.0, 3.5, 0.1, 1e300, -0.0};
  const std::string content = npy_content(rows, 2);
  EXPECT_EQ((content.size() - rows.size() * sizeof(double)) % 64, 0U); // as NumPy aligns it
  const HeightTable table = read(content);
  EXPECT_EQ(table.heights, rows);
  EXPECT_EQ(table.columns, 2U);
}

// Element [z, y, x] = [1, 0, 2] of an array of 2 x 3 x 4 is x = 2, y = 0, z = 1 in either order of the bytes.
TEST_F(Npy, VolumesAreReadInEitherOrder)
{
  std::vector<std::int8_t> by_rows(24, 0), by_columns(24, 0);
  by_rows[12 + 2] = by_columns[2 * 6 + 0 * 2 + 1] = 1;
  for (const bool is_by_columns : {false, true})
  {
    const auto file = folder.path() / "volume.npy";
    std::ofstream(file, std::ios::binary)
        << file_of(is_by_columns ? "{'descr': '|b1', 'fortran_order': True, 'shape': (2, 3, 4), }\n"
                                 : "{'descr': '|b1', 'fortran_order': False, 'shape': (2, 3, 4), }\n",
                   is_by_columns ? by_columns : by_rows);
    const NpyVolume volume = read_npy_volume(file);
    EXPECT_EQ(volume.count, (std::array<std::size_t, 3>{4, 3, 2}));
    ASSERT_EQ(volume.values.size(), 24U);
    for (std::size_t i = 0; i < 24; ++i)
      EXPECT_EQ(volume.values[i], i == 14 ? 1.0 : 0.0);
  }
}

TEST_F(Npy, Refusals)
{
  const std::vector<double> two{1.0, 2.0};
  EXPECT_EQ(refusal("1,2\n3,4\n"), "is not a .npy file of NumPy, or is damaged");
  EXPECT_EQ(refusal(""), "is not a .npy file of NumPy, or is damaged");
  EXPECT_EQ(refusal("\x93NUMPY\x01"), "is not a .npy file of NumPy, or is damaged");
  EXPECT_NE(refusal(file_of("{'descr': '|O', 'fortran_order': False, 'shape': (1, 2), }", two)).find("type \"|O\""),
            std::string::npos);
  EXPECT_NE(refusal(file_of("{'descr': '<f8', 'fortran_order': False, 'shape': (2,), }", two)).find("an array [y, x]"),
            std::string::npos);
  EXPECT_NE(
      refusal(file_of("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), }", two)).find("16 bytes for 2 x 2"),
      std::string::npos);
}

// The product of the numbers along the axes is 2^64, which is 0 in 64 bits.
TEST_F(Npy, AHeaderOfMoreNumbersThanThereAreIsRefused)
{
  const auto file = folder.path() / "volume.npy";
  for (const char* order : {"False", "True"})
  {
    std::ofstream(file, std::ios::binary) << file_of(
        fmt::format("{{'descr': '|b1', 'fortran_order': {}, 'shape': (536870912, 536870912, 64), }}\n", order),
        std::vector<std::int8_t>{});
    try
    {
      (void)read_npy_volume(file);
      ADD_FAILURE() << order;
    }
    catch (const InputError& error)
    {
      EXPECT_NE(std::string(error.what()).find("is damaged: it has 0 bytes"), std::string::npos) << error.what();
    }
  }
}

TEST_F(Npy, GapsAreNamedAndAnyEndingIsRead)
{
  const std::vector<double> gap{1.0, std::numeric_limits<double>::quiet_NaN()};
  const auto file = folder.path() / "map.dat";
  std::ofstream(file, std::ios::binary) << file_of("{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2), }", gap);
  const HeightFile read = read_height_file(file, {.unit = "um"});
  EXPECT_EQ(read.table.heights.front(), 1e-6);
  EXPECT_TRUE(std::isnan(read.table.heights.back()));
  EXPECT_EQ(read.gaps, 1u);
  EXPECT_TRUE(gap_text(read).starts_with("has in row 1, column 2 a height that is not finite; fill"));
}

constexpr const char* head = R"(scenario = "rolling"
[rolling]
load = 5
distance = 1e-4
[upper]
shape = {type = "sphere", radius = "2 mm"}
material = {rigid = true}
[lower]
shape = {type = "flat"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
texture = {type = "height_map", file = "FILE", spacing = ["5 um", "5 um"]}
)";

std::string with_file(const std::string& name)
{
  std::string text = head;
  return text.replace(text.find("FILE"), 4, name);
}

std::vector<double> slope(std::size_t count)
{
  std::vector<double> heights;
  for (std::size_t i = 0; i < count; ++i)
    heights.push_back(1e-9 * static_cast<double>(i));
  return heights;
}

/// What `resolved.toml` of a run is, and what `brinell run` makes of it.
TEST_F(Npy, LongMapsOfAResolvedCaseAreFilesThatGiveTheSameCase)
{
  const std::size_t columns = 40;
  const auto heights = slope(30 * columns);
  std::ofstream(folder.path() / "map.npy", std::ios::binary) << npy_content(heights, columns);
  const Case c = parse_case(with_file("map.npy"), folder.path() / "case.toml");
  const auto file = folder.path() / "resolved.toml";
  write_resolved(file, c.values);
  const std::string text = case_file_text(file);
  EXPECT_LT(text.size(), 5000U);
  EXPECT_EQ(text, resolved_files(c.values).text);
  EXPECT_EQ(resolved_text(read_case(file).values), resolved_text(c.values));
  EXPECT_EQ(resolved_text(parse_case(resolved_text(c.values), "elsewhere.toml").values), resolved_text(c.values));

  auto other = heights;
  other.back() += 1e-15;
  std::ofstream(folder.path() / "map.npy", std::ios::binary) << npy_content(other, columns);
  const Case changed = parse_case(with_file("map.npy"), folder.path() / "case.toml");
  EXPECT_NE(resolved_files(changed.values).text, text); // the name tells the content

  std::ofstream(folder.path() / "case-heights-0123456789abcdef.npy") << "somebody's";
  remove_resolved_maps(folder.path());
  std::vector<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    left.push_back(entry.path().filename().string());
  std::sort(left.begin(), left.end());
  EXPECT_EQ(left, (std::vector<std::string>{"case-heights-0123456789abcdef.npy", "map.npy", "resolved.toml"}));
}

TEST_F(Npy, ShortMapsStayInTheText)
{
  std::ofstream(folder.path() / "map.npy", std::ios::binary) << npy_content(slope(20), 5);
  const Case c = parse_case(with_file("map.npy"), folder.path() / "case.toml");
  EXPECT_TRUE(resolved_files(c.values).maps.empty());
  EXPECT_EQ(resolved_files(c.values).text, resolved_text(c.values));
}

TEST_F(Npy, ATableInMemoryIsAsGoodAsAFile)
{
  const HeightTables tables{{"memory:1", {slope(12), 4}}};
  const Case c = parse_case(with_file("memory:1"), "case.toml", {}, Places::none, tables);
  std::ofstream(folder.path() / "map.npy", std::ios::binary) << npy_content(slope(12), 4);
  const Case of_file = parse_case(with_file("map.npy"), folder.path() / "case.toml");
  EXPECT_EQ(resolved_text(c.values), resolved_text(of_file.values));
}

} // namespace

} // namespace brinell::io::npy_test
