// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/layered_fields.hpp"
#include "brinell/io/output_choice.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <hdf5.h>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// A small wrapper for the part of HDF5 that the results need: handles that close themselves, errors as exceptions.
namespace brinell::io::h5
{

/// An HDF5 identifier of any kind.
class Handle
{
public:
  explicit Handle(hid_t id) : id_(id) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
  Handle& operator=(Handle&& other) noexcept
  {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Handle()
  {
    if (id_ >= 0)
      H5Idec_ref(id_); // closes the object
  }
  [[nodiscard]] hid_t id() const { return id_; }

private:
  hid_t id_;
};

/// Turns an error of HDF5 into an exception.
/// @param what  the failed action: "read the dataset X"
/// @throws IoError always, with the message of HDF5
[[noreturn]] void fail(std::string_view what);
[[nodiscard]] Handle checked(hid_t id, std::string_view what);
void check(herr_t status, std::string_view what);
[[nodiscard]] Handle properties(hid_t kind);

/// A new file, which replaces an existing one.
/// @throws IoError (all of this header)
[[nodiscard]] Handle create_file(const std::filesystem::path& path);
/// A file in memory, to be written in one piece: HDF5 crashes when a full disk does not let it close a file.
/// @param growth  increment by which its memory grows [bytes]
[[nodiscard]] Handle create_file_in_memory(std::size_t growth = 1 << 20);
/// The bytes of a file in memory.
[[nodiscard]] std::string file_image(Handle file);
[[nodiscard]] Handle open_file(const std::filesystem::path& path);
/// Closes the file; unlike the destructor it reports data that could not be written.
void close_file(Handle file);

[[nodiscard]] Handle create_group(const Handle& parent, const std::string& name);
/// A group that keeps the order in which its members were created.
[[nodiscard]] Handle create_ordered_group(const Handle& parent, const std::string& name);
[[nodiscard]] Handle open_group(const Handle& parent, const std::string& name);

void write_attribute(const Handle& object, const char* name, std::string_view text);
void write_attribute(const Handle& object, const char* name, double value);
void write_attribute(const Handle& object, const char* name, int value);
void write_attribute(const Handle& object, const char* name, std::span<const double> values);
void write_attribute(const Handle& object, const char* name, std::span<const int> values);
/// Writes text of fixed length in ASCII, for readers that support no other kind. The text must not be empty.
void write_fixed_attribute(const Handle& object, const char* name, std::string_view text);

/// Storage layout of a dataset. Both chunked layouts have checksums, so that a reader detects damage.
enum class Storage
{
  deflated, ///< compressed chunks, for fields that are mostly zero, or smooth
  plain, ///< chunks, for stresses: deflating them takes most of the time of writing, and saves a quarter of their size
  contiguous ///< no chunks: for files that stay in memory
};

/// Writes numbers with their unit and meaning.
/// @param Number  double or int
/// @param shape   slowest index first
/// @param precision  in which doubles are stored
template <typename Number>
void write_dataset(const Handle& group, const char* name, const std::vector<Number>& values,
                   std::span<const std::size_t> shape, std::string_view units, std::string_view long_name,
                   Storage storage = Storage::deflated, Precision precision = Precision::double_precision);
/// The parts of a field on the cells of a body, [z][y][x], as which it is written: each consists of whole chunks, for a file in
/// memory as well.
[[nodiscard]] std::vector<Slab> slabs(const std::array<std::size_t, 3>& shape);
/// Writes fields on the cells of a body in parts, so that they need not be in memory as a whole; first all parts of the first field,
/// in the order of `slabs`. Deflated ones are compressed by all threads; the bytes are those that HDF5 would write with a single thread.
/// @param names, long_names  of the fields
void write_fields(const Handle& group, const LayeredFields& fields, std::span<const char* const> names,
                  std::span<const std::string> long_names, std::string_view units, Storage storage,
                  Precision precision = Precision::double_precision);
/// Writes a dataset with a single UTF-8 text.
void write_text(const Handle& group, const char* name, std::string_view text);

/// A box of cells of an array, slowest index first.
struct Box
{
  std::vector<hsize_t> start, count;
};

/// A box of a virtual dataset, and the box of equal size in the dataset to which it refers.
struct VirtualPart
{
  Box target;
  std::string file; ///< relative to the folder of the file; "." is the file itself
  std::string dataset;
  std::vector<hsize_t> shape; ///< of the dataset referred to
  Box source;
};

/// A virtual dataset of floating-point numbers, which stores no data but refers to parts of other datasets.
/// @param fill  value where no other dataset is referred to
/// @param precision  of the datasets referred to
void write_virtual_dataset(const Handle& group, const char* name, std::span<const hsize_t> shape, double fill,
                           std::span<const VirtualPart> parts, Precision precision = Precision::double_precision);

/// Reading and writing of plain numbers. Files are not trusted: types and sizes are checked on reading.
void write_numbers(const Handle& group, const std::string& name, std::span<const double> values);
[[nodiscard]] std::vector<double> read_numbers(const Handle& group, const std::string& name);
/// A list of `size` numbers, which `write_part` fills.
[[nodiscard]] Handle create_numbers(const Handle& group, const std::string& name, std::size_t size);
void write_part(const Handle& numbers, std::size_t first, std::span<const double> values);
/// How many numbers a list has.
[[nodiscard]] std::size_t count_of_numbers(const Handle& group, const std::string& name);
/// Reads numbers from a first one on.
void read_part(const Handle& group, const std::string& name, std::size_t first, std::span<double> values);
/// Names of the objects in a group.
[[nodiscard]] std::vector<std::string> names(const Handle& group);
[[nodiscard]] std::string read_text_attribute(const Handle& object, const char* name);

/// A link `name` in `group` to an object of the same file.
void link_soft(const Handle& group, const std::string& name, const std::string& object);
/// A link `name` in `group` to an object of another file, whose path is relative to the folder of this one.
void link_external(const Handle& group, const std::string& name, const std::string& file, const std::string& object);

/// Whether a group has a member with this name.
[[nodiscard]] bool has_member(const Handle& group, const char* name);
/// Copies a group, or a dataset, from another file or place without decompressing it.
void copy_object(const Handle& from, const std::string& object, const Handle& to, const std::string& name);

/// Checks that the other group contains all datasets of a group, with the same stored bytes.
/// @throws IoError
void require_same_datasets(const Handle& group, const Handle& other);

} // namespace brinell::io::h5
