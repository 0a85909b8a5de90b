// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <stdexcept>

/// Two kinds of error: those that a user can fix (input, convergence, files) and bugs of brinell (internal).
namespace brinell
{

/// The user's input cannot be computed: a bad key, value, unit or combination. The text says where the error is, which value
/// was found and which values are allowed.
class InputError : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// The grid, specified by the user or chosen automatically, does not suit the case.
class GridError : public InputError
{
  using InputError::InputError;
};

/// An increment did not reach its tolerance even after it was split. The text states the residuals in physical units.
class ConvergenceError : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A file could not be read or written.
class IoError : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A GPU is missing, does not suit or has failed. The text names the cause and what to do about it.
class DeviceError : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// One part of brinell violated the contract of another: a bug, never an error of the user.
class InternalError : public std::logic_error
{
  using std::logic_error::logic_error;
};

/// Not an error: the observer of a computation has requested that it stop. Results finished before remain valid.
class Interrupted : public std::exception
{
public:
  [[nodiscard]] const char* what() const noexcept override { return "interrupted"; }
};

} // namespace brinell
