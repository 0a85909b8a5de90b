// SPDX-License-Identifier: BSD-3-Clause
#include "hdf5.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <fmt/format.h>
#include <omp.h>
#include <zlib.h>

/// Attributes and datasets.
namespace brinell::io::h5
{

namespace
{

/// Longest side of a chunk, by the number of dimensions; 64^3 doubles are 2 MB, a good size for the deflate filter.
constexpr std::array<hsize_t, 4> longest_chunk_side{1, 4096, 512, 64};
constexpr int deflate_level = 1; ///< fields are smooth or zero: higher levels gain little and cost much

template <typename Number>
hid_t type_of()
{
  return std::is_same_v<Number, int> ? H5T_NATIVE_INT : H5T_NATIVE_DOUBLE;
}

/// Type of the stored numbers of a field.
template <typename Number>
hid_t stored_type(Precision precision)
{
  return std::is_same_v<Number, double> && precision == Precision::single ? H5T_NATIVE_FLOAT : type_of<Number>();
}

/// Text type of variable length, because a fixed length cannot hold an empty string, and in UTF-8 because of titles.
Handle text_type()
{
  Handle type = checked(H5Tcopy(H5T_C_S1), "make a string type");
  check(H5Tset_size(type.id(), H5T_VARIABLE), "size a string type");
  check(H5Tset_cset(type.id(), H5T_CSET_UTF8), "set UTF-8");
  return type;
}

/// Data space of an array; an empty shape means a single value.
Handle space_of(std::span<const hsize_t> shape)
{
  return checked(shape.empty() ? H5Screate(H5S_SCALAR)
                               : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                 "make a data space");
}

/// Data space of an array in which a box is selected.
Handle selection(std::span<const hsize_t> shape, const Box& box)
{
  Handle space = space_of(shape);
  check(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, box.start.data(), nullptr, box.count.data(), nullptr),
        "select a part of a dataset");
  return space;
}

void write_attribute_of(const Handle& object, const char* name, hid_t type, std::span<const hsize_t> shape,
                        const void* data)
{
  const std::string what = fmt::format("write the attribute {}", name);
  const Handle attribute =
      checked(H5Acreate2(object.id(), name, type, space_of(shape).id(), H5P_DEFAULT, H5P_DEFAULT), what);
  check(H5Awrite(attribute.id(), type, data), what);
}

template <typename Number>
void write_list_attribute(const Handle& object, const char* name, std::span<const Number> values)
{
  const hsize_t size = values.size();
  write_attribute_of(object, name, type_of<Number>(), {&size, 1}, values.data());
}

/// @param data    nullptr: the dataset is created without writing data
/// @param stored  type in the file; HDF5 converts
Handle write_dataset_of(const Handle& group, const std::string& name, hid_t type, std::span<const hsize_t> shape,
                        const void* data, hid_t creation = H5P_DEFAULT, hid_t stored = H5I_INVALID_HID)
{
  const std::string what = fmt::format("write the dataset {}", name);
  Handle dataset = checked(H5Dcreate2(group.id(), name.c_str(), stored == H5I_INVALID_HID ? type : stored,
                                      space_of(shape).id(), H5P_DEFAULT, creation, H5P_DEFAULT),
                           what);
  if (data)
    check(H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), what);
  return dataset;
}

/// Sides of the chunks. They divide the shape evenly, because chunks are stored as a whole: 69 cells in chunks of 64 would take
/// the space of 128.
std::vector<hsize_t> sides_of_chunk(std::span<const hsize_t> shape)
{
  std::vector<hsize_t> sides(shape.begin(), shape.end());
  for (hsize_t& side : sides)
  {
    const hsize_t longest = longest_chunk_side.at(shape.size());
    const hsize_t count = std::max<hsize_t>(1, (side + longest - 1) / longest);
    side = (side + count - 1) / count;
  }
  return sides;
}

