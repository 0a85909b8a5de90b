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

/// Stores the text of the innermost HDF5 error, which describes the cause.
herr_t take_description(unsigned n, const H5E_error2_t* error, void* data)
{
  if (n == 0 && error->desc)
    *static_cast<std::string*>(data) = error->desc;
  return 0;
}

/// Stops HDF5 from printing errors itself.
void silence()
{
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

/// The bytes of a chunk as they are stored. @param mask  output: the filters that were skipped
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

void fail(std::string_view what)
{
  std::string cause;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_description, &cause);
  H5Eclear2(H5E_DEFAULT);
  throw IoError(fmt::format("HDF5: cannot {}{}{}", what, cause.empty() ? "" : ": ", cause));
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

Handle properties(hid_t kind)
{
  return checked(H5Pcreate(kind), "make a property list");
}

Handle create_file(const std::filesystem::path& path)
{
  silence();
  return checked(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
                 fmt::format("create {}", path.string()));
}

Handle create_file_in_memory(std::size_t growth)
{
  silence();
  constexpr hbool_t on_disk_too = false;
  const Handle access = properties(H5P_FILE_ACCESS);
  check(H5Pset_fapl_core(access.id(), growth, on_disk_too), "keep a file in memory");
  static std::atomic<unsigned> count = 0; // HDF5 treats files in memory with equal names as the same file
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
  // A full disk causes an error at the flush; after it, closing cannot lose data.
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

std::size_t count_of_numbers(const Handle& group, const std::string& name)
{
  const std::string what = fmt::format("read the dataset {}", name);
  const Handle dataset = checked(H5Dopen2(group.id(), name.c_str(), H5P_DEFAULT), what);
  const Handle space = checked(H5Dget_space(dataset.id()), what);
  const Handle type = checked(H5Dget_type(dataset.id()), what);
  const hssize_t size = H5Sget_simple_extent_npoints(space.id());
  // Compared with the stored size, so that a damaged header cannot cause a huge allocation.
  const hsize_t stored = H5Dget_storage_size(dataset.id()) / sizeof(double);
  if (H5Tget_class(type.id()) != H5T_FLOAT || size < 0 || static_cast<hsize_t>(size) != stored ||
      H5Sget_simple_extent_ndims(space.id()) != 1)
    fail(fmt::format("{}: it is not a plain list of numbers", what));
  return static_cast<std::size_t>(size);
}

std::vector<double> read_numbers(const Handle& group, const std::string& name)
{
  std::vector<double> values(count_of_numbers(group, name));
  if (!values.empty())
    read_part(group, name, 0, values);
  return values;
}

void read_part(const Handle& group, const std::string& name, std::size_t first, std::span<double> values)
{
  const std::string what = fmt::format("read the dataset {}", name);
  const Handle dataset = checked(H5Dopen2(group.id(), name.c_str(), H5P_DEFAULT), what);
  const Handle there = checked(H5Dget_space(dataset.id()), what);
  const hsize_t start = first, count = values.size();
  check(H5Sselect_hyperslab(there.id(), H5S_SELECT_SET, &start, nullptr, &count, nullptr), what);
  const Handle here = checked(H5Screate_simple(1, &count, nullptr), what);
  check(H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, here.id(), there.id(), H5P_DEFAULT, values.data()), what);
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

bool has_member(const Handle& group, const char* name)
{
  return H5Lexists(group.id(), name, H5P_DEFAULT) > 0;
}

void copy_object(const Handle& from, const std::string& object, const Handle& to, const std::string& name)
{
  check(H5Ocopy(from.id(), object.c_str(), to.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
        fmt::format("copy {}", name));
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
