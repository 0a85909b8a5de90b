// SPDX-License-Identifier: BSD-3-Clause
#include "io/npy.hpp"

#include "io/files.hpp"
#include "io/pattern.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

namespace brinell::io
{

namespace
{

static_assert(std::endian::native == std::endian::little, "the bytes of a file are copied without conversion");

constexpr std::string_view magic = "\x93NUMPY";
constexpr std::size_t largest_table = 1'000'000'000; // bytes; as for text files, far more than any instrument delivers
constexpr std::size_t largest_header = 10'000;       // the limit of NumPy itself

/// Information from the header of a file.
struct Head
{
  std::string type; ///< "<f8": float64
  bool is_by_columns = false;
  std::vector<std::size_t> shape{};
  std::size_t length = 0; ///< bytes before the first number

  /// Number of numbers; of a damaged header, which may name any, not more than no file has.
  [[nodiscard]] std::size_t count() const
  {
    constexpr std::size_t most = std::size_t{1} << 40U;
    std::size_t numbers = shape.empty() ? 0 : 1;
    for (const std::size_t along : shape)
      numbers = along != 0 && numbers > most / along ? most : numbers * along;
    return numbers;
  }
};

/// Format of NumPy (numpy.lib.format): magic, version, length of the header, and the header, a Python dictionary as text.
std::optional<Head> head_of(std::string_view content)
{
  if (!content.starts_with(magic) || content.size() < 12)
    return std::nullopt;
  const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(content[i])); };
  const bool is_short = byte(6) == 1;
  const std::size_t begin = is_short ? 10 : 12;
  const std::size_t length = byte(8) | byte(9) << 8 | (is_short ? 0 : byte(10) << 16 | byte(11) << 24);
  if (length > largest_header || begin + length > content.size())
    return std::nullopt;
  const std::string header(content.substr(begin, length));
  static const Pattern type(R"('descr':\s*'([^']*)')"), order(R"('fortran_order':\s*(True|False))"),
      shape(R"('shape':\s*\(((?:\d{1,9},?\s*){1,4})\))");
  Head head;
  head.length = begin + length;
  const auto found_type = type.find(header), found_order = order.find(header);
  if (!found_type || !found_order)
    return std::nullopt;
  head.type = found_type->group(0);
  head.is_by_columns = found_order->group(0) == "True";
  if (const auto found = shape.find(header)) // with more axes the array counts as empty
  {
    std::istringstream numbers(found->group(0));
    for (std::string number; std::getline(numbers, number, ',');)
      if (number.find_first_not_of(' ') != number.npos)
        head.shape.push_back(std::stoul(number));
  }
  return head;
}

template <typename Number>
std::vector<double> values_of(std::string_view bytes, std::size_t count)
{
  std::vector<Number> raw(count);
  std::memcpy(raw.data(), bytes.data(), count * sizeof(Number));
  return {raw.begin(), raw.end()};
}

std::vector<double> by_rows(const std::vector<double>& by_columns, std::size_t rows, std::size_t columns)
{
  std::vector<double> result(by_columns.size());
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i)
      result[j * columns + i] = by_columns[i * rows + j];
  return result;
}

} // namespace

HeightTable read_npy(const std::filesystem::path& file)
{
  const std::string content = input_text(file, largest_table);
  const std::optional<Head> head = head_of(content);
  if (!head)
    throw InputError("is not a .npy file of NumPy, or is damaged");
  if (head->type != "<f8" && head->type != "<f4")
    throw InputError(fmt::format("has numbers of the type \"{}\"; allowed: float64 or float32, as by "
                                 "numpy.save(file, heights.astype(float))",
                                 head->type));
  const std::size_t count = head->count();
  if (count == 0 || head->shape.size() != 2)
    throw InputError("has no rows and columns of numbers; allowed: an array [y, x]");
  const std::string_view bytes = std::string_view(content).substr(head->length);
  const bool is_double = head->type == "<f8";
  if (bytes.size() != count * (is_double ? sizeof(double) : sizeof(float)))
    throw InputError(
        fmt::format("is damaged: it has {} bytes for {} x {} numbers", bytes.size(), head->shape[0], head->shape[1]));
  std::vector<double> values = is_double ? values_of<double>(bytes, count) : values_of<float>(bytes, count);
  if (head->is_by_columns)
    values = by_rows(values, head->shape[0], head->shape[1]);
  return {std::move(values), head->shape[1]};
}

namespace
{

/// Converts the bytes of a file to numbers: those of arrays that tell what is filled are often boolean or integer.
std::vector<double> values_of(std::string_view bytes, const std::string& type, std::size_t count)
{
  const auto of = [&]<typename Number>(Number)
  {
    if (bytes.size() != count * sizeof(Number))
      throw InputError(fmt::format("is damaged: it has {} bytes for {} numbers", bytes.size(), count));
    return values_of<Number>(bytes, count);
  };
  if (type == "|b1" || type == "|u1")
    return of(std::uint8_t{});
  if (type == "|i1")
    return of(std::int8_t{});
  if (type == "<i4")
    return of(std::int32_t{});
  if (type == "<i8")
    return of(std::int64_t{});
  if (type == "<f4")
    return of(float{});
  if (type == "<f8")
    return of(double{});
  throw InputError(fmt::format(
      "has numbers of the type \"{}\"; allowed: bool, int8, uint8, int32, int64, float32 or float64", type));
}

} // namespace

NpyVolume read_npy_volume(const std::filesystem::path& file)
{
  const std::string content = input_text(file, largest_table);
  const std::optional<Head> head = head_of(content);
  if (!head)
    throw InputError("is not a .npy file of NumPy, or is damaged");
  const std::size_t axes = head->shape.size(), count = head->count();
  if (count == 0 || axes < 2 || axes > 3)
    throw InputError(fmt::format("has {} axes and {} numbers; allowed: an array [z, y, x]", axes, count));
  NpyVolume volume{{head->shape[axes - 1], head->shape[axes - 2], axes == 3 ? head->shape[0] : 1}, {}};
  std::vector<double> stored = values_of(std::string_view(content).substr(head->length), head->type, count);
  if (!head->is_by_columns)
  {
    volume.values = std::move(stored);
    return volume;
  }
  const auto [nx, ny, nz] = volume.count;
  volume.values.resize(count);
  for (std::size_t k = 0; k < nz; ++k)
    for (std::size_t j = 0; j < ny; ++j)
      for (std::size_t i = 0; i < nx; ++i)
        volume.values[(k * ny + j) * nx + i] = stored[(i * ny + j) * nz + k];
  return volume;
}

bool is_npy(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string begin(magic.size(), ' ');
  return std::filesystem::is_regular_file(file) && stream.read(begin.data(), std::ssize(begin)) && begin == magic;
}

std::string npy_content(std::span<const double> values, std::size_t columns)
{
  std::string header =
      fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}", values.size() / columns, columns);
  constexpr std::size_t before = 10, alignment = 64; // of the first number in the file
  header.append(alignment - (before + header.size() + 1) % alignment, ' ');
  header += '\n';
  std::string content(magic);
  content += {'\x01', '\x00', static_cast<char>(header.size() % 256), static_cast<char>(header.size() / 256)};
  content += header;
  content.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  return content;
}

} // namespace brinell::io
