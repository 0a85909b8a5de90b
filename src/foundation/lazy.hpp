// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>

namespace brinell
{

/// A value that is made when it is first needed, once, whichever thread asks for it.
template <typename T>
class Lazy
{
public:
  /// @param make  function that returns the value
  template <typename Make>
  const T& get(const Make& make) const
  {
    std::call_once(made_, [&] { value_ = std::make_unique<T>(make()); });
    return *value_;
  }

private:
  mutable std::once_flag made_;
  mutable std::unique_ptr<T> value_;
};

} // namespace brinell
