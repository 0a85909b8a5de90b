// SPDX-License-Identifier: BSD-3-Clause
#include "hdf5.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>
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

Handle checked(hid_t id, Handle::Close close, std::string_view what)
{
  if (id < 0)
    fail(what);
  return {id, close};
}

void check(herr_t status, std::string_view what)
{
  if (status < 0)
    fail(what);
}

void write_attribute(const Handle& object, const char* name, hid_t type, const Handle& space, const void* data)
{
  const std::string what = fmt::format("write the attribute {}", name);
  const Handle attribute =
      checked(H5Acreate2(object.id(), name, type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose, what);
  check(H5Awrite(attribute.id(), type, data), what);
}

Handle scalar_space()
{
  return checked(H5Screate(H5S_SCALAR), H5Sclose, "make a data space");
}

Handle list_space(hsize_t size)
{
  return checked(H5Screate_simple(1, &size, nullptr), H5Sclose, "make a data space");
}

Handle chunks(std::span<const hsize_t> dims, Storage storage)
{
  Handle properties = checked(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make a property list");
  std::vector<hsize_t> chunk(dims.begin(), dims.end());
  for (hsize_t& side : chunk)
    side = std::min(side, longest_chunk_side.at(dims.size()));
  check(H5Pset_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data()), "set the chunks");
  if (storage == Storage::plain)
  {
    check(H5Pset_fletcher32(properties.id()), "set the checksum filter");
    return properties;
  }
  check(H5Pset_shuffle(properties.id()), "set the shuffle filter");
  check(H5Pset_deflate(properties.id(), deflate_level), "set the deflate filter");
  return properties;
}

/// A space of which a box is selected.
Handle selection(std::span<const hsize_t> shape, const Box& box)
{
  constexpr const char* what = "select a part of a dataset";
  Handle space = checked(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, what);
  check(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, box.start.data(), nullptr, box.count.data(), nullptr), what);
  return space;
}

template <typename Number>
void write_described(const Handle& group, const char* name, hid_t type, const std::vector<Number>& values,
                     std::span<const std::size_t> shape, std::string_view units, std::string_view long_name,
                     Storage storage)
{
  std::size_t size = 1;
  for (const std::size_t n : shape)
    size *= n;
  if (size != values.size() || size == 0)
    throw InternalError(fmt::format("field {} has {} values on a grid of {} cells", name, values.size(), size));
  const std::string what = fmt::format("write the dataset {}", name);
  const std::vector<hsize_t> dims(shape.begin(), shape.end());
  const Handle space = checked(H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr), H5Sclose, what);
  const Handle properties = chunks(dims, storage);
  const Handle dataset = checked(
      H5Dcreate2(group.id(), name, type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Dclose, what);
  check(H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), what);
  h5::write_attribute(dataset, "units", units);
  h5::write_attribute(dataset, "long_name", long_name);
}

/// Variable length, because a fixed one cannot hold an empty string; UTF-8 for titles.
Handle text_type()
{
  Handle type = checked(H5Tcopy(H5T_C_S1), H5Tclose, "make a string type");
  check(H5Tset_size(type.id(), H5T_VARIABLE), "size a string type");
  check(H5Tset_cset(type.id(), H5T_CSET_UTF8), "set UTF-8");
  return type;
}

} // namespace

Handle create_file(const std::filesystem::path& path)
{
  silence();
  return checked(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose,
                 fmt::format("create {}", path.string()));
}

Handle create_file_in_memory()
{
  silence();
  constexpr std::size_t growth = 1 << 20;
  const Handle access = checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make a property list");
  constexpr hbool_t on_disk_too = false;
  check(H5Pset_fapl_core(access.id(), growth, on_disk_too), "keep a file in memory");
  static std::atomic<unsigned> count = 0; // HDF5 takes files in memory of one name for the same file
  const std::string name = fmt::format("memory-{}", count++);
  return checked(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose, "create a file in memory");
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
  return checked(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, fmt::format("open {}", path.string()));
}

void close_file(Handle file)
{
  // A full disk shows at the flush; closing afterwards has nothing left to lose.
  check(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), "write the file to the disk");
}

