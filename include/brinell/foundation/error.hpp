// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <stdexcept>

/// Two kinds of error: those a user can mend (input, convergence, files) and those that are ours (internal).
namespace brinell
{

/// What the user gave cannot be computed: a bad key, value, unit or combination. The text says where, what was found,
/// what is allowed.
class InputError : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// The grid, given or automatic, does not suit the case.
class GridError : public InputError
{
  using InputError::InputError;
};

/// An increment did not reach its tolerance, also after splitting. The text carries the residuals in physical units.
class ConvergenceError : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A file could not be read or written.
class IoError : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A broken promise between two parts of brinell: a bug, never the user's doing.
class InternalError : public std::logic_error
{
  using std::logic_error::logic_error;
};

/// Not an error: whoever watches a computation has asked it to stop. What was finished before stays valid.
class Interrupted : public std::exception
{
public:
  [[nodiscard]] const char* what() const noexcept override { return "interrupted"; }
};

} // namespace brinell
