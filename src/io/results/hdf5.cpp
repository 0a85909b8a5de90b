// SPDX-License-Identifier: BSD-3-Clause
#include "hdf5.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <fmt/format.h>

namespace brinell::io::h5
{

namespace
{

/// Of chunks, by rank; 64^3 doubles are 2 MB, a good size for the deflate filter.
constexpr std::array<hsize_t, 4> longest_chunk_side{1, 4096, 512, 64};
constexpr unsigned deflate_level = 1; ///< fields are smooth or zero: higher levels gain little and cost much

/// The text of the innermost HDF5 error, where the cause is.
herr_t take_description(unsigned n, const H5E_error2_t* error, void* data)
{
  if (n == 0 && error->desc)
    *static_cast<std::string*>(data) = error->desc;
  return 0;
}

[[noreturn]] void fail(std::string_view what)
{
  std::string cause;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_description, &cause);
  H5Eclear2(H5E_DEFAULT);
  throw IoError(fmt::format("HDF5: cannot {}{}{}", what, cause.empty() ? "" : ": ", cause));
}

/// HDF5 prints errors by itself unless told not to.
void silence()
{
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Handle checked(hid_t id, std::string_view what)
{
  if (id < 0)
    fail(what);
  return Handle(id);
}

void check(herr_t status, std::string_view what)
{
  if (status < 0)
    fail(what);
}

template <typename Number>
hid_t type_of()
{
  return std::is_same_v<Number, int> ? H5T_NATIVE_INT : H5T_NATIVE_DOUBLE;
}

/// Variable length, because a fixed one cannot hold an empty string; UTF-8 for titles.
Handle text_type()
{
  Handle type = checked(H5Tcopy(H5T_C_S1), "make a string type");
  check(H5Tset_size(type.id(), H5T_VARIABLE), "size a string type");
  check(H5Tset_cset(type.id(), H5T_CSET_UTF8), "set UTF-8");
  return type;
}

Handle properties(hid_t kind)
{
  return checked(H5Pcreate(kind), "make a property list");
}

/// An array; a single value if it has no side.
Handle space_of(std::span<const hsize_t> shape)
{
  return checked(shape.empty() ? H5Screate(H5S_SCALAR)
                               : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                 "make a data space");
}

/// The same, of which a box is selected.
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

/// @param data  none for one that stores nothing
Handle write_dataset_of(const Handle& group, const std::string& name, hid_t type, std::span<const hsize_t> shape,
                        const void* data, hid_t creation = H5P_DEFAULT)
{
  const std::string what = fmt::format("write the dataset {}", name);
  Handle dataset = checked(
      H5Dcreate2(group.id(), name.c_str(), type, space_of(shape).id(), H5P_DEFAULT, creation, H5P_DEFAULT), what);
  if (data)
    check(H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), what);
  return dataset;
}

Handle chunks(std::span<const hsize_t> shape, Storage storage)
{
  Handle creation = properties(H5P_DATASET_CREATE);
  if (storage == Storage::contiguous)
    return creation;
  std::vector<hsize_t> chunk(shape.begin(), shape.end());
  // Of one size, as chunks are stored whole: 69 cells in chunks of 64 would take the place of 128.
  for (hsize_t& side : chunk)
  {
    const hsize_t longest = longest_chunk_side.at(shape.size());
    const hsize_t count = std::max<hsize_t>(1, (side + longest - 1) / longest);
    side = (side + count - 1) / count;
  }
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

/// The bytes of a chunk as they are stored. @param mask  tells which filters were left out
std::vector<char> stored_chunk(const Handle& dataset, const std::vector<hsize_t>& offset, std::uint32_t& mask,
                               const std::string& what)
{
  hsize_t size = 0;
  check(H5Dget_chunk_storage_size(dataset.id(), offset.data(), &size), what);
  std::vector<char> bytes(size);
  check(H5Dread_chunk(dataset.id(), H5P_DEFAULT, offset.data(), &mask, bytes.data()), what);
  return bytes;
}

void require_same_chunks(const Handle& dataset, const Handle& other, const std::string& what)
{
  const Handle space = checked(H5Dget_space(dataset.id()), what);
  hsize_t count = 0, count_there = 0;
  check(H5Dget_num_chunks(dataset.id(), space.id(), &count), what);
  check(H5Dget_num_chunks(other.id(), space.id(), &count_there), what);
  std::vector<hsize_t> offset(static_cast<std::size_t>(std::max(1, H5Sget_simple_extent_ndims(space.id()))));
  bool same = count == count_there;
  for (hsize_t i = 0; i < count && same; ++i)
  {
    unsigned ignored = 0;
    haddr_t address = 0;
    hsize_t size = 0;
    check(H5Dget_chunk_info(dataset.id(), space.id(), i, offset.data(), &ignored, &address, &size), what);
    std::uint32_t mask = 0, mask_there = 0;
    same = stored_chunk(dataset, offset, mask, what) == stored_chunk(other, offset, mask_there, what) &&
           mask == mask_there;
  }
  if (!same)
    fail(fmt::format("{}: it differs from what was written", what));
}

} // namespace

Handle create_file(const std::filesystem::path& path)
{
  silence();
  return checked(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
                 fmt::format("create {}", path.string()));
}

Handle create_file_in_memory()
{
  silence();
  constexpr std::size_t growth = 1 << 20;
  constexpr hbool_t on_disk_too = false;
  const Handle access = properties(H5P_FILE_ACCESS);
  check(H5Pset_fapl_core(access.id(), growth, on_disk_too), "keep a file in memory");
  static std::atomic<unsigned> count = 0; // HDF5 takes files in memory of one name for the same file
  const std::string name = fmt::format("memory-{}", count++);
  return checked(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), "create a file in memory");
}