Handle create_group(const Handle& parent, const std::string& name)
{
  return checked(H5Gcreate2(parent.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
                 fmt::format("create the group {}", name));
}

Handle create_ordered_group(const Handle& parent, const std::string& name)
{
  const std::string what = fmt::format("create the group {}", name);
  const Handle properties = checked(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, what);
  check(H5Pset_link_creation_order(properties.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED), what);
  return checked(H5Gcreate2(parent.id(), name.c_str(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Gclose, what);
}

Handle open_group(const Handle& parent, const std::string& name)
{
  return checked(H5Gopen2(parent.id(), name.c_str(), H5P_DEFAULT), H5Gclose, fmt::format("open the group {}", name));
}

void write_attribute(const Handle& object, const char* name, std::string_view text)
{
  const Handle type = text_type();
  const std::string copy(text);
  const char* data = copy.c_str();
  write_attribute(object, name, type.id(), scalar_space(), &data);
}

void write_attribute(const Handle& object, const char* name, double value)
{
  write_attribute(object, name, H5T_NATIVE_DOUBLE, scalar_space(), &value);
}

void write_attribute(const Handle& object, const char* name, int value)
{
  write_attribute(object, name, H5T_NATIVE_INT, scalar_space(), &value);
}

void write_attribute(const Handle& object, const char* name, std::span<const double> values)
{
  write_attribute(object, name, H5T_NATIVE_DOUBLE, list_space(values.size()), values.data());
}

void write_attribute(const Handle& object, const char* name, std::span<const int> values)
{
  write_attribute(object, name, H5T_NATIVE_INT, list_space(values.size()), values.data());
}

void write_fixed_attribute(const Handle& object, const char* name, std::string_view text)
{
  const Handle type = checked(H5Tcopy(H5T_C_S1), H5Tclose, "make a string type");
  check(H5Tset_size(type.id(), text.size()), "size a string type");
  check(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), "pad a string type");
  write_attribute(object, name, type.id(), scalar_space(), text.data());
}

void write_dataset(const Handle& group, const char* name, const std::vector<double>& values,
                   std::span<const std::size_t> shape, std::string_view units, std::string_view long_name,
                   Storage storage)
{
  write_described(group, name, H5T_NATIVE_DOUBLE, values, shape, units, long_name, storage);
}

void write_dataset(const Handle& group, const char* name, const std::vector<int>& values,
                   std::span<const std::size_t> shape, std::string_view units, std::string_view long_name)
{
  write_described(group, name, H5T_NATIVE_INT, values, shape, units, long_name, Storage::deflated);
}

void write_text(const Handle& group, const char* name, std::string_view text)
{
  const std::string what = fmt::format("write the text {}", name);
  const Handle type = text_type();
  const Handle dataset =
      checked(H5Dcreate2(group.id(), name, type.id(), scalar_space().id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
              H5Dclose, what);
  const std::string copy(text);
  const char* data = copy.c_str();
  check(H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, static_cast<const void*>(&data)), what);
}

void write_virtual_dataset(const Handle& group, const char* name, std::span<const hsize_t> shape, double fill,
                           std::span<const VirtualPart> parts)
{
  const std::string what = fmt::format("write the virtual dataset {}", name);
  const Handle properties = checked(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, what);
  check(H5Pset_fill_value(properties.id(), H5T_NATIVE_DOUBLE, &fill), what);
  for (const VirtualPart& part : parts)
    check(H5Pset_virtual(properties.id(), selection(shape, part.target).id(), part.file.c_str(), part.dataset.c_str(),
                         selection(part.shape, part.source).id()),
          what);
  const Handle space = checked(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, what);
  (void)checked(H5Dcreate2(group.id(), name, H5T_NATIVE_DOUBLE, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
                H5Dclose, what);
}

void write_numbers(const Handle& group, const std::string& name, const std::vector<double>& values)
{
  const std::string what = fmt::format("write the dataset {}", name);
  const hsize_t size = values.size();
  const Handle space = checked(H5Screate_simple(1, &size, nullptr), H5Sclose, what);
  const Handle dataset = checked(
      H5Dcreate2(group.id(), name.c_str(), H5T_NATIVE_DOUBLE, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose, what);
  check(H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), what);
}

std::vector<double> read_numbers(const Handle& group, const std::string& name)
{
  const std::string what = fmt::format("read the dataset {}", name);
  const Handle dataset = checked(H5Dopen2(group.id(), name.c_str(), H5P_DEFAULT), H5Dclose, what);
  const Handle space = checked(H5Dget_space(dataset.id()), H5Sclose, what);
  const Handle type = checked(H5Dget_type(dataset.id()), H5Tclose, what);
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
  H5G_info_t info{};
  check(H5Gget_info(group.id(), &info), "look into a group");
  std::vector<std::string> result;
  for (hsize_t i = 0; i < info.nlinks; ++i)
  {
    const ssize_t length =
        H5Lget_name_by_idx(group.id(), ".", H5_INDEX_NAME, H5_ITER_NATIVE, i, nullptr, 0, H5P_DEFAULT);
    std::string name(static_cast<std::size_t>(std::max<ssize_t>(length, 0)), ' ');
    H5Lget_name_by_idx(group.id(), ".", H5_INDEX_NAME, H5_ITER_NATIVE, i, name.data(), name.size() + 1, H5P_DEFAULT);
    result.push_back(std::move(name));
  }
  return result;
}

std::string read_text_attribute(const Handle& object, const char* name)
{
  const std::string what = fmt::format("read the attribute {}", name);
  const Handle attribute = checked(H5Aopen(object.id(), name, H5P_DEFAULT), H5Aclose, what);
  const Handle type = checked(H5Aget_type(attribute.id()), H5Tclose, what);
  const Handle space = checked(H5Aget_space(attribute.id()), H5Sclose, what);
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
  const Handle attribute = checked(H5Aopen(object.id(), name, H5P_DEFAULT), H5Aclose, what);
  const Handle type = checked(H5Aget_type(attribute.id()), H5Tclose, what);
  const Handle space = checked(H5Aget_space(attribute.id()), H5Sclose, what);
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

namespace
{

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
  const Handle space = checked(H5Dget_space(dataset.id()), H5Sclose, what);
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

void require_same_datasets(const Handle& group, const Handle& other)
{
  for (const std::string& name : names(group))
  {
    const std::string what = fmt::format("read back {}", name);
    const Handle here = checked(H5Oopen(group.id(), name.c_str(), H5P_DEFAULT), H5Oclose, what);
    const Handle there = checked(H5Oopen(other.id(), name.c_str(), H5P_DEFAULT), H5Oclose, what);
    if (H5Iget_type(here.id()) != H5Iget_type(there.id()))
      fail(what);
    if (H5Iget_type(here.id()) == H5I_GROUP)
      require_same_datasets(here, there);
    else if (H5Iget_type(here.id()) == H5I_DATASET)
      require_same_chunks(here, there, what);
  }
}

void copy_group(const Handle& from, const std::string& object, const Handle& to, const std::string& name)
{
  check(H5Ocopy(from.id(), object.c_str(), to.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
        fmt::format("copy the group {}", name));
}

} // namespace brinell::io::h5
