// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>

namespace brinell
{

/// Owner of one object of a type that may be incomplete (pimpl), so that a class with such a member needs to declare neither a
/// destructor nor move operations. A Hidden can be moved but not copied, and a const Hidden gives access to a const object.
template <typename T>
class Hidden
{
public:
  Hidden() = default; ///< empty
  /// To be called only where T is complete.
  explicit Hidden(std::unique_ptr<T> object) : object_(object.release(), [](T* o) { delete o; }) {}

  [[nodiscard]] bool empty() const { return !object_; }
  T& operator*() { return *object_; }
  const T& operator*() const { return *object_; }
  T* operator->() { return object_.get(); }
  const T* operator->() const { return object_.get(); }

private:
  // The deleter is stored as a function pointer, so that T may be incomplete where the owner is destroyed.
  std::unique_ptr<T, void (*)(T*)> object_{nullptr, [](T* /*none*/) {}};
};

/// Makes a hidden object from these arguments; to be called only where T is complete.
template <typename T, typename... Arguments>
[[nodiscard]] Hidden<T> make_hidden(Arguments&&... arguments)
{
  return Hidden<T>(std::unique_ptr<T>(new T{std::forward<Arguments>(arguments)...}));
}

} // namespace brinell
