// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>

#include <chrono>
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

  /// Whether anything has been raised, by a call or by a signal. Asks for signals a few times per second: the lock may be
  /// long in coming.
  bool wants_stop()
  {
    constexpr std::chrono::milliseconds pause{100};
    const auto now = std::chrono::steady_clock::now();
    if (!raised_ && now - asked_ >= pause)
    {
      asked_ = now;
      call(
          []
          {
            if (PyErr_CheckSignals() != 0)
              nanobind::raise_python_error();
          });
    }
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
  std::chrono::steady_clock::time_point asked_;
};

} // namespace brinell::python
