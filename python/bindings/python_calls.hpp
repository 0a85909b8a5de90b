// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>

#include <optional>
#include <utility>

namespace brinell::python
{

/// Python called from a computation that runs without the interpreter's lock. What it raises, Ctrl-C included, is kept until
/// the computation has come to its end.
class PythonCalls
{
public:
  template <typename Function>
  void call(const Function& function)
  {
    const nanobind::gil_scoped_acquire lock;
    try
    {
      function();
    }
    catch (nanobind::python_error& error)
    {
      raised_.emplace(std::move(error));
    }
  }

  /// Whether anything has been raised, by a call or by a signal.
  bool wants_stop()
  {
    if (!raised_)
      call(
          []
          {
            if (PyErr_CheckSignals() != 0)
              nanobind::raise_python_error();
          });
    return raised_.has_value();
  }

  /// To be called once the computation has ended, or has been interrupted.
  void rethrow()
  {
    if (raised_)
      throw std::move(raised_).value();
  }

private:
  std::optional<nanobind::python_error> raised_;
};

} // namespace brinell::python