std::string file_image(Handle file)
{
  check(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), "complete a file in memory");
  const ssize_t size = H5Fget_file_image(file.id(), nullptr, 0);
  std::string image(static_cast<std::size_t>(std::max<ssize_t>(size, 0)), '\0');
  if (H5Fget_file_image(file.id(), image.data(), image.size()) != size || size <= 0)
    fail("read a file in memory");
  return image;
}

Handle open_file(const std::filesystem::path& path)
{
  silence();
  return checked(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), fmt::format("open {}", path.string()));
}

void close_file(Handle file)
{
  // A full disk shows at the flush; closing afterwards has nothing left to lose.
  check(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), "write the file to the disk");
}

Handle create_group(const Handle& parent, const std::string& name)
{
  return checked(H5Gcreate2(parent.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                 fmt::format("create the group {}", name));
}

Handle create_ordered_group(const Handle& parent, const std::string& name)
{
  const std::string what = fmt::format("create the group {}", name);
  const Handle creation = properties(H5P_GROUP_CREATE);
  check(H5Pset_link_creation_order(creation.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED), what);
  return checked(H5Gcreate2(parent.id(), name.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT), what);
}

Handle open_group(const Handle& parent, const std::string& name)
{
  return checked(H5Gopen2(parent.id(), name.c_str(), H5P_DEFAULT), fmt::format("open the group {}", name));
}

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

template <typename Number>
void write_dataset(const Handle& group, const char* name, const std::vector<Number>& values,
                   std::span<const std::size_t> shape, std::string_view units, std::string_view long_name,
                   Storage storage)
{
  std::size_t size = 1;
  for (const std::size_t n : shape)
    size *= n;
  if (size != values.size() || size == 0)
    throw InternalError(fmt::format("field {} has {} values on a grid of {} cells", name, values.size(), size));
  const std::vector<hsize_t> dims(shape.begin(), shape.end());
  const Handle dataset =
      write_dataset_of(group, name, type_of<Number>(), dims, values.data(), chunks(dims, storage).id());
  write_attribute(dataset, "units", units);
  write_attribute(dataset, "long_name", long_name);
}

template void write_dataset(const Handle&, const char*, const std::vector<double>&, std::span<const std::size_t>,
                            std::string_view, std::string_view, Storage);
template void write_dataset(const Handle&, const char*, const std::vector<int>&, std::span<const std::size_t>,
                            std::string_view, std::string_view, Storage);

void write_text(const Handle& group, const char* name, std::string_view text)
{
  const std::string copy(text);
  const char* data = copy.c_str();
  (void)write_dataset_of(group, name, text_type().id(), {}, static_cast<const void*>(&data));
}

void write_virtual_dataset(const Handle& group, const char* name, std::span<const hsize_t> shape, double fill,
                           std::span<const VirtualPart> parts)
{
  const std::string what = fmt::format("write the virtual dataset {}", name);
  const Handle creation = properties(H5P_DATASET_CREATE);
  check(H5Pset_fill_value(creation.id(), H5T_NATIVE_DOUBLE, &fill), what);
  for (const VirtualPart& part : parts)
    check(H5Pset_virtual(creation.id(), selection(shape, part.target).id(), part.file.c_str(), part.dataset.c_str(),
                         selection(part.shape, part.source).id()),
          what);
  (void)write_dataset_of(group, name, H5T_NATIVE_DOUBLE, shape, nullptr, creation.id());
}

void write_numbers(const Handle& group, const std::string& name, const std::vector<double>& values)
{
  const hsize_t size = values.size();
  (void)write_dataset_of(group, name, H5T_NATIVE_DOUBLE, {&size, 1}, values.data());
}

std::vector<double> read_numbers(const Handle& group, const std::string& name)
{
  const std::string what = fmt::format("read the dataset {}", name);
  const Handle dataset = checked(H5Dopen2(group.id(), name.c_str(), H5P_DEFAULT), what);
  const Handle space = checked(H5Dget_space(dataset.id()), what);
  const Handle type = checked(H5Dget_type(dataset.id()), what);
  const hssize_t size = H5Sget_simple_extent_npoints(space.id());
  // A size that is not stored is a claim only, for which no memory should be taken.
  const hsize_t stored = H5Dget_storage_size(dataset.id()) / sizeof(double);
  if (H5Tget_class(type.id()) != H5T_FLOAT || size < 0 || static_cast<hsize_t>(size) != stored)
    fail(fmt::format("{}: it is no plain list of numbers", what));
  std::vector<double> values(static_cast<std::size_t>(size));
  check(H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), what);
  return values;
}

