// SPDX-License-Identifier: BSD-3-Clause
#include "hdf5.hpp"

#include "brinell/foundation/error.hpp"
#include "replace_file.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace brinell::io::h5
{

namespace
{

constexpr hsize_t longest_chunk_side = 64; ///< 64^3 doubles are 2 MB, a good size for the deflate filter
constexpr unsigned deflate_level = 1;      ///< fields are smooth or zero: higher levels gain little and cost much

/// The text of the innermost HDF5 error, where the cause is.
herr_t take_description(unsigned /*n*/, const H5E_error2_t* error, void* data)
{
  if (error->desc)
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

Handle compression(std::span<const hsize_t> dims)
{
  Handle properties = checked(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make a property list");
  std::vector<hsize_t> chunk(dims.begin(), dims.end());
  for (hsize_t& side : chunk)
    side = std::min(side, dims.size() == 2 ? 8 * longest_chunk_side : longest_chunk_side);
  check(H5Pset_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data()), "set the chunks");
  check(H5Pset_shuffle(properties.id()), "set the shuffle filter");
  check(H5Pset_deflate(properties.id(), deflate_level), "set the deflate filter");
  return properties;
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
  return checked(H5Fcreate("memory", H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose, "create a file in memory");
}

void save_file(Handle file, const std::filesystem::path& path)
{
  check(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), "complete a file in memory");
  const ssize_t size = H5Fget_file_image(file.id(), nullptr, 0);
  std::vector<char> image(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  if (H5Fget_file_image(file.id(), image.data(), image.size()) != size || size <= 0)
    fail("read a file in memory");
  replace_file(path, {image.data(), image.size()});
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

Handle open_group(const Handle& parent, const std::string& name)
{
  return checked(H5Gopen2(parent.id(), name.c_str(), H5P_DEFAULT), H5Gclose, fmt::format("open the group {}", name));
}

void write_attribute(const Handle& object, const char* name, std::string_view text)
{
  const Handle type = checked(H5Tcopy(H5T_C_S1), H5Tclose, "make a string type");
  // Variable length, because a fixed one cannot hold an empty string; UTF-8 for titles.
  check(H5Tset_size(type.id(), H5T_VARIABLE), "size a string type");
  check(H5Tset_cset(type.id(), H5T_CSET_UTF8), "set UTF-8");
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
  const hsize_t size = values.size();
  const Handle space = checked(H5Screate_simple(1, &size, nullptr), H5Sclose, "make a data space");
  write_attribute(object, name, H5T_NATIVE_DOUBLE, space, values.data());
}

void write_dataset(const Handle& group, const char* name, const std::vector<double>& values,
                   std::span<const std::size_t> shape, std::string_view units, std::string_view long_name)
{
  std::size_t size = 1;
  for (const std::size_t n : shape)
    size *= n;
  if (size != values.size() || size == 0)
    throw InternalError(fmt::format("field {} has {} values on a grid of {} cells", name, values.size(), size));
  const std::string what = fmt::format("write the dataset {}", name);
  const std::vector<hsize_t> dims(shape.begin(), shape.end());
  const Handle space = checked(H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr), H5Sclose, what);
  const Handle properties = compression(dims);
  const Handle dataset =
      checked(H5Dcreate2(group.id(), name, H5T_NATIVE_DOUBLE, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
              H5Dclose, what);
  check(H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), what);
  write_attribute(dataset, "units", units);
  write_attribute(dataset, "long_name", long_name);
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
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())));
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
  int value = 0;
  check(H5Aread(attribute.id(), H5T_NATIVE_INT, &value), what);
  return value;
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

} // namespace brinell::io::h5
