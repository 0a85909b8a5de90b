// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/foundation/sym_tensor.hpp"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <cstddef>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <span>
#include <utility>
#include <vector>

/// Arrays of NumPy in and out. Fields are [y, x] and [z, y, x], tensor components come first, so that a contiguous array
/// is a field of the engine as it lies in memory. Towards Python a symmetric tensor has six components (order of
/// SymTensor), also where the engine keeps the five of a Deviator.
namespace brinell::python
{

namespace nb = nanobind;

/// Array from Python, used where it lies.
using Input = nb::ndarray<const double, nb::c_contig, nb::device::cpu>;
/// Array for Python.
using Output = nb::ndarray<nb::numpy, double>;
using Shape = std::vector<std::size_t>;

/// The values of an array.
/// @throws InputError if it has another shape
inline std::span<const double> values(const Input& array, const Shape& shape, const char* name)
{
  Shape given;
  for (std::size_t i = 0; i < array.ndim(); ++i)
    given.push_back(array.shape(i));
  if (given != shape)
    throw InputError(
        fmt::format("{} has the shape ({}); it must be ({})", name, fmt::join(given, ", "), fmt::join(shape, ", ")));
  return {array.data(), array.size()};
}

/// An array that owns the values: they are moved, not copied.
inline Output array(std::vector<double>&& values, const Shape& shape)
{
  auto* owner = new std::vector<double>(std::move(values));
  const nb::capsule capsule(owner, [](void* p) noexcept { delete static_cast<std::vector<double>*>(p); });
  return {owner->data(), shape.size(), shape.data(), capsule};
}

/// The result of a computation that needs nothing of Python: other threads of the interpreter go on meanwhile.
template <typename Computation>
auto without_lock(const Computation& computation)
{
  const nb::gil_scoped_release release;
  return computation();
}

/// The tensor of cell i in six fields of n values.
inline SymTensor tensor_at(std::span<const double> fields, std::size_t n, std::size_t i)
{
  SymTensor t;
  for (std::size_t c = 0; c < t.size(); ++c)
    t[c] = fields[c * n + i];
  return t;
}

inline void store(const SymTensor& t, std::vector<double>& fields, std::size_t n, std::size_t i)
{
  for (std::size_t c = 0; c < t.size(); ++c)
    fields[c * n + i] = t[c];
}

/// Six fields of a field of deviators, with a third of a trace if there is one.
inline std::vector<double> six_fields(std::span<const double> deviators, std::span<const double> trace = {})
{
  const std::size_t n = deviators.size() / Deviator::size;
  std::vector<double> fields(6 * n);
  for (std::size_t i = 0; i < n; ++i)
    store(to_tensor(deviator_at(deviators, n, i), trace.empty() ? 0.0 : trace[i]), fields, n, i);
  return fields;
}

} // namespace brinell::python