std::vector<std::string> names(const Handle& group)
{
  std::vector<std::string> result;
  const auto take = [](hid_t, const char* name, const H5L_info_t*, void* data) -> herr_t
  {
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
    return 0;
  };
  check(H5Literate(group.id(), H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, take, &result), "look into a group");
  return result;
}

std::string read_text_attribute(const Handle& object, const char* name)
{
  const std::string what = fmt::format("read the attribute {}", name);
  const Handle attribute = checked(H5Aopen(object.id(), name, H5P_DEFAULT), what);
  const Handle type = checked(H5Aget_type(attribute.id()), what);
  const Handle space = checked(H5Aget_space(attribute.id()), what);
  if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) <= 0 ||
      H5Sget_simple_extent_npoints(space.id()) != 1)
    fail(fmt::format("{}: it is not one text of variable length", what));
  char* data = nullptr;
  check(H5Aread(attribute.id(), type.id(), static_cast<void*>(&data)), what);
  std::string text = data ? data : "";
  H5free_memory(data);
  return text;
}

int read_int_attribute(const Handle& object, const char* name)
{
  const std::string what = fmt::format("read the attribute {}", name);
  const Handle attribute = checked(H5Aopen(object.id(), name, H5P_DEFAULT), what);
  const Handle type = checked(H5Aget_type(attribute.id()), what);
  const Handle space = checked(H5Aget_space(attribute.id()), what);
  if (H5Tget_class(type.id()) != H5T_INTEGER || H5Sget_simple_extent_npoints(space.id()) != 1)
    fail(fmt::format("{}: it is not one whole number", what));
  int value = 0;
  check(H5Aread(attribute.id(), H5T_NATIVE_INT, &value), what);
  return value;
}

void link_soft(const Handle& group, const std::string& name, const std::string& object)
{
  check(H5Lcreate_soft(object.c_str(), group.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
        fmt::format("link {}", object));
}

void link_external(const Handle& group, const std::string& name, const std::string& file, const std::string& object)
{
  check(H5Lcreate_external(file.c_str(), object.c_str(), group.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
        fmt::format("link {}", file));
}

void copy_group(const Handle& from, const std::string& object, const Handle& to, const std::string& name)
{
  check(H5Ocopy(from.id(), object.c_str(), to.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
        fmt::format("copy the group {}", name));
}

void require_same_datasets(const Handle& group, const Handle& other)
{
  for (const std::string& name : names(group))
  {
    const std::string what = fmt::format("read back {}", name);
    const Handle here = checked(H5Oopen(group.id(), name.c_str(), H5P_DEFAULT), what);
    const Handle there = checked(H5Oopen(other.id(), name.c_str(), H5P_DEFAULT), what);
    if (H5Iget_type(here.id()) != H5Iget_type(there.id()))
      fail(what);
    if (H5Iget_type(here.id()) == H5I_GROUP)
      require_same_datasets(here, there);
    else if (H5Iget_type(here.id()) == H5I_DATASET)
      require_same_chunks(here, there, what);
  }
}

} // namespace brinell::io::h5