Handle chunks(std::span<const hsize_t> shape, Storage storage)
{
  Handle creation = properties(H5P_DATASET_CREATE);
  if (storage == Storage::contiguous)
    return creation;
  const std::vector<hsize_t> chunk = sides_of_chunk(shape);
  check(H5Pset_chunk(creation.id(), static_cast<int>(chunk.size()), chunk.data()), "set the chunks");
  if (storage == Storage::plain)
  {
    check(H5Pset_fletcher32(creation.id()), "set the checksum filter");
    return creation;
  }
  check(H5Pset_shuffle(creation.id()), "set the shuffle filter");
  check(H5Pset_deflate(creation.id(), deflate_level), "set the deflate filter");
  return creation;
}

} // namespace

void write_attribute(const Handle& object, const char* name, std::string_view text)
{
  const std::string copy(text);
  const char* data = copy.c_str();
  write_attribute_of(object, name, text_type().id(), {}, &data);
}

void write_attribute(const Handle& object, const char* name, double value)
{
  write_attribute_of(object, name, H5T_NATIVE_DOUBLE, {}, &value);
}

void write_attribute(const Handle& object, const char* name, int value)
{
  write_attribute_of(object, name, H5T_NATIVE_INT, {}, &value);
}

void write_attribute(const Handle& object, const char* name, std::span<const double> values)
{
  write_list_attribute(object, name, values);
}

void write_attribute(const Handle& object, const char* name, std::span<const int> values)
{
  write_list_attribute(object, name, values);
}

void write_fixed_attribute(const Handle& object, const char* name, std::string_view text)
{
  const Handle type = checked(H5Tcopy(H5T_C_S1), "make a string type");
  check(H5Tset_size(type.id(), text.size()), "size a string type");
  check(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), "pad a string type");
  write_attribute_of(object, name, type.id(), {}, text.data());
}

namespace
{

void require_values(const char* name, std::size_t values, std::span<const std::size_t> shape)
{
  std::size_t size = 1;
  for (const std::size_t n : shape)
    size *= n;
  if (size != values || size == 0)
    throw InternalError(fmt::format("field {} has {} values on a grid of {} cells", name, values, size));
}

/// One chunk of a part of a field.
struct Chunk
{
  std::size_t part; ///< to which it belongs
  std::array<hsize_t, 3> offset;
  std::vector<unsigned char> stored{};
};

/// A part of a field, and its values.
struct Part
{
  std::size_t field;
  Slab slab;
  std::vector<double> values{};
};

hsize_t as_hsize(int count)
{
  return static_cast<hsize_t>(count);
}

/// The numbers of a chunk; 0 beyond the end of the field, like the fill value of HDF5.
std::vector<double> numbers_of(const Part& part, const Chunk& chunk, std::span<const hsize_t> shape,
                               std::span<const hsize_t> sides)
{
  const auto& [k0, j0, i0] = chunk.offset;
  const Slab& slab = part.slab;
  std::vector<double> numbers(sides[0] * sides[1] * sides[2]);
  for (hsize_t k = k0; k < std::min(k0 + sides[0], shape[0]); ++k)
    for (hsize_t j = j0; j < std::min(j0 + sides[1], shape[1]); ++j)
    {
      const hsize_t row = (k - as_hsize(slab.first_layer)) * as_hsize(slab.rows) + j - as_hsize(slab.first_row);
      std::copy_n(part.values.begin() + static_cast<std::ptrdiff_t>(row * shape[2] + i0),
                  std::min(sides[2], shape[2] - i0),
                  numbers.begin() + static_cast<std::ptrdiff_t>(((k - k0) * sides[1] + j - j0) * sides[2]));
    }
  return numbers;
}

/// A chunk as the HDF5 filters shuffle and deflate store it: the first bytes of all numbers, then their second bytes and so on,
/// as a zlib stream. Unlike HDF5, this function may be called by several threads at the same time.
template <typename Number>
std::vector<unsigned char> shuffled_and_deflated(std::span<const Number> numbers)
{
  const std::span<const std::byte> bytes = std::as_bytes(numbers);
  std::vector<unsigned char> shuffled(bytes.size());
  for (std::size_t byte = 0; byte < sizeof(Number); ++byte)
    for (std::size_t i = 0; i < numbers.size(); ++i)
      shuffled[byte * numbers.size() + i] = std::to_integer<unsigned char>(bytes[i * sizeof(Number) + byte]);
  uLongf size = compressBound(shuffled.size());
  std::vector<unsigned char> deflated(size);
  if (compress2(deflated.data(), &size, shuffled.data(), shuffled.size(), deflate_level) != Z_OK)
    throw InternalError("a field cannot be deflated");
  deflated.resize(size);
  deflated.shrink_to_fit();
  return deflated;
}

std::vector<unsigned char> shuffled_and_deflated(const std::vector<double>& numbers, Precision precision)
{
  if (precision == Precision::double_precision)
    return shuffled_and_deflated(std::span<const double>(numbers));
  const std::vector<float> singles(numbers.begin(), numbers.end());
  return shuffled_and_deflated(std::span<const float>(singles));
}

/// The chunks of parts, compressed by all threads.
std::vector<Chunk> deflated_chunks(std::span<const Part> parts, std::span<const hsize_t> shape,
                                   std::span<const hsize_t> sides, Precision precision)
{
  std::vector<Chunk> chunks;
  for (std::size_t part = 0; part < parts.size(); ++part)
    for (hsize_t i = 0; i < shape[2]; i += sides[2])
      chunks.push_back({part, {as_hsize(parts[part].slab.first_layer), as_hsize(parts[part].slab.first_row), i}});
  std::exception_ptr failure; // such as lack of memory; an exception must not leave the parallel loop
#pragma omp parallel for schedule(dynamic)
  for (Chunk& chunk : chunks)
    try
    {
      chunk.stored = shuffled_and_deflated(numbers_of(parts[chunk.part], chunk, shape, sides), precision);
    }
    catch (...)
    {
#pragma omp critical
      failure = std::current_exception();
    }
  if (failure)
    std::rethrow_exception(failure);
  return chunks;
}

/// The datasets of fields, which are written in parts.
class Datasets
{
public:
  Datasets(const Handle& group, const std::array<std::size_t, 3>& shape, std::span<const char* const> names,
           std::span<const std::string> long_names, std::string_view units, Storage storage, Precision precision)
      : shape_(shape.begin(), shape.end()), sides_(sides_of_chunk(shape_)), is_deflated_(storage == Storage::deflated),
        precision_(precision)
  {
    const Handle creation = chunks(shape_, storage);
    for (std::size_t field = 0; field < names.size(); ++field)
    {
      names_.push_back(fmt::format("write the dataset {}", names[field]));
      datasets_.push_back(
          write_dataset_of(group, names[field], stored_type<double>(precision), shape_, nullptr, creation.id()));
      write_attribute(datasets_.back(), "units", units);
      write_attribute(datasets_.back(), "long_name", long_names[field]);
    }
  }

