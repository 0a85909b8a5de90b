// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hdf5.hpp"

/// Errors of HDF5 as exceptions, for the functions of hdf5.hpp. @param what  was to be done: "read the dataset X"
namespace brinell::io::h5
{

/// @throws IoError always, with what HDF5 tells
[[noreturn]] void fail(std::string_view what);
[[nodiscard]] Handle checked(hid_t id, std::string_view what);
void check(herr_t status, std::string_view what);
[[nodiscard]] Handle properties(hid_t kind);

} // namespace brinell::io::h5