  void write(std::span<const Part> parts) const
  {
    if (!is_deflated_)
    {
      for (const Part& part : parts)
        write_plain(part);
      return;
    }
    constexpr std::uint32_t all_filters = 0;
    for (const Chunk& chunk : deflated_chunks(parts, shape_, sides_, precision_))
    {
      const std::size_t field = parts[chunk.part].field;
      check(H5Dwrite_chunk(datasets_[field].id(), H5P_DEFAULT, all_filters, chunk.offset.data(), chunk.stored.size(),
                           chunk.stored.data()),
            names_[field]);
    }
  }

private:
  void write_plain(const Part& part) const
  {
    const Slab& slab = part.slab;
    const Box box{{as_hsize(slab.first_layer), as_hsize(slab.first_row), 0},
                  {as_hsize(slab.layers), as_hsize(slab.rows), shape_[2]}};
    check(H5Dwrite(datasets_[part.field].id(), H5T_NATIVE_DOUBLE, space_of(box.count).id(), selection(shape_, box).id(),
                   H5P_DEFAULT, part.values.data()),
          names_[part.field]);
  }

  std::vector<hsize_t> shape_, sides_;
  bool is_deflated_;
  Precision precision_;
  std::vector<std::string> names_;
  std::vector<Handle> datasets_;
};

} // namespace

template <typename Number>
void write_dataset(const Handle& group, const char* name, const std::vector<Number>& values,
                   std::span<const std::size_t> shape, std::string_view units, std::string_view long_name,
                   Storage storage, Precision precision)
{
  require_values(name, values.size(), shape);
  const std::vector<hsize_t> dims(shape.begin(), shape.end());
  const Handle dataset = write_dataset_of(group, name, type_of<Number>(), dims, values.data(),
                                          chunks(dims, storage).id(), stored_type<Number>(precision));
  write_attribute(dataset, "units", units);
  write_attribute(dataset, "long_name", long_name);
}

template void write_dataset(const Handle&, const char*, const std::vector<double>&, std::span<const std::size_t>,
                            std::string_view, std::string_view, Storage, Precision);
template void write_dataset(const Handle&, const char*, const std::vector<int>&, std::span<const std::size_t>,
                            std::string_view, std::string_view, Storage, Precision);

std::vector<Slab> slabs(const std::array<std::size_t, 3>& shape)
{
  const std::vector<hsize_t> dims(shape.begin(), shape.end());
  const std::vector<hsize_t> sides = sides_of_chunk(dims);
  const auto rest = [](hsize_t of, hsize_t first, hsize_t side)
  { return static_cast<int>(std::min(side, of - first)); };
  std::vector<Slab> slabs;
  for (hsize_t k = 0; k < dims[0]; k += sides[0])
    for (hsize_t j = 0; j < dims[1]; j += sides[1])
      slabs.push_back(
          {static_cast<int>(k), rest(dims[0], k, sides[0]), static_cast<int>(j), rest(dims[1], j, sides[1])});
  return slabs;
}

void write_fields(const Handle& group, const LayeredFields& fields, std::span<const char* const> names,
                  std::span<const std::string> long_names, std::string_view units, Storage storage, Precision precision)
{
  constexpr std::size_t numbers_of_chunk = 64 * 64 * 64; // of the largest
  const std::size_t numbers_at_once = numbers_of_chunk * static_cast<std::size_t>(omp_get_max_threads());
  const Datasets datasets(group, fields.shape(), names, long_names, units, storage, precision);
  std::vector<Part> parts;
  std::size_t numbers = 0;
  for (std::size_t field = 0; field < names.size(); ++field)
    for (const Slab& slab : slabs(fields.shape()))
    {
      parts.push_back({field, slab, fields.part(field, slab)});
      numbers += parts.back().values.size();
      if (numbers < numbers_at_once)
        continue;
      datasets.write(parts);
      parts.clear();
      numbers = 0;
    }
  datasets.write(parts);
}

void write_text(const Handle& group, const char* name, std::string_view text)
{
  const std::string copy(text);
  const char* data = copy.c_str();
  (void)write_dataset_of(group, name, text_type().id(), {}, static_cast<const void*>(&data));
}

void write_virtual_dataset(const Handle& group, const char* name, std::span<const hsize_t> shape, double fill,
                           std::span<const VirtualPart> parts, Precision precision)
{
  const std::string what = fmt::format("write the virtual dataset {}", name);
  const Handle creation = properties(H5P_DATASET_CREATE);
  check(H5Pset_fill_value(creation.id(), H5T_NATIVE_DOUBLE, &fill), what);
  for (const VirtualPart& part : parts)
    check(H5Pset_virtual(creation.id(), selection(shape, part.target).id(), part.file.c_str(), part.dataset.c_str(),
                         selection(part.shape, part.source).id()),
          what);
  (void)write_dataset_of(group, name, stored_type<double>(precision), shape, nullptr, creation.id());
}

void write_numbers(const Handle& group, const std::string& name, std::span<const double> values)
{
  const hsize_t size = values.size();
  (void)write_dataset_of(group, name, H5T_NATIVE_DOUBLE, {&size, 1}, values.data());
}

Handle create_numbers(const Handle& group, const std::string& name, std::size_t size)
{
  const hsize_t numbers = size;
  return write_dataset_of(group, name, H5T_NATIVE_DOUBLE, {&numbers, 1}, nullptr);
}

void write_part(const Handle& numbers, std::size_t first, std::span<const double> values)
{
  const std::string what = "write a part of a dataset";
  const Handle space = checked(H5Dget_space(numbers.id()), what);
  const hsize_t start = first, count = values.size();
  check(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &start, nullptr, &count, nullptr), what);
  check(H5Dwrite(numbers.id(), H5T_NATIVE_DOUBLE, space_of({&count, 1}).id(), space.id(), H5P_DEFAULT, values.data()),
        what);
}

} // namespace brinell::io::h5
